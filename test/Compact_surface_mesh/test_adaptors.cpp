// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// CGAL's adaptors of graphs, and what CGAL's packages specialize for Surface_mesh by name: on Compact_surface_mesh,
// with the answers that they give on Surface_mesh.

#include "bumpy_sphere.h"

#include <CGAL/Compact_surface_mesh.h>

#include <CGAL/Face_graph_wrapper.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Triangle_accessor_3.h>
#include <CGAL/boost/graph/Dual.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/Graph_with_descriptor_with_graph.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

namespace {

using test::Kernel;
using test::Point;
using test::Surface_mesh;
using Mesh = CGAL::Compact_surface_mesh<Point>;
namespace parameters = CGAL::parameters;

// A sphere without some faces.
Surface_mesh open_sphere()
{
  Surface_mesh source = test::bumpy_sphere(2);
  for (const unsigned int f : { 3u, 77u, 200u })
    CGAL::Euler::remove_face(source.halfedge(Surface_mesh::Face_index(f)), source);
  source.collect_garbage();
  return source;
}

// The heights of faces, to tell these apart, and to choose some.
template <class M>
double height(const M& m, typename boost::graph_traits<M>::face_descriptor f)
{
  const auto points = get(CGAL::vertex_point, m);
  double sum = 0;
  for (const auto v : CGAL::vertices_around_face(halfedge(f, m), m))
    sum += get(points, v).z();
  return sum;
}

// Sums over stars and faces, sorted: the same for isomorphic graphs with the same points.
template <class Graph>
std::vector<double> sums_of(const Graph& g)
{
  std::vector<double> sums = { double(std::distance(vertices(g).begin(), vertices(g).end())),
                               double(std::distance(faces(g).begin(), faces(g).end())),
                               double(CGAL::is_valid_polygon_mesh(g)) };
  const auto points = get(CGAL::vertex_point, g);
  for (const auto v : vertices(g)) {
    double sum = get(points, v).x();
    for (const auto h : CGAL::halfedges_around_target(v, g))
      sum += get(points, source(h, g)).y() + is_border(h, g);
    sums.push_back(sum);
  }
  for (const auto f : faces(g))
    sums.push_back(height(g, f));
  std::sort(sums.begin(), sums.end());
  return sums;
}

void expect_near(const std::vector<double>& expected, const std::vector<double>& found)
{
  ASSERT_EQ(expected.size(), found.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    ASSERT_NEAR(expected[i], found[i], 1e-9) << i;
}

template <class M>
std::vector<double> sums_of_filtered(const M& m)
{
  std::vector<typename M::Face_index> chosen;
  for (const auto f : m.faces())
    if (height(m, f) > 0.3)
      chosen.push_back(f);
  return sums_of(CGAL::Face_filtered_graph<M>(m, chosen));
}

template <class M>
std::vector<double> sums_of_with_graph(M& m)
{
  return sums_of(CGAL::Graph_with_descriptor_with_graph<M>(m));
}

template <class M>
std::vector<double> sums_of_dual(const M& m)
{
  const CGAL::Dual<M> dual(m);
  std::vector<double> sums = { double(num_vertices(dual)), double(num_edges(dual)) };
  for (const auto f : vertices(dual)) {
    double sum = height(m, f);
    for (const auto e : out_edges(f, dual))
      sum += target(e, dual) == f ? 0 : 10;
    sums.push_back(sum);
  }
  std::sort(sums.begin(), sums.end());
  return sums;
}

template <class M>
std::vector<double> sums_of_seam_mesh(const M& m)
{
  auto is_seam_edge = get(CGAL::dynamic_edge_property_t<bool>(), m);
  auto is_seam_vertex = get(CGAL::dynamic_vertex_property_t<bool>(), m);
  for (const auto e : m.edges())
    put(is_seam_edge, e, false);
  for (const auto v : m.vertices())
    put(is_seam_vertex, v, false);
  using Seam_mesh = CGAL::Seam_mesh<M, decltype(is_seam_edge), decltype(is_seam_vertex)>;
  Seam_mesh seam_mesh(m, is_seam_edge, is_seam_vertex);
  for (const auto e : m.edges()) {
    const double a = m.point(m.vertex(e, 0)).x(), b = m.point(m.vertex(e, 1)).x();
    if (!m.is_border(e) && a > 0.4 && b > 0.4 && a + b < 1.2)
      seam_mesh.add_seam(m.vertex(e, 0), m.vertex(e, 1));
  }
  std::vector<double> sums = { double(num_edges(seam_mesh)), double(num_faces(seam_mesh)) };
  std::size_t num_borders = 0;
  for (const auto h : halfedges(seam_mesh))
    num_borders += is_border(h, seam_mesh);
  sums.push_back(double(num_borders));
  for (const auto f : faces(seam_mesh)) {
    double sum = height(m, f);
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, seam_mesh), seam_mesh))
      sum += 10 * is_border(opposite(h, seam_mesh), seam_mesh);
    sums.push_back(sum);
  }
  std::sort(sums.begin(), sums.end());
  return sums;
}

TEST(Adaptors, of_graphs_answer_as_on_surface_mesh)
{
  Surface_mesh source = open_sphere();
  Mesh mesh(source);
  expect_near(sums_of(source), sums_of(mesh));
  expect_near(sums_of_filtered(source), sums_of_filtered(mesh));
  expect_near(sums_of_with_graph(source), sums_of_with_graph(mesh));
  expect_near(sums_of_dual(source), sums_of_dual(mesh));
  expect_near(sums_of_seam_mesh(source), sums_of_seam_mesh(mesh));
}

TEST(Adaptors, can_be_copied_into_a_compact_mesh)
{
  const Surface_mesh source = open_sphere();
  const Mesh mesh(source);
  std::vector<Mesh::Face_index> chosen;
  for (const auto f : mesh.faces())
    if (height(mesh, f) > 0.3)
      chosen.push_back(f);
  const CGAL::Face_filtered_graph<const Mesh> part(mesh, chosen);
  Mesh copy;
  CGAL::copy_face_graph(part, copy);
  expect_near(sums_of(part), sums_of(copy));
}

// The distances from a vertex by the intrinsic heat method.
template <class M>
std::vector<double> heat_distances(const M& m, const std::vector<typename M::Vertex_index>& order, bool by_class)
{
  auto distances = get(CGAL::dynamic_vertex_property_t<double>(), m);
  if (by_class) {
    CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<M> heat_method(m);
    EXPECT_TRUE(heat_method.add_source(order[0]));
    EXPECT_FALSE(heat_method.add_source(order[0]));
    EXPECT_TRUE(heat_method.add_source(order[5]));
    EXPECT_TRUE(heat_method.remove_source(order[0]));
    EXPECT_FALSE(heat_method.remove_source(order[0]));
    heat_method.add_sources(std::vector<typename M::Vertex_index>{ order[9], order[5] });
    EXPECT_EQ(heat_method.sources().size(), 2u);
    heat_method.estimate_geodesic_distances(distances);
    heat_method.clear_sources();
    EXPECT_TRUE(heat_method.sources().empty());
    heat_method.add_source(order[9]);
    heat_method.add_source(order[5]);
    EXPECT_EQ(num_vertices(heat_method.triangle_mesh()), num_vertices(m));
    heat_method.estimate_geodesic_distances(distances);
  } else
    CGAL::Heat_method_3::estimate_geodesic_distances(m, distances, order[0]);
  std::vector<double> result;
  for (const auto v : order)
    result.push_back(get(distances, v));
  return result;
}

TEST(Heat_method, intrinsic_mode_answers_as_on_surface_mesh)
{
  const Surface_mesh source = test::bumpy_sphere(2);
  std::vector<Mesh::Vertex_index> image(source.number_of_vertices());
  const Mesh mesh(source, parameters::vertex_to_vertex_map(CGAL::make_property_map(image)));
  const std::vector<Surface_mesh::Vertex_index> order(source.vertices().begin(), source.vertices().end());
  for (const bool by_class : { false, true }) {
    const std::vector<double> expected = heat_distances(source, order, by_class);
    const std::vector<double> found = heat_distances(mesh, image, by_class);
    ASSERT_GT(*std::max_element(expected.begin(), expected.end()), 1);
    for (std::size_t i = 0; i < expected.size(); ++i)
      ASSERT_NEAR(expected[i], found[i], 1e-6) << i;
  }
}

TEST(Hooks, of_surface_mesh_topology_and_mesh_3_know_the_mesh)
{
  const Mesh mesh(open_sphere());
  using Index = CGAL::internal::Index_from_halfedge_descriptor<Mesh>;
  using Halfedge = CGAL::internal::Halfedge_descriptor_from_index<Mesh>;
  using Is_used = CGAL::internal::Is_index_used<Mesh>;
  for (const auto h : mesh.halfedges()) {
    ASSERT_EQ(Halfedge::run(mesh, Index::run(mesh, h)), h);
    ASSERT_TRUE(Is_used::run(mesh, h.idx()));
    ASSERT_EQ(CGAL::Get_traits<Mesh>::get_point(mesh, h), mesh.point(mesh.source(h)));
  }
  EXPECT_FALSE(Is_used::run(mesh, mesh.number_of_halfedges()));
  const CGAL::Face_graph_wrapper<Mesh> wrapper(mesh);
  EXPECT_EQ(wrapper.number_of_darts(), mesh.number_of_halfedges());

  using With_graph = CGAL::Graph_with_descriptor_with_graph<Mesh>;
  Mesh copy(mesh);
  With_graph with_graph(copy);
  const CGAL::Triangle_accessor_3<With_graph, Kernel> accessor;
  auto f = copy.faces().begin();
  for (auto it = accessor.triangles_begin(with_graph); it != accessor.triangles_end(with_graph); ++it, ++f) {
    const auto triangle = accessor.triangle(it);
    ASSERT_EQ(triangle[0], copy.point(copy.target(copy.halfedge(*f))));
    ASSERT_EQ(triangle[2], copy.point(copy.source(copy.halfedge(*f))));
  }
  EXPECT_TRUE(f == copy.faces().end());
}

} // namespace
