// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_CORNER_LAYOUT_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_CORNER_LAYOUT_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/Input_images.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Bordered_corners.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Mask.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Ranked_edges.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Triangle_numbering.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/around_vertex.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/for_each_face_from.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

/*!
The class `Corner_layout` makes a layout of a table of corners over a closed triangulation: it
adds what is not of the table's concern, which are borders, vertices with several fans, polygons and
double edges, and the numbering of edges, by a bit per halfedge with its rank directory. A layout
that derives from it adds its name and the largest number of its vertices.

\tparam Table see `Bordered_corners`
\tparam Numbering numbers triangles
\tparam Edges numbers edges
*/
template <class Table, class Numbering = Triangle_numbering<typename Table::Index>,
          class Edges = Ranked_edges<typename Table::Index>>
class Corner_layout
{
  typedef internal::Bordered_corners<Table, Numbering> Corners;

public:
  /// the integer type of all indices.
  typedef typename Table::Index Index;
  /// names a halfedge: its index.
  typedef Index Halfedge;

  /// whether `edge(h) == h / 2` and `opposite(h) == (h ^ 1)`.
  static constexpr bool edge_is_half_of_halfedge = false;

  /// returns the index of no element: the largest value of `Index`.
  static constexpr Index null_index() { return Corners::null(); }

  /// creates the layout of the empty mesh.
  Corner_layout() = default;

  /*!
  builds the table of `t`, and what stands beside it in linear time.
  \param t the triangulation; it is empty afterwards
  \param images tells what becomes of the elements of the input
  */
  Corner_layout(Closed_triangulation<Index>&& t, Input_images<Index>& images)
  {
    t.remove_caps();
    const std::size_t num_sides = 3 * t.num_open_faces();
    Corner_images<Index> of_table;
    m_corners = Corners(t, of_table);
    std::vector<Index> halfedges; // of the corners that faces have
    if (images.wants_halfedges || t.simple().has_hidden()) {
      halfedges.resize(num_sides);
      for (std::size_t c = 0; c < num_sides; ++c)
        halfedges[c] = m_corners.halfedge_at(of_table.corners.empty() ? static_cast<Index>(c) : of_table.corners[c]);
    }
    of_table.corners = std::vector<Index>();
    if (t.simple().has_hidden())
      m_mask = Mask(m_corners, t, of_table.vertices, halfedges);
    m_mask.write_images(t, std::move(of_table.vertices), halfedges, images);
    t = Closed_triangulation<Index>();
    m_edges = Edges(*this, m_corners, !m_mask.empty());
  }

  /// \name Counts
  /// in constant time.
  /// @{

  /// returns the number of vertices.
  std::size_t num_vertices() const { return m_mask.empty() ? m_corners.num_vertices() : m_mask.num_vertices(); }
  /// returns the number of halfedges.
  std::size_t num_halfedges() const { return m_mask.empty() ? m_corners.num_halfedges() : m_mask.num_halfedges(); }
  /// returns the number of edges.
  std::size_t num_edges() const { return m_edges.count(); }
  /// returns the number of faces.
  std::size_t num_faces() const { return m_mask.empty() ? m_corners.num_faces() : m_mask.num_faces(); }
  /// @}

  /// \name Navigation
  /// in constant time, unless said otherwise.
  /// @{

  /// returns the next halfedge counterclockwise around the face of `h`.
  BOOST_FORCEINLINE Index next(Index h) const
  {
    return m_mask.empty() ? m_corners.next(h) : masked([this, h] { return m_mask.next(m_corners, h); });
  }
  /// returns the halfedge whose next one is `h`.
  BOOST_FORCEINLINE Index prev(Index h) const
  {
    return m_mask.empty() ? m_corners.prev(h) : masked([this, h] { return m_mask.prev(m_corners, h); });
  }
  /// returns the other halfedge of the edge of `h`.
  BOOST_FORCEINLINE Index opposite(Index h) const
  {
    return m_mask.empty() ? m_corners.opposite(h) : masked([this, h] { return m_mask.opposite(m_corners, h); });
  }
  /// returns the vertex where `h` starts.
  BOOST_FORCEINLINE Index source(Index h) const
  {
    return m_mask.empty() ? m_corners.source(h) : masked([this, h] { return m_mask.source(m_corners, h); });
  }
  /// returns the vertex where `h` ends.
  BOOST_FORCEINLINE Index target(Index h) const
  {
    return m_mask.empty() ? m_corners.target(h) : masked([this, h] { return m_mask.target(m_corners, h); });
  }
  /// returns the face to the left of `h`, `null_index()` on a border.
  BOOST_FORCEINLINE Index face(Index h) const
  {
    return m_mask.empty() ? m_corners.face(h) : masked([this, h] { return m_mask.face(m_corners, h); });
  }
  /// returns whether `h` is known to be a side of a triangle: always so in meshes without polygons.
  bool is_in_triangle(Index h) const
  {
    return m_mask.empty() && h != null_index() && m_corners.face(h) != null_index();
  }
  /// returns the vertices of the triangle of `h` counterclockwise, from its target on, if `is_in_triangle(h)`.
  BOOST_FORCEINLINE std::array<Index, 3> vertices_of_triangle(Index h) const
  {
    return { target(h), target(next(h)), source(h) };
  }
  /// returns the edge of `h`, as `Edges` numbers it: by the rank of a bit, unless the layout says otherwise.
  Index edge(Index h) const { return m_edges.edge(*this, m_corners, h); }
  /// returns a halfedge of `e`, always the same: in logarithmic time by the selection of a bit, likewise.
  Index halfedge_of_edge(Index e) const { return m_edges.halfedge(m_corners, e); }
  /// returns a halfedge whose target is `v`, always the same: a border halfedge if `v` lies on a
  /// border, `null_index()` if `v` is isolated.
  BOOST_FORCEINLINE Index halfedge_of_vertex(Index v) const
  {
    return m_mask.empty() ? m_corners.halfedge_of_vertex(v)
                          : masked([this, v] { return m_mask.halfedge_of_vertex(m_corners, v); });
  }
  /// returns a halfedge of `f`, always the same.
  BOOST_FORCEINLINE Index halfedge_of_face(Index f) const
  {
    return m_mask.empty() ? m_corners.halfedge_of_face(f)
                          : masked([this, f] { return m_mask.halfedge_of_face(m_corners, f); });
  }
  /// returns the halfedge from `u` to `v`, `null_index()` if they are not adjacent, in time
  /// linear in the smaller degree.
  Index halfedge(Index u, Index v) const
  {
    return m_mask.empty() ? m_corners.halfedge(u, v) : m_mask.halfedge(m_corners, u, v);
  }
  /// @}

  /// \name Whole Stars
  /// @{

  /// calls `visit(u)` for each vertex `u` adjacent to `v`, once each, in no particular order.
  template <class Visitor>
  void for_each_adjacent_vertex(Index v, Visitor&& visit) const
  {
    internal::for_each_halfedge_into(*this, v, [&](Index h) { visit(source(h)); });
  }

  /// calls `visit(u, w)` for each face at `v`, once each, in no particular order, where `u` follows
  /// and `w` precedes `v` in the face counterclockwise: a triangle is (`v`,`u`,`w`).
  template <class Visitor>
  void for_each_incident_triangle(Index v, Visitor&& visit) const
  {
    internal::for_each_corner_at(*this, v, visit);
  }

  /// returns the number of edges at `v`, in time linear in that number.
  Index degree(Index v) const
  {
    Index d = 0;
    internal::for_each_halfedge_into(*this, v, [&d](Index) { ++d; });
    return d;
  }

  /// returns the target of `halfedge_of_face(f)`.
  Index vertex_of_face(Index f) const { return target(halfedge_of_face(f)); }

  /// returns the vertices of `f` counterclockwise, from the target of `halfedge_of_face(f)` on;
  /// of a polygon, only the first three.
  std::array<Index, 3> vertices_of_face(Index f) const
  {
    const Index h = halfedge_of_face(f), g = next(h);
    return { target(h), target(g), target(next(g)) };
  }

  /// calls `visit(f, u, v, w)` for each face `f` in their order, where `u`, `v`, `w` are `vertices_of_face(f)`.
  template <class Visitor>
  void for_each_face(Visitor&& visit) const
  {
    internal::for_each_face_from(0, *this, visit);
  }
  /// @}

  /// \name Memory
  /// @{

  /// returns the arrays that the layout holds, with the bytes that they have allocated.
  std::vector<std::pair<std::string, std::size_t>> memory() const
  {
    std::vector<std::pair<std::string, std::size_t>> arrays = m_corners.table().memory();
    arrays.emplace_back("border bits", m_corners.border_bytes());
    arrays.emplace_back("fans of vertices", m_corners.fan_bytes());
    arrays.emplace_back("edge bits", m_edges.bytes());
    arrays.emplace_back("mask of polygons", m_mask.bytes());
    return arrays;
  }

  /// @}

protected:
  /// returns the table.
  const Table& table() const { return m_corners.table(); }

private:
  typedef internal::Mask<Index, false> Mask;

  // Keeps the walks of the mask out of the code that has none.
  template <class Answer>
  BOOST_NOINLINE static Index masked(const Answer& answer)
  {
    return answer();
  }

  Corners m_corners;
  Mask m_mask;
  Edges m_edges;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_CORNER_LAYOUT_H
