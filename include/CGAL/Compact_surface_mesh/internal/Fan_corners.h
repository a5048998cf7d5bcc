// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_INTERNAL_FAN_CORNERS_H
#define CGAL_COMPACT_SURFACE_MESH_INTERNAL_FAN_CORNERS_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/internal/Polygon_list.h>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

// Chooses for each polygon the corner from which diagonals to all other corners make it a fan
// of triangles, such that no diagonal has the same ends as an edge or another diagonal. No
// edges of the polygons may have the same ends. In linear time, and without search: it goes
// from vertex to vertex and stamps where that vertex is joined to.
template <class Index>
class Fan_corners
{
public:
  static constexpr Index null() { return (std::numeric_limits<Index>::max)(); }

  Fan_corners(const Polygon_list<Index>& polygons, std::size_t max_size)
    : m_polygons(polygons), m_max_size(max_size), m_of_face(polygons.num_faces(), null()),
      m_stamp(polygons.num_vertices(), null()), m_diagonal(polygons.num_vertices(), null())
  {
    std::vector<Index> first_corner(polygons.num_vertices(), null()), next_corner(polygons.num_halfedges());
    for (std::size_t i = polygons.num_halfedges(); i-- > 0;) {
      Index& first = first_corner[polygons.vertex(static_cast<Index>(i))];
      next_corner[i] = first;
      first = static_cast<Index>(i);
    }
    for (std::size_t i = 0; i < polygons.num_vertices(); ++i) {
      const Index v = static_cast<Index>(i);
      stamp_neighbors(v, first_corner[v], next_corner);
      for (Index c = first_corner[v]; c != null(); c = next_corner[c])
        if (is_undecided(m_polygons.face(c)) && is_free(c))
          choose(c);
    }
  }

  // Gives away the corners chosen for the faces: null for triangles, for polygons that are too
  // large, and where there is no such corner.
  std::vector<Index> release() { return std::move(m_of_face); }

private:
  struct Diagonal
  {
    Index end;
    Index next; // at the same other end
  };

  void stamp_neighbors(Index v, Index first_corner, const std::vector<Index>& next_corner)
  {
    for (Index c = first_corner; c != null(); c = next_corner[c]) {
      m_stamp[m_polygons.vertex(m_polygons.next(c))] = v;
      m_stamp[m_polygons.vertex(m_polygons.prev(c))] = v;
    }
    for (Index d = m_diagonal[v]; d != null(); d = m_diagonals[d].next)
      m_stamp[m_diagonals[d].end] = v;
  }

  bool is_undecided(Index f) const
  {
    const std::size_t size = m_polygons.size(f);
    return m_of_face[f] == null() && size > 3 && size <= m_max_size;
  }

  // Whether the vertex of c, whose turn it is, is not joined to where the diagonals from c end.
  bool is_free(Index c) const
  {
    bool free = true;
    for_each_diagonal_end(c, [&](Index w) { free = free && m_stamp[w] != m_polygons.vertex(c); });
    return free;
  }

  void choose(Index c)
  {
    const Index v = m_polygons.vertex(c);
    m_of_face[m_polygons.face(c)] = c;
    for_each_diagonal_end(c, [&](Index w) {
      m_stamp[w] = v;
      if (w < v) // its turn is over
        return;
      m_diagonals.push_back(Diagonal{ v, m_diagonal[w] });
      m_diagonal[w] = static_cast<Index>(m_diagonals.size() - 1);
    });
  }

  template <class Visitor>
  void for_each_diagonal_end(Index c, Visitor visit) const
  {
    const Index last = m_polygons.prev(c);
    for (Index d = m_polygons.next(m_polygons.next(c)); d != last; d = m_polygons.next(d))
      visit(m_polygons.vertex(d));
  }

  const Polygon_list<Index>& m_polygons;
  std::size_t m_max_size;
  std::vector<Index> m_of_face;
  std::vector<Index> m_stamp;        // of each vertex: the last one that was found to be joined to it
  std::vector<Diagonal> m_diagonals; // noted at those ends whose turn comes later; fewer than corners
  std::vector<Index> m_diagonal;     // of each vertex: the one that was noted last
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_INTERNAL_FAN_CORNERS_H
