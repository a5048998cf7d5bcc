// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_CUT_GRAPH_ORACLE_H
#define TEST_COMPACT_SURFACE_MESH_CUT_GRAPH_ORACLE_H

// What is true of a cut graph and its loops, by the definitions and by other functions of CGAL.

#include "closed_surfaces.h"
#include "damaged_soups.h"

#include <CGAL/Schnyder_woods/cut_graph.h>
#include <CGAL/Schnyder_woods/cut_graph_loops.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/property_map.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace test {

typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Surface_mesh;
typedef Surface_mesh::Vertex_index Vertex;
typedef Surface_mesh::Halfedge_index Halfedge;
typedef Surface_mesh::Edge_index Edge;
typedef Surface_mesh::Face_index Face;

/// A mesh with vertices at random places, so that edges have random lengths.
inline Surface_mesh mesh_of(const Polygon_soup& soup, unsigned int seed = 1)
{
  std::mt19937 rng(seed);
  std::uniform_real_distribution<double> coordinate(0, 1);
  Surface_mesh mesh;
  for (std::size_t i = 0; i < soup.num_vertices; ++i)
    mesh.add_vertex(Point(coordinate(rng), coordinate(rng), coordinate(rng)));
  std::vector<std::vector<Vertex>> faces;
  for (const auto& face : soup.faces)
    faces.emplace_back(face.begin(), face.end());
  CGAL::Euler::add_faces(faces, mesh);
  return mesh;
}

inline Surface_mesh mesh_of(const Soup& soup, unsigned int seed = 1) { return mesh_of(soup_of(soup), seed); }

/// The length of an edge.
template <class Mesh>
double length_of(typename boost::graph_traits<Mesh>::edge_descriptor e, const Mesh& mesh)
{
  const auto point = get(CGAL::vertex_point, mesh);
  return std::sqrt(CGAL::squared_distance(get(point, source(e, mesh)), get(point, target(e, mesh))));
}

/// What is left of a mesh that is cut, component by component. A component is what edges join.
///
/// Off borders, cut edges and constrained vertices, it is an open surface: a disk, if it is
/// connected and its Euler number is 1, and an uncut sphere if it is 2.
class Complement
{
public:
  template <class EdgeIsCutMap, class VertexIsConstrainedMap>
  Complement(const Surface_mesh& mesh, const EdgeIsCutMap& is_cut, const VertexIsConstrainedMap& is_constrained)
    : mesh(mesh), m_is_cut(mesh.number_of_edges()), m_is_end(mesh.number_of_vertices()),
      m_degree(mesh.number_of_vertices(), 0)
  {
    for (const Vertex v : mesh.vertices())
      m_is_end[v] = get(is_constrained, v);
    for (const Halfedge h : mesh.halfedges())
      if (mesh.is_border(h))
        m_is_end[mesh.target(h)] = true;
    for (const Edge e : mesh.edges())
      if ((m_is_cut[e] = get(is_cut, e)))
        for (const int end : { 0, 1 })
          ++m_degree[mesh.vertex(e, end)];
  }

  /// What is wrong, or nothing.
  std::string defect() const
  {
    for (const Edge e : mesh.edges())
      if (m_is_cut[e] && mesh.is_border(e))
        return "a border edge is cut";
    for (const Vertex v : mesh.vertices())
      if (m_degree[v] == 1 && !m_is_end[v])
        return "the graph dangles";
    const std::vector<std::size_t> component = components(false), piece = components(true);
    if (std::set<std::size_t>(component.begin(), component.end()).size()
        != std::set<std::size_t>(piece.begin(), piece.end()).size())
      return "a component falls into pieces";
    const std::vector<int> euler = euler_numbers(component);
    for (const std::size_t c : component)
      if (euler[c] != 1 && euler[c] != 2)
        return "Euler number " + std::to_string(euler[c]);
    return "";
  }

  /// For a mesh without cuts, how many loops a cut graph has: in each component 2 genus, and one
  /// less than there are borders and constrained vertices.
  std::size_t num_loops_to_cut() const
  {
    const std::vector<std::size_t> component = components(false);
    const std::vector<int> euler = euler_numbers(component);
    std::vector<int> loops(mesh.number_of_faces(), 0);
    for (const Face f : mesh.faces())
      loops[component[f]] = 2 - euler[component[f]];
    std::vector<bool> is_punctured(mesh.number_of_faces(), false);
    for (const Halfedge h : mesh.halfedges())
      if (!mesh.is_border(h) && m_is_end[mesh.target(h)])
        is_punctured[component[mesh.face(h)]] = true;
    return std::accumulate(loops.begin(), loops.end(), 0)
           - std::count(is_punctured.begin(), is_punctured.end(), true);
  }

private:
  // For each face the number of its component, when the mesh is cut or not.
  std::vector<std::size_t> components(bool when_cut) const
  {
    std::vector<std::size_t> number(mesh.number_of_faces());
    const auto number_of_face = boost::make_function_property_map<Face, std::size_t&>(
        [&](Face f) -> std::size_t& { return number[f]; });
    const auto is_seam = boost::make_function_property_map<Edge>([=](Edge e) { return when_cut && m_is_cut[e]; });
    CGAL::Polygon_mesh_processing::connected_components(mesh, number_of_face,
                                                        CGAL::parameters::edge_is_constrained_map(is_seam));
    return number;
  }

  std::vector<int> euler_numbers(const std::vector<std::size_t>& component) const
  {
    std::vector<int> euler(mesh.number_of_faces(), 0);
    for (const Face f : mesh.faces())
      ++euler[component[f]];
    for (const Edge e : mesh.edges())
      if (!mesh.is_border(e) && !m_is_cut[e])
        --euler[component[mesh.face(mesh.halfedge(e))]];
    for (const Vertex v : mesh.vertices())
      if (!mesh.is_isolated(v) && !m_is_end[v] && m_degree[v] == 0)
        ++euler[component[mesh.face(mesh.halfedge(v))]];
    return euler;
  }

  const Surface_mesh& mesh;
  std::vector<bool> m_is_cut, m_is_end;
  std::vector<int> m_degree;
};

/// A mesh with a cut graph and its loops.
struct Cut
{
  explicit Cut(Surface_mesh& mesh)
    : mesh(mesh), is_cut(mesh.add_property_map<Edge, bool>("e:is_cut").first),
      is_constrained(mesh.add_property_map<Vertex, bool>("v:is_constrained").first)
  {}

  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  double compute(const NamedParameters& np = CGAL::parameters::default_values())
  {
    const double weight = CGAL::cut_graph(mesh, is_cut, np);
    loops.clear();
    CGAL::cut_graph_loops(mesh, is_cut, std::back_inserter(loops), np);
    return weight;
  }

  std::size_t size() const { return std::count(is_cut.begin(), is_cut.end(), true); }

  double length() const
  {
    double sum = 0;
    for (const Edge e : mesh.edges())
      if (is_cut[e])
        sum += length_of(e, mesh);
    return sum;
  }

  std::string defect() const { return Complement(mesh, is_cut, is_constrained).defect(); }

  /// What is wrong with the loops, or nothing.
  std::string defect_of_loops() const
  {
    std::vector<bool> is_end(mesh.number_of_vertices());
    for (const Halfedge h : mesh.halfedges())
      if (mesh.is_border(h) || is_constrained[mesh.target(h)])
        is_end[mesh.target(h)] = true;
    std::map<Edge, int> num_loops_along;
    for (const auto& loop : loops) {
      std::set<Vertex> sources;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        if (!is_cut[mesh.edge(loop[i])])
          return "a loop leaves the graph";
        if (i > 0 && mesh.target(loop[i - 1]) != mesh.source(loop[i]))
          return "a loop jumps";
        if (!sources.insert(mesh.source(loop[i])).second)
          return "a loop visits a vertex twice";
        ++num_loops_along[mesh.edge(loop[i])];
      }
      const Vertex first = mesh.source(loop.front()), last = mesh.target(loop.back());
      if (first != last && !(is_end[first] && is_end[last]))
        return "a loop is open";
    }
    for (const auto& loop : loops)
      if (std::none_of(loop.begin(), loop.end(), [&](Halfedge h) { return num_loops_along[mesh.edge(h)] == 1; }))
        return "a loop has no edge of its own";
    const CGAL::Static_boolean_property_map<Edge, false> nothing_is_cut;
    if (loops.size() != Complement(mesh, nothing_is_cut, is_constrained).num_loops_to_cut())
      return "number of loops";
    return "";
  }

  Surface_mesh& mesh;
  Surface_mesh::Property_map<Edge, bool> is_cut;
  Surface_mesh::Property_map<Vertex, bool> is_constrained;
  std::vector<std::vector<Halfedge>> loops;
};


} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_CUT_GRAPH_ORACLE_H
