// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_TRIANGLE_NUMBERING_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_TRIANGLE_NUMBERING_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/internal/Emptied_on_move.h>
#include <CGAL/Compact_surface_mesh/internal/Ranked_bits.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace internal {

// What a triangle of a structure is: a face, the triangle behind a border halfedge, which
// joins it to an apex, or none that the mesh has.
enum class Triangle_kind : unsigned char { face, border, none };

/*
Numbers faces and halfedges without holes, where a structure has triangles of all kinds in an order of
its own. Triangle t has the corners 3t, 3t+1 and 3t+2, which also name the halfedges that start there;
one of kind `border` stands for the single halfedge that starts at 3t.

Faces keep their order, face f has the halfedges 3f, 3f+1 and 3f+2, and those of borders follow. So
numbers are those of the structure up to the first triangle that is no face. Where borders are in one
piece they are found by a subtraction, else by ranks of bits.
*/
template <class Index>
class Triangle_numbering
{
public:
  Triangle_numbering() = default;

  // The triangles before `num_faces` are faces, the others are borders.
  Triangle_numbering(std::size_t num_triangles, std::size_t num_faces)
    : m_num_sides(static_cast<Index>(3 * num_faces)), m_num_borders(static_cast<Index>(num_triangles - num_faces)),
      m_first(m_num_sides)
  {}

  explicit Triangle_numbering(const std::vector<Triangle_kind>& kinds)
  {
    const auto is_border = [](Triangle_kind kind) { return kind == Triangle_kind::border; };
    const auto is_face = [](Triangle_kind kind) { return kind == Triangle_kind::face; };
    const auto first = std::find_if_not(kinds.begin(), kinds.end(), is_face);
    const auto end = std::find_if_not(first, kinds.end(), is_border);
    const std::size_t num_faces = static_cast<std::size_t>(std::count_if(kinds.begin(), kinds.end(), is_face));
    m_num_sides = static_cast<Index>(3 * num_faces);
    m_num_borders = static_cast<Index>(std::count_if(kinds.begin(), kinds.end(), is_border));
    m_first = static_cast<Index>(3 * (first - kinds.begin()));
    if (std::all_of(end, kinds.end(), is_face))
      return;
    m_faces = Ranked_bits(kinds.size(), [&](std::size_t t) { return is_face(kinds[t]); });
    if (m_num_borders != 0)
      m_borders = Ranked_bits(kinds.size(), [&](std::size_t t) { return is_border(kinds[t]); });
  }

  std::size_t num_faces() const { return m_num_sides / 3; }
  std::size_t num_borders() const { return m_num_borders; }
  std::size_t num_halfedges() const { return std::size_t(m_num_sides) + m_num_borders; }

  // Whether the halfedge is on a border.
  bool is_border(Index h) const { return h >= m_num_sides; }

  // The halfedge that starts at corner c.
  template <class Table>
  Index halfedge(const Table&, Index c) const { return c < m_first ? c : halfedge_behind(c); }
  // The corner where halfedge h starts.
  template <class Table>
  Index corner(const Table&, Index h) const { return h < m_first ? h : corner_behind(h); }

  std::size_t bytes() const { return m_faces.bytes() + m_borders.bytes(); }

private:
  Index halfedge_behind(Index c) const
  {
    const Index t = c / 3;
    if (m_faces.empty()) {
      const Index i = t - m_first / 3;
      return i < m_num_borders ? m_num_sides + i : c - 3 * m_num_borders;
    }
    return m_faces[t] ? static_cast<Index>(3 * m_faces.rank(t) + c % 3)
                      : static_cast<Index>(m_num_sides + m_borders.rank(t));
  }

  Index corner_behind(Index h) const
  {
    if (m_faces.empty())
      return is_border(h) ? m_first + 3 * (h - m_num_sides) : h + 3 * m_num_borders;
    return is_border(h) ? static_cast<Index>(3 * m_borders.select(h - m_num_sides))
                        : static_cast<Index>(3 * m_faces.select(h / 3) + h % 3);
  }

  Emptied_on_move<Index> m_num_sides;   // halfedges of faces
  Emptied_on_move<Index> m_num_borders; // border halfedges
  Emptied_on_move<Index> m_first;       // the first corner of a triangle that is no face
  Ranked_bits m_faces, m_borders;       // empty where borders are in one piece
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_TRIANGLE_NUMBERING_H
