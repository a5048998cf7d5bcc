// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Tetrahedral meshes of what both meshes of each pair bound. Slow.

#include "conformance_answers.h"

#include <CGAL/Compact_surface_mesh/internal/versions_of_cgal.h>

#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/refine_mesh_3.h>

#if CGAL_COMPACT_SURFACE_MESH_WITH_CGAL_6
#include <CGAL/Polygon_mesh_processing/surface_Delaunay_remeshing.h>
#endif

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace {

using test::Answer;
using test::expect_same_answers_in_same_order;
using test::Kernel;
using test::Mesh_of;
using test::Point;
namespace parameters = CGAL::parameters;

/// What a tetrahedral mesh is.
template <class Complex>
Answer& add_complex(Answer& answer, const Complex& complex)
{
  std::vector<Point> points;
  for (const auto v : complex.triangulation().finite_vertex_handles())
    points.push_back(v->point().point());
  std::sort(points.begin(), points.end());
  return answer << complex.number_of_cells() << complex.number_of_facets() << complex.number_of_edges()
                << complex.number_of_corners() << points;
}

TEST(Conformance_tetrahedra, in_a_domain)
{
  expect_same_answers_in_same_order(test::connected_closed_pairs(), [](const auto& m) {
    typedef CGAL::Polyhedral_mesh_domain_3<Mesh_of<decltype(m)>, Kernel> Domain;
    typedef typename CGAL::Mesh_triangulation_3<Domain>::type Triangulation;
    typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation> Complex;
    typedef CGAL::Mesh_criteria_3<Triangulation> Criteria;
    CGAL::Random random(1);
    CGAL::get_default_random() = CGAL::Random(1);
    const Domain domain(m.mesh, &random);
    Complex complex = CGAL::make_mesh_3<Complex>(
      domain, Criteria(parameters::facet_angle = 25, parameters::facet_size = 0.5, parameters::facet_distance = 0.05,
                       parameters::cell_radius_edge_ratio = 3),
      parameters::no_perturb(), parameters::no_exude());
    EXPECT_GT(complex.number_of_cells(), 0u);
    Answer answer;
    add_complex(answer, complex);
    CGAL::refine_mesh_3(complex, domain, Criteria(parameters::cell_radius_edge_ratio = 3, parameters::cell_size = 0.4),
                        parameters::no_perturb(), parameters::no_exude());
    return add_complex(answer, complex);
  });
}

TEST(Conformance_tetrahedra, in_a_domain_with_features)
{
  expect_same_answers_in_same_order({&test::genus_3_pair()}, [](const auto& m) {
    typedef CGAL::Polyhedral_mesh_domain_with_features_3<Kernel, Mesh_of<decltype(m)>> Domain;
    typedef typename CGAL::Mesh_triangulation_3<Domain>::type Triangulation;
    typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, typename Domain::Corner_index,
                                                    typename Domain::Curve_index> Complex;
    typedef CGAL::Mesh_criteria_3<Triangulation> Criteria;
    CGAL::Random random(1);
    CGAL::get_default_random() = CGAL::Random(1);
    Domain domain(m.mesh, &random);
    domain.detect_features(30);
    const Complex complex = CGAL::make_mesh_3<Complex>(
      domain,
      Criteria(parameters::edge_size = 0.3, parameters::facet_angle = 25, parameters::facet_size = 0.4,
               parameters::facet_distance = 0.05, parameters::cell_radius_edge_ratio = 3),
      parameters::no_perturb(), parameters::no_exude());
    EXPECT_GT(complex.number_of_edges(), 0u);
    Answer answer;
    return add_complex(answer, complex);
  });
}

#if CGAL_COMPACT_SURFACE_MESH_WITH_CGAL_6

TEST(Conformance_tetrahedra, remeshed_surfaces)
{
  expect_same_answers_in_same_order({&test::sphere_pair(), &test::borders_pair()}, [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    CGAL::get_default_random() = CGAL::Random(1);
    const auto result = CGAL::Polygon_mesh_processing::surface_Delaunay_remeshing<Mesh, test::Surface_mesh>(
      m.mesh, parameters::mesh_edge_size(0.4).mesh_facet_distance(0.05).features_angle_bound(60.));
    EXPECT_GT(num_faces(result), 0u);
    std::vector<Point> points(result.points().begin(), result.points().end());
    std::sort(points.begin(), points.end());
    return Answer() << num_faces(result) << points;
  });
}

#endif

} // namespace
