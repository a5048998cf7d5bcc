// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_INTERNAL_BREADTH_FIRST_RENUMBERING_H
#define CGAL_COMPACT_SURFACE_MESH_INTERNAL_BREADTH_FIRST_RENUMBERING_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Corner_table.h>
#include <CGAL/Compact_surface_mesh/internal/Large_array.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace internal {

/*
Gives the first faces and the first vertices of a closed corner table numbers in breadth-first order, so that
neighbors stand close to each other; the other faces and vertices keep theirs. Corners keep their places
in their faces.

The queue of faces says what will be needed: it is fetched ahead, so that the one pass through memory in the order of
the input, which is a bad one, does not wait for each face. All later ones are in the new order.
*/
template <class Index>
class Breadth_first_renumbering
{
  typedef Corner_table<Index> Table;
  static constexpr std::size_t corners_ahead = 32, numbers_ahead = 16;

public:
  Breadth_first_renumbering(const Table& table, std::size_t num_faces, std::size_t num_vertices)
    : m_table(table), m_num_faces(num_faces), m_face(num_faces, Table::null()), m_vertex(num_vertices, Table::null())
  {
    m_order.reserve(num_faces);
    m_corner.reserve(table.m_corner.capacity());
    for (std::size_t f = 0; f < num_faces; ++f)
      if (m_face[f] == Table::null())
        number_component(static_cast<Index>(f));
    number_isolated_vertices();
    for (std::size_t f = num_faces; f < table.num_faces(); ++f)
      append(static_cast<Index>(f));
    Large_array<Index>().swap(m_order);
  }

  Index halfedge(Index h) const
  {
    const Index f = Table::face(h);
    return f < m_num_faces ? static_cast<Index>(3 * m_face[f] + h % 3) : h;
  }
  Index vertex(Index v) const { return v < m_vertex.size() ? m_vertex[v] : v; }

  // Give away the new corners, and the new numbers of vertices and faces.
  Paired_corners<Index> release_corners() { return std::move(m_corner); }
  Large_array<Index> release_vertices() { return std::move(m_vertex); }
  Large_array<Index> release_faces() { return std::move(m_face); }

  // Whether most edges join faces that are so far apart that they are in different parts of the cache.
  static bool is_scattered(const Table& table)
  {
    constexpr std::size_t far = std::size_t(1) << 13, num_samples = 1024;
    if (table.num_faces() < 8 * far)
      return false;
    std::size_t num_far = 0;
    for (std::size_t i = 0; i < num_samples; ++i) {
      const std::size_t h = i * (table.num_halfedges() / num_samples) + i % 3; // the places in faces take turns
      const Index o = table.opposite(static_cast<Index>(h));
      const std::size_t f = h / 3, g = o == Table::null() ? f : Table::face(o);
      num_far += (std::max)(f, g) - (std::min)(f, g) > far ? 1 : 0;
    }
    return num_far > num_samples / 2;
  }

private:
  void number_component(Index first)
  {
    std::size_t i = m_order.size();
    number_face(first);
    for (; i < m_order.size(); ++i) {
      if (i + corners_ahead < m_order.size())
        fetch(&m_table.m_corner[3 * std::size_t(m_order[i + corners_ahead])]);
      if (i + numbers_ahead < m_order.size())
        fetch_numbers(m_order[i + numbers_ahead]);
      append(m_order[i]);
    }
  }

  void number_face(Index f)
  {
    m_face[f] = static_cast<Index>(m_order.size());
    m_order.push_back(f);
  }

  // Appends the corners of face f as they are now. New numbers of neighbors are found.
  void append(Index f)
  {
    for (Index h = 3 * f; h != 3 * f + 3; ++h) {
      const Index v = m_table.vertex(h), o = m_table.opposite(h);
      if (v < m_vertex.size() && m_vertex[v] == Table::null())
        m_vertex[v] = m_num_numbered++;
      if (Table::face(o) < m_num_faces && m_face[Table::face(o)] == Table::null())
        number_face(Table::face(o));
      m_corner.push_back({ vertex(v), halfedge(o) });
    }
  }

  void fetch_numbers(Index f) const
  {
    for (Index h = 3 * f; h != 3 * f + 3; ++h) {
      const Index v = m_table.vertex(h), g = Table::face(m_table.opposite(h));
      if (v < m_vertex.size())
        fetch(&m_vertex[v]);
      if (g < m_num_faces)
        fetch(&m_face[g]);
    }
  }

  void number_isolated_vertices()
  {
    for (Index& number : m_vertex)
      if (number == Table::null())
        number = m_num_numbered++;
  }

  static void fetch(const void* p)
  {
#if defined(__GNUC__)
    __builtin_prefetch(p);
#else
    static_cast<void>(p);
#endif
  }

  const Table& m_table;
  const std::size_t m_num_faces;
  Large_array<Index> m_face, m_vertex; // the new number of each
  Large_array<Index> m_order;          // the old one of each face
  Paired_corners<Index> m_corner;      // as they are now
  Index m_num_numbered = 0;            // vertices
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_INTERNAL_BREADTH_FIRST_RENUMBERING_H
