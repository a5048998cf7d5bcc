// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Segmentation, deformation, ridges, bounding boxes and collisions, on both meshes of each pair. Slow.

#include "conformance_answers.h"

#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Ridges.h>
#include <CGAL/Rigid_triangle_mesh_collision_detection.h>
#include <CGAL/Surface_mesh_deformation.h>
#include <CGAL/Umbilics.h>
#include <CGAL/mesh_segmentation.h>
#include <CGAL/optimal_bounding_box.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <memory>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using test::Answer;
using test::expect_same_answers;
using test::expect_same_answers_in_same_order;
using test::Kernel;
using test::Mesh_of;
using test::Point;

TEST(Conformance_surfaces, segmentation)
{
  expect_same_answers_in_same_order({&test::sphere_pair(), &test::genus_3_pair()}, [](const auto& m) {
    const auto sdf = get(CGAL::dynamic_face_property_t<double>(), m.mesh);
    const auto segment = get(CGAL::dynamic_face_property_t<std::size_t>(), m.mesh);
    Answer answer;
    const auto add_segments = [&] { answer.on(m.faces(), [&](auto f) { return get(segment, f); }); };
    answer << CGAL::sdf_values(m.mesh, sdf);
    answer.on(m.faces(), [&](auto f) { return get(sdf, f); });
    answer << CGAL::sdf_values_postprocessing(m.mesh, sdf);
    answer << CGAL::segmentation_from_sdf_values(m.mesh, sdf, segment, 4, 0.3);
    add_segments();
    answer << CGAL::segmentation_via_sdf_values(m.mesh, segment);
    add_segments();
    return answer;
  });
}

template <CGAL::Deformation_algorithm_tag algorithm>
void expect_same_deformation()
{
  expect_same_answers({&test::sphere_pair(), &test::disk_pair()}, [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    typedef CGAL::Surface_mesh_deformation<Mesh, CGAL::Default, CGAL::Default, algorithm> Deformation;
    Mesh mesh = m.mesh;
    Deformation deformation(mesh);
    for (const auto v : m.vertices())
      if (m.point(v).x() < 0.7)
        deformation.insert_roi_vertex(v);
    const std::vector<typename Mesh::Vertex_index> controls(m.vertices().begin(), m.vertices().begin() + 3);
    deformation.insert_control_vertices(controls.begin(), controls.end());
    Answer answer;
    answer << deformation.preprocess();
    deformation.translate(controls.begin(), controls.end(), Kernel::Vector_3(0.1, 0.2, 0.3));
    deformation.deform(5, 0.0);
    answer.on(m.vertices(), [&](auto v) { return mesh.point(v); });
    deformation.set_target_position(controls[1], Point(1, 1, 1));
    deformation.deform();
    answer.on(m.vertices(), [&](auto v) { return mesh.point(v); });
    return answer << m.names(deformation.roi_vertices());
  }, test::solving);
}

TEST(Conformance_surfaces, deformation)
{
  expect_same_deformation<CGAL::ORIGINAL_ARAP>();
  expect_same_deformation<CGAL::SPOKES_AND_RIMS>();
  expect_same_deformation<CGAL::SRE_ARAP>();
}

/// The vertices at most `num_rings` edges away from `v`, which comes first.
template <class Mesh>
std::vector<typename Mesh::Vertex_index> rings(typename Mesh::Vertex_index v, const Mesh& mesh, int num_rings)
{
  std::vector<typename Mesh::Vertex_index> found = {v};
  std::set<typename Mesh::Vertex_index> seen = {v};
  for (std::size_t begin = 0, end = 1; num_rings-- > 0; end = found.size())
    for (; begin < end; ++begin)
      for (const auto u : adjacent_vertices(found[begin], mesh))
        if (seen.insert(u).second)
          found.push_back(u);
  return found;
}

TEST(Conformance_surfaces, ridges_and_umbilics)
{
  expect_same_answers_in_same_order(test::connected_closed_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    typedef typename Mesh::Vertex_index Vertex;
    typedef typename Mesh::template Property_map<Vertex, double> Scalars;
    typedef typename Mesh::template Property_map<Vertex, Kernel::Vector_3> Vectors;
    Mesh mesh = m.mesh;
    const auto scalars = [&](const char* name) { return mesh.template add_property_map<Vertex, double>(name).first; };
    const auto vectors = [&](const char* name) {
      return mesh.template add_property_map<Vertex, Kernel::Vector_3>(name).first;
    };
    Scalars k1 = scalars("k1"), k2 = scalars("k2"), b0 = scalars("b0"), b3 = scalars("b3"), p1 = scalars("p1"),
            p2 = scalars("p2");
    Vectors d1 = vectors("d1"), d2 = vectors("d2");
    for (const Vertex v : vertices(mesh)) {
      std::vector<Point> points;
      for (const Vertex u : rings(v, mesh, 3))
        points.push_back(mesh.point(u));
      CGAL::Monge_via_jet_fitting<Kernel> fitting;
      auto monge = fitting(points.begin(), points.end(), 4, 4);
      monge.comply_wrt_given_normal(mesh.point(v) - CGAL::ORIGIN);
      const auto& c = monge.coefficients();
      k1[v] = c[0];
      k2[v] = c[1];
      b0[v] = c[2];
      b3[v] = c[5];
      p1[v] = 3 * c[3] * c[3] + (c[0] - c[1]) * (c[6] - 3 * c[0] * c[0] * c[0]);
      p2[v] = 3 * c[4] * c[4] + (c[1] - c[0]) * (c[10] - 3 * c[1] * c[1] * c[1]);
      d1[v] = monge.maximal_principal_direction();
      d2[v] = monge.minimal_principal_direction();
    }
    Answer answer;
    answer.on(m.vertices(), [&](auto v) { return std::make_pair(k1[v], k2[v]); });

    typedef CGAL::Ridge_line<Mesh> Line;
    CGAL::Ridge_approximation<Mesh, Scalars, Vectors> ridges(mesh, k1, k2, b0, b3, d1, d2, p1, p2);
    std::vector<Line*> lines;
    ridges.compute_max_ridges(std::back_inserter(lines), CGAL::Ridge_order_4);
    ridges.compute_min_ridges(std::back_inserter(lines), CGAL::Ridge_order_3);
    ridges.compute_crest_ridges(std::back_inserter(lines), CGAL::Ridge_order_4);
    CGAL::compute_max_ridges(mesh, k1, k2, b0, b3, d1, d2, p1, p2, std::back_inserter(lines));
    CGAL::compute_min_ridges(mesh, k1, k2, b0, b3, d1, d2, p1, p2, std::back_inserter(lines));
    CGAL::compute_crest_ridges(mesh, k1, k2, b0, b3, d1, d2, p1, p2, std::back_inserter(lines));
    EXPECT_FALSE(lines.empty());
    for (Line* const line : lines) {
      const std::unique_ptr<Line> owner(line);
      answer << line->line_type() << line->strength() << line->sharpness();
      for (const auto& point : *line->line())
        answer << m.name(point.first) << double(point.second);
    }
    typedef CGAL::Umbilic<Mesh> Umbilic;
    std::vector<Umbilic*> umbilics;
    CGAL::compute_umbilics(mesh, k1, k2, d1, d2, std::back_inserter(umbilics), 2.);
    for (Umbilic* const umbilic : umbilics) {
      const std::unique_ptr<Umbilic> owner(umbilic);
      answer << m.name(umbilic->vertex()) << umbilic->umbilic_type() << umbilic->contour_list().size();
    }
    return answer;
  });
}

TEST(Conformance_surfaces, optimal_bounding_box)
{
  expect_same_answers_in_same_order({&test::polygons_pair()}, [](const auto& m) {
    std::array<Point, 8> corners;
    CGAL::oriented_bounding_box(m.mesh, corners, CGAL::parameters::random_seed(1));
    Kernel::Aff_transformation_3 axes;
    CGAL::oriented_bounding_box(m.mesh, axes, CGAL::parameters::random_seed(1));
    test::Surface_mesh box;
    CGAL::oriented_bounding_box(m.mesh, box, CGAL::parameters::random_seed(1));
    Answer answer;
    answer << corners << axes.transform(Point(1, 2, 3)) << num_faces(box);
    for (const auto v : vertices(box))
      answer << box.point(v);
    return answer;
  }, test::rounding);
}

TEST(Conformance_surfaces, collisions)
{
  const test::Mesh_pair other("another sphere", test::placed(test::bumpy_sphere(1), 0.4, Kernel::Vector_3(0.9, 0, 0)));
  const auto translation = [](const Kernel::Vector_3& v) {
    return Kernel::Aff_transformation_3(CGAL::TRANSLATION, v);
  };
  const auto collisions = [&](const auto& m1, const auto& m2) {
    CGAL::Rigid_triangle_mesh_collision_detection<Mesh_of<decltype(m1)>> detection;
    detection.add_mesh(m1.mesh);
    detection.add_mesh(m2.mesh);
    detection.add_mesh(m1.mesh);
    Answer answer;
    for (int i = 0; i < 12; ++i) {
      detection.set_transformation(1, translation(Kernel::Vector_3(0.25 * i - 2, 0.1, 0)));
      detection.set_transformation(2, translation(Kernel::Vector_3(0, 0.3 * i, 0.1)));
      for (std::size_t id = 0; id < 3; ++id)
        answer << detection.get_all_intersections(id) << detection.get_all_intersections_and_inclusions(id);
    }
    return answer;
  };
  for (const auto* const pair : {&test::sphere_pair(), &test::genus_3_pair()}) {
    const Answer expected = collisions(pair->expected, other.expected);
    EXPECT_FALSE(expected.is_empty());
    EXPECT_EQ(collisions(pair->compact, other.compact).difference(expected, 0), "") << pair->name;
  }
}

} // namespace
