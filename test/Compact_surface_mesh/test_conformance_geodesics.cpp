// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Shortest paths and distances on surfaces, on both meshes of each pair.

#include "conformance_answers.h"
#include "../../examples/Compact_surface_mesh/names_of_cgal_6.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using test::Answer;
using test::expect_same_answers;
using test::Kernel;
using test::Mesh_of;
using test::Point;

/// What a path passes, with the names of edges and faces.
template <class Named>
struct Path_visitor
{
  void operator()(typename Named::Halfedge h, Kernel::FT) { answer << m.name(edge(h, m.mesh)); }
  void operator()(typename Named::Vertex v) { answer << m.name(v); }
  template <class Coordinates> void operator()(typename Named::Face f, Coordinates) { answer << m.name(f); }

  const Named& m;
  Answer& answer;
};

TEST(Conformance_geodesics, shortest_paths)
{
  expect_same_answers(test::triangle_pairs(), [](const auto& m) {
    typedef std::decay_t<decltype(m)> Named;
    typedef Mesh_of<Named> Mesh;
    typedef example::AABB_traits_3<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>> Tree_traits;
    CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>> paths(m.mesh);
    paths.add_source_point(m.vertex(7));
    paths.add_source_point(m.face_of(101), {{1. / 3, 1. / 3, 1. / 3}});
    Answer answer;
    Path_visitor<Named> visitor{m, answer};
    for (const auto v : m.vertices()) {
      std::vector<Point> points;
      answer << paths.shortest_distance_to_source_points(v).first;
      answer << paths.shortest_path_points_to_source_points(v, std::back_inserter(points)).first << points;
      answer << paths.shortest_path_sequence_to_source_points(v, visitor).first;
    }
    for (std::size_t i = 0; i < m.faces().size(); i += 10) {
      std::vector<Point> points;
      answer << paths.shortest_path_points_to_source_points(m.face_of(i), {{1. / 3, 1. / 3, 1. / 3}},
                                                            std::back_inserter(points)).first
             << points;
    }
    for (int i = 1; i < 10; ++i) {
      const auto location = paths.template locate<Tree_traits>(Point(0.1 * i, 0.2, 0.3));
      answer << paths.point(location.first, location.second);
    }
    return answer;
  }, test::solving);
}

/// Distances from one vertex and from several ones, by functions and by the class.
template <class Mode, class Named>
Answer heat_distances(const Named& m)
{
  typedef CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<typename Named::Mesh, Mode> Heat_method;
  const auto distance = get(CGAL::dynamic_vertex_property_t<double>(), m.mesh);
  Answer answer;
  const auto add_distances = [&] { answer.on(m.vertices(), [&](auto v) { return get(distance, v); }); };
  CGAL::Heat_method_3::estimate_geodesic_distances(m.mesh, distance, m.vertex(7), Mode());
  add_distances();
  CGAL::Heat_method_3::estimate_geodesic_distances(m.mesh, distance, std::vector{m.vertex(7), m.vertex(100)}, Mode());
  add_distances();
  Heat_method heat(m.mesh);
  heat.add_source(m.vertex(20));
  heat.add_source(m.vertex(7));
  heat.estimate_geodesic_distances(distance);
  add_distances();
  heat.remove_source(m.vertex(20));
  heat.add_source(m.vertex(100));
  heat.estimate_geodesic_distances(distance);
  add_distances();
  // for Surface_mesh, those of the intrinsic mode are no vertices of the mesh
  return answer << std::distance(heat.sources().begin(), heat.sources().end());
}

TEST(Conformance_geodesics, heat_method_directly)
{
  expect_same_answers(test::connected_triangle_pairs(),
                      [](const auto& m) { return heat_distances<CGAL::Heat_method_3::Direct>(m); }, test::solving);
}

// It copies the mesh, in an order of its own.
TEST(Conformance_geodesics, heat_method_by_intrinsic_triangulations)
{
  const auto distances = [](const auto& m) {
    Answer answer = heat_distances<CGAL::Heat_method_3::Intrinsic_Delaunay>(m);
    const auto distance = get(CGAL::dynamic_vertex_property_t<double>(), m.mesh);
    CGAL::Heat_method_3::estimate_geodesic_distances(m.mesh, distance, m.vertex(7)); // the default
    return answer.on(m.vertices(), [&](auto v) { return get(distance, v); });
  };
  for (const auto* const pair : test::connected_triangle_pairs())
    EXPECT_EQ(distances(pair->compact).difference(distances(pair->expected), test::solving), "") << pair->name;
}

} // namespace
