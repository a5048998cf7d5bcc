// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_CORNER_TABLE_H
#define CGAL_COMPACT_SURFACE_MESH_CORNER_TABLE_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Mesh_defect_exception.h>
#include <CGAL/Compact_surface_mesh/internal/Emptied_on_move.h>
#include <CGAL/Compact_surface_mesh/internal/Graph_faces.h>
#include <CGAL/Compact_surface_mesh/internal/Halfedge_matching.h>
#include <CGAL/Compact_surface_mesh/internal/Paired_corners.h>
#include <CGAL/Compact_surface_mesh/internal/Polygon_list.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

template <class Index>
class Closed_triangulation;
template <class Index>
class Simple_triangulation;
namespace internal {
template <class Index>
class Breadth_first_renumbering;
}

/*!
\ingroup PkgCompactSurfaceMeshRef

The class `Corner_table` is the explicit connectivity of an oriented manifold
triangle mesh, with or without borders: two indices per corner, as in
Rossignac's Corner Table (J. Rossignac, <em>Triangle meshes</em>, Handbook of
Discrete and Computational Geometry). It is the road by which every mesh enters
this package, and finds every defect on the way.

Triangle `f` owns the corners `3f`, `3f+1` and `3f+2`, counterclockwise. Corner `c`
also names the halfedge that starts there: from `source(c)`, the vertex of the
corner, to the vertex of corner `next(c)`, with the triangle on its left.

\tparam Index an unsigned integer type. A mesh with `n` vertices and `f` faces needs
`n` and `3f` to be smaller than the largest value of `Index`.
*/
template <class Index = std::uint32_t>
class Corner_table
{
  static_assert(std::is_unsigned<Index>::value, "Index must be an unsigned integer type");

public:
  /// returns the index of no element.
  static constexpr Index null() { return (std::numeric_limits<Index>::max)(); }

  /// \name Construction
  /// Both constructors take linear time, whatever the degrees of the vertices, and
  /// two words per vertex beside the table. Both accept vertices with several fans
  /// of triangles, provided that all of them are open, and isolated vertices.
  ///
  /// \throws Mesh_defect_exception if the triangles are no oriented manifold.
  /// @{

  /// creates the empty table.
  Corner_table() = default;

  /*!
  builds the table of a triangle soup.

  \tparam TriangleRange a range of ranges of three integers each
  \param num_vertices the number of vertices; indices are smaller than this
  \param triangles the triangles, each counterclockwise
  */
  template <class TriangleRange>
  Corner_table(std::size_t num_vertices, const TriangleRange& triangles)
  {
    internal::Polygon_list<Index> list(
      num_vertices, static_cast<std::size_t>(std::distance(std::begin(triangles), std::end(triangles))));
    for (const auto& triangle : triangles)
      list.append_triangle(triangle);
    take_triangles(list);
    internal::match_halfedges<Index>(*this);
  }

  /*!
  builds the table of a triangulated mesh. Triangle `i` is the `i`-th face `f` in
  the order of `faces(g)`, and the halfedge `3i` is `halfedge(f, g)`.

  \tparam FaceGraph a model of `FaceListGraph`
  \tparam VertexIndexMap a readable property map from vertices to integers
  \param g the mesh
  \param vertex_index numbers the vertices of `g` from 0 without holes

  No two edges of `g` may have the same ends; `Simple_triangulation` takes them.
  */
  template <class FaceGraph, class VertexIndexMap
#ifndef DOXYGEN_RUNNING
            , std::enable_if_t<!std::is_integral<FaceGraph>::value, int> = 0
#endif
            >
  Corner_table(const FaceGraph& g, const VertexIndexMap& vertex_index)
  {
    internal::Graph_faces<FaceGraph, VertexIndexMap> graph_faces(g, vertex_index);
    internal::Polygon_list<Index> list = graph_faces.template read<Index>(true);
    take_triangles(list);
    internal::Halfedge_matching<Index, Corner_table> matching(*this);
    if (!graph_faces.pair_by_ends(matching, *this))
      throw Mesh_defect_exception(Mesh_defect::double_edge,
                                  matching.has_conflict() ? matching.face_of_conflict()
                                                          : graph_faces.triangle_at_false_pair(*this));
    matching.check_vertices();
  }

  /// @}

  /// \name Counts
  /// in constant time.
  /// @{

  /// returns the number of vertices, isolated ones included.
  std::size_t num_vertices() const { return m_num_vertices; }
  /// returns the number of triangles.
  std::size_t num_faces() const { return m_corner.size() / 3; }
  /// returns the number of halfedges that have a triangle, which is that of corners.
  std::size_t num_halfedges() const { return m_corner.size(); }
  /// returns the number of bytes that the table has allocated.
  std::size_t bytes() const { return m_corner.capacity() * sizeof(internal::Paired_corner<Index>); }
  /// @}

  /// \name Halfedges
  /// All in constant time.
  /// @{

  /// returns the corner, and halfedge, that follows `h` counterclockwise in its triangle.
  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  /// returns the corner, and halfedge, that precedes `h` counterclockwise in its triangle.
  static Index prev(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  /// returns the triangle of `h`.
  static Index face(Index h) { return h / 3; }
  /// returns the vertex where `h` starts.
  Index source(Index h) const { return vertex(h); }
  /// returns the vertex where `h` ends.
  Index target(Index h) const { return vertex(next(h)); }
  /// returns the halfedge of the same edge in the other direction, `null()` on a border.
  Index opposite(Index h) const { return m_corner[h].opposite; }
  /// returns the next halfedge out of `source(h)` counterclockwise, `null()` behind a border.
  Index next_around_source(Index h) const { return opposite(prev(h)); }

  /// @}

  /// \name Rossignac's Operators
  /// @{

  /// returns the vertex of corner `c` (operator v).
  Index vertex(Index c) const { return m_corner[c].vertex; }
  /// returns the corner opposite to `c` across the edge that it sees (operator o), `null()` on a border.
  Index opposite_corner(Index c) const
  {
    const Index h = opposite(next(c));
    return h == null() ? null() : prev(h);
  }
  /// returns the corner opposite to the previous one (operator l of the chapter cited above), `null()` on a border.
  Index left_corner(Index c) const { return opposite_corner(prev(c)); }
  /// returns the corner opposite to the next one (operator r), `null()` on a border.
  Index right_corner(Index c) const { return opposite_corner(next(c)); }
  /// returns the next corner at the vertex of `c`, counterclockwise (operator s), `null()` behind a border.
  Index swing(Index c) const { return next_around_source(c); }

  /// @}

  /// \name Hidden Vertices
  /// What closes the table, and parts its vertices, so that it is simple and has no border.
  /// @{

  /// appends a vertex without faces and returns it.
  /// \throws Mesh_defect_exception if `Index` cannot number it
  Index add_vertex()
  {
    if (m_num_vertices + 1 >= null())
      throw Mesh_defect_exception(Mesh_defect::too_many_elements, m_num_vertices + 1);
    return static_cast<Index>((*m_num_vertices)++);
  }

  /// makes room for as many further faces.
  /// \throws Mesh_defect_exception if `Index` cannot number them
  void reserve_further_faces(std::size_t n)
  {
    if (n > (null() - 1 - num_halfedges()) / 3)
      throw Mesh_defect_exception(Mesh_defect::too_many_elements, num_faces() + n);
    m_corner.reserve(m_corner.size() + 3 * n);
  }

  /*!
  splits face `f` = (`a`,`b`,`c`) by a new vertex `x` into (`a`,`b`,`x`), which keeps the
  index `f`, and two faces at the end, (`b`,`c`,`x`) and (`c`,`a`,`x`). The halfedges of
  the three edges of `f` become `3f`, and the first ones of the two new faces.
  \returns `x`
  \throws Mesh_defect_exception if `Index` cannot number the new elements
  */
  Index split_face(Index f)
  {
    reserve_further_faces(2);
    const Index x = add_vertex();
    const Index h = 3 * f, bc = static_cast<Index>(num_halfedges()), ca = bc + 3;
    const Index b = vertex(h + 1), c = vertex(h + 2), a = vertex(h);
    append_triangle(b, c, x);
    append_triangle(c, a, x);
    set_vertex(h + 2, x);
    move_halfedge(h + 1, bc);
    move_halfedge(h + 2, ca);
    pair(h + 1, bc + 2);
    pair(bc + 1, ca + 2);
    pair(ca + 1, h + 2);
    return x;
  }

  /// returns where `split_face()` put halfedge `h` of the face that it split.
  Index halfedge_of_split_face(Index h) const
  {
    return h % 3 == 0 ? h : (h % 3 == 1 ? opposite(h) - 2 : opposite(h) - 1);
  }

  /// undoes `split_face(f)`, but for the two faces and the vertex at the end.
  void unsplit_face(Index f)
  {
    const Index h = 3 * f, bc = halfedge_of_split_face(h + 1), ca = halfedge_of_split_face(h + 2);
    set_vertex(h + 2, vertex(ca));
    move_halfedge(bc, h + 1);
    move_halfedge(ca, h + 2);
  }

  /*!
  closes the border along which `h` lies, by triangles at the end that join it to a new vertex.
  The first one is opposite to `h`, and each of them starts with a halfedge of the border.
  \returns the new vertex
  \throws Mesh_defect_exception if `Index` cannot number the new elements
  \pre `h` has no opposite, and its border passes no vertex twice.
  */
  Index close_border(Index h)
  {
    const Index x = add_vertex();
    const Index first = static_cast<Index>(num_halfedges());
    Index g = h;
    do {
      if (m_corner.size() + 3 >= null())
        throw Mesh_defect_exception(Mesh_defect::too_many_elements, num_faces() + 1);
      const Index u = source(g);
      const Index added = static_cast<Index>(m_corner.size());
      append_triangle(target(g), u, x);
      const Index closed = g;
      g = prev(last_around_source(g));
      if (added == first) // h shows the end of the border as long as it has no opposite
        continue;
      pair(added - 2, added + 2);
      pair(closed, added);
    } while (g != h);
    pair(static_cast<Index>(m_corner.size()) - 2, first + 2);
    pair(h, first);
    return x;
  }

  /// returns the last halfedge counterclockwise, from `h` on, out of `source(h)`, which lies on a border.
  Index last_around_source(Index h) const
  {
    for (Index g = next_around_source(h); g != null(); g = next_around_source(g))
      h = g;
    return h;
  }

  /// gives corner `c` to vertex `v`.
  void set_vertex(Index c, Index v) { m_corner[c].vertex = v; }

  /// removes all but the first `num_vertices` vertices and `num_faces` faces; the remaining
  /// faces may not use the other vertices.
  void resize(std::size_t num_vertices, std::size_t num_faces)
  {
    for (std::size_t h = 3 * num_faces; h < num_halfedges(); ++h) {
      const Index o = opposite(static_cast<Index>(h));
      if (o < 3 * num_faces && opposite(o) == h)
        set_opposite(o, null());
    }
    m_corner.resize(3 * num_faces);
    m_num_vertices = num_vertices;
  }

  /// @}

private:
  friend class Closed_triangulation<Index>;
  friend class Simple_triangulation<Index>;
  friend class internal::Breadth_first_renumbering<Index>;
  friend class internal::Halfedge_matching<Index, Corner_table>;

  // Takes the list apart. Halfedges remain to be paired.
  void take_triangles(internal::Polygon_list<Index>& list)
  {
    m_num_vertices = list.num_vertices();
    m_corner = list.release_corners();
  }

  // Appends a triangle whose halfedges have no opposites.
  void append_triangle(Index a, Index b, Index c)
  {
    m_corner.insert(m_corner.end(), { { a, null() }, { b, null() }, { c, null() } });
  }

  void set_opposite(Index h, Index opposite) { m_corner[h].opposite = opposite; }

  void pair(Index g, Index h)
  {
    set_opposite(g, h);
    set_opposite(h, g);
  }

  // The edge of halfedge `from` is that of halfedge `to` from now on.
  void move_halfedge(Index from, Index to)
  {
    const Index o = opposite(from);
    set_opposite(to, o);
    if (o != null())
      set_opposite(o, to);
  }

  internal::Emptied_on_move<std::size_t> m_num_vertices;
  internal::Paired_corners<Index> m_corner;
};

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_CORNER_TABLE_H
