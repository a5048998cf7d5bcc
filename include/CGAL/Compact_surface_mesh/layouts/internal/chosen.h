// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_CHOSEN_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_CHOSEN_H

#include <CGAL/license/Compact_surface_mesh.h>

namespace CGAL {
namespace internal {

// Returns `a` if `first`, else `b`, by a mask: for what processors cannot guess, where both are at hand.
template <class Index>
constexpr Index chosen(bool first, Index a, Index b)
{
  return static_cast<Index>(b ^ ((a ^ b) & static_cast<Index>(0 - static_cast<Index>(first))));
}

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_CHOSEN_H
