// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_LAYOUT_ORACLE_H
#define TEST_COMPACT_SURFACE_MESH_LAYOUT_ORACLE_H

#include "each_face_oracle.h"

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/Corner_table.h>
#include <CGAL/Compact_surface_mesh/Input_images.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace test {

// Compares every operator of a layout with the corner table of the same mesh.
// `vertex_of_input` is the vertex map that the layout reported. Since the halfedges
// correspond one to one and all operators agree, the layout is isomorphic to the mesh as
// an oriented map. Returns what differs first, or an empty string.
template <class Layout, class TableIndex>
class Layout_oracle
{
  typedef typename Layout::Index Index;
  typedef CGAL::Corner_table<TableIndex> Table;

public:
  Layout_oracle(const Layout& layout, const Table& table, const std::vector<Index>& vertex_of_input)
    : m_layout(layout), m_table(table), m_vertex(vertex_of_input),
      m_halfedge(table.num_halfedges(), Layout::null_index())
  {}

  std::string difference()
  {
    check_counts();
    if (m_difference.empty())
      map_halfedges();
    if (m_difference.empty())
      check_halfedges();
    if (m_difference.empty())
      check_each_face();
    if (m_difference.empty())
      check_elements();
    if (m_difference.empty())
      check_stars();
    return m_difference;
  }

  // the layout's halfedge for each one of the table
  const std::vector<Index>& halfedges() const { return m_halfedge; }

private:
  void expect(bool condition, const std::string& what, std::size_t element)
  {
    if (!condition && m_difference.empty())
      m_difference = what + " at " + std::to_string(element);
  }

  void check_counts()
  {
    expect(m_layout.num_vertices() == m_table.num_vertices(), "number of vertices", 0);
    expect(m_layout.num_faces() == m_table.num_faces(), "number of faces", 0);
    expect(m_layout.num_halfedges() == m_table.num_halfedges(), "number of halfedges", 0);
    expect(2 * m_layout.num_edges() == m_table.num_halfedges(), "number of edges", 0);
    expect(m_vertex.size() == m_table.num_vertices(), "size of the vertex map", 0);
    std::vector<bool> used(m_table.num_vertices(), false);
    for (std::size_t i = 0; i < m_vertex.size() && m_difference.empty(); ++i) {
      expect(m_vertex[i] < used.size() && !used[m_vertex[i]], "vertex map", i);
      if (m_difference.empty())
        used[m_vertex[i]] = true;
    }
  }

  Index vertex(std::size_t v) const { return m_vertex[v]; }

  void map_halfedges()
  {
    std::vector<bool> used(m_layout.num_halfedges(), false);
    for (std::size_t i = 0; i < m_halfedge.size(); ++i) {
      const TableIndex h = static_cast<TableIndex>(i);
      m_halfedge[h] = m_layout.halfedge(vertex(m_table.source(h)), vertex(m_table.target(h)));
      expect(m_halfedge[h] < used.size() && !used[m_halfedge[h]], "halfedge(u, v)", h);
      if (!m_difference.empty())
        return;
      used[m_halfedge[h]] = true;
    }
  }

  void check_halfedges()
  {
    std::vector<bool> used(m_layout.num_faces(), false);
    for (std::size_t i = 0; i < m_halfedge.size() && m_difference.empty(); ++i) {
      const TableIndex h = static_cast<TableIndex>(i);
      const Index g = m_halfedge[h];
      expect(m_layout.source(g) == vertex(m_table.source(h)), "source", h);
      expect(m_layout.target(g) == vertex(m_table.target(h)), "target", h);
      expect(m_layout.next(g) == m_halfedge[m_table.next(h)], "next", h);
      expect(m_layout.prev(g) == m_halfedge[m_table.prev(h)], "prev", h);
      expect(m_layout.opposite(g) == m_halfedge[m_table.opposite(h)], "opposite", h);
      expect(m_layout.edge(g) == m_layout.edge(m_layout.opposite(g)), "edge", h);
      expect(m_layout.edge(g) < m_layout.num_edges(), "edge", h);
      expect(m_layout.face(g) == m_layout.face(m_halfedge[m_table.next(h)]), "face", h);
      expect(m_layout.face(g) < used.size(), "face", h);
      if (m_layout.is_in_triangle(g)) {
        const TableIndex next = m_table.next(h);
        const std::array<Index, 3> v = m_layout.vertices_of_triangle(g);
        expect(v[0] == vertex(m_table.target(h)) && v[1] == vertex(m_table.target(next)) &&
                   v[2] == vertex(m_table.source(h)), "vertices of a triangle", h);
      }
      if (h % 3 == 0 && m_difference.empty()) {
        expect(!used[m_layout.face(g)], "face twice", h);
        used[m_layout.face(g)] = true;
        check_face(h);
      }
    }
  }

  void check_face(TableIndex h)
  {
    const Index f = m_layout.face(m_halfedge[h]);
    const Index first = m_layout.halfedge_of_face(f);
    expect(m_layout.face(first) == f, "halfedge of a face", h);
    expect(m_layout.vertex_of_face(f) == m_layout.target(first), "vertex of a face", h);
    const std::array<Index, 3> vertices = m_layout.vertices_of_face(f);
    Index g = first;
    for (int i = 0; i < 3; ++i, g = m_layout.next(g))
      expect(vertices[i] == m_layout.target(g), "vertices of a face", h);
  }

  void check_each_face()
  {
    const std::optional<std::size_t> wrong = first_wrong_visit(m_layout);
    expect(!wrong, "each face", wrong.value_or(0));
  }

  void check_elements()
  {
    for (std::size_t e = 0; e < m_layout.num_edges(); ++e) {
      const Index h = m_layout.halfedge_of_edge(static_cast<Index>(e));
      expect(h < m_layout.num_halfedges() && m_layout.edge(h) == e, "halfedge of an edge", e);
    }
    for (std::size_t v = 0; v < m_layout.num_vertices(); ++v) {
      const Index h = m_layout.halfedge_of_vertex(static_cast<Index>(v));
      expect(h < m_layout.num_halfedges() && m_layout.target(h) == v, "halfedge of a vertex", v);
      expect(m_layout.halfedge(static_cast<Index>(v), static_cast<Index>(v)) == Layout::null_index(),
             "halfedge(v, v)", v);
    }
  }

  // The stars against lists of neighbors and triangles, in any order.
  void check_stars()
  {
    std::vector<TableIndex> start(m_table.num_vertices());
    for (std::size_t h = 0; h < m_table.num_halfedges(); ++h)
      start[m_table.source(static_cast<TableIndex>(h))] = static_cast<TableIndex>(h);
    for (std::size_t v = 0; v < start.size() && m_difference.empty(); ++v) {
      std::vector<std::array<Index, 2>> expected, triangles;
      std::vector<Index> neighbors, visited;
      TableIndex h = start[v];
      do {
        const TableIndex following = m_table.next_around_source(h);
        expected.push_back({ vertex(m_table.target(h)), vertex(m_table.target(following)) });
        neighbors.push_back(vertex(m_table.target(h)));
        h = following;
      } while (h != start[v]);
      m_layout.for_each_incident_triangle(vertex(v), [&](Index u, Index w) { triangles.push_back({ u, w }); });
      m_layout.for_each_adjacent_vertex(vertex(v), [&](Index u) { visited.push_back(u); });
      expect(same(expected, triangles), "triangles of a star", v);
      expect(m_layout.degree(vertex(v)) == neighbors.size(), "degree", v);
      expect(same(neighbors, visited), "vertices of a star", v);
    }
  }

  template <class T>
  static bool same(std::vector<T>& a, std::vector<T>& b)
  {
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    return a == b;
  }

  const Layout& m_layout;
  const Table& m_table;
  const std::vector<Index>& m_vertex;
  std::vector<Index> m_halfedge;
  std::string m_difference;
};

// Builds `Layout` from a soup and compares; `arguments` go to the layout's constructor.
template <class Layout, class Triangles, class... Arguments>
std::string difference_from_table(std::size_t num_vertices, const Triangles& triangles, const Arguments&... arguments)
{
  typedef typename Layout::Index Index;
  const CGAL::Corner_table<Index> table(num_vertices, triangles);
  CGAL::Closed_triangulation<Index> closed{ CGAL::Corner_table<Index>(table) };
  CGAL::Input_images<Index> images;
  images.wants_halfedges = true;
  const Layout layout(std::move(closed), images, arguments...);
  Layout_oracle<Layout, Index> oracle(layout, table, images.vertices);
  const std::string difference = oracle.difference();
  return difference.empty() && oracle.halfedges() != images.halfedges ? "images of halfedges" : difference;
}

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_LAYOUT_ORACLE_H
