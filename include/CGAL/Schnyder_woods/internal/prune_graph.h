// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_INTERNAL_PRUNE_GRAPH_H
#define CGAL_SCHNYDER_WOODS_INTERNAL_PRUNE_GRAPH_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace internal {

// Takes from a graph, as long as there is one, an edge with an end of degree 1 that is no
// terminal. Around a cut graph, the two sides of such an edge are the same face, so that the
// face stays a disk. Linear time.
//
// The ends of edge e are ends(e)[0] and ends(e)[1]; is_in[e] tells whether it is in the graph.
template <class Ends, class IsTerminal>
void prune_graph(std::size_t num_nodes, const Ends& ends, const IsTerminal& is_terminal, std::vector<char>& is_in)
{
  // where one edge is left at a node, the exclusive or of the edges there is that edge
  std::vector<std::size_t> degree(num_nodes, 0), edges_at(num_nodes, 0);
  const auto count = [&](std::size_t e, std::size_t one) {
    for (const std::size_t v : { std::size_t(ends(e)[0]), std::size_t(ends(e)[1]) }) {
      degree[v] += one;
      edges_at[v] ^= e;
    }
  };
  for (std::size_t e = 0; e < is_in.size(); ++e)
    if (is_in[e])
      count(e, 1);
  for (std::size_t leaf = 0; leaf < num_nodes; ++leaf)
    for (std::size_t v = leaf; degree[v] == 1 && !is_terminal(v);) {
      const std::size_t e = edges_at[v];
      is_in[e] = false;
      count(e, std::size_t(-1));
      v = ends(e)[0] == v ? ends(e)[1] : ends(e)[0];
    }
}

} // namespace internal
} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_INTERNAL_PRUNE_GRAPH_H
