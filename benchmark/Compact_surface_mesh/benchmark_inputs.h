// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef BENCHMARK_COMPACT_SURFACE_MESH_BENCHMARK_INPUTS_H
#define BENCHMARK_COMPACT_SURFACE_MESH_BENCHMARK_INPUTS_H

// The surfaces on which structures are compared, generated when they are needed.

#include "../../examples/Compact_surface_mesh/schnyder_embedding.h"
#include "../../examples/Compact_surface_mesh/triangle_soup.h"
#include "../../test/Compact_surface_mesh/large_surfaces.h"

#include <CGAL/Compact_surface_mesh.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace benchmark_inputs {

using example::Point;
using example::Triangle_soup;

/// A surface of about `n` vertices: their number is the nearest to `n`, by its ratio, that the kind allows.
struct Input
{
  std::string name;
  std::function<Triangle_soup()> make;
};

/// reads the mesh `file`, or generates a sphere if that is its name, and subdivides it to about `n` vertices.
inline Triangle_soup subdivided_mesh(const std::string& file, std::size_t n)
{
  if (file == "sphere")
    return example::sphere(n);
  try {
    return example::subdivided_to(example::read_soup(file), n);
  } catch (const std::exception& e) {
    throw std::runtime_error(file + ": " + e.what() + " (scripts/fetch_meshes gets CGAL's meshes)");
  }
}

/// generates a uniform random triangulation, drawn without overlaps.
inline Triangle_soup random_triangulation(std::size_t n)
{
  Triangle_soup soup = example::random_soup(n, 1);
  example::embed(soup);
  return soup;
}

/// generates `test::scaffold()` with points: genus 10,693 at a million vertices, and in proportion.
inline Triangle_soup scaffold(std::size_t n)
{
  const int k = test::scaffold_size(n);
  const test::Soup lattice = test::scaffold(k, 0);
  Triangle_soup soup;
  soup.triangles = lattice.triangles;
  for (std::uint32_t v = 0; v < lattice.num_vertices; ++v)
    soup.points.push_back(Point(v / (4 * k * k), v / (2 * k) % (2 * k), v % (2 * k)));
  return example::subdivided(example::subdivided(soup));
}

/// generates hills over a square grid, row by row. Its border has about 4 sqrt(`n`) sides.
inline Triangle_soup terrain(std::size_t n)
{
  const auto side = static_cast<std::uint32_t>((std::max)(2., std::round(std::sqrt(static_cast<double>(n)))) - 1);
  Triangle_soup soup;
  soup.triangles = test::triangle_grid(side, side).triangles;
  for (std::uint32_t i = 0; i <= side; ++i)
    for (std::uint32_t j = 0; j <= side; ++j) {
      const double x = 10. * i / side, y = 10. * j / side;
      soup.points.push_back(Point(x, y, std::sin(x) * std::cos(1.3 * y) + 0.1 * std::sin(9 * x + 7 * y)));
    }
  return soup;
}

/// lists all inputs. The first three are `mesh`, subdivided: the order of the vertices is what differs.
inline std::vector<Input> all_inputs(std::size_t n, const std::string& mesh, const std::string& scan)
{
  return {
    { "natural order", [=] { return subdivided_mesh(mesh, n); } },
    { "shuffled", [=] { return example::shuffled(subdivided_mesh(mesh, n), 1); } },
    { "cache-friendly order",
      [=] {
        const Triangle_soup soup = subdivided_mesh(mesh, n);
        return example::soup_of_mesh(CGAL::Compact_surface_mesh<Point>(soup.points, soup.triangles));
      } },
    { "random triangulation", [=] { return random_triangulation(n); } },
    { "scaffold", [=] { return scaffold(n); } },
    { "terrain", [=] { return terrain(n); } },
    { "scan", [=] { return subdivided_mesh(scan, n); } },
  };
}

} // namespace benchmark_inputs

#endif // BENCHMARK_COMPACT_SURFACE_MESH_BENCHMARK_INPUTS_H
