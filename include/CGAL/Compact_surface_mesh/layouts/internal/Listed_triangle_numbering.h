// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_LISTED_TRIANGLE_NUMBERING_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_LISTED_TRIANGLE_NUMBERING_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/internal/Emptied_on_move.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Filled_slots.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Triangle_numbering.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

/*
Numbers faces and halfedges as Triangle_numbering does, but by lists of the triangles that are no faces
where these are few. A face keeps its number then, but for the last ones, which fill the gaps. The table
must say whether triangle t is a face: bool is_face(Index t) const.
*/
template <class Index>
class Listed_triangle_numbering
{
public:
  Listed_triangle_numbering() = default;

  Listed_triangle_numbering(std::size_t num_triangles, std::size_t num_faces) : m_ranked(num_triangles, num_faces) {}

  explicit Listed_triangle_numbering(const std::vector<Triangle_kind>& kinds) : m_ranked(kinds)
  {
    std::vector<Index> others, borders;
    for (std::size_t t = 0; t < kinds.size(); ++t) {
      if (kinds[t] != Triangle_kind::face)
        others.push_back(static_cast<Index>(t));
      if (kinds[t] == Triangle_kind::border)
        borders.push_back(static_cast<Index>(t));
    }
    Filled_slots<Index> faces(kinds.size(), std::move(others));
    if (faces.bytes() + borders.size() * sizeof(Index) >= m_ranked.bytes())
      return;
    m_is_listed = true;
    m_num_sides = static_cast<Index>(3 * m_ranked.num_faces());
    m_ranked = Triangle_numbering<Index>();
    m_faces = std::move(faces);
    borders.shrink_to_fit();
    m_borders = std::move(borders);
  }

  std::size_t num_faces() const { return m_is_listed ? m_num_sides / 3 : m_ranked.num_faces(); }
  std::size_t num_halfedges() const
  {
    return m_is_listed ? std::size_t(m_num_sides) + m_borders.size() : m_ranked.num_halfedges();
  }

  // Whether the halfedge is on a border.
  bool is_border(Index h) const { return m_is_listed ? h >= m_num_sides : m_ranked.is_border(h); }

  // The halfedge that starts at corner c.
  template <class Table>
  BOOST_FORCEINLINE Index halfedge(const Table& table, Index c) const
  {
    if (BOOST_LIKELY(m_is_listed && c < m_num_sides && (m_borders.empty() || table.is_face(c / 3))))
      return c;
    return m_is_listed ? halfedge_elsewhere(table, c) : m_ranked.halfedge(table, c);
  }

  // The corner where halfedge h starts.
  template <class Table>
  BOOST_FORCEINLINE Index corner(const Table& table, Index h) const
  {
    if (BOOST_LIKELY(m_is_listed && h < m_num_sides && table.is_face(h / 3)))
      return h;
    return m_is_listed ? corner_elsewhere(h) : m_ranked.corner(table, h);
  }

  std::size_t bytes() const
  {
    return m_ranked.bytes() + m_faces.bytes() + m_borders.capacity() * sizeof(Index);
  }

private:
  template <class Table>
  BOOST_NOINLINE Index halfedge_elsewhere(const Table& table, Index c) const
  {
    const Index t = c / 3;
    if (m_borders.empty() || table.is_face(t))
      return static_cast<Index>(3 * m_faces.number(t) + c % 3);
    const auto it = std::lower_bound(m_borders.begin(), m_borders.end(), t);
    return m_num_sides + static_cast<Index>(it - m_borders.begin());
  }

  BOOST_NOINLINE Index corner_elsewhere(Index h) const
  {
    return is_border(h) ? 3 * m_borders[h - m_num_sides] : static_cast<Index>(3 * m_faces.slot(h / 3) + h % 3);
  }

  Triangle_numbering<Index> m_ranked;
  Emptied_on_move<unsigned char> m_is_listed;
  Emptied_on_move<Index> m_num_sides; // halfedges of faces
  Filled_slots<Index> m_faces;
  std::vector<Index> m_borders;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_LISTED_TRIANGLE_NUMBERING_H
