// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// CGAL's functions that fill a mesh: what they make of an empty Compact_surface_mesh, and what of a Surface_mesh.

#include "read_mesh_oracle.h"

#include <CGAL/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/layouts/Corner_table_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/Input_order_layout.h>

#include <CGAL/Convex_hull_traits_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/convex_hull_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Surface_mesh = CGAL::Surface_mesh<Point>;
using Mesh = CGAL::Compact_surface_mesh<Point>;
namespace parameters = CGAL::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;

// The vertices of each face in turn, from the one with the least number on.
template <class Graph>
std::vector<std::vector<std::size_t> > cycles_of_faces(const Graph& g)
{
  std::vector<std::vector<std::size_t> > cycles;
  for (const auto f : faces(g)) {
    std::vector<std::size_t> cycle;
    for (const auto v : CGAL::vertices_around_face(halfedge(f, g), g))
      cycle.push_back(v);
    std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
    cycles.push_back(cycle);
  }
  return cycles;
}

// Calls make(mesh), which returns a halfedge, for both meshes and compares what there is then.
template <class Make>
void check_generator(const Make& make, bool has_order_of_faces = true)
{
  Surface_mesh expected;
  Mesh mesh;
  auto kept = mesh.add_property_map<Mesh::Vertex_index, int>("v:kept", 5).first;
  const auto h = make(expected);
  const auto image = make(mesh);

  // to the last bits: sines and cosines are rounded
  std::map<std::array<long, 3>, Point> rounded;
  const auto key = [](const Point& p) {
    return std::array<long, 3>{ { std::lround(1e9 * p.x()), std::lround(1e9 * p.y()), std::lround(1e9 * p.z()) } };
  };
  for (const Point& p : expected.points())
    rounded[key(p)] = p;
  for (Point& p : mesh.points()) {
    ASSERT_EQ(rounded.count(key(p)), 1u) << p;
    p = rounded[key(p)];
  }

  ASSERT_EQ(h.is_valid(), image.is_valid());
  if (h.is_valid()) {
    EXPECT_EQ(mesh.point(mesh.source(image)), expected.point(expected.source(h)));
    EXPECT_EQ(mesh.point(mesh.target(image)), expected.point(expected.target(h)));
  }
  CGAL::Compact_surface_mesh<Point, CGAL::Input_order_layout<CGAL::Schnyder_parents_layout<>,
                                                             CGAL::Input_order::VERTICES_AND_FACES> > ordered;
  make(ordered);
  if (has_order_of_faces) {
    EXPECT_EQ(cycles_of_faces(ordered), cycles_of_faces(expected));
  }
  for (const auto v : mesh.vertices())
    EXPECT_EQ(kept[v], 5);
  mesh.remove_property_map(kept);
  EXPECT_EQ(test::difference(expected, mesh), "");
  EXPECT_THROW(make(mesh), std::runtime_error);
  EXPECT_EQ(test::difference(expected, mesh), "");
}

TEST(Generators, make_what_cgal_makes)
{
  const Point p(0, 0, 0), q(1, 0, 0), r(1, 1, 0), s(0, 1, 0), t(0, 1, 1), u(0, 0, 1), v(1, 0, 1), w(1, 1, 1);
  check_generator([&](auto& g) { return CGAL::make_triangle(p, q, r, g); });
  check_generator([&](auto& g) { return CGAL::make_quad(p, q, r, s, g); });
  check_generator([&](auto& g) { return CGAL::make_tetrahedron(p, q, r, u, g); });
  check_generator([&](auto& g) { return CGAL::make_hexahedron(p, q, r, s, t, u, v, w, g); });
#if CGAL_COMPACT_SURFACE_MESH_WITH_CGAL_6
  for (const bool is_triangulated : { true, false }) {
    const auto np = parameters::do_not_triangulate_faces(!is_triangulated);
    check_generator([&](auto& g) { return CGAL::make_hexahedron(p, q, r, s, t, u, v, w, g, np); }, false);
    const Kernel::Iso_cuboid_3 cuboid(p, Point(1, 2, 3));
    check_generator([&](auto& g) { return CGAL::make_hexahedron(cuboid, g, np); }, false);
  }
#endif
  check_generator([&](auto& g) { return CGAL::make_icosahedron(g, q, 2); }, false);
  for (const unsigned int n : { 3u, 4u, 11u })
    for (const bool is_closed : { true, false }) {
      check_generator([&](auto& g) { return CGAL::make_regular_prism(n, g, q, 3, 2, is_closed); });
      check_generator([&](auto& g) { return CGAL::make_pyramid(n, g, t, 2.5, 0.5, is_closed); });
    }
  for (const bool is_triangulated : { true, false }) {
    check_generator([&](auto& g) { return CGAL::make_grid(3, 5, g, is_triangulated); });
    check_generator([&](auto& g) { return CGAL::make_grid(1, 1, g, is_triangulated); });
    check_generator([&](auto& g) {
      return CGAL::make_grid(4, 2, g, [](int a, int b) { return Point(a, a * b, b); }, is_triangulated);
    });
  }
}

TEST(Generators, take_cgals_template_arguments)
{
  check_generator([](auto& g) {
    using Graph = std::decay_t<decltype(g)>;
    return CGAL::make_icosahedron<Graph, Point>(g);
  }, false);
  check_generator([](auto& g) {
    using Graph = std::decay_t<decltype(g)>;
    return CGAL::make_regular_prism<Graph, Point>(5, g);
  });
  check_generator([](auto& g) {
    using Graph = std::decay_t<decltype(g)>;
    return CGAL::make_pyramid<Graph, Point>(5, g);
  });
  check_generator([](auto& g) {
    using Graph = std::decay_t<decltype(g)>;
    return CGAL::make_triangle<Graph>(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), g);
  });
}

// Random points of some kind, their hull as Surface_mesh and as Compact_surface_mesh.
template <class Points>
void check_hull(const Points& points)
{
  Surface_mesh expected;
  Mesh mesh;
  CGAL::convex_hull_3(points.begin(), points.end(), expected);
  CGAL::convex_hull_3(points.begin(), points.end(), mesh);
  EXPECT_EQ(test::difference(expected, mesh), "");

  // what was there before is lost
  CGAL::convex_hull_3(points.begin(), points.end(), mesh, CGAL::Convex_hull_traits_3<Kernel, Mesh>());
  EXPECT_EQ(test::difference(expected, mesh), "");

  Mesh other;
  if (!expected.is_empty()) {
    CGAL::convex_hull_3(expected, other);
    EXPECT_EQ(other.number_of_faces(), mesh.number_of_faces());
  }
}

TEST(Convex_hull, is_that_of_cgal)
{
  CGAL::Random random(1);
  const auto number = [&random] { return random.uniform_real(-1., 1.); };
  for (const int n : { 4, 5, 10, 300 }) {
    std::vector<Point> points, plane, line;
    for (int i = 0; i < n; ++i) {
      points.emplace_back(number(), number(), number());
      plane.emplace_back(number(), number(), 2);
      line.emplace_back(i, 2 * i, 3 * i);
    }
    check_hull(points);
    check_hull(plane);
    check_hull(line);
  }
  check_hull(std::vector<Point>{ Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0) });
  check_hull(std::vector<Point>{ Point(0, 0, 0), Point(1, 0, 0) });
  check_hull(std::vector<Point>{ Point(0, 0, 0), Point(0, 0, 0), Point(0, 0, 0) });
  check_hull(std::vector<Point>());
  std::vector<Point> grid;
  for (int i = 0; i < 27; ++i)
    grid.emplace_back(i % 3, i / 3 % 3, i / 9);
  check_hull(grid);
}

TEST(Convex_hull, keeps_the_mesh_if_there_are_no_points)
{
  Mesh mesh;
  CGAL::make_icosahedron<Mesh, Point>(mesh);
  const std::vector<Point> none;
  CGAL::convex_hull_3(none.begin(), none.end(), mesh);
  EXPECT_EQ(mesh.number_of_faces(), 20u);
}

const std::vector<std::vector<std::size_t> > prism = { { 0, 1, 2 }, { 5, 4, 3 }, { 1, 0, 3, 4 }, { 2, 1, 4, 5 },
                                                       { 0, 2, 5, 3 } };
const std::vector<Point> corners = { Point(0, 0, 0), Point(0, 1, 0), Point(1, 0, 0),
                                     Point(0, 0, 1), Point(0, 1, 1), Point(1, 0, 1), Point(7, 7, 7) };

TEST(Polygon_soup, becomes_what_it_becomes_in_cgal)
{
  Surface_mesh expected;
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(corners, prism, expected);
  PMP::polygon_soup_to_polygon_mesh(corners, prism, mesh);
  EXPECT_EQ(test::difference(expected, mesh), "");

  Mesh named;
  PMP::polygon_soup_to_polygon_mesh<Mesh>(corners, prism, named);
  EXPECT_EQ(test::difference(expected, named), "");

  std::vector<std::array<double, 3> > coordinates;
  for (const Point& p : corners)
    coordinates.push_back({ { p.x(), p.y(), p.z() } });
  Mesh from_coordinates;
  PMP::polygon_soup_to_polygon_mesh(coordinates, prism, from_coordinates);
  EXPECT_EQ(test::difference(expected, from_coordinates), "");
}

TEST(Polygon_soup, takes_the_named_parameters_of_cgal)
{
  std::vector<std::pair<int, Point> > labelled;
  for (const Point& p : corners)
    labelled.emplace_back(3, p);
  Surface_mesh expected;
  Mesh mesh;
  const auto map = CGAL::Second_of_pair_property_map<std::pair<int, Point> >();
  PMP::polygon_soup_to_polygon_mesh(labelled, prism, expected, parameters::point_map(map));
  PMP::polygon_soup_to_polygon_mesh(labelled, prism, mesh, parameters::point_map(map));
  EXPECT_EQ(test::difference(expected, mesh), "");

  Mesh with_other_points;
  auto points = with_other_points.add_property_map<Mesh::Vertex_index, Point>("v:rest").first;
  PMP::polygon_soup_to_polygon_mesh(corners, prism, with_other_points, parameters::default_values(),
                                    parameters::vertex_point_map(points));
  for (const auto v : with_other_points.vertices())
    with_other_points.point(v) = points[v];
  with_other_points.remove_property_map(points);
  EXPECT_EQ(test::difference(expected, with_other_points), "");
}

#if CGAL_COMPACT_SURFACE_MESH_WITH_CGAL_6

// The points of the vertices and the sums of those of the faces, as `fill` tells them by maps and by iterators.
template <class M, class Fill>
std::vector<std::pair<std::size_t, Point> > told_by(const Fill& fill)
{
  M mesh;
  std::map<std::size_t, typename M::Vertex_index> vertex_map;
  std::map<std::size_t, typename M::Face_index> face_map;
  std::vector<std::pair<std::size_t, typename M::Vertex_index> > vertices;
  std::vector<std::pair<std::size_t, typename M::Face_index> > faces;
  fill(mesh, parameters::point_to_vertex_map(boost::make_assoc_property_map(vertex_map))
               .polygon_to_face_map(boost::make_assoc_property_map(face_map)));
  mesh.clear();
  fill(mesh, parameters::point_to_vertex_output_iterator(std::back_inserter(vertices))
               .polygon_to_face_output_iterator(std::back_inserter(faces)));
  vertices.insert(vertices.end(), vertex_map.begin(), vertex_map.end());
  faces.insert(faces.end(), face_map.begin(), face_map.end());
  std::vector<std::pair<std::size_t, Point> > told;
  for (const auto& pair : vertices)
    told.emplace_back(pair.first, mesh.point(pair.second));
  for (const auto& pair : faces) {
    Kernel::Vector_3 sum(0, 0, 0);
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(pair.second)))
      sum = sum + (mesh.point(v) - CGAL::ORIGIN);
    told.emplace_back(pair.first, CGAL::ORIGIN + sum);
  }
  return told;
}

TEST(Polygon_soup, tells_what_became_of_its_elements_by_the_names_of_cgal_6)
{
  const auto fill = [](auto& mesh, const auto& np) { PMP::polygon_soup_to_polygon_mesh(corners, prism, mesh, np); };
  const auto construct = [](auto& mesh, const auto& np) { mesh = Mesh(corners, prism, np); };
  const auto expected = told_by<Surface_mesh>(fill);
  EXPECT_EQ(expected.size(), 2 * (corners.size() + prism.size()));
  EXPECT_EQ(told_by<Mesh>(fill), expected);
  EXPECT_EQ(told_by<Mesh>(construct), expected);
}

#endif

TEST(Polygon_soup, that_is_no_mesh_leaves_the_target_as_it_was)
{
  Mesh mesh;
  auto kept = mesh.add_property_map<Mesh::Face_index, int>("f:kept", 5).first;
  auto damaged = prism;
  damaged[3] = { 2, 1, 4, 2 };
  EXPECT_THROW(PMP::polygon_soup_to_polygon_mesh(corners, damaged, mesh), CGAL::Mesh_defect_exception);
  damaged[3] = { 0, 1, 2 };
  EXPECT_THROW(PMP::polygon_soup_to_polygon_mesh(corners, damaged, mesh), CGAL::Mesh_defect_exception);
  EXPECT_TRUE(mesh.is_empty());
  PMP::polygon_soup_to_polygon_mesh(corners, prism, mesh);
  EXPECT_EQ(kept[Mesh::Face_index(4)], 5);
  EXPECT_THROW(PMP::polygon_soup_to_polygon_mesh(corners, prism, mesh), std::runtime_error);
  EXPECT_EQ(mesh.number_of_faces(), 5u);
}

// A prism with a missing face and properties.
Surface_mesh open_prism()
{
  Surface_mesh mesh;
  auto faces = prism;
  faces.pop_back();
  std::vector<Point> points(corners.begin(), corners.end() - 1);
  PMP::polygon_soup_to_polygon_mesh(points, faces, mesh);
  int i = 0;
  auto v_map = mesh.add_property_map<Surface_mesh::Vertex_index, int>("v:i").first;
  for (const auto v : mesh.vertices())
    v_map[v] = ++i;
  auto h_map = mesh.add_property_map<Surface_mesh::Halfedge_index, float>("h:f").first;
  for (const auto h : mesh.halfedges())
    h_map[h] = float(++i);
  auto e_map = mesh.add_property_map<Surface_mesh::Edge_index, double>("e:d").first;
  for (const auto e : mesh.edges())
    e_map[e] = ++i;
  auto f_map = mesh.add_property_map<Surface_mesh::Face_index, CGAL::IO::Color>("f:color").first;
  for (const auto f : mesh.faces())
    f_map[f] = CGAL::IO::Color(1, 2, static_cast<unsigned char>(++i));
  return mesh;
}

TEST(Copy_face_graph, takes_property_maps_there_and_back)
{
  const Surface_mesh source = open_prism();
  Mesh mesh;
  CGAL::copy_face_graph(source, mesh);
  EXPECT_EQ(test::difference(source, mesh), "");

  CGAL::Compact_surface_mesh<Point, CGAL::Corner_table_layout<> > other;
  CGAL::copy_face_graph(mesh, other);
  EXPECT_EQ(test::difference(source, other), "");

  Surface_mesh back;
  CGAL::copy_face_graph(mesh, back);
  EXPECT_EQ(test::difference(back, mesh), "");

  // added to what is there
  Surface_mesh two;
  CGAL::make_tetrahedron(Point(9, 0, 0), Point(9, 1, 0), Point(8, 0, 0), Point(8, 0, 1), two);
  CGAL::copy_face_graph(mesh, two);
  EXPECT_EQ(two.number_of_faces(), 8u);
  const auto v_map = CGAL::internal::optional_map(two.property_map<Surface_mesh::Vertex_index, int>("v:i")).value();
  int sum = 0;
  for (const auto v : two.vertices())
    sum += get(v_map, v);
  EXPECT_EQ(sum, 21);
}

TEST(Copy_face_graph, tells_what_became_of_each_element)
{
  const Surface_mesh source = open_prism();
  std::map<Surface_mesh::Vertex_index, Mesh::Vertex_index> v2v;
  std::vector<std::pair<Surface_mesh::Halfedge_index, Mesh::Halfedge_index> > h2h;
  std::vector<std::pair<Surface_mesh::Face_index, Mesh::Face_index> > f2f;
  Mesh mesh;
  CGAL::copy_face_graph(source, mesh, parameters::vertex_to_vertex_map(boost::make_assoc_property_map(v2v))
                                        .halfedge_to_halfedge_output_iterator(std::back_inserter(h2h))
                                        .face_to_face_output_iterator(std::back_inserter(f2f)));
  ASSERT_EQ(v2v.size(), 6u);
  ASSERT_EQ(h2h.size(), source.number_of_halfedges());
  ASSERT_EQ(f2f.size(), 4u);
  for (const auto& pair : v2v)
    EXPECT_EQ(mesh.point(pair.second), source.point(pair.first));
  for (const auto& pair : h2h) {
    EXPECT_EQ(mesh.target(pair.second), v2v.at(source.target(pair.first)));
    EXPECT_EQ(mesh.source(pair.second), v2v.at(source.source(pair.first)));
  }

  // and back
  std::map<Mesh::Halfedge_index, Surface_mesh::Halfedge_index> back_map;
  std::vector<std::pair<Mesh::Vertex_index, Surface_mesh::Vertex_index> > v2v_back;
  Surface_mesh back;
  CGAL::copy_face_graph(mesh, back, parameters::vertex_to_vertex_output_iterator(std::back_inserter(v2v_back))
                                      .halfedge_to_halfedge_map(boost::make_assoc_property_map(back_map)));
  ASSERT_EQ(v2v_back.size(), 6u);
  for (const auto& pair : v2v_back)
    EXPECT_EQ(mesh.point(pair.first), back.point(pair.second));
  ASSERT_EQ(back_map.size(), source.number_of_halfedges());
  for (const auto& pair : back_map)
    EXPECT_EQ(mesh.point(mesh.target(pair.first)), back.point(back.target(pair.second)));
}

TEST(Copy_face_graph, converts_points_and_takes_property_maps_of_points)
{
  using Exact_mesh = CGAL::Compact_surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>;
  using Float_mesh = CGAL::Compact_surface_mesh<CGAL::Simple_cartesian<float>::Point_3>;
  CGAL::Polyhedron_3<Kernel> polyhedron;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(0, 1, 0), Point(1, 0, 0), Point(0, 0, 1), polyhedron);
  Exact_mesh exact;
  CGAL::copy_face_graph(polyhedron, exact);
  EXPECT_EQ(exact.number_of_faces(), 4u);
  Float_mesh floats;
  CGAL::copy_face_graph(exact, floats);
  float sum = 0;
  for (const auto& p : floats.points())
    sum += p.x() + 10 * p.y() + 100 * p.z();
  EXPECT_EQ(sum, 111);

  Surface_mesh source = open_prism();
  auto other = source.add_property_map<Surface_mesh::Vertex_index, Point>("v:other").first;
  for (const auto v : source.vertices())
    other[v] = Point(v.idx(), 0, 1);
  Mesh mesh;
  auto target = mesh.add_property_map<Mesh::Vertex_index, Point>("v:target").first;
  CGAL::copy_face_graph(source, mesh, parameters::vertex_point_map(other), parameters::vertex_point_map(target));
  double x = 0;
  for (const auto v : mesh.vertices()) {
    EXPECT_EQ(target[v].z(), 1);
    x += target[v].x();
  }
  EXPECT_EQ(x, 15);
}

// An output iterator that throws.
struct Thrower
{
  using iterator_category = std::output_iterator_tag;
  using value_type = void;
  using difference_type = std::ptrdiff_t;
  using pointer = void;
  using reference = void;
  Thrower& operator*() { return *this; }
  Thrower& operator++() { return *this; }
  Thrower& operator++(int) { return *this; }
  template <class T> Thrower& operator=(const T&) { throw std::logic_error("thrown"); }
};

TEST(Copy_face_graph, that_fails_leaves_the_target_as_it_was)
{
  const Surface_mesh source = open_prism();
  Mesh mesh;
  mesh.add_property_map<Mesh::Vertex_index, int>("v:mine");
  EXPECT_THROW(CGAL::copy_face_graph(source, mesh, parameters::face_to_face_output_iterator(Thrower())),
               std::logic_error);
  EXPECT_TRUE(mesh.is_empty());
  EXPECT_EQ(mesh.properties<Mesh::Vertex_index>().size(), 2u);
  EXPECT_TRUE(mesh.properties<Mesh::Face_index>().empty());

  CGAL::copy_face_graph(source, mesh);
  EXPECT_THROW(CGAL::copy_face_graph(source, mesh), std::runtime_error);
  EXPECT_EQ(mesh.number_of_faces(), 4u);
}

} // namespace
