// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_BINARY_OFF_H
#define TEST_COMPACT_SURFACE_MESH_BINARY_OFF_H

#include <CGAL/IO/binary_file_io.h>

#include <initializer_list>
#include <sstream>
#include <string>

namespace test {

/// A tetrahedron as a binary OFF file, which CGAL does not write: with normals (1,2,3), colors of vertices
/// (1,0.5,0), texture coordinates (0.5,0.25), and a color of the first face alone, (0,0,1).
inline std::string binary_off_of_tetrahedron()
{
  std::ostringstream os;
  const auto write_integers = [&](std::initializer_list<int> integers) {
    for (const int i : integers)
      CGAL::I_Binary_write_big_endian_integer32(os, i);
  };
  const auto write_floats = [&](std::initializer_list<float> floats) {
    for (const float f : floats)
      CGAL::I_Binary_write_big_endian_float32(os, f);
  };
  os << "STCNOFF BINARY\n";
  write_integers({ 4, 4, 6 });
  for (int i = 0; i < 4; ++i) {
    write_floats({ i == 1 ? 1.f : 0.f, i == 2 ? 1.f : 0.f, i == 3 ? 1.f : 0.f });
    write_floats({ 1, 2, 3, 1, 0.5f, 0, 1, 0.5f, 0.25f });
  }
  write_integers({ 3, 0, 2, 1, 3 });
  write_floats({ 0, 0, 1 });
  write_integers({ 3, 0, 1, 3, 0, 3, 1, 2, 3, 0, 3, 2, 0, 3, 0 });
  return os.str();
}

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_BINARY_OFF_H
