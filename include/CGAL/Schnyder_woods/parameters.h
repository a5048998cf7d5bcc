// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The named parameters of this package's own for functions on graphs of any type.

#ifndef CGAL_SCHNYDER_WOODS_PARAMETERS_H
#define CGAL_SCHNYDER_WOODS_PARAMETERS_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL {

namespace internal_np {

enum edge_weight_map_t { edge_weight_map };

} // namespace internal_np

namespace parameters {

/*!
\ingroup PkgSchnyderWoodsRef

tells `cut_graph()` and `cut_graph_loops()` what the edges weigh: a readable property map from
edges to a number type, nonnegative and finite.

As only the named parameters of \cgal can be appended to others, this one has to
come first: `edge_weight_map(m).random_seed(7)`.
*/
template <class EdgeWeightMap>
Named_function_parameters<EdgeWeightMap, internal_np::edge_weight_map_t>
edge_weight_map(const EdgeWeightMap& map)
{
  return Named_function_parameters<EdgeWeightMap, internal_np::edge_weight_map_t>(map);
}

} // namespace parameters

} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_PARAMETERS_H
