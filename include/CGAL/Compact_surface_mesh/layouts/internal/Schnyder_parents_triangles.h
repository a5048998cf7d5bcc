// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_PARENTS_TRIANGLES_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_PARENTS_TRIANGLES_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_parents_numbering.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_parents_operators.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace internal {

// All records, with the answers that Schnyder_parents_operators asks for.
template <class Records, class Index>
struct Schnyder_any_zone
{
  static constexpr bool has_holes = true;
  const Records& r;
  const Schnyder_parents_numbering<Index>& n;

  bool on_border(Index x) const { return n.on_border(x); }
  Index vertex(Index x) const { return x < n.sectors ? x : r.red_parent(x); }
  Index next_fan(Index x) const { return r.has_more_fans(x) ? n.fan(x).next : x; }
  Index prev_fan(Index x) const { return r.has_more_fans(x) ? n.fan(x).prev : x; }
  Index last_sector(Index x) const
  {
    if (!r.has_more_sectors(x))
      return x;
    Index low = n.sectors, high = n.end;
    while (low < high) {
      const Index middle = low + (high - low) / 2;
      if (r.red_parent(middle) <= x)
        low = middle + 1;
      else
        high = middle;
    }
    return low - 1;
  }
};

// The operators on the triangles of the parents layout, by the numbers of their elements, on all
// surfaces: to be used outside the core, and right in it.
template <class Records, class Index>
class Schnyder_parents_triangles
{
  typedef Schnyder_any_zone<Records, Index> Zone;
  typedef Schnyder_parents_numbering<Index> Numbering;

public:
  typedef Schnyder_parents_operators<Records, Index, Zone> Operators;
  typedef typename Operators::Side Side;
  typedef typename Operators::Face Face;

  Schnyder_parents_triangles(const Records& records, const Numbering& numbering)
    : r(records), n(numbering)
  {}

  static constexpr Index null() { return (std::numeric_limits<Index>::max)(); }

  std::size_t num_vertices() const { return n.vertices.count(); }
  std::size_t num_halfedges() const { return 2 * n.edges.count(); }
  std::size_t num_faces() const { return n.faces.count(); }

  Index next(Index h) const { return halfedge(operators().next(side(h))); }
  Index prev(Index h) const { return halfedge(operators().prev(side(h))); }
  static Index opposite(Index h) { return h ^ 1; }
  Index source(Index h) const { return vertex(operators().source(side(h))); }
  Index target(Index h) const { return vertex(operators().target(side(h))); }
  Index face(Index h) const { return face(operators().face(side(h))); }

  // null for an isolated vertex
  Index halfedge_of_vertex(Index v) const
  {
    const Index x = n.vertices.slot(v);
    if (x >= n.isolated)
      return null();
    return halfedge(x < n.border ? Side{ x, 1 } : operators().border_side(x));
  }

  Index halfedge_of_face(Index f) const
  {
    const Index slot = n.faces.slot(f), cap = n.cap_of_face(slot);
    if (cap != n.end)
      return halfedge(operators().border_side(cap));
    return halfedge(Side{ n.record_of_face(slot), slot < 2 * n.border && slot % 2 == 0 ? 0u : 5u });
  }

  // null if u and v are not adjacent
  Index halfedge(Index u, Index v) const
  {
    const Index h = halfedge_out_of(u, v);
    if (h != null())
      return h;
    const Index g = halfedge_out_of(v, u);
    return g == null() ? g : g ^ 1;
  }

  // From sides, faces and records to numbers.
  Index halfedge(Side s) const
  {
    Index slot = n.edge_slot(s.x, s.k);
    unsigned end = s.k & 1;
    if (r.is_irregular(s.x)) {
      const auto* copy = n.special_copy(slot);
      if (copy != nullptr && copy->other < slot) {
        slot = copy->other;
        end = end == copy->live ? 1u - copy->other_live : copy->other_live;
      }
    }
    return static_cast<Index>(2 * n.edges.number(slot) + end);
  }

  Index face(Face f) const
  {
    if (f.owner != Operators::hole)
      return n.faces.number(n.face_slot(f.x, f.owner));
    return f.x < n.caps ? null() : n.faces.number(n.cap_slot(f.x));
  }

  Index vertex(Index x) const
  {
    if (x >= n.sectors)
      x = r.red_parent(x);
    return n.vertices.number(r.has_more_fans(x) ? n.fan(x).first : x);
  }

private:
  Operators operators() const { return Operators{ r, Zone{ r, n } }; }

  Side side(Index h) const
  {
    Index slot = h / 2;
    unsigned end = h & 1;
    if (r.is_irregular(n.record_of_edge(slot))) {
      slot = n.edges.slot(slot);
      const auto* copy = n.special_copy(slot);
      if (copy != nullptr && end != copy->live) {
        slot = copy->other;
        end = copy->other_live;
      }
    }
    return { n.record_of_edge(slot), n.k_of_edge(slot) | end };
  }

  // The halfedge from u to v that u owns, or null.
  Index halfedge_out_of(Index u, Index v) const
  {
    const Zone zone{ r, n };
    const Index first_fan = n.vertices.slot(u);
    if (first_fan >= n.isolated)
      return null();
    Index x = first_fan;
    do {
      for (unsigned word = n.on_border(x) ? 1 : 0; word < 3; ++word)
        if (leads_to(x, word, v))
          return halfedge(Side{ x, 2 * word });
      for (Index s = zone.last_sector(x); s != x && zone.vertex(s) == x; --s)
        for (unsigned word : { 1u, 2u })
          if (leads_to(s, word, v))
            return halfedge(Side{ s, 2 * word });
      x = zone.next_fan(x);
    } while (x != first_fan);
    return null();
  }

  bool leads_to(Index x, unsigned word, Index v) const
  {
    const Index p = r.parent(x, word);
    return p != x && vertex(p) == v;
  }

  const Records& r;
  const Numbering& n;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_PARENTS_TRIANGLES_H
