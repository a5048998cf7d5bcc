// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef COMPACT_SURFACE_MESH_EXAMPLES_TRIANGLE_SOUP_H
#define COMPACT_SURFACE_MESH_EXAMPLES_TRIANGLE_SOUP_H

// Points and triples of indices: what all programs here start from. They are read from a
// file or generated, and put into other orders.

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/Corner_table.h>
#include <CGAL/Schnyder_woods/random_planar_triangulation.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Random.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace example {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Triangle = std::array<std::uint32_t, 3>;

struct Triangle_soup
{
  std::vector<Point> points;
  std::vector<Triangle> triangles; // counterclockwise
};

/// \name Files
/// @{

/// reads an OFF, PLY, OBJ or STL file.
/// \throws std::runtime_error if the file cannot be read or has no faces
/// \throws CGAL::Mesh_defect_exception if it holds anything but an oriented triangle mesh
inline Triangle_soup read_soup(const std::string& file)
{
  Triangle_soup soup;
  std::vector<std::vector<std::size_t> > polygons;
  if (!CGAL::IO::read_polygon_soup(file, soup.points, polygons))
    throw std::runtime_error("cannot be read");
  if (polygons.empty())
    throw std::runtime_error("has no faces");
  CGAL::Corner_table<>(soup.points.size(), polygons); // throws
  soup.triangles.resize(polygons.size());
  for (std::size_t f = 0; f < polygons.size(); ++f)
    std::copy(polygons[f].begin(), polygons[f].end(), soup.triangles[f].begin());
  return soup;
}

/// @}

/// \name Generators
/// @{

/// generates a unit sphere with two poles and between them `num_circles` circles of
/// `num_meridians` vertices each.
inline Triangle_soup globe(std::uint32_t num_circles, std::uint32_t num_meridians)
{
  Triangle_soup soup;
  const std::uint32_t south = 1 + num_circles * num_meridians;
  const auto vertex = [=](std::uint32_t i, std::uint32_t j) { return 1 + i * num_meridians + j % num_meridians; };
  soup.points.push_back(Point(0, 0, 1));
  for (std::uint32_t i = 0; i < num_circles; ++i)
    for (std::uint32_t j = 0; j < num_meridians; ++j) {
      const double latitude = CGAL_PI * (i + 1) / (num_circles + 1), longitude = 2 * CGAL_PI * j / num_meridians;
      soup.points.push_back(Point(std::sin(latitude) * std::cos(longitude), std::sin(latitude) * std::sin(longitude),
                                  std::cos(latitude)));
    }
  soup.points.push_back(Point(0, 0, -1));
  for (std::uint32_t j = 0; j < num_meridians; ++j) {
    soup.triangles.push_back({ 0, vertex(0, j), vertex(0, j + 1) });
    for (std::uint32_t i = 0; i + 1 < num_circles; ++i) {
      soup.triangles.push_back({ vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1) });
      soup.triangles.push_back({ vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1) });
    }
    soup.triangles.push_back({ vertex(num_circles - 1, j), south, vertex(num_circles - 1, j + 1) });
  }
  return soup;
}

/// cuts each triangle into four at the middles of its edges: n vertices become 4n - 6 on a
/// sphere. The vertices of `soup` come first, in their order.
inline Triangle_soup subdivided(const Triangle_soup& soup)
{
  const CGAL::Corner_table<> table(soup.points.size(), soup.triangles);
  Triangle_soup result;
  result.points.reserve(soup.points.size() + table.num_halfedges() / 2);
  result.triangles.reserve(4 * soup.triangles.size());
  result.points = soup.points;
  std::vector<std::uint32_t> middle(table.num_halfedges());
  for (std::uint32_t h = 0; h < table.num_halfedges(); ++h) {
    const std::uint32_t opposite = table.opposite(h); // null, which is larger than h, on a border
    if (opposite < h) {
      middle[h] = middle[opposite];
      continue;
    }
    middle[h] = static_cast<std::uint32_t>(result.points.size());
    result.points.push_back(CGAL::midpoint(soup.points[table.source(h)], soup.points[table.target(h)]));
  }
  for (std::uint32_t f = 0; f < table.num_faces(); ++f) {
    const Triangle& corner = soup.triangles[f];
    const std::uint32_t* const m = &middle[3 * f]; // of the sides from corners 0, 1, 2 on
    result.triangles.push_back({ corner[0], m[0], m[2] });
    result.triangles.push_back({ m[0], corner[1], m[1] });
    result.triangles.push_back({ m[2], m[1], corner[2] });
    result.triangles.push_back({ m[0], m[1], m[2] });
  }
  return result;
}

/// subdivides until the number of vertices is nearest to `n` by its ratio.
inline Triangle_soup subdivided_to(Triangle_soup soup, std::size_t n)
{
  while (2 * soup.points.size() < n)
    soup = subdivided(soup);
  return soup;
}

/// generates a unit sphere with about `n` vertices, in the order of subdivision.
inline Triangle_soup sphere(std::size_t n)
{
  std::size_t coarse = n;
  while (coarse >= 800)
    coarse = (coarse + 6) / 4;
  const auto num_circles = static_cast<std::uint32_t>(
      (std::max)(1., std::round(std::sqrt(static_cast<double>(coarse) / 2))));
  const auto num_meridians = (std::max)(std::uint32_t(3), static_cast<std::uint32_t>(coarse) / num_circles);
  Triangle_soup soup = globe(num_circles, num_meridians);
  while (soup.points.size() < n / 2)
    soup = subdivided(soup);
  for (Point& p : soup.points)
    p = CGAL::ORIGIN + (p - CGAL::ORIGIN) / std::sqrt((p - CGAL::ORIGIN).squared_length());
  return soup;
}

/// generates a uniform random triangulation of `n` vertices. These lie on the unit sphere,
/// along a spiral in the order of their indices: its faces overlap, see `embed()`.
inline Triangle_soup random_soup(std::size_t n, unsigned int seed)
{
  if (n < 4)
    throw std::runtime_error("a random triangulation has 4 vertices or more");
  CGAL::Random random(seed);
  Triangle_soup soup;
  soup.triangles = CGAL::random_planar_triangulation<std::uint32_t>(n, random);
  soup.points.reserve(n);
  for (std::size_t v = 0; v < n; ++v) {
    const double z = 1 - (2. * static_cast<double>(v) + 1) / static_cast<double>(n), r = std::sqrt(1 - z * z);
    const double longitude = 2.4 * static_cast<double>(v);
    soup.points.push_back(Point(r * std::cos(longitude), r * std::sin(longitude), z));
  }
  return soup;
}

/// makes the soup of `argument`: `sphere`, `sphere:N`, `random:N`, `random:N:SEED`, or a file.
inline Triangle_soup soup_of_argument(const std::string& argument)
{
  const std::size_t colon = argument.find(':');
  const std::string kind = argument.substr(0, colon);
  if (kind != "sphere" && !(kind == "random" && colon != std::string::npos))
    return read_soup(argument);
  if (colon == std::string::npos)
    return sphere(100000);
  try {
    std::size_t end;
    const std::string rest = argument.substr(colon + 1);
    const unsigned long n = std::stoul(rest, &end);
    unsigned long seed = 1;
    if (kind == "random" && end < rest.size() && rest[end] == ':') {
      const std::size_t start = end + 1;
      seed = std::stoul(rest.substr(start), &end);
      end += start;
    }
    if (end == rest.size())
      return kind == "sphere" ? sphere(n) : random_soup(n, static_cast<unsigned int>(seed));
  } catch (const std::logic_error&) {} // not a number
  throw std::runtime_error("has something that is not a number");
}

/// @}

/// \name Orders
/// @{

/// returns the soup of `mesh` in the order of its vertices and faces.
template <class Mesh>
Triangle_soup soup_of_mesh(const Mesh& mesh)
{
  Triangle_soup soup;
  soup.points.reserve(num_vertices(mesh));
  soup.triangles.reserve(num_faces(mesh));
  for (const auto v : vertices(mesh))
    soup.points.push_back(mesh.point(v));
  mesh.for_each_face([&](auto, auto u, auto v, auto w) { soup.triangles.push_back({ u.idx(), v.idx(), w.idx() }); });
  return soup;
}

/// returns the same surface with vertices and triangles in random order.
inline Triangle_soup shuffled(const Triangle_soup& soup, unsigned int seed)
{
  std::mt19937 random(seed);
  std::vector<std::uint32_t> name(soup.points.size());
  std::iota(name.begin(), name.end(), 0u);
  std::shuffle(name.begin(), name.end(), random);
  Triangle_soup result = soup;
  for (std::size_t v = 0; v < name.size(); ++v)
    result.points[name[v]] = soup.points[v];
  for (Triangle& triangle : result.triangles)
    for (std::uint32_t& v : triangle)
      v = name[v];
  std::shuffle(result.triangles.begin(), result.triangles.end(), random);
  return result;
}

/// @}

} // namespace example

#endif // COMPACT_SURFACE_MESH_EXAMPLES_TRIANGLE_SOUP_H
