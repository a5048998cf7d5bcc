// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_CUT_GRAPH_LOOPS_H
#define CGAL_SCHNYDER_WOODS_CUT_GRAPH_LOOPS_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Schnyder_woods/internal/Shortest_path_forest.h>
#include <CGAL/Schnyder_woods/internal/Surface_to_cut.h>
#include <CGAL/Schnyder_woods/internal/edge_weights.h>
#include <CGAL/Schnyder_woods/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {

namespace internal {

// The loops of a graph on a surface: one for each edge that is not in a spanning tree.
template <class FaceGraph>
class Loops_of_cut_graph
{
  typedef typename boost::graph_traits<FaceGraph>::halfedge_descriptor halfedge_descriptor;
  typedef std::uint32_t Index;

public:
  Loops_of_cut_graph(const Surface_to_cut<FaceGraph>& surface, const std::vector<char>& is_cut)
    : m_surface(surface), m_edges(surface.edges()), m_is_cut(is_cut), m_paths(surface.num_nodes(), m_edges, is_cut)
  {
    std::vector<Index> roots;
    for (std::size_t c = 0; c < surface.num_components(); ++c)
      roots.push_back(surface.component(c).is_punctured ? surface.component(c).first_node
                                                        : node_of_highest_degree(c));
    m_paths.grow(roots);
  }

  template <class OutputIterator>
  OutputIterator operator()(OutputIterator out) const
  {
    for (Index e = 0; e < m_edges.size(); ++e)
      if (m_is_cut[e] && !is_in_tree(e) && m_paths.rank(m_edges[e].nodes[0]) != Shortest_path_forest::none)
        *out++ = loop(e);
    return out;
  }

private:
  Index node_of_highest_degree(std::size_t c) const
  {
    const Index first = m_surface.component(c).first_node, last = m_surface.component(c + 1).first_node;
    std::vector<std::size_t> degree(last - first, 0);
    for (Index e = m_surface.component(c).first_edge; e < m_surface.component(c + 1).first_edge; ++e)
      if (m_is_cut[e])
        for (const Index v : m_edges[e].nodes)
          ++degree[v - first];
    return first + static_cast<Index>(std::max_element(degree.begin(), degree.end()) - degree.begin());
  }

  bool is_in_tree(Index e) const
  {
    const auto& [u, v] = m_edges[e].nodes;
    return m_paths.parent_edge(u) == e || m_paths.parent_edge(v) == e;
  }

  // The edge, and the paths from its ends to where they meet, or to the border.
  std::vector<halfedge_descriptor> loop(Index e) const
  {
    auto [u, v] = m_edges[e].nodes;
    std::vector<halfedge_descriptor> to_u(1, m_surface.halfedge_to(e, 1)), from_v;
    while (u != v)
      if (m_paths.rank(u) > m_paths.rank(v))
        u = climb(u, 1, to_u);
      else
        v = climb(v, 0, from_v);
    std::reverse(to_u.begin(), to_u.end());
    to_u.insert(to_u.end(), from_v.begin(), from_v.end());
    return to_u;
  }

  // Adds the last halfedge of the path to a node, as it is (down) or reversed, and returns
  // where the path comes from.
  Index climb(Index v, bool down, std::vector<halfedge_descriptor>& halfedges) const
  {
    const Index e = m_paths.parent_edge(v);
    const int end = m_edges[e].nodes[1] == v;
    halfedges.push_back(m_surface.halfedge_to(e, down ? end : 1 - end));
    return m_edges[e].nodes[1 - end];
  }

  const Surface_to_cut<FaceGraph>& m_surface;
  const std::vector<Edge_to_cut>& m_edges;
  const std::vector<char>& m_is_cut;
  Shortest_path_forest m_paths;
};

} // namespace internal

/*!
\ingroup PkgSchnyderWoodsRef

writes the loops of which a cut graph consists: for each edge off a spanning tree of shortest paths in
the graph, the edge and the paths from its ends to where they meet. Each loop is a
sequence of halfedges, each of which starts where the one before ends. It visits no vertex twice, and

- in a component without borders and constrained vertices it is closed; there are \f$2g\f$ loops for genus \f$g\f$,
  which generate the first homology group of the surface;
- otherwise it is closed, or a path from a border or constrained vertex to another or the same one; there
  are \f$2g + b - 1\f$ of them for \f$b\f$ borders and constrained vertices, which generate the first
  homology group relative to these.

Time O(n + s log s + l) for a mesh of n edges, a cut graph of s edges and loops of l halfedges.

\tparam FaceGraph a model of `FaceListGraph`, `EdgeListGraph` and `HalfedgeListGraph` with dynamic properties
\tparam EdgeIsCutMap a readable property map from edges to `bool`
\tparam OutputIterator an output iterator over `std::vector<halfedge_descriptor>`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param g a mesh
\param edge_is_cut a cut graph of it, such as `cut_graph()` or `cut_graph_of_schnyder_wood()` writes it
\param out gets the loops
\param np `edge_weight_map`, `vertex_point_map` and `vertex_is_constrained_map` as for `cut_graph()`

\returns `out` behind the last loop

\throws std::invalid_argument,Mesh_defect_exception as `cut_graph()`
*/
template <class FaceGraph, class EdgeIsCutMap, class OutputIterator,
          class NamedParameters = parameters::Default_named_parameters>
OutputIterator cut_graph_loops(const FaceGraph& g,
                               EdgeIsCutMap edge_is_cut,
                               OutputIterator out,
                               const NamedParameters& np = parameters::default_values())
{
  const auto surface = internal::surface_to_cut(g, np);
  std::vector<char> is_cut(surface.edges().size());
  for (std::uint32_t e = 0; e < is_cut.size(); ++e)
    is_cut[e] = get(edge_is_cut, surface.descriptor(e));
  return internal::Loops_of_cut_graph<FaceGraph>(surface, is_cut)(out);
}

} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_CUT_GRAPH_LOOPS_H
