// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_DAMAGED_SOUPS_H
#define TEST_COMPACT_SURFACE_MESH_DAMAGED_SOUPS_H

// Small surfaces of all kinds as polygon soups, and soups with all kinds of defects.

#include "generated_triangulations.h"
#include "small_triangulations.h"
#include "soup_oracle.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace test {

inline Polygon_soup soup_of(std::size_t num_vertices, const Triangles& triangles)
{
  Polygon_soup soup{num_vertices, {}};
  for (const auto& t : triangles)
    soup.faces.push_back({t[0], t[1], t[2]});
  return soup;
}

inline Polygon_soup soup_of(const Soup& soup) { return soup_of(soup.num_vertices, soup.triangles); }

inline Polygon_soup tetrahedron() { return {4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}}; }

/// Moebius' torus of seven vertices.
inline Polygon_soup torus()
{
  Polygon_soup soup{7, {}};
  for (long long i = 0; i < 7; ++i) {
    soup.faces.push_back({i, (i + 1) % 7, (i + 3) % 7});
    soup.faces.push_back({i, (i + 3) % 7, (i + 2) % 7});
  }
  return soup;
}

/// `first` and `second` side by side.
inline Polygon_soup disjoint_union(Polygon_soup first, const Polygon_soup& second)
{
  for (auto face : second.faces) {
    for (long long& v : face)
      v += static_cast<long long>(first.num_vertices);
    first.faces.push_back(face);
  }
  first.num_vertices += second.num_vertices;
  return first;
}

/// Two vertices become one; the last vertex takes the name that is free then.
inline void merge_vertices(Polygon_soup& soup, long long u, long long v)
{
  const long long last = static_cast<long long>(--soup.num_vertices);
  if (u == last)
    std::swap(u, v);
  for (auto& face : soup.faces)
    for (long long& w : face)
      w = w == v ? u : (w == last ? v : w);
}

/// `first` and `second` glued along their last faces, which vanish: the handles add up.
inline Polygon_soup connected_sum(const Polygon_soup& first, const Polygon_soup& second)
{
  std::vector<long long> glued = first.faces.back(), with = second.faces.back();
  Polygon_soup soup = disjoint_union(first, second);
  soup.faces.pop_back();
  soup.faces.erase(soup.faces.begin() + static_cast<std::ptrdiff_t>(first.faces.size()) - 1);
  std::swap(with[0], with[1]);
  std::vector<long long> images(second.num_vertices, -1);
  for (int i = 0; i < 3; ++i)
    images[with[i]] = glued[i];
  soup.num_vertices = first.num_vertices;
  for (long long& v : images)
    if (v < 0)
      v = static_cast<long long>(soup.num_vertices++);
  for (auto& face : soup.faces)
    for (long long& v : face)
      if (v >= static_cast<long long>(first.num_vertices))
        v = images[static_cast<std::size_t>(v) - first.num_vertices];
  return soup;
}

/// Surfaces of all kinds that a Corner_table takes.
inline std::vector<Polygon_soup> small_surfaces()
{
  std::vector<Polygon_soup> surfaces{
    {0, {}}, {3, {}}, {3, {{0, 1, 2}}}, {3, {{0, 1, 2}, {0, 2, 1}}},
    {5, {{0, 1, 2}, {0, 3, 4}}},             // two open fans at a vertex
    {8, {{0, 1, 2}, {3, 4, 0}, {6, 0, 5}}},  // three of them, and an isolated vertex
    torus(), connected_sum(torus(), torus()), disjoint_union(torus(), tetrahedron()),
  };
  for (int n = 4; n <= 7; ++n)
    for (const Triangles& triangles : all_sphere_triangulations(n)) {
      surfaces.push_back(soup_of(static_cast<std::size_t>(n), triangles));
      for (const std::size_t removed : {1, 2, 4}) { // borders, some of which meet at a vertex
        surfaces.push_back(surfaces.back());
        auto& faces = surfaces.back().faces;
        faces.erase(faces.begin() + static_cast<std::ptrdiff_t>(removed % faces.size()));
      }
    }
  return surfaces;
}

/// The same soup, with names and orders of all things at random.
inline Polygon_soup shuffled(Polygon_soup soup, std::mt19937& rng)
{
  std::vector<long long> name(soup.num_vertices);
  std::iota(name.begin(), name.end(), 0);
  std::shuffle(name.begin(), name.end(), rng);
  std::shuffle(soup.faces.begin(), soup.faces.end(), rng);
  for (auto& face : soup.faces) {
    for (long long& v : face)
      if (v >= 0 && v < static_cast<long long>(name.size()))
        v = name[static_cast<std::size_t>(v)];
    if (!face.empty())
      std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(rng() % face.size()), face.end());
  }
  return soup;
}

/// One of the ways in which soups go wrong.
inline void damage(Polygon_soup& soup, std::mt19937& rng)
{
  const auto vertex = [&] { return static_cast<long long>(rng() % (std::max<std::size_t>)(1, soup.num_vertices)); };
  if (soup.faces.empty()) {
    soup.faces.push_back({vertex(), vertex(), vertex()});
    return;
  }
  const std::size_t f = rng() % soup.faces.size();
  auto& face = soup.faces[f];
  switch (rng() % 12) {
  case 0: std::reverse(face.begin(), face.end()); break;
  case 1: soup.faces.push_back(std::vector<long long>(face)); break;
  case 2: soup.faces.push_back({vertex(), vertex(), vertex()}); break;
  case 3: face[rng() % face.size()] = vertex(); break;
  case 4: ++soup.num_vertices; break;
  case 5: if (rng() % 2) face.push_back(vertex()); else if (face.size() > 1) face.pop_back(); break;
  case 6: face[rng() % face.size()] = rng() % 2 ? -1 : static_cast<long long>(soup.num_vertices); break;
  case 7: case 8:
    if (soup.num_vertices > 1) {
      const long long u = vertex(), v = vertex();
      if (u != v)
        merge_vertices(soup, u, v);
    }
    break;
  case 9: soup = disjoint_union(soup, tetrahedron()); break;
  default: soup.faces.erase(soup.faces.begin() + static_cast<std::ptrdiff_t>(f));
  }
}

/// One of `surfaces`, damaged or not; now and then, nothing but random triangles.
inline Polygon_soup random_soup(const std::vector<Polygon_soup>& surfaces, std::mt19937& rng)
{
  Polygon_soup soup;
  if (rng() % 8 == 0) {
    const auto vertex = [&] { return static_cast<long long>(rng() % 6); };
    soup.num_vertices = 3 + rng() % 5;
    for (std::size_t f = rng() % 5; f-- > 0;)
      soup.faces.push_back({vertex(), vertex(), vertex()});
  } else {
    soup = surfaces[rng() % surfaces.size()];
    for (std::size_t i = rng() % 4; i-- > 0;)
      damage(soup, rng);
  }
  return shuffled(soup, rng);
}

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_DAMAGED_SOUPS_H
