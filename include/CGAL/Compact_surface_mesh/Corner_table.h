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

#include <CGAL/boost/graph/properties.h>

#include <boost/container/static_vector.hpp>
#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {

namespace internal {

// The indices of the vertices of face f, from the source of halfedge(f, g) on. There
// are four of them if the face is no triangle: whoever takes triangles only sees it.
template <class Face, class FaceGraph, class VertexIndexMap>
boost::container::static_vector<std::size_t, 4>
vertex_indices_of_face(Face f, const FaceGraph& g, const VertexIndexMap& vertex_index)
{
  boost::container::static_vector<std::size_t, 4> indices;
  const auto first = halfedge(f, g);
  auto h = first;
  do {
    indices.push_back(static_cast<std::size_t>(get(vertex_index, source(h, g))));
    h = next(h, g);
  } while (h != first && indices.size() < 4);
  return indices;
}

} // namespace internal

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
    : m_num_vertices(num_vertices)
  {
    reserve(static_cast<std::size_t>(std::distance(std::begin(triangles), std::end(triangles))));
    for (const auto& triangle : triangles)
      append_triangle(triangle);
    match_halfedges();
  }

  /*!
  builds the table of a triangulated mesh. Triangle `i` is the `i`-th face `f` in
  the order of `faces(g)`, and the halfedge `3i` is `halfedge(f, g)`.

  \tparam FaceGraph a model of `FaceListGraph`
  \tparam VertexIndexMap a readable property map from vertices to integers
  \param g the mesh
  \param vertex_index numbers the vertices of `g` from 0 without holes
  */
  template <class FaceGraph, class VertexIndexMap
#ifndef DOXYGEN_RUNNING
            , std::enable_if_t<!std::is_integral<FaceGraph>::value, int> = 0
#endif
            >
  Corner_table(const FaceGraph& g, const VertexIndexMap& vertex_index)
  {
    const auto vertex_range = vertices(g);
    const auto face_range = faces(g);
    m_num_vertices = static_cast<std::size_t>(std::distance(vertex_range.begin(), vertex_range.end()));
    reserve(static_cast<std::size_t>(std::distance(face_range.begin(), face_range.end())));
    for (const auto f : face_range)
      append_triangle(internal::vertex_indices_of_face(f, g, vertex_index));
    match_halfedges();
  }

  /// @}

  /// \name Counts
  /// in constant time.
  /// @{

  /// returns the number of vertices, isolated ones included.
  std::size_t num_vertices() const { return m_num_vertices; }
  /// returns the number of triangles.
  std::size_t num_faces() const { return m_vertex.size() / 3; }
  /// returns the number of halfedges that have a triangle, which is that of corners.
  std::size_t num_halfedges() const { return m_vertex.size(); }
  /// returns the number of bytes that the table has allocated.
  std::size_t bytes() const { return (m_vertex.capacity() + m_opposite.capacity()) * sizeof(Index); }
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
  Index source(Index h) const { return m_vertex[h]; }
  /// returns the vertex where `h` ends.
  Index target(Index h) const { return m_vertex[next(h)]; }
  /// returns the halfedge of the same edge in the other direction, `null()` on a border.
  Index opposite(Index h) const { return m_opposite[h]; }
  /// returns the next halfedge out of `source(h)` counterclockwise, `null()` behind a border.
  Index next_around_source(Index h) const { return m_opposite[prev(h)]; }

  /// @}

  /// \name Rossignac's Operators
  /// @{

  /// returns the vertex of corner `c` (operator v).
  Index vertex(Index c) const { return m_vertex[c]; }
  /// returns the corner opposite to `c` across the edge that it sees (operator o), `null()` on a border.
  Index opposite_corner(Index c) const
  {
    const Index h = m_opposite[next(c)];
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
  /// @{

  /*!
  splits face `f` = (`a`,`b`,`c`) by a new vertex `x` into (`a`,`b`,`x`), which keeps the
  index `f`, and two faces at the end, (`b`,`c`,`x`) and (`c`,`a`,`x`). The halfedges of
  the three edges of `f` become `3f`, and the first ones of the two new faces.
  \returns `x`
  \throws Mesh_defect_exception if `Index` cannot number the new elements
  */
  Index split_face(Index f)
  {
    if (num_halfedges() + 6 >= null() || m_num_vertices + 1 >= null())
      throw Mesh_defect_exception(Mesh_defect::too_many_elements, num_faces() + 2);
    const Index h = 3 * f, bc = static_cast<Index>(num_halfedges()), ca = bc + 3;
    const Index b = m_vertex[h + 1], c = m_vertex[h + 2], a = m_vertex[h];
    const Index x = static_cast<Index>((*m_num_vertices)++);
    m_vertex.insert(m_vertex.end(), { b, c, x, c, a, x });
    m_opposite.resize(m_vertex.size(), null());
    m_vertex[h + 2] = x;
    move_halfedge(h + 1, bc);
    move_halfedge(h + 2, ca);
    pair(h + 1, bc + 2);
    pair(bc + 1, ca + 2);
    pair(ca + 1, h + 2);
    return x;
  }

  /// undoes the last `split_face()`, which was of face `f`.
  void unsplit_face(Index f)
  {
    const Index h = 3 * f, ca = static_cast<Index>(num_halfedges() - 3), bc = ca - 3;
    m_vertex[h + 2] = m_vertex[ca];
    move_halfedge(bc, h + 1);
    move_halfedge(ca, h + 2);
    m_vertex.resize(bc);
    m_opposite.resize(bc);
    --*m_num_vertices;
  }

  /// @}

private:
  void reserve(std::size_t num_faces)
  {
    const std::size_t limit = null();
    if (m_num_vertices >= limit)
      throw Mesh_defect_exception(Mesh_defect::too_many_elements, m_num_vertices);
    if (num_faces >= limit / 3)
      throw Mesh_defect_exception(Mesh_defect::too_many_elements, num_faces);
    // room for one split_face(), so that closing a mesh does not copy it
    m_vertex.reserve(3 * num_faces + 6);
  }

  template <class Triangle>
  void append_triangle(const Triangle& triangle)
  {
    const std::size_t f = num_faces();
    std::size_t size = 0;
    std::size_t v[3];
    for (const auto& i : triangle) {
      if (size == 3)
        throw Mesh_defect_exception(Mesh_defect::not_a_triangle, f);
      v[size++] = static_cast<std::size_t>(i);
    }
    if (size != 3)
      throw Mesh_defect_exception(Mesh_defect::not_a_triangle, f);
    for (std::size_t i : v)
      if (i >= m_num_vertices)
        throw Mesh_defect_exception(Mesh_defect::index_out_of_range, f);
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
      throw Mesh_defect_exception(Mesh_defect::repeated_vertex, f);
    for (std::size_t i : v)
      m_vertex.push_back(static_cast<Index>(i));
  }

  // Pairs the halfedges vertex by vertex: those that end at v are noted at their
  // sources, where those that start at v find them. Until the turn of its vertex
  // comes, the entry of a corner in m_opposite links the corners of that vertex.
  void match_halfedges()
  {
    std::vector<Index> corner(m_num_vertices, null()), incoming(m_num_vertices, null());
    m_opposite.reserve(m_vertex.capacity());
    m_opposite.resize(m_vertex.size());
    for (std::size_t i = m_vertex.size(); i-- > 0;) {
      m_opposite[i] = corner[m_vertex[i]];
      corner[m_vertex[i]] = static_cast<Index>(i);
    }

    const auto note = [&](Index v, Index u) { return incoming[u] != null() && target(incoming[u]) == v; };
    for (std::size_t i = 0; i < m_num_vertices; ++i) {
      const Index v = static_cast<Index>(i);
      for (Index c = corner[v]; c != null(); c = m_opposite[c]) {
        const Index u = m_vertex[prev(c)];
        if (note(v, u))
          throw Mesh_defect_exception(edge_defect(corner[v], u), face(c));
        incoming[u] = prev(c);
      }
      for (Index c = corner[v], following; c != null(); c = following) {
        following = m_opposite[c];
        const Index w = target(c);
        m_opposite[c] = note(v, w) ? incoming[w] : null();
      }
    }
    check_vertices(corner, incoming);
  }

  // What is wrong with the edge between u and the vertex whose corners are listed
  // from first on: two of its halfedges have the same direction.
  Mesh_defect edge_defect(Index first, Index u) const
  {
    std::size_t num_faces_at_edge = 0;
    Index others[2] = { null(), null() };
    for (Index c = first; c != null(); c = m_opposite[c]) {
      const Index s = m_vertex[next(c)], t = m_vertex[prev(c)];
      if (s != u && t != u)
        continue;
      if (num_faces_at_edge < 2)
        others[num_faces_at_edge] = s == u ? t : s;
      ++num_faces_at_edge;
    }
    if (num_faces_at_edge > 2)
      return Mesh_defect::nonmanifold_edge;
    return others[0] == others[1] ? Mesh_defect::duplicate_face : Mesh_defect::inconsistent_orientation;
  }

  // Every vertex must have one closed fan, or open fans only.
  void check_vertices(const std::vector<Index>& corner, std::vector<Index>& unseen) const
  {
    unseen.assign(m_num_vertices, 0);
    for (Index v : m_vertex)
      ++unseen[v];
    for (std::size_t v = 0; v < m_num_vertices; ++v) {
      if (unseen[v] == 0)
        continue;
      const Fan fan = fan_from(corner[v]);
      if (fan.closed && fan.size != unseen[v])
        throw Mesh_defect_exception(Mesh_defect::nonmanifold_vertex, v);
      if (fan.closed)
        unseen[v] = 0;
    }
    for (std::size_t h = 0; h < m_vertex.size(); ++h)
      if (m_opposite[h] == null())
        unseen[m_vertex[h]] -= fan_from(static_cast<Index>(h)).size;
    for (std::size_t v = 0; v < m_num_vertices; ++v)
      if (unseen[v] != 0)
        throw Mesh_defect_exception(Mesh_defect::nonmanifold_vertex, v);
  }

  struct Fan
  {
    Index size;
    bool closed;
  };

  // The corners from c on counterclockwise, to a border or around.
  Fan fan_from(Index c) const
  {
    Fan fan = { 0, false };
    Index d = c;
    do {
      ++fan.size;
      d = swing(d);
    } while (d != c && d != null());
    fan.closed = d == c;
    return fan;
  }

  void pair(Index g, Index h)
  {
    m_opposite[g] = h;
    m_opposite[h] = g;
  }

  // The edge of halfedge `from` is that of halfedge `to` from now on.
  void move_halfedge(Index from, Index to)
  {
    const Index o = m_opposite[from];
    m_opposite[to] = o;
    if (o != null())
      m_opposite[o] = to;
  }

  internal::Emptied_on_move<std::size_t> m_num_vertices;
  std::vector<Index> m_vertex;   // of each corner
  std::vector<Index> m_opposite; // of each halfedge
};

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_CORNER_TABLE_H
