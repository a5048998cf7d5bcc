// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_INTERNAL_PAIRED_CORNERS_H
#define CGAL_COMPACT_SURFACE_MESH_INTERNAL_PAIRED_CORNERS_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/internal/Large_array.h>

namespace CGAL {
namespace internal {

// The vertex of a corner, and the opposite of the halfedge that starts there. Who asks for one soon asks for the
// other: side by side they are in the same line of the cache, whatever the order of the faces.
template <class Index>
struct Paired_corner
{
  Index vertex, opposite;
};

template <class Index>
using Paired_corners = Large_array<Paired_corner<Index>>;

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_INTERNAL_PAIRED_CORNERS_H
