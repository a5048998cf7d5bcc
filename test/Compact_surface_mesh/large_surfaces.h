// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_LARGE_SURFACES_H
#define TEST_COMPACT_SURFACE_MESH_LARGE_SURFACES_H

// Regular surfaces of any size whose bytes and times are measured, beside those of
// generated_surfaces.h.

#include "generated_surfaces.h"

#include <CGAL/Compact_surface_mesh/Corner_table.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace test {

/// A disk of `a` times `b` squares, each cut into two triangles.
inline Soup triangle_grid(std::uint32_t a, std::uint32_t b)
{
  Soup soup{(a + 1) * (b + 1), {}};
  soup.triangles.reserve(2 * std::size_t(a) * b);
  for (std::uint32_t i = 0; i < a; ++i)
    for (std::uint32_t j = 0; j < b; ++j) {
      const std::uint32_t v = i * (b + 1) + j, below = v + b + 1;
      soup.triangles.push_back({v, below, v + 1});
      soup.triangles.push_back({below, below + 1, v + 1});
    }
  return soup;
}

/// A `globe()` with one polygon in place of the triangles around its north pole.
inline Polygon_soup globe_with_polygon(std::uint32_t num_circles, std::uint32_t num_sides)
{
  const Soup with_pole = globe(num_circles, num_sides);
  Polygon_soup soup = polygon(num_sides);
  soup.num_vertices = with_pole.num_vertices - 1;
  // the south pole takes the name of the north pole, and so the first circle has vertices 1, 2, ...
  for (long long& v : soup.faces[0])
    ++v;
  for (const Triangle& t : with_pole.triangles)
    if (std::find(t.begin(), t.end(), 0u) == t.end())
      soup.faces.push_back({static_cast<long long>(t[0]) - 1, static_cast<long long>(t[1]) - 1,
                            static_cast<long long>(t[2]) - 1});
  return soup;
}

/// How many nodes `scaffold()` wants in each direction, subdivided twice, for about so many vertices.
inline int scaffold_size(std::size_t num_vertices)
{
  return (std::max)(2, static_cast<int>(std::lround(std::cbrt(static_cast<double>(num_vertices) / 183))));
}

/// `mesh_with_borders()`, with pairs of vertices of different borders made one: half as many vertices
/// with two fans as there are borders.
inline Soup mesh_with_pinched_vertices(std::uint32_t num_vertices, std::size_t num_borders, unsigned int seed)
{
  Soup soup = mesh_with_borders(num_vertices, num_borders, seed);
  const CGAL::Corner_table<> table(soup.num_vertices, soup.triangles);
  std::vector<std::uint32_t> chosen; // one of each border, which is a triangle
  std::vector<bool> is_taken(soup.num_vertices, false);
  for (std::uint32_t h = 0; h < table.num_halfedges(); ++h)
    if (table.opposite(h) == table.null() && !is_taken[table.source(h)] && !is_taken[table.target(h)]) {
      chosen.push_back(table.source(h));
      is_taken[table.source(h)] = is_taken[table.target(h)] = true;
    }
  // vertices are numbered row by row, so those of a pair are far from each other
  std::sort(chosen.begin(), chosen.end());
  std::vector<std::uint32_t> image(soup.num_vertices);
  std::iota(image.begin(), image.end(), 0u);
  const std::size_t num_pairs = chosen.size() / 2;
  for (std::size_t i = 0; i < num_pairs; ++i)
    image[chosen[i + num_pairs]] = chosen[i];
  // an image is smaller than what it is the image of
  std::uint32_t num_left = 0;
  for (std::uint32_t v = 0; v < soup.num_vertices; ++v)
    image[v] = image[v] == v ? num_left++ : image[image[v]];
  for (Triangle& t : soup.triangles)
    for (std::uint32_t& v : t)
      v = image[v];
  soup.num_vertices = num_left;
  return soup;
}

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_LARGE_SURFACES_H
