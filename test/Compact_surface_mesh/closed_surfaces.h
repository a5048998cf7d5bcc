// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_CLOSED_SURFACES_H
#define TEST_COMPACT_SURFACE_MESH_CLOSED_SURFACES_H

// Simple triangulations of closed surfaces of any genus: all small ones of the torus, random
// ones, and regular ones of any size.

#include "damaged_soups.h"
#include "generated_triangulations.h"
#include "small_triangulations.h"
#include "soup_oracle.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

namespace test {

/// A polygon soup, all of whose faces are triangles, as a soup of triangles.
inline Soup triangle_soup(const Polygon_soup& polygons)
{
  Soup soup{static_cast<std::uint32_t>(polygons.num_vertices), {}};
  for (const auto& face : polygons.faces)
    soup.triangles.push_back({static_cast<std::uint32_t>(face.at(0)), static_cast<std::uint32_t>(face.at(1)),
                              static_cast<std::uint32_t>(face.at(2))});
  return soup;
}

/// All simple triangulations of the torus with n >= 7 vertices, one of each class of
/// oriented maps, by their canonical codes in ascending order. They are connected by flips
/// (Dewdney, Wagner's theorem for torus graphs, 1973).
inline std::vector<Triangles> all_torus_triangulations(int n)
{
  Soup soup = triangle_soup(torus());
  if (n < static_cast<int>(soup.num_vertices))
    throw std::invalid_argument("a simple triangulation of the torus has 7 vertices or more");
  while (soup.num_vertices < static_cast<std::uint32_t>(n))
    insert_vertex(soup, 0);
  return reachable_by_flips(soup.triangles);
}

/// `num_tori` >= 1 tori of seven vertices in a row, each glued to the next one along a face
/// that vanishes: 4 `num_tori` + 3 vertices, and as many handles as tori.
inline Soup chain_of_tori(std::uint32_t num_tori)
{
  const Soup link = triangle_soup(torus());
  // two faces without a common vertex
  const std::size_t in = 0, out = 5;
  Soup chain{0, {}};
  std::array<std::uint32_t, 3> end{};
  for (std::uint32_t i = 0; i < num_tori; ++i) {
    constexpr std::uint32_t unnamed = static_cast<std::uint32_t>(-1);
    std::vector<std::uint32_t> name(link.num_vertices, unnamed);
    if (i > 0)
      for (std::size_t j = 0; j < 3; ++j)
        name[link.triangles[in][j]] = end[(3 - j) % 3];
    for (std::uint32_t& v : name)
      if (v == unnamed)
        v = chain.num_vertices++;
    for (std::size_t f = 0; f < link.triangles.size(); ++f) {
      const Triangle& t = link.triangles[f];
      const Triangle named{name[t[0]], name[t[1]], name[t[2]]};
      if (f == out)
        end = named;
      if ((f != in || i == 0) && (f != out || i + 1 == num_tori))
        chain.triangles.push_back(named);
    }
  }
  return chain;
}

/// The six triangles of a tube from the hole that triangle `first` leaves to that of `second`.
inline std::array<Triangle, 6> tube(const Triangle& first, const Triangle& second)
{
  std::array<Triangle, 6> triangles{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    triangles[2 * i] = {first[i], first[j], second[(3 - i) % 3]};
    triangles[2 * i + 1] = {second[(3 - j) % 3], second[(3 - i) % 3], first[j]};
  }
  return triangles;
}

/// A closed surface, triangulated without double edges, that changes and remains so.
class Flippable_surface
{
public:
  explicit Flippable_surface(Soup soup) : m_soup(std::move(soup))
  {
    m_halfedge.reserve(4 * m_soup.triangles.size());
    for (std::size_t f = 0; f < m_soup.triangles.size(); ++f)
      insert_halfedges(f);
  }

  const Soup& soup() const { return m_soup; }
  std::size_t num_halfedges() const { return 3 * m_soup.triangles.size(); }

  /// Replaces the edge of side `h` % 3 of triangle `h` / 3 by the other diagonal of its two
  /// triangles where that makes no double edge. Expected constant time.
  bool flip(std::size_t h)
  {
    const std::size_t o = m_halfedge.at(key(target(h), vertex(h)));
    const std::uint32_t a = vertex(h), b = vertex(o), left = apex(h), right = apex(o);
    if (is_adjacent(left, right))
      return false;
    replace(h / 3, {a, right, left});
    replace(o / 3, {b, left, right});
    m_halfedge.erase(key(a, b));
    m_halfedge.erase(key(b, a));
    return true;
  }

  /// Adds a handle between two triangles where that makes no double edge.
  bool add_handle(std::size_t f, std::size_t g)
  {
    for (const std::uint32_t u : m_soup.triangles[f])
      for (const std::uint32_t v : m_soup.triangles[g])
        if (u == v || is_adjacent(u, v))
          return false;
    const std::array<Triangle, 6> triangles = tube(m_soup.triangles[f], m_soup.triangles[g]);
    replace(f, triangles[0]);
    replace(g, triangles[1]);
    for (std::size_t i = 2; i < triangles.size(); ++i) {
      m_soup.triangles.push_back(triangles[i]);
      insert_halfedges(m_soup.triangles.size() - 1);
    }
    return true;
  }

private:
  static std::uint64_t key(std::uint32_t u, std::uint32_t v) { return std::uint64_t(u) << 32 | v; }
  std::uint32_t vertex(std::size_t h) const { return m_soup.triangles[h / 3][h % 3]; }
  std::uint32_t target(std::size_t h) const { return m_soup.triangles[h / 3][(h + 1) % 3]; }
  std::uint32_t apex(std::size_t h) const { return m_soup.triangles[h / 3][(h + 2) % 3]; }
  bool is_adjacent(std::uint32_t u, std::uint32_t v) const { return m_halfedge.count(key(u, v)) != 0; }

  void insert_halfedges(std::size_t f)
  {
    for (std::size_t h = 3 * f; h < 3 * f + 3; ++h)
      m_halfedge[key(vertex(h), target(h))] = h;
  }

  void replace(std::size_t f, const Triangle& triangle)
  {
    m_soup.triangles[f] = triangle;
    insert_halfedges(f);
  }

  Soup m_soup;
  std::unordered_map<std::uint64_t, std::size_t> m_halfedge; // from the ends to the side of a triangle
};

/// A random triangulation of the surface of genus `genus` with `num_vertices` vertices, at
/// least 4, and 4 `genus` + 3 with handles: a random triangulation of the sphere with handles
/// between random triangles or, where vertices are few, a chain of tori with inserted
/// vertices; then with handles random flips, five times as many attempts as there are edges,
/// so that the handles are everywhere.
inline Soup closed_surface(std::uint32_t genus, std::uint32_t num_vertices, unsigned int seed)
{
  if (num_vertices < 4 || (genus > 0 && num_vertices < 4 * genus + 3))
    throw std::invalid_argument("too few vertices for a surface of this genus");
  if (genus == 0)
    return random_triangulation(num_vertices, seed);
  std::mt19937 rng(seed);
  const bool are_vertices_few = num_vertices < 16 * genus + 8;
  Soup start = are_vertices_few ? chain_of_tori(genus) : random_triangulation(num_vertices, seed);
  while (start.num_vertices < num_vertices)
    insert_vertex(start, rng() % start.triangles.size());
  Flippable_surface surface(std::move(start));
  for (std::uint32_t handles = are_vertices_few ? genus : 0; handles < genus;) {
    const std::size_t num_faces = surface.soup().triangles.size(), f = rng() % num_faces;
    if (surface.add_handle(f, rng() % num_faces))
      ++handles;
    else
      surface.flip(rng() % surface.num_halfedges());
  }
  for (std::size_t i = 5 * surface.num_halfedges() / 2; i > 0; --i)
    surface.flip(rng() % surface.num_halfedges());
  return surface.soup();
}

/// The octahedron |x| + |y| + |z| = m with all of its points with whole coordinates: 4 m^2 + 2
/// vertices, six of degree 4 and all others of degree 6, and 8 m^2 triangles. Those of the
/// second half lie opposite to those of the first half, in the same order.
inline Soup octahedron(int m)
{
  const auto vertex = [m](int x, int y, int z) {
    // Row by row of constant z; with |z| = m - r, a row has 4 r vertices, and poles have one.
    const int r = m - std::abs(z);
    const int around = y >= 0 && x > 0 ? y : (x <= 0 && y > 0 ? r - x : (x < 0 ? 2 * r - y : 3 * r + x));
    const int above = z >= 0 ? (r == 0 ? 0 : 1 + 2 * r * (r - 1))
                             : 4 * m * m + 2 - (1 + 2 * r * (r + 1));
    return static_cast<std::uint32_t>(above + (r == 0 ? 0 : around));
  };
  Soup soup{static_cast<std::uint32_t>(4 * m * m + 2), {}};
  soup.triangles.reserve(8 * static_cast<std::size_t>(m) * static_cast<std::size_t>(m));
  for (const std::array<int, 3> s : {std::array<int, 3>{1, 1, 1}, {-1, 1, 1}, {-1, -1, 1}, {1, -1, 1},
                                     {-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}}) {
    const bool is_turned = s[0] * s[1] * s[2] < 0;
    const auto add = [&](int x, int y, const std::array<int, 3>& dx, const std::array<int, 3>& dy) {
      Triangle t;
      for (std::size_t i = 0; i < 3; ++i) {
        const int px = x + dx[i], py = y + dy[i];
        t[is_turned ? 2 - i : i] = vertex(s[0] * px, s[1] * py, s[2] * (m - px - py));
      }
      soup.triangles.push_back(t);
    };
    for (int x = 0; x < m; ++x)
      for (int y = 0; x + y < m; ++y) {
        add(x, y, {0, 1, 0}, {0, 0, 1});
        if (x + y + 1 < m)
          add(x, y, {1, 1, 0}, {0, 1, 1});
      }
  }
  return soup;
}

/// The smallest `octahedron()` with `num_vertices` vertices or more.
inline Soup regular_sphere(std::uint32_t num_vertices)
{
  int m = 1;
  while (4 * static_cast<std::uint64_t>(m) * static_cast<std::uint64_t>(m) + 2 < num_vertices)
    ++m;
  return octahedron(m);
}

/// Indices below `num_faces` of `num_chosen` random triangles of `soup`. No two of them have a
/// common vertex, nor have their images under `partner`, which are not listed.
template <class Partner>
std::vector<std::size_t> disjoint_triangles(const Soup& soup, std::size_t num_faces, std::size_t num_chosen,
                                            unsigned int seed, const Partner& partner)
{
  std::mt19937 rng(seed);
  std::vector<bool> is_taken(soup.num_vertices, false);
  std::vector<std::size_t> chosen;
  const auto is_free = [&](const Triangle& t) { return !is_taken[t[0]] && !is_taken[t[1]] && !is_taken[t[2]]; };
  for (std::size_t tries = 100 * num_faces; chosen.size() < num_chosen && tries > 0; --tries) {
    const std::size_t f = rng() % num_faces;
    if (!is_free(soup.triangles[f]) || !is_free(soup.triangles[partner(f)]))
      continue;
    chosen.push_back(f);
    for (const std::size_t g : {f, partner(f)})
      for (const std::uint32_t v : soup.triangles[g])
        is_taken[v] = true;
  }
  if (chosen.size() < num_chosen)
    throw std::invalid_argument("too few triangles for so many without common vertices");
  return chosen;
}

/// A `regular_sphere()` with `genus` handles, each between opposite triangles.
inline Soup sphere_with_far_handles(std::uint32_t num_vertices, std::uint32_t genus, unsigned int seed = 1)
{
  Soup sphere = regular_sphere((std::max)(num_vertices, 38u)); // no edge from a triangle to its opposite
  const std::size_t half = sphere.triangles.size() / 2;
  const auto opposite = [half](std::size_t f) { return f + half; };
  for (const std::size_t f : disjoint_triangles(sphere, half, genus, seed, opposite)) {
    const std::array<Triangle, 6> triangles = tube(sphere.triangles[f], sphere.triangles[opposite(f)]);
    sphere.triangles[f] = triangles[0];
    sphere.triangles[opposite(f)] = triangles[1];
    sphere.triangles.insert(sphere.triangles.end(), triangles.begin() + 2, triangles.end());
  }
  return sphere;
}

/// A torus of `a` times `b` vertices, both at least 3, all of degree 6.
inline Soup torus_grid(std::uint32_t a, std::uint32_t b)
{
  Soup soup{a * b, {}};
  soup.triangles.reserve(2 * std::size_t(a) * b);
  const auto vertex = [=](std::uint32_t i, std::uint32_t j) { return i % a * b + j % b; };
  for (std::uint32_t i = 0; i < a; ++i)
    for (std::uint32_t j = 0; j < b; ++j) {
      soup.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)});
      soup.triangles.push_back({vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return soup;
}

/// The surface of the unit cubes c, below `size` in all directions, that `is_full(c)` tells: its
/// vertices are all points with whole coordinates in the box, row by row, and each square has
/// two triangles. It must be a manifold.
template <class IsFull>
Soup surface_of_cubes(const std::array<int, 3>& size, const IsFull& is_full)
{
  const auto is_cube = [&](const std::array<int, 3>& c) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (c[axis] < 0 || c[axis] >= size[axis])
        return false;
    return is_full(c);
  };
  const auto vertex = [&](const std::array<int, 3>& p) {
    return static_cast<std::uint32_t>((p[0] * (size[1] + 1) + p[1]) * (size[2] + 1) + p[2]);
  };
  Soup soup{static_cast<std::uint32_t>((size[0] + 1) * (size[1] + 1) * (size[2] + 1)), {}};
  std::array<int, 3> cube;
  for (cube[0] = 0; cube[0] < size[0]; ++cube[0])
    for (cube[1] = 0; cube[1] < size[1]; ++cube[1])
      for (cube[2] = 0; cube[2] < size[2]; ++cube[2])
        for (std::size_t side = 0; is_cube(cube) && side < 6; ++side) {
          const std::size_t axis = side / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
          const int outwards = side % 2 == 0 ? -1 : 1;
          std::array<int, 3> neighbor = cube, corner = cube;
          neighbor[axis] += outwards;
          if (is_cube(neighbor))
            continue;
          corner[axis] += outwards > 0 ? 1 : 0;
          std::array<std::uint32_t, 4> square;
          for (const std::size_t i : {0, 1, 2, 3}) {
            std::array<int, 3> p = corner;
            p[u] += i == 1 || i == 2 ? 1 : 0;
            p[v] += i >= 2 ? 1 : 0;
            square[outwards > 0 ? i : 3 - i] = vertex(p);
          }
          soup.triangles.push_back({square[0], square[1], square[2]});
          soup.triangles.push_back({square[2], square[3], square[0]});
        }
  return soup;
}

/// The surface of a scaffold: the cubic lattice of k x k x k nodes, thickened, its triangles cut
/// into four `subdivisions` times. Genus 2 k^3 - 3 k^2 + 1; without subdivisions 8 k^3 vertices.
/// With k = 18 and two subdivisions that is genus 10,693 and 1,067,256 vertices.
inline Soup scaffold(int k, int subdivisions)
{
  const int size = 2 * k - 1; // cubes along each side: nodes at even places, struts between them
  Soup soup = surface_of_cubes({size, size, size}, [](const std::array<int, 3>& c) {
    return c[0] % 2 + c[1] % 2 + c[2] % 2 <= 1;
  });
  for (int i = 0; i < subdivisions; ++i)
    soup = subdivided(soup);
  return soup;
}

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_CLOSED_SURFACES_H
