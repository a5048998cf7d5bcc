// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef BENCHMARK_COMPACT_SURFACE_MESH_ALL_LAYOUTS_H
#define BENCHMARK_COMPACT_SURFACE_MESH_ALL_LAYOUTS_H

// The layouts of this package and those of papers, beside it.

#include "../../examples/Compact_surface_mesh/compared_meshes.h"

#include <CGAL/Compact_surface_mesh/layouts/Laced_ring_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/SOT_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/SQuad_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/Schnyder_fronts_layout.h>

#include <cstdint>
#include <tuple>
#include <utility>

/// A new one is one line here, or in `Layouts`.
using Layouts_of_papers = std::tuple<CGAL::Schnyder_fronts_layout<6>,
                                     CGAL::Schnyder_fronts_layout<5>,
                                     CGAL::Schnyder_fronts_layout<4>,
                                     CGAL::Schnyder_fronts_layout<5, true>,
                                     CGAL::SOT_layout<>,
                                     CGAL::SQuad_layout<>,
                                     CGAL::Laced_ring_layout<>,
                                     CGAL::Laced_ring_layout<std::uint32_t, std::uint16_t> >;

using All_layouts = decltype(std::tuple_cat(std::declval<example::Layouts>(), std::declval<Layouts_of_papers>()));

#endif // BENCHMARK_COMPACT_SURFACE_MESH_ALL_LAYOUTS_H
