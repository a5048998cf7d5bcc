// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_IS_SCHNYDER_WOOD_H
#define CGAL_SCHNYDER_WOODS_IS_SCHNYDER_WOOD_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {

namespace internal {

// Checks one rule after the other of a wood on a triangulated sphere.
template <class FaceGraph, class HalfedgeColorMap, class HalfedgeOutgoingMap>
class Schnyder_wood_checker
{
  typedef boost::graph_traits<FaceGraph> Traits;
  typedef typename Traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Traits::vertex_descriptor vertex_descriptor;

public:
  Schnyder_wood_checker(const FaceGraph& g, halfedge_descriptor root, HalfedgeColorMap color,
                        HalfedgeOutgoingMap outgoing)
    : g(g), m_root{ target(root, g), source(root, g), target(next(root, g), g) }, m_color(color), m_outgoing(outgoing)
  {}

  bool operator()() const
  {
    for (const auto h : halfedges(g))
      if (!is_root_edge(h) && !edge_is_consistent(h))
        return false;
    for (const auto v : vertices(g)) {
      const std::size_t i = root_index(v);
      if (i < 3 ? !root_rule(v, static_cast<int>(i)) : !local_rule(v))
        return false;
    }
    for (int c = 0; c < 3; ++c)
      if (!is_tree(c))
        return false;
    return true;
  }

private:
  std::size_t root_index(vertex_descriptor v) const
  {
    std::size_t i = 0;
    while (i < 3 && m_root[i] != v)
      ++i;
    return i;
  }

  // In a simple triangulation with an inner vertex, an edge between two vertices of the
  // root face is one of its three edges.
  bool is_root_edge(halfedge_descriptor h) const
  {
    return root_index(source(h, g)) < 3 && root_index(target(h, g)) < 3;
  }

  bool is_out(halfedge_descriptor h) const { return get(m_outgoing, h); }

  bool edge_is_consistent(halfedge_descriptor h) const
  {
    const halfedge_descriptor o = opposite(h, g);
    const int c = get(m_color, h);
    return 0 <= c && c < 3 && c == get(m_color, o) && is_out(h) != is_out(o);
  }

  halfedge_descriptor next_around_source(halfedge_descriptor h) const { return opposite(prev(h, g), g); }

  // All edges of V_i come in with color i.
  bool root_rule(vertex_descriptor v, int i) const
  {
    const halfedge_descriptor first = opposite(halfedge(v, g), g);
    halfedge_descriptor h = first;
    do {
      if (!is_root_edge(h) && (is_out(h) || get(m_color, h) != i))
        return false;
      h = next_around_source(h);
    } while (h != first);
    return true;
  }

  // From the edge out of color 0 on: each edge out has the next color, and what comes in
  // between the edges out of colors c and c + 1 has color c + 2.
  bool local_rule(vertex_descriptor v) const
  {
    halfedge_descriptor h = opposite(halfedge(v, g), g);
    const halfedge_descriptor any = h;
    while (!(is_out(h) && get(m_color, h) == 0)) {
      h = next_around_source(h);
      if (h == any)
        return false;
    }
    const halfedge_descriptor first = h;
    int num_out = 0;
    do {
      const int c = get(m_color, h);
      if (is_out(h) ? c != num_out++ : c != (num_out + 1) % 3)
        return false;
      h = next_around_source(h);
    } while (h != first);
    return num_out == 3;
  }

  // From every vertex off the root face, the edges of color c lead to V_c.
  bool is_tree(int c) const
  {
    enum State { unknown, on_path, reaches_root };
    const auto state = get(dynamic_vertex_property_t<int>(), g);
    const auto parent = get(dynamic_vertex_property_t<vertex_descriptor>(), g);
    for (const auto v : vertices(g))
      put(state, v, v == m_root[c] ? reaches_root : unknown);
    for (const auto h : halfedges(g))
      if (!is_root_edge(h) && is_out(h) && get(m_color, h) == c)
        put(parent, source(h, g), target(h, g));
    std::vector<vertex_descriptor> path;
    for (auto v : vertices(g)) {
      if (root_index(v) < 3)
        continue;
      for (path.clear(); get(state, v) == unknown && root_index(v) == 3; v = get(parent, v)) {
        put(state, v, on_path);
        path.push_back(v);
      }
      if (get(state, v) != reaches_root)
        return false;
      for (const auto u : path)
        put(state, u, reaches_root);
    }
    return true;
  }

  const FaceGraph& g;
  const std::array<vertex_descriptor, 3> m_root;
  const HalfedgeColorMap m_color;
  const HalfedgeOutgoingMap m_outgoing;
};

} // namespace internal

/*!
\ingroup PkgSchnyderWoodsRef

returns whether `color` and `outgoing` are a Schnyder wood of `g`, as `schnyder_wood()` writes one:
whether the two halfedges of each edge agree, the rules around all vertices hold, and
the edges of each color form a tree that spans the vertices off the root face. Values at the
edges of the root face are ignored.

Time linear in the size of the mesh.

\tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam HalfedgeColorMap a readable property map from halfedges to `int`
\tparam HalfedgeOutgoingMap a readable property map from halfedges to `bool`

\pre `g` is a simple triangulation of the sphere, and `root` a halfedge of it, from \f$V_1\f$ to \f$V_0\f$.
*/
template <class FaceGraph, class HalfedgeColorMap, class HalfedgeOutgoingMap>
bool is_schnyder_wood(const FaceGraph& g,
                      typename boost::graph_traits<FaceGraph>::halfedge_descriptor root,
                      HalfedgeColorMap color,
                      HalfedgeOutgoingMap outgoing)
{
  return internal::Schnyder_wood_checker<FaceGraph, HalfedgeColorMap, HalfedgeOutgoingMap>(g, root, color, outgoing)();
}

} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_IS_SCHNYDER_WOOD_H
