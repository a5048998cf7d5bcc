// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_SCHNYDER_DRAWING_H
#define CGAL_SCHNYDER_WOODS_SCHNYDER_DRAWING_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/internal/numbered_vertices.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {

namespace internal {

// The three trees of a Schnyder wood on the indices of vertices, and sums along them.
class Schnyder_trees
{
public:
  explicit Schnyder_trees(std::size_t n) : m_parent(n, { none, none, none }) {}

  void set_parent(std::size_t v, int color, std::size_t p) { m_parent[v][color] = p; }

  // The number of vertices in the subtree of each vertex.
  std::vector<std::size_t> subtree_sizes(int color) const
  {
    std::vector<std::size_t> size(m_parent.size(), 1);
    const std::vector<std::size_t> order = parents_first(color);
    for (std::size_t i = order.size(); i-- > 0;)
      if (m_parent[order[i]][color] != none)
        size[m_parent[order[i]][color]] += size[order[i]];
    return size;
  }

  // The sum of `value` over the path from each vertex to the root.
  std::vector<std::size_t> path_sums(int color, std::vector<std::size_t> value) const
  {
    for (const std::size_t v : parents_first(color))
      if (m_parent[v][color] != none)
        value[v] += value[m_parent[v][color]];
    return value;
  }

private:
  static constexpr std::size_t none = std::size_t(-1);

  std::vector<std::size_t> parents_first(int color) const
  {
    std::vector<std::size_t> order, path;
    std::vector<bool> done(m_parent.size(), false);
    for (std::size_t v = 0; v < m_parent.size(); ++v) {
      for (std::size_t u = v; u != none && !done[u]; u = m_parent[u][color]) {
        done[u] = true;
        path.push_back(u);
      }
      order.insert(order.end(), path.rbegin(), path.rend());
      path.clear();
    }
    return order;
  }

  std::vector<std::array<std::size_t, 3>> m_parent;
};

} // namespace internal

/*!
\ingroup PkgSchnyderWoodsRef

computes Schnyder's straight-line drawing of a triangulated sphere from one of its Schnyder
woods. The three paths from a vertex \f$v\f$ to \f$V_0\f$, \f$V_1\f$, \f$V_2\f$ part the inner faces into three regions;
the coordinate \f$i\f$ of \f$v\f$ is the number of faces in the region off \f$V_i\f$'s path. So every vertex gets three
integers with the sum \f$2n-5\f$, barycentric coordinates with respect to the outer triangle, and
placing it at the first two of them draws the mesh on a grid of \f$(2n-5) \times (2n-5)\f$, all edges
straight and none crossing.

Linear time (W. Schnyder, <em>Embedding planar graphs on the grid</em>, SODA 1990).

\tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam HalfedgeColorMap a readable property map from halfedges to `int`
\tparam HalfedgeOutgoingMap a readable property map from halfedges to `bool`
\tparam VertexCoordinatesMap a writable property map from vertices to `std::array<std::size_t, 3>`

\param g a triangulated sphere
\param root a halfedge from \f$V_1\f$ to \f$V_0\f$ along the root face, which becomes the outer face
\param color,outgoing a Schnyder wood of `g`, as `schnyder_wood()` writes it
\param coordinates gets the coordinates

\pre `is_schnyder_wood(g, root, color, outgoing)`
*/
template <class FaceGraph, class HalfedgeColorMap, class HalfedgeOutgoingMap, class VertexCoordinatesMap>
void schnyder_drawing(const FaceGraph& g,
                      typename boost::graph_traits<FaceGraph>::halfedge_descriptor root,
                      HalfedgeColorMap color,
                      HalfedgeOutgoingMap outgoing,
                      VertexCoordinatesMap coordinates)
{
  const auto index = internal::numbered_vertices(g);
  const std::size_t n = vertices(g).size();

  const std::array<typename boost::graph_traits<FaceGraph>::vertex_descriptor, 3> roots = {
    target(root, g), source(root, g), target(next(root, g), g)
  };
  internal::Schnyder_trees trees(n);
  for (const auto h : halfedges(g))
    if (get(outgoing, h) && std::find(roots.begin(), roots.end(), source(h, g)) == roots.end())
      trees.set_parent(get(index, source(h, g)), get(color, h), get(index, target(h, g)));

  // A region is a disk. Its vertices hang, in the tree of its color, from the two paths
  // that bound it; Euler's formula gives its faces.
  std::vector<std::array<std::size_t, 3>> faces_in_region(n);
  const std::vector<std::size_t> ones(n, 1);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const auto size = trees.subtree_sizes(i);
    const auto sum_j = trees.path_sums(j, size), sum_k = trees.path_sums(k, size);
    const auto length_j = trees.path_sums(j, ones), length_k = trees.path_sums(k, ones);
    for (std::size_t v = 0; v < n; ++v) {
      const std::size_t vertices_in_region = sum_j[v] + sum_k[v] - size[v];
      const std::size_t boundary = length_j[v] + length_k[v] - 1;
      faces_in_region[v][i] = 2 * vertices_in_region - boundary - 2;
    }
  }
  for (int i = 0; i < 3; ++i) {
    faces_in_region[get(index, roots[i])] = { 0, 0, 0 };
    faces_in_region[get(index, roots[i])][i] = 2 * n - 5;
  }
  for (const auto v : vertices(g))
    put(coordinates, v, faces_in_region[get(index, v)]);
}

} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_SCHNYDER_DRAWING_H
