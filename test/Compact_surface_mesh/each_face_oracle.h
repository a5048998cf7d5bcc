// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_EACH_FACE_ORACLE_H
#define TEST_COMPACT_SURFACE_MESH_EACH_FACE_ORACLE_H

#include <array>
#include <cstddef>
#include <optional>

namespace test {

/// returns the first visit of a layout's `for_each_face()` that is not of the next face with its `vertices_of_face()`, or
/// is missing.
template <class Layout>
std::optional<std::size_t> first_wrong_visit(const Layout& layout)
{
  typedef typename Layout::Index Index;
  std::size_t n = 0;
  std::optional<std::size_t> wrong;
  layout.for_each_face([&](Index f, Index u, Index v, Index w) {
    const std::array<Index, 3> vertices{ u, v, w };
    if (!wrong && !(f == n && n < layout.num_faces() && layout.vertices_of_face(f) == vertices))
      wrong = n;
    ++n;
  });
  if (!wrong && n != layout.num_faces())
    wrong = n;
  return wrong;
}

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_EACH_FACE_ORACLE_H
