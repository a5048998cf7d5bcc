// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// What reads meshes in CGAL 6 and is not in CGAL 5, on both meshes of each pair.

#include "conformance_answers.h"

#include <CGAL/Orthtree.h>
#include <CGAL/Orthtree_traits_face_graph.h>
#include <CGAL/Polygon_mesh_processing/interpolated_corrected_curvatures.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/region_growing.h>
#include <CGAL/Polygon_mesh_processing/remesh_planar_patches.h>
#include <CGAL/Polygon_mesh_processing/triangle.h>
#include <CGAL/Shape_detection/Region_growing/Polygon_mesh/Polyline_graph.h>
#include <CGAL/Weights/cotangent_weights.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/draw_compact_surface_mesh.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <vector>

namespace {

using test::all_pairs;
using test::Answer;
using test::expect_same_answers;
using test::expect_same_answers_in_same_order;
using test::Kernel;
using test::Mesh_of;
using test::Point;
using test::triangle_pairs;
namespace parameters = CGAL::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;

TEST(Conformance_cgal_6, validity_of_elements)
{
  expect_same_answers(all_pairs(), [](const auto& m) {
    const auto& mesh = m.mesh;
    Answer answer;
    answer.on(m.vertices(), [&](auto v) { return CGAL::BGL::is_valid_vertex_descriptor(v, mesh); });
    answer.on(m.halfedges(), [&](auto h) { return CGAL::BGL::is_valid_halfedge_descriptor(h, mesh); });
    answer.on(m.edges(), [&](auto e) { return CGAL::BGL::is_valid_edge_descriptor(e, mesh); });
    answer.on(m.faces(), [&](auto f) { return CGAL::BGL::is_valid_face_descriptor(f, mesh); });
    answer.on(m.edges(), [&](auto e) { return CGAL::is_valid_edge_descriptor(e, mesh); });

    typedef Mesh_of<decltype(m)> Mesh;
    typedef typename Mesh::size_type Index;
    const auto none = [](auto number) { return static_cast<Index>(number + 3); };
    answer << CGAL::is_valid_vertex_descriptor(typename Mesh::Vertex_index(none(num_vertices(mesh))), mesh)
           << CGAL::is_valid_halfedge_descriptor(typename Mesh::Halfedge_index(none(num_halfedges(mesh))), mesh)
           << CGAL::is_valid_edge_descriptor(typename Mesh::Edge_index(none(num_edges(mesh))), mesh)
           << CGAL::is_valid_face_descriptor(typename Mesh::Face_index(none(num_faces(mesh))), mesh)
           << CGAL::is_valid_vertex_descriptor(Mesh::null_vertex(), mesh)
           << CGAL::is_valid_face_descriptor(Mesh::null_face(), mesh);
    return answer;
  });
}

TEST(Conformance_cgal_6, lengths_triangles_and_weights)
{
  expect_same_answers(triangle_pairs(), [](const auto& m) {
    const auto& mesh = m.mesh;
    Answer answer;
    answer << PMP::average_edge_length(mesh);
    for (const auto f : m.faces()) {
      const Kernel::Triangle_3 triangle = PMP::triangle(f, mesh);
      answer << CGAL::centroid(triangle) << CGAL::unit_normal(triangle[0], triangle[1], triangle[2]);
    }
    const auto point = get(CGAL::vertex_point, mesh);
    const CGAL::Weights::Cotangent_weight<Mesh_of<decltype(m)>, std::decay_t<decltype(point)>> weight(mesh, point);
    return answer.on(m.halfedges(), [&](auto h) { return weight(h); });
  });
}

TEST(Conformance_cgal_6, curvatures)
{
  typedef PMP::Principal_curvatures_and_directions<Kernel> Principal;
  expect_same_answers(triangle_pairs(), [](const auto& m) {
    const auto& mesh = m.mesh;
    const auto mean = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
    const auto gaussian = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
    const auto principal = get(CGAL::dynamic_vertex_property_t<Principal>(), mesh);
    Answer answer;
    for (const double radius : {0., 0.5}) {
      PMP::interpolated_corrected_curvatures(mesh, parameters::vertex_mean_curvature_map(mean)
                                                     .vertex_Gaussian_curvature_map(gaussian)
                                                     .vertex_principal_curvatures_and_directions_map(principal)
                                                     .ball_radius(radius));
      for (const auto v : m.vertices())
        answer << get(mean, v) << get(gaussian, v) << get(principal, v).min_curvature
               << get(principal, v).max_curvature;
    }
    double mean_of_one = 0;
    PMP::interpolated_corrected_curvatures(m.vertex(5), mesh,
                                           parameters::vertex_mean_curvature(std::ref(mean_of_one)).ball_radius(0.5));
    return answer << mean_of_one;
  }, test::solving);
}

// CGAL 6.0 takes the type of the point map of the input as that of the output if none is given.
auto points_of(test::Surface_mesh& mesh) { return parameters::vertex_point_map(mesh.points()); }

// Regions as sets of names, the corners between them, and the mesh of these.
TEST(Conformance_cgal_6, regions_and_their_corners)
{
  expect_same_answers_in_same_order(triangle_pairs(), [](const auto& m) {
    const auto& mesh = m.mesh;
    const auto region = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
    const auto corner = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
    const auto is_between = get(CGAL::dynamic_edge_property_t<bool>(), mesh, false);
    const auto limits = parameters::maximum_distance(0.05).maximum_angle(30.);
    Answer answer;
    const std::size_t num_regions =
      PMP::region_growing_of_planes_on_faces(mesh, region, limits.postprocess_regions(true));
    EXPECT_GT(num_regions, 1u);
    const std::size_t num_corners =
      PMP::detect_corners_of_regions(mesh, region, num_regions, corner,
                                     limits.edge_is_constrained_map(is_between));
    answer << num_regions << num_corners;
    answer.on(m.faces(), [&](auto f) { return get(region, f); });
    answer.on(m.vertices(), [&](auto v) { return get(corner, v); });
    answer.on(m.edges(), [&](auto e) { return get(is_between, e); });

    test::Surface_mesh simple;
    answer << PMP::remesh_almost_planar_patches(mesh, simple, num_regions, num_corners, region, corner, is_between,
                                                parameters::default_values(), points_of(simple))
           << num_vertices(simple) << num_faces(simple);
    for (const auto v : simple.vertices())
      answer << simple.point(v);

    typedef CGAL::Shape_detection::Polygon_mesh::Polyline_graph<Mesh_of<decltype(m)>> Polylines;
    const Polylines polylines(mesh, region);
    answer << m.names(polylines.segment_range());
    std::vector<typename Polylines::Item> neighbors;
    for (const auto e : polylines.segment_range()) {
      polylines(e, neighbors);
      answer << m.names(neighbors);
    }
    return answer;
  });
}

TEST(Conformance_cgal_6, planar_patches)
{
  test::Surface_mesh box;
  CGAL::make_hexahedron(Kernel::Iso_cuboid_3(Point(0, 0, 0), Point(1, 2, 3)), box,
                        parameters::do_not_triangulate_faces(false));
  for (test::Surface_mesh::size_type i = 0; i < 20; ++i) { // points on edges and in faces, all of which can go
    const test::Surface_mesh::Edge_index e(7 * i % box.number_of_edges());
    const auto h = box.halfedge(e);
    const Point p = CGAL::midpoint(box.point(box.source(h)), box.point(box.target(h)));
    const auto middle = CGAL::Euler::split_edge(h, box);
    box.point(box.target(middle)) = p;
    CGAL::Euler::split_face(middle, box.next(box.next(middle)), box);
    const auto other = box.opposite(h);
    CGAL::Euler::split_face(other, box.next(box.next(other)), box);
  }
  const test::Mesh_pair pair("a box", box);
  test::expect_same_answer(pair, [](const auto& m) {
    const auto corner = get(CGAL::dynamic_vertex_property_t<std::size_t>(), m.mesh);
    test::Surface_mesh triangles, polygons;
    PMP::remesh_planar_patches(m.mesh, triangles, parameters::vertex_corner_map(corner), points_of(triangles));
    PMP::remesh_planar_patches(m.mesh, polygons, parameters::default_values(),
                               points_of(polygons).do_not_triangulate_faces(true));
    EXPECT_EQ(num_vertices(triangles), 8u);
    EXPECT_EQ(num_faces(triangles), 12u);
    EXPECT_EQ(num_faces(polygons), 6u);
    const std::set<Point> corners(triangles.points().begin(), triangles.points().end());
    return (Answer() << corners).on(m.vertices(), [&](auto v) { return get(corner, v) != std::size_t(-1); });
  });
}

TEST(Conformance_cgal_6, octrees)
{
  expect_same_answers(triangle_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    typedef typename boost::property_map<Mesh, CGAL::vertex_point_t>::const_type Point_map;
    typedef CGAL::Orthtree_traits_face_graph<Mesh, Point_map> Traits;
    typedef CGAL::Orthtree<Traits> Octree;
    Octree octree(Traits(m.mesh, get(CGAL::vertex_point, m.mesh)));
    octree.refine(typename Traits::Split_predicate_node_min_extent(0.3));
    Answer answer;
    for (const auto node : octree.traverse(CGAL::Orthtrees::Leaves_traversal<Octree>(octree)))
      answer << m.names(octree.data(node));
    return answer;
  });
}

TEST(Conformance_cgal_6, scenes)
{
  const auto counts = [](const CGAL::Graphics_scene& scene) {
    Answer answer;
    for (const auto kind : {CGAL::Graphics_scene::POS_MONO_POINTS, CGAL::Graphics_scene::POS_COLORED_POINTS,
                            CGAL::Graphics_scene::POS_MONO_SEGMENTS, CGAL::Graphics_scene::POS_COLORED_SEGMENTS,
                            CGAL::Graphics_scene::POS_MONO_FACES, CGAL::Graphics_scene::POS_COLORED_FACES})
      answer << scene.number_of_elements(kind);
    return answer << scene.bounding_box();
  };
  expect_same_answers(all_pairs(), [&](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    CGAL::Graphics_scene_options<Mesh, typename Mesh::Vertex_index, typename Mesh::Edge_index,
                                 typename Mesh::Face_index> options;
    const auto is_large = [](const Mesh& mesh, auto f) { return PMP::face_area(f, mesh) > 0.05; };
    options.colored_face = is_large;
    options.face_color = [](const Mesh&, auto) { return CGAL::IO::Color(1, 2, 3); };
    CGAL::Graphics_scene scene;
    CGAL::add_to_graphics_scene_for_fg(m.mesh, scene, options);
    return counts(scene);
  });

  // colors are those of property maps
  test::Compact_mesh mesh = test::polygons_pair().compact.mesh;
  CGAL::Graphics_scene plain, colored;
  CGAL::add_to_graphics_scene(mesh, plain);
  mesh.add_property_map<test::Compact_mesh::Face_index, CGAL::IO::Color>("f:color", CGAL::IO::Color(9, 8, 7));
  CGAL::add_to_graphics_scene(mesh, colored);
  EXPECT_EQ(plain.number_of_elements(CGAL::Graphics_scene::POS_COLORED_FACES), 0u);
  EXPECT_GT(plain.number_of_elements(CGAL::Graphics_scene::POS_MONO_FACES), 0u);
  EXPECT_EQ(colored.number_of_elements(CGAL::Graphics_scene::POS_COLORED_FACES),
            plain.number_of_elements(CGAL::Graphics_scene::POS_MONO_FACES));
}

} // namespace
