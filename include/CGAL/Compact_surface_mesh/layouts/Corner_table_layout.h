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
#include <CGAL/Compact_surface_mesh/Input_images.h>
#include <CGAL/Compact_surface_mesh/internal/Emptied_on_move.h>
#include <CGAL/Compact_surface_mesh/internal/Large_array.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Bordered_corners.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Corner_layout.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {

namespace internal {

// The corner table of the input as it is, and a halfedge of each vertex: see Bordered_corners.
template <class Index_>
class Explicit_corners
{
  typedef Corner_table<Index_> Table;

public:
  typedef Index_ Index;

  Explicit_corners() = default;

  Explicit_corners(Closed_triangulation<Index>& t, Corner_images<Index>& images)
    : m_num_vertices(t.first_copy())
  {
    images.vertices.resize(m_num_vertices);
    std::iota(images.vertices.begin(), images.vertices.end(), Index(0));
    const std::size_t first_copy = t.first_copy(), num_sides = 3 * t.num_open_faces();
    const std::vector<Index> copies = t.copies();
    m_table = t.release_table();
    m_halfedge.assign(m_num_vertices, Table::null());
    for (std::size_t i = 0; i < m_table.num_halfedges(); i += i < num_sides ? 1 : 3) { // those of borders last
      const Index c = static_cast<Index>(i), v = m_table.target(c);
      if (v < first_copy)
        m_halfedge[v] = c;
    }
    if (copies.empty())
      return;
    for (Index c = 0; c < m_table.num_halfedges(); ++c) {
      const std::size_t v = m_table.vertex(c);
      if (first_copy <= v && v < first_copy + copies.size())
        m_table.set_vertex(c, copies[v - first_copy]);
    }
  }

  std::size_t num_vertices() const { return m_num_vertices; }
  std::size_t num_triangles() const { return m_table.num_faces(); }

  Index opposite(Index c) const { return m_table.opposite(c); }
  Index source(Index c) const { return m_table.source(c); }
  Index target(Index c) const { return m_table.target(c); }
  Index halfedge_of_vertex(Index v) const { return m_halfedge[v]; }

  std::vector<std::pair<std::string, std::size_t>> memory() const
  {
    return { { "corners", m_table.bytes() }, { "halfedges of vertices", m_halfedge.capacity() * sizeof(Index) } };
  }

private:
  Table m_table;
  Emptied_on_move<std::size_t> m_num_vertices;
  internal::Large_array<Index> m_halfedge; // one with target v, on a border if there is one
};

} // namespace internal

/*!
\ingroup PkgCompactSurfaceMeshRef

The class `Corner_table_layout` stores the connectivity of a mesh as it came: the two
indices per corner of a `Corner_table`, a halfedge per vertex, and a bit per
halfedge with its rank directory for the numbering of edges. That is 13.2 references per
vertex, 52.9 bytes for a 32-bit `Index`, and six references more for an edge of a border.

It keeps the order of the input's vertices and faces, and is there to compare with.

\tparam Index_ an unsigned integer type

\cgalModels{CompactSurfaceMeshLayout}
*/
template <class Index_ = std::uint32_t>
class Corner_table_layout
#ifndef DOXYGEN_RUNNING
  : public internal::Corner_layout<internal::Explicit_corners<Index_>>
#endif
{
  typedef internal::Corner_layout<internal::Explicit_corners<Index_>> Base;

public:
  /// the integer type of all indices.
  typedef Index_ Index;

  /// returns `"corner-table"`.
  static std::string name() { return "corner-table"; }
  /// returns the largest number of vertices of a sphere for which `Index` is wide enough.
  // the 6n - 12 halfedges, and six more while the triangulation is closed, are below the null index
  static std::size_t max_vertices() { return std::size_t(Base::null_index()) / 6 + 1; }

  /// creates the layout of the empty mesh.
  Corner_table_layout() = default;

  /*!
  takes the table of `t` over in linear time; vertices and faces keep their indices.
  \param t the triangulation; it is empty afterwards
  \param images tells what becomes of the elements of the input
  */
  Corner_table_layout(Closed_triangulation<Index>&& t, Input_images<Index>& images)
    : Base(std::move(t), images)
  {}
};

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_CORNER_TABLE_LAYOUT_H
