// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef BENCHMARK_COMPACT_SURFACE_MESH_POSITIVE_NUMBER_H
#define BENCHMARK_COMPACT_SURFACE_MESH_POSITIVE_NUMBER_H

#include <cstdlib>

/// The number that `word` is, or 0 if it is no positive number.
inline unsigned long positive_number(const char* word)
{
  char* end;
  const unsigned long n = std::strtoul(word, &end, 10);
  return *end == '\0' ? n : 0;
}

#endif // BENCHMARK_COMPACT_SURFACE_MESH_POSITIVE_NUMBER_H
