// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_SOUP_ORACLE_H
#define TEST_COMPACT_SURFACE_MESH_SOUP_ORACLE_H

// What is true of a small polygon soup, by the definitions and by search through all of
// its faces: which defects it has and where, and what a corner table of it must say.

#include <CGAL/Compact_surface_mesh/Corner_table.h>
#include <CGAL/Compact_surface_mesh/Mesh_defect_exception.h>

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test {

struct Polygon_soup
{
  std::size_t num_vertices;
  std::vector<std::vector<long long>> faces;
};

inline std::ostream& operator<<(std::ostream& out, const Polygon_soup& soup)
{
  out << soup.num_vertices << " vertices, faces";
  for (const auto& face : soup.faces) {
    out << " (";
    for (std::size_t i = 0; i < face.size(); ++i)
      out << (i == 0 ? "" : " ") << face[i];
    out << ")";
  }
  return out;
}

/// A defect and the element at which it is.
using Defect = std::pair<CGAL::Mesh_defect, std::size_t>;

/// Drops faces of `soup` as long as `fails` remains true of it.
template <class Predicate>
Polygon_soup smallest_failing(Polygon_soup soup, const Predicate& fails)
{
  for (std::size_t f = soup.faces.size(); f-- > 0;) {
    Polygon_soup smaller = soup;
    smaller.faces.erase(smaller.faces.begin() + static_cast<std::ptrdiff_t>(f));
    if (fails(smaller)) {
      soup = smaller;
      f = soup.faces.size();
    }
  }
  return soup;
}

class Soup_oracle
{
  using Face = std::vector<long long>;

public:
  explicit Soup_oracle(const Polygon_soup& soup) : m_soup(soup) {}

  /// All that keeps the soup from being an oriented manifold of triangles. Edges are looked at
  /// when all faces are triangles, and vertices when all edges are those of a manifold.
  std::set<Defect> defects() const { return defects(3, CGAL::Mesh_defect::not_a_triangle); }

  /// All that keeps the soup from being an oriented manifold of polygons, in the same order.
  std::set<Defect> polygon_defects() const
  {
    return defects(static_cast<std::size_t>(-1), CGAL::Mesh_defect::degenerate_face);
  }

  /// All that keeps an oriented manifold from being a sphere. The genus is that of a
  /// connected closed surface only.
  std::set<Defect> sphere_defects() const
  {
    using CGAL::Mesh_defect;
    std::set<Defect> found;
    std::size_t num_edges = 0;
    for (std::size_t f = 0; f < num_faces(); ++f)
      for (std::size_t i = 0; i < 3; ++i) {
        if (faces_along(vertex(f, i + 1), vertex(f, i)).empty())
          found.insert(Defect(Mesh_defect::border, f));
        num_edges += vertex(f, i) < vertex(f, i + 1) ? 1 : 0;
      }
    for (std::size_t v = 0; v < m_soup.num_vertices; ++v)
      if (faces_at(static_cast<long long>(v)).empty())
        found.insert(Defect(Mesh_defect::isolated_vertex, v));
    const std::vector<bool> reached = faces_connected_to_first();
    for (std::size_t f = 0; f < num_faces(); ++f)
      if (!reached[f])
        found.insert(Defect(Mesh_defect::several_components, f));
    if (found.empty() && num_faces() != 0 && m_soup.num_vertices + num_faces() != num_edges + 2)
      found.insert(Defect(Mesh_defect::positive_genus, (num_edges + 2 - m_soup.num_vertices - num_faces()) / 2));
    return found;
  }

  /// What differs first between `table` and the soup, an oriented manifold; or nothing.
  template <class Index>
  std::string difference(const CGAL::Corner_table<Index>& table) const
  {
    if (table.num_vertices() != m_soup.num_vertices || table.num_faces() != num_faces()
        || table.num_halfedges() != 3 * num_faces())
      return "counts";
    const Index null = CGAL::Corner_table<Index>::null();
    const auto index = [](long long v) { return static_cast<Index>(v); };
    for (std::size_t i = 0; i < 3 * num_faces(); ++i) {
      const Index c = static_cast<Index>(i);
      const std::size_t f = i / 3, j = i % 3;
      const long long v = vertex(f, j), following = vertex(f, j + 1), preceding = vertex(f, j + 2);
      const std::string at = " at " + std::to_string(i);
      // the corner of vertex `at_vertex` in the face that runs from v1 to v2, or null
      const auto corner = [&](long long v1, long long v2, long long at_vertex) {
        const std::vector<std::size_t> faces = faces_along(v1, v2);
        return faces.empty() ? null : static_cast<Index>(corner_of(faces[0], at_vertex));
      };
      // the corner of the third vertex of that face
      const auto far_corner = [&](long long v1, long long v2) {
        const std::vector<std::size_t> faces = faces_along(v1, v2);
        return faces.empty() ? null : static_cast<Index>(corner_of(faces[0], third(faces[0], v1, v2)));
      };
      if (table.face(c) != f)
        return "face" + at;
      if (table.vertex(c) != index(v) || table.source(c) != index(v))
        return "vertex" + at;
      if (table.next(c) != corner_of(f, following) || table.target(c) != index(following))
        return "next" + at;
      if (table.prev(c) != corner_of(f, preceding))
        return "prev" + at;
      if (table.opposite(c) != corner(following, v, following))
        return "opposite" + at;
      if (table.opposite_corner(c) != far_corner(preceding, following))
        return "opposite corner" + at;
      // Rossignac: c.l = c.p.o, across the edge to the next vertex, and c.r = c.n.o
      if (table.left_corner(c) != far_corner(following, v))
        return "left corner" + at;
      if (table.right_corner(c) != far_corner(v, preceding))
        return "right corner" + at;
      if (table.swing(c) != corner(v, preceding, v) || table.next_around_source(c) != table.swing(c))
        return "swing" + at;
    }
    return "";
  }

private:
  std::size_t num_faces() const { return m_soup.faces.size(); }
  std::size_t size(std::size_t f) const { return m_soup.faces[f].size(); }
  long long vertex(std::size_t f, std::size_t i) const { return m_soup.faces[f][i % size(f)]; }
  // of a triangle
  long long third(std::size_t f, long long v, long long w) const
  {
    return vertex(f, 0) + vertex(f, 1) + vertex(f, 2) - v - w;
  }

  // The place of v in face f; v must be one of f's.
  std::size_t place_of(std::size_t f, long long v) const
  {
    const Face& face = m_soup.faces[f];
    return static_cast<std::size_t>(std::find(face.begin(), face.end(), v) - face.begin());
  }

  // The number of the corner of triangle f at v, in all of the soup.
  std::size_t corner_of(std::size_t f, long long v) const { return 3 * f + place_of(f, v); }

  // The vertices of face f from v on.
  Face turned(std::size_t f, long long v) const
  {
    Face face = m_soup.faces[f];
    std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(place_of(f, v)), face.end());
    return face;
  }

  // The faces with an edge from v to w in this direction.
  std::vector<std::size_t> faces_along(long long v, long long w) const
  {
    std::vector<std::size_t> faces;
    for (std::size_t f = 0; f < num_faces(); ++f)
      for (std::size_t i = 0; i < size(f); ++i)
        if (vertex(f, i) == v && vertex(f, i + 1) == w)
          faces.push_back(f);
    return faces;
  }

  std::vector<std::size_t> faces_at(long long v) const
  {
    std::vector<std::size_t> faces;
    for (std::size_t f = 0; f < num_faces(); ++f)
      if (place_of(f, v) != size(f))
        faces.push_back(f);
    return faces;
  }

  std::set<Defect> defects(std::size_t max_size, CGAL::Mesh_defect other_size) const
  {
    std::set<Defect> found = face_defects(max_size, other_size);
    if (found.empty())
      found = edge_defects();
    if (found.empty())
      found = vertex_defects();
    return found;
  }

  std::set<Defect> face_defects(std::size_t max_size, CGAL::Mesh_defect other_size) const
  {
    using CGAL::Mesh_defect;
    std::set<Defect> found;
    for (std::size_t f = 0; f < num_faces(); ++f) {
      const Face& face = m_soup.faces[f];
      if (face.size() < 3 || face.size() > max_size)
        found.insert(Defect(other_size, f));
      if (std::set<long long>(face.begin(), face.end()).size() != face.size())
        found.insert(Defect(Mesh_defect::repeated_vertex, f));
      for (const long long v : face)
        if (v < 0 || v >= static_cast<long long>(m_soup.num_vertices))
          found.insert(Defect(Mesh_defect::index_out_of_range, f));
    }
    return found;
  }

  std::set<Defect> edge_defects() const
  {
    using CGAL::Mesh_defect;
    std::set<Defect> found;
    for (std::size_t f = 0; f < num_faces(); ++f)
      for (std::size_t i = 0; i < size(f); ++i) {
        const long long v = vertex(f, i), w = vertex(f, i + 1);
        const std::vector<std::size_t> along = faces_along(v, w), against = faces_along(w, v);
        if (along.size() + against.size() > 2)
          found.insert(Defect(Mesh_defect::nonmanifold_edge, f));
        for (const std::size_t g : along)
          if (g != f && turned(g, v) == turned(f, v))
            found.insert(Defect(Mesh_defect::duplicate_face, f));
          else if (g != f && along.size() == 2 && against.empty())
            found.insert(Defect(Mesh_defect::inconsistent_orientation, f));
      }
    return found;
  }

  std::set<Defect> vertex_defects() const
  {
    std::set<Defect> found;
    for (std::size_t i = 0; i < m_soup.num_vertices; ++i) {
      const long long v = static_cast<long long>(i);
      std::size_t num_fans = 0, num_open_fans = 0;
      std::set<std::size_t> seen;
      for (const std::size_t f : faces_at(v)) {
        if (seen.count(f) != 0)
          continue;
        ++num_fans;
        num_open_fans += is_open_fan(v, f, seen) ? 1 : 0;
      }
      if (num_fans > 1 && num_open_fans < num_fans)
        found.insert(Defect(CGAL::Mesh_defect::nonmanifold_vertex, i));
    }
    return found;
  }

  // Puts the faces that are connected to f by edges at v into `seen`, and says whether one of
  // these edges has no second face.
  bool is_open_fan(long long v, std::size_t f, std::set<std::size_t>& seen) const
  {
    bool is_open = false;
    std::vector<std::size_t> fan(1, f);
    seen.insert(f);
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const Face face = turned(fan[i], v);
      const long long following = face[1], preceding = face.back();
      for (const auto& neighbors : {faces_along(following, v), faces_along(v, preceding)}) {
        is_open = is_open || neighbors.empty();
        for (const std::size_t g : neighbors)
          if (seen.insert(g).second)
            fan.push_back(g);
      }
    }
    return is_open;
  }

  std::vector<bool> faces_connected_to_first() const
  {
    std::vector<bool> reached(num_faces(), false);
    std::vector<std::size_t> stack;
    const auto reach = [&](std::size_t f) {
      if (!reached[f])
        stack.push_back(f);
      reached[f] = true;
    };
    if (num_faces() != 0)
      reach(0);
    while (!stack.empty()) {
      const std::size_t f = stack.back();
      stack.pop_back();
      for (const long long v : m_soup.faces[f])
        for (const std::size_t g : faces_at(v))
          reach(g);
    }
    return reached;
  }

  const Polygon_soup& m_soup;
};

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_SOUP_ORACLE_H
