// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_INTERNAL_EDGE_WEIGHTS_H
#define CGAL_SCHNYDER_WOODS_INTERNAL_EDGE_WEIGHTS_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Schnyder_woods/internal/Surface_to_cut.h>
#include <CGAL/Schnyder_woods/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>
#include <CGAL/squared_distance_3.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>

namespace CGAL {
namespace internal {

// What an edge weighs, by the named parameters.
template <class FaceGraph, class NamedParameters>
auto edge_weights(const FaceGraph& g, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef typename boost::graph_traits<FaceGraph>::edge_descriptor edge_descriptor;

  if constexpr (parameters::is_default_parameter<NamedParameters, internal_np::edge_weight_map_t>::value) {
    const auto point = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                        get_const_property_map(vertex_point, g));
    return [&g, point](edge_descriptor e) {
      return std::sqrt(CGAL::to_double(CGAL::squared_distance(get(point, source(e, g)), get(point, target(e, g)))));
    };
  } else {
    const auto weight = get_parameter(np, internal_np::edge_weight_map);
    return [weight](edge_descriptor e) { return CGAL::to_double(get(weight, e)); };
  }
}

// What there is to be cut of a mesh, by the named parameters.
template <class FaceGraph, class NamedParameters>
Surface_to_cut<FaceGraph> surface_to_cut(const FaceGraph& g, const NamedParameters& np)
{
  typedef typename boost::graph_traits<FaceGraph>::vertex_descriptor vertex_descriptor;
  const auto is_constrained =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_is_constrained),
                                   Static_boolean_property_map<vertex_descriptor, false>());
  return Surface_to_cut<FaceGraph>(g, is_constrained, edge_weights(g, np));
}

} // namespace internal
} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_INTERNAL_EDGE_WEIGHTS_H
