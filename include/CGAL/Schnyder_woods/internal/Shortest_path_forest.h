// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_INTERNAL_SHORTEST_PATH_FOREST_H
#define CGAL_SCHNYDER_WOODS_INTERNAL_SHORTEST_PATH_FOREST_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Schnyder_woods/internal/Surface_to_cut.h>

#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

// The shortest paths along some edges of a surface from each node to the nearest source.
class Shortest_path_forest
{
public:
  typedef std::uint32_t Index;

  static constexpr Index none = (std::numeric_limits<Index>::max)();

  // Of the edges, only those that are marked can be used.
  Shortest_path_forest(std::size_t num_nodes,
                       const std::vector<Edge_to_cut>& edges,
                       const std::vector<char>& is_marked)
    : m_edges(edges), m_graph(graph(num_nodes, edges, is_marked)), m_parent_edge(num_nodes), m_distance(num_nodes),
      m_rank(num_nodes)
  {}

  // The sources must be different.
  void grow(const std::vector<Index>& sources)
  {
    m_parent_edge.assign(m_parent_edge.size(), none);
    m_rank.assign(m_rank.size(), none);
    m_num_reached = 0;
    const auto index = get(boost::vertex_index, m_graph);
    const auto weight = boost::make_function_property_map<Arc>(
        [this](const Arc& a) { return m_edges[m_graph[a]].weight; });
    boost::dijkstra_shortest_paths(
        m_graph, sources.begin(), sources.end(), boost::dummy_property_map(),
        boost::make_iterator_property_map(m_distance.begin(), index), weight, index, std::less<double>(),
        std::plus<double>(), (std::numeric_limits<double>::infinity)(), 0., Visitor{ {}, this });
  }

  double distance(Index v) const { return m_distance[v]; }

  // The last edge of the path to a node; none at sources and nodes that cannot be reached.
  Index parent_edge(Index v) const { return m_parent_edge[v]; }

  // In which order nodes were reached: a path goes upwards. None if they cannot be reached.
  Index rank(Index v) const { return m_rank[v]; }

private:
  typedef boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, Index, boost::no_property, Index,
                                             Index>
      Graph;
  typedef boost::graph_traits<Graph>::edge_descriptor Arc;

  struct Visitor : boost::dijkstra_visitor<>
  {
    Visitor(boost::dijkstra_visitor<> base, Shortest_path_forest* forest)
      : boost::dijkstra_visitor<>(base), forest(forest)
    {}
    void edge_relaxed(const Arc& a, const Graph& graph) const
    {
      forest->m_parent_edge[target(a, graph)] = graph[a];
    }
    void examine_vertex(Index v, const Graph&) const { forest->m_rank[v] = forest->m_num_reached++; }

    Shortest_path_forest* forest;
  };

  static Graph graph(std::size_t num_nodes,
                     const std::vector<Edge_to_cut>& edges,
                     const std::vector<char>& is_marked)
  {
    std::vector<std::pair<Index, Index>> arcs;
    std::vector<Index> edge_of_arc;
    for (std::size_t e = 0; e < edges.size(); ++e)
      if (is_marked[e])
        for (const int end : { 0, 1 }) {
          arcs.emplace_back(edges[e].nodes[end], edges[e].nodes[1 - end]);
          edge_of_arc.push_back(static_cast<Index>(e));
        }
    return Graph(boost::edges_are_unsorted_multi_pass, arcs.begin(), arcs.end(), edge_of_arc.begin(),
                 static_cast<Index>(num_nodes));
  }

  const std::vector<Edge_to_cut>& m_edges;
  Graph m_graph;
  std::vector<Index> m_parent_edge;
  std::vector<double> m_distance;
  std::vector<Index> m_rank;
  Index m_num_reached = 0;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_INTERNAL_SHORTEST_PATH_FOREST_H
