// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef BENCHMARK_COMPACT_SURFACE_MESH_HALF_EDGE_ARRAYS_H
#define BENCHMARK_COMPACT_SURFACE_MESH_HALF_EDGE_ARRAYS_H

#include <CGAL/Compact_surface_mesh/Corner_table.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

/// The half-edge data structure of a closed triangle mesh as the papers count it (CD18, 1.2): each of the 6n
/// halfedges stores the next one, the opposite one and a vertex, and each vertex a halfedge, 19n references
/// in all. Faces are not stored. Halfedges have the numbers of the corner table.
class Half_edge_arrays
{
public:
  using Index = std::uint32_t;

  static std::string name() { return "half-edge"; }

  Half_edge_arrays() = default;

  /// \throws std::invalid_argument if `table` has a border
  explicit Half_edge_arrays(const CGAL::Corner_table<Index>& table)
    : m_halfedges(table.num_halfedges()), m_halfedge(table.num_vertices(), table.null())
  {
    for (Index h = 0; h < m_halfedges.size(); ++h) {
      if (table.opposite(h) == table.null())
        throw std::invalid_argument("the half-edge structure of the papers has no borders");
      m_halfedges[h] = { table.next(h), table.opposite(h), table.target(h) };
      m_halfedge[table.target(h)] = h;
    }
  }

  std::size_t num_vertices() const { return m_halfedge.size(); }
  std::size_t num_halfedges() const { return m_halfedges.size(); }
  std::size_t num_references() const { return 3 * m_halfedges.size() + m_halfedge.size(); }

  /// \name Operators
  /// in constant time.
  /// @{

  Index next(Index h) const { return m_halfedges[h].next; }
  Index prev(Index h) const { return next(next(h)); } // in a triangle
  Index opposite(Index h) const { return m_halfedges[h].opposite; }
  Index source(Index h) const { return target(opposite(h)); }
  Index target(Index h) const { return m_halfedges[h].target; }
  /// a halfedge with target `v`.
  Index halfedge_of_vertex(Index v) const { return m_halfedge[v]; }
  /// @}

private:
  struct Halfedge
  {
    Index next, opposite, target;
  };

  std::vector<Halfedge> m_halfedges;
  std::vector<Index> m_halfedge; // of each vertex
};

#endif // BENCHMARK_COMPACT_SURFACE_MESH_HALF_EDGE_ARRAYS_H
