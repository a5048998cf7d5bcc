// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_PARENTS_ZONE_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_PARENTS_ZONE_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_parents_numbering.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_sectors.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_side.h>

#include <boost/config.hpp>

#include <limits>

namespace CGAL {
namespace internal {

// All records of the parents layout, with the answers that Schnyder_parents_operators and
// Schnyder_triangles ask for.
template <class Records, class Index>
struct Schnyder_parents_zone
{
  typedef Schnyder_parents_numbering<Index> Numbering;
  const Records& r;
  const Numbering& n;

  bool is_isolated(Index x) const { return n.isolated <= x && x < n.sectors; }
  bool is_irregular(Schnyder_side<Index> s) const { return r.is_irregular(s.x, s.k / 2); }
  bool may_face_hole(Index x) const { return x >= n.border; }
  bool on_border(Index x) const { return n.on_border(x); }
  Index vertex(Index x) const { return x < n.sectors ? x : r.red_parent(x); }
  Index first_fan(Index x) const { return x >= n.border && r.has_more_fans(x) ? n.fans[x].first : x; }
  Index next_fan(Index x) const { return r.has_more_fans(x) ? n.fans[x].next : x; }
  Index prev_fan(Index x) const { return r.has_more_fans(x) ? n.fans[x].prev : x; }
  Index last_sector(Index x) const { return BOOST_LIKELY(!r.has_more_sectors(x)) ? x : searched_last_sector(r, n, x); }
  static BOOST_NOINLINE Index searched_last_sector(const Records& r, const Numbering& n, Index x)
  {
    return last_sector_of<Index>(x, n.sectors, n.end - n.sectors, n.search_sectors,
                                 [&r](Index s) { return r.red_parent(s); });
  }

  Schnyder_face<Index> face_of_slot(Index slot) const { return n.face_of_slot(slot); }
  Index slot_of_hole(Index x) const { return x < n.caps ? (std::numeric_limits<Index>::max)() : n.cap_slot(x); }
};

// The records of vertices off the borders, and their first sectors.
template <class Records, class Index>
struct Schnyder_inner_zone
{
  const Records& r;
  const Schnyder_parents_numbering<Index>& n;

  static bool may_face_hole(Index) { return false; }
  static bool on_border(Index) { return false; }
  static Index vertex(Index x) { return x; }
  static Index next_fan(Index x) { return x; }
  static Index prev_fan(Index x) { return x; }
  Index last_sector(Index x) const { return Schnyder_parents_zone<Records, Index>{ r, n }.last_sector(x); }
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_PARENTS_ZONE_H
