// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_CORNER_TABLE_LAYOUT_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_CORNER_TABLE_LAYOUT_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/Corner_table.h>
#include <CGAL/Compact_surface_mesh/internal/Ranked_bits.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgCompactSurfaceMeshRef

The class `Corner_table_layout` stores the connectivity of a triangle mesh as it came: the
two indices per corner of a `Corner_table`, a halfedge per vertex, and a bit per
halfedge with its rank directory for the numbering of edges. That is 13.2 references per
vertex, 52.9 bytes for a 32-bit `Index`.

It keeps the order of the input's vertices and faces, and is there to compare with.

\tparam Index_ an unsigned integer type

\cgalModels{CompactSurfaceMeshLayout}
*/
template <class Index_ = std::uint32_t>
class Corner_table_layout
{
  typedef Corner_table<Index_> Table;

public:
  /// the integer type of all indices.
  typedef Index_ Index;

  /// whether `edge(h) == h / 2` and `opposite(h) == (h ^ 1)`.
  static constexpr bool edge_is_half_of_halfedge = false;

  /// returns the index of no element: the largest value of `Index`.
  static constexpr Index null_index() { return Table::null(); }
  /// returns `"corner-table"`.
  static std::string name() { return "corner-table"; }
  /// returns the largest number of vertices for which `Index` is wide enough.
  // the 6n - 12 halfedges, and six more while the triangulation is closed, are below the null index
  static std::size_t max_vertices() { return std::size_t(null_index()) / 6 + 1; }

  /// creates the layout of the empty mesh.
  Corner_table_layout() = default;

  /*!
  takes the table of `t` over in linear time; vertices keep their indices.
  \param t the triangulation; it is empty afterwards
  \param vertex_of_input gets, appended, the indices of the vertices: 0, 1, 2 and so on
  */
  Corner_table_layout(Closed_triangulation<Index>&& t, std::vector<Index>& vertex_of_input)
    : m_table(t.release()), m_halfedge(m_table.num_vertices(), null_index())
  {
    for (std::size_t h = 0; h < m_table.num_halfedges(); ++h)
      m_halfedge[m_table.target(static_cast<Index>(h))] = static_cast<Index>(h);
    m_first_of_edge = internal::Ranked_bits(
        m_table.num_halfedges(), [this](std::size_t h) { return h < m_table.opposite(static_cast<Index>(h)); });
    for (std::size_t v = 0; v < m_table.num_vertices(); ++v)
      vertex_of_input.push_back(static_cast<Index>(v));
  }

  /// \name Counts
  /// in constant time.
  /// @{

  /// returns the number of vertices.
  std::size_t num_vertices() const { return m_table.num_vertices(); }
  /// returns the number of halfedges.
  std::size_t num_halfedges() const { return m_table.num_halfedges(); }
  /// returns the number of edges.
  std::size_t num_edges() const { return m_first_of_edge.count(); }
  /// returns the number of faces.
  std::size_t num_faces() const { return m_table.num_faces(); }
  /// @}

  /// \name Navigation
  /// in constant time, unless said otherwise.
  /// @{

  /// returns the next halfedge counterclockwise around the face of `h`.
  static Index next(Index h) { return Table::next(h); }
  /// returns the halfedge whose next one is `h`.
  static Index prev(Index h) { return Table::prev(h); }
  /// returns the other halfedge of the edge of `h`.
  Index opposite(Index h) const { return m_table.opposite(h); }
  /// returns the vertex where `h` starts.
  Index source(Index h) const { return m_table.source(h); }
  /// returns the vertex where `h` ends.
  Index target(Index h) const { return m_table.target(h); }
  /// returns the face to the left of `h`.
  static Index face(Index h) { return Table::face(h); }
  /// returns the edge of `h`, by the rank of a bit.
  Index edge(Index h) const
  {
    return static_cast<Index>(m_first_of_edge.rank((std::min)(h, m_table.opposite(h))));
  }
  /// returns the halfedge of `e` with the smaller index, in logarithmic time by the selection of a bit.
  Index halfedge_of_edge(Index e) const { return static_cast<Index>(m_first_of_edge.select(e)); }
  /// returns a halfedge whose target is `v`, always the same.
  Index halfedge_of_vertex(Index v) const { return m_halfedge[v]; }
  /// returns the first halfedge of `f`, `3f`.
  static Index halfedge_of_face(Index f) { return 3 * f; }
  /// returns the halfedge from `u` to `v`, `null_index()` if they are not adjacent, in time
  /// linear in the smaller degree.
  Index halfedge(Index u, Index v) const
  {
    const Index first_out = m_table.next(m_halfedge[u]), first_in = m_halfedge[v];
    Index out = first_out, in = first_in;
    do {
      if (target(out) == v)
        return out;
      if (source(in) == u)
        return in;
      out = m_table.next_around_source(out);
      in = m_table.opposite(m_table.next(in));
    } while (out != first_out && in != first_in);
    return null_index();
  }
  /// @}

  /// \name Whole Stars
  /// @{

  /// calls `visit(u)` for each vertex `u` adjacent to `v`, once each, in no particular order.
  template <class Visitor>
  void for_each_adjacent_vertex(Index v, Visitor&& visit) const
  {
    const Index first = m_table.next(m_halfedge[v]);
    Index h = first;
    do {
      visit(target(h));
      h = m_table.next_around_source(h);
    } while (h != first);
  }

  /// calls `visit(u, w)` for each face (`v`,`u`,`w`), counterclockwise, at `v`, once each, in
  /// no particular order.
  template <class Visitor>
  void for_each_incident_triangle(Index v, Visitor&& visit) const
  {
    const Index first = m_table.next(m_halfedge[v]);
    Index h = first;
    do {
      const Index opposite_edge = m_table.next(h);
      visit(source(opposite_edge), target(opposite_edge));
      h = m_table.next_around_source(h);
    } while (h != first);
  }

  /// returns the number of edges at `v`, in time linear in that number.
  Index degree(Index v) const
  {
    Index d = 0;
    for_each_adjacent_vertex(v, [&d](Index) { ++d; });
    return d;
  }

  /// returns the vertices of `f` counterclockwise, from the target of `halfedge_of_face(f)` on.
  std::array<Index, 3> vertices_of_face(Index f) const
  {
    return { m_table.source(3 * f + 1), m_table.source(3 * f + 2), m_table.source(3 * f) };
  }
  /// @}

  /// \name Memory
  /// @{

  /// returns the arrays that the layout holds, with the bytes that they have allocated.
  std::vector<std::pair<std::string, std::size_t>> memory() const
  {
    return { { "corners", m_table.bytes() },
             { "halfedges of vertices", m_halfedge.capacity() * sizeof(Index) },
             { "edge bits", m_first_of_edge.bytes() } };
  }

  /// @}

private:
  Table m_table;
  std::vector<Index> m_halfedge;        // one with target v
  internal::Ranked_bits m_first_of_edge; // the halfedges with h < opposite(h)
};

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_CORNER_TABLE_LAYOUT_H
