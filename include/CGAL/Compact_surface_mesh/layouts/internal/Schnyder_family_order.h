// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_FAMILY_ORDER_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_FAMILY_ORDER_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Schnyder_woods/internal/Schnyder_wood.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace internal {

/*
Numbers the vertices of a closed triangulation with a Schnyder wood such that red siblings have consecutive
numbers, counterclockwise; depth first. The families of apices come last but for isolated vertices. The red edges may
form cycles, as those of extremal woods do on surfaces with handles.
*/
template <class Index>
class Schnyder_family_order
{
  typedef Corner_table<Index> Table;

public:
  // `red_edge` is as from red_edges_out().
  Schnyder_family_order(const Closed_triangulation<Index>& t, const Schnyder_wood& wood,
                        const Large_array<Index>& red_edge)
    : m_triangulation(t), m_table(t.table()), m_wood(wood), m_red_edge(red_edge),
      m_number(red_edge.size(), Table::null()), m_has_even_depth(red_edge.size(), false),
      m_is_done(red_edge.size(), false)
  {
    number_ends();
    const auto unfinished = [this] {
      while (!m_stack.empty()) {
        const Index v = m_stack.back();
        m_stack.pop_back();
        number_children(v);
      }
    };
    unfinished();
    std::vector<bool> is_met(m_red_edge.size(), false);
    for (std::size_t v = 0; v < m_red_edge.size(); ++v)
      if (m_number[v] == Table::null()) {
        number_children(vertex_on_cycle(static_cast<Index>(v), is_met));
        unfinished();
      }
  }

  std::vector<Index> release_numbers() { return std::move(m_number); }

  // Whether the number of red edges from v to the end of its path is even: other than for the red parent of v, but
  // for the children of one vertex of each cycle.
  bool has_even_depth(Index v) const { return m_has_even_depth[v]; }

private:
  // Where the path of red edges from v, which has no end, closes. All vertices on it get numbers from there.
  Index vertex_on_cycle(Index v, std::vector<bool>& is_met) const
  {
    while (!is_met[v]) {
      is_met[v] = true;
      v = m_table.target(m_red_edge[v]);
    }
    return v;
  }

  void number_ends()
  {
    Index number = static_cast<Index>(m_red_edge.size());
    for (std::size_t v = m_red_edge.size(); v-- > 0;)
      if (m_red_edge[v] == Table::null())
        m_number[v] = --number;
    for (const auto& root : m_triangulation.roots()) {
      const std::vector<Index> family = m_triangulation.vertices_around(root);
      for (auto v = family.rbegin(); v != family.rend(); ++v)
        m_number[*v] = --number;
      m_stack.insert(m_stack.end(), family.rbegin(), family.rend());
    }
  }

  void number_children(Index v)
  {
    if (m_is_done[v])
      return;
    m_is_done[v] = true;
    const std::size_t pushed = m_stack.size();
    for (Index h = m_table.next_around_source(m_red_edge[v]); h != m_red_edge[v]; h = m_table.next_around_source(h))
      if (m_wood.is_in(h, red)) {
        const Index child = m_table.target(h);
        m_number[child] = m_next_number++;
        m_has_even_depth[child] = !m_has_even_depth[v];
        m_stack.push_back(child);
      }
    std::reverse(m_stack.begin() + static_cast<std::ptrdiff_t>(pushed), m_stack.end());
  }

  const Closed_triangulation<Index>& m_triangulation;
  const Table& m_table;
  const Schnyder_wood& m_wood;
  const Large_array<Index>& m_red_edge;
  std::vector<Index> m_number;
  std::vector<bool> m_has_even_depth, m_is_done;
  std::vector<Index> m_stack; // vertices whose children have no numbers yet
  Index m_next_number = 0;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_FAMILY_ORDER_H
