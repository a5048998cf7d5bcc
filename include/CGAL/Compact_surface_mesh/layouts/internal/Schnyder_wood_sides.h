// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_WOOD_SIDES_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_WOOD_SIDES_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/Corner_table.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_sectors.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_side.h>
#include <CGAL/Schnyder_woods/internal/Schnyder_wood.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace internal {

// What the halfedges of a triangulation with a Schnyder wood are as sides of records. `record` has the
// records of vertices and further sectors by their names in Schnyder_sectors.
template <class Index>
struct Schnyder_wood_sides
{
  typedef Schnyder_side<Index> Side;

  const Corner_table<Index>& table;
  const Schnyder_wood& wood;
  const Schnyder_sectors<Index>& sectors;
  const std::vector<Index>& record;

  // The record of the sector of corner c.
  Index record_of_corner(Index c) const { return record[sectors.sector(table, c)]; }

  // The side of h in the copy of its edge that bounds its face.
  Side operator()(Index h) const
  {
    const Index corner = wood.is_outgoing(h) ? h : table.next(h);
    const unsigned back = wood.is_outgoing(h) ? 0 : 1;
    if (wood.color(h) == red) // between the first and the last sector
      return { record[table.vertex(corner)], back };
    return { record_of_corner(corner), (wood.color(h) == blue ? 2 : 4) + back };
  }
};

// The number of each halfedge of `t` in the layout that has these sides and triangles; null for those at apices.
template <class Index, class Triangles>
std::vector<Index> numbers_of_halfedges(const Closed_triangulation<Index>& t, const Schnyder_wood_sides<Index>& side,
                                        const Triangles& triangles)
{
  std::vector<Index> result(t.table().num_halfedges(), Corner_table<Index>::null());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const Index h = static_cast<Index>(i);
    if ((std::max)(t.table().source(h), t.table().target(h)) < t.first_apex())
      result[h] = triangles.halfedge(side(h));
  }
  return result;
}

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_WOOD_SIDES_H
