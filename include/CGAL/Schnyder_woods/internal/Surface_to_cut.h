// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_INTERNAL_SURFACE_TO_CUT_H
#define CGAL_SCHNYDER_WOODS_INTERNAL_SURFACE_TO_CUT_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Mesh_defect_exception.h>
#include <CGAL/Dynamic_property_map.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace internal {

// An edge between two faces.
struct Edge_to_cut
{
  std::array<std::uint32_t, 2> nodes, faces;
  double weight;
};

// What is numbered from where on for a component; it ends where the next one begins.
struct Component_to_cut
{
  std::uint32_t first_node, first_edge, first_face;
  bool is_punctured; // whether the first node stands for anything
};

// What there is to be cut of a mesh, numbered. Of each component, all border vertices and
// all vertices at which the user lets a cut end are the first node, the puncture; all other
// vertices are one node each. Without its punctures, a component that is a sphere or an open
// disk has nothing to be cut and is left out.
//
// Why one node: faces that are glued along a spanning tree of the dual graph are an open disk, so that
// all other edges with the puncture are a cut graph; how the puncture hangs together does not matter.
//
// A vertex where several components meet belongs to the puncture of each.
template <class FaceGraph>
class Surface_to_cut
{
  typedef boost::graph_traits<FaceGraph> Traits;
  typedef typename Traits::vertex_descriptor vertex_descriptor;
  typedef typename Traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Traits::edge_descriptor edge_descriptor;
  typedef typename Traits::face_descriptor face_descriptor;

public:
  typedef std::uint32_t Index;

  // Throws std::invalid_argument if the weights are negative or have no finite sum.
  template <class VertexIsConstrainedMap, class WeightOfEdge>
  Surface_to_cut(const FaceGraph& g, VertexIsConstrainedMap is_constrained, const WeightOfEdge& weight)
    : g(g),
      m_is_puncture(get(dynamic_vertex_property_t<bool>(), g)),
      m_node(get(dynamic_vertex_property_t<Index>(), g)),
      m_face(get(dynamic_face_property_t<Index>(), g))
  {
    if (num_halfedges(g) >= none)
      throw Mesh_defect_exception(Mesh_defect::too_many_elements, num_halfedges(g));
    for (const vertex_descriptor v : vertices(g)) {
      put(m_is_puncture, v, get(is_constrained, v));
      put(m_node, v, Index(none));
    }
    for (const halfedge_descriptor h : halfedges(g))
      if (is_border(h, g))
        put(m_is_puncture, target(h, g), true);
    for (const face_descriptor f : faces(g))
      put(m_face, f, Index(none));
    for (const face_descriptor f : faces(g))
      if (get(m_face, f) == none)
        add_component(f);
    m_components.push_back({ m_num_nodes, Index(m_edges.size()), m_num_faces, false });
    weigh(weight);
  }

  std::size_t num_nodes() const { return m_num_nodes; }
  std::size_t num_faces() const { return m_num_faces; }
  const std::vector<Edge_to_cut>& edges() const { return m_edges; }

  std::size_t num_components() const { return m_components.size() - 1; }
  const Component_to_cut& component(std::size_t c) const { return m_components[c]; }

  // Whether a node is a puncture, for each node.
  std::vector<char> punctures() const
  {
    std::vector<char> result(m_num_nodes, false);
    for (std::size_t c = 0; c < num_components(); ++c)
      result[component(c).first_node] = component(c).is_punctured;
    return result;
  }

  // The halfedge of an edge that ends in the second of its nodes, and that which ends in the first.
  halfedge_descriptor halfedge_to(Index e, int end) const
  {
    return end == 1 ? m_halfedges[e] : opposite(m_halfedges[e], g);
  }

  edge_descriptor descriptor(Index e) const { return edge(m_halfedges[e], g); }

private:
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  void add_component(face_descriptor seed)
  {
    Component_to_cut c{ m_num_nodes++, Index(m_edges.size()), m_num_faces, false };
    std::vector<face_descriptor> found(1, seed);
    put(m_face, seed, m_num_faces++);
    for (std::size_t i = 0; i < found.size(); ++i) {
      const face_descriptor f = found[i];
      for (const halfedge_descriptor h : halfedges_around_face(halfedge(f, g), g)) {
        const face_descriptor neighbor = face(opposite(h, g), g);
        if (neighbor == Traits::null_face()) {
          c.is_punctured = true;
          continue;
        }
        if (get(m_face, neighbor) == none) {
          put(m_face, neighbor, m_num_faces++);
          found.push_back(neighbor);
        }
        const Index left = get(m_face, f), right = get(m_face, neighbor);
        if (left < right || (left == right && h < opposite(h, g))) {
          m_edges.push_back({ { node(source(h, g), c), node(target(h, g), c) },
                              { left, right },
                              0 });
          m_halfedges.push_back(h);
        }
      }
    }
    if (has_nothing_to_cut(c)) {
      m_num_nodes = c.first_node;
      m_num_faces = c.first_face;
      m_edges.resize(c.first_edge);
      m_halfedges.resize(c.first_edge);
    } else
      m_components.push_back(c);
  }

  Index node(vertex_descriptor v, Component_to_cut& c)
  {
    if (get(m_is_puncture, v)) {
      c.is_punctured = true;
      return c.first_node;
    }
    if (get(m_node, v) == none)
      put(m_node, v, m_num_nodes++);
    return get(m_node, v);
  }

  // Borders have as many vertices as edges: so Euler's number of the surface without them
  // and without points is 2 - 2 genus - borders - points.
  bool has_nothing_to_cut(const Component_to_cut& c) const
  {
    const std::ptrdiff_t v = m_num_nodes - c.first_node - 1, e = m_edges.size() - c.first_edge,
                         f = m_num_faces - c.first_face;
    return v - e + f >= 1;
  }

  template <class WeightOfEdge>
  void weigh(const WeightOfEdge& weight)
  {
    double sum = 0;
    for (std::size_t e = 0; e < m_edges.size(); ++e) {
      const double w = m_edges[e].weight = weight(edge(m_halfedges[e], g));
      if (w < 0)
        throw std::invalid_argument("the weight of an edge is negative");
      sum += w;
    }
    if (!std::isfinite(sum))
      throw std::invalid_argument("the weights of the edges have no finite sum");
  }

  const FaceGraph& g;
  typename boost::property_map<FaceGraph, dynamic_vertex_property_t<bool>>::const_type m_is_puncture;
  typename boost::property_map<FaceGraph, dynamic_vertex_property_t<Index>>::const_type m_node;
  typename boost::property_map<FaceGraph, dynamic_face_property_t<Index>>::const_type m_face;
  Index m_num_nodes = 0, m_num_faces = 0;
  std::vector<Edge_to_cut> m_edges;
  std::vector<halfedge_descriptor> m_halfedges;
  std::vector<Component_to_cut> m_components;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_INTERNAL_SURFACE_TO_CUT_H
