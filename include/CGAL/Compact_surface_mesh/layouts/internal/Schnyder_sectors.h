// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_SECTORS_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_SECTORS_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Corner_table.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Search_directory.h>
#include <CGAL/Schnyder_woods/internal/Schnyder_wood.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

// The halfedge out of each vertex that is red, null if the vertex is isolated; but for apices, which follow
// the first `num_vertices` vertices.
template <class Index>
Large_array<Index> red_edges_out(const Corner_table<Index>& table, const Schnyder_wood& wood, std::size_t num_vertices)
{
  Large_array<Index> result(num_vertices, Corner_table<Index>::null());
  for (std::size_t h = 0; h < table.num_halfedges(); ++h)
    if (wood.is_out(h, red) && table.source(static_cast<Index>(h)) < num_vertices)
      result[table.source(static_cast<Index>(h))] = static_cast<Index>(h);
  return result;
}

// The last sector of a vertex x, whose further sectors are among the `size` from `begin` on, which are sorted by
// their vertices, vertex(s). `search` is the directory of these.
template <class Index, class VertexOfSector>
Index last_sector_of(Index x, Index begin, std::size_t size, const Search_directory<Index>& search,
                     const VertexOfSector& vertex)
{
  const std::size_t end = search.lower_bound(size, static_cast<Index>(x + 1),
                                             [&](std::size_t i) { return vertex(static_cast<Index>(begin + i)); });
  if (end == 0)
    return x;
  const Index last = static_cast<Index>(begin + (end - 1));
  return vertex(last) == x ? last : x;
}

// The sectors of the vertices of a wood: what the special edges at a vertex and its red edge out
// part. The first one, counterclockwise behind the red edge, has the name of its vertex; further
// ones have the names from the number of vertices on, those of a vertex in counterclockwise order.
template <class Index>
class Schnyder_sectors
{
  typedef Corner_table<Index> Table;

public:
  Schnyder_sectors() = default;

  // `red_edge` is as from red_edges_out().
  Schnyder_sectors(const Table& table, const Schnyder_wood& wood, const Large_array<Index>& red_edge)
    : m_num_vertices(red_edge.size())
  {
    for (std::size_t h = 0; h < table.num_halfedges(); ++h)
      if (BOOST_UNLIKELY(wood.is_special(h)))
        m_multiple.push_back(table.source(static_cast<Index>(h)));
    if (m_multiple.empty())
      return;
    std::sort(m_multiple.begin(), m_multiple.end());
    m_multiple.erase(std::unique(m_multiple.begin(), m_multiple.end()), m_multiple.end());
    m_is_multiple.assign(table.num_vertices(), false);
    for (const Index v : m_multiple) {
      m_is_multiple[v] = true;
      Index name = v;
      Index h = red_edge[v];
      do {
        if (wood.is_special(h)) {
          name = static_cast<Index>(m_num_vertices + m_vertex_of_further.size());
          m_vertex_of_further.push_back(v);
        }
        m_sector_of_corner.emplace_back(h, name);
        h = table.next_around_source(h);
      } while (h != red_edge[v]);
    }
    std::sort(m_sector_of_corner.begin(), m_sector_of_corner.end());
  }

  // The vertices with several sectors.
  const std::vector<Index>& multiple_vertices() const { return m_multiple; }

  std::size_t num_further() const { return m_vertex_of_further.size(); }
  Index vertex_of_further(Index name) const { return m_vertex_of_further[name - m_num_vertices]; }

  // The names of the further sectors, sorted by the numbers of their vertices.
  std::vector<Index> further_sectors_by(const std::vector<Index>& number) const
  {
    std::vector<Index> names(num_further());
    for (std::size_t i = 0; i < names.size(); ++i)
      names[i] = static_cast<Index>(m_num_vertices + i);
    std::sort(names.begin(), names.end(), [&](Index a, Index b) {
      return std::make_pair(number[vertex_of_further(a)], a) < std::make_pair(number[vertex_of_further(b)], b);
    });
    return names;
  }

  // The sector in which corner c is.
  Index sector(const Table& table, Index c) const
  {
    const Index v = table.vertex(c);
    if (BOOST_LIKELY(m_is_multiple.empty() || !m_is_multiple[v]))
      return v;
    return std::lower_bound(m_sector_of_corner.begin(), m_sector_of_corner.end(), std::make_pair(c, Index(0)))->second;
  }

private:
  std::size_t m_num_vertices = 0;
  std::vector<Index> m_multiple, m_vertex_of_further;
  std::vector<bool> m_is_multiple; // empty if no vertex is
  std::vector<std::pair<Index, Index>> m_sector_of_corner; // of multiple vertices
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_SECTORS_H
