// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// What handles, borders, components and polygons cost: bytes and times of traversals beside
// Surface_mesh with the same numbering, and times of construction beside the sphere.

#include "../../examples/Compact_surface_mesh/compared_meshes.h"
#include "../../examples/Compact_surface_mesh/interleaved_times.h"
#include "../../examples/Compact_surface_mesh/mesh_kernels.h"
#include "../../test/Compact_surface_mesh/large_surfaces.h"
#include "closed_surface.h"
#include "positive_number.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iomanip>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace example;
using Mesh = CGAL::Compact_surface_mesh<Point>;
using test::Polygon_soup;
using test::Soup;

struct Arguments
{
  std::uint32_t num_vertices = 1000000;
  int rounds = 7;
};

[[noreturn]] void exit_with_usage()
{
  std::cerr << "surfaces [N] [ROUNDS]\n"
               "  N       about how many vertices the meshes have, 20000 or more, 1000000 by default\n"
               "  ROUNDS  medians are taken of so many runs, 7 by default\n";
  std::exit(2);
}

Arguments parsed(int argc, char* argv[])
{
  const auto number = [](const char* word) {
    const unsigned long n = positive_number(word);
    if (n == 0)
      exit_with_usage();
    return n;
  };
  Arguments arguments;
  if (argc > 1)
    arguments.num_vertices = static_cast<std::uint32_t>(number(argv[1]));
  if (argc > 2)
    arguments.rounds = static_cast<int>(number(argv[2]));
  if (argc > 3 || arguments.num_vertices < 20000)
    exit_with_usage();
  return arguments;
}

// Vertices and faces keep their numbers.
Surface_mesh surface_mesh_of_mesh(const Mesh& mesh)
{
  Surface_mesh result;
  result.reserve(mesh.number_of_vertices(), mesh.number_of_edges(), mesh.number_of_faces());
  for (const auto v : vertices(mesh))
    result.add_vertex(mesh.point(v));
  std::vector<Surface_mesh::Vertex_index> around;
  for (const auto f : faces(mesh)) {
    around.clear();
    for (const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      around.push_back(Surface_mesh::Vertex_index(v.idx()));
    if (result.add_face(around) == Surface_mesh::null_face())
      throw std::runtime_error("Surface_mesh refuses a face");
  }
  return result;
}

// All halfedges of all faces: returns the sum of the squares of the numbers of sides.
template <class AnyMesh>
double sum_of_sides(const AnyMesh& mesh)
{
  std::uint64_t sum = 0;
  for (const auto f : faces(mesh)) {
    const auto first = halfedge(f, mesh);
    std::uint64_t sides = 0;
    auto h = first;
    do {
      ++sides;
      h = next(h, mesh);
    } while (h != first);
    sum += sides * sides;
  }
  return static_cast<double>(sum);
}

// Prints a row: of the first function its time in ns per vertex, of the others the ratio to it.
void print_times(const std::vector<Timed_function>& functions, std::size_t num_vertices, int rounds)
{
  const std::vector<Timing> timings = interleaved_times(functions, rounds);
  std::cout << std::setw(9) << std::fixed << std::setprecision(2)
            << 1e9 * timings[0].seconds / static_cast<double>(num_vertices);
  for (std::size_t i = 1; i < timings.size(); ++i) {
    if (timings[i].result != timings[0].result)
      throw std::logic_error("results differ");
    std::cout << std::setw(7) << timings[i].seconds / timings[0].seconds;
  }
  std::cout << std::flush;
}

void print_traversals(const std::string& name, const Mesh& mesh, int rounds)
{
  const Surface_mesh other = surface_mesh_of_mesh(mesh);
  const std::size_t n = mesh.number_of_vertices();
  std::cout << std::left << std::setw(28) << name << std::right << std::setw(8) << n << std::fixed
            << std::setprecision(3) << std::setw(8)
            << static_cast<double>(mesh.connectivity_bytes()) / static_cast<double>(n) << std::setprecision(1)
            << std::setw(7) << connectivity_bytes(other) / static_cast<double>(n) << std::flush;
  print_times({ [&] { return sum_of_degrees<By_operators>(other); }, [&] { return sum_of_degrees<By_stars>(mesh); },
                [&] { return sum_of_degrees<By_operators>(mesh); } },
              n, rounds);
  Breadth_first_search<Surface_mesh> other_search(other, Surface_mesh::Vertex_index(0));
  Breadth_first_search<Mesh> search(mesh, Mesh::Vertex_index(0));
  print_times({ [&] { return other_search.run<By_operators>(); }, [&] { return search.run<By_stars>(); },
                [&] { return search.run<By_operators>(); } },
              n, rounds);
  print_times({ [&] { return sum_of_sides(other); }, [&] { return sum_of_sides(mesh); } }, n, rounds);
  std::cout << std::endl;
}

void measure_traversals(const Arguments& arguments)
{
  std::cout << "Traversals: ns per vertex of Surface_mesh in our order, and ratios to it: "
               "whole stars, one operator at a time\n"
            << std::setw(36) << "vertices" << std::setw(15) << "bytes a vertex" << std::setw(23) << "degree"
            << std::setw(23) << "breadth-first search" << std::setw(16) << "sides of faces" << std::endl;
  const std::uint32_t n = arguments.num_vertices, side = static_cast<std::uint32_t>(std::sqrt(n));
  const auto measure = [&](const std::string& name, const auto& faces, std::size_t num_vertices) {
    print_traversals(name, Mesh(std::vector<Point>(num_vertices, Point(0, 0, 0)), faces), arguments.rounds);
  };
  const auto triangles = [&](const std::string& name, const Soup& soup) {
    measure(name, soup.triangles, soup.num_vertices);
  };
  const auto polygons = [&](const std::string& name, const Polygon_soup& soup) {
    measure(name, soup.faces, soup.num_vertices);
  };
  triangles("sphere", test::regular_sphere(n));
  for (const std::uint32_t genus : { 1u, 100u, n / 100 })
    triangles("genus " + std::to_string(genus), test::sphere_with_far_handles(n, genus));
  triangles("scaffold", test::scaffold(test::scaffold_size(n), 2));
  triangles("1 border", test::mesh_with_borders(n, 1, 1));
  triangles(std::to_string(n / 1000) + " borders", test::mesh_with_borders(n, n / 1000, 1));
  triangles("border of " + std::to_string(4 * side) + " sides", test::triangle_grid(side, side));
  triangles(std::to_string(n / 2000) + " vertices with two fans", test::mesh_with_pinched_vertices(n, n / 1000, 1));
  triangles(std::to_string(n / 1000) + " components", test::many_components(n, n / 1000, 1));
  polygons("squares", test::quad_grid(side, side));
  polygons("polygon of " + std::to_string(n / 10) + " sides", test::globe_with_polygon(10, n / 10));
}

// The first surface is the one to which the others are compared.
void print_constructions(const std::vector<Closed_surface>& surfaces, int rounds)
{
  std::vector<Timed_function> functions;
  for (const Closed_surface& s : surfaces)
    functions.push_back([&s] { return s.shell(); });
  for (const Closed_surface& s : surfaces)
    functions.push_back([&s] { return s.build_layout<Mesh::Layout>(); });
  const std::vector<Timing> timings = interleaved_times(functions, rounds);
  const auto time = [&](std::size_t i) {
    const std::size_t n = surfaces[i % surfaces.size()].num_user_vertices();
    return 1e9 * timings[i].seconds / static_cast<double>(n);
  };
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const std::size_t layout = surfaces.size() + i;
    std::cout << std::left << std::setw(28) << surfaces[i].name() << std::right << std::setw(8)
              << surfaces[i].num_user_vertices() << std::setprecision(0) << std::setw(15) << timings[i].result
              << std::setprecision(1) << std::setw(9) << time(i) << std::setprecision(2) << std::setw(7)
              << time(i) / time(0) << std::setprecision(1) << std::setw(9) << time(layout) << std::setprecision(2)
              << std::setw(7) << time(layout) / time(surfaces.size()) << std::endl;
  }
}

void measure_constructions(const Arguments& arguments)
{
  std::cout << "\nConstruction: ns per vertex, and ratio to the sphere\n"
            << std::setw(36) << "vertices" << std::setw(15) << "special edges" << std::setw(16) << "shelling"
            << std::setw(16) << "layout with it" << std::endl;
  const std::uint32_t n = arguments.num_vertices;
  std::vector<Closed_surface> surfaces;
  surfaces.emplace_back("sphere", test::regular_sphere(n));
  for (const std::uint32_t genus : { 1u, 10u, 100u, n / 1000, n / 100 })
    surfaces.emplace_back("genus " + std::to_string(genus), test::sphere_with_far_handles(n, genus));
  surfaces.emplace_back("scaffold", test::scaffold(test::scaffold_size(n), 2));
  print_constructions(surfaces, arguments.rounds);
  for (const std::uint32_t num_tori : { n * 2 / 125, n / 4 }) {
    surfaces.clear();
    surfaces.emplace_back("sphere", test::regular_sphere(4 * num_tori + 3));
    surfaces.emplace_back("chain of " + std::to_string(num_tori) + " tori", test::chain_of_tori(num_tori));
    print_constructions(surfaces, arguments.rounds);
  }
}

} // namespace

int main(int argc, char* argv[])
{
  const Arguments arguments = parsed(argc, argv);
  try {
    measure_traversals(arguments);
    measure_constructions(arguments);
  } catch (const std::exception& e) {
    std::cerr << e.what() << std::endl;
    return 1;
  }
  return 0;
}
