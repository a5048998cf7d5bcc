// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_SIMPLE_TRIANGULATION_ORACLE_H
#define TEST_COMPACT_SURFACE_MESH_SIMPLE_TRIANGULATION_ORACLE_H

// Whether a Simple_triangulation is simple, and whether what is not hidden of it is the mesh
// that it was made from.

#include "glued_polygons.h"

#include <CGAL/Compact_surface_mesh/Simple_triangulation.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test {

template <class Index>
class Simple_triangulation_oracle
{
  using Ends = std::pair<std::size_t, std::size_t>;

public:
  Simple_triangulation_oracle(const CGAL::Simple_triangulation<Index>& simple, const Glued_polygons& polygons)
    : m_simple(simple), m_table(simple.table()), m_polygons(polygons), m_ends(ends_of_sides(polygons.soup))
  {}

  /// What is wrong first, or an empty string.
  std::string error()
  {
    using Check = std::string (Simple_triangulation_oracle::*)();
    for (const Check check :
         {&Simple_triangulation_oracle::error_of_counts, &Simple_triangulation_oracle::error_of_table,
          &Simple_triangulation_oracle::error_of_sides, &Simple_triangulation_oracle::error_of_hidden_edges,
          &Simple_triangulation_oracle::error_of_faces, &Simple_triangulation_oracle::error_of_opposites}) {
      const std::string error = (this->*check)();
      if (!error.empty())
        return error;
    }
    return "";
  }

private:
  static constexpr Index null() { return CGAL::Corner_table<Index>::null(); }
  Index next(Index h) const { return m_table.next(h); }
  std::size_t num_vertices() const { return m_polygons.soup.num_vertices; }
  std::size_t num_faces() const { return m_polygons.soup.faces.size(); }
  static Ends sorted(const Ends& e) { return Ends((std::min)(e.first, e.second), (std::max)(e.first, e.second)); }
  static std::string at(std::size_t i) { return " at " + std::to_string(i); }

  // How many edges there are beside one for each pair of ends.
  std::size_t num_further_copies() const
  {
    std::set<Ends> ends;
    std::size_t num_edges = 0;
    for (std::size_t s = 0; s < m_ends.size(); ++s) {
      ends.insert(sorted(m_ends[s]));
      num_edges += m_polygons.opposite[s] < s ? 0 : 1;
    }
    return num_edges - ends.size();
  }

  std::string error_of_counts()
  {
    const std::vector<Index>& stands_for = m_simple.stands_for();
    if (m_simple.num_user_vertices() != num_vertices() || m_simple.num_user_faces() != num_faces()
        || m_table.num_vertices() != num_vertices() + stands_for.size())
      return "counts";
    const std::size_t num_splits = num_further_copies();
    if (stands_for.size() - static_cast<std::size_t>(std::count(stands_for.begin(), stands_for.end(), null()))
        != num_splits)
      return "number of split edges";
    const auto& faces = m_polygons.soup.faces;
    const bool has_polygons = std::any_of(faces.begin(), faces.end(), [](const auto& f) { return f.size() != 3; });
    return m_simple.has_hidden() == (has_polygons || num_splits != 0) ? "" : "has_hidden";
  }

  // No two halfedges have the same ends, and those with opposite ends are opposite.
  std::string error_of_table()
  {
    for (std::size_t i = 0; i < m_table.num_halfedges(); ++i) {
      const Index h = static_cast<Index>(i);
      if (m_table.source(h) >= m_table.num_vertices() || m_table.source(h) == m_table.target(h))
        return "vertex of the table" + at(i);
      if (!m_halfedge.emplace(Ends(m_table.source(h), m_table.target(h)), h).second)
        return "halfedges with the same ends" + at(i);
    }
    for (const auto& entry : m_halfedge) {
      const auto it = m_halfedge.find(Ends(entry.first.second, entry.first.first));
      if (m_table.opposite(entry.second) != (it == m_halfedge.end() ? null() : it->second))
        return "opposite in the table" + at(entry.second);
    }
    return "";
  }

  // The vertex of the user that v is or stands for.
  std::size_t user_vertex(std::size_t v) const
  {
    return v < num_vertices() ? v : m_simple.stands_for()[v - num_vertices()];
  }

  std::string error_of_sides()
  {
    std::set<Index> images;
    for (std::size_t s = 0; s < m_ends.size(); ++s) {
      const Index h = m_simple.halfedge_of_side(s);
      if (h >= m_table.num_halfedges() || !images.insert(h).second)
        return "no halfedge, or one for two sides," + at(s);
      const std::size_t u = m_table.source(h), v = m_table.target(h);
      if ((u >= num_vertices() && v >= num_vertices()) || Ends(user_vertex(u), user_vertex(v)) != m_ends[s])
        return "ends of a side" + at(s);
      if (!m_simple.has_hidden() && h != s)
        return "a side is not its own halfedge" + at(s);
    }
    for (std::size_t h = 0; h < m_table.num_halfedges(); ++h)
      if (m_simple.is_hidden(static_cast<Index>(h)) == (images.count(static_cast<Index>(h)) != 0))
        return "is_hidden" + at(h);
    return "";
  }

  std::string error_of_hidden_edges()
  {
    for (std::size_t i = 0; i < m_table.num_halfedges(); ++i) {
      const Index h = static_cast<Index>(i), o = m_table.opposite(h);
      if (o != null() && m_simple.is_hidden(h) != m_simple.is_hidden(o))
        return "an edge is hidden from one side only" + at(i);
    }
    return "";
  }

  std::size_t face(Index h) const { return m_simple.face_of_triangle(m_table.face(h)); }
  bool is_inside(Index h) const { return m_table.opposite(h) != null() && face(m_table.opposite(h)) == face(h); }

  // The halfedge that follows h along the border of its face.
  Index next_along_face(Index h) const
  {
    h = next(h);
    while (is_inside(h))
      h = next(m_table.opposite(h));
    return h;
  }

  // The halfedges, one or two, that side s consists of.
  std::vector<Index> parts(std::size_t s) const
  {
    const Index h = m_simple.halfedge_of_side(s);
    const auto u = m_halfedge.find(Ends(m_ends[s].first, m_table.source(h)));
    const auto v = m_halfedge.find(Ends(m_table.target(h), m_ends[s].second));
    if (m_table.source(h) != m_ends[s].first)
      return u == m_halfedge.end() ? std::vector<Index>() : std::vector<Index>{u->second, h};
    if (m_table.target(h) != m_ends[s].second)
      return v == m_halfedge.end() ? std::vector<Index>() : std::vector<Index>{h, v->second};
    return {h};
  }

  // Each face is a disk that its sides go around.
  std::string error_of_faces()
  {
    std::vector<std::size_t> num_triangles(num_faces(), 0);
    for (std::size_t t = 0; t < m_table.num_faces(); ++t) {
      const std::size_t f = m_simple.face_of_triangle(static_cast<Index>(t));
      if (f >= num_faces() || (t != 0 && f < m_simple.face_of_triangle(static_cast<Index>(t - 1))))
        return "face of triangle" + at(t);
      ++num_triangles[f];
    }
    std::vector<std::size_t> centers = centers_of_faces();
    std::size_t first = 0;
    for (std::size_t f = 0; f < num_faces(); ++f) {
      const std::size_t size = m_polygons.soup.faces[f].size();
      std::vector<Index> sides;
      for (std::size_t s = first; s < first + size; ++s) {
        m_parts.push_back(parts(s));
        if (m_parts.back().empty())
          return "no second part of a side" + at(s);
        sides.insert(sides.end(), m_parts.back().begin(), m_parts.back().end());
      }
      first += size;
      for (std::size_t i = 0; i < sides.size(); ++i)
        if (face(sides[i]) != f || is_inside(sides[i])
            || next_along_face(sides[i]) != sides[(i + 1) % sides.size()])
          return "sides of face" + at(f);
      if (centers[f] > 1 || num_triangles[f] != sides.size() - 2 + 2 * centers[f])
        return "number of triangles" + at(f);
      if (centers[f] == 1 && sides.size() <= m_simple.max_fan_size && can_be_fan(sides))
        return "needless center" + at(f);
      if (centers[f] == 0 && sides.size() > m_simple.max_fan_size)
        return "large fan" + at(f);
    }
    return "";
  }

  // The number of hidden vertices inside each face.
  std::vector<std::size_t> centers_of_faces() const
  {
    std::map<std::size_t, std::size_t> face_of_center;
    for (std::size_t h = 0; h < m_table.num_halfedges(); ++h) {
      const std::size_t v = m_table.source(static_cast<Index>(h));
      if (v >= num_vertices() && m_simple.stands_for()[v - num_vertices()] == null())
        face_of_center[v] = face(static_cast<Index>(h)); // another face at the center is met along the sides
    }
    std::vector<std::size_t> centers(num_faces(), 0);
    for (const auto& entry : face_of_center)
      ++centers[entry.second];
    return centers;
  }

  // Whether diagonals from a corner are all new.
  bool can_be_fan(const std::vector<Index>& sides) const
  {
    const std::size_t size = sides.size();
    const auto is_joined = [&](std::size_t i, std::size_t j) {
      const std::size_t v = m_table.source(sides[i]), w = m_table.source(sides[j % size]);
      return m_halfedge.count(Ends(v, w)) != 0 || m_halfedge.count(Ends(w, v)) != 0;
    };
    for (std::size_t i = 0; i < size; ++i) {
      bool is_free = true;
      for (std::size_t j = 2; j + 1 < size; ++j)
        is_free = is_free && !is_joined(i, i + j);
      if (is_free)
        return true;
    }
    return false;
  }

  std::string error_of_opposites()
  {
    for (std::size_t s = 0; s < m_ends.size(); ++s) {
      const std::size_t o = m_polygons.opposite[s];
      const std::size_t size = m_parts[s].size();
      if (o != Glued_polygons::none && m_parts[o].size() != size)
        return "an edge is split from one side only" + at(s);
      for (std::size_t i = 0; i < size; ++i)
        if (m_table.opposite(m_parts[s][i]) != (o == Glued_polygons::none ? null() : m_parts[o][size - 1 - i]))
          return "opposite of side" + at(s);
      if (o != Glued_polygons::none && m_table.opposite(m_simple.halfedge_of_side(s)) != m_simple.halfedge_of_side(o))
        return "opposite of the visible part of side" + at(s);
    }
    return "";
  }

  const CGAL::Simple_triangulation<Index>& m_simple;
  const CGAL::Corner_table<Index>& m_table;
  const Glued_polygons& m_polygons;
  const std::vector<Ends> m_ends;                // of each side
  std::map<Ends, Index> m_halfedge;              // of the table, by its ends
  std::vector<std::vector<Index>> m_parts;       // of each side
};

/// What is wrong with `simple`, made from `polygons`; or an empty string.
template <class Index>
std::string error_of_triangulation(const CGAL::Simple_triangulation<Index>& simple, const Glued_polygons& polygons)
{
  return Simple_triangulation_oracle<Index>(simple, polygons).error();
}

template <class Index>
std::string error_of_triangulation(const CGAL::Simple_triangulation<Index>& simple, const Polygon_soup& soup)
{
  return error_of_triangulation(simple, glued_by_ends(soup));
}

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_SIMPLE_TRIANGULATION_ORACLE_H
