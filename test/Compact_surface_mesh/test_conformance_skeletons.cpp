// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Skeletons of CGAL's package Surface_mesh_skeletonization, on both meshes of each pair.

#include "conformance_answers.h"

#include <CGAL/Mean_curvature_flow_skeletonization.h>
#include <CGAL/extract_mean_curvature_flow_skeleton.h>

#include <boost/range/iterator_range.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <set>

namespace {

using test::Answer;
using test::connected_closed_pairs;
using test::expect_same_answers;
using test::expect_same_answers_in_same_order;
using test::Mesh_of;

// CGAL collapses edges of its copy of the mesh in the order of their addresses. Whatever this is, the skeleton has the
// same loops, and each vertex contracts to one of its points.
TEST(Conformance_skeletons, by_mean_curvature_flow)
{
  expect_same_answers(connected_closed_pairs(), [](const auto& m) {
    typedef CGAL::Mean_curvature_flow_skeletonization<Mesh_of<decltype(m)>> Skeletonization;
    typename Skeletonization::Skeleton skeleton;
    CGAL::extract_mean_curvature_flow_skeleton(m.mesh, skeleton);
    EXPECT_GT(num_vertices(skeleton), 0u);
    std::multiset<std::size_t> names;
    for (const auto v : boost::make_iterator_range(vertices(skeleton)))
      names.merge(m.names(skeleton[v].vertices));
    EXPECT_EQ(names.size(), m.vertices().size());
    return Answer() << names << num_edges(skeleton) - num_vertices(skeleton);
  });
}

// No edge is collapsed in the first step.
TEST(Conformance_skeletons, first_step_of_mean_curvature_flow)
{
  expect_same_answers_in_same_order(connected_closed_pairs(), [](const auto& m) {
    typedef CGAL::Mean_curvature_flow_skeletonization<Mesh_of<decltype(m)>> Skeletonization;
    Answer answer;
    for (const bool is_medially_centered : {true, false}) {
      Skeletonization flow(m.mesh);
      flow.set_is_medially_centered(is_medially_centered);
      flow.contract_geometry();
      const auto& contracted = flow.meso_skeleton();
      for (const auto v : vertices(contracted))
        answer << get(CGAL::vertex_point, contracted, v);
    }
    return answer;
  });
}

} // namespace
