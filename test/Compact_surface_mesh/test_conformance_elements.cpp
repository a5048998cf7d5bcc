// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// What CGAL asks about single vertices, edges and faces, and about places on them; and the writers
// that look at them one by one, on both meshes of each pair.

#include "conformance_answers.h"
#include "../../examples/Compact_surface_mesh/names_of_cgal_6.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup_extension.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/Random.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/IO/INP.h>
#include <CGAL/boost/graph/IO/WRL.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/selection.h>
#include <CGAL/point_generators_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using test::all_pairs;
using test::Answer;
using test::expect_same_answers;
using test::expect_same_answers_in_same_order;
using test::Kernel;
using test::Mesh_of;
using test::Mesh_pair;
using test::Point;
using test::Surface_mesh;
using test::triangle_pairs;
namespace PMP = CGAL::Polygon_mesh_processing;

TEST(Conformance_elements, neighbors)
{
  expect_same_answers(all_pairs(), [](const auto& m) {
    const auto& mesh = m.mesh;
    Answer answer;
    answer.on(m.halfedges(), [&](auto h) { return m.names(CGAL::halfedges_around_source(h, mesh)); });
    answer.on(m.halfedges(), [&](auto h) { return m.names(CGAL::halfedges_around_target(h, mesh)); });
    answer.on(m.halfedges(), [&](auto h) { return m.names(CGAL::halfedges_around_face(h, mesh)); });
    answer.on(m.halfedges(), [&](auto h) { return m.names(CGAL::edges_around_face(h, mesh)); });
    answer.on(m.halfedges(), [&](auto h) { return m.names(CGAL::opposite_edges_around_face(h, mesh)); });
    answer.on(m.halfedges(), [&](auto h) { return m.names(CGAL::vertices_around_face(h, mesh)); });
    answer.on(m.halfedges(), [&](auto h) { return m.names(CGAL::vertices_around_target(h, mesh)); });
    answer.on(m.halfedges(), [&](auto h) { return m.names(CGAL::faces_around_face(h, mesh)); });
    answer.on(m.halfedges(), [&](auto h) { return m.names(CGAL::faces_around_target(h, mesh)); });
    answer.on(m.halfedges(), [&](auto h) { return CGAL::is_border_edge(h, mesh); });
    return answer;
  });
  expect_same_answers_in_same_order(all_pairs(), [](const auto& m) { // from halfedge(f) on
    const auto& mesh = m.mesh;
    Answer answer;
    for (const auto h : m.halfedges())
      if (!CGAL::is_border(h, mesh))
        answer << CGAL::halfedge_index_in_face(h, mesh)
               << CGAL::vertex_index_in_face(target(h, mesh), face(h, mesh), mesh);
    return answer;
  });
}

/// A mesh of one kind of faces, made by a generator.
template <class Make>
Mesh_pair made(const std::string& name, const Make& make)
{
  Surface_mesh mesh;
  make(mesh);
  return Mesh_pair(name, mesh);
}

TEST(Conformance_elements, validity_and_shape)
{
  const Point p(0, 0, 0), q(1, 0, 0), r(1, 1, 0), s(0, 1, 0.5);
  const Mesh_pair triangle = made("a triangle", [&](Surface_mesh& mesh) { CGAL::make_triangle(p, q, r, mesh); });
  const Mesh_pair quad = made("a quadrilateral", [&](Surface_mesh& mesh) { CGAL::make_quad(p, q, r, s, mesh); });
  auto pairs = all_pairs();
  pairs.insert(pairs.end(), {&triangle, &quad});
  expect_same_answers(pairs, [](const auto& m) {
    const auto& mesh = m.mesh;
    Answer answer;
    answer << CGAL::is_bivalent_mesh(mesh);
    answer.on(m.halfedges(), [&](auto h) { return CGAL::is_isolated_triangle(h, mesh); });
    answer.on(m.halfedges(), [&](auto h) { return CGAL::is_isolated_quad(h, mesh); });
    answer.on(m.halfedges(), [&](auto h) { return CGAL::is_valid_halfedge_descriptor(h, mesh); });
    answer.on(m.vertices(), [&](auto v) { return CGAL::is_valid_vertex_descriptor(v, mesh); });
    answer.on(m.faces(), [&](auto f) { return CGAL::is_valid_face_descriptor(f, mesh); });
    answer.on(m.edges(), [&](auto e) { return PMP::is_degenerate_edge(e, mesh); });
    return answer;
  });
  EXPECT_TRUE(CGAL::is_isolated_triangle(halfedge(triangle.compact.face_of(0), triangle.compact.mesh),
                                         triangle.compact.mesh));
}

// Euler operations that only look.
TEST(Conformance_elements, possible_edits)
{
  expect_same_answers(triangle_pairs(), [](const auto& m) {
    const auto& mesh = m.mesh;
    return Answer().on(m.edges(), [&](auto e) { return CGAL::Euler::does_satisfy_link_condition(e, mesh); });
  });
  expect_same_answers_in_same_order({&test::sphere_pair(), &test::genus_3_pair(), &test::disk_pair()},
                                    [](const auto& m) {
    typedef typename Mesh_of<decltype(m)>::Vertex_index Vertex;
    const auto& mesh = m.mesh;
    Answer answer;
    for (const auto h : m.halfedges()) { // across a corner of the border, or on a face that is there
      const std::vector<Vertex> corners = {source(h, mesh), target(h, mesh), target(next(h, mesh), mesh)};
      answer << CGAL::Euler::can_add_face(corners, mesh);
    }
    return answer;
  });
}

TEST(Conformance_elements, property_maps_of_helpers)
{
  expect_same_answers(all_pairs(), [](const auto& m) {
    Mesh_of<decltype(m)> mesh = m.mesh;
    const auto read = CGAL::get_const_property_map(CGAL::vertex_point, m.mesh);
    const auto written = CGAL::get_property_map(CGAL::vertex_point, mesh);
    put(written, m.vertex(0), Point(1, 2, 3));
    Answer answer;
    answer.on(m.vertices(), [&](auto v) { return get(read, v); });
    answer.on(m.vertices(), [&](auto v) { return mesh.point(v); });
    const auto face_normals = get(CGAL::dynamic_face_property_t<Kernel::Vector_3>(), mesh);
    const auto vertex_normals = get(CGAL::dynamic_vertex_property_t<Kernel::Vector_3>(), mesh);
    PMP::compute_face_normals(m.mesh, face_normals);
    PMP::compute_vertex_normals(m.mesh, vertex_normals);
    answer.on(m.faces(), [&](auto f) { return get(face_normals, f); });
    answer.on(m.vertices(), [&](auto v) { return get(vertex_normals, v); });
    return answer;
  });
}

TEST(Conformance_elements, smaller_selections)
{
  expect_same_answers(triangle_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    typedef typename Mesh::Vertex_index Vertex;
    typedef typename Mesh::Edge_index Edge;
    const Mesh& mesh = m.mesh;
    const auto vertex_is_selected = get(CGAL::dynamic_vertex_property_t<bool>(), mesh);
    const auto edge_is_selected = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
    for (const auto v : vertices(mesh))
      put(vertex_is_selected, v, m.name(v) < 60);
    for (const auto e : edges(mesh))
      put(edge_is_selected, e, m.name(e) < 100);
    const std::vector<Vertex> vertices_selected(m.vertices().begin(), m.vertices().begin() + 60);
    const std::vector<Edge> edges_selected(m.edges().begin(), m.edges().begin() + 100);
    std::vector<Vertex> vertices_lost;
    std::vector<Edge> edges_lost;
    CGAL::reduce_vertex_selection(vertices_selected, mesh, 1, vertex_is_selected, std::back_inserter(vertices_lost));
    CGAL::reduce_edge_selection(edges_selected, mesh, 1, edge_is_selected, std::back_inserter(edges_lost));
    return Answer() << m.names(vertices_lost) << m.names(edges_lost);
  });
  expect_same_answers_in_same_order(triangle_pairs(), [](const auto& m) {
    Mesh_of<decltype(m)> mesh = m.mesh; // not const in the function
    const auto is_selected = get(CGAL::dynamic_face_property_t<bool>(), mesh);
    for (const auto f : faces(mesh))
      put(is_selected, f, m.name(f) % 7 < 4);
    CGAL::regularize_face_selection_borders(mesh, is_selected, 0.5);
    return Answer().on(m.faces(), [&](auto f) { return bool(get(is_selected, f)); });
  });
}

TEST(Conformance_elements, places)
{
  expect_same_answers_in_same_order(triangle_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    const Mesh& mesh = m.mesh;
    Answer answer;
    const auto add = [&](const auto& location) {
      answer << m.name(location.first) << location.second[0] << location.second[1] << location.second[2]
             << PMP::is_on_face_border(location, mesh) << PMP::is_on_mesh_border(location, mesh);
    };
    CGAL::Random random(1);
    for (std::size_t i = 0; i < 20; ++i) {
      const auto h = halfedge(m.face_of(5 * i), mesh);
      add(PMP::random_location_on_mesh<double>(mesh, random));
      add(PMP::random_location_on_face<double>(m.face_of(5 * i), mesh, random));
      add(PMP::random_location_on_halfedge<double>(h, mesh, random));

      auto on_edge = PMP::locate_on_halfedge(h, 0.25, mesh);
      auto at_vertex = PMP::locate_vertex<double>(target(next(h, mesh), mesh), mesh);
      answer << PMP::is_on_halfedge(on_edge, h, mesh) << PMP::is_on_halfedge(on_edge, next(h, mesh), mesh)
             << PMP::is_on_vertex(at_vertex, target(next(h, mesh), mesh), mesh)
             << PMP::is_on_vertex(at_vertex, target(h, mesh), mesh)
             << PMP::locate_in_common_face(on_edge, at_vertex, mesh);
      add(on_edge);
      add(at_vertex);
    }

    typedef typename boost::property_map<Mesh, CGAL::vertex_point_t>::const_type Vertex_point_map;
    typedef CGAL::AABB_face_graph_triangle_primitive<Mesh, Vertex_point_map> Primitive;
    CGAL::AABB_tree<example::AABB_traits_3<Kernel, Primitive>> tree;
    PMP::build_AABB_tree(mesh, tree);
    for (int i = 0; i < 20; ++i)
      add(PMP::locate_with_AABB_tree(Point(0.1 * i, 1 - 0.1 * i, 0.05 * i), tree, mesh));
    return answer;
  });
}

TEST(Conformance_elements, random_points)
{
  expect_same_answers_in_same_order(triangle_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    const Mesh& mesh = m.mesh;
    std::vector<Point> points;
    CGAL::get_default_random() = CGAL::Random(1); // points in an element are drawn by it, whatever is passed
    CGAL::Random_points_in_triangle_mesh_3<Mesh> in_faces(mesh);
    std::copy_n(in_faces, 20, std::back_inserter(points));
    CGAL::Random_points_on_edge_list_graph_3<Mesh> on_edges(mesh);
    std::copy_n(on_edges, 20, std::back_inserter(points));
    PMP::sample_triangles<Kernel>(faces(mesh), mesh, get(CGAL::vertex_point, mesh), 0.2, std::back_inserter(points),
                                  true, true, true);
    return Answer() << points;
  });
}

TEST(Conformance_elements, distances_of_all_faces)
{
  constexpr double bound = 0.05;
  const Surface_mesh other = test::placed(test::bumpy_sphere(1), 0.8, Kernel::Vector_3(0.1, 0.2, 0));
  expect_same_answers({&test::sphere_pair()}, [&](const auto& m) {
    return Answer() << PMP::bounded_error_Hausdorff_distance_naive<CGAL::Sequential_tag>(m.mesh, other, bound);
  }, 2 * bound);
}

// The mesh is only read, and says which triangles of a soup to reverse.
TEST(Conformance_elements, soups_are_oriented)
{
  expect_same_answers_in_same_order(test::connected_closed_pairs(), [](const auto& m) {
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> triangles;
    PMP::polygon_mesh_to_polygon_soup(m.mesh, points, triangles);
    for (std::size_t i = 0; i < triangles.size(); i += 3)
      std::reverse(triangles[i].begin(), triangles[i].end());
    PMP::orient_triangle_soup_with_reference_triangle_mesh(m.mesh, points, triangles);
    Answer answer;
    answer << points;
    for (const auto& triangle : triangles)
      answer << triangle;
    return answer;
  });
}

TEST(Conformance_elements, parts_are_copied)
{
  expect_same_answers({&test::components_pair()}, [](const auto& m) {
    std::vector<Mesh_of<decltype(m)>> parts;
    PMP::split_connected_components(m.mesh, parts);
    std::multiset<std::pair<std::size_t, std::size_t>> sizes;
    for (const auto& part : parts)
      sizes.insert({num_vertices(part), num_faces(part)});
    return Answer() << sizes;
  });
}

TEST(Conformance_elements, are_written)
{
  expect_same_answers_in_same_order(all_pairs(), [](const auto& m) {
    std::ostringstream out;
    EXPECT_TRUE(CGAL::IO::write_INP(out, "mesh", "S3R", m.mesh));
    EXPECT_TRUE(CGAL::IO::write_WRL(out, m.mesh));
    return Answer() << out.str();
  });
}

} // namespace
