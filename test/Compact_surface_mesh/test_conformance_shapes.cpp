// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Approximations, regions, partitions, hulls and smoothing, on both meshes of each pair. Many of
// them depend on the order of elements.

#include "conformance_answers.h"

#include <CGAL/Compact_surface_mesh/internal/versions_of_cgal.h>

#include <CGAL/Extreme_points_traits_adapter_3.h>
#include <CGAL/Polygon_mesh_processing/fair.h>
#include <CGAL/Polygon_mesh_processing/random_perturbation.h>
#include <CGAL/Polygon_mesh_processing/smooth_shape.h>
#include <CGAL/Polygon_mesh_processing/tangential_relaxation.h>
#include <CGAL/Polyhedral_envelope.h>
#include <CGAL/Shape_detection/Region_growing/Region_growing.h>
#include <CGAL/Surface_mesh_approximation/L2_metric_plane_proxy.h>
#include <CGAL/Surface_mesh_approximation/approximate_triangle_mesh.h>
#include <CGAL/Variational_shape_approximation.h>
#include <CGAL/convex_hull_3.h>

#if CGAL_COMPACT_SURFACE_MESH_WITH_CGAL_6
#include <CGAL/Shape_detection/Region_growing/Polygon_mesh.h>
#else
#include <CGAL/Shape_detection/Region_growing/Region_growing_on_polygon_mesh.h>
#endif

#ifdef CGAL_METIS_ENABLED
#include <CGAL/boost/graph/METIS/partition_dual_graph.h>
#include <CGAL/boost/graph/METIS/partition_graph.h>
#endif

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <map>
#include <set>
#include <type_traits>
#include <vector>

namespace {

using test::Answer;
using test::expect_same_answers;
using test::expect_same_answers_in_same_order;
using test::Kernel;
using test::Mesh_of;
using test::Point;
using test::triangle_pairs;
namespace parameters = CGAL::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace VSA = CGAL::Surface_mesh_approximation;

/// The places of all vertices.
template <class Named, class Mesh>
Answer points(const Named& m, const Mesh& mesh)
{
  return Answer().on(m.vertices(), [&](auto v) { return mesh.point(v); });
}

TEST(Conformance_shapes, smoothing_and_fairing)
{
  expect_same_answers({&test::sphere_pair(), &test::genus_3_pair(), &test::borders_pair()}, [](const auto& m) {
    Mesh_of<decltype(m)> mesh = m.mesh;
    PMP::smooth_shape(mesh, 0.01, parameters::number_of_iterations(2));
    return points(m, mesh);
  }, test::solving);
  // At borders, CGAL 6.0 asserts of Surface_mesh, too, that they are triangles: Weights/cotangent_weights.h, line 357.
  const test::Mesh_pairs pairs_to_fair =
    CGAL::internal::is_with_cgal_6 ? test::connected_closed_pairs() : test::connected_triangle_pairs();
  expect_same_answers(pairs_to_fair, [](const auto& m) {
    Mesh_of<decltype(m)> mesh = m.mesh;
    std::vector<typename Mesh_of<decltype(m)>::Vertex_index> region;
    for (const auto v : m.vertices())
      if (mesh.point(v).x() < 0.5)
        region.push_back(v);
    const bool is_fair = PMP::fair(mesh, region);
    EXPECT_TRUE(is_fair);
    return points(m, mesh);
  }, test::solving);
  expect_same_answers_in_same_order(test::connected_triangle_pairs(), [](const auto& m) {
    Mesh_of<decltype(m)> mesh = m.mesh;
    PMP::tangential_relaxation(mesh, parameters::number_of_iterations(2));
    PMP::random_perturbation(mesh, 0.01, parameters::random_seed(1));
    return points(m, mesh);
  });
}

TEST(Conformance_shapes, variational_approximation)
{
  expect_same_answers_in_same_order(triangle_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    typedef typename Mesh::Face_index Face;
    typedef typename boost::property_map<Mesh, CGAL::vertex_point_t>::type Vertex_point_map;
    const Mesh& mesh = m.mesh;
    Answer answer;
    for (const VSA::Seeding_method method : {VSA::HIERARCHICAL, VSA::INCREMENTAL, VSA::RANDOM}) {
      std::srand(1); // for random seeds
      std::map<Face, std::size_t> proxy;
      std::vector<Point> anchors;
      std::vector<std::array<std::size_t, 3>> triangles;
      VSA::approximate_triangle_mesh(mesh, parameters::seeding_method(method)
                                             .max_number_of_proxies(8)
                                             .number_of_iterations(3)
                                             .face_proxy_map(boost::make_assoc_property_map(proxy))
                                             .anchors(std::back_inserter(anchors))
                                             .triangles(std::back_inserter(triangles)));
      answer.on(m.faces(), [&](auto f) { return proxy.at(f); });
      answer << anchors << triangles;
    }

    typedef CGAL::Variational_shape_approximation<Mesh, Vertex_point_map> Approximation;
    const Vertex_point_map point = get(CGAL::vertex_point, const_cast<Mesh&>(mesh));
    const typename Approximation::Error_metric metric(mesh, point);
    Approximation approximation(mesh, point, metric);
    answer << approximation.initialize_seeds(parameters::seeding_method(VSA::INCREMENTAL).max_number_of_proxies(6));
    approximation.run(3);
    answer << approximation.add_to_furthest_proxies(2, 2) << approximation.teleport_proxies(1, 2)
           << approximation.extract_mesh(parameters::default_values()) << approximation.number_of_proxies();
    std::map<Face, std::size_t> proxy;
    approximation.proxy_map(boost::make_assoc_property_map(proxy));
    answer.on(m.faces(), [&](auto f) { return proxy.at(f); });

    typedef VSA::L2_metric_plane_proxy<Mesh> Distance_metric;
    const Distance_metric distance_metric(mesh, point);
    CGAL::Variational_shape_approximation<Mesh, Vertex_point_map, Distance_metric> by_distance(mesh, point,
                                                                                              distance_metric);
    by_distance.initialize_seeds(parameters::seeding_method(VSA::INCREMENTAL).max_number_of_proxies(6));
    by_distance.run(3);
    by_distance.proxy_map(boost::make_assoc_property_map(proxy));
    return answer.on(m.faces(), [&](auto f) { return proxy.at(f); });
  });
}

/// The names of the faces of almost planar regions.
template <class Named>
std::vector<std::multiset<std::size_t>> grown_regions(const Named& m)
{
  namespace Regions = CGAL::Shape_detection::Polygon_mesh;
  typedef Mesh_of<Named> Mesh;
  typedef Regions::One_ring_neighbor_query<Mesh> Neighbors;
  typedef Regions::Least_squares_plane_fit_region<Kernel, Mesh> Region_type;
  typedef Regions::Least_squares_plane_fit_sorting<Kernel, Mesh, Neighbors> Sorting;
  Neighbors neighbors(m.mesh);
  std::vector<std::multiset<std::size_t>> result;
#if CGAL_COMPACT_SURFACE_MESH_WITH_CGAL_6
  typedef CGAL::Shape_detection::Region_growing<Neighbors, Region_type> Region_growing;
  Region_type region_type(m.mesh, parameters::maximum_distance(0.05).maximum_angle(30.).minimum_region_size(3));
  Sorting sorting(m.mesh, neighbors);
  sorting.sort();
  Region_growing region_growing(faces(m.mesh), sorting.ordered(), neighbors, region_type);
  std::vector<typename Region_growing::Primitive_and_region> regions;
  region_growing.detect(std::back_inserter(regions));
  for (const auto& region : regions)
    result.push_back(m.names(region.second));
#else
  typedef typename Mesh::Face_range Face_range;
  typedef CGAL::Shape_detection::Region_growing<Face_range, Neighbors, Region_type, typename Sorting::Seed_map>
    Region_growing;
  const Face_range face_range = faces(m.mesh);
  const auto point = get(CGAL::vertex_point, m.mesh);
  Region_type region_type(m.mesh, 0.05, 30, 3, point);
  Sorting sorting(m.mesh, neighbors, point);
  sorting.sort();
  Region_growing region_growing(face_range, neighbors, region_type, sorting.seed_map());
  std::vector<std::vector<std::size_t>> regions;
  region_growing.detect(std::back_inserter(regions));
  for (const auto& region : regions) {
    result.emplace_back();
    for (const std::size_t i : region)
      result.back().insert(m.name(*(face_range.begin() + static_cast<std::ptrdiff_t>(i))));
  }
#endif
  return result;
}

TEST(Conformance_shapes, region_growing)
{
  expect_same_answers_in_same_order(test::all_pairs(), [](const auto& m) {
    const std::vector<std::multiset<std::size_t>> regions = grown_regions(m);
    EXPECT_GT(regions.size(), 1u);
    return Answer() << regions;
  });
}

#ifdef CGAL_METIS_ENABLED

TEST(Conformance_shapes, partition)
{
  expect_same_answers_in_same_order(triangle_pairs(), [](const auto& m) {
    const auto vertex_part = get(CGAL::dynamic_vertex_property_t<std::size_t>(), m.mesh);
    const auto face_part = get(CGAL::dynamic_face_property_t<std::size_t>(), m.mesh);
    Answer answer;
    const auto add_parts = [&] {
      answer.on(m.vertices(), [&](auto v) { return get(vertex_part, v); });
      answer.on(m.faces(), [&](auto f) { return get(face_part, f); });
    };
    const auto parts = parameters::vertex_partition_id_map(vertex_part).face_partition_id_map(face_part);
    CGAL::METIS::partition_graph(m.mesh, 5, parts);
    add_parts();
    CGAL::METIS::partition_dual_graph(m.mesh, 5, parts);
    add_parts();
    return answer;
  });
}

#else

TEST(Conformance_shapes, partition) { GTEST_SKIP() << "METIS was not found"; }

#endif

TEST(Conformance_shapes, convex_hull)
{
  expect_same_answers(test::all_pairs(), [](const auto& m) {
    test::Surface_mesh hull;
    CGAL::convex_hull_3(m.mesh, hull);
    std::set<Point> corners, extremes;
    for (const auto v : vertices(hull))
      corners.insert(hull.point(v));
    std::vector<typename Mesh_of<decltype(m)>::Vertex_index> extreme_vertices;
    CGAL::extreme_points_3(vertices(m.mesh), std::back_inserter(extreme_vertices),
                           CGAL::make_extreme_points_traits_adapter(get(CGAL::vertex_point, m.mesh)));
    return Answer() << corners << num_faces(hull) << m.names(extreme_vertices)
                    << CGAL::is_strongly_convex_3(hull);
  });
}

TEST(Conformance_shapes, polyhedral_envelope)
{
  expect_same_answers({&test::sphere_pair(), &test::disk_pair()}, [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    const CGAL::Polyhedral_envelope<Kernel> envelope(m.mesh, 0.1);
    const std::vector<typename Mesh::Face_index> some(m.faces().begin(), m.faces().begin() + 30);
    const CGAL::Polyhedral_envelope<Kernel> part(some, m.mesh, 0.1);
    Answer answer;
    answer << envelope(m.mesh) << part(m.mesh);
    for (const auto v : m.vertices()) {
      const Point p = m.point(v), q = p + 0.03 * Kernel::Vector_3(1, 1, 1), r = p + Kernel::Vector_3(0, 0.3, 0);
      answer << envelope(p) << envelope(p, q) << envelope(p, r) << envelope(p, q, r) << part(p) << part(p, q);
    }
    return answer;
  });
}

} // namespace
