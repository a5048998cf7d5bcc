// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Nef polyhedra of meshes, and meshes wrapped, on both meshes of each pair. Slow.

#include "conformance_answers.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/alpha_wrap_3.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace {

using test::Answer;
using test::expect_same_answers_in_same_order;
using test::Kernel;
using test::Mesh_of;
using test::Mesh_pair;
using test::Point;

typedef CGAL::Exact_predicates_exact_constructions_kernel Exact_kernel;

template <class Mesh> struct Exact;
template <> struct Exact<test::Surface_mesh> { typedef CGAL::Surface_mesh<Exact_kernel::Point_3> Mesh; };
template <> struct Exact<test::Compact_mesh> { typedef CGAL::Compact_surface_mesh<Exact_kernel::Point_3> Mesh; };

/// A mesh with exact points, moved.
template <class Mesh>
typename Exact<Mesh>::Mesh exact(const Mesh& mesh, const Kernel::Vector_3& translation)
{
  std::vector<Exact_kernel::Point_3> points;
  for (const auto v : vertices(mesh)) {
    const Point p = mesh.point(v) + translation;
    points.emplace_back(p.x(), p.y(), p.z());
  }
  std::vector<std::vector<std::size_t>> polygons;
  for (const auto f : faces(mesh)) {
    polygons.emplace_back();
    for (const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      polygons.back().push_back(v);
  }
  if constexpr (std::is_same<Mesh, test::Compact_mesh>::value)
    return typename Exact<Mesh>::Mesh(points, polygons);
  else {
    typename Exact<Mesh>::Mesh result;
    for (const auto& p : points)
      result.add_vertex(p);
    for (const auto& polygon : polygons) {
      typedef typename Mesh::Vertex_index Vertex;
      result.add_face(std::vector<Vertex>(polygon.begin(), polygon.end()));
    }
    return result;
  }
}

/// What a Nef polyhedron is.
Answer& add_polyhedron(Answer& answer, const CGAL::Nef_polyhedron_3<Exact_kernel>& nef)
{
  test::Surface_mesh boundary;
  CGAL::convert_nef_polyhedron_to_polygon_mesh(nef, boundary, true);
  std::vector<Point> points(boundary.points().begin(), boundary.points().end());
  std::sort(points.begin(), points.end());
  return answer << nef.number_of_vertices() << nef.number_of_edges() << nef.number_of_facets()
                << nef.number_of_volumes() << nef.is_simple() << points;
}

TEST(Conformance_volumes, nef_polyhedra)
{
  const Mesh_pair small("a small sphere", test::displaced(test::bumpy_sphere(0), 0.05));
  test::expect_same_answer(small, [](const auto& m) {
    typedef CGAL::Nef_polyhedron_3<Exact_kernel> Nef;
    const Nef first(exact(m.mesh, Kernel::Vector_3(0, 0, 0))), second(exact(m.mesh, Kernel::Vector_3(0.31, 0.37, 0.5)));
    Answer answer;
    add_polyhedron(answer, first);
    add_polyhedron(answer, first * second);
    return add_polyhedron(answer, first + second);
  });
}

TEST(Conformance_volumes, alpha_wrapping)
{
  expect_same_answers_in_same_order({&test::sphere_pair(), &test::disk_pair()}, [](const auto& m) {
    test::Surface_mesh wrap;
    CGAL::alpha_wrap_3(m.mesh, 0.4, 0.05, wrap);
    Answer answer;
    answer << num_vertices(wrap) << num_faces(wrap);
    return answer.on(vertices(wrap), [&](auto v) { return wrap.point(v); });
  });
}

} // namespace
