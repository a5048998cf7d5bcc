// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_INTERNAL_POLYGON_LIST_H
#define CGAL_COMPACT_SURFACE_MESH_INTERNAL_POLYGON_LIST_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Mesh_defect_exception.h>
#include <CGAL/Compact_surface_mesh/internal/Paired_corners.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

// The faces of a mesh as they are read: the vertices of their corners, face by face, and,
// unless all of them are triangles, where each face starts. A corner also names the halfedge
// of its face that starts there. Defects that a face has on its own are found here.
template <class Index>
class Polygon_list
{
public:
  static constexpr Index null() { return (std::numeric_limits<Index>::max)(); }

  Polygon_list(std::size_t num_vertices, std::size_t num_faces)
    : m_num_vertices(num_vertices)
  {
    check_counts(num_vertices, num_faces);
    m_corner.reserve(3 * num_faces + 6); // room for one split_face(), so that closing a mesh does not copy it
    m_corner.resize(3 * num_faces);
  }

  // Throws if a corner table with so many vertices and triangles has too many of them.
  static void check_counts(std::size_t num_vertices, std::size_t num_triangles)
  {
    if (num_vertices >= null())
      throw Mesh_defect_exception(Mesh_defect::too_many_elements, num_vertices);
    if (num_triangles >= null() / 3)
      throw Mesh_defect_exception(Mesh_defect::too_many_elements, num_triangles);
  }

  // Adds a face, which is a range of vertices. Negative numbers are seen as large ones.
  template <class Face>
  void append(const Face& face)
  {
    std::size_t v[3];
    if (read_triangle(face, v))
      append_triangle(v[0], v[1], v[2]);
    else
      append_polygon(face);
  }

  // Adds a face that must be a triangle.
  template <class Face>
  void append_triangle(const Face& face)
  {
    std::size_t v[3];
    if (!read_triangle(face, v))
      throw Mesh_defect_exception(Mesh_defect::not_a_triangle, num_faces());
    append_triangle(v[0], v[1], v[2]);
  }

  void append_triangle(std::size_t a, std::size_t b, std::size_t c)
  {
    if (a >= m_num_vertices || b >= m_num_vertices || c >= m_num_vertices)
      throw Mesh_defect_exception(Mesh_defect::index_out_of_range, num_faces());
    if (a == b || b == c || c == a)
      throw Mesh_defect_exception(Mesh_defect::repeated_vertex, num_faces());
    Paired_corner<Index>* const corners = new_corners(3);
    corners[0].vertex = static_cast<Index>(a);
    corners[1].vertex = static_cast<Index>(b);
    corners[2].vertex = static_cast<Index>(c);
    if (!m_first.empty())
      end_polygon(3);
  }

  // Adds a face that is no triangle.
  template <class Face>
  void append_polygon(const Face& face)
  {
    index_faces();
    m_polygon.clear();
    for (const auto& i : face) {
      const std::size_t v = static_cast<std::size_t>(i);
      if (v >= m_num_vertices)
        throw Mesh_defect_exception(Mesh_defect::index_out_of_range, num_faces());
      m_polygon.push_back(v);
    }
    if (m_polygon.size() < 3)
      throw Mesh_defect_exception(Mesh_defect::degenerate_face, num_faces());
    check_vertices_differ();
    Paired_corner<Index>* const corners = new_corners(m_polygon.size());
    for (std::size_t i = 0; i < m_polygon.size(); ++i)
      corners[i].vertex = static_cast<Index>(m_polygon[i]);
    end_polygon(m_polygon.size());
  }

  // Makes ready for what follows has_triangles_only().
  void index_corners()
  {
    index_faces();
    m_face.resize(m_num_corners);
    for (std::size_t f = 0; f < num_faces(); ++f)
      for (std::size_t c = m_first[f]; c < m_first[f + 1]; ++c)
        m_face[c] = static_cast<Index>(f);
  }

  std::size_t num_vertices() const { return m_num_vertices; }
  std::size_t num_faces() const { return m_first.empty() ? m_num_corners / 3 : m_first.size() - 1; }
  std::size_t num_halfedges() const { return m_num_corners; }

  // Gives all corners away.
  Paired_corners<Index> release_corners()
  {
    m_corner.resize(m_num_corners);
    return std::move(m_corner);
  }
  // Takes them back.
  void restore_corners(Paired_corners<Index>&& corners) { m_corner = std::move(corners); }

  bool has_triangles_only() const { return m_first.empty(); }

  Index vertex(Index c) const { return m_corner[c].vertex; }
  Index opposite(Index c) const { return m_corner[c].opposite; }
  void set_opposite(Index c, Index opposite) { m_corner[c].opposite = opposite; }
  Index face(Index c) const { return m_face[c]; }
  Index first(Index f) const { return m_first[f]; }
  Index end(Index f) const { return m_first[f + 1]; }
  std::size_t size(Index f) const { return m_first[f + 1] - m_first[f]; }
  Index next(Index c) const
  {
    const Index f = m_face[c];
    return c + 1 == m_first[f + 1] ? m_first[f] : static_cast<Index>(c + 1);
  }
  Index prev(Index c) const
  {
    const Index f = m_face[c];
    return static_cast<Index>((c == m_first[f] ? m_first[f + 1] : c) - 1);
  }

private:
  // The vertices of `face`, if it has three.
  template <class Face>
  static bool read_triangle(const Face& face, std::size_t (&v)[3])
  {
    std::size_t size = 0;
    for (const auto& i : face) {
      if (size == 3)
        return false;
      v[size++] = static_cast<std::size_t>(i);
    }
    return size == 3;
  }

  Paired_corner<Index>* new_corners(std::size_t size)
  {
    const std::size_t begin = m_num_corners;
    m_num_corners += size;
    if (m_num_corners > m_corner.size())
      m_corner.resize(m_num_corners);
    return m_corner.data() + begin;
  }

  void index_faces()
  {
    if (!m_first.empty())
      return;
    const std::size_t size = m_num_corners / 3;
    m_num_triangles = size;
    m_first.reserve(size + 2);
    for (std::size_t f = 0; f <= size; ++f)
      m_first.push_back(static_cast<Index>(3 * f));
  }

  void end_polygon(std::size_t size)
  {
    m_num_triangles += size - 2;
    if (m_num_corners >= null()) // there are not fewer corners of triangles
      throw Mesh_defect_exception(Mesh_defect::too_many_elements, m_num_triangles);
    m_first.push_back(static_cast<Index>(m_num_corners));
  }

  void check_vertices_differ()
  {
    const std::size_t f = num_faces();
    bool differ = true;
    if (m_polygon.size() <= 8) {
      for (auto i = m_polygon.begin(); i != m_polygon.end(); ++i)
        differ = differ && std::find(m_polygon.begin(), i, *i) == i;
    } else {
      m_last_face.resize(m_num_vertices, null());
      for (const std::size_t v : m_polygon)
        differ = differ && std::exchange(m_last_face[v], static_cast<Index>(f)) != f;
    }
    if (!differ)
      throw Mesh_defect_exception(Mesh_defect::repeated_vertex, f);
  }

  std::size_t m_num_vertices;
  std::size_t m_num_corners = 0;
  std::size_t m_num_triangles = 0; // that the faces make at least; counted if some are polygons
  Paired_corners<Index> m_corner;  // and more; halfedges are paired later
  std::vector<std::size_t> m_polygon; // that is being read
  std::vector<Index> m_first;      // corner of each face, and the number of corners; empty for triangles
  std::vector<Index> m_face;       // of each corner
  std::vector<Index> m_last_face;  // with more than 8 sides, of each vertex
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_INTERNAL_POLYGON_LIST_H
