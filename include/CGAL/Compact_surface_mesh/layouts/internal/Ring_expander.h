// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_RING_EXPANDER_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_RING_EXPANDER_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Corner_table.h>

#include <cstddef>
#include <deque>
#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

/*
Finds nearly Hamiltonian cycles of a closed triangulation, one in each component: T. Gurung, M. Luffel,
P. Lindstrom, J. Rossignac, LR: Compact connectivity representation for triangle meshes, 2011, sections
4.2 (depth first) and 6.1 (hybrid). A region of triangles grows by a triangle at a time that has a new
vertex, so it is a disk without inner vertices; the ring is its border, with the region to its left. Vertices
from `first_excluded` on are taken for old ones: no ring passes them.
*/
template <class Index>
class Ring_expander
{
  typedef Corner_table<Index> Table;

public:
  // on a shorter ring, a triangle could have three edges
  enum : std::size_t { min_ring_size = 4 };

  Ring_expander(const Table& table, std::size_t first_excluded)
    : m_table(table), m_first_excluded(first_excluded)
  {
    find_components();
  }

  // The halfedges of the rings, one ring after the other, and where each ring begins.
  struct Result
  {
    std::vector<Index> halfedges, starts;
  };

  // Expands from a random seed in each component. Every `period` triangles, the traversal goes on at the
  // oldest triangle that is left; it is purely depth first if `period` is 0.
  Result expand(std::size_t period, unsigned int seed)
  {
    Result result;
    std::mt19937 random(seed);
    m_is_old.assign(m_table.num_vertices(), false);
    for (std::size_t v = m_first_excluded; v < m_is_old.size(); ++v)
      m_is_old[v] = true;
    m_is_inside.assign(m_table.num_faces(), false);
    result.halfedges.reserve(m_first_excluded);
    std::size_t begin = 0;
    for (const std::size_t end : m_end) {
      const Index c = 3 * m_faces[begin + random() % (end - begin)];
      begin = end;
      if (period == 0)
        expand_depth_first(c);
      else
        expand_hybrid(c, period);
      append_ring(Table::next(c), result);
    }
    return result;
  }

private:
  // Those faces of each component that have no excluded vertex, component by component.
  void find_components()
  {
    std::vector<bool> is_seen(m_table.num_faces(), false);
    std::vector<Index> stack;
    m_faces.reserve(m_table.num_faces());
    for (std::size_t first = 0; first < m_table.num_faces(); ++first) {
      if (is_seen[first])
        continue;
      is_seen[first] = true;
      stack.push_back(static_cast<Index>(first));
      while (!stack.empty()) {
        const Index f = stack.back(), h = 3 * f;
        stack.pop_back();
        if (!is_excluded(h) && !is_excluded(h + 1) && !is_excluded(h + 2))
          m_faces.push_back(f);
        for (Index g = h; g < h + 3; ++g) {
          const Index neighbor = Table::face(m_table.opposite(g));
          if (is_seen[neighbor])
            continue;
          is_seen[neighbor] = true;
          stack.push_back(neighbor);
        }
      }
      if (m_faces.size() > (m_end.empty() ? 0 : m_end.back()))
        m_end.push_back(m_faces.size());
    }
  }

  bool is_excluded(Index c) const { return m_table.vertex(c) >= m_first_excluded; }

  void begin_at(Index seed)
  {
    m_is_old[m_table.source(Table::next(seed))] = true;
    m_is_old[m_table.source(Table::prev(seed))] = true;
  }

  // Takes the triangle of c into the region, if its vertex is new.
  bool take(Index c)
  {
    if (m_is_old[m_table.vertex(c)])
      return false;
    m_is_old[m_table.vertex(c)] = true;
    m_is_inside[Table::face(c)] = true;
    return true;
  }

  // Slides along the border of the region: the marks tell the way back.
  void expand_depth_first(Index seed)
  {
    begin_at(seed);
    const Index end = m_table.opposite_corner(seed);
    Index c = seed;
    do {
      if (!take(c) && !m_is_inside[Table::face(c)])
        c = m_table.opposite_corner(c);
      c = m_table.right_corner(c);
    } while (c != end);
  }

  void expand_hybrid(Index seed, std::size_t period)
  {
    begin_at(seed);
    std::deque<Index> left_over(1, seed);
    std::size_t num_taken = 0;
    while (!left_over.empty()) {
      Index c;
      if (num_taken % period == 0) {
        c = left_over.front();
        left_over.pop_front();
      } else {
        c = left_over.back();
        left_over.pop_back();
      }
      if (!take(c))
        continue;
      ++num_taken;
      left_over.push_back(m_table.left_corner(c));
      left_over.push_back(m_table.right_corner(c));
    }
  }

  void append_ring(Index first, Result& result)
  {
    const std::size_t before = result.halfedges.size();
    Index h = first;
    do {
      result.halfedges.push_back(h);
      h = Table::next(h);
      for (Index o = m_table.opposite(h); m_is_inside[Table::face(o)]; o = m_table.opposite(h))
        h = Table::next(o);
    } while (h != first);
    if (result.halfedges.size() - before >= min_ring_size)
      result.starts.push_back(static_cast<Index>(before));
    else
      result.halfedges.resize(before);
  }

  const Table& m_table;
  const std::size_t m_first_excluded;
  std::vector<Index> m_faces;             // those without excluded vertices, by components
  std::vector<std::size_t> m_end;         // where each component ends in m_faces
  std::vector<bool> m_is_old, m_is_inside; // vertices, triangles
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_RING_EXPANDER_H
