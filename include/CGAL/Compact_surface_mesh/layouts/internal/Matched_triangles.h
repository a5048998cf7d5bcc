// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_MATCHED_TRIANGLES_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_MATCHED_TRIANGLES_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/Corner_table.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

/*
Gives a triangle of its own to each vertex of a closed triangulation without caps, in linear time.

A vertex on a border gets the triangle behind the border halfedge into it. From there, or from one
triangle of a component without border, the region grows over one edge after the other,
depth first: a triangle whose third vertex is new is given to that one. In a component without border
the first two vertices remain, and get theirs by an alternating path. There is one if each
vertex has three triangles, for any k vertices then see k or more of them, that is, always but in the
component of two triangles.
*/
template <class Index>
class Matched_triangles
{
  typedef Corner_table<Index> Table;

public:
  explicit Matched_triangles(const Closed_triangulation<Index>& t)
    : m_table(t.table()), m_num_faces(t.num_open_faces()), m_first_copy(t.first_copy()),
      m_into(t.first_apex(), null()), m_owner(t.table().num_faces(), null()), m_via(t.table().num_faces(), null())
  {
    std::vector<bool> is_met(t.table().num_vertices(), false), is_passed(t.table().num_faces(), false);
    for (std::size_t f = m_num_faces; f < m_owner.size(); ++f) {
      const Index h = static_cast<Index>(3 * f);
      give(h);
      is_met[m_table.target(h)] = is_passed[f] = true;
      m_waiting.push_back(m_table.opposite(h));
    }
    grow(is_met, is_passed);
    for (std::size_t f = 0; f < m_num_faces; ++f) {
      if (is_passed[f])
        continue;
      const Index h = static_cast<Index>(3 * f);
      is_met[m_table.source(h)] = is_met[m_table.target(h)] = true;
      m_waiting.push_back(h);
      grow(is_met, is_passed);
      augment(h);
      augment(Table::prev(h));
    }
    std::vector<Index>().swap(m_via);
    std::vector<Index>().swap(m_waiting);
  }

  static constexpr Index null() { return Table::null(); }

  const Table& table() const { return m_table; }
  // Those that are neither apices nor isolated have a triangle, with the exception above.
  std::size_t num_vertices() const { return m_into.size(); }
  bool is_copy(Index v) const { return v >= m_first_copy; }
  bool is_apex(Index v) const { return v >= m_into.size(); }
  bool is_face(Index f) const { return f < m_num_faces; }

  // The halfedge with target v in the triangle of v, null if it has none.
  Index into(Index v) const { return m_into[v]; }
  // The vertex of triangle f, null if it has none.
  Index owner(Index f) const { return m_owner[f]; }

  // Gives the triangle of h, which has none or is that of the same vertex, to the target of h.
  void give(Index h)
  {
    m_into[m_table.target(h)] = h;
    m_owner[Table::face(h)] = m_table.target(h);
  }

  // The same for a further triangle of a vertex, or, with null, takes it away.
  void set_owner(Index f, Index v) { m_owner[f] = v; }

  // The halfedge with the same target in the triangle that follows, clockwise, and the one before.
  Index following(Index h) const { return m_table.opposite(Table::next(h)); }
  Index preceding(Index h) const { return Table::prev(m_table.opposite(h)); }

private:
  // Passes all triangles that are reached from the halfedges that wait, whose ends are met.
  void grow(std::vector<bool>& is_met, std::vector<bool>& is_passed)
  {
    while (!m_waiting.empty()) {
      const Index h = m_waiting.back();
      m_waiting.pop_back();
      if (is_passed[Table::face(h)])
        continue;
      is_passed[Table::face(h)] = true;
      const Index to_third = Table::next(h), third = m_table.target(to_third);
      if (!is_met[third]) {
        is_met[third] = true;
        give(to_third);
      }
      m_waiting.push_back(m_table.opposite(to_third));
      m_waiting.push_back(m_table.opposite(Table::prev(h)));
    }
  }

  // Finds a triangle for the target of `start`: one of its own, or else one that a neighbor gets
  // in place of its own, and so on.
  void augment(Index start)
  {
    std::vector<Index> reached(1, start); // halfedges into vertices in search of a triangle
    std::vector<Index> passed;
    for (std::size_t i = 0; i < reached.size(); ++i) {
      Index h = reached[i];
      do {
        const Index f = Table::face(h);
        if (m_via[f] == null() && m_owner[f] != m_table.target(h)) {
          m_via[f] = h;
          passed.push_back(f);
          if (m_owner[f] == null()) {
            shift(f);
            reached.clear();
            break;
          }
          reached.push_back(m_into[m_owner[f]]);
        }
        h = following(h);
      } while (h != reached[i]);
    }
    for (const Index f : passed)
      m_via[f] = null();
  }

  // Gives f to the vertex from which it was reached, the triangle of that one to the one before, and so on.
  void shift(Index f)
  {
    for (;;) {
      const Index h = m_via[f], before = m_into[m_table.target(h)];
      give(h);
      if (before == null())
        return;
      f = Table::face(before);
    }
  }

  const Table& m_table;
  std::size_t m_num_faces, m_first_copy;
  std::vector<Index> m_into;  // a halfedge with target v, for each vertex v that is no apex
  std::vector<Index> m_owner; // of each triangle
  std::vector<Index> m_via;   // how a triangle was reached, by the halfedge into the vertex
  std::vector<Index> m_waiting;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_MATCHED_TRIANGLES_H
