// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_PARENTS_STAR_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_PARENTS_STAR_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <boost/config.hpp>

namespace CGAL {
namespace internal {

/*
The star of a record of the parents layout that is the only sector of its vertex, off the borders: from the red edge
on, in-black counterclockwise, the blue parent, the red children, the black parent; and in-blue clockwise. Visitors get
records. Each loop calls its visitor in one place: with two, compilers stop inlining it.
*/
template <class Operators, class Index>
class Schnyder_parents_star
{
public:
  BOOST_FORCEINLINE Schnyder_parents_star(const Operators& op, Index v)
    : op(op), v(v)
  {}

  // Calls visit(u) for each neighbor.
  template <class Visitor>
  BOOST_FORCEINLINE void for_each_neighbor(Visitor&& visit) const
  {
    visit(op.r.red_parent(v));
    for_each_in_black(visit);
    visit(op.r.blue_parent(v));
    for_each_child(visit);
    visit(op.r.black_parent(v));
    for_each_in_blue(visit);
  }

  // Calls visit(u, w) for each triangle (v,u,w).
  template <class Visitor>
  BOOST_FORCEINLINE void for_each_triangle(Visitor&& visit) const
  {
    const Index red = op.r.red_parent(v), blue = op.r.blue_parent(v), black = op.r.black_parent(v);
    Index last = red;
    const auto counterclockwise = [&](Index u) {
      visit(last, u);
      last = u;
    };
    const auto clockwise = [&](Index u) {
      visit(u, last);
      last = u;
    };
    for_each_in_black(counterclockwise);
    counterclockwise(blue);
    for_each_child(counterclockwise);
    counterclockwise(black);
    last = red;
    for_each_in_blue(clockwise);
    clockwise(black);
  }

  BOOST_FORCEINLINE Index degree() const
  {
    Index d = op.r.number_of_children(v) + 3;
    const auto count = [&d](Index) { ++d; };
    for_each_in_black(count);
    for_each_in_blue(count);
    return d;
  }

private:
  template <class Visitor>
  BOOST_FORCEINLINE void for_each_in_black(Visitor&& visit) const
  {
    if (!op.r.in_black(v))
      return;
    for (Index u = op.after_red(v);; u = op.next_in_black(u)) {
      visit(u);
      if (!op.r.more_black(u))
        return;
    }
  }

  template <class Visitor>
  BOOST_FORCEINLINE void for_each_in_blue(Visitor&& visit) const
  {
    if (!op.r.in_blue(v))
      return;
    for (Index u = op.before_red(v);; u = op.r.next_in_blue(u)) {
      visit(u);
      if (!op.r.more_blue(u))
        return;
    }
  }

  template <class Visitor>
  BOOST_FORCEINLINE void for_each_child(Visitor&& visit) const
  {
    if (op.r.is_leaf(v))
      return;
    const Index end = op.r.last_child(v) + 1;
    for (Index u = op.r.first_child(v); u != end; ++u)
      visit(u);
  }

  Operators op;
  Index v;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_PARENTS_STAR_H
