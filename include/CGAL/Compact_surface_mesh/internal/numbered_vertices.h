// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_INTERNAL_NUMBERED_VERTICES_H
#define CGAL_COMPACT_SURFACE_MESH_INTERNAL_NUMBERED_VERTICES_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Dynamic_property_map.h>

#include <cstddef>

namespace CGAL {
namespace internal {

// Numbers the vertices of `g` from 0 in the order of vertices(g): without holes, whatever is
// marked as removed in g, and whether or not g has indices of its own.
template <class FaceGraph>
auto numbered_vertices(const FaceGraph& g)
{
  auto numbers = get(dynamic_vertex_property_t<std::size_t>(), g);
  std::size_t i = 0;
  for (const auto v : vertices(g))
    put(numbers, v, i++);
  return numbers;
}

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_INTERNAL_NUMBERED_VERTICES_H
