// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_GENERATED_SURFACES_H
#define TEST_COMPACT_SURFACE_MESH_GENERATED_SURFACES_H

// Surfaces of every kind that a mesh takes: closed ones (closed_surfaces.h), and those with
// borders, several components, isolated vertices and polygons, at random and of any size.

#include "closed_surfaces.h"
#include "damaged_soups.h"
#include "generated_triangulations.h"
#include "soup_oracle.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

namespace test {

/// The disk that is one polygon of `k` >= 3 sides.
inline Polygon_soup polygon(std::size_t k)
{
  Polygon_soup soup{k, {std::vector<long long>(k)}};
  std::iota(soup.faces[0].begin(), soup.faces[0].end(), 0);
  return soup;
}

/// The sphere that consists of two polygons with the same `k` >= 3 sides.
inline Polygon_soup pillow(std::size_t k)
{
  Polygon_soup soup = polygon(k);
  soup.faces.emplace_back(soup.faces[0].rbegin(), soup.faces[0].rend());
  return soup;
}

/// `a` times `b` squares.
inline Polygon_soup quad_grid(std::size_t a, std::size_t b)
{
  Polygon_soup soup{(a + 1) * (b + 1), {}};
  soup.faces.reserve(a * b);
  const long long row = static_cast<long long>(b) + 1;
  for (long long v = 0; v + row < static_cast<long long>(soup.num_vertices); ++v)
    if ((v + 1) % row != 0)
      soup.faces.push_back({v, v + row, v + row + 1, v + 1});
  return soup;
}

/// A `regular_sphere()` without `num_borders` random triangles, which have no common vertices.
inline Soup mesh_with_borders(std::uint32_t num_vertices, std::size_t num_borders, unsigned int seed)
{
  Soup soup = regular_sphere(num_vertices);
  const auto itself = [](std::size_t f) { return f; };
  std::vector<std::size_t> holes = disjoint_triangles(soup, soup.triangles.size(), num_borders, seed, itself);
  std::sort(holes.rbegin(), holes.rend());
  for (const std::size_t f : holes) {
    soup.triangles[f] = soup.triangles.back();
    soup.triangles.pop_back();
  }
  return soup;
}

/// `num_components` random triangulations of the sphere, each with the same number of
/// vertices, at least 4, or one more; `num_vertices` in all.
inline Soup many_components(std::uint32_t num_vertices, std::uint32_t num_components, unsigned int seed)
{
  Soup soup{0, {}};
  for (std::uint32_t i = 0; i < num_components; ++i) {
    const std::uint32_t n = num_vertices / num_components + (i < num_vertices % num_components ? 1 : 0);
    for (Triangle t : random_triangulation(n, seed + i).triangles) {
      for (std::uint32_t& v : t)
        v += soup.num_vertices;
      soup.triangles.push_back(t);
    }
    soup.num_vertices += n;
  }
  return soup;
}

/// What a `random_surface()` may consist of.
struct Surface_options
{
  std::uint32_t max_components = 3;
  std::uint32_t max_vertices = 40; ///< of a component, before faces are removed
  std::uint32_t max_genus = 3;     ///< of a component
  bool has_borders = true;         ///< and vertices where several of them meet
  bool has_polygons = true;
  bool has_isolated_vertices = true;
};

/// Makes a random surface, step by step.
class Surface_generator
{
public:
  Surface_generator(unsigned int seed, const Surface_options& options)
    : m_rng(seed), m_options(options), m_soup{0, {}}
  {}

  Polygon_soup operator()()
  {
    for (std::size_t i = 1 + below(m_options.max_components); i > 0; --i)
      m_soup = disjoint_union(std::move(m_soup), component());
    for (std::size_t i = m_options.has_borders ? below(4) : 0; i > 0; --i)
      pinch();
    if (m_options.has_polygons)
      merge_faces();
    rename_vertices();
    if (m_options.has_isolated_vertices && below(2) == 0)
      m_soup.num_vertices += below(4);
    return shuffled(std::move(m_soup), m_rng);
  }

private:
  using Directed_edges = std::unordered_map<std::uint64_t, std::size_t>;

  static std::uint64_t key(long long u, long long v)
  {
    return static_cast<std::uint64_t>(u) << 32 | static_cast<std::uint64_t>(v);
  }

  std::size_t below(std::size_t bound) { return m_rng() % bound; }

  Polygon_soup component()
  {
    if (below(8) == 0) {
      const std::size_t k = 3 + (m_options.has_polygons ? below(m_options.max_vertices) : 0);
      return m_options.has_borders && below(2) == 0 ? polygon(k) : pillow(k);
    }
    const std::uint32_t genus = static_cast<std::uint32_t>(below(m_options.max_genus + 1));
    const std::uint32_t least = genus == 0 ? 4 : 4 * genus + 3;
    const std::uint32_t range = (std::max)(least, m_options.max_vertices) - least + 1;
    const std::uint32_t n = least + static_cast<std::uint32_t>(below(range));
    Soup soup = closed_surface(genus, n, static_cast<unsigned int>(m_rng()));
    if (m_options.has_borders && below(4) != 0)
      cut_holes(soup);
    return soup_of(soup);
  }

  // Removes single triangles, and patches that grow from triangle to triangle by the stars of
  // vertices: from none to all of the surface, so that it may fall into pieces, too.
  void cut_holes(Soup& soup)
  {
    std::vector<std::vector<std::size_t>> triangles_at(soup.num_vertices);
    for (std::size_t f = 0; f < soup.triangles.size(); ++f)
      for (const std::uint32_t v : soup.triangles[f])
        triangles_at[v].push_back(f);
    std::vector<bool> is_removed(soup.triangles.size(), false);
    const std::size_t largest = below(4) == 0 ? soup.num_vertices / 4 + 1 : 3;
    for (std::size_t holes = 1 + below(below(2) == 0 ? 3 : soup.num_vertices / 8 + 1); holes > 0; --holes) {
      std::size_t f = below(soup.triangles.size());
      is_removed[f] = true;
      for (std::size_t stars = below(largest); stars > 0; --stars) {
        const std::uint32_t v = soup.triangles[f][below(3)];
        for (const std::size_t g : triangles_at[v])
          is_removed[g] = true;
        f = triangles_at[v][below(triangles_at[v].size())];
      }
    }
    Triangles left;
    for (std::size_t f = 0; f < soup.triangles.size(); ++f)
      if (!is_removed[f])
        left.push_back(soup.triangles[f]);
    soup.triangles = std::move(left);
  }

  // Each directed edge with its face.
  Directed_edges directed_edges() const
  {
    Directed_edges edges;
    for (std::size_t f = 0; f < m_soup.faces.size(); ++f)
      for (std::size_t i = 0; i < m_soup.faces[f].size(); ++i)
        edges[key(m_soup.faces[f][i], m_soup.faces[f][(i + 1) % m_soup.faces[f].size()])] = f;
    return edges;
  }

  // Makes one vertex of two random border vertices without a common neighbor or face.
  void pinch()
  {
    const Directed_edges edges = directed_edges();
    std::vector<long long> candidates;
    for (const auto& face : m_soup.faces)
      for (std::size_t i = 0; i < face.size(); ++i)
        if (edges.count(key(face[(i + 1) % face.size()], face[i])) == 0)
          candidates.push_back(face[i]);
    for (int tries = candidates.empty() ? 0 : 5; tries > 0; --tries) {
      const long long u = candidates[below(candidates.size())], v = candidates[below(candidates.size())];
      const std::set<long long> around = neighborhood(u);
      if (around.count(v) != 0)
        continue;
      const std::set<long long> others = neighborhood(v);
      if (std::none_of(others.begin(), others.end(), [&](long long w) { return around.count(w) != 0; }))
        return merge_vertices(m_soup, u, v);
    }
  }

  // The vertices of all faces at v.
  std::set<long long> neighborhood(long long v) const
  {
    std::set<long long> vertices;
    for (const auto& face : m_soup.faces)
      if (std::find(face.begin(), face.end(), v) != face.end())
        vertices.insert(face.begin(), face.end());
    return vertices;
  }

  // Removes some or all of the edges between two faces that have nothing but that edge in
  // common, up to some number of sides.
  void merge_faces()
  {
    Directed_edges edges = directed_edges();
    const std::size_t max_sides = std::vector<std::size_t>{3, 4, 8, m_soup.num_vertices}[below(4)];
    const std::size_t percentage = std::vector<std::size_t>{10, 50, 100}[below(3)];
    std::vector<std::pair<long long, long long>> candidates;
    for (const auto& face : m_soup.faces)
      for (std::size_t i = 0; i < face.size(); ++i) {
        const std::pair<long long, long long> edge(face[i], face[(i + 1) % face.size()]);
        if (edge.first < edge.second && edges.count(key(edge.second, edge.first)) != 0 && below(100) < percentage)
          candidates.push_back(edge);
      }
    std::shuffle(candidates.begin(), candidates.end(), m_rng);
    for (const auto& edge : candidates)
      merge_along(edge.first, edge.second, max_sides, edges);
    m_soup.faces.erase(std::remove(m_soup.faces.begin(), m_soup.faces.end(), std::vector<long long>()),
                       m_soup.faces.end());
  }

  void merge_along(long long u, long long v, std::size_t max_sides, Directed_edges& edges)
  {
    const std::size_t f = edges.at(key(u, v)), g = edges.at(key(v, u));
    std::vector<long long>& into = m_soup.faces[f];
    std::vector<long long>& from = m_soup.faces[g];
    if (into.size() + from.size() - 2 > max_sides)
      return;
    const std::set<long long> vertices(into.begin(), into.end());
    if (std::count_if(from.begin(), from.end(), [&](long long w) { return vertices.count(w) != 0; }) != 2)
      return;
    for (std::size_t i = 0; i < from.size(); ++i)
      edges[key(from[i], from[(i + 1) % from.size()])] = f;
    // (v, ..., u) and (u, x, ..., v): the inner vertices of the second go to the end of the first
    std::rotate(into.begin(), std::find(into.begin(), into.end(), v), into.end());
    std::rotate(from.begin(), std::find(from.begin(), from.end(), u), from.end());
    into.insert(into.end(), from.begin() + 1, from.end() - 1);
    from.clear();
  }

  // Vertices that have lost all of their faces stay or go.
  void rename_vertices()
  {
    if (m_options.has_isolated_vertices && below(2) == 0)
      return;
    std::vector<long long> name(m_soup.num_vertices, -1);
    m_soup.num_vertices = 0;
    for (auto& face : m_soup.faces)
      for (long long& v : face) {
        if (name[static_cast<std::size_t>(v)] < 0)
          name[static_cast<std::size_t>(v)] = static_cast<long long>(m_soup.num_vertices++);
        v = name[static_cast<std::size_t>(v)];
      }
  }

  std::mt19937 m_rng;
  const Surface_options m_options;
  Polygon_soup m_soup;
};

/// An oriented manifold without double edges, made of random components of all kinds that
/// `options` allows. Several fans at a vertex are all open. Two faces may have several separate
/// vertices and edges in common.
inline Polygon_soup random_surface(unsigned int seed, const Surface_options& options = Surface_options())
{
  return Surface_generator(seed, options)();
}

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_GENERATED_SURFACES_H
