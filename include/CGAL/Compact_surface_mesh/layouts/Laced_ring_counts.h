// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_LACED_RING_COUNTS_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_LACED_RING_COUNTS_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgCompactSurfaceMeshRef

How many vertices and triangles of each kind a laced ring has, the hidden ones that close borders included:
what the costs in section 8 of LR depend on (see `Laced_ring_layout`).
*/
struct Laced_ring_counts
{
  /// vertices on the ring.
  std::size_t num_ring_vertices;
  /// vertices with triangles that are on no ring.
  std::size_t num_isolated_vertices;
  /// triangles \f$T_0\f$, without ring edge, but for those that skip a wart.
  std::size_t num_t0;
  /// triangles \f$T_0^w\f$, which skip a wart.
  std::size_t num_skipped_warts;
  /// irregular triangles \f$T^i\f$: those that are beside a \f$T_0\f$.
  std::size_t num_irregular;
  /// entries \f$T^l\f$ with a long reference; none if entries are references.
  std::size_t num_long;
};

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_LACED_RING_COUNTS_H
