// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_GLUED_POLYGONS_H
#define TEST_COMPACT_SURFACE_MESH_GLUED_POLYGONS_H

// Oriented surfaces of polygons on which several edges may have the same ends, as soups
// cannot: it is told which sides are glued.

#include "soup_oracle.h"

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <ostream>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace test {

/// Polygons whose sides, counted face by face, are glued in pairs.
struct Glued_polygons
{
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  Polygon_soup soup;
  std::vector<std::size_t> opposite; ///< of each side, `none` on a border
};

inline std::ostream& operator<<(std::ostream& out, const Glued_polygons& polygons)
{
  out << polygons.soup << ", sides glued to";
  for (const std::size_t o : polygons.opposite)
    o == Glued_polygons::none ? out << " -" : out << ' ' << o;
  return out;
}

/// The ends of all sides.
inline std::vector<std::pair<std::size_t, std::size_t>> ends_of_sides(const Polygon_soup& soup)
{
  std::vector<std::pair<std::size_t, std::size_t>> ends;
  for (const auto& face : soup.faces)
    for (std::size_t i = 0; i < face.size(); ++i)
      ends.emplace_back(face[i], face[(i + 1) % face.size()]);
  return ends;
}

/// The sides of a soup, an oriented manifold, glued where they have the same ends.
inline Glued_polygons glued_by_ends(const Polygon_soup& soup)
{
  const auto ends = ends_of_sides(soup);
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> sides;
  for (std::size_t s = 0; s < ends.size(); ++s)
    sides.emplace(ends[s], s);
  Glued_polygons polygons{soup, std::vector<std::size_t>(ends.size(), Glued_polygons::none)};
  for (std::size_t s = 0; s < ends.size(); ++s) {
    const auto it = sides.find({ends[s].second, ends[s].first});
    if (it != sides.end())
      polygons.opposite[s] = it->second;
  }
  return polygons;
}

inline void glue(Glued_polygons& polygons, std::size_t s, std::size_t t)
{
  polygons.opposite[s] = t;
  polygons.opposite[t] = s;
}

/// The torus of the vertices 0, ..., n - 1 and the parallelograms (k, k+1, k+1+s, k+s) modulo
/// n, each cut into two triangles or not. With n = 7 and s = 3, it is Moebius' torus.
inline Glued_polygons helical_torus(std::size_t n, std::size_t s, bool triangles)
{
  Glued_polygons torus{{n, {}}, std::vector<std::size_t>(triangles ? 6 * n : 4 * n, Glued_polygons::none)};
  const auto vertex = [=](std::size_t k) { return static_cast<long long>(k % n); };
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t above = (k + s) % n, right = (k + 1) % n;
    if (triangles) {
      torus.soup.faces.push_back({vertex(k), vertex(k + 1), vertex(k + s)});
      torus.soup.faces.push_back({vertex(k + 1), vertex(k + 1 + s), vertex(k + s)});
      glue(torus, 6 * k + 1, 6 * k + 5);
      glue(torus, 6 * k + 4, 6 * above);
      glue(torus, 6 * k + 3, 6 * right + 2);
    } else {
      torus.soup.faces.push_back({vertex(k), vertex(k + 1), vertex(k + 1 + s), vertex(k + s)});
      glue(torus, 4 * k + 2, 4 * above);
      glue(torus, 4 * k + 1, 4 * right + 3);
    }
  }
  return torus;
}

namespace detail {

inline bool has_repeated_vertex(const Polygon_soup& soup)
{
  return std::any_of(soup.faces.begin(), soup.faces.end(), [](const std::vector<long long>& face) {
    return std::set<long long>(face.begin(), face.end()).size() != face.size();
  });
}

// Two vertices become one, unless a face then has it twice; names get gaps.
inline bool identify(Polygon_soup& soup, const std::vector<std::pair<long long, long long>>& vertices)
{
  Polygon_soup identified = soup;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    long long u = vertices[i].first, v = vertices[i].second;
    for (std::size_t j = 0; j < i; ++j) { // they may have a new name already
      u = u == vertices[j].second ? vertices[j].first : u;
      v = v == vertices[j].second ? vertices[j].first : v;
    }
    for (auto& face : identified.faces)
      std::replace(face.begin(), face.end(), v, u);
  }
  if (has_repeated_vertex(identified))
    return false;
  soup = identified;
  return true;
}

// Names vertices without gaps, at random, and some more that are isolated.
inline void rename_vertices(Polygon_soup& soup, std::size_t num_isolated, std::mt19937& rng)
{
  std::map<long long, long long> name;
  for (const auto& face : soup.faces)
    for (const long long v : face)
      name.emplace(v, 0);
  soup.num_vertices = name.size() + num_isolated;
  std::vector<long long> names;
  for (std::size_t i = 0; i < soup.num_vertices; ++i)
    names.push_back(static_cast<long long>(i));
  std::shuffle(names.begin(), names.end(), rng);
  for (auto& entry : name) {
    entry.second = names.back();
    names.pop_back();
  }
  for (auto& face : soup.faces)
    for (long long& v : face)
      v = name[v];
}

} // namespace detail

/// Random polygons, glued at random along pairs of sides, and at pairs of border vertices, as
/// long as no face has a vertex twice. Many edges have the same ends.
inline Glued_polygons random_glued_polygons(std::mt19937& rng)
{
  Glued_polygons polygons{{0, {}}, {}};
  for (std::size_t f = 1 + rng() % 8; f-- > 0;) {
    const std::size_t size = rng() % 8 == 0 ? 3 + rng() % 9 : 3 + rng() % 3;
    polygons.soup.faces.emplace_back();
    for (std::size_t i = 0; i < size; ++i)
      polygons.soup.faces.back().push_back(static_cast<long long>(polygons.soup.num_vertices++));
  }
  const std::size_t num_sides = polygons.soup.num_vertices;
  polygons.opposite.assign(num_sides, Glued_polygons::none);
  for (std::size_t attempts = rng() % (10 * num_sides); attempts-- > 0;) {
    const std::size_t s = rng() % num_sides, t = rng() % num_sides;
    const auto ends = ends_of_sides(polygons.soup);
    const auto end = [](std::size_t v) { return static_cast<long long>(v); };
    if (s != t && polygons.opposite[s] == Glued_polygons::none && polygons.opposite[t] == Glued_polygons::none
        && detail::identify(polygons.soup, {{end(ends[s].first), end(ends[t].second)},
                                            {end(ends[s].second), end(ends[t].first)}}))
      glue(polygons, s, t);
  }
  for (std::size_t attempts = rng() % 3 == 0 ? rng() % num_sides : 0; attempts-- > 0;) {
    const std::size_t s = rng() % num_sides, t = rng() % num_sides;
    const auto ends = ends_of_sides(polygons.soup);
    if (polygons.opposite[s] == Glued_polygons::none && polygons.opposite[t] == Glued_polygons::none)
      detail::identify(polygons.soup, {{static_cast<long long>(ends[s].first), static_cast<long long>(ends[t].first)}});
  }
  detail::rename_vertices(polygons.soup, rng() % 3, rng);
  return polygons;
}

/// The faces of a graph, each from `halfedge(f, g)` on, and how it glues them.
template <class FaceGraph, class VertexIndexMap>
Glued_polygons polygons_of(const FaceGraph& g, const VertexIndexMap& vertex_index)
{
  using Halfedge = typename boost::graph_traits<FaceGraph>::halfedge_descriptor;
  std::vector<Halfedge> sides;
  Glued_polygons polygons{{static_cast<std::size_t>(std::distance(vertices(g).begin(), vertices(g).end())), {}}, {}};
  for (const auto f : faces(g)) {
    polygons.soup.faces.emplace_back();
    Halfedge h = halfedge(f, g);
    do {
      sides.push_back(h);
      polygons.soup.faces.back().push_back(static_cast<long long>(get(vertex_index, source(h, g))));
      h = next(h, g);
    } while (h != halfedge(f, g));
  }
  for (const Halfedge h : sides) { // quadratic time
    const auto it = std::find(sides.begin(), sides.end(), opposite(h, g));
    polygons.opposite.push_back(it == sides.end() ? Glued_polygons::none
                                                  : static_cast<std::size_t>(it - sides.begin()));
  }
  return polygons;
}

/// The same as a graph, for instance a `Surface_mesh`. The fans at a vertex remain apart along
/// the border: each has a border of its own.
template <class Mesh>
Mesh graph_of(const Glued_polygons& polygons)
{
  Mesh mesh;
  const auto ends = ends_of_sides(polygons.soup);
  std::vector<typename Mesh::Vertex_index> vertex;
  for (std::size_t v = 0; v < polygons.soup.num_vertices; ++v)
    vertex.push_back(mesh.add_vertex());
  std::vector<typename Mesh::Halfedge_index> halfedge(ends.size());
  for (std::size_t s = 0; s < ends.size(); ++s) {
    const std::size_t o = polygons.opposite[s];
    halfedge[s] = o < s ? mesh.opposite(halfedge[o]) : mesh.add_edge();
    mesh.set_target(halfedge[s], vertex[ends[s].second]);
    mesh.set_halfedge(vertex[ends[s].second], halfedge[s]);
    if (o == Glued_polygons::none)
      mesh.set_target(mesh.opposite(halfedge[s]), vertex[ends[s].first]);
  }
  std::size_t first = 0;
  for (const auto& face : polygons.soup.faces) {
    const auto f = mesh.add_face();
    mesh.set_halfedge(f, halfedge[first]);
    for (std::size_t i = 0; i < face.size(); ++i) {
      mesh.set_face(halfedge[first + i], f);
      mesh.set_next(halfedge[first + i], halfedge[first + (i + 1) % face.size()]);
    }
    first += face.size();
  }
  for (const auto h : mesh.halfedges()) {
    if (!mesh.is_border(h))
      continue;
    auto following = mesh.opposite(h);
    while (!mesh.is_border(following))
      following = mesh.opposite(mesh.prev(following));
    mesh.set_next(h, following);
    mesh.set_halfedge(mesh.target(h), h);
  }
  return mesh;
}

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_GLUED_POLYGONS_H
