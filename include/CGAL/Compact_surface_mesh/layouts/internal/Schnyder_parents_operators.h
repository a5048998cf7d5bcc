// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_PARENTS_OPERATORS_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_PARENTS_OPERATORS_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_side.h>

#include <boost/config.hpp>

namespace CGAL {
namespace internal {

/*
The raw operators of the parents layout. A side is a halfedge named by the vertex x that
owns its edge: k = 0, 2, 4 runs from x to its red, blue, black parent, and k + 1 back. A
face is owned in two ways: A(x) is left of the red edge out of x, B(x) right of the
black one. Every face but the hidden ones is owned exactly once: label a corner 0, 1, 2
if it lies in the red, blue, black sector of its vertex (opposite the edge out of that
color); then every face has each label once, and

  A(x) = { P(x),  first sibling ? W(P(x)) : x - 1,  x }
  B(x) = { x,  leaf ? W(x) : last child of x,  Q(x) }          (labels 0, 1, 2)

The side from label 1 to label 2 is a black edge, or a blue one the other way round; all
flags of the records say which. So two of three vertices of a face give the third.

A record is a sector of its vertex: special edges of the wood part the edges around their ends
into sectors, and a vertex without special edges has one. The first sector starts behind the
red edge out, counterclockwise, and it alone has this edge and A(x); x is the first sector where
the operators say vertex. Parents name the sector that an edge enters, and lists the one that
it leaves. What differs between zones of the mesh is said by Zone: which vertices surround
a hidden apex, the vertex of a sector, and the last sector of a vertex. The sides around an apex
face its hole: they are looked up by their heads (border_side), and next() and prev() go
along the apex's family of red children, which is cyclic; at a vertex with several fans they
go from one fan to the next.
*/
template <class Records, class Index, class Zone>
struct Schnyder_parents_operators
{
  typedef Schnyder_side<Index> Side;
  typedef Schnyder_face<Index> Face;
  static constexpr typename Face::Owner A = Face::A, B = Face::B, hole = Face::hole;

  const Records& r;
  Zone zone;

  // The vertices with label 1 of A(x), and across the red edge of x, clockwise.
  Index after_red(Index x) const
  {
    if (zone.on_border(x))
      return zone.last_sector(pred(x));
    return r.is_first(x) ? r.blue_parent(r.red_parent(x)) : zone.last_sector(x - 1);
  }
  Index before_red(Index x) const
  {
    if (zone.on_border(x))
      return succ(x);
    return r.is_last(x) ? r.black_parent(r.red_parent(x)) : x + 1;
  }

  // The next one counterclockwise in the in-black list of black_parent(x), if there are more.
  Index next_in_black(Index x) const { return r.is_leaf(x) ? r.blue_parent(x) : zone.last_sector(r.last_child(x)); }

  BOOST_FORCEINLINE Index last_in_black(Index x) const
  {
    return BOOST_LIKELY(r.has_last_in_black(x)) ? r.last_in_black(x) : searched_last_in_black(*this, x);
  }
  // By value, so that what is inlined need not have its operators in memory.
  static BOOST_NOINLINE Index searched_last_in_black(Schnyder_parents_operators op, Index x)
  {
    return op.r.searched_last_in_black(x, op.after_red(x), [op](Index y) { return op.next_in_black(y); });
  }
  Index first_in_blue(Index x) const { return r.first_in_blue(x, before_red(zone.vertex(x))); }

  // The third vertex left of the black edge out of x.
  Index left_of_black(Index x) const { return r.in_blue(x) ? first_in_blue(x) : r.red_parent(zone.vertex(x)); }

  // The neighbors of x in the family of its apex.
  Index pred(Index x) const { return r.is_first(x) ? r.red_parent(x) : x - 1; }
  Index succ(Index x) const { return r.is_last(x) ? r.red_parent(x) : x + 1; }

  // The side that faces the hole of an apex and ends at x: that of the edge between x and the
  // vertex before it. If x has no blue edge out it is V_0, and the edge is the blue one of V_1; else
  // it is the first black edge into x, or the blue edge of x.
  Side border_side(Index x) const
  {
    if (r.blue_parent(x) == x)
      return { zone.last_sector(pred(x)), 2 };
    return r.in_black(x) ? Side{ zone.last_sector(pred(x)), 4 } : Side{ x, 3 };
  }

  // Whether a side faces a hole; then `head` is where it ends. Of the records with a blue edge
  // out, only the last one of V_1 has no black one.
  bool faces_hole(Side s, Index& head) const
  {
    switch (s.k) {
    case 2:
      head = r.blue_parent(s.x);
      return r.black_parent(s.x) == s.x;
    case 3:
      head = s.x;
      return zone.on_border(s.x) && !r.in_black(s.x);
    case 4:
      head = r.black_parent(s.x);
      return r.is_first_in_black(s.x) && zone.on_border(head);
    default:
      return false;
    }
  }

  // The records where a side starts and ends.
  Index source(Side s) const { return s.k & 1 ? r.parent(s.x, s.k / 2) : s.x; }
  Index target(Side s) const { return s.k & 1 ? s.x : r.parent(s.x, s.k / 2); }

  BOOST_FORCEINLINE Side next(Side s) const
  {
    const Index x = s.x;
    Index head;
    if (zone.may_face_hole(x) && faces_hole(s, head))
      return border_side(succ(zone.next_fan(head)));
    switch (s.k) {
    case 0:
      return r.is_first(x) ? Side{ r.red_parent(x), 2 } : Side{ x - 1, 1 };
    case 1: {
      const Index l = zone.last_sector(x);
      return r.in_blue(l) ? Side{ before_red(x), 3 } : Side{ l, 4 };
    }
    case 2:
      return r.more_blue(x) ? Side{ r.next_in_blue(x), 3 } : Side{ r.blue_parent(x), 4 };
    case 3:
      return r.in_black(x) ? Side{ last_in_black(x), 5 } : Side{ x, 0 };
    case 4:
      return r.is_first_in_black(x) ? Side{ r.black_parent(x), 0 } : Side{ left_of_black(x), 5 };
    default:
      return r.is_leaf(x) ? Side{ x, 2 } : Side{ r.last_child(x), 1 };
    }
  }

  BOOST_FORCEINLINE Side prev(Side s) const
  {
    const Index x = s.x;
    Index head;
    if (zone.may_face_hole(x) && faces_hole(s, head))
      return border_side(zone.prev_fan(pred(head)));
    switch (s.k) {
    case 0:
      return r.in_black(x) ? Side{ after_red(x), 4 } : Side{ x, 3 };
    case 1:
      return r.is_last(x) ? Side{ r.red_parent(x), 5 } : Side{ x + 1, 0 };
    case 2:
      return r.is_leaf(x) ? Side{ x, 5 } : Side{ r.first_child(x), 0 };
    case 3: {
      if (!r.in_black(x))
        return r.is_first(x) ? Side{ r.red_parent(x), 2 } : Side{ x - 1, 1 };
      const Index y = last_in_black(x);
      return r.is_leaf(y) ? Side{ y, 2 } : Side{ r.last_child(y), 1 };
    }
    case 4:
      return r.in_blue(x) ? Side{ first_in_blue(x), 2 } : Side{ zone.vertex(x), 1 };
    default:
      return r.more_black(x) ? Side{ next_in_black(x), 4 } : Side{ r.black_parent(x), 3 };
    }
  }

  BOOST_FORCEINLINE Face face(Side s) const
  {
    const Index x = s.x;
    Index head;
    if (zone.may_face_hole(x) && faces_hole(s, head))
      return { head, hole };
    switch (s.k) {
    case 0:
      return { x, A };
    case 1:
      return r.is_last(x) ? Face{ r.red_parent(x), B } : Face{ x + 1, A };
    case 2:
      return r.is_leaf(x) ? Face{ x, B } : Face{ r.first_child(x), A };
    case 3:
      return r.in_black(x) ? Face{ last_in_black(x), B } : Face{ x, A };
    case 4:
      return r.is_first_in_black(x) ? Face{ r.black_parent(x), A } : Face{ left_of_black(x), B };
    default:
      return { x, B };
    }
  }
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_PARENTS_OPERATORS_H
