// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_SURFACE_ORACLE_H
#define TEST_COMPACT_SURFACE_MESH_SURFACE_ORACLE_H

// What every operator of a layout must answer about a surface of any kind, known from
// nothing but the sides of its faces.

#include "each_face_oracle.h"
#include "soup_oracle.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// The halfedges of a polygon soup that is an oriented manifold without double edges. The
/// sides of the faces come first, in their order, then one halfedge for each side without
/// opposite, along the border.
class Soup_halfedges
{
public:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  explicit Soup_halfedges(const Polygon_soup& soup) : m_num_faces(soup.faces.size())
  {
    for (std::size_t f = 0; f < soup.faces.size(); ++f) {
      const std::size_t first = m_halfedges.size(), degree = soup.faces[f].size();
      for (std::size_t i = 0; i < degree; ++i)
        m_halfedges.push_back({static_cast<std::size_t>(soup.faces[f][i]),
                               static_cast<std::size_t>(soup.faces[f][(i + 1) % degree]), none, f,
                               first + (i + 1) % degree, first + (i + degree - 1) % degree});
    }
    m_num_sides = m_halfedges.size();
    m_first_out.assign(soup.num_vertices + 1, 0);
    sort_by_ends();
    const std::size_t num_sides = m_num_sides;
    for (std::size_t h = 0; h < num_sides; ++h) {
      m_halfedges[h].opposite = between(target(h), source(h));
      if (m_halfedges[h].opposite != none)
        continue;
      m_halfedges[h].opposite = m_halfedges.size();
      m_halfedges.push_back({target(h), source(h), h, none, none, none});
    }
    sort_by_ends();
  }

  std::size_t num_vertices() const { return m_first_out.size() - 1; }
  std::size_t num_faces() const { return m_num_faces; }
  std::size_t num_sides() const { return m_num_sides; }
  std::size_t num_halfedges() const { return m_halfedges.size(); }

  std::size_t source(std::size_t h) const { return m_halfedges[h].source; }
  std::size_t target(std::size_t h) const { return m_halfedges[h].target; }
  std::size_t opposite(std::size_t h) const { return m_halfedges[h].opposite; }
  std::size_t face(std::size_t h) const { return m_halfedges[h].face; } ///< `none` on the border
  std::size_t next(std::size_t h) const { return m_halfedges[h].next; } ///< `none` on the border
  std::size_t prev(std::size_t h) const { return m_halfedges[h].prev; } ///< `none` on the border
  bool is_border(std::size_t h) const { return face(h) == none; }
  bool is_triangle(std::size_t side) const { return next(next(next(side))) == side; }

  std::size_t degree(std::size_t v) const { return m_first_out[v + 1] - m_first_out[v]; }
  /// The i-th halfedge out of `v`, by ascending targets.
  std::size_t out(std::size_t v, std::size_t i) const { return m_by_ends[m_first_out[v] + i]; }

  /// The halfedge from u to v, or `none`.
  std::size_t between(std::size_t u, std::size_t v) const
  {
    const auto begin = m_by_ends.begin(), last = begin + static_cast<std::ptrdiff_t>(m_first_out[u + 1]);
    const auto it = std::lower_bound(begin + static_cast<std::ptrdiff_t>(m_first_out[u]), last, v,
                                     [this](std::size_t h, std::size_t w) { return target(h) < w; });
    return it == last || target(*it) != v ? none : *it;
  }

private:
  struct Halfedge
  {
    std::size_t source, target, opposite, face, next, prev;
  };

  void sort_by_ends()
  {
    m_by_ends.resize(m_halfedges.size());
    std::fill(m_first_out.begin(), m_first_out.end(), 0);
    for (const Halfedge& h : m_halfedges)
      ++m_first_out[h.source + 1];
    for (std::size_t v = 0; v + 1 < m_first_out.size(); ++v)
      m_first_out[v + 1] += m_first_out[v];
    std::vector<std::size_t> end(m_first_out.begin(), m_first_out.end() - 1);
    for (std::size_t h = 0; h < m_halfedges.size(); ++h)
      m_by_ends[end[source(h)]++] = h;
    for (std::size_t v = 0; v < num_vertices(); ++v) {
      const auto begin = m_by_ends.begin() + static_cast<std::ptrdiff_t>(m_first_out[v]);
      const auto last = m_by_ends.begin() + static_cast<std::ptrdiff_t>(m_first_out[v + 1]);
      std::sort(begin, last, [this](std::size_t g, std::size_t h) { return target(g) < target(h); });
      if (std::adjacent_find(begin, last, [this](std::size_t g, std::size_t h) { return target(g) == target(h); })
          != last)
        throw std::invalid_argument("two halfedges with the same ends in the same direction");
    }
  }

  std::size_t m_num_faces, m_num_sides = 0;
  std::vector<Halfedge> m_halfedges;
  std::vector<std::size_t> m_by_ends;   // halfedges by source, then by target
  std::vector<std::size_t> m_first_out; // for each vertex, where its own begin in m_by_ends
};

/// Compares every operator of a layout with the polygon soup that it was made from.
/// `vertex_images` holds the layout's vertex for each one of the soup, and `halfedge_images`,
/// where it is given, the layout's halfedge for each side of the soup's faces, in their order.
/// All elements correspond one to one and all operators agree, so that the layout is
/// isomorphic to the soup as an oriented map. Where several fans meet at a vertex, their
/// cyclic order is free.
template <class Layout>
class Surface_oracle
{
  typedef typename Layout::Index Index;

public:
  Surface_oracle(const Layout& layout, const Polygon_soup& soup, const std::vector<Index>& vertex_images,
                 const std::vector<Index>& halfedge_images = std::vector<Index>())
    : m_layout(layout), m_soup(soup), m_vertex(vertex_images), m_reported(halfedge_images)
  {}

  /// What differs first, or an empty string.
  std::string difference()
  {
    typedef void (Surface_oracle::*Check)();
    for (const Check check :
         {&Surface_oracle::check_counts, &Surface_oracle::map_vertices, &Surface_oracle::map_halfedges,
          &Surface_oracle::check_halfedges, &Surface_oracle::check_sides, &Surface_oracle::check_borders,
          &Surface_oracle::check_edges, &Surface_oracle::check_faces, &Surface_oracle::check_each_face,
          &Surface_oracle::check_vertices, &Surface_oracle::check_stars,
          &Surface_oracle::check_vertices_that_are_not_adjacent})
      if (m_difference.empty())
        (this->*check)();
    return m_difference;
  }

private:
  static constexpr std::size_t none = Soup_halfedges::none;

  void check_counts()
  {
    expect(m_layout.num_vertices() == m_soup.num_vertices(), "number of vertices");
    expect(m_layout.num_halfedges() == m_soup.num_halfedges(), "number of halfedges");
    expect(m_layout.num_edges() == m_soup.num_halfedges() / 2, "number of edges");
    expect(m_layout.num_faces() == m_soup.num_faces(), "number of faces");
    expect(m_vertex.size() == m_soup.num_vertices(), "number of reported vertices");
    expect(m_reported.empty() || m_reported.size() == m_soup.num_sides(), "number of reported halfedges");
  }

  void map_vertices()
  {
    std::vector<bool> is_used(m_soup.num_vertices(), false);
    for (std::size_t v = 0; v < m_vertex.size() && m_difference.empty(); ++v) {
      expect(m_vertex[v] < is_used.size() && !is_used[m_vertex[v]], "reported vertex", vertex(v));
      if (m_difference.empty())
        is_used[m_vertex[v]] = true;
    }
  }

  void map_halfedges()
  {
    m_halfedge.resize(m_soup.num_halfedges());
    m_soup_halfedge.assign(m_soup.num_halfedges(), none);
    for (std::size_t h = 0; h < m_halfedge.size() && m_difference.empty(); ++h) {
      m_halfedge[h] = m_layout.halfedge(m_vertex[m_soup.source(h)], m_vertex[m_soup.target(h)]);
      expect(m_halfedge[h] < m_halfedge.size() && m_soup_halfedge[m_halfedge[h]] == none, "halfedge(u, v)",
             halfedge(h));
      expect(h >= m_reported.size() || m_reported[h] == m_halfedge[h], "reported halfedge", halfedge(h));
      if (m_difference.empty())
        m_soup_halfedge[m_halfedge[h]] = h;
    }
  }

  void check_halfedges()
  {
    for (std::size_t h = 0; h < m_halfedge.size() && m_difference.empty(); ++h) {
      const Index g = m_halfedge[h];
      expect(m_layout.source(g) == m_vertex[m_soup.source(h)], "source", halfedge(h));
      expect(m_layout.target(g) == m_vertex[m_soup.target(h)], "target", halfedge(h));
      expect(m_layout.opposite(g) == m_halfedge[m_soup.opposite(h)], "opposite", halfedge(h));
      expect(m_layout.edge(g) < m_layout.num_edges(), "edge out of range", halfedge(h));
      expect(m_layout.edge(g) == m_layout.edge(m_halfedge[m_soup.opposite(h)]), "edge", halfedge(h));
      if (Layout::edge_is_half_of_halfedge)
        expect(m_layout.edge(g) == g / 2 && m_layout.opposite(g) == (g ^ 1), "edge is half of halfedge", halfedge(h));
    }
  }

  void check_sides()
  {
    std::vector<bool> is_used(m_soup.num_faces(), false);
    for (std::size_t h = 0; h < m_soup.num_sides() && m_difference.empty(); ++h) {
      const Index g = m_halfedge[h], f = m_layout.face(g);
      expect(m_layout.next(g) == m_halfedge[m_soup.next(h)], "next", halfedge(h));
      expect(m_layout.prev(g) == m_halfedge[m_soup.prev(h)], "prev", halfedge(h));
      expect(f < is_used.size(), "face out of range", halfedge(h));
      const bool is_first_side = h == 0 || m_soup.face(h) != m_soup.face(h - 1);
      if (!is_first_side)
        expect(f == m_layout.face(m_halfedge[h - 1]), "face", halfedge(h));
      else if (m_difference.empty()) {
        expect(!is_used[f], "face of another face", halfedge(h));
        is_used[f] = true;
      }
      if (m_difference.empty() && m_layout.is_in_triangle(g))
        check_triangle(h);
    }
  }

  void check_triangle(std::size_t side)
  {
    expect(m_soup.is_triangle(side), "triangle", halfedge(side));
    std::size_t h = side;
    for (const Index v : m_layout.vertices_of_triangle(m_halfedge[side])) {
      expect(v == m_vertex[m_soup.target(h)], "vertices of triangle", halfedge(side));
      h = m_soup.next(h);
    }
  }

  // Along borders, next and prev are permutations, inverse to each other, that join targets to
  // sources; that much is true of each order of the fans at a vertex.
  void check_borders()
  {
    for (std::size_t h = m_soup.num_sides(); h < m_halfedge.size() && m_difference.empty(); ++h) {
      const Index g = m_halfedge[h], next = m_layout.next(g), prev = m_layout.prev(g);
      expect(m_layout.face(g) == Layout::null_index(), "face of a border halfedge", halfedge(h));
      expect(!m_layout.is_in_triangle(g), "triangle of a border halfedge", halfedge(h));
      expect(is_border(next) && m_soup.source(m_soup_halfedge[next]) == m_soup.target(h), "next along the border",
             halfedge(h));
      expect(is_border(prev) && m_soup.target(m_soup_halfedge[prev]) == m_soup.source(h), "prev along the border",
             halfedge(h));
      if (m_difference.empty())
        expect(m_layout.prev(next) == g && m_layout.next(prev) == g, "next and prev along the border", halfedge(h));
    }
  }

  bool is_border(Index g) const
  {
    return g < m_soup_halfedge.size() && m_soup.is_border(m_soup_halfedge[g]);
  }

  void check_edges()
  {
    for (std::size_t e = 0; e < m_layout.num_edges() && m_difference.empty(); ++e) {
      const Index g = m_layout.halfedge_of_edge(static_cast<Index>(e));
      expect(g < m_halfedge.size() && m_layout.edge(g) == e, "halfedge of edge", edge(e));
    }
  }

  void check_faces()
  {
    for (std::size_t f = 0; f < m_layout.num_faces() && m_difference.empty(); ++f) {
      Index g = m_layout.halfedge_of_face(static_cast<Index>(f));
      expect(g < m_halfedge.size() && m_layout.face(g) == f, "halfedge of face", face(f));
      if (!m_difference.empty())
        continue;
      expect(m_layout.vertex_of_face(static_cast<Index>(f)) == m_layout.target(g), "vertex of face", face(f));
      if (!m_soup.is_triangle(m_soup_halfedge[g]))
        continue;
      for (const Index v : m_layout.vertices_of_face(static_cast<Index>(f))) {
        expect(v == m_layout.target(g), "vertices of face", face(f));
        g = m_layout.next(g);
      }
    }
  }

  void check_each_face()
  {
    const std::optional<std::size_t> wrong = first_wrong_visit(m_layout);
    expect(!wrong, "each face", face(wrong.value_or(0)));
  }

  void check_vertices()
  {
    for (std::size_t v = 0; v < m_soup.num_vertices() && m_difference.empty(); ++v) {
      const Index first = m_layout.halfedge_of_vertex(m_vertex[v]);
      const std::size_t degree = m_soup.degree(v);
      expect(m_layout.degree(m_vertex[v]) == degree, "degree", vertex(v));
      if (degree == 0) {
        expect(first == Layout::null_index(), "halfedge of an isolated vertex", vertex(v));
        continue;
      }
      expect(first < m_halfedge.size() && m_layout.target(first) == m_vertex[v], "halfedge of vertex", vertex(v));
      bool is_on_border = false;
      for (std::size_t i = 0; i < degree; ++i)
        is_on_border = is_on_border || m_soup.is_border(m_soup.out(v, i));
      if (m_difference.empty()) {
        expect(is_border(first) == is_on_border, "halfedge of a vertex on the border or not", vertex(v));
        check_cycle(v, first);
      }
    }
  }

  // All halfedges to v follow each other around v, whatever fans there are.
  void check_cycle(std::size_t v, Index first)
  {
    Index g = first;
    for (std::size_t i = 1; i <= m_soup.degree(v); ++i) {
      g = m_layout.opposite(m_layout.next(g));
      expect((g == first) == (i == m_soup.degree(v)), "cycle around vertex", vertex(v));
    }
  }

  void check_stars()
  {
    std::vector<Index> neighbors, visited;
    std::vector<std::array<Index, 2>> corners, visited_corners;
    for (std::size_t v = 0; v < m_soup.num_vertices() && m_difference.empty(); ++v) {
      neighbors.clear();
      visited.clear();
      corners.clear();
      visited_corners.clear();
      for (std::size_t i = 0; i < m_soup.degree(v); ++i) {
        const std::size_t h = m_soup.out(v, i);
        neighbors.push_back(m_vertex[m_soup.target(h)]);
        if (!m_soup.is_border(h))
          corners.push_back({m_vertex[m_soup.target(h)], m_vertex[m_soup.source(m_soup.prev(h))]});
      }
      m_layout.for_each_adjacent_vertex(m_vertex[v], [&](Index u) { visited.push_back(u); });
      m_layout.for_each_incident_triangle(m_vertex[v], [&](Index u, Index w) { visited_corners.push_back({u, w}); });
      expect(is_same_set(neighbors, visited), "adjacent vertices", vertex(v));
      expect(is_same_set(corners, visited_corners), "incident triangles", vertex(v));
    }
  }

  template <class T>
  static bool is_same_set(std::vector<T>& a, std::vector<T>& b)
  {
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    return a == b;
  }

  // All pairs if there are not many, otherwise random ones; and those that a hidden edge could
  // join: vertices of the same face or on both sides of an edge, and neighbors of a vertex.
  void check_vertices_that_are_not_adjacent()
  {
    const std::size_t n = m_soup.num_vertices();
    std::mt19937 rng(static_cast<std::mt19937::result_type>(n));
    for (std::size_t u = 0; u < n && m_difference.empty(); ++u) {
      check_pair(u, u);
      for (std::size_t i = 0; i < (n <= 64 ? n : 2); ++i)
        check_pair(u, n <= 64 ? i : rng() % n);
      if (const std::size_t degree = m_soup.degree(u))
        check_pair(m_soup.target(m_soup.out(u, rng() % degree)), m_soup.target(m_soup.out(u, rng() % degree)));
    }
    for (std::size_t h = 0; h < m_soup.num_sides() && m_difference.empty(); ++h) {
      const std::size_t following = m_soup.next(h), other = m_soup.opposite(h);
      check_pair(m_soup.source(h), m_soup.target(following));
      if (!m_soup.is_border(other))
        check_pair(m_soup.target(following), m_soup.target(m_soup.next(other)));
      if (following < h) { // the last side of a face, so that its first side follows
        const std::size_t degree = h + 1 - following;
        check_pair(m_soup.source(following + rng() % degree), m_soup.source(following + rng() % degree));
      }
    }
  }

  void check_pair(std::size_t u, std::size_t v)
  {
    const std::size_t h = m_soup.between(u, v);
    expect(m_layout.halfedge(m_vertex[u], m_vertex[v]) == (h == none ? Layout::null_index() : m_halfedge[h]),
           "halfedge(u, v)", {"vertices", u, v});
  }

  // One element, or two vertices.
  struct Place
  {
    const char* kind;
    std::size_t first, second;
  };

  static Place vertex(std::size_t v) { return {"vertex", v, none}; }
  static Place edge(std::size_t e) { return {"edge", e, none}; }
  static Place face(std::size_t f) { return {"face", f, none}; }
  Place halfedge(std::size_t h) const { return {"halfedge", m_soup.source(h), m_soup.target(h)}; }

  void expect(bool condition, const char* what, const Place& place)
  {
    if (condition || !m_difference.empty())
      return;
    m_difference = std::string(what) + " at " + place.kind + " " + std::to_string(place.first);
    if (place.second != none)
      m_difference += ", " + std::to_string(place.second);
  }

  void expect(bool condition, const char* what)
  {
    if (!condition && m_difference.empty())
      m_difference = what;
  }

  const Layout& m_layout;
  const Soup_halfedges m_soup;
  const std::vector<Index> m_vertex;
  const std::vector<Index> m_reported;
  std::vector<Index> m_halfedge;            // the layout's halfedge for each of the soup
  std::vector<std::size_t> m_soup_halfedge; // and conversely
  std::string m_difference;
};

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_SURFACE_ORACLE_H
