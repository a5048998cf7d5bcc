// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// No function makes a Surface_mesh of a compact one that the user has not asked for, but for those that the manual
// names. The compiler shows it: here the Surface_mesh of the points of our mesh is no more than a name. And allocated
// blocks show it: each is smaller than the halfedges of a Surface_mesh, whatever its points.

#include "counted_allocation.h"
#include "generated_triangulations.h"
#include "temporary_file.h"

#include <CGAL/Compact_surface_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

// Declared before any use, and never defined: what makes such a mesh, or asks for its size, does not compile.
namespace CGAL {
template <> class Surface_mesh<Exact_predicates_inexact_constructions_kernel::Point_3>;
}

#include <CGAL/Compact_surface_mesh/layouts/Corner_table_layout.h>

#include <CGAL/Face_graph_wrapper.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangle_accessor_3.h>
#include <CGAL/boost/graph/Graph_with_descriptor_with_graph.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/io.h>
#include <CGAL/convex_hull_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace {

using test::Counted_allocation;
using test::Temporary_file;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Compact_surface_mesh<Point>;
using Other_mesh = CGAL::Compact_surface_mesh<Point, CGAL::Corner_table_layout<>>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Control = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>; // with points of the same size
namespace parameters = CGAL::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;

// A sphere of 16,382 vertices and a few less than 2^15 triangles, so that vectors that double their size do not
// waste much.
struct Globe
{
  Globe()
    : soup(test::globe(num_circles, num_meridians))
  {
    const double pi = std::acos(-1.);
    points = { Point(0, 0, 1), Point(0, 0, -1) };
    for (std::uint32_t c = 1; c <= num_circles; ++c)
      for (std::uint32_t m = 0; m < num_meridians; ++m) {
        const double latitude = pi * c / (num_circles + 1), longitude = 2 * pi * m / num_meridians;
        points.emplace_back(std::sin(latitude) * std::cos(longitude), std::sin(latitude) * std::sin(longitude),
                            std::cos(latitude));
      }
    mesh = Mesh(points, soup.triangles);
  }

  static constexpr std::uint32_t num_circles = 91, num_meridians = 180;

  test::Soup soup;
  std::vector<Point> points;
  Mesh mesh;
};

const Globe& globe()
{
  static const Globe globe;
  return globe;
}

// The bytes in the largest array of a Surface_mesh with as many elements as `mesh`: that of its halfedges.
template <class M>
std::size_t largest_array_of_surface_mesh(const M& mesh)
{
  Counted_allocation::reset_peak();
  Control control;
  control.reserve(mesh.number_of_vertices(), mesh.number_of_edges(), mesh.number_of_faces());
  return Counted_allocation::largest_block();
}

// Expects that call() allocates no block as large as the largest array of a Surface_mesh like `mesh`, which may be
// what call() fills.
template <class M, class Call>
void expect_no_copy(const std::string& name, const M& mesh, const Call& call)
{
  const std::size_t before = Counted_allocation::live();
  Counted_allocation::reset_peak();
  call();
  const std::size_t largest = Counted_allocation::largest_block(), peak = Counted_allocation::peak() - before;
  const std::size_t bound = largest_array_of_surface_mesh(mesh);
  std::cout << "  " << std::left << std::setw(48) << name << std::right << std::setw(9) << largest << " of " << bound
            << " bytes in a block, " << peak << " at a time\n";
  EXPECT_GT(mesh.number_of_vertices(), 16000u) << name; // or else nothing is shown
  EXPECT_LT(largest, bound) << name;
}

// The same for a call that fills a mesh.
template <class Fill>
void expect_no_copy_filling(const std::string& name, const Fill& fill)
{
  Mesh mesh;
  expect_no_copy(name, mesh, [&] { fill(mesh); });
}

TEST(Unasked_copies, would_be_seen)
{
  const Mesh& mesh = globe().mesh;
  Counted_allocation::reset_peak();
  Control control;
  CGAL::copy_face_graph(mesh, control);
  EXPECT_EQ(control.number_of_halfedges(), mesh.number_of_halfedges());
  const std::size_t largest = Counted_allocation::largest_block();
  EXPECT_GE(largest, largest_array_of_surface_mesh(mesh));
}

TEST(Unasked_copies, are_not_made_by_constructors)
{
  const Mesh& mesh = globe().mesh;
  expect_no_copy_filling("from a soup", [&](Mesh& copy) { copy = Mesh(globe().points, globe().soup.triangles); });
  expect_no_copy_filling("a copy", [&](Mesh& copy) { copy = mesh; });
  expect_no_copy_filling("assign()", [&](Mesh& copy) { copy.assign(mesh); });
  const Other_mesh other(mesh);
  expect_no_copy_filling("from another layout", [&](Mesh& copy) { copy = Mesh(other); });
  Polyhedron polyhedron;
  CGAL::copy_face_graph(mesh, polyhedron);
  expect_no_copy_filling("from a Polyhedron_3", [&](Mesh& copy) { copy = Mesh(polyhedron); });
  expect_no_copy("into a Polyhedron_3", mesh, [&] {
    Polyhedron copy;
    CGAL::copy_face_graph(mesh, copy);
  });
}

TEST(Unasked_copies, are_not_made_by_what_fills_a_mesh)
{
  const Mesh& mesh = globe().mesh;
  const std::vector<Point>& points = globe().points;
  const auto& triangles = globe().soup.triangles;
  const Other_mesh other(mesh);
  expect_no_copy_filling("copy_face_graph()", [&](Mesh& copy) { CGAL::copy_face_graph(mesh, copy); });
  expect_no_copy_filling("copy_face_graph() of another layout",
                         [&](Mesh& copy) { CGAL::copy_face_graph(other, copy); });
  expect_no_copy_filling("polygon_soup_to_polygon_mesh()",
                         [&](Mesh& copy) { PMP::polygon_soup_to_polygon_mesh(points, triangles, copy); });
  expect_no_copy_filling("convex_hull_3() of points",
                         [&](Mesh& hull) { CGAL::convex_hull_3(points.begin(), points.end(), hull); });
  expect_no_copy_filling("convex_hull_3() of points, with traits", [&](Mesh& hull) {
    CGAL::convex_hull_3(points.begin(), points.end(), hull, CGAL::Convex_hull_traits_3<Kernel, Mesh>());
  });
  expect_no_copy_filling("convex_hull_3() of a graph", [&](Mesh& hull) { CGAL::convex_hull_3(mesh, hull); });
}

TEST(Unasked_copies, are_not_made_by_generators)
{
  const Point p(0, 0, 0);
  expect_no_copy_filling("make_regular_prism()", [&](Mesh& g) { CGAL::make_regular_prism(8190, g, p, 1, 1); });
  expect_no_copy_filling("make_pyramid()", [&](Mesh& g) { CGAL::make_pyramid(16380, g, p, 1, 1); });
  expect_no_copy_filling("make_grid()", [&](Mesh& g) { CGAL::make_grid(127, 127, g, true); });
  expect_no_copy_filling("make_grid() of squares", [&](Mesh& g) { CGAL::make_grid(127, 127, g); });
  expect_no_copy_filling("make_grid() of a function", [&](Mesh& g) {
    CGAL::make_grid(127, 127, g, [](int i, int j) { return Point(i, j, i * j); }, true);
  });
  Mesh small[5]; // the compiler looks on
  CGAL::make_triangle(p, p, p, small[0]);
  CGAL::make_quad(p, p, p, p, small[1]);
  CGAL::make_tetrahedron(p, p, p, p, small[2]);
  CGAL::make_hexahedron(p, p, p, p, p, p, p, p, small[3]);
  CGAL::make_icosahedron(small[4], p, 1);
  EXPECT_EQ(small[4].number_of_faces(), 20u);
}

TEST(Unasked_copies, are_not_made_by_readers_and_writers)
{
  const Mesh& mesh = globe().mesh;
  std::vector<std::string> endings = { ".off", ".obj", ".stl", ".ply", ".ts" };
#ifdef CGAL_USE_VTK
  endings.push_back(".vtp");
#endif
  for (const std::string& ending : endings)
    for (const bool is_binary : { false, true }) {
      if (is_binary && (ending == ".obj" || ending == ".ts")) // they are text
        continue;
      const Temporary_file file(ending);
      const std::string name = file.name();
      const std::string what = ending + (is_binary ? ", binary, by " : ", text, by ");
      const auto np = parameters::use_binary_mode(is_binary);
      expect_no_copy(what + "write_polygon_mesh()", mesh,
                     [&] { EXPECT_TRUE(CGAL::IO::write_polygon_mesh(name, mesh, np)); });
      expect_no_copy_filling(what + "read_polygon_mesh()",
                             [&](Mesh& read) { EXPECT_TRUE(CGAL::IO::read_polygon_mesh(name, read)); });
      expect_no_copy_filling(what + "PMP::IO::read_polygon_mesh()",
                             [&](Mesh& read) { EXPECT_TRUE(PMP::IO::read_polygon_mesh(name, read)); });
    }
#ifdef CGAL_LINKED_WITH_3MF
  const Temporary_file file(".3mf");
  EXPECT_TRUE(CGAL::IO::write_3MF(file.name(), std::vector<Mesh>{ mesh }, { "globe" }));
  expect_no_copy_filling("read_3MF()", [&](Mesh& read) {
    std::vector<Mesh> meshes;
    EXPECT_TRUE(CGAL::IO::read_3MF(file.name(), meshes));
    read = std::move(meshes.at(0));
  });
#endif
}

// Attributes are carried without one as well.
TEST(Unasked_copies, are_not_made_by_readers_and_writers_of_attributes)
{
  Mesh mesh = globe().mesh;
  mesh.add_property_map<Mesh::Vertex_index, CGAL::IO::Color>("v:color", CGAL::IO::Color(1, 2, 3));
  mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal", Kernel::Vector_3(1, 0, 0));
  mesh.add_property_map<Mesh::Face_index, CGAL::IO::Color>("f:color", CGAL::IO::Color(4, 5, 6));
  const Temporary_file off(".off"), ply(".ply");
  expect_no_copy("operator<<", mesh, [&] { std::ofstream(off.name()) << mesh; });
  expect_no_copy_filling("operator>>", [&](Mesh& read) {
    std::ifstream(off.name()) >> read;
    EXPECT_TRUE((read.find_property_map<Mesh::Face_index, CGAL::IO::Color>("f:color")));
  });
  mesh.add_property_map<Mesh::Face_index, int>("f:region", 7);
  expect_no_copy("write_PLY()", mesh, [&] {
    std::ofstream os(ply.name(), std::ios::binary);
    CGAL::IO::set_binary_mode(os);
    EXPECT_TRUE(CGAL::IO::write_PLY(os, mesh, "a comment"));
  });
  expect_no_copy_filling("read_PLY()", [&](Mesh& read) {
    std::ifstream is(ply.name(), std::ios::binary);
    std::string comments;
    EXPECT_TRUE(CGAL::IO::read_PLY(is, read, comments));
    EXPECT_TRUE((read.find_property_map<Mesh::Face_index, int>("f:region")));
  });
}

// CGAL's heat method allocates larger blocks of its own, and so the compiler alone shows it here.
TEST(Unasked_copies, are_not_made_by_the_direct_heat_method)
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1);
  const auto distance = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
  CGAL::Heat_method_3::estimate_geodesic_distances(mesh, distance, *mesh.vertices().begin(),
                                                   CGAL::Heat_method_3::Direct());
  for (const auto v : mesh.vertices())
    EXPECT_LT(get(distance, v), 5);
}

TEST(Unasked_copies, are_not_made_for_topology_and_tetrahedral_meshes)
{
  Mesh mesh = globe().mesh;
  expect_no_copy("Face_graph_wrapper", mesh, [&] {
    const CGAL::Face_graph_wrapper<Mesh> wrapper(mesh);
    EXPECT_EQ(wrapper.number_of_darts(), mesh.number_of_halfedges());
  });
  using With_graph = CGAL::Graph_with_descriptor_with_graph<Mesh>;
  expect_no_copy("Triangle_accessor_3", mesh, [&] {
    With_graph graph(mesh);
    const CGAL::Triangle_accessor_3<With_graph, Kernel> accessor;
    double area = 0;
    for (auto it = accessor.triangles_begin(graph); it != accessor.triangles_end(graph); ++it)
      area += std::sqrt(accessor.triangle(it).squared_area());
    EXPECT_NEAR(area, 4 * std::acos(-1.), 0.01);
  });
}

} // namespace
