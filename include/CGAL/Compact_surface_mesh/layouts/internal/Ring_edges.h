// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_RING_EDGES_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_RING_EDGES_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Corner_table.h>
#include <CGAL/Compact_surface_mesh/internal/Emptied_on_move.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Filled_slots.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Ranked_edges.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

/*
Numbers edges where vertices are numbered along rings, for next to nothing: first the ring edges; then the
edges by triangles. On either side of a ring, the triangles are those of a polygon, with the numbers of its vertices
ascending, and each edge but the sides of the polygon joins the least and the greatest vertex of one triangle:
this one *has* the edge. So a triangle has one edge, and an edge is had by one triangle, but for the triangle where
the ring is closed, and around vertices off the ring and handles: triangles without an edge of their own, and edges
of no triangle, stand in lists. Where these would be long, and where polygons hide edges, bits are ranked.
*/
template <class Index>
class Ring_edges
{
public:
  Ring_edges() = default;

  template <class Layout, class Corners>
  Ring_edges(const Layout& layout, const Corners& corners, bool are_some_hidden)
  {
    if (are_some_hidden || !list(corners))
      m_ranked = Ranked_edges<Index>(layout, corners, are_some_hidden);
  }

  std::size_t count() const { return is_listed() ? m_slots.count() : m_ranked.count(); }

  template <class Layout, class Corners>
  Index edge(const Layout& layout, const Corners& corners, Index h) const
  {
    if (!is_listed())
      return m_ranked.edge(layout, corners, h);
    const auto& table = corners.table();
    const Index c = corners.corner(h), u = table.number(c), v = table.number(Table::next(c));
    const Index e = table.ring_edge(u, v);
    return e != null() ? e : m_slots.number(m_num_ring_edges + place(corners, h, c, u, v));
  }

  template <class Corners>
  Index halfedge(const Corners& corners, Index e) const
  {
    if (!is_listed())
      return m_ranked.halfedge(corners, e);
    if (e < m_num_ring_edges)
      return corners.halfedge_at(corners.table().ring_halfedge(e, 0));
    const Index f = m_slots.slot(e) - m_num_ring_edges;
    if (f >= corners.num_faces())
      return m_of_no_triangle[f - corners.num_faces()];
    return longest_side(corners, f);
  }

  std::size_t bytes() const
  {
    return m_ranked.bytes() + m_slots.bytes() + m_of_no_triangle.capacity() * sizeof(Index);
  }

private:
  typedef Corner_table<Index> Table;

  static constexpr Index null() { return (std::numeric_limits<Index>::max)(); }
  bool is_listed() const { return m_num_ring_edges != 0; }

  // Returns whether lists are shorter than bits.
  template <class Corners>
  bool list(const Corners& corners)
  {
    const std::size_t num_ring_edges = corners.table().num_ring_edges();
    std::vector<Index> dead;
    for (Index f = 0; f < corners.num_faces(); ++f)
      if (!has_edge(corners, f))
        dead.push_back(static_cast<Index>(num_ring_edges + f));
    for (Index h = 0; h < corners.num_halfedges(); ++h) {
      const Index g = corners.opposite(h);
      if (h < g && !is_longest_side(corners, h) && !is_longest_side(corners, g)
          && ring_edge(corners, h) == null())
        m_of_no_triangle.push_back(h);
    }
    const std::size_t num_slots = num_ring_edges + corners.num_faces() + m_of_no_triangle.size();
    if (num_slots < null())
      m_slots = Filled_slots<Index>(num_slots, std::move(dead));
    const std::size_t num_bits = 8 * (m_slots.bytes() + m_of_no_triangle.size() * sizeof(Index));
    if (num_ring_edges == 0 || num_slots >= null() || num_bits >= corners.num_halfedges()) {
      *this = Ring_edges();
      return false;
    }
    m_num_ring_edges = static_cast<Index>(num_ring_edges);
    m_of_no_triangle.shrink_to_fit();
    return true;
  }

  template <class Corners>
  static Index ring_edge(const Corners& corners, Index h)
  {
    const Index c = corners.corner(h);
    return corners.table().ring_edge(corners.table().number(c), corners.table().number(Table::next(c)));
  }

  // The side of face f that joins its least and its greatest vertex.
  template <class Corners>
  static Index longest_side(const Corners& corners, Index f)
  {
    const Index h = Corners::halfedge_of_face(f);
    return h + corners.table().longest_side(corners.corner(h));
  }

  template <class Corners>
  static bool is_longest_side(const Corners& corners, Index h)
  {
    const Index f = corners.face(h);
    return f != null() && longest_side(corners, f) == h;
  }

  // Of two triangles with the same longest side, the first one has the edge.
  template <class Corners>
  static bool has_edge(const Corners& corners, Index f)
  {
    const Index h = longest_side(corners, f);
    if (ring_edge(corners, h) != null())
      return false;
    const Index g = corners.opposite(h);
    return !is_longest_side(corners, g) || f < corners.face(g);
  }

  // Behind the ring edges, the place of the edge of h, from corner c to the next one, with the numbers u and v; it is
  // off the ring. Who has it, `has_edge()` and `list()` decide alike.
  template <class Corners>
  Index place(const Corners& corners, Index h, Index c, Index u, Index v) const
  {
    const Index d = corners.table().opposite(c), g = corners.halfedge_at(d);
    const Index f = corners.face(h), f_of_g = corners.face(g);
    const auto is_longest = [&](Index face, Index third) { // the third vertex is between
      if (face == null())
        return false;
      const Index w = corners.table().number(third);
      return (u < w) == (w < v);
    };
    const bool of_h = is_longest(f, Table::prev(c)), of_g = is_longest(f_of_g, Table::prev(d));
    if (of_h || of_g)
      return of_h && !(of_g && f_of_g < f) ? f : f_of_g;
    const auto it = std::lower_bound(m_of_no_triangle.begin(), m_of_no_triangle.end(), (std::min)(g, h));
    return static_cast<Index>(corners.num_faces() + static_cast<std::size_t>(it - m_of_no_triangle.begin()));
  }

  Emptied_on_move<Index> m_num_ring_edges; // 0 if bits are ranked
  Ranked_edges<Index> m_ranked;
  Filled_slots<Index> m_slots;         // the ring edges, the faces, and the edges of no triangle
  std::vector<Index> m_of_no_triangle; // their first halfedges, sorted
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_RING_EDGES_H
