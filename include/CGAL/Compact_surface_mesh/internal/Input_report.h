// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// How a constructor reads its input, and tells what became of it.

#ifndef CGAL_COMPACT_SURFACE_MESH_INTERNAL_INPUT_REPORT_H
#define CGAL_COMPACT_SURFACE_MESH_INTERNAL_INPUT_REPORT_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Mesh_defect_exception.h>
#include <CGAL/Compact_surface_mesh/internal/for_each_side.h>
#include <CGAL/Compact_surface_mesh/internal/simple_property_maps.h>
#include <CGAL/Compact_surface_mesh/parameters.h>

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

namespace internal {

template <class T>
struct Is_array_of_3 : std::false_type {};

template <class Number>
struct Is_array_of_3<std::array<Number, 3> > : std::true_type {};

// The point p as a Point, converted between kernels where C++ does not convert it. Three coordinates are a point, too.
template <class Point, class Source>
Point converted_point(const Source& p)
{
  if constexpr (std::is_convertible<const Source&, Point>::value)
    return p;
  else if constexpr (Is_array_of_3<Source>::value)
    return Point(p[0], p[1], p[2]);
  else
    return Cartesian_converter<typename Kernel_traits<Source>::Kernel, typename Kernel_traits<Point>::Kernel>()(p);
}

// boost::graph_traits, with no members for a type that cannot be a graph.
template <class Graph, bool can_be_graph = std::is_class<Graph>::value>
struct Possible_graph_traits
  : boost::graph_traits<Graph>
{};

template <class Graph>
struct Possible_graph_traits<Graph, false>
{};

// Whether g counts vertices that are only marked as removed, as Surface_mesh does: then
// its indices have gaps.
template <class FaceGraph>
bool has_removed_vertices(const FaceGraph& g)
{
  return vertices(g).size() != static_cast<std::size_t>(num_vertices(g));
}

// Throws Mesh_defect_exception if `index` does not number the vertices of g from 0 without
// holes. Faces would not show it at isolated vertices.
template <class FaceGraph, class VertexIndexMap>
void check_numbering(const FaceGraph& g, const VertexIndexMap& index)
{
  std::vector<bool> is_used(static_cast<std::size_t>(std::distance(vertices(g).begin(), vertices(g).end())), false);
  std::size_t k = 0;
  for (const auto v : vertices(g)) {
    const std::size_t i = static_cast<std::size_t>(get(index, v));
    if (i >= is_used.size() || is_used[i])
      throw Mesh_defect_exception(Mesh_defect::wrong_vertex_index, k);
    is_used[i] = true;
    ++k;
  }
}

// Takes the pairs (element of the input, element of the mesh) of one kind to where the
// caller wants them: an output iterator, a property map, both or neither.
template <class OutputIterator, class Map>
class Correspondence
{
  using Missing = internal_np::Param_not_found;
  static constexpr bool to_iterator = !std::is_same<OutputIterator, Missing>::value;
  static constexpr bool to_map = !std::is_same<Map, Missing>::value;

public:
  static constexpr bool is_wanted = to_iterator || to_map;

  Correspondence(const OutputIterator& iterator, const Map& map) : m_iterator(iterator), m_map(map) {}

  template <class Source, class Target>
  void operator()(const Source& source, const Target& target)
  {
    if constexpr (to_iterator)
      *m_iterator++ = std::make_pair(source, target);
    if constexpr (to_map) // soups are indexed by std::size_t, maps of them often by int
      put(m_map, static_cast<typename boost::property_traits<Map>::key_type>(source), target);
  }

private:
  OutputIterator m_iterator;
  Map m_map;
};

template <class NamedParameters, class IteratorTag, class MapTag>
auto correspondence(const NamedParameters& np, IteratorTag iterator_tag, MapTag map_tag)
{
  auto iterator = parameters::get_parameter(np, iterator_tag);
  auto map = parameters::get_parameter(np, map_tag);
  return Correspondence<decltype(iterator), decltype(map)>(iterator, map);
}

// The two kinds of input are seen alike. Sides are the halfedges of faces, counted face by face. They call
//   visit(i, p)         for the point p of each vertex, where i is its index in the input,
//   visit(source, i)    for each vertex,
//   visit(source, i, b) for each halfedge, where i is the index of its side if b is false, and that
//                       of the other side of its edge if b is true and it lies on a border,
//   visit(source, i)    for each face, whose first side has index i.

// A range of ranges of indices, and the points beside it.
template <class PointRange, class PolygonRange>
class Soup_input
{
public:
  Soup_input(const PointRange& points, const PolygonRange& polygons)
    : m_points(points), m_polygons(polygons)
  {}

  template <class Visitor>
  void for_each_point(Visitor visit) const
  {
    std::size_t i = 0;
    for (const auto& p : m_points)
      visit(i++, p);
  }

  template <class Visitor>
  void for_each_vertex(Visitor visit) const
  {
    const std::size_t n = static_cast<std::size_t>(std::distance(std::begin(m_points), std::end(m_points)));
    for (std::size_t i = 0; i < n; ++i)
      visit(i, i);
  }

  template <class Visitor>
  void for_each_face(Visitor visit) const
  {
    std::size_t f = 0, side = 0;
    for (const auto& polygon : m_polygons) {
      visit(f++, side);
      side += static_cast<std::size_t>(std::distance(std::begin(polygon), std::end(polygon)));
    }
  }

  template <class Visitor>
  void for_each_halfedge(Visitor) const {} // a soup has none to name

  static constexpr bool has_maps_that_need_halfedges() { return false; }

  // A soup has no property maps.
  template <class Images, class Mesh, class Owner>
  void copy_maps(const Images&, const Mesh&, Owner&) const
  {}

private:
  const PointRange& m_points;
  const PolygonRange& m_polygons;
};

// A model of FaceListGraph with a point map and a contiguous vertex index map.
template <class FaceGraph, class PointMap, class VertexIndexMap>
class Graph_input
{
public:
  Graph_input(const FaceGraph& g, const PointMap& point, const VertexIndexMap& index)
    : m_graph(g), m_point(point), m_index(index)
  {}

  template <class Visitor>
  void for_each_point(Visitor visit) const
  {
    for (const auto v : vertices(m_graph))
      visit(index(v), get(m_point, v));
  }

  template <class Visitor>
  void for_each_vertex(Visitor visit) const
  {
    for (const auto v : vertices(m_graph))
      visit(v, index(v));
  }

  template <class Visitor>
  void for_each_halfedge(Visitor visit) const
  {
    for_each_side(m_graph, [&](std::size_t side, const auto& h) {
      visit(h, side, false);
      const auto o = opposite(h, m_graph);
      if (is_border(o, m_graph))
        visit(o, side, true);
    });
  }

  template <class Visitor>
  void for_each_face(Visitor visit) const
  {
    std::size_t side = 0;
    for (const auto f : faces(m_graph)) {
      visit(f, side);
      side += degree(f, m_graph);
    }
  }

  bool has_maps_that_need_halfedges() const { return maps_need_halfedges(m_graph); }

  // Copies the graph's simple property maps to those that `owner` adds to the mesh.
  template <class Images, class Mesh, class Owner>
  void copy_maps(const Images& images, const Mesh& mesh, Owner& owner) const
  {
    if constexpr (has_property_maps<FaceGraph>) {
      using Vertex = typename Mesh::Vertex_index;
      using Halfedge = typename Mesh::Halfedge_index;
      copy_simple_maps<typename FaceGraph::Vertex_index, Vertex>(m_graph, owner, [&](const auto& visit) {
        for_each_vertex([&](const auto& v, std::size_t i) { visit(v, Vertex(images.vertices[i])); });
      });
      if (!has_maps_that_need_halfedges())
        return;
      const auto for_each_halfedge_pair = [&](const auto& visit) {
        for_each_halfedge([&](const auto& h, std::size_t i, bool is_other_side) {
          const Halfedge image(images.halfedges[i]);
          visit(h, is_other_side ? mesh.opposite(image) : image);
        });
      };
      copy_simple_maps<typename FaceGraph::Halfedge_index, Halfedge>(m_graph, owner, for_each_halfedge_pair);
      const auto for_each_edge_pair = [&](const auto& visit) {
        for_each_halfedge_pair([&](const auto& h, Halfedge image) { visit(m_graph.edge(h), mesh.edge(image)); });
      };
      copy_simple_maps<typename FaceGraph::Edge_index, typename Mesh::Edge_index>(m_graph, owner, for_each_edge_pair);
      const auto for_each_face_pair = [&](const auto& visit) {
        for_each_face([&](const auto& f, std::size_t i) { visit(f, mesh.face(Halfedge(images.halfedges[i]))); });
      };
      copy_simple_maps<typename FaceGraph::Face_index, typename Mesh::Face_index>(m_graph, owner, for_each_face_pair);
    }
  }

private:
  template <class Vertex>
  std::size_t index(Vertex v) const { return static_cast<std::size_t>(get(m_index, v)); }

  const FaceGraph& m_graph;
  PointMap m_point;
  VertexIndexMap m_index;
};

template <class NamedParameters>
bool wants_input_index_maps(const NamedParameters& np)
{
  return parameters::choose_parameter(parameters::get_parameter(np, internal_np::input_index_maps), false);
}

// Whether the caller wants to know what became of halfedges or faces.
template <class NamedParameters>
bool wants_halfedges(const NamedParameters& np)
{
  return wants_input_index_maps(np)
      || decltype(correspondence(np, internal_np::halfedge_to_halfedge_output_iterator,
                                 internal_np::halfedge_to_halfedge_map))::is_wanted
      || decltype(correspondence(np, internal_np::face_to_face_output_iterator,
                                 internal_np::face_to_face_map))::is_wanted;
}

// Adds the property maps that tell the indices of vertices and faces in the input.
template <class Mesh, class Input, class Images, class Owner, class FaceOfSide>
void add_input_index_maps(const Input& input, const Images& images, Owner& owner, FaceOfSide face_of_side)
{
  using size_type = typename Mesh::size_type;
  using Vertex_index = typename Mesh::Vertex_index;
  auto vertex_number = owner.template add_property_map<Vertex_index, size_type>("v:input_index").first;
  for (std::size_t i = 0; i < images.vertices.size(); ++i)
    vertex_number[Vertex_index(images.vertices[i])] = static_cast<size_type>(i);
  auto face_number = owner.template add_property_map<typename Mesh::Face_index, size_type>("f:input_index").first;
  size_type k = 0;
  input.for_each_face([&](const auto&, std::size_t side) { face_number[face_of_side(side)] = k++; });
}

// Copies property maps, and tells what became of the elements of the input, of which `images` knows what is asked for.
template <class Input, class Images, class Mesh, class Owner, class NamedParameters>
void report_input(const Input& input, const Images& images, const Mesh& mesh, Owner& owner, const NamedParameters& np)
{
  const auto halfedge_of_side = [&](std::size_t i) { return typename Mesh::Halfedge_index(images.halfedges[i]); };
  const auto face_of_side = [&](std::size_t i) { return mesh.face(halfedge_of_side(i)); };

  input.copy_maps(images, mesh, owner);
  if (wants_input_index_maps(np))
    add_input_index_maps<Mesh>(input, images, owner, face_of_side);

  auto vertex_report = correspondence(np, internal_np::vertex_to_vertex_output_iterator,
                                      internal_np::vertex_to_vertex_map);
  if constexpr (decltype(vertex_report)::is_wanted)
    input.for_each_vertex([&](const auto& v, std::size_t i) {
      vertex_report(v, typename Mesh::Vertex_index(images.vertices[i]));
    });

  auto halfedge_report = correspondence(np, internal_np::halfedge_to_halfedge_output_iterator,
                                        internal_np::halfedge_to_halfedge_map);
  if constexpr (decltype(halfedge_report)::is_wanted)
    input.for_each_halfedge([&](const auto& h, std::size_t i, bool is_other_side) {
      halfedge_report(h, is_other_side ? mesh.opposite(halfedge_of_side(i)) : halfedge_of_side(i));
    });

  auto face_report = correspondence(np, internal_np::face_to_face_output_iterator,
                                    internal_np::face_to_face_map);
  if constexpr (decltype(face_report)::is_wanted)
    input.for_each_face([&](const auto& f, std::size_t side) { face_report(f, face_of_side(side)); });
}

} // namespace internal

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_INTERNAL_INPUT_REPORT_H
