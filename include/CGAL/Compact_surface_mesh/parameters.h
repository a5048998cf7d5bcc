// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The named parameters of this package's own.

#ifndef CGAL_COMPACT_SURFACE_MESH_PARAMETERS_H
#define CGAL_COMPACT_SURFACE_MESH_PARAMETERS_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL {

namespace internal_np {

enum input_index_maps_t { input_index_maps };

} // namespace internal_np

namespace parameters {

/*!
\ingroup PkgCompactSurfaceMeshRef

asks a constructor of `Compact_surface_mesh` to add the property maps `"v:input_index"`
and `"f:input_index"`, which tell the indices of vertices and faces in the input.

As only the named parameters of \cgal can be appended to others, this one has to
come first: `input_index_maps(true).vertex_to_vertex_map(m)`.
*/
inline Named_function_parameters<bool, internal_np::input_index_maps_t>
input_index_maps(bool wanted)
{
  return Named_function_parameters<bool, internal_np::input_index_maps_t>(wanted);
}

} // namespace parameters

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_PARAMETERS_H
