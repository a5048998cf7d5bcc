// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// What CGAL's package Classification says about faces, on both meshes of each pair.

#include "conformance_answers.h"

#include <CGAL/Classification/Feature_set.h>
#include <CGAL/Classification/Local_eigen_analysis.h>
#include <CGAL/Classification/Mesh_feature_generator.h>
#include <CGAL/Classification/Mesh_neighborhood.h>
#include <CGAL/Classification/property_maps.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <iterator>
#include <set>
#include <vector>

namespace {

using test::Answer;
using test::expect_same_answers;
using test::expect_same_answers_in_same_order;
using test::Kernel;
using test::Mesh_of;
using test::triangle_pairs;
namespace Classification = CGAL::Classification;

TEST(Conformance_classification, neighborhoods)
{
  expect_same_answers(triangle_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    typedef typename Mesh::Face_index Face;
    const Classification::Mesh_neighborhood<Mesh> neighborhood(m.mesh);
    Answer answer;
    const auto add_neighbors = [&](const auto& query) {
      for (const Face f : m.faces()) {
        std::vector<typename Mesh::size_type> indices;
        query(f, std::back_inserter(indices));
        std::multiset<std::size_t> names;
        for (const auto i : indices)
          names.insert(m.name(Face(i)));
        answer << names;
      }
    };
    add_neighbors(neighborhood.one_ring_neighbor_query());
    add_neighbors(neighborhood.n_ring_neighbor_query(3));
    return answer;
  });
}

// Numbers are stored in few bits, and the order of sums could decide about the last one.
TEST(Conformance_classification, eigenvalues_of_neighborhoods)
{
  expect_same_answers_in_same_order(triangle_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    const Classification::Mesh_neighborhood<Mesh> neighborhood(m.mesh);
    const auto eigen = Classification::Local_eigen_analysis::create_from_face_graph(
      m.mesh, neighborhood.n_ring_neighbor_query(2), CGAL::Sequential_tag());
    Answer answer;
    answer << eigen.mean_range();
    for (std::size_t i = 0; i < num_faces(m.mesh); ++i)
      answer << eigen.eigenvalue(i) << eigen.template normal_vector<Kernel>(i);
    return answer;
  });
}

TEST(Conformance_classification, features)
{
  expect_same_answers_in_same_order(triangle_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    typedef typename boost::property_map<Mesh, CGAL::vertex_point_t>::const_type Vertex_point_map;
    typedef Classification::Face_descriptor_to_center_of_mass_map<Mesh, Vertex_point_map> Center_map;
    Classification::Mesh_feature_generator<Kernel, Mesh, Center_map, CGAL::Sequential_tag> generator(
      m.mesh, Center_map(&m.mesh, get(CGAL::vertex_point, m.mesh)), 2);
    Classification::Feature_set features;
    generator.generate_point_based_features(features);
    generator.generate_face_based_features(features);
    Answer answer;
    answer << features.size();
    for (std::size_t i = 0; i < features.size(); ++i) {
      answer << features[i]->name();
      for (std::size_t f = 0; f < num_faces(m.mesh); ++f)
        answer << features[i]->value(f);
    }
    return answer;
  });
}

} // namespace
