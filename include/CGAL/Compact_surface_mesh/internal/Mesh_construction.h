// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_INTERNAL_MESH_CONSTRUCTION_H
#define CGAL_COMPACT_SURFACE_MESH_INTERNAL_MESH_CONSTRUCTION_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/Input_images.h>
#include <CGAL/Compact_surface_mesh/Simple_triangulation.h>
#include <CGAL/Compact_surface_mesh/internal/Input_report.h>
#include <CGAL/Compact_surface_mesh/internal/numbered_vertices.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>
#include <iterator>
#include <utility>

namespace CGAL {
namespace internal {

// Makes an empty mesh that of an input. The mesh keeps its property maps; if this throws, they may have
// been resized.
template <class Mesh>
class Mesh_construction
{
  using Index = typename Mesh::size_type;

public:
  explicit Mesh_construction(Mesh& mesh) : m_mesh(mesh) {}

  // Copies a FaceListGraph, with the named parameters of the mesh's constructor.
  template <class FaceGraph, class NamedParameters>
  void copy_graph(const FaceGraph& g, const NamedParameters& np)
  {
    if constexpr (parameters::is_default_parameter<NamedParameters, internal_np::vertex_index_t>::value) {
      if (has_removed_vertices(g)) {
        copy_graph(g, numbered_vertices(g), np);
        return;
      }
    } else
      check_numbering(g, parameters::get_parameter(np, internal_np::vertex_index));
    copy_graph(g, get_initialized_vertex_index_map(g, np), np);
  }

  // Takes a polygon soup, with the named parameters of the mesh's constructor.
  template <class PointRange, class PolygonRange, class NamedParameters>
  void take_soup(const PointRange& points, const PolygonRange& polygons, const NamedParameters& np)
  {
    const std::size_t n = static_cast<std::size_t>(std::distance(std::begin(points), std::end(points)));
    construct(Simple_triangulation<Index>(n, polygons), Soup_input<PointRange, PolygonRange>(points, polygons), np);
  }

private:
  template <class FaceGraph, class VertexIndexMap, class NamedParameters>
  void copy_graph(const FaceGraph& g, const VertexIndexMap& vertex_index, const NamedParameters& np)
  {
    if constexpr (parameters::is_default_parameter<NamedParameters, internal_np::vertex_point_t>::value)
      copy_graph(g, vertex_index, get_const_property_map(CGAL::vertex_point, g), np);
    else
      copy_graph(g, vertex_index, parameters::get_parameter(np, internal_np::vertex_point), np);
  }

  template <class FaceGraph, class VertexIndexMap, class PointMap, class NamedParameters>
  void copy_graph(const FaceGraph& g, const VertexIndexMap& vertex_index, const PointMap& point,
                  const NamedParameters& np)
  {
    construct(Simple_triangulation<Index>(g, vertex_index),
              Graph_input<FaceGraph, PointMap, VertexIndexMap>(g, point, vertex_index), np);
  }

  // The connectivity comes first, so that the memory for its construction is free again
  // when the points are copied. What the caller owns is written to last.
  template <class Input, class NamedParameters>
  void construct(Simple_triangulation<Index>&& t, const Input& input, const NamedParameters& np)
  {
    Input_images<Index> images;
    images.wants_halfedges = wants_halfedges(np);
    m_mesh.set_layout(typename Mesh::Layout(Closed_triangulation<Index>(std::move(t)), images));
    input.for_each_point([&](std::size_t i, const auto& p) {
      m_mesh.point(typename Mesh::Vertex_index(images.vertices[i])) = converted_point<typename Mesh::Point>(p);
    });
    report_input(input, images, m_mesh, np);
  }

  Mesh& m_mesh;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_INTERNAL_MESH_CONSTRUCTION_H
