// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_FOR_EACH_FACE_FROM_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_FOR_EACH_FACE_FROM_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <array>

namespace CGAL {
namespace internal {

// Calls visit(f, u, v, w) for the faces `f` of a layout from `first` on, with its `vertices_of_face(f)`.
template <class Layout, class Visitor>
void for_each_face_from(typename Layout::Index first, const Layout& layout, Visitor&& visit)
{
  typedef typename Layout::Index Index;
  const Index end = static_cast<Index>(layout.num_faces());
  for (Index f = first; f < end; ++f) {
    const std::array<Index, 3> v = layout.vertices_of_face(f);
    visit(f, v[0], v[1], v[2]);
  }
}

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_FOR_EACH_FACE_FROM_H
