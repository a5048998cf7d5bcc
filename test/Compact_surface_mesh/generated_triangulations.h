// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_GENERATED_TRIANGULATIONS_H
#define TEST_COMPACT_SURFACE_MESH_GENERATED_TRIANGULATIONS_H

// Simple triangulations of the sphere of any size, as soups: regular ones, random ones,
// and those with the largest possible degrees.

#include "small_triangulations.h"

#include <CGAL/Schnyder_woods/random_planar_triangulation.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

namespace test {

/// Triangles, each counterclockwise, over the vertices 0, ..., `num_vertices` - 1.
struct Soup
{
  std::uint32_t num_vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Each triangle of a closed surface cut into four at the middles of its edges.
/// The vertices of `soup` come first.
inline Soup subdivided(const Soup& soup)
{
  const Oriented_map map(soup.triangles);
  std::vector<std::uint32_t> middle(map.num_halfedges());
  Soup result{soup.num_vertices, {}};
  for (std::uint32_t h = 0; h < map.num_halfedges(); ++h)
    middle[h] = h < map.opposite(h) ? result.num_vertices++ : middle[map.opposite(h)];
  result.triangles.reserve(4 * soup.triangles.size());
  for (std::uint32_t h = 0; h < map.num_halfedges(); h += 3) {
    const Triangle corners = soup.triangles[h / 3];
    const Triangle middles{middle[h], middle[h + 1], middle[h + 2]};
    result.triangles.push_back({corners[0], middles[0], middles[2]});
    result.triangles.push_back({middles[0], corners[1], middles[1]});
    result.triangles.push_back({middles[2], middles[1], corners[2]});
    result.triangles.push_back(middles);
  }
  return result;
}

/// An octahedron, subdivided: 4^(subdivisions + 1) + 2 vertices, six of degree 4 and all
/// others of degree 6.
inline Soup octasphere(int subdivisions)
{
  Soup soup{6, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}}};
  for (int i = 0; i < subdivisions; ++i)
    soup = subdivided(soup);
  return soup;
}

/// A globe: two poles, 0 and 1, and between them `num_circles` circles of `num_meridians`
/// vertices, which are numbered row by row. With one circle, it is a double wheel.
inline Soup globe(std::uint32_t num_circles, std::uint32_t num_meridians)
{
  Soup soup{2 + num_circles * num_meridians, {}};
  soup.triangles.reserve(2 * std::size_t(soup.num_vertices) - 4);
  const auto vertex = [=](std::uint32_t circle, std::uint32_t meridian) {
    return 2 + circle * num_meridians + meridian % num_meridians;
  };
  for (std::uint32_t m = 0; m < num_meridians; ++m) {
    soup.triangles.push_back({0, vertex(0, m), vertex(0, m + 1)});
    for (std::uint32_t c = 0; c + 1 < num_circles; ++c) {
      soup.triangles.push_back({vertex(c, m), vertex(c + 1, m), vertex(c, m + 1)});
      soup.triangles.push_back({vertex(c + 1, m), vertex(c + 1, m + 1), vertex(c, m + 1)});
    }
    soup.triangles.push_back({1, vertex(num_circles - 1, m + 1), vertex(num_circles - 1, m)});
  }
  return soup;
}

/// A circle of n - 2 >= 3 vertices, all of which are adjacent to both of the hubs 0 and 1.
inline Soup double_wheel(std::uint32_t n)
{
  return globe(1, n - 2);
}

/// Replaces triangle `f` = (`a`,`b`,`c`) by the three triangles around a new vertex `x`:
/// (`a`,`b`,`x`) in its place, (`b`,`c`,`x`) and (`c`,`a`,`x`) at the end.
inline void insert_vertex(Soup& soup, std::size_t f)
{
  const Triangle t = soup.triangles[f];
  const std::uint32_t x = soup.num_vertices++;
  soup.triangles[f] = {t[0], t[1], x};
  soup.triangles.push_back({t[1], t[2], x});
  soup.triangles.push_back({t[2], t[0], x});
}

/// A tetrahedron, with vertices inserted into random triangles until there are n >= 4 of them.
inline Soup stacked_triangulation(std::uint32_t n, unsigned int seed)
{
  Soup soup{4, double_fan(4)};
  std::mt19937 rng(seed);
  while (soup.num_vertices < n)
    insert_vertex(soup, rng() % soup.triangles.size());
  return soup;
}

/// A tetrahedron, with vertices inserted into random triangles at vertex 0, the hub, until
/// there are n >= 4 of them: the hub has degree n - 1, and some of its neighbors have large
/// degrees as well. Without randomness, `double_fan()` has two hubs of degree n - 1.
inline Soup stacked_at_hub(std::uint32_t n, unsigned int seed = 1)
{
  Soup soup{4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
  std::vector<std::size_t> at_hub{0, 1, 2}; // triangles that start with the hub
  std::mt19937 rng(seed);
  while (soup.num_vertices < n) {
    insert_vertex(soup, at_hub[rng() % at_hub.size()]);
    std::array<std::uint32_t, 3>& last = soup.triangles.back();
    std::rotate(last.begin(), last.begin() + 1, last.end());
    at_hub.push_back(soup.triangles.size() - 1);
  }
  return soup;
}

/// A uniform random triangulation with n >= 3 vertices.
inline Soup random_triangulation(std::uint32_t n, unsigned int seed)
{
  CGAL::Random rng(seed);
  return Soup{n, CGAL::random_planar_triangulation(n, rng)};
}

/// The same surface: vertices renamed, triangles in another order and turned, all at random.
inline Soup shuffled(Soup soup, unsigned int seed)
{
  std::mt19937 rng(seed);
  std::vector<std::uint32_t> name(soup.num_vertices);
  std::iota(name.begin(), name.end(), 0u);
  std::shuffle(name.begin(), name.end(), rng);
  std::shuffle(soup.triangles.begin(), soup.triangles.end(), rng);
  for (auto& triangle : soup.triangles) {
    for (std::uint32_t& v : triangle)
      v = name[v];
    std::rotate(triangle.begin(), triangle.begin() + rng() % 3, triangle.end());
  }
  return soup;
}

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_GENERATED_TRIANGULATIONS_H
