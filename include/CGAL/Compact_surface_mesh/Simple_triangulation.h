// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_SIMPLE_TRIANGULATION_H
#define CGAL_COMPACT_SURFACE_MESH_SIMPLE_TRIANGULATION_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Corner_table.h>
#include <CGAL/Compact_surface_mesh/Mesh_defect_exception.h>
#include <CGAL/Compact_surface_mesh/internal/Double_edge_split.h>
#include <CGAL/Compact_surface_mesh/internal/Emptied_on_move.h>
#include <CGAL/Compact_surface_mesh/internal/Fan_corners.h>
#include <CGAL/Compact_surface_mesh/internal/Graph_faces.h>
#include <CGAL/Compact_surface_mesh/internal/Halfedge_matching.h>
#include <CGAL/Compact_surface_mesh/internal/Polygon_list.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgCompactSurfaceMeshRef

The class `Simple_triangulation` is a polygon mesh made into a simple triangulation: all
faces are triangles, and no two edges have the same ends. The mesh may have borders, handles,
several components, isolated vertices, and vertices with several fans of faces, all of which are open.

What it takes to get there is <em>hidden</em>:
- a polygon with up to `max_fan_size` sides becomes a fan of triangles, by hidden diagonals
  from one of its corners. None of them has the same ends as an edge or another diagonal;
- where there is no such corner, and in larger polygons, a hidden vertex in the center is
  joined to all corners by hidden edges;
- of several edges with the same ends `u` and `v`, which only a `FaceGraph` can have, all but one
  are split by a hidden vertex `x`: (`u`,`x`) is visible and stands for the edge, (`x`,`v`) is
  hidden, and the faces beside the edge are triangulated as if `x` were a corner of theirs.

The user's vertices are the first vertices of the table, in the order of the input, and the hidden
ones follow. The triangles of a face are consecutive, in the order of the faces. A mesh of triangles
without double edges is its own table: nothing is hidden, and nothing is stored beside the table.

\tparam Index an unsigned integer type, as for `Corner_table`; it must be able to number what is hidden, too
*/
template <class Index = std::uint32_t>
class Simple_triangulation
{
  using Polygon_list = internal::Polygon_list<Index>;

public:
  /// the largest number of sides of a polygon that needs no hidden vertex.
  static constexpr std::size_t max_fan_size = 8;

  /// \name Construction
  /// All constructors take linear time, whatever the sizes of the faces and the degrees of the vertices.
  ///
  /// \throws Mesh_defect_exception if the faces are no oriented manifold, or if `Index` cannot
  /// number the triangulation. Elements are those of the input.
  /// @{

  /// creates the empty triangulation.
  Simple_triangulation() = default;

  /// takes the table of a triangle mesh.
  Simple_triangulation(Corner_table<Index>&& triangles)
    : m_table(std::move(triangles)), m_num_user_vertices(m_table.num_vertices()), m_num_user_faces(m_table.num_faces())
  {}

  /*!
  triangulates a polygon soup.

  \tparam PolygonRange a range of ranges of integers
  \param num_vertices the number of vertices; indices are smaller than this
  \param polygons the faces, each counterclockwise. Two edges with the same ends are one edge.
  */
  template <class PolygonRange>
  Simple_triangulation(std::size_t num_vertices, const PolygonRange& polygons)
  {
    Polygon_list list(num_vertices,
                      static_cast<std::size_t>(std::distance(std::begin(polygons), std::end(polygons))));
    for (const auto& polygon : polygons)
      list.append(polygon);
    set_user_counts(list);
    if (list.has_triangles_only()) {
      m_table.take_triangles(list);
      internal::match_halfedges<Index>(m_table);
    } else {
      list.index_corners();
      internal::match_halfedges<Index>(list);
      triangulate(list);
    }
  }

  /*!
  triangulates a mesh. Its faces are numbered in the order of `faces(g)`.

  \tparam FaceGraph a model of `FaceListGraph`
  \tparam VertexIndexMap a readable property map from vertices to integers
  \param g the mesh. Its halfedges are paired as by `opposite()`. Edges without faces are left out.
  \param vertex_index numbers the vertices of `g` from 0 without holes
  */
  template <class FaceGraph, class VertexIndexMap
#ifndef DOXYGEN_RUNNING
            , std::enable_if_t<!std::is_integral<FaceGraph>::value, int> = 0
#endif
            >
  Simple_triangulation(const FaceGraph& g, const VertexIndexMap& vertex_index)
  {
    internal::Graph_faces<FaceGraph, VertexIndexMap> graph_faces(g, vertex_index);
    Polygon_list list = graph_faces.template read<Index>(false);
    set_user_counts(list);
    if (list.has_triangles_only()) {
      m_table.take_triangles(list);
      internal::Halfedge_matching<Index, Corner_table<Index> > matching(m_table);
      if (graph_faces.pair_by_ends(matching, m_table)) {
        matching.check_vertices();
        return;
      }
      list.restore_corners(std::move(m_table.m_corner));
    }
    list.index_corners();
    internal::Halfedge_matching<Index, Polygon_list> matching(list);
    if (graph_faces.pair_by_ends(matching, list))
      matching.check_vertices();
    else {
      graph_faces.pair(list);
      internal::check_vertices<Index>(list);
      split_double_edges(list);
    }
    triangulate(list);
  }

  /// @}

  /// \name The Triangulation
  /// @{

  /// returns the triangulation.
  const Corner_table<Index>& table() const { return m_table; }

  /// returns the triangulation, which may be moved out and appended to.
  Corner_table<Index>& table() { return m_table; }

  /// @}

  /// \name The User's Mesh
  /// in constant time.
  /// @{

  /// returns the number of vertices of the user, isolated ones included: the first vertices of the table.
  std::size_t num_user_vertices() const { return m_num_user_vertices; }

  /// returns the number of faces of the user.
  std::size_t num_user_faces() const { return m_num_user_faces; }

  /// returns the number of halfedges of the user that have a face.
  std::size_t num_user_halfedges() const { return has_hidden() ? m_halfedge_of_side.size() : 3 * m_num_user_faces; }

  /// returns whether anything is hidden. If not, face `i` of the user is triangle `i` of the
  /// table, and its `j`-th halfedge is `3i+j`.
  bool has_hidden() const { return !m_face_of_triangle.empty(); }

  /// returns whether the edge of halfedge `h` of the table is hidden.
  bool is_hidden(Index h) const { return has_hidden() && m_is_hidden[h]; }

  /// returns the face of the user to which triangle `t` of the table belongs.
  Index face_of_triangle(Index t) const { return has_hidden() ? m_face_of_triangle[t] : t; }

  /// returns the halfedge of the table that stands for the `i`-th halfedge of the user. These are counted through
  /// the faces in order, and in each face from its first vertex on, or from `halfedge(f, g)`.
  Index halfedge_of_side(std::size_t i) const
  {
    return has_hidden() ? m_halfedge_of_side[i] : static_cast<Index>(i);
  }

  /// returns for each hidden vertex, in order, `Corner_table::null()` if it is in the center of a polygon,
  /// and the user's vertex `v` if it is a vertex `x` that splits an edge, whose part (`x`,`v`) is hidden.
  const std::vector<Index>& stands_for() const { return m_stands_for; }

  /// @}

private:
  static constexpr Index null() { return Corner_table<Index>::null(); }

  void set_user_counts(const Polygon_list& list)
  {
    m_num_user_vertices = list.num_vertices();
    m_num_user_faces = list.num_faces();
  }

  void split_double_edges(Polygon_list& list)
  {
    internal::Double_edge_split<Index> split(list);
    Polygon_list split_list = split.polygons();
    m_stands_for = split.ends();
    m_halfedge_of_side = split.images();
    list = std::move(split_list);
  }

  // Cuts faces whose halfedges are paired, and no two edges of which have the same ends.
  void triangulate(const Polygon_list& list)
  {
    const std::vector<Index> fan_corner = internal::Fan_corners<Index>(list, max_fan_size).release();
    make_room(list, fan_corner);
    std::vector<Index> image(list.num_halfedges()); // of the halfedges of the faces
    for (std::size_t i = 0; i < list.num_faces(); ++i) {
      const Index f = static_cast<Index>(i);
      if (list.size(f) == 3)
        append_fan(list, list.first(f), image);
      else if (fan_corner[f] != null())
        append_fan(list, fan_corner[f], image);
      else
        append_wheel(list, f, image);
    }
    for (std::size_t i = 0; i < image.size(); ++i) {
      const Index opposite = list.opposite(static_cast<Index>(i));
      if (opposite != null())
        m_table.set_opposite(image[i], image[opposite]);
    }

    if (m_halfedge_of_side.empty()) // no edge is split
      m_halfedge_of_side = std::move(image);
    else
      for (Index& h : m_halfedge_of_side)
        h = image[h];
    m_is_hidden.assign(m_table.num_halfedges(), true);
    for (const Index h : m_halfedge_of_side)
      m_is_hidden[h] = false;
  }

  void make_room(const Polygon_list& list, const std::vector<Index>& fan_corner)
  {
    std::size_t num_triangles = 0, num_centers = 0;
    for (std::size_t i = 0; i < list.num_faces(); ++i) {
      const Index f = static_cast<Index>(i);
      const bool has_center = list.size(f) != 3 && fan_corner[f] == null();
      num_triangles += has_center ? list.size(f) : list.size(f) - 2;
      num_centers += has_center ? 1 : 0;
    }
    Polygon_list::check_counts(list.num_vertices() + num_centers, num_triangles);
    m_table.m_num_vertices = list.num_vertices();
    m_table.m_corner.clear();
    m_table.m_corner.reserve(3 * num_triangles);
    m_face_of_triangle.reserve(num_triangles);
  }

  // The triangles of the diagonals from corner c of its face.
  void append_fan(const Polygon_list& list, Index c, std::vector<Index>& image)
  {
    const Index f = list.face(c), last = list.prev(c);
    Index d = list.next(c), previous = null();
    while (d != last) {
      const Index following = list.next(d);
      const Index h = append_triangle(f, list.vertex(c), list.vertex(d), list.vertex(following));
      if (previous == null())
        image[c] = h;
      else
        m_table.pair(previous + 2, h);
      image[d] = h + 1;
      previous = h;
      d = following;
    }
    image[last] = previous + 2;
  }

  // The triangles around a hidden vertex in the center of face f.
  void append_wheel(const Polygon_list& list, Index f, std::vector<Index>& image)
  {
    const Index center = static_cast<Index>((*m_table.m_num_vertices)++);
    m_stands_for.push_back(null());
    for (Index c = list.first(f); c != list.end(f); ++c)
      image[c] = append_triangle(f, list.vertex(c), list.vertex(list.next(c)), center);
    for (Index c = list.first(f); c != list.end(f); ++c)
      m_table.pair(image[c] + 1, image[list.next(c)] + 2);
  }

  // Returns the halfedge from a to b.
  Index append_triangle(Index f, Index a, Index b, Index c)
  {
    const Index h = static_cast<Index>(m_table.num_halfedges());
    m_table.append_triangle(a, b, c);
    m_face_of_triangle.push_back(f);
    return h;
  }

  Corner_table<Index> m_table;
  internal::Emptied_on_move<std::size_t> m_num_user_vertices, m_num_user_faces;
  std::vector<Index> m_stands_for; // for each hidden vertex
  // empty if nothing is hidden
  std::vector<Index> m_face_of_triangle;
  std::vector<Index> m_halfedge_of_side;
  std::vector<bool> m_is_hidden; // of each halfedge of the table
};

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_SIMPLE_TRIANGULATION_H
