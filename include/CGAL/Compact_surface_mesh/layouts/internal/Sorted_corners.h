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
#include <CGAL/Compact_surface_mesh/internal/Large_array.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Bordered_corners.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Matched_triangles.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Paired_triangles.h>

#include <boost/config.hpp>

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

Each vertex has a triangle, and they are sorted alike: the halfedge 3t of the triangle t of v has the
target v. To find the target of another halfedge, one turns around it until such a one is met. If triangles are
`paired`, many vertices have two, and the halfedge 3t of the second one, too, has the target v: the quad of v. The
common edge of the two, which is at 1 in the first one and at 0 in the second one, is not stored.

The triangle behind a border halfedge belongs to the vertex where that one ends, as the second one if there is a
quad. Of its sides, only that one is stored, and inside of a quad it is not, either; what is next to it at the
apex is found around the vertices of the border. So there is one reference for each halfedge, those of borders
included, and two less for each quad.

With f faces, and numbers q <= s <= m <= n, these are

    vertices                            triangles           stored of a triangle
    with a quad             0 .. q-1    v, and m + v        halfedges 0 and 2; 1 and 2
    with a triangle         q .. s-1    v                   all
    with a quad, on border  s .. m-1    v, and f + v - s    halfedges 0 and 2; none
    on a border             m .. n-1    f + v - s           halfedge 0
    none                                m + q .. f-1        all

that is, vertices on borders come last, and so do the triangles behind these. Copies of a vertex, one for each
further fan, are the last of these n; they have no quad. Vertices of a component of two triangles that have none
are listed; isolated ones follow.
*/
template <class Index_, bool paired>
class Sorted_corners
{
  typedef Corner_table<Index_> Table;

public:
  typedef Index_ Index;

  Sorted_corners() = default;

  Sorted_corners(Closed_triangulation<Index>& t, Corner_images<Index>& images)
    : m_num_vertices(t.first_copy()), m_num_faces(static_cast<Index>(t.num_open_faces()))
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
  std::size_t num_triangles() const { return std::size_t(m_num_faces) + num_borders(); }

  // In constant time, but at an apex in time linear in the degree of a vertex.
  BOOST_FORCEINLINE Index opposite(Index c) const
  {
    return with_opposite(c, itself(), stored(), [this](Index other) { return opposite_elsewhere(other); });
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
      h = opposite_of_side(Table::next(h));
    } while (h != c);
    return target_without_triangle(c);
  }

  Index halfedge_of_vertex(Index v) const
  {
    if (v < m_first_copy)
      return static_cast<Index>(3 * (v < m_first_on_border ? v : triangle_behind_border(v)));
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
  std::size_t num_borders() const { return m_num_matched - m_first_on_border; }
  std::size_t num_border_quads() const { return m_num_with_face - m_first_on_border; }

  static auto itself() { return [](Index opposite) { return opposite; }; }
  auto stored() const { return [this](std::size_t slot) { return m_opposite[slot]; }; }

  // Returns `stored(slot)` of the slot where the opposite of a halfedge is stored, or `implied(opposite)` if it is not.
  // Most halfedges are those of quads of two faces, or, without quads, of faces; what other ones need is `elsewhere`.
  template <class Implied, class Stored, class Elsewhere>
  BOOST_FORCEINLINE auto with_opposite(Index c, const Implied& implied, const Stored& stored,
                                       const Elsewhere& elsewhere) const
  {
    if constexpr (!paired)
      return c < 3 * m_num_faces ? stored(c) : elsewhere(c);
    const Index t = c / 3, i = c % 3;
    if (t < m_num_quads)
      return i == 1 ? implied(static_cast<Index>(3 * (m_num_with_face + t))) : stored(4 * std::size_t(t) + i / 2);
    const Index v = static_cast<Index>(t - m_num_with_face);
    if (v < m_num_quads)
      return i == 0 ? implied(static_cast<Index>(3 * v + 1)) : stored(4 * std::size_t(v) + 1 + i);
    return elsewhere(c);
  }

  // The same for other halfedges, but not at apices.
  template <class Implied, class Stored>
  BOOST_FORCEINLINE auto with_opposite_elsewhere(Index c, const Implied& implied, const Stored& stored) const
  {
    const std::size_t t = c / 3, i = c % 3, b = num_border_quads();
    if (t < m_first_on_border)
      return stored(c + m_num_quads);
    if (t < m_num_with_face)
      return i == 1 ? implied(static_cast<Index>(3 * triangle_behind_border(static_cast<Index>(t))))
                    : stored(m_first_on_border + m_num_quads + 2 * t + i / 2);
    if (t < m_num_faces)
      return stored(c - 2 * std::size_t(m_num_quads) - b);
    if (t < m_num_faces + b)
      return implied(static_cast<Index>(3 * (t - m_num_faces + m_first_on_border) + 1));
    return stored(t + 2 * (std::size_t(m_num_faces) - m_num_quads - b));
  }

  // Not asked at an apex.
  BOOST_FORCEINLINE Index opposite_of_side(Index c) const
  {
    return with_opposite(c, itself(), stored(),
                         [this](Index other) { return with_opposite_elsewhere(other, itself(), stored()); });
  }

  // At an apex, the triangle behind the next border halfedge, or the one before, is found around the vertex between.
  BOOST_NOINLINE Index opposite_elsewhere(Index c) const
  {
    if (c / 3 < m_num_faces || c % 3 == 0)
      return with_opposite_elsewhere(c, itself(), stored());
    const bool is_next = c % 3 == 1;
    Index h = opposite_of_side(static_cast<Index>(c - c % 3));
    do
      h = opposite_of_side(is_next ? Table::prev(h) : Table::next(h));
    while (h / 3 < m_num_faces);
    return static_cast<Index>(is_next ? h + 2 : h + 1);
  }

  // Of a vertex on a border.
  Index triangle_behind_border(Index v) const { return static_cast<Index>(m_num_faces + (v - m_first_on_border)); }

  // The vertex of triangle t, null if it has none.
  BOOST_FORCEINLINE Index owner(Index t) const
  {
    if (t < m_num_with_face)
      return t;
    const Index v = static_cast<Index>(t - m_num_with_face);
    if (paired && v < m_num_quads)
      return v;
    return t < m_num_faces ? null() : static_cast<Index>(m_first_on_border + (t - m_num_faces));
  }

  // There are few such vertices, which have two halfedges each, and the first one is listed.
  Index target_without_triangle(Index c) const
  {
    const Index first = (std::min)(c, opposite(Table::next(c)));
    const auto it = std::lower_bound(m_without_triangle.begin(), m_without_triangle.end(), first);
    return static_cast<Index>(m_first_copy + (it - m_without_triangle.begin()));
  }

  enum Kind { quad, triangle, border_quad, border_triangle, copy, no_triangle, isolated, num_kinds };

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
    m_num_quads = static_cast<Index>(first[triangle]);
    m_first_on_border = static_cast<Index>(first[border_quad]);
    m_num_with_face = static_cast<Index>(first[border_triangle]);
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
      const Index p = order[v];
      place(h, p < m_num_with_face ? p : triangle_behind_border(p));
      if (has_quad(v))
        place(matched.following(h), p < m_num_quads ? std::size_t(m_num_with_face) + p : triangle_behind_border(p));
    }
    std::size_t next_place = std::size_t(m_num_with_face) + m_num_quads;
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
    m_opposite.resize(3 * std::size_t(m_num_faces) + num_borders() - 2 * (m_num_quads + num_border_quads()));
    for (std::size_t i = 0; i < table.num_halfedges(); ++i) {
      const Index c = corners[i];
      const auto ignore = [](Index) {};
      const auto store = [&](std::size_t slot) { m_opposite[slot] = corners[table.opposite(static_cast<Index>(i))]; };
      if (c / 3 < m_num_faces || c % 3 == 0) // not at an apex
        with_opposite(c, ignore, store, [&](Index other) { with_opposite_elsewhere(other, ignore, store); });
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
  Emptied_on_move<Index> m_num_faces;                     // f
  Emptied_on_move<Index> m_num_quads;                     // of two faces: q
  Emptied_on_move<Index> m_first_on_border;               // s
  Emptied_on_move<Index> m_num_with_face;                 // m
  Emptied_on_move<Index> m_first_copy, m_num_matched;     // all that have a triangle, and with copies: n
  Large_array<Index> m_opposite;
  std::vector<Index> m_copies;           // the vertices that they are copies of
  std::vector<Index> m_without_triangle; // the first halfedge into each vertex without triangle, sorted
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SORTED_CORNERS_H
