// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// What CGAL keeps for old programs, and what it does not document, on both meshes of each pair.

#include "conformance_answers.h"

#include "temporary_file.h"

#include <CGAL/Polygon_mesh_processing/angle_and_area_smoothing.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/IO/INP.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/boost/graph/IO/WRL.h>
#include <CGAL/boost/graph/backward_compatibility_functions.h>
#include <CGAL/boost/graph/selection.h>

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#pragma GCC diagnostic ignored "-Wdeprecated-declarations" // it is what is tested

namespace {

using test::all_pairs;
using test::Answer;
using test::expect_same_answers;
using test::expect_same_answers_in_same_order;
using test::Kernel;
using test::Mesh_of;
using test::triangle_pairs;
namespace PMP = CGAL::Polygon_mesh_processing;

TEST(Conformance_old_functions, next_edges)
{
  expect_same_answers(all_pairs(), [](const auto& m) {
    const auto& mesh = m.mesh;
    Answer answer;
    for (const auto e : m.edges()) {
      const auto opposite = CGAL::opposite_edge(e, mesh);
      answer << m.name(opposite) << m.name(halfedge(opposite, mesh)) << m.name(CGAL::next_edge(e, mesh))
             << m.name(CGAL::next_edge_cw(e, mesh)) << m.name(CGAL::next_edge_ccw(opposite, mesh));
    }
    return answer;
  });
}

TEST(Conformance_old_functions, link_condition)
{
  expect_same_answers(triangle_pairs(), [](const auto& m) {
    return Answer().on(m.edges(), [&](auto e) { return CGAL::Euler::satisfies_link_condition(e, m.mesh); });
  });
}

TEST(Conformance_old_functions, writers)
{
  expect_same_answers_in_same_order(all_pairs(), [](const auto& m) {
    std::ostringstream out;
    EXPECT_TRUE(CGAL::write_off(out, m.mesh));
    EXPECT_TRUE(CGAL::write_wrl(out, m.mesh));
    EXPECT_TRUE(CGAL::IO::write_inp(out, m.mesh, "mesh", "S3R"));
    const test::Temporary_file file(".off");
    EXPECT_TRUE(CGAL::write_off(file.name().c_str(), m.mesh));
    return Answer() << out.str() << file.bytes();
  });
}

// They write figures into a file and close it.
TEST(Conformance_old_functions, figures_of_smoothing)
{
  expect_same_answers_in_same_order(triangle_pairs(), [](const auto& m) {
    Mesh_of<decltype(m)> mesh = m.mesh; // not const in the functions
    const test::Temporary_file file(".txt");
    Answer answer;
    const auto add = [&](const auto& evaluate) {
      std::ofstream out(file.name());
      out.precision(17);
      evaluate(out);
      EXPECT_FALSE(out.is_open());
      answer << file.bytes();
    };
    add([&](std::ofstream& out) { PMP::angles_evaluation(mesh, Kernel(), out); });
    add([&](std::ofstream& out) { PMP::areas_evaluation(mesh, Kernel(), out); });
    add([&](std::ofstream& out) { PMP::aspect_ratio_evaluation(mesh, Kernel(), out); });
    return answer;
  });
}

// It asks for the faces on both sides of all edges.
TEST(Conformance_old_functions, selections_with_short_borders)
{
  expect_same_answers_in_same_order({&test::sphere_pair()}, [](const auto& m) {
    Mesh_of<decltype(m)> mesh = m.mesh; // not const in the function
    const auto is_selected = get(CGAL::dynamic_face_property_t<bool>(), mesh);
    for (const auto f : faces(mesh))
      put(is_selected, f, m.name(f) % 7 < 2);
    CGAL::experimental::regularize_face_selection_borders(mesh, is_selected, get(CGAL::vertex_point, mesh));
    Answer answer;
    std::size_t num_changed = 0;
    for (const auto f : m.faces()) {
      answer << bool(get(is_selected, f));
      num_changed += get(is_selected, f) != (m.name(f) % 7 < 2);
    }
    EXPECT_GT(num_changed, 0u);
    return answer;
  });
}

} // namespace
