// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_INPUT_IMAGES_H
#define CGAL_COMPACT_SURFACE_MESH_INPUT_IMAGES_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <cstdint>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgCompactSurfaceMeshRef

What a layout made of the elements of its input.

\tparam Index the integer type of the layout
*/
template <class Index = std::uint32_t>
struct Input_images
{
  /// the vertex of the layout for each vertex of the input.
  std::vector<Index> vertices;

  /// whether to tell the halfedges as well, which takes time and memory.
  bool wants_halfedges = false;

  /// the halfedge of the layout for each halfedge of the input: those of the first face from its
  /// first vertex on, those of the second one, and so on. Empty if they are not wanted.
  std::vector<Index> halfedges;
};

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_INPUT_IMAGES_H
