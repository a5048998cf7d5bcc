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
#include <CGAL/Compact_surface_mesh/internal/Ranked_bits.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Mask.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/around_vertex.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {

namespace internal {

// The operators of a corner table in which every border is closed by triangles around an apex. The
// i-th of these triangles stands for a halfedge of a border, the one behind those of the faces.
template <class Index>
class Bordered_corner_table
{
  typedef Corner_table<Index> Table;

public:
  Bordered_corner_table() = default;

  explicit Bordered_corner_table(Closed_triangulation<Index>& t)
    : m_num_vertices(t.first_copy()), m_num_sides(static_cast<Index>(3 * t.num_open_faces()))
  {
    t.remove_caps();
    const std::size_t first_copy = t.first_copy();
    const std::vector<Index> copies = t.copies();
    m_table = t.release_table();
    m_halfedge.assign(m_num_vertices, null());
    std::vector<std::pair<Index, Index>> fans; // a vertex, and the border halfedge into one of its fans
    for (Index h = 0; h < num_halfedges(); ++h) {
      const Index v = m_table.target(corner(h));
      if (v < first_copy)
        m_halfedge[v] = h;
      if (h >= m_num_sides && !copies.empty())
        fans.emplace_back(v < first_copy ? v : copies[v - first_copy], h);
    }
    if (copies.empty())
      return;
    for (Index c = 0; c < m_table.num_halfedges(); ++c) {
      const std::size_t v = m_table.vertex(c);
      if (first_copy <= v && v < first_copy + copies.size())
        m_table.set_vertex(c, copies[v - first_copy]);
    }
    link_fans(fans);
  }

  static constexpr Index null() { return Table::null(); }
  static constexpr Index null_index() { return null(); }

  std::size_t num_vertices() const { return m_num_vertices; }
  std::size_t num_halfedges() const { return m_num_sides + (m_table.num_halfedges() - m_num_sides) / 3; }
  std::size_t num_faces() const { return m_num_sides / 3; }

  Index next(Index h) const { return h < m_num_sides ? Table::next(h) : next_on_border(h); }
  Index prev(Index h) const { return h < m_num_sides ? Table::prev(h) : prev_on_border(h); }
  Index opposite(Index h) const { return halfedge_of_corner(m_table.opposite(corner(h))); }
  Index source(Index h) const { return m_table.source(corner(h)); }
  Index target(Index h) const { return m_table.target(corner(h)); }
  Index face(Index h) const { return h < m_num_sides ? Table::face(h) : null(); }
  Index halfedge_of_vertex(Index v) const { return m_halfedge[v]; }
  static Index halfedge_of_face(Index f) { return 3 * f; }

  Index halfedge(Index u, Index v) const
  {
    const Index out = m_halfedge[u], in = m_halfedge[v];
    if (out == null() || in == null())
      return null();
    Index g = out, h = in; // into u and v
    do {
      if (source(g) == v)
        return opposite(g);
      if (source(h) == u)
        return h;
      g = opposite(next(g));
      h = opposite(next(h));
    } while (g != out && h != in);
    return null();
  }

  std::size_t corner_bytes() const { return m_table.bytes(); }
  std::size_t vertex_bytes() const { return m_halfedge.capacity() * sizeof(Index); }
  std::size_t fan_bytes() const { return (m_next.capacity() + m_prev.capacity()) * sizeof(m_next[0]); }

private:
  Index corner(Index h) const { return h < m_num_sides ? h : 3 * h - 2 * m_num_sides; }
  Index halfedge_of_corner(Index c) const { return c < m_num_sides ? c : (c + 2 * m_num_sides) / 3; }

  // Where a vertex has several fans, borders go from each one to the next.
  void link_fans(std::vector<std::pair<Index, Index>>& into_fans)
  {
    std::sort(into_fans.begin(), into_fans.end());
    for (std::size_t i = 0, end; i < into_fans.size(); i = end) {
      for (end = i; end < into_fans.size() && into_fans[end].first == into_fans[i].first;)
        ++end;
      if (end - i == 1)
        continue;
      for (std::size_t j = i; j < end; ++j) {
        const Index h = into_fans[j].second, g = into_fans[j + 1 == end ? i : j + 1].second;
        m_next.emplace_back(h, next_in_fan(g));
        m_prev.emplace_back(next_in_fan(g), h);
      }
    }
    std::sort(m_next.begin(), m_next.end());
    std::sort(m_prev.begin(), m_prev.end());
  }

  // The neighboring triangle around the apex has the halfedge that follows in the same fan.
  Index next_in_fan(Index h) const { return halfedge_of_corner(Table::next(m_table.opposite(corner(h) + 1))); }
  Index prev_in_fan(Index h) const { return halfedge_of_corner(Table::prev(m_table.opposite(corner(h) + 2))); }

  Index next_on_border(Index h) const { return linked(m_next, h, [&] { return next_in_fan(h); }); }
  Index prev_on_border(Index h) const { return linked(m_prev, h, [&] { return prev_in_fan(h); }); }

  template <class Otherwise>
  static Index linked(const std::vector<std::pair<Index, Index>>& links, Index h, const Otherwise& otherwise)
  {
    if (links.empty())
      return otherwise();
    const auto it = std::lower_bound(links.begin(), links.end(), std::make_pair(h, Index(0)));
    return it == links.end() || it->first != h ? otherwise() : it->second;
  }

  Table m_table;
  Emptied_on_move<std::size_t> m_num_vertices;
  Emptied_on_move<Index> m_num_sides;             // halfedges of faces
  std::vector<Index> m_halfedge;                  // one with target v, on a border if there is one
  std::vector<std::pair<Index, Index>> m_next, m_prev; // between the fans of a vertex, sorted
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
{
  typedef internal::Bordered_corner_table<Index_> Triangles;
  typedef internal::Mask<Index_, false> Mask;

public:
  /// the integer type of all indices.
  typedef Index_ Index;
  /// names a halfedge: its index.
  typedef Index_ Halfedge;

  /// whether `edge(h) == h / 2` and `opposite(h) == (h ^ 1)`.
  static constexpr bool edge_is_half_of_halfedge = false;

  /// returns the index of no element: the largest value of `Index`.
  static constexpr Index null_index() { return Triangles::null(); }
  /// returns `"corner-table"`.
  static std::string name() { return "corner-table"; }
  /// returns the largest number of vertices of a sphere for which `Index` is wide enough.
  // the 6n - 12 halfedges, and six more while the triangulation is closed, are below the null index
  static std::size_t max_vertices() { return std::size_t(null_index()) / 6 + 1; }

  /// creates the layout of the empty mesh.
  Corner_table_layout() = default;

  /*!
  takes the table of `t` over in linear time; vertices and faces keep their indices.
  \param t the triangulation; it is empty afterwards
  \param images tells what becomes of the elements of the input
  */
  Corner_table_layout(Closed_triangulation<Index>&& t, Input_images<Index>& images)
    : m_triangles(t)
  {
    std::vector<Index> vertices(t.first_copy()), halfedges;
    std::iota(vertices.begin(), vertices.end(), Index(0));
    if (images.wants_halfedges || t.simple().has_hidden()) {
      halfedges.resize(m_triangles.num_halfedges());
      std::iota(halfedges.begin(), halfedges.end(), Index(0));
    }
    if (t.simple().has_hidden())
      m_mask = Mask(m_triangles, t, vertices, halfedges);
    m_mask.write_images(t, std::move(vertices), halfedges, images);
    t = Closed_triangulation<Index>();
    m_first_of_edge = internal::Ranked_bits(
        num_halfedges(), [this](std::size_t h) { return h < opposite(static_cast<Index>(h)); });
  }

  /// \name Counts
  /// in constant time.
  /// @{

  /// returns the number of vertices.
  std::size_t num_vertices() const { return m_mask.empty() ? m_triangles.num_vertices() : m_mask.num_vertices(); }
  /// returns the number of halfedges.
  std::size_t num_halfedges() const { return m_mask.empty() ? m_triangles.num_halfedges() : m_mask.num_halfedges(); }
  /// returns the number of edges.
  std::size_t num_edges() const { return m_first_of_edge.count(); }
  /// returns the number of faces.
  std::size_t num_faces() const { return m_mask.empty() ? m_triangles.num_faces() : m_mask.num_faces(); }
  /// @}

  /// \name Navigation
  /// in constant time, unless said otherwise.
  /// @{

  /// returns the next halfedge counterclockwise around the face of `h`.
  Index next(Index h) const { return m_mask.empty() ? m_triangles.next(h) : m_mask.next(m_triangles, h); }
  /// returns the halfedge whose next one is `h`.
  Index prev(Index h) const { return m_mask.empty() ? m_triangles.prev(h) : m_mask.prev(m_triangles, h); }
  /// returns the other halfedge of the edge of `h`.
  Index opposite(Index h) const { return m_mask.empty() ? m_triangles.opposite(h) : m_mask.opposite(m_triangles, h); }
  /// returns the vertex where `h` starts.
  Index source(Index h) const { return m_mask.empty() ? m_triangles.source(h) : m_mask.source(m_triangles, h); }
  /// returns the vertex where `h` ends.
  Index target(Index h) const { return m_mask.empty() ? m_triangles.target(h) : m_mask.target(m_triangles, h); }
  /// returns the face to the left of `h`, `null_index()` on a border.
  Index face(Index h) const { return m_mask.empty() ? m_triangles.face(h) : m_mask.face(m_triangles, h); }
  /// returns whether `h` is known to be a side of a triangle: always so in meshes without polygons.
  bool is_in_triangle(Index h) const { return m_mask.empty() && m_triangles.face(h) != null_index(); }
  /// returns the edge of `h`, by the rank of a bit.
  Index edge(Index h) const { return static_cast<Index>(m_first_of_edge.rank((std::min)(h, opposite(h)))); }
  /// returns the halfedge of `e` with the smaller index, in logarithmic time by the selection of a bit.
  Index halfedge_of_edge(Index e) const { return static_cast<Index>(m_first_of_edge.select(e)); }
  /// returns a halfedge whose target is `v`, always the same: a border halfedge if `v` lies on a
  /// border, `null_index()` if `v` is isolated.
  Index halfedge_of_vertex(Index v) const
  {
    return m_mask.empty() ? m_triangles.halfedge_of_vertex(v) : m_mask.halfedge_of_vertex(m_triangles, v);
  }
  /// returns a halfedge of `f`, always the same.
  Index halfedge_of_face(Index f) const
  {
    return m_mask.empty() ? m_triangles.halfedge_of_face(f) : m_mask.halfedge_of_face(m_triangles, f);
  }
  /// returns the halfedge from `u` to `v`, `null_index()` if they are not adjacent, in time
  /// linear in the smaller degree.
  Index halfedge(Index u, Index v) const
  {
    return m_mask.empty() ? m_triangles.halfedge(u, v) : m_mask.halfedge(m_triangles, u, v);
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

  /// returns the vertices of `f` counterclockwise, from the target of `halfedge_of_face(f)` on;
  /// of a polygon, only the first three.
  std::array<Index, 3> vertices_of_face(Index f) const
  {
    const Index h = halfedge_of_face(f), g = next(h);
    return { target(h), target(g), target(next(g)) };
  }
  /// @}

  /// \name Memory
  /// @{

  /// returns the arrays that the layout holds, with the bytes that they have allocated.
  std::vector<std::pair<std::string, std::size_t>> memory() const
  {
    return { { "corners", m_triangles.corner_bytes() },
             { "halfedges of vertices", m_triangles.vertex_bytes() },
             { "fans of vertices", m_triangles.fan_bytes() },
             { "edge bits", m_first_of_edge.bytes() },
             { "mask of polygons", m_mask.bytes() } };
  }

  /// @}

private:
  Triangles m_triangles;
  Mask m_mask;
  internal::Ranked_bits m_first_of_edge; // the halfedges with h < opposite(h)
};

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_CORNER_TABLE_LAYOUT_H
