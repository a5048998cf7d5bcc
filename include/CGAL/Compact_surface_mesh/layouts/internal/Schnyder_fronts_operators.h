// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_FRONTS_OPERATORS_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_FRONTS_OPERATORS_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_side.h>

#include <boost/config.hpp>

#include <cstddef>

// Tests count here in how many steps targets are found.
#ifndef CGAL_SCHNYDER_FRONTS_LAYOUT_COUNT_STEP
#  define CGAL_SCHNYDER_FRONTS_LAYOUT_COUNT_STEP
#endif

namespace CGAL {
namespace internal {

/*
The raw operators of the fronts layouts (L. Castelli Aleardi, O. Devillers, 2018, theorems 2, 4, 5 and 6).

Let e be the edge of color c out of x, and v its target. The front left of e is of color c and into v, or the edge
of the next color out of v; the front right of it is of color c and into v, or the edge of the previous color out
of v, where red, blue, black follow each other. So next() along e, and prev() against e, are fronts. The
third side of each face follows from the rule around x and the fronts of the other two sides: it is an edge
out of x, if the list of edges into x that may be between is empty, and else the third vertex's.

With four or five fronts, those that are not stored follow from the wood having no clockwise faces: an edge u v,
a list of edges into u that is not empty, and the directions at v leave one direction to the third side. There is no
exception, in any genus: of the faces that an extremal wood exempts, all but one have an apex, which no edge leaves,
and the one across V_1 V_0 has its corner at V_0 where all edges come in.

Records are sectors of vertices, and faces are owned, as in Schnyder_parents_operators. Around an apex, next()
and prev() go along its hole; its own edges, the red ones of the vertices around it, come out of no operator.
*/
template <class Records, class Index, class Zone>
struct Schnyder_fronts_operators
{
  typedef Schnyder_side<Index> Side;
  typedef Schnyder_face<Index> Face;

  const Records& r;
  Zone zone;

  bool in_red(Index x) const { return r.has(Records::has_in_red, x); }
  bool in_blue(Index x) const { return r.has(Records::has_in_blue, x); }
  bool in_black(Index x) const { return r.has(Records::has_in_black, x); }

  // The fronts of the three edges out of x.
  BOOST_FORCEINLINE Side red_left(Index x) const
  {
    const Side s = r.side_at(x, Records::red_left);
    if constexpr (Zone::has_holes)
      if (s.k >= Records::border)
        return { zone.pred(x), 1 };
    if (Records::is_renumbered && s.k == 1)
      return { x - 1, 1 };
    if (Records::num_fronts < 6 && s.k == 5)
      return { r.record_at(s.x, Records::black_right), 2 }; // case black of theorem 4
    return s;
  }

  BOOST_FORCEINLINE Side red_right(Index x) const
  {
    if constexpr (!Records::is_renumbered)
      return r.side_at(x, Records::red_right);
    if constexpr (Zone::has_holes)
      if (zone.on_border(x))
        return { zone.succ(x), 0 };
    if (has_next_sibling(x))
      return { x + 1, 0 };
    return black_left(zone.last_sector(x)); // theorem 5
  }

  BOOST_FORCEINLINE Side blue_left(Index x) const
  {
    if constexpr (Records::num_fronts == 6)
      return r.side_at(x, Records::blue_left);
    return r.side_at(x, in_red(x) ? Records::blue : Records::black_right); // case 1 of theorem 4
  }

  BOOST_FORCEINLINE Side blue_right(Index x) const
  {
    if constexpr (Records::num_fronts == 6)
      return r.side_at(x, Records::blue_right);
    if (!in_red(x))
      return r.side_at(x, Records::blue);
    if (!in_black(x))
      return red_left(x); // case 2a
    const Side s = r.side_at(x, Records::blue); // case 2b
    const Index w = s.k & 1 ? s.x : r.record_at(s.x, Records::black_left);
    return { r.record_at(w, Records::red_left), 2 };
  }

  Side black_left(Index x) const { return r.side_at(x, Records::black_left); }
  Side black_right(Index x) const { return r.side_at(x, Records::black_right); }

  // The records where a side starts and ends.
  BOOST_FORCEINLINE Index source(Side s) const { return s.k & 1 ? parent(s.x, s.k - 1) : s.x; }
  BOOST_FORCEINLINE Index target(Side s) const { return s.k & 1 ? s.x : parent(s.x, s.k); }

  BOOST_FORCEINLINE Side next(Side s) const
  {
    const Index x = s.x;
    if constexpr (Zone::has_holes) {
      const Face f = face(s);
      if (f.owner == Face::hole)
        return border_side_out_of(zone.next_fan(f.x));
    }
    switch (s.k) {
    case 0:
      return red_left(x);
    case 1: {
      const Index l = zone.last_sector(x);
      if (!in_blue(l))
        return { l, 4 };
      const Side f = red_right(x);
      return f.k & 1 ? black_right(f.x) : Side{ f.x, 3 };
    }
    case 2:
      return blue_left(x);
    case 3: {
      if (!in_black(x))
        return { x, 0 };
      const Side f = blue_right(x);
      return f.k & 1 ? red_right(f.x) : Side{ f.x, 5 };
    }
    case 4:
      return black_left(x);
    default: {
      if (!in_red(x))
        return { x, 2 };
      const Side f = black_right(x);
      return f.k & 1 ? blue_right(f.x) : Side{ zone.vertex(f.x), 1 };
    }
    }
  }

  BOOST_FORCEINLINE Side prev(Side s) const
  {
    const Index x = s.x;
    if constexpr (Zone::has_holes) {
      const Face f = face(s);
      if (f.owner == Face::hole)
        return border_side(zone.prev_fan(zone.pred(f.x)));
    }
    switch (s.k) {
    case 0: {
      if (!in_black(x))
        return { x, 3 };
      const Side f = red_left(x);
      return f.k & 1 ? Side{ zone.last_sector(f.x), 4 } : blue_left(f.x);
    }
    case 1:
      return red_right(x);
    case 2: {
      if (!in_red(x))
        return { x, 5 };
      const Side f = blue_left(x);
      return f.k & 1 ? Side{ f.x, 0 } : black_left(f.x);
    }
    case 3:
      return blue_right(x);
    case 4: {
      if (!in_blue(x))
        return { zone.vertex(x), 1 };
      const Side f = black_left(x);
      return f.k & 1 ? Side{ f.x, 2 } : red_left(f.x);
    }
    default:
      return black_right(x);
    }
  }

  // Of the sides of a face, one is 0 and it is owned as A, or 5 and it is owned as B.
  BOOST_FORCEINLINE Face face(Side s) const
  {
    const Index x = s.x;
    if (Zone::has_holes && s.k == 2 && r.lacks(x, 4))
      return { zone.vertex(blue_left(x).x), Face::hole }; // from V_1 to V_0
    switch (s.k) {
    case 0:
      return { x, Face::A };
    case 1: {
      const Side f = red_right(x);
      return f.k & 1 ? Face{ f.x, Face::B } : left_of_red(f.x);
    }
    case 2: {
      if (!in_red(x))
        return { x, Face::B };
      const Side f = blue_left(x);
      return left_of_red(f.k & 1 ? f.x : black_left(f.x).x);
    }
    case 3: {
      if (!in_black(x))
        return left_of_red(x);
      const Side f = blue_right(x);
      return { f.k & 1 ? red_right(f.x).x : f.x, Face::B };
    }
    case 4: {
      const Side f = black_left(x);
      return f.k & 1 ? Face{ f.x, Face::B } : left_of_red(f.x);
    }
    default:
      return { x, Face::B };
    }
  }

  // The vertex where side s ends and side t, the next one in a face, starts.
  BOOST_FORCEINLINE Index vertex_between(Side s, Side t) const
  {
    return s.k & 1 ? s.x : t.k & 1 ? parent(s.x, s.k) : t.x;
  }

  // The side that faces the hole of an apex and ends at x, which lies around the apex.
  Side border_side(Index x) const
  {
    if (r.lacks(x, 2))
      return { zone.last_sector(zone.pred(x)), 2 };
    return in_black(x) ? Side{ zone.last_sector(zone.pred(x)), 4 } : Side{ x, 3 };
  }

  // The one that starts at x.
  Side border_side_out_of(Index x) const
  {
    const Index l = zone.last_sector(x);
    if (in_blue(l))
      return { zone.succ(x), 3 };
    return { l, r.lacks(l, 4) ? 2u : 4u };
  }

private:
  bool has_next_sibling(Index x) const
  {
    if (Zone::has_holes && std::size_t(x) + 1 >= r.records.size())
      return false;
    return r.k_at(x + 1, Records::red_left) == 1;
  }

  BOOST_FORCEINLINE Face left_of_red(Index x) const
  {
    return { x, Zone::has_holes && zone.on_border(x) ? Face::hole : Face::A };
  }

  // The target of the edge of color k / 2 out of x; x if there is none.
  BOOST_FORCEINLINE Index parent(Index x, unsigned k) const
  {
    if (Zone::has_holes && k != 0 && r.lacks(x, k))
      return x;
    switch (k) {
    case 0:
      return red_parent(x);
    case 2:
      return blue_parent(x);
    default:
      return black_parent(x);
    }
  }

  // With targets, the red child or sibling that a front names has the target, or it is the source of the next front:
  // the depths of x and its children in the red tree have different parities, but at one vertex of each red cycle.
  // Without targets, walks go around the target, to the edge out of it in which the list of edges into it ends:
  // counterclockwise among black edges, where no special edge can be between, and clockwise among others.
  Index red_parent(Index x) const
  {
    Side s = r.side_at(x, Records::red_left);
    if (!Records::is_renumbered)
      while (s.k == 1)
        s = r.side_at(s.x, Records::red_left);
    return Records::num_fronts < 6 && s.k == 5 ? r.record_at(s.x, Records::black_right) : s.x;
  }

  Index blue_parent(Index x) const
  {
    if constexpr (Records::stores_targets)
      while (true) {
        if (!in_red(x)) {
          const Side s = black_right(x);
          return s.k & 1 ? r.record_at(x, Records::other_target) : s.x;
        }
        if (!r.has(Records::black_target, x))
          return r.record_at(x, Records::other_target);
        const Side s = r.side_at(x, Records::blue);
        if (!(s.k & 1))
          return s.x;
        CGAL_SCHNYDER_FRONTS_LAYOUT_COUNT_STEP
        x = s.x;
      }
    Side s = blue_left(x);
    while (s.k & 1)
      s = blue_left(s.x);
    return s.x;
  }

  Index black_parent(Index x) const
  {
    if constexpr (Records::stores_targets)
      while (true) {
        const Side s = black_right(x);
        if (!in_red(x))
          return s.k & 1 ? s.x : r.record_at(x, Records::other_target);
        if (r.has(Records::black_target, x))
          return r.record_at(x, Records::other_target);
        if (s.k & 1)
          return s.x;
        CGAL_SCHNYDER_FRONTS_LAYOUT_COUNT_STEP
        x = s.x;
      }
    Side s = black_right(x);
    while (!(s.k & 1))
      s = black_right(s.x);
    return s.x;
  }
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_FRONTS_OPERATORS_H
