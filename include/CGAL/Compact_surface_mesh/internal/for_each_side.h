// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_INTERNAL_FOR_EACH_SIDE_H
#define CGAL_COMPACT_SURFACE_MESH_INTERNAL_FOR_EACH_SIDE_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>

namespace CGAL {
namespace internal {

// Calls visit(i, h) for the halfedges h of all faces, numbered face by face in the order of
// faces(g), and in each face f from halfedge(f, g) on.
template <class FaceGraph, class Visitor>
void for_each_side(const FaceGraph& g, Visitor&& visit)
{
  typedef typename boost::graph_traits<FaceGraph>::halfedge_descriptor halfedge_descriptor;
  std::size_t i = 0;
  for (const auto f : faces(g)) {
    const halfedge_descriptor first = halfedge(f, g);
    halfedge_descriptor h = first;
    do {
      visit(i++, h);
      h = next(h, g);
    } while (h != first);
  }
}

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_INTERNAL_FOR_EACH_SIDE_H
