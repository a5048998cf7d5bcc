// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_INTERNAL_ROOTED_SPHERE_H
#define CGAL_SCHNYDER_WOODS_INTERNAL_ROOTED_SPHERE_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/Corner_table.h>
#include <CGAL/Compact_surface_mesh/internal/numbered_vertices.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace internal {

// A mesh that is a triangulated sphere, with its root face, as a corner table, and the
// way back from the table's halfedges to those of the mesh.
template <class FaceGraph>
struct Rooted_sphere
{
  typedef typename boost::graph_traits<FaceGraph>::halfedge_descriptor halfedge_descriptor;
  typedef std::uint32_t Index;

  // `root` runs from V_1 to V_0 along the root face. Throws Mesh_defect_exception if g is
  // no triangulated sphere.
  Rooted_sphere(const FaceGraph& g, halfedge_descriptor root)
  {
    table = Corner_table<Index>(g, numbered_vertices(g));
    Closed_triangulation<Index>::check(table);

    halfedges.reserve(table.num_halfedges());
    for (const auto f : faces(g)) {
      halfedge_descriptor h = halfedge(f, g);
      for (int i = 0; i < 3; ++i, h = next(h, g))
        halfedges.push_back(h);
    }
    base = static_cast<Index>(std::find(halfedges.begin(), halfedges.end(), root) - halfedges.begin());
  }

  Corner_table<Index> table;
  std::vector<halfedge_descriptor> halfedges;
  Index base = 0;
};

// The halfedge in which functions root a wood if they are not told.
template <class FaceGraph>
typename boost::graph_traits<FaceGraph>::halfedge_descriptor default_root(const FaceGraph& g)
{
  return faces(g).begin() == faces(g).end() ? boost::graph_traits<FaceGraph>::null_halfedge()
                                            : halfedge(*faces(g).begin(), g);
}

} // namespace internal
} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_INTERNAL_ROOTED_SPHERE_H
