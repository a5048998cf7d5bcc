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
#include <CGAL/Compact_surface_mesh/internal/versions_of_cgal.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace internal {

// Named parameters that have what `np` has by the name From by the name To as well.
template <class From, class To, class NamedParameters>
auto renamed_parameter(const NamedParameters& np)
{
  if constexpr (parameters::is_default_parameter<NamedParameters, From>::value)
    return np;
  else {
    const auto value = parameters::get_parameter(np, From());
    return Named_function_parameters<std::decay_t<decltype(value)>, To, NamedParameters>(value, np);
  }
}

// The names that CGAL 6 has for what polygon soups are told of their elements, as those of the constructor.
template <class NamedParameters>
auto soup_parameters(const NamedParameters& np)
{
  return renamed_parameter<Polygon_to_face_map, internal_np::face_to_face_map_t>(
    renamed_parameter<Polygon_to_face_output_iterator, internal_np::face_to_face_output_iterator_t>(
      renamed_parameter<Point_to_vertex_map, internal_np::vertex_to_vertex_map_t>(
        renamed_parameter<Point_to_vertex_output_iterator, internal_np::vertex_to_vertex_output_iterator_t>(np))));
}

// Makes an empty mesh that of an input. The mesh keeps its property maps; if this throws, they may have
// been resized. Further ones are added by `owner`, the mesh or who answers for it.
template <class Mesh, class Owner = Mesh>
class Mesh_construction
{
  using Index = typename Mesh::size_type;

public:
  Mesh_construction(Mesh& mesh, Owner& owner) : m_mesh(mesh), m_owner(owner) {}

  // Copies a FaceListGraph, with the named parameters of the mesh's constructor.
  template <class FaceGraph, class NamedParameters>
  void copy_graph(const FaceGraph& g, const NamedParameters& np)
  {
    copy_graph(g, np, m_mesh.points());
  }

  // The same with the points in another property map of the mesh.
  template <class FaceGraph, class NamedParameters, class PointMap>
  void copy_graph(const FaceGraph& g, const NamedParameters& np, const PointMap& point_map)
  {
    if constexpr (parameters::is_default_parameter<NamedParameters, internal_np::vertex_index_t>::value) {
      if (has_removed_vertices(g)) {
        copy_indexed_graph(g, numbered_vertices(g), np, point_map);
        return;
      }
    } else
      check_numbering(g, parameters::get_parameter(np, internal_np::vertex_index));
    copy_indexed_graph(g, get_initialized_vertex_index_map(g, np), np, point_map);
  }

  // Takes a polygon soup, with the named parameters of the mesh's constructor.
  template <class PointRange, class PolygonRange, class NamedParameters>
  void take_soup(const PointRange& points, const PolygonRange& polygons, const NamedParameters& np)
  {
    take_soup(points, polygons, np, m_mesh.points());
  }

  // The same with the points in another property map of the mesh.
  template <class PointRange, class PolygonRange, class NamedParameters, class PointMap>
  void take_soup(const PointRange& points, const PolygonRange& polygons, const NamedParameters& np,
                 const PointMap& point_map)
  {
    const std::size_t n = static_cast<std::size_t>(std::distance(std::begin(points), std::end(points)));
    construct(Simple_triangulation<Index>(n, polygons), Soup_input<PointRange, PolygonRange>(points, polygons),
              soup_parameters(np), point_map);
  }

private:
  template <class FaceGraph, class VertexIndexMap, class NamedParameters, class PointMap>
  void copy_indexed_graph(const FaceGraph& g, const VertexIndexMap& vertex_index, const NamedParameters& np,
                          const PointMap& point_map)
  {
    const auto copy = [&](const auto& source_points) {
      using Source_points = std::decay_t<decltype(source_points)>;
      construct(Simple_triangulation<Index>(g, vertex_index),
                Graph_input<FaceGraph, Source_points, VertexIndexMap>(g, source_points, vertex_index), np, point_map);
    };
    if constexpr (parameters::is_default_parameter<NamedParameters, internal_np::vertex_point_t>::value)
      copy(get_const_property_map(CGAL::vertex_point, g));
    else
      copy(parameters::get_parameter(np, internal_np::vertex_point));
  }

  // The connectivity comes first, so that the memory for its construction is free again
  // when the points are copied. What the caller owns is written to last.
  template <class Input, class NamedParameters, class PointMap>
  void construct(Simple_triangulation<Index>&& t, const Input& input, const NamedParameters& np,
                 const PointMap& point_map)
  {
    Input_images<Index> images;
    images.wants_halfedges = wants_halfedges(np) || input.has_maps_that_need_halfedges();
    m_mesh.set_layout(typename Mesh::Layout(Closed_triangulation<Index>(std::move(t)), images));
    input.for_each_point([&](std::size_t i, const auto& p) {
      put(point_map, typename Mesh::Vertex_index(images.vertices[i]),
          converted_point<typename boost::property_traits<PointMap>::value_type>(p));
    });
    report_input(input, images, m_mesh, m_owner, np);
  }

  Mesh& m_mesh;
  Owner& m_owner;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_INTERNAL_MESH_CONSTRUCTION_H
