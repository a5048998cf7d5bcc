// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef BENCHMARK_COMPACT_SURFACE_MESH_WINGED_EDGE_ARRAYS_H
#define BENCHMARK_COMPACT_SURFACE_MESH_WINGED_EDGE_ARRAYS_H

#include <CGAL/Compact_surface_mesh/Corner_table.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

/// Baumgart's winged-edge data structure of a closed triangle mesh as the papers count it (CD18, table 3): each of
/// the 3n edges stores its two ends and the four edges that follow and precede it in its two faces, and each
/// vertex an edge, 19n references in all. Faces are not stored.
///
/// A reference to a neighboring edge e says in its last bit s which side of e is meant: 2e + s serves as halfedge, from
/// end s to the other one. Where references have no bit to spare, as in Baumgart's structure, a side is found by
/// comparing ends; that takes three times as many instructions a step, which would flatter what is compared.
class Winged_edge_arrays
{
public:
  using Index = std::uint32_t;

  static std::string name() { return "winged-edge"; }

  Winged_edge_arrays() = default;

  /// \throws std::invalid_argument if `table` has a border
  explicit Winged_edge_arrays(const CGAL::Corner_table<Index>& table)
    : m_edges(table.num_halfedges() / 2), m_edge(table.num_vertices(), table.null())
  {
    std::vector<Index> edge(table.num_halfedges());
    Index num_edges = 0;
    for (Index h = 0; h < edge.size(); ++h) {
      if (table.opposite(h) == table.null())
        throw std::invalid_argument("the winged-edge structure of the papers has no borders");
      edge[h] = table.opposite(h) < h ? edge[table.opposite(h)] : num_edges++;
    }
    const auto side = [&](Index h) { return 2 * edge[h] + (table.opposite(h) < h ? 1 : 0); };
    for (Index h = 0; h < edge.size(); ++h) {
      const Index s = side(h) % 2;
      Edge& e = m_edges[edge[h]];
      e.end[s] = table.source(h);
      e.next[s] = side(table.next(h));
      e.prev[s] = side(table.prev(h));
      m_edge[table.target(h)] = side(h);
    }
  }

  std::size_t num_vertices() const { return m_edge.size(); }
  std::size_t num_halfedges() const { return 2 * m_edges.size(); }
  std::size_t num_references() const { return sizeof(Edge) / sizeof(Index) * m_edges.size() + m_edge.size(); }

  /// \name Operators
  /// in constant time.
  /// @{

  Index next(Index h) const { return m_edges[h / 2].next[h % 2]; }
  Index prev(Index h) const { return m_edges[h / 2].prev[h % 2]; }
  Index opposite(Index h) const { return h ^ 1; }
  Index source(Index h) const { return m_edges[h / 2].end[h % 2]; }
  Index target(Index h) const { return source(opposite(h)); }
  /// a halfedge with target `v`.
  Index halfedge_of_vertex(Index v) const { return m_edge[v]; }
  /// @}

private:
  struct Edge
  {
    std::array<Index, 2> end, next, prev; // where a side starts, and around the face to its left
  };

  std::vector<Edge> m_edges;
  std::vector<Index> m_edge; // of each vertex, one of its sides that ends there
};

#endif // BENCHMARK_COMPACT_SURFACE_MESH_WINGED_EDGE_ARRAYS_H
