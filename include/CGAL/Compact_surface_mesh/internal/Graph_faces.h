// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_INTERNAL_GRAPH_FACES_H
#define CGAL_COMPACT_SURFACE_MESH_INTERNAL_GRAPH_FACES_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Mesh_defect_exception.h>
#include <CGAL/Compact_surface_mesh/internal/Halfedge_matching.h>
#include <CGAL/Compact_surface_mesh/internal/Polygon_list.h>
#include <CGAL/Compact_surface_mesh/internal/for_each_side.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {

template <class Index>
class Corner_table;

namespace internal {

// The faces of a graph and their halfedges, as Polygon_list numbers them: face by face in the
// order of faces(g), and in each face f from halfedge(f, g) on.
template <class FaceGraph, class VertexIndexMap>
class Graph_faces
{
  using halfedge_descriptor = typename boost::graph_traits<FaceGraph>::halfedge_descriptor;

public:
  Graph_faces(const FaceGraph& g, const VertexIndexMap& vertex_index)
    : m_graph(g), m_vertex_index(vertex_index)
  {}

  // Must come before pairing.
  template <class Index>
  Polygon_list<Index> read(bool triangles_only)
  {
    const auto vertex_range = vertices(m_graph);
    const auto face_range = faces(m_graph);
    const std::size_t n = static_cast<std::size_t>(std::distance(vertex_range.begin(), vertex_range.end()));
    Polygon_list<Index> list(n, static_cast<std::size_t>(std::distance(face_range.begin(), face_range.end())));
    std::size_t num_borders = 0;
    for (const auto f : face_range) {
      const halfedge_descriptor first = halfedge(f, m_graph);
      const halfedge_descriptor second = next(first, m_graph), third = next(second, m_graph);
      if (second != first && next(third, m_graph) == first) {
        list.append_triangle(source_index(first), source_index(second), source_index(third));
        for (const halfedge_descriptor h : { first, second, third })
          num_borders += has_face_opposite(h) ? 0 : 1;
      } else if (triangles_only)
        throw Mesh_defect_exception(Mesh_defect::not_a_triangle, list.num_faces());
      else
        num_borders += append_polygon(first, list);
    }
    m_num_borders = num_borders;
    return list;
  }

  // Pairs halfedges by their ends, which is faster than by asking the graph, and returns whether
  // that is how the graph pairs them. It is not so if several edges have the same ends: either
  // two halfedges have the same direction, or two from a border are taken for one edge.
  template <class Index, class Faces>
  bool pair_by_ends(Halfedge_matching<Index, Faces>& matching, const Faces& faces) const
  {
    if (!matching.pair_by_ends())
      return false;
    std::size_t num_borders = 0;
    for (std::size_t h = 0; h < faces.num_halfedges(); ++h)
      num_borders += faces.opposite(static_cast<Index>(h)) == matching.null() ? 1 : 0;
    return num_borders == m_num_borders;
  }

  // Pairs halfedges as the graph does.
  template <class Index>
  void pair(Polygon_list<Index>& list) const
  {
    auto number = get(dynamic_halfedge_property_t<Index>(), m_graph);
    for_each_side(m_graph, [&](std::size_t i, halfedge_descriptor h) { put(number, h, static_cast<Index>(i)); });
    for_each_side(m_graph, [&](std::size_t i, halfedge_descriptor h) {
      list.set_opposite(static_cast<Index>(i), has_face_opposite(h) ? get(number, opposite_of(h)) : list.null());
    });
  }

  // The triangle of a halfedge that has an opposite one by its ends, but none in the graph.
  template <class Index>
  std::size_t triangle_at_false_pair(const Corner_table<Index>& table) const
  {
    std::size_t found = table.num_halfedges();
    for_each_side(m_graph, [&](std::size_t i, halfedge_descriptor h) {
      if (table.opposite(static_cast<Index>(i)) != table.null() && !has_face_opposite(h))
        found = (std::min)(found, i);
    });
    return found / 3;
  }

private:
  // Adds the face of `first`, and counts its halfedges that have no face on the other side.
  template <class Index>
  std::size_t append_polygon(halfedge_descriptor first, Polygon_list<Index>& list)
  {
    std::size_t num_borders = 0;
    m_polygon.clear();
    halfedge_descriptor h = first;
    do {
      m_polygon.push_back(source_index(h));
      num_borders += has_face_opposite(h) ? 0 : 1;
      h = next(h, m_graph);
    } while (h != first && m_polygon.size() <= list.num_vertices()); // then some vertex is there twice
    list.append_polygon(m_polygon);
    return num_borders;
  }

  std::size_t source_index(halfedge_descriptor h) const
  {
    return static_cast<std::size_t>(get(m_vertex_index, source(h, m_graph)));
  }
  bool has_face_opposite(halfedge_descriptor h) const { return !is_border(opposite_of(h), m_graph); }
  halfedge_descriptor opposite_of(halfedge_descriptor h) const { return opposite(h, m_graph); }

  const FaceGraph& m_graph;
  VertexIndexMap m_vertex_index;
  std::vector<std::size_t> m_polygon;
  std::size_t m_num_borders = 0; // halfedges of faces that have no face on the other side
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_INTERNAL_GRAPH_FACES_H
