// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_TRIANGLES_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_TRIANGLES_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_side.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace internal {

// The operators on the triangles of a layout that stands on a Schnyder wood, by the numbers of their
// elements, on all surfaces: to be used outside the core, and right in it. Operators has them by sides, faces and
// records, and Numbering the slots and numbers of these. Operators::Zone is that of all records.
template <class Operators, class Numbering, class Index>
class Schnyder_triangles
{
public:
  typedef Schnyder_side<Index> Side;
  typedef Schnyder_face<Index> Face;

  Schnyder_triangles(const Operators& operators, const Numbering& numbering)
    : op(operators), n(numbering)
  {}

  static constexpr Index null() { return (std::numeric_limits<Index>::max)(); }

  std::size_t num_vertices() const { return n.vertices.count(); }
  std::size_t num_halfedges() const { return 2 * n.edges.count(); }
  std::size_t num_faces() const { return n.faces.count(); }

  Index next(Index h) const { return halfedge(op.next(side(h))); }
  Index prev(Index h) const { return halfedge(op.prev(side(h))); }
  static Index opposite(Index h) { return h ^ 1; }
  Index source(Index h) const { return vertex(op.source(side(h))); }
  Index target(Index h) const { return vertex(op.target(side(h))); }
  Index face(Index h) const { return face(op.face(side(h))); }

  // null for an isolated vertex
  Index halfedge_of_vertex(Index v) const
  {
    const Index x = n.vertices.slot(v);
    if (op.zone.is_isolated(x))
      return null();
    return halfedge(op.zone.on_border(x) ? op.border_side(x) : Side{ x, 1 });
  }

  Index halfedge_of_face(Index f) const
  {
    const Face face = op.zone.face_of_slot(n.faces.slot(f));
    if (face.owner == Face::hole)
      return halfedge(op.border_side(face.x));
    return halfedge(Side{ face.x, face.owner == Face::A ? 0u : 5u });
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

  // Calls visit(u) for each neighbor u of v.
  template <class Visitor>
  void for_each_adjacent_vertex(Index v, Visitor&& visit) const
  {
    for_each_side_into(v, [&](Side s, Side) { visit(vertex(op.source(s))); });
  }

  // Calls visit(u, w) for each face (v,u,w).
  template <class Visitor>
  void for_each_incident_triangle(Index v, Visitor&& visit) const
  {
    for_each_side_into(v, [&](Side s, Side following) {
      if (!is_on_border(s))
        visit(vertex(op.target(following)), vertex(op.source(s)));
    });
  }

  // From sides, faces and records to numbers.
  Index halfedge(Side s) const
  {
    Index slot = n.edge_slot(s.x, s.k);
    unsigned end = s.k & 1;
    if (op.zone.is_irregular(s)) {
      const auto* copy = n.copies.find(slot);
      if (copy != nullptr && copy->other < slot) {
        slot = copy->other;
        end = end == copy->live ? 1u - copy->other_live : copy->other_live;
      }
    }
    return static_cast<Index>(2 * n.edges.number(slot) + end);
  }

  Index face(Face f) const
  {
    if (f.owner != Face::hole)
      return n.faces.number(n.face_slot(f.x, f.owner));
    const Index slot = op.zone.slot_of_hole(f.x); // null but in caps
    return slot == null() ? slot : n.faces.number(slot);
  }

  Index vertex(Index x) const { return n.vertices.number(op.zone.first_fan(op.zone.vertex(x))); }

private:
  // Calls visit(s, t) for each side s into v, clockwise, where t is the one that follows s around its face.
  template <class Visitor>
  void for_each_side_into(Index v, Visitor&& visit) const
  {
    const Index x = n.vertices.slot(v);
    if (op.zone.is_isolated(x))
      return;
    const Side first = op.zone.on_border(x) ? op.border_side(x) : Side{ x, 1 };
    Side s = first;
    do {
      const Side following = op.next(s);
      visit(s, following);
      s = live(Side{ following.x, following.k ^ 1 });
    } while (s.x != first.x || s.k != first.k);
  }

  // Whether there is no face left of s.
  bool is_on_border(Side s) const
  {
    const Face f = op.face(s);
    return f.owner == Face::hole && op.zone.slot_of_hole(f.x) == null();
  }

  Side side(Index h) const
  {
    const Side s = side_in_slot(h / 2, h & 1);
    return op.zone.is_irregular(s) ? live(side_in_slot(n.edges.slot(h / 2), h & 1)) : s;
  }

  Side side_in_slot(Index slot, unsigned end) const { return { n.record_of_edge(slot), n.k_of_edge(slot) | end }; }

  // The side that bounds a face, where a special edge has a copy for each of its two faces.
  Side live(Side s) const
  {
    if (op.zone.is_irregular(s)) {
      const auto* copy = n.copies.find(n.edge_slot(s.x, s.k));
      if (copy != nullptr && (s.k & 1) != copy->live)
        return side_in_slot(copy->other, copy->other_live);
    }
    return s;
  }

  // The halfedge from u to v that u owns, or null.
  Index halfedge_out_of(Index u, Index v) const
  {
    const Index first_fan = n.vertices.slot(u);
    if (op.zone.is_isolated(first_fan))
      return null();
    Index x = first_fan;
    do {
      for (unsigned k = op.zone.on_border(x) ? 2 : 0; k < 6; k += 2)
        if (leads_to(Side{ x, k }, v))
          return halfedge(Side{ x, k });
      for (Index s = op.zone.last_sector(x); s != x && op.zone.vertex(s) == x; --s)
        for (unsigned k : { 2u, 4u })
          if (leads_to(Side{ s, k }, v))
            return halfedge(Side{ s, k });
      x = op.zone.next_fan(x);
    } while (x != first_fan);
    return null();
  }

  // The target of a missing edge is its source.
  bool leads_to(Side s, Index v) const
  {
    const Index p = op.target(s);
    return p != s.x && vertex(p) == v;
  }

  Operators op;
  const Numbering& n;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_TRIANGLES_H
