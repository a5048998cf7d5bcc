// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Distances, intersections, sections, locations and the AABB tree, on both meshes of each pair.

#include "conformance_answers.h"
#include "../../examples/Compact_surface_mesh/names_of_cgal_6.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_halfedge_graph_segment_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Polygon_mesh_processing/intersection.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_slicer.h>
#include <CGAL/Side_of_triangle_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using test::Answer;
using test::expect_same_answer;
using test::expect_same_answers;
using test::Kernel;
using test::Mesh_of;
using test::Mesh_pair;
using test::Point;
using test::triangle_pairs;
namespace parameters = CGAL::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;

/// Calls `algorithm` with each tag of concurrency that there is.
template <class Algorithm>
void for_each_concurrency(const Algorithm& algorithm)
{
  algorithm(CGAL::Sequential_tag());
#ifdef CGAL_LINKED_WITH_TBB
  algorithm(CGAL::Parallel_tag());
#endif
}

/// Points around the origin, in and out of the meshes.
std::vector<Point> queries(int n = 30)
{
  std::vector<Point> points;
  for (int i = 1; i <= n; ++i)
    points.emplace_back(1.9 * std::sin(3. * i), 1.7 * std::sin(5. * i + 1), 1.3 * std::sin(7. * i * i + 2));
  return points;
}

/// A mesh, and itself with other points.
struct Two_meshes
{
  explicit Two_meshes(const test::Surface_mesh& mesh, const test::Surface_mesh& other)
    : first("first", mesh), second("second", other)
  {}

  /// Expects the same answer of `algorithm(m1, m2)` for both types.
  template <class Algorithm>
  void expect_same(const Algorithm& algorithm, double tolerance = test::rounding) const
  {
    const Answer answer = algorithm(first.compact, second.compact);
    const Answer expected = algorithm(first.expected, second.expected);
    EXPECT_FALSE(expected.is_empty());
    EXPECT_EQ(answer.difference(expected, tolerance), "");
    EXPECT_EQ(answer.difference(algorithm(first.twin, second.twin), 0), "") << "in the same order";
  }

  Mesh_pair first, second;
};

Two_meshes crossing_meshes()
{
  return Two_meshes(test::several_components(),
                    test::placed(test::plate_of_genus_3(), 1.3, Kernel::Vector_3(-0.3, -0.4, -0.7)));
}

TEST(Conformance_distances, from_vertices)
{
  crossing_meshes().expect_same([](const auto& m1, const auto& m2) {
    Answer answer;
    answer << PMP::max_distance_to_triangle_mesh<CGAL::Sequential_tag>(queries(), m1.mesh);
    const auto vertices_only = parameters::do_sample_faces(false).do_sample_edges(false);
    for_each_concurrency([&](auto tag) {
      typedef decltype(tag) Tag;
      answer << PMP::max_distance_to_triangle_mesh<Tag>(queries(), m2.mesh)
             << PMP::approximate_Hausdorff_distance<Tag>(m1.mesh, m2.mesh, vertices_only)
             << PMP::approximate_symmetric_Hausdorff_distance<Tag>(m1.mesh, m2.mesh, vertices_only, vertices_only);
    });
    return answer << PMP::approximate_max_distance_to_point_set(m1.mesh, queries(), 0.01);
  }, 0.01); // the precision of the last one
}

TEST(Conformance_distances, with_bounded_errors)
{
  constexpr double bound = 0.01;
  crossing_meshes().expect_same([](const auto& m1, const auto& m2) {
    Answer answer;
    answer << PMP::bounded_error_Hausdorff_distance<CGAL::Sequential_tag>(m1.mesh, m2.mesh, bound)
           << PMP::bounded_error_symmetric_Hausdorff_distance<CGAL::Sequential_tag>(m1.mesh, m2.mesh, bound);
#if defined(CGAL_LINKED_WITH_TBB) && defined(CGAL_METIS_ENABLED)
    answer << PMP::bounded_error_Hausdorff_distance<CGAL::Parallel_tag>(m1.mesh, m2.mesh, bound);
#endif
    for (const double distance : {0.1, 1., 3., 10.})
      answer << PMP::is_Hausdorff_distance_larger<CGAL::Sequential_tag>(m1.mesh, m2.mesh, distance, bound);
    return answer;
  }, 2 * bound);
  const Two_meshes same(test::bumpy_sphere(2), test::bumpy_sphere(2));
  same.expect_same([](const auto& m1, const auto& m2) {
    return Answer() << PMP::bounded_error_Hausdorff_distance<CGAL::Sequential_tag>(m1.mesh, m2.mesh, bound);
  }, bound);
}

// Where points in faces lie depends on their first vertices, and random ones on the order of faces.
TEST(Conformance_distances, samples)
{
  test::expect_same_answers_in_same_order(triangle_pairs(), [](const auto& m) {
    Answer answer;
    std::vector<Point> points;
    const auto sample = [&](const auto& np) {
      points.clear();
      CGAL::get_default_random() = CGAL::Random(1);
      PMP::sample_triangle_mesh(m.mesh, std::back_inserter(points), np);
      answer << points;
    };
    sample(parameters::do_sample_faces(false).do_sample_edges(false));
    sample(parameters::random_seed(1).number_of_points_on_faces(100).number_of_points_on_edges(50));
    sample(parameters::use_random_uniform_sampling(false).use_monte_carlo_sampling(true).random_seed(1)
             .number_of_points_per_face(2).number_of_points_per_edge(3));
    sample(parameters::use_random_uniform_sampling(false).use_grid_sampling(true).grid_spacing(0.05));
    for_each_concurrency([&](auto tag) {
      CGAL::get_default_random() = CGAL::Random(1);
      answer << PMP::approximate_Hausdorff_distance<decltype(tag)>(
        m.mesh, m.mesh, parameters::random_seed(1).number_of_points_on_faces(100).number_of_points_on_edges(50));
    });
    return answer;
  });
}

/// The names of the faces of pairs.
template <class Named, class Pairs>
std::set<std::multiset<std::size_t>> names_of_pairs(const Named& m, const Pairs& pairs)
{
  std::set<std::multiset<std::size_t>> names;
  for (const auto& pair : pairs)
    names.insert({m.name(pair.first), m.name(pair.second)});
  return names;
}

/// What polylines are, wherever they start.
Answer& add_polylines(Answer& answer, const std::vector<std::vector<Point>>& polylines)
{
  std::vector<std::pair<std::size_t, double>> sizes;
  for (const auto& polyline : polylines) {
    double length = 0;
    for (std::size_t i = 1; i < polyline.size(); ++i)
      length += std::sqrt(CGAL::squared_distance(polyline[i - 1], polyline[i]));
    sizes.emplace_back(polyline.size(), length);
  }
  std::sort(sizes.begin(), sizes.end());
  return answer << sizes;
}

test::Surface_mesh self_intersecting_mesh()
{
  test::Surface_mesh mesh = test::bumpy_sphere(2);
  CGAL::copy_face_graph(test::placed(test::bumpy_sphere(1), 0.8, Kernel::Vector_3(0.7, 0.4, 0.3)), mesh);
  mesh.point(test::Surface_mesh::Vertex_index(5)) = Point(0.1, -1.5, 0.2);
  return mesh;
}

TEST(Conformance_distances, self_intersections)
{
  const Mesh_pair intersecting("two spheres that intersect", self_intersecting_mesh());
  const auto self_intersections = [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    typedef typename Mesh::Face_index Face;
    Answer answer;
    for_each_concurrency([&](auto tag) {
      typedef decltype(tag) Tag;
      std::vector<std::pair<Face, Face>> pairs;
      PMP::self_intersections<Tag>(m.mesh, std::back_inserter(pairs));
      answer << names_of_pairs(m, pairs) << PMP::does_self_intersect<Tag>(m.mesh);
    });
    const std::vector<Face> some(m.faces().begin(), m.faces().begin() + 60);
    std::vector<std::pair<Face, Face>> pairs;
    PMP::self_intersections(some, m.mesh, std::back_inserter(pairs));
    answer << names_of_pairs(m, pairs) << PMP::does_self_intersect(some, m.mesh);
    return answer;
  };
  expect_same_answer(intersecting, self_intersections);
  EXPECT_TRUE(PMP::does_self_intersect(intersecting.compact.mesh));
  expect_same_answers(triangle_pairs(), self_intersections);
  const Mesh_pair two_spheres("two spheres", [] {
    test::Surface_mesh mesh = test::bumpy_sphere(2);
    CGAL::copy_face_graph(test::placed(test::bumpy_sphere(1), 0.8, Kernel::Vector_3(0.7, 0.4, 0.3)), mesh);
    return mesh;
  }());
  expect_same_answer(two_spheres, [](const auto& m) {
    std::vector<std::vector<Point>> polylines;
    PMP::experimental::surface_self_intersection(m.mesh, std::back_inserter(polylines));
    EXPECT_FALSE(polylines.empty());
    Answer answer;
    return add_polylines(answer, polylines);
  });
}

TEST(Conformance_distances, intersections)
{
  crossing_meshes().expect_same([](const auto& m1, const auto& m2) {
    typedef Mesh_of<decltype(m1)> Mesh;
    std::vector<std::vector<Point>> polylines;
    PMP::surface_intersection(m1.mesh, m2.mesh, std::back_inserter(polylines));
    EXPECT_FALSE(polylines.empty());
    Answer answer;
    add_polylines(answer, polylines);
    const std::vector<Point> polyline = {Point(0, 0, 0), Point(0.5, 0.1, 0.3), Point(4, 0.1, 0.2)};
    const std::vector<Point> short_one = {Point(0, 0, 0), Point(0.01, 0.02, 0.01)};
    answer << PMP::do_intersect(m1.mesh, m2.mesh)
           << PMP::do_intersect(m1.mesh, polyline) << PMP::do_intersect(m1.mesh, short_one)
           << PMP::do_intersect(m1.mesh, std::vector<std::vector<Point>>{short_one, polyline});
    const std::vector<Mesh> meshes = {m1.mesh, m2.mesh, Mesh(m1.mesh)};
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    PMP::intersecting_meshes(meshes, std::back_inserter(pairs));
    std::set<std::pair<std::size_t, std::size_t>> sorted;
    for (const auto& pair : pairs)
      sorted.insert(std::minmax(pair.first, pair.second));
    return answer << sorted;
  });
  const Two_meshes nested(test::bumpy_sphere(1), test::placed(test::bumpy_sphere(1), 0.5, Kernel::Vector_3(0, 0, 0)));
  nested.expect_same([](const auto& m1, const auto& m2) {
    return Answer() << PMP::do_intersect(m1.mesh, m2.mesh)
                    << PMP::do_intersect(m1.mesh, m2.mesh, parameters::do_overlap_test_of_bounded_sides(true),
                                         parameters::do_overlap_test_of_bounded_sides(true));
  });
}

TEST(Conformance_distances, sections)
{
  expect_same_answers(triangle_pairs(), [](const auto& m) {
    CGAL::Polygon_mesh_slicer<Mesh_of<decltype(m)>, Kernel> slice(m.mesh);
    Answer answer;
    for (std::size_t i = 0; i < 6; ++i) {
      std::vector<std::vector<Point>> polylines;
      const Point p = CGAL::midpoint(m.point(m.vertex(10 + i)), m.point(m.vertex(140 - i)));
      const Kernel::Vector_3 normal(0.3 * double(i) - 0.7, 1 - 0.2 * double(i), 0.4);
      slice(Kernel::Plane_3(p, normal), std::back_inserter(polylines));
      EXPECT_FALSE(polylines.empty());
      std::size_t num_closed = 0;
      for (const auto& polyline : polylines)
        num_closed += polyline.front() == polyline.back() ? 1 : 0;
      answer << num_closed;
      add_polylines(answer, polylines);
    }
    return answer;
  });
}

TEST(Conformance_distances, sides_of_meshes)
{
  expect_same_answers(test::connected_closed_pairs(), [](const auto& m) {
    const CGAL::Side_of_triangle_mesh<Mesh_of<decltype(m)>, Kernel> side(m.mesh);
    return Answer().on(queries(200), [&](const Point& p) { return side(CGAL::ORIGIN + 0.7 * (p - CGAL::ORIGIN)); });
  });
}

/// A location, by the names of the corners of its face.
template <class Named, class Location>
Answer& add_location(Answer& answer, const Named& m, const Location& location)
{
  std::map<std::size_t, double> coordinates;
  std::size_t i = 0;
  for (const auto v : CGAL::vertices_around_face(halfedge(location.first, m.mesh), m.mesh))
    coordinates[m.name(v)] = location.second[(i++ + 1) % 3]; // coordinates begin at the source
  return answer << m.name(location.first) << coordinates << PMP::construct_point(location, m.mesh);
}

TEST(Conformance_distances, locations)
{
  expect_same_answers(triangle_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    const Mesh& mesh = m.mesh;
    Answer answer;
    for (const Point& p : queries(5)) { // each call builds a tree
      const auto location = PMP::locate(p, mesh);
      answer << PMP::construct_point(location, mesh);
      // the face, unless a point far away is closest to an edge
      if (*std::min_element(location.second.begin(), location.second.end()) > 1e-6)
        add_location(answer, m, location);
    }
    for (const Point& p : queries(3)) {
      const auto location = PMP::locate(Kernel::Ray_3(Point(0.31, 0.37, 0.23), p), mesh);
      answer << (location.first != Mesh::null_face());
      if (location.first != Mesh::null_face())
        add_location(answer, m, location);
    }
    for (const auto v : m.vertices())
      answer << PMP::construct_point(PMP::locate_vertex<double>(v, mesh), mesh);
    for (const auto h : m.halfedges())
      if (!CGAL::is_border(h, mesh))
        add_location(answer, m, PMP::locate_on_halfedge(h, 0.3, mesh));
    for (const auto f : m.faces()) {
      const auto h = halfedge(f, mesh);
      const Point p = CGAL::centroid(m.point(source(h, mesh)), m.point(target(h, mesh)),
                                     m.point(target(next(h, mesh), mesh)));
      add_location(answer, m, PMP::locate_in_face(p, f, mesh));
      answer << PMP::is_in_face(PMP::locate_in_face(p, f, mesh), mesh);
    }
    for (const auto h : m.halfedges())
      if (!CGAL::is_border(h, mesh) && !CGAL::is_border(opposite(h, mesh), mesh)) {
        const auto there = PMP::locate_in_adjacent_face(PMP::locate_on_halfedge(h, 0.4, mesh),
                                                        face(opposite(h, mesh), mesh), mesh);
        add_location(answer, m, there);
      }
    return answer;
  });
}

/// Answers of a tree that hold for any order of its primitives.
template <class Tree, class Name>
Answer answers_of_tree(const Tree& tree, const Name& name)
{
  Answer answer;
  answer << tree.size() << tree.bbox();
  for (const Point& p : queries()) {
    answer << tree.closest_point(p) << tree.squared_distance(p);
    const auto closest = tree.closest_point_and_primitive(p);
    answer << closest.first;
    const Kernel::Ray_3 ray(Point(0.01, 0.02, 0.03), p);
    const Kernel::Segment_3 segment(Point(0.01, 0.02, 0.03), p);
    const Kernel::Plane_3 plane(p, p - CGAL::ORIGIN);
    answer << tree.do_intersect(segment) << tree.number_of_intersected_primitives(plane);
    std::vector<typename Tree::Primitive_id> primitives;
    tree.all_intersected_primitives(plane, std::back_inserter(primitives));
    std::multiset<std::size_t> names;
    for (const auto& primitive : primitives)
      names.insert(name(primitive));
    answer << names << bool(tree.any_intersected_primitive(ray)) << bool(tree.any_intersection(plane));
  }
  return answer;
}

TEST(Conformance_distances, trees_of_faces)
{
  expect_same_answers(triangle_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    typedef CGAL::AABB_face_graph_triangle_primitive<Mesh> Primitive;
    CGAL::AABB_tree<example::AABB_traits_3<Kernel, Primitive>> tree(faces(m.mesh).first, faces(m.mesh).second, m.mesh);
    tree.accelerate_distance_queries();
    Answer answer = answers_of_tree(tree, [&](auto f) { return m.name(f); });
    for (const Point& p : queries()) {
      const Kernel::Ray_3 ray(Point(0.01, 0.02, 0.03), p);
      const auto hit = tree.first_intersection(ray);
      answer << bool(hit) << tree.number_of_intersected_primitives(ray);
      if (hit) {
        const auto face = tree.first_intersected_primitive(ray);
        answer << m.name(hit->second) << m.name(*face);
        if (const Point* q = example::get_if<Point>(&hit->first))
          answer << *q;
      }
    }
    return answer;
  });
}

TEST(Conformance_distances, trees_of_faces_with_cached_triangles)
{
  expect_same_answers(triangle_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    typedef CGAL::AABB_face_graph_triangle_primitive<Mesh, CGAL::Default, CGAL::Tag_false, CGAL::Tag_true> Primitive;
    const CGAL::AABB_tree<example::AABB_traits_3<Kernel, Primitive>> tree(faces(m.mesh).first, faces(m.mesh).second,
                                                                              m.mesh);
    return answers_of_tree(tree, [&](const auto& f) { return m.name(f.first); });
  });
}

TEST(Conformance_distances, trees_of_edges)
{
  expect_same_answers(test::all_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    typedef CGAL::AABB_halfedge_graph_segment_primitive<Mesh> Primitive;
    const CGAL::AABB_tree<example::AABB_traits_3<Kernel, Primitive>> tree(edges(m.mesh).first, edges(m.mesh).second,
                                                                              m.mesh);
    return answers_of_tree(tree, [&](auto e) { return m.name(e); });
  });
}

} // namespace
