// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The layouts of the literature as connectivity of a mesh: concepts and algorithms of CGAL and Boost
// against Surface_mesh, and a real mesh with many handles.

#include "bumpy_sphere.h"
#include "damaged_soups.h"
#include "layout_of_soup.h"
#include "real_mesh.h"
#include "../../examples/Compact_surface_mesh/names_of_cgal_6.h"

#include <CGAL/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/layouts/Laced_ring_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/SOT_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/SQuad_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/Schnyder_fronts_layout.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/graph_concepts.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/graph_concepts.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

namespace {

using test::Kernel;
using test::Point;
using test::Surface_mesh;
namespace PMP = CGAL::Polygon_mesh_processing;

template <class Layout>
struct Papers_layout
  : public ::testing::Test
{};

using Papers_layouts = ::testing::Types<
  CGAL::SOT_layout<>,
  CGAL::SQuad_layout<>,
  CGAL::Schnyder_fronts_layout<6>,
  CGAL::Schnyder_fronts_layout<5>,
  CGAL::Schnyder_fronts_layout<4>,
  CGAL::Schnyder_fronts_layout<5, true>,
  CGAL::Laced_ring_layout<>,
  CGAL::Laced_ring_layout<std::uint32_t, std::uint16_t>
>;
TYPED_TEST_SUITE(Papers_layout, Papers_layouts);

// The numbers of vertices at each distance from the vertex at `point`.
template <class Mesh>
std::map<int, int> distances(const Mesh& mesh, const Point& point)
{
  using V = typename boost::graph_traits<Mesh>::vertex_descriptor;
  V start;
  for (const V v : vertices(mesh))
    if (get(CGAL::vertex_point, mesh, v) == point)
      start = v;
  std::vector<int> distance(num_vertices(mesh), 0);
  const auto index = get(boost::vertex_index, mesh);
  boost::breadth_first_search(
    mesh, start, boost::visitor(boost::make_bfs_visitor(boost::record_distances(
                   boost::make_iterator_property_map(distance.begin(), index), boost::on_tree_edge()))));
  std::map<int, int> count;
  for (const int d : distance)
    ++count[d];
  return count;
}

template <class Mesh>
double distance_of_query(const Mesh& mesh, const Point& point)
{
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
  CGAL::AABB_tree<example::AABB_traits_3<Kernel, Primitive>> tree(faces(mesh).first, faces(mesh).second, mesh);
  return std::sqrt(tree.squared_distance(point));
}

TYPED_TEST(Papers_layout, serves_a_mesh_in_algorithms)
{
  using Mesh = CGAL::Compact_surface_mesh<Point, TypeParam>;
  BOOST_CONCEPT_ASSERT((CGAL::HalfedgeListGraphConcept<Mesh>));
  BOOST_CONCEPT_ASSERT((CGAL::FaceListGraphConcept<Mesh>));
  BOOST_CONCEPT_ASSERT((boost::concepts::BidirectionalGraph<Mesh>));
  BOOST_CONCEPT_ASSERT((boost::concepts::VertexAndEdgeListGraph<Mesh>));

  const Surface_mesh expected = test::bumpy_sphere();
  std::map<Surface_mesh::Vertex_index, typename Mesh::Vertex_index> image;
  const Mesh mesh(expected, CGAL::parameters::vertex_to_vertex_map(boost::make_assoc_property_map(image)));
  EXPECT_TRUE(mesh.is_valid());
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_TRUE(CGAL::is_triangle_mesh(mesh));
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_NEAR(PMP::area(mesh), PMP::area(expected), 1e-9 * PMP::area(expected));
  EXPECT_NEAR(PMP::volume(mesh), PMP::volume(expected), 1e-9 * PMP::volume(expected));
  for (const auto v : expected.vertices()) {
    EXPECT_EQ(degree(image.at(v), mesh), degree(v, expected));
    const Kernel::Vector_3 normal = PMP::compute_vertex_normal(image.at(v), mesh);
    EXPECT_LT((normal - PMP::compute_vertex_normal(v, expected)).squared_length(), 1e-12);
  }
  const Point start = expected.point(*expected.vertices().begin());
  EXPECT_EQ(distances(mesh, start), distances(expected, start));
  const Point query(0.3, 2.5, -1);
  EXPECT_NEAR(distance_of_query(mesh, query), distance_of_query(expected, query), 1e-9);
}

TYPED_TEST(Papers_layout, is_right_on_a_real_mesh_of_genus_133)
{
  const test::Soup cheese = test::real_mesh("cheese.off");
  if (cheese.num_vertices == 0)
    GTEST_SKIP() << "CGAL's meshes are not there: run scripts/fetch_meshes";
  EXPECT_EQ(2 - 2 * 133, static_cast<int>(cheese.num_vertices) - static_cast<int>(cheese.triangles.size() / 2));
  EXPECT_EQ(test::difference_from_soup<TypeParam>(test::soup_of(cheese)), "");
}

} // namespace
