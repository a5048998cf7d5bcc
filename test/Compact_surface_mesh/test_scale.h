// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_TEST_SCALE_H
#define TEST_COMPACT_SURFACE_MESH_TEST_SCALE_H

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace test {

// A size of generated data, by the factor COMPACT_SURFACE_MESH_TEST_SCALE of the
// environment; at least 10 of what is counted in thousands, and nothing less than 1.
inline std::size_t scaled(std::size_t size)
{
  const char* const factor = std::getenv("COMPACT_SURFACE_MESH_TEST_SCALE");
  const double scaled_size = (factor == nullptr ? 1.0 : std::atof(factor)) * static_cast<double>(size);
  return (std::max)(static_cast<std::size_t>(scaled_size), size >= 1000 ? std::size_t(10) : std::size_t(1));
}

// Up to how many vertices all triangulations are enumerated: 9, and 8 on a smaller scale.
inline int largest_exhaustive() { return scaled(1000) >= 1000 ? 9 : 8; }

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_TEST_SCALE_H
