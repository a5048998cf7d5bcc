// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SORTED_CORNERS_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SORTED_CORNERS_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/Corner_table.h>
#include <CGAL/Compact_surface_mesh/internal/Emptied_on_move.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Bordered_corners.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Matched_triangles.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Paired_triangles.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

/*
Opposites alone: see Bordered_corners for what a table is.

Each vertex has a triangle, and they are sorted alike: the halfedge 3v of triangle v has the
target v. To find the target of another halfedge, one turns around it until such a one is met.

If triangles are `paired`, the first q vertices have two, v and m + v, where m is the number of vertices
with triangles, and the halfedges 3v and 3(m + v) have the target v: the quad of v. Their common edge
{3v + 1, 3(m + v)} is not stored.

    vertices                        triangles                    stored of a triangle
    with a quad      0 .. q-1       v, and m + v                 halfedges 0 and 2; 1 and 2
    with a triangle  q .. m-1       v                            all
    none                            m + q ..                     all

Of the vertices with a quad those on borders are the first, of the others they are the last, so the triangles behind
borders are in one piece: of a quad it is the second one that is behind the border, and always the halfedge
that is a multiple of three. Copies of a vertex, one for each further fan, are at the end; they have no quad.
Vertices of a component of two triangles that have none are listed; isolated ones follow.
*/
template <class Index_, bool paired>
class Sorted_corners
{
  typedef Corner_table<Index_> Table;

public:
  typedef Index_ Index;

  Sorted_corners() = default;

  Sorted_corners(Closed_triangulation<Index>& t, Corner_images<Index>& images)
    : m_num_vertices(t.first_copy())
  {
    Matched_triangles<Index> matched(t);
    std::unique_ptr<const Paired_triangles<Index>> pairs;
    if (paired)
      pairs = std::make_unique<const Paired_triangles<Index>>(matched);
    const auto has_quad = [&](Index v) { return paired && pairs->is_pair(v); };
    std::vector<Index> order = sort_vertices(t, matched, has_quad);
    sort_triangles(matched, has_quad, order, images.corners);
    list_vertices_without_triangle(t, matched, order, images.corners);
    store_opposites(t.table(), images.corners);
    name_vertices(t, order, images.vertices);
    t.release_table();
  }

  static constexpr Index null() { return Table::null(); }

  std::size_t num_vertices() const { return m_num_vertices; }
  std::size_t num_triangles() const { return (m_opposite.size() + 2 * std::size_t(m_num_quads)) / 3; }

  Index opposite(Index c) const
  {
    if (!is_in_quad(c))
      return m_opposite[slot(c)];
    const Index t = c / 3;
    return static_cast<Index>(t < m_num_quads ? 3 * (m_num_matched + t) : 3 * (t - m_num_matched) + 1);
  }

  Index source(Index c) const { return target(Table::prev(c)); }

  Index target(Index c) const
  {
    Index h = c;
    do {
      if (h % 3 == 0) {
        const Index v = owner(static_cast<Index>(h / 3));
        if (v != null())
          return v < m_first_copy ? v : m_copies[v - m_first_copy];
      }
      h = opposite(Table::next(h));
    } while (h != c);
    return target_without_triangle(c);
  }

  Index halfedge_of_vertex(Index v) const
  {
    if (v < m_first_copy)
      return static_cast<Index>(3 * (v < m_num_border_quads ? m_num_matched + v : v));
    const std::size_t i = v - m_first_copy;
    return i < m_without_triangle.size() ? m_without_triangle[i] : null();
  }

  std::vector<std::pair<std::string, std::size_t>> memory() const
  {
    return { { "opposites", m_opposite.capacity() * sizeof(Index) },
             { "copies of vertices", m_copies.capacity() * sizeof(Index) },
             { "vertices without triangle", m_without_triangle.capacity() * sizeof(Index) } };
  }

private:
  // Whether halfedge c is one of the two inside of a quad.
  bool is_in_quad(Index c) const
  {
    if (!paired)
      return false;
    const Index t = c / 3, i = c % 3;
    return t < m_num_quads ? i == 1 : i == 0 && m_num_matched <= t && t - m_num_matched < m_num_quads;
  }

  // Where the opposite of c, which is not inside of a quad, is stored.
  Index slot(Index c) const
  {
    if (!paired)
      return c;
    const Index t = c / 3, i = c % 3;
    if (t < m_num_quads)
      return static_cast<Index>(4 * t + i / 2);
    if (t < m_num_matched)
      return static_cast<Index>(c + m_num_quads);
    if (t - m_num_matched < m_num_quads)
      return static_cast<Index>(4 * (t - m_num_matched) + 1 + i);
    return static_cast<Index>(c - 2 * m_num_quads);
  }

  // The vertex of triangle t, null if it has none.
  Index owner(Index t) const
  {
    if (t < m_num_matched)
      return t;
    return paired && t - m_num_matched < m_num_quads ? static_cast<Index>(t - m_num_matched) : null();
  }

  // There are few such vertices, which have two halfedges each, and the first one is listed.
  Index target_without_triangle(Index c) const
  {
    const Index first = (std::min)(c, opposite(Table::next(c)));
    const auto it = std::lower_bound(m_without_triangle.begin(), m_without_triangle.end(), first);
    return static_cast<Index>(m_first_copy + (it - m_without_triangle.begin()));
  }

  enum Kind { border_quad, quad, triangle, border_triangle, copy, no_triangle, isolated, num_kinds };

  // Returns for each vertex that is no apex its place among them, sorted by kinds.
  template <class HasQuad>
  std::vector<Index> sort_vertices(const Closed_triangulation<Index>& t, const Matched_triangles<Index>& matched,
                                   const HasQuad& has_quad)
  {
    const std::size_t n = matched.num_vertices();
    std::vector<unsigned char> kind(n, isolated);
    for (std::size_t h = 0; h < t.table().num_halfedges(); ++h)
      if (!matched.is_apex(t.table().target(static_cast<Index>(h))))
        kind[t.table().target(static_cast<Index>(h))] = no_triangle;
    std::array<std::size_t, num_kinds + 1> first{};
    for (std::size_t i = 0; i < n; ++i) {
      const Index v = static_cast<Index>(i), h = matched.into(v);
      if (h != null() && has_quad(v))
        kind[i] = matched.is_face(Table::face(matched.following(h))) ? quad : border_quad;
      else if (h != null())
        kind[i] = matched.is_face(Table::face(h)) ? triangle : matched.is_copy(v) ? copy : border_triangle;
      ++first[kind[i] + 1];
    }
    for (std::size_t k = 0; k < num_kinds; ++k)
      first[k + 1] += first[k];
    m_num_border_quads = static_cast<Index>(first[quad]);
    m_num_quads = static_cast<Index>(first[triangle]);
    m_first_copy = static_cast<Index>(first[copy]);
    m_num_matched = static_cast<Index>(first[no_triangle]);
    std::vector<Index> order(n);
    for (std::size_t i = 0; i < n; ++i)
      order[i] = static_cast<Index>(first[kind[i]]++);
    return order;
  }

  template <class HasQuad>
  void sort_triangles(const Matched_triangles<Index>& matched, const HasQuad& has_quad, const std::vector<Index>& order,
                      std::vector<Index>& corners) const
  {
    const Table& table = matched.table();
    corners.assign(table.num_halfedges(), null());
    const auto place = [&](Index h, std::size_t triangle) { // halfedge h becomes the first one of the triangle
      corners[h] = static_cast<Index>(3 * triangle);
      corners[Table::next(h)] = static_cast<Index>(3 * triangle + 1);
      corners[Table::prev(h)] = static_cast<Index>(3 * triangle + 2);
    };
    for (std::size_t i = 0; i < matched.num_vertices(); ++i) {
      const Index v = static_cast<Index>(i), h = matched.into(v);
      if (h == null())
        continue;
      place(h, order[v]);
      if (has_quad(v))
        place(matched.following(h), std::size_t(m_num_matched) + order[v]);
    }
    std::size_t next_place = std::size_t(m_num_matched) + m_num_quads;
    for (std::size_t f = 0; f < table.num_faces(); ++f)
      if (matched.owner(static_cast<Index>(f)) == null())
        place(static_cast<Index>(3 * f), next_place++);
  }

  void list_vertices_without_triangle(const Closed_triangulation<Index>& t, const Matched_triangles<Index>& matched,
                                      std::vector<Index>& order, const std::vector<Index>& corners)
  {
    std::vector<std::pair<Index, Index>> without; // the first halfedge, and the vertex
    for (std::size_t i = 0; i < 3 * t.num_open_faces(); ++i) {
      const Index h = static_cast<Index>(i), v = t.table().target(h);
      if (matched.into(v) == null() && corners[h] < corners[matched.following(h)])
        without.emplace_back(corners[h], v);
    }
    std::sort(without.begin(), without.end());
    for (std::size_t i = 0; i < without.size(); ++i) {
      order[without[i].second] = static_cast<Index>(m_num_matched + i);
      m_without_triangle.push_back(without[i].first);
    }
    m_without_triangle.shrink_to_fit();
  }

  void store_opposites(const Table& table, const std::vector<Index>& corners)
  {
    m_opposite.resize(table.num_halfedges() - 2 * std::size_t(m_num_quads));
    for (std::size_t i = 0; i < table.num_halfedges(); ++i) {
      if (!is_in_quad(corners[i]))
        m_opposite[slot(corners[i])] = corners[table.opposite(static_cast<Index>(i))];
    }
  }

  // Copies have no names of their own: those of the vertices behind them are smaller by their number.
  void name_vertices(const Closed_triangulation<Index>& t, const std::vector<Index>& order,
                     std::vector<Index>& vertices)
  {
    m_copies.resize(m_num_matched - m_first_copy);
    const auto name = [&](std::size_t v) {
      return order[v] < m_num_matched ? order[v] : static_cast<Index>(order[v] - m_copies.size());
    };
    for (std::size_t i = 0; i < t.copies().size(); ++i)
      m_copies[order[t.first_copy() + i] - m_first_copy] = name(t.copies()[i]);
    vertices.resize(t.first_copy());
    for (std::size_t v = 0; v < vertices.size(); ++v)
      vertices[v] = name(v);
  }

  Emptied_on_move<std::size_t> m_num_vertices;
  Emptied_on_move<Index> m_num_border_quads, m_num_quads; // the first vertices
  Emptied_on_move<Index> m_first_copy, m_num_matched;     // the first vertices, and with copies
  std::vector<Index> m_opposite;
  std::vector<Index> m_copies;           // the vertices that they are copies of
  std::vector<Index> m_without_triangle; // the first halfedge into each vertex without triangle, sorted
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SORTED_CORNERS_H
