// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef BENCHMARK_COMPACT_SURFACE_MESH_SPEED_COMPARISON_H
#define BENCHMARK_COMPACT_SURFACE_MESH_SPEED_COMPARISON_H

#include "../../examples/Compact_surface_mesh/comparison.h"

#include <memory>

/// compares traversals and single operators in all structures that are wanted. `soup` must live as long.
std::unique_ptr<const example::Comparison> speed_comparison(const example::Triangle_soup& soup,
                                                            const example::Comparison::Selection& wants);

#endif // BENCHMARK_COMPACT_SURFACE_MESH_SPEED_COMPARISON_H
