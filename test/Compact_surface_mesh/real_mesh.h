// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_REAL_MESH_H
#define TEST_COMPACT_SURFACE_MESH_REAL_MESH_H

#include "generated_triangulations.h"

#include <CGAL/IO/OFF.h>
#include <CGAL/Simple_cartesian.h>

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace test {

/// A triangle mesh of CGAL's data, from an OFF file; no vertices where it could not be had.
inline Soup real_mesh(const std::string& name)
{
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  Soup soup{0, {}};
  std::vector<std::vector<std::uint32_t>> faces;
  std::ifstream in(CGAL::data_file_path("meshes/" + name));
  if (!in || !CGAL::IO::read_OFF(in, points, faces))
    return soup;
  soup.num_vertices = static_cast<std::uint32_t>(points.size());
  for (const auto& face : faces)
    soup.triangles.push_back({face.at(0), face.at(1), face.at(2)});
  return soup;
}

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_REAL_MESH_H
