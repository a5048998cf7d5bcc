// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// What differs between CGAL 5 and CGAL 6 for this package. No other header asks for the version.

#ifndef CGAL_COMPACT_SURFACE_MESH_INTERNAL_VERSIONS_OF_CGAL_H
#define CGAL_COMPACT_SURFACE_MESH_INTERNAL_VERSIONS_OF_CGAL_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/config.h>

#include <optional>
#include <utility>

// For what only the preprocessor can choose: headers, and names that only one version has.
#if CGAL_VERSION_NR >= 1060000000
#define CGAL_COMPACT_SURFACE_MESH_WITH_CGAL_6 1
#else
#define CGAL_COMPACT_SURFACE_MESH_WITH_CGAL_6 0
#endif

namespace CGAL {
namespace internal {

inline constexpr bool is_with_cgal_6 = CGAL_COMPACT_SURFACE_MESH_WITH_CGAL_6;

// What property_map() answers, as an optional: a pair in CGAL 5, an optional in CGAL 6.
template <class Map>
std::optional<Map> optional_map(const std::pair<Map, bool>& answer)
{
  return answer.second ? std::optional<Map>(answer.first) : std::nullopt;
}

template <class Map>
std::optional<Map> optional_map(const std::optional<Map>& answer)
{
  return answer;
}

// Tags of named parameters. Those that CGAL 5 lacks are never given there.
#if CGAL_COMPACT_SURFACE_MESH_WITH_CGAL_6
using Point_to_vertex_output_iterator = internal_np::point_to_vertex_output_iterator_t;
using Point_to_vertex_map = internal_np::point_to_vertex_map_t;
using Polygon_to_face_output_iterator = internal_np::polygon_to_face_output_iterator_t;
using Polygon_to_face_map = internal_np::polygon_to_face_map_t;
using Do_not_triangulate_faces = internal_np::do_not_triangulate_faces_t;
#else
enum Point_to_vertex_output_iterator {};
enum Point_to_vertex_map {};
enum Polygon_to_face_output_iterator {};
enum Polygon_to_face_map {};
enum Do_not_triangulate_faces {};
#endif

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_INTERNAL_VERSIONS_OF_CGAL_H
