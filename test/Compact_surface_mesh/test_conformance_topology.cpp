// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Curves on surfaces, on both meshes of each pair.

#include "conformance_answers.h"

#include <CGAL/Curves_on_surface_topology.h>
#include <CGAL/Path_on_surface.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <type_traits>
#include <vector>

namespace {

using test::Answer;
using test::expect_same_answers;
using test::expect_same_answers_in_same_order;
using test::Mesh_of;
namespace Topology = CGAL::Surface_mesh_topology;

/// The length of a path.
template <class Named, class Path>
double length(const Named& m, const Path& path)
{
  double sum = 0;
  for (std::size_t i = 0; i < path.length(); ++i) {
    const auto h = path[i];
    sum += CGAL::approximate_sqrt(CGAL::squared_distance(m.point(source(h, m.mesh)), m.point(target(h, m.mesh))));
  }
  return sum;
}

TEST(Conformance_topology, shortest_cycles)
{
  expect_same_answers({&test::genus_3_pair()}, [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    const Topology::Curves_on_surface_topology<Mesh> curves(m.mesh);
    const Topology::Euclidean_length_weight_functor<Mesh> weight(m.mesh);
    Answer answer;
    answer << curves.compute_edge_width().length(); // ties, but all of the same length
    const auto cycle = curves.compute_shortest_non_contractible_cycle(weight);
    std::multiset<std::size_t> edges;
    for (std::size_t i = 0; i < cycle.length(); ++i)
      edges.insert(m.name(edge(cycle[i], m.mesh)));
    answer << edges << length(m, cycle);
    for (const std::size_t name : {0, 30, 60})
      answer << length(m, curves.compute_shortest_non_contractible_cycle_with_base_point(m.halfedge_of(2 * name),
                                                                                         weight));
    return answer;
  });
}

TEST(Conformance_topology, face_width)
{
  const test::Mesh_pair small("a small surface of genus 3", test::plate_of_genus_3(0));
  expect_same_answers({&small}, [](const auto& m) {
    const Topology::Curves_on_surface_topology<Mesh_of<decltype(m)>> curves(m.mesh);
    return Answer() << curves.compute_face_width().size();
  });
}

TEST(Conformance_topology, homotopy)
{
  expect_same_answers_in_same_order({&test::sphere_pair(), &test::genus_3_pair(), &test::borders_pair()},
                                    [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    typedef Topology::Path_on_surface<Mesh> Path;
    const Topology::Curves_on_surface_topology<Mesh> curves(m.mesh);
    CGAL::Random random(1);
    std::vector<Path> paths;
    Answer answer;
    for (int i = 0; i < 8; ++i) {
      paths.emplace_back(m.mesh);
      paths.back().generate_random_closed_path(20, random);
      answer << paths.back().length() << length(m, paths.back()) << curves.is_contractible(paths.back());
    }
    const auto cycle = curves.compute_shortest_non_contractible_cycle();
    if (!cycle.is_empty()) {
      paths.push_back(cycle);
      paths.push_back(cycle);
      paths.back().update_path_randomly(20, random);
      EXPECT_FALSE(curves.is_contractible(cycle));
      EXPECT_TRUE(curves.are_freely_homotopic(paths[8], paths[9]));
    }
    for (const Path& p : paths)
      for (const Path& q : paths)
        answer << curves.are_freely_homotopic(p, q);
    return answer;
  });
}

} // namespace
