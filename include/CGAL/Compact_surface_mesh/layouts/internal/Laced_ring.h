// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_LACED_RING_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_LACED_RING_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/internal/Emptied_on_move.h>
#include <CGAL/Compact_surface_mesh/layouts/Laced_ring_counts.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Bordered_corners.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Copied_vertices.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Ring_expander.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Ring_triangles.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Rings.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

/*
The laced ring, as a table of corners for Bordered_corners: T. Gurung, M. Luffel, P. Lindstrom, J. Rossignac,
LR: Compact connectivity representation for triangle meshes, 2011. Vertices are numbered along the ring, a nearly
Hamiltonian cycle (of each component); ring edge e leads from vertex e to the next one. It has a slot on each
side: 2e on its left, 2e + 1 on its right.

With the left side's ring running forward and the right side's backward, a slot's triangle is
(from, to, tip), counterclockwise, and its corners 3 * slot + k, k = 0, 1, 2:

    side   from     to       the tip of the slot is that of
    left   e        e.next   T1: one ring edge, its own one
    right  e.next   e        T2: two ring edges; in the slot of the second one, e. That of the first one is
                             redundant, with the tip e.next.next, and no corner is named by it; or it holds
                             T0w: the neighbor of that T2 beyond its third side, if this has no ring edge;
                             from and to are then those of that side, which skips e.next: the T2 is a wart

All other triangles without ring edge, T0, follow with vertices and opposite corners of their own. What is beside
a T0 is irregular and has its opposite corners stored; else two ring edges are looked at. The tables of the slots
are those of `Entries`.

This takes simple triangulations, in which ring edges and tips name triangles.
*/
template <class Index_, class Entries>
class Laced_ring
{
public:
  typedef Index_ Index;

  Laced_ring() = default;

  Laced_ring(const Closed_triangulation<Index>& t, Corner_images<Index>& images) : m_first_apex(t.first_apex())
  {
    const auto triangles = best_ring(t.table(), t.first_apex());
    if (3 * triangles->num_slots() > null())
      throw Mesh_defect_exception(Mesh_defect::too_many_elements, t.table().num_vertices());
    m_rings = triangles->rings();
    m_entries = Entries(*triangles);
    store_t0(*triangles);
    store_halfedges(t, *triangles);
    images.corners.resize(t.table().num_halfedges());
    for (std::size_t h = 0; h < images.corners.size(); ++h)
      images.corners[h] = triangles->corner(static_cast<Index>(h));
    images.vertices = triangles->release_numbers();
    std::vector<std::pair<Index, Index>> copies;
    for (std::size_t i = 0; i < t.copies().size(); ++i)
      copies.emplace_back(images.vertices[t.first_copy() + i], images.vertices[t.copies()[i]]);
    m_vertices = Copied_vertices<Index>(m_first_apex, std::move(copies));
    images.vertices.resize(t.first_copy());
    for (Index& v : images.vertices)
      v = m_vertices.vertex(v);
  }

  std::size_t num_vertices() const { return m_vertices.count(); }
  std::size_t num_triangles() const { return num_ring_slots() + m_t0.size() / 6; }

  Index source(Index c) const { return m_vertices.vertex(corner_vertex(c)); }
  Index target(Index c) const { return source(Corner_table<Index>::next(c)); }

  BOOST_FORCEINLINE Index opposite(Index c) const
  {
    const std::size_t slot = c / 3;
    const unsigned k = c % 3;
    if (slot >= num_ring_slots())
      return t0(slot)[3 + k];
    const Index e = static_cast<Index>(slot / 2);
    const unsigned side = slot % 2;
    if (k == 0)
      return skips_wart(e, side) ? corner(next(e), side, 1 + side) : ring_halfedge(e, 1 - side);
    const Index tip = this->tip(e, side);
    if (tip == prev(e)) { // a T2: one of the sides is a ring edge, one that of a skipped wart, maybe
      if (k == 2 - side)
        return ring_halfedge(tip, 1 - side);
      if (skips_wart(tip, side))
        return corner(tip, side, 0);
    }
    if (m_entries.is_irregular(slot))
      return m_entries.opposite(slot, k);
    return k == 1 ? across<1>(side, to(e, side), tip) : across<2>(side, from(e, side), tip);
  }

  Index halfedge_of_vertex(Index v) const
  {
    const Index r = m_vertices.in_structure(v);
    if (r >= m_rings.size()) {
      const std::size_t i = r - m_rings.size();
      return i < m_isolated.size() ? m_isolated[i] : null();
    }
    return has_borders() ? halfedge_of_bordered(r) : ring_halfedge(prev(r), 0);
  }

  std::vector<std::pair<std::string, std::size_t>> memory() const
  {
    return { { "L and R", m_entries.entry_bytes() + m_rings.bytes() },
             { "irregular and long", m_entries.long_bytes() },
             { "T0", m_t0.capacity() * sizeof(Index) },
             { "isolated vertices", m_isolated.capacity() * sizeof(Index) },
             { "borders off the ring", m_border_halfedges.capacity() * sizeof(m_border_halfedges[0]) },
             { "copies", m_vertices.bytes() } };
  }

  // Whether triangle t is a face: no redundant slot, and not at an apex.
  BOOST_FORCEINLINE bool is_face(Index t) const
  {
    if (t >= num_ring_slots())
      return t0(t)[2] < m_first_apex;
    const Index tip = m_entries.tip(t);
    return tip < m_first_apex && tip != m_rings.second_next(static_cast<Index>(t / 2));
  }

  std::size_t num_ring_edges() const { return m_rings.size(); }

  // The number of the vertex at corner c: along the rings, or behind them.
  Index number(Index c) const { return corner_vertex(c); }

  // The ring edge between two vertices with these numbers, null if there is none.
  Index ring_edge(Index u, Index v) const
  {
    if (u >= m_rings.size() || v >= m_rings.size())
      return null();
    return next(u) == v ? u : next(v) == u ? v : null();
  }

  // The halfedge of ring edge e that has its triangle on that side; the second slot of a T2 tells both of its edges.
  Index ring_halfedge(Index e, unsigned side) const
  {
    return skips_wart(e, side) || tip(e, side) == m_rings.second_next(e) ? corner(next(e), side, 2 - side)
                                                                         : corner(e, side, 0);
  }

  // Which one of the three halfedges from corner c on joins the least and the greatest vertex of a triangle, of which
  // c is the first corner.
  Index longest_side(Index c) const
  {
    const Index a = corner_vertex(c), b = corner_vertex(c + 1), v = corner_vertex(c + 2);
    return (a < v) == (v < b) ? 0 : (b < a) == (a < v) ? 1 : 2;
  }

  Laced_ring_counts counts() const
  {
    Laced_ring_counts counts = { m_rings.size(), m_isolated.size(), m_t0.size() / 6, 0, 0, 0 };
    for (std::size_t slot = 0; slot < num_ring_slots(); ++slot) {
      counts.num_skipped_warts += m_entries.is_wart_skipped(slot) ? 1 : 0;
      if (m_entries.is_irregular(slot))
        ++counts.num_irregular;
      else if (m_entries.is_long(slot))
        ++counts.num_long;
    }
    return counts;
  }

private:
  typedef Ring_triangles<Index> Triangles;
  static constexpr Index null() { return Corner_table<Index>::null(); }

  // The best ring of several ones for these tables.
  static std::unique_ptr<Triangles> best_ring(const Corner_table<Index>& table, std::size_t first_apex)
  {
    Ring_expander<Index> expander(table, first_apex);
    std::unique_ptr<Triangles> best;
    std::size_t least = 0;
    unsigned int seed = 0;
    for (const std::size_t period : Entries::periods()) {
      std::unique_ptr<Triangles> triangles(new Triangles(table, first_apex, expander.expand(period, seed++)));
      const std::size_t num_bits =
        Entries::num_bits(*triangles)
        + (6 * (triangles->num_slots() - triangles->num_ring_slots()) + triangles->num_isolated())
            * std::numeric_limits<Index>::digits;
      if (best != nullptr && num_bits >= least)
        continue;
      least = num_bits;
      best = std::move(triangles);
    }
    return best;
  }

  void store_t0(const Triangles& triangles)
  {
    m_t0.reserve(6 * (triangles.num_slots() - triangles.num_ring_slots()));
    for (std::size_t slot = triangles.num_ring_slots(); slot < triangles.num_slots(); ++slot) {
      for (unsigned k = 0; k < 3; ++k)
        m_t0.push_back(triangles.vertex(slot, k));
      for (unsigned k = 0; k < 3; ++k)
        m_t0.push_back(triangles.opposite(slot, k));
    }
  }

  // Of vertices off the rings, and where no ring slot at the vertex holds that of the border.
  void store_halfedges(const Closed_triangulation<Index>& t, const Triangles& triangles)
  {
    m_isolated.assign(triangles.num_isolated(), null());
    const std::size_t num_sides = 3 * t.num_open_faces();
    for (std::size_t h = 0; h < t.table().num_halfedges(); h += h < num_sides ? 1 : 3) { // those of borders last
      const Index v = triangles.number(t.table().target(static_cast<Index>(h)));
      const Index c = triangles.corner(static_cast<Index>(h));
      if (m_rings.size() <= v && v < m_first_apex)
        m_isolated[v - m_rings.size()] = c;
      else if (v < m_rings.size() && h >= num_sides && c / 3 >= num_ring_slots())
        m_border_halfedges.emplace_back(v, c);
    }
    std::sort(m_border_halfedges.begin(), m_border_halfedges.end());
    m_border_halfedges.shrink_to_fit();
    m_has_borders = t.table().num_faces() > t.num_open_faces();
  }

  std::size_t num_ring_slots() const { return 2 * std::size_t(m_rings.size()); }
  Index next(Index e) const { return m_rings.next(e); }
  Index prev(Index e) const { return m_rings.prev(e); }
  static std::size_t slot_of(Index e, unsigned side) { return 2 * std::size_t(e) + side; }
  static Index corner(Index e, unsigned side, unsigned k) { return static_cast<Index>(3 * slot_of(e, side) + k); }
  const Index* t0(std::size_t slot) const { return m_t0.data() + 6 * (slot - num_ring_slots()); }
  Index tip(Index e, unsigned side) const { return m_entries.tip(slot_of(e, side)); }
  bool skips_wart(Index e, unsigned side) const { return m_entries.is_wart_skipped(slot_of(e, side)); }

  // The vertex behind ring edge e, wart skipped if the slot says so.
  Index end(Index e, unsigned side) const { return skips_wart(e, side) ? m_rings.second_next(e) : next(e); }
  Index from(Index e, unsigned side) const { return side == 0 ? e : end(e, side); }
  Index to(Index e, unsigned side) const { return side == 0 ? end(e, side) : e; }

  // The ring edge whose slot ends at v in the order of the ring.
  Index before(Index v, unsigned side) const
  {
    const Index e = prev(v), wart = prev(e);
    return skips_wart(wart, side) ? wart : e;
  }
  Index leaving(Index v, unsigned side) const { return side == 0 ? v : before(v, side); }
  Index arriving(Index v, unsigned side) const { return side == 0 ? before(v, side) : v; }

  // In a redundant slot, the corners of the T2 in order are those of its other slot, turned.
  Index canonical(Index e, unsigned side, unsigned k, Index tip) const
  {
    return tip == m_rings.second_next(e) ? corner(next(e), side, side == 0 ? (k + 2) % 3 : (k + 1) % 3)
                                         : corner(e, side, k);
  }

  // The halfedge opposite to corner k of a regular triangle, from v to the tip (k = 1) or from the tip to v (k = 2).
  template <unsigned k>
  Index across(unsigned side, Index v, Index tip) const
  {
    // the ring edge is at v, and the triangle has the same tip ...
    const Index at_v = k == 1 ? leaving(v, side) : arriving(v, side);
    if (this->tip(at_v, side) == tip)
      return canonical(at_v, side, 3 - k, tip);
    // ... or it is at the tip, and v is the other tip
    return canonical(k == 1 ? arriving(tip, side) : leaving(tip, side), side, k, v);
  }

  BOOST_FORCEINLINE Index corner_vertex(Index c) const
  {
    const std::size_t slot = c / 3;
    const unsigned k = c % 3;
    if (slot >= num_ring_slots())
      return t0(slot)[k];
    const Index e = static_cast<Index>(slot / 2);
    const unsigned side = slot % 2;
    return k == 2 ? tip(e, side) : k == side ? e : end(e, side);
  }

  bool has_borders() const { return m_has_borders; }

  Index halfedge_of_bordered(Index r) const
  {
    const Index e = prev(r);
    if (!skips_wart(e, 0)) {
      const Index at_r = before(r, 0);
      if (tip(at_r, 0) >= m_first_apex)
        return corner(at_r, 0, 0);
    }
    if (tip(r, 1) >= m_first_apex)
      return corner(r, 1, 0);
    const auto it = std::lower_bound(m_border_halfedges.begin(), m_border_halfedges.end(), std::make_pair(r, Index(0)));
    return it != m_border_halfedges.end() && it->first == r ? it->second : ring_halfedge(e, 0);
  }

  Rings<Index> m_rings;
  Entries m_entries;
  std::vector<Index> m_t0;                                // three vertices, three opposite corners
  std::vector<Index> m_isolated;                          // a halfedge to each vertex that is on no ring
  std::vector<std::pair<Index, Index>> m_border_halfedges; // a vertex on a ring, and the halfedge to it on a border
  Copied_vertices<Index> m_vertices;
  Emptied_on_move<std::size_t> m_first_apex;
  Emptied_on_move<unsigned char> m_has_borders;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_LACED_RING_H
