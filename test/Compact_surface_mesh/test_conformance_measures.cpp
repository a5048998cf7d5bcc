// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The measures and predicates of Polygon_mesh_processing and BGL, on both meshes of each pair.

#include "conformance_answers.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/extrude.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/Polygon_mesh_processing/transform.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/selection.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using test::all_pairs;
using test::Answer;
using test::expect_same_answer;
using test::expect_same_answers;
using test::Kernel;
using test::Mesh_of;
using test::Mesh_pair;
using test::Point;
using test::Surface_mesh;
using test::triangle_pairs;
namespace parameters = CGAL::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;

/// A property map of elements without a place in the mesh.
template <class Element, class T>
struct Values
{
  boost::associative_property_map<std::map<Element, T>> map() { return {values}; }

  std::map<Element, T> values;
};

TEST(Conformance_measures, elements_correspond)
{
  expect_same_answers(all_pairs(), [](const auto& m) {
    const auto& mesh = m.mesh;
    Answer answer;
    answer << num_vertices(mesh) << num_halfedges(mesh) << num_edges(mesh) << num_faces(mesh);
    answer.on(m.halfedges(), [&](auto h) { return m.name(next(h, mesh)); });
    answer.on(m.halfedges(), [&](auto h) { return m.name(prev(h, mesh)); });
    answer.on(m.halfedges(), [&](auto h) { return m.name(opposite(h, mesh)); });
    answer.on(m.halfedges(), [&](auto h) { return m.name(source(h, mesh)); });
    answer.on(m.halfedges(), [&](auto h) { return m.name(target(h, mesh)); });
    answer.on(m.halfedges(), [&](auto h) { return m.name(face(h, mesh)); });
    answer.on(m.halfedges(), [&](auto h) { return m.name(edge(h, mesh)); });
    answer.on(m.vertices(), [&](auto v) { return get(CGAL::vertex_point, mesh, v); });
    return answer;
  });
}

TEST(Conformance_measures, shapes_of_graphs)
{
  expect_same_answers(all_pairs(), [](const auto& m) {
    const auto& mesh = m.mesh;
    Answer answer;
    answer << CGAL::is_valid_halfedge_graph(mesh) << CGAL::is_valid_face_graph(mesh)
           << CGAL::is_valid_polygon_mesh(mesh) << CGAL::is_closed(mesh) << CGAL::is_triangle_mesh(mesh)
           << CGAL::is_quad_mesh(mesh) << CGAL::is_empty(mesh);
    answer.on(m.vertices(), [&](auto v) { return bool(CGAL::is_border(v, mesh)); });
    answer.on(m.halfedges(), [&](auto h) { return CGAL::is_border(h, mesh); });
    answer.on(m.edges(), [&](auto e) { return CGAL::is_border(e, mesh); });
    answer.on(m.halfedges(), [&](auto h) { return CGAL::is_triangle(h, mesh); });
    answer.on(m.halfedges(), [&](auto h) { return CGAL::is_quad(h, mesh); });
    answer.on(m.halfedges(), [&](auto h) { return CGAL::is_tetrahedron(h, mesh) || CGAL::is_hexahedron(h, mesh); });
    answer.on(m.halfedges(), [&](auto h) { return CGAL::is_bivalent(h, mesh) || CGAL::is_trivalent(h, mesh); });
    return answer;
  });
}

TEST(Conformance_measures, lengths_areas_and_volumes)
{
  expect_same_answers(all_pairs(), [](const auto& m) {
    const auto& mesh = m.mesh;
    Answer answer;
    answer.on(m.halfedges(), [&](auto h) { return PMP::edge_length(h, mesh); });
    answer.on(m.edges(), [&](auto e) { return PMP::edge_length(e, mesh); });
    answer.on(m.edges(), [&](auto e) { return PMP::squared_edge_length(e, mesh); });
    answer.on(m.faces(), [&](auto f) { return PMP::face_border_length(halfedge(f, mesh), mesh); });
    answer << PMP::longest_border(mesh).second;
    return answer;
  });
  expect_same_answers(triangle_pairs(), [](const auto& m) {
    const auto& mesh = m.mesh;
    Answer answer;
    answer.on(m.faces(), [&](auto f) { return PMP::face_area(f, mesh); });
    answer.on(m.faces(), [&](auto f) { return PMP::squared_face_area(f, mesh); });
    answer.on(m.faces(), [&](auto f) { return PMP::face_aspect_ratio(f, mesh); });
    answer << PMP::area(mesh) << PMP::area(faces(mesh), mesh);
    if (CGAL::is_closed(mesh))
      answer << PMP::volume(mesh) << PMP::centroid(mesh);
    return answer;
  });
}

TEST(Conformance_measures, boxes)
{
  expect_same_answers(all_pairs(), [](const auto& m) {
    Answer answer;
    answer << PMP::bbox(m.mesh);
    answer.on(m.vertices(), [&](auto v) { return PMP::vertex_bbox(v, m.mesh); });
    answer.on(m.edges(), [&](auto e) { return PMP::edge_bbox(e, m.mesh); });
    answer.on(m.faces(), [&](auto f) { return PMP::face_bbox(f, m.mesh); });
    return answer;
  });
}

TEST(Conformance_measures, normals)
{
  expect_same_answers(all_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    const Mesh& mesh = m.mesh;
    Answer answer;
    answer.on(m.faces(), [&](auto f) { return PMP::compute_face_normal(f, mesh); });
    answer.on(m.vertices(), [&](auto v) { return PMP::compute_vertex_normal(v, mesh); });
    const auto vertex_normals = get(CGAL::dynamic_vertex_property_t<Kernel::Vector_3>(), mesh);
    const auto face_normals = get(CGAL::dynamic_face_property_t<Kernel::Vector_3>(), mesh);
    PMP::compute_normals(mesh, vertex_normals, face_normals);
    answer.on(m.vertices(), [&](auto v) { return get(vertex_normals, v); });
    answer.on(m.faces(), [&](auto f) { return get(face_normals, f); });
    return answer;
  });
}

TEST(Conformance_measures, connected_components)
{
  expect_same_answers(all_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    typedef typename Mesh::Face_index Face;
    const Mesh& mesh = m.mesh;
    Answer answer;
    Values<Face, std::size_t> component;
    answer << PMP::connected_components(mesh, component.map()) << PMP::internal::number_of_connected_components(mesh);
    answer.partition(m.faces(), [&](auto f) { return component.values.at(f); });

    std::vector<Face> found;
    PMP::connected_component(m.face_of(3), mesh, std::back_inserter(found));
    answer << m.names(found);

    Values<typename Mesh::Edge_index, bool> is_constrained; // all that lie halfway
    for (const auto e : edges(mesh))
      is_constrained.values[e] = (m.point(source(e, mesh)).x() < 0.3) != (m.point(target(e, mesh)).x() < 0.3);
    answer << PMP::connected_components(mesh, component.map(),
                                        parameters::edge_is_constrained_map(is_constrained.map()));
    answer.partition(m.faces(), [&](auto f) { return component.values.at(f); });
    return answer;
  });
}

TEST(Conformance_measures, orientation)
{
  // spheres within each other, the inner one inside out
  Surface_mesh shell = test::placed(test::bumpy_sphere(1), 2, Kernel::Vector_3(0.1, 0.2, 0.3));
  Surface_mesh inside = test::bumpy_sphere(2);
  PMP::reverse_face_orientations(inside);
  CGAL::copy_face_graph(inside, shell);
  const Mesh_pair hollow_ball("a hollow ball", shell), inside_out("a sphere inside out", inside);

  const auto orientations = [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    const Mesh& mesh = m.mesh;
    Answer answer;
    answer << PMP::does_bound_a_volume(mesh);
    Values<typename Mesh::Face_index, std::size_t> volume;
    answer << PMP::volume_connected_components(mesh, volume.map());
    answer.partition(m.faces(), [&](auto f) { return volume.values.at(f); });
    if (PMP::internal::number_of_connected_components(mesh) == 1)
      answer << PMP::is_outward_oriented(mesh);
    return answer;
  };
  expect_same_answer(hollow_ball, orientations);
  expect_same_answer(inside_out, orientations);
  expect_same_answers(test::connected_closed_pairs(), orientations);
  expect_same_answers(all_pairs(), [](const auto& m) {
    Values<typename Mesh_of<decltype(m)>::Face_index, bool> is_compatible;
    Answer answer;
    answer << PMP::compatible_orientations(m.mesh, is_compatible.map());
    answer.on(m.faces(), [&](auto f) { return is_compatible.values.at(f); });
    return answer;
  });
}

TEST(Conformance_measures, borders)
{
  expect_same_answers(all_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    typedef typename Mesh::Halfedge_index Halfedge;
    const Mesh& mesh = m.mesh;
    Answer answer;
    std::vector<Halfedge> border, cycles, patch_border;
    PMP::border_halfedges(mesh, std::back_inserter(border));
    answer << m.names(border) << PMP::number_of_borders(mesh);
    PMP::extract_boundary_cycles(mesh, std::back_inserter(cycles)); // a const mesh deduces `const Mesh`
    std::multiset<std::multiset<std::size_t>> names_of_cycles;
    for (const Halfedge h : cycles)
      names_of_cycles.insert(m.names(CGAL::halfedges_around_face(h, mesh)));
    for (const auto& names : names_of_cycles)
      answer << names;
    const std::vector<typename Mesh::Face_index> patch(m.faces().begin(), m.faces().begin() + 20);
    PMP::border_halfedges(patch, mesh, std::back_inserter(patch_border));
    answer << m.names(patch_border);
    return answer;
  });
}

TEST(Conformance_measures, holes_are_triangulated_as_polylines)
{
  expect_same_answers({&test::borders_pair(), &test::components_pair()}, [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    std::vector<typename Mesh::Halfedge_index> cycles;
    PMP::extract_boundary_cycles(m.mesh, std::back_inserter(cycles));
    std::set<std::set<std::set<std::size_t>>> patches;
    for (const auto first : cycles) {
      // from the halfedge with the least name on, as ties depend on it
      const auto around = CGAL::halfedges_around_face(first, m.mesh);
      const auto h = *std::min_element(around.begin(), around.end(),
                                       [&](auto a, auto b) { return m.name(a) < m.name(b); });
      std::vector<Point> polyline, third_points;
      std::vector<std::size_t> names;
      for (const auto g : CGAL::halfedges_around_face(h, m.mesh)) {
        polyline.push_back(m.point(source(g, m.mesh)));
        names.push_back(m.name(source(g, m.mesh)));
        third_points.push_back(m.point(target(next(opposite(g, m.mesh), m.mesh), m.mesh)));
      }
      std::vector<CGAL::Triple<int, int, int>> triangles;
      PMP::triangulate_hole_polyline(polyline, third_points, std::back_inserter(triangles));
      std::set<std::set<std::size_t>> patch;
      for (const auto& t : triangles)
        patch.insert({names.at(std::size_t(t.first)), names.at(std::size_t(t.second)), names.at(std::size_t(t.third))});
      patches.insert(patch);
    }
    Answer answer;
    for (const auto& patch : patches)
      for (const auto& triangle : patch)
        answer << triangle;
    return answer;
  });
}

TEST(Conformance_measures, shapes_of_faces)
{
  expect_same_answers(triangle_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    const Mesh& mesh = m.mesh;
    Answer answer;
    std::vector<typename Mesh::Edge_index> degenerate_edges;
    std::vector<typename Mesh::Face_index> degenerate_faces;
    PMP::degenerate_edges(mesh, std::back_inserter(degenerate_edges));
    PMP::degenerate_faces(mesh, std::back_inserter(degenerate_faces));
    answer << m.names(degenerate_edges) << m.names(degenerate_faces);
    const auto name_or_none = [&](auto h) { return h == Mesh::null_halfedge() ? m.none : m.name(edge(h, mesh)); };
    answer.on(m.faces(), [&](auto f) { return PMP::is_degenerate_triangle_face(f, mesh); });
    answer.on(m.faces(), [&](auto f) { return name_or_none(PMP::is_needle_triangle_face(f, mesh, 1.2)); });
    answer.on(m.faces(), [&](auto f) { return name_or_none(PMP::is_cap_triangle_face(f, mesh, -0.1)); });
    std::vector<typename Mesh::Halfedge_index> non_manifold;
    PMP::non_manifold_vertices(mesh, std::back_inserter(non_manifold));
    answer << m.names(non_manifold);
    answer.on(m.vertices(), [&](auto v) { return PMP::is_non_manifold_vertex(v, mesh); });
    return answer;
  });
}

TEST(Conformance_measures, features)
{
  expect_same_answers(triangle_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    Mesh mesh = m.mesh; // feature maps are added to it
    const auto is_feature = get(CGAL::edge_is_feature, mesh);
    const auto patch = get(CGAL::face_patch_id_t<int>(), mesh);
    const auto degree = get(CGAL::vertex_feature_degree, mesh);
    Answer answer;
    PMP::detect_sharp_edges(mesh, 30., is_feature, parameters::vertex_feature_degree_map(degree));
    answer.on(m.edges(), [&](auto e) { return bool(get(is_feature, e)); });
    answer.on(m.vertices(), [&](auto v) { return get(degree, v); });
    answer << PMP::sharp_edges_segmentation(mesh, 45., is_feature, patch);
    answer.on(m.edges(), [&](auto e) { return bool(get(is_feature, e)); });
    answer.partition(m.faces(), [&](auto f) { return get(patch, f); });
    return answer;
  });
}

// CGAL looks at those vertices v only for which the edge of halfedge(v) is a feature.
TEST(Conformance_measures, patches_at_vertices)
{
  test::expect_same_answers_in_same_order(triangle_pairs(), [](const auto& m) {
    Mesh_of<decltype(m)> mesh = m.mesh;
    const auto is_feature = get(CGAL::edge_is_feature, mesh);
    const auto patch = get(CGAL::face_patch_id_t<int>(), mesh);
    const auto incident = get(CGAL::vertex_incident_patches_t<int>(), mesh);
    PMP::sharp_edges_segmentation(mesh, 45., is_feature, patch, parameters::vertex_incident_patches_map(incident));
    Answer answer;
    answer.on(m.vertices(), [&](auto v) { return get(incident, v); });
    PMP::detect_vertex_incident_patches(mesh, patch, incident, is_feature);
    answer.on(m.vertices(), [&](auto v) { return get(incident, v); });
    return answer;
  });
}

TEST(Conformance_measures, selections)
{
  expect_same_answers(triangle_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    typedef typename Mesh::Vertex_index Vertex;
    typedef typename Mesh::Edge_index Edge;
    typedef typename Mesh::Face_index Face;
    const Mesh& mesh = m.mesh;
    Values<Vertex, bool> vertex_is_selected;
    Values<Edge, bool> edge_is_selected;
    Values<Face, bool> face_is_selected;
    for (const auto f : faces(mesh))
      face_is_selected.values[f] = m.name(f) < 5;
    for (const auto e : edges(mesh))
      edge_is_selected.values[e] = m.name(e) < 5;
    for (const auto v : vertices(mesh))
      vertex_is_selected.values[v] = m.name(v) < 5;
    std::vector<Face> selected(m.faces().begin(), m.faces().begin() + 5), grown;
    std::vector<Edge> edges_selected(m.edges().begin(), m.edges().begin() + 5), edges_grown;
    std::vector<Vertex> vertices_selected(m.vertices().begin(), m.vertices().begin() + 5), vertices_grown;
    CGAL::expand_face_selection(selected, mesh, 2, face_is_selected.map(), std::back_inserter(grown));
    CGAL::expand_edge_selection(edges_selected, mesh, 1, edge_is_selected.map(), std::back_inserter(edges_grown));
    CGAL::expand_vertex_selection(vertices_selected, mesh, 1, vertex_is_selected.map(),
                                  std::back_inserter(vertices_grown));
    Answer answer;
    answer << m.names(grown) << m.names(edges_grown) << m.names(vertices_grown);
    grown.insert(grown.end(), selected.begin(), selected.end());
    answer << CGAL::euler_characteristic_of_selection(grown, mesh)
           << CGAL::is_selection_a_topological_disk(grown, mesh);
    std::vector<Face> lost, incident;
    const std::vector<typename Mesh::Halfedge_index> halfedges_selected(m.halfedges().begin(),
                                                                        m.halfedges().begin() + 5);
    CGAL::reduce_face_selection(grown, mesh, 1, face_is_selected.map(), std::back_inserter(lost));
    CGAL::select_incident_faces(halfedges_selected, mesh, std::back_inserter(incident));
    answer << m.names(lost) << m.names(std::set<Face>(incident.begin(), incident.end()));
    CGAL::expand_face_selection_for_removal(selected, mesh, face_is_selected.map());
    answer.on(m.faces(), [&](auto f) { return face_is_selected.values.at(f); });
    return answer;
  });
}

TEST(Conformance_measures, points_are_transformed)
{
  expect_same_answers(all_pairs(), [](const auto& m) {
    Mesh_of<decltype(m)> mesh = m.mesh;
    PMP::transform(Kernel::Aff_transformation_3(0, 2, 0, 1, -1, 0, 0, 3, 0, 0, 1, 5), mesh);
    return Answer().on(m.vertices(), [&](auto v) { return mesh.point(v); });
  });
}

// The mesh is only read, and what is written is a Surface_mesh.
TEST(Conformance_measures, other_meshes_are_made_of_them)
{
  expect_same_answers({&test::disk_pair(), &test::borders_pair()}, [](const auto& m) {
    Surface_mesh thick; // by functions, as with a vector both meshes have to be of the same type
    PMP::extrude_mesh(m.mesh, thick, [](auto, auto) {}, [&](auto from, Surface_mesh::Vertex_index to) {
      thick.point(to) = m.point(from) + Kernel::Vector_3(0.1, 0.2, 1);
    });
    return Answer() << num_vertices(thick) << num_faces(thick) << PMP::area(thick);
  });
  expect_same_answers(all_pairs(), [](const auto& m) {
    Surface_mesh copy;
    CGAL::copy_face_graph(m.mesh, copy);
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> polygons;
    PMP::polygon_mesh_to_polygon_soup(m.mesh, points, polygons);
    const std::multiset<Point> sorted(points.begin(), points.end());
    return Answer() << num_vertices(copy) << num_halfedges(copy) << num_faces(copy) << PMP::bbox(copy) << sorted
                    << polygons.size();
  });
}

TEST(Conformance_measures, faces_are_matched)
{
  for (const Mesh_pair* const pair : all_pairs()) {
    const auto& first = pair->expected;
    const auto& second = pair->compact;
    std::vector<std::pair<Surface_mesh::Face_index, test::Compact_mesh::Face_index>> common;
    std::vector<Surface_mesh::Face_index> only_first;
    std::vector<test::Compact_mesh::Face_index> only_second;
    PMP::match_faces(first.mesh, second.mesh, std::back_inserter(common), std::back_inserter(only_first),
                     std::back_inserter(only_second));
    EXPECT_EQ(common.size(), num_faces(first.mesh)) << pair->name;
    EXPECT_TRUE(only_first.empty() && only_second.empty()) << pair->name;
    for (const auto& faces : common)
      EXPECT_EQ(first.name(faces.first), second.name(faces.second)) << pair->name;
  }
}

} // namespace
