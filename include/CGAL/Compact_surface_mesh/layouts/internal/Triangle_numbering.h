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

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
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

Faces keep their order, face f has the halfedges 3f, 3f+1 and 3f+2, and those of borders follow. So numbers
are those of the structure before the first triangle that is no face, and behind the last one they
differ by a constant. In between, a subtraction finds borders where they are in one piece, else it takes ranks of bits.
*/
template <class Index>
class Triangle_numbering
{
public:
  Triangle_numbering() = default;

  // The triangles before `num_faces` are faces, the others are borders.
  Triangle_numbering(std::size_t num_triangles, std::size_t num_faces)
    : m_num_sides(static_cast<Index>(3 * num_faces)), m_num_borders(static_cast<Index>(num_triangles - num_faces)),
      m_first(m_num_sides), m_end(static_cast<Index>(3 * num_triangles)), m_shift(m_end - m_first)
  {}

  explicit Triangle_numbering(const std::vector<Triangle_kind>& kinds)
  {
    const auto is_face = [](Triangle_kind kind) { return kind == Triangle_kind::face; };
    const auto is_border = [](Triangle_kind kind) { return kind == Triangle_kind::border; };
    const auto first = std::find_if_not(kinds.begin(), kinds.end(), is_face);
    const auto end = std::find_if_not(kinds.rbegin(), std::make_reverse_iterator(first), is_face).base();
    const std::size_t num_faces = static_cast<std::size_t>(std::count_if(kinds.begin(), kinds.end(), is_face));
    m_num_sides = static_cast<Index>(3 * num_faces);
    m_num_borders = static_cast<Index>(std::count_if(first, end, is_border));
    m_first = static_cast<Index>(3 * (first - kinds.begin()));
    m_end = static_cast<Index>(3 * (end - kinds.begin()));
    m_shift = static_cast<Index>(3 * (kinds.size() - num_faces));
    if (std::all_of(first, end, is_border))
      return;
    const std::size_t num_between = static_cast<std::size_t>(end - first);
    m_faces = Ranked_bits(num_between, [&](std::size_t i) { return is_face(first[static_cast<std::ptrdiff_t>(i)]); });
    if (m_num_borders != 0)
      m_borders =
        Ranked_bits(num_between, [&](std::size_t i) { return is_border(first[static_cast<std::ptrdiff_t>(i)]); });
  }

  std::size_t num_faces() const { return m_num_sides / 3; }
  std::size_t num_borders() const { return m_num_borders; }
  std::size_t num_halfedges() const { return std::size_t(m_num_sides) + m_num_borders; }

  // Whether the halfedge is on a border.
  bool is_border(Index h) const { return h >= m_num_sides; }

  // The halfedge that starts at corner c.
  template <class Table>
  BOOST_FORCEINLINE Index halfedge(const Table&, Index c) const
  {
    return c < m_first ? c : c >= m_end ? static_cast<Index>(c - m_shift) : halfedge_between(c);
  }
  // The corner where halfedge h starts.
  template <class Table>
  BOOST_FORCEINLINE Index corner(const Table&, Index h) const
  {
    return h < m_first ? h : is_border(h) || h + m_shift < m_end ? corner_between(h) : static_cast<Index>(h + m_shift);
  }

  std::size_t bytes() const { return m_faces.bytes() + m_borders.bytes(); }

private:
  BOOST_NOINLINE Index halfedge_between(Index c) const
  {
    const Index i = (c - m_first) / 3;
    if (!m_faces.empty() && m_faces[i])
      return static_cast<Index>(m_first + 3 * m_faces.rank(i) + c % 3);
    return static_cast<Index>(m_num_sides + (m_faces.empty() ? i : m_borders.rank(i)));
  }

  BOOST_NOINLINE Index corner_between(Index h) const
  {
    if (!is_border(h))
      return static_cast<Index>(m_first + 3 * m_faces.select((h - m_first) / 3) + h % 3);
    const Index i = h - m_num_sides;
    return static_cast<Index>(m_first + 3 * (m_faces.empty() ? i : m_borders.select(i)));
  }

  Emptied_on_move<Index> m_num_sides;     // halfedges of faces
  Emptied_on_move<Index> m_num_borders;   // border halfedges
  Emptied_on_move<Index> m_first, m_end;  // corners: of the first triangle that is no face, and behind the last one
  Emptied_on_move<Index> m_shift;         // the number of corners of such triangles
  Ranked_bits m_faces, m_borders;         // from the first one to the last one; empty if all of these are borders
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_TRIANGLE_NUMBERING_H
