// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_BUMPY_SPHERE_H
#define TEST_COMPACT_SURFACE_MESH_BUMPY_SPHERE_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <cmath>

namespace test {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Surface_mesh = CGAL::Surface_mesh<Point>;

/// An icosahedron with every triangle cut into 4^levels, whose vertices are moved in and
/// out so that no two edges have the same length.
inline Surface_mesh bumpy_sphere(unsigned int levels = 2)
{
  Surface_mesh mesh;
  CGAL::make_icosahedron<Surface_mesh, Point>(mesh);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(levels));
  for (const auto v : mesh.vertices()) {
    const double i = static_cast<double>(v.idx());
    mesh.point(v) = CGAL::ORIGIN + (1 + 0.1 * std::sin(i * i)) * (mesh.point(v) - CGAL::ORIGIN);
  }
  return mesh;
}

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_BUMPY_SPHERE_H
