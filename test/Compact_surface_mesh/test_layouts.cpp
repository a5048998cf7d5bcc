// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The layouts of this package against the corner table.

#include "layout_suite.h"
#include "scattered_layout.h"

#include <CGAL/Compact_surface_mesh/layouts/Corner_table_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/Input_order_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/Schnyder_parents_layout.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <utility>

namespace test {

typedef testing::Types<CGAL::Corner_table_layout<>,
                       CGAL::Schnyder_parents_layout<4>,
                       CGAL::Schnyder_parents_layout<5>,
                       CGAL::Schnyder_parents_layout<6>,
                       CGAL::Corner_table_layout<std::uint64_t>,
                       Scattered_layout<>,
                       CGAL::Schnyder_parents_layout<4, std::uint64_t>,
                       CGAL::Input_order_layout<>,
                       CGAL::Input_order_layout<CGAL::Corner_table_layout<>, CGAL::Input_order::VERTICES_AND_FACES>>
    Layouts_of_this_package;
INSTANTIATE_TYPED_TEST_SUITE_P(This_package, Layouts, Layouts_of_this_package);

} // namespace test

namespace {

TEST(Layout_oracle, sees_a_wrong_vertex_map)
{
  typedef CGAL::Schnyder_parents_layout<> Layout;
  const test::Soup sphere = test::octasphere(2);
  const CGAL::Corner_table<> table(sphere.num_vertices, sphere.triangles);
  CGAL::Input_images<> images;
  const Layout layout(CGAL::Closed_triangulation<>(CGAL::Corner_table<>(table)), images);
  std::swap(images.vertices[0], images.vertices[40]);
  EXPECT_NE((test::Layout_oracle<Layout, std::uint32_t>(layout, table, images.vertices).difference()), "");
}

TEST(Schnyder_parents_layout, keeps_red_siblings_consecutive_and_the_root_face_last)
{
  const test::Soup sphere = test::octasphere(3);
  CGAL::Input_images<> images;
  const CGAL::Schnyder_parents_layout<> layout(
      CGAL::Closed_triangulation<>(CGAL::Corner_table<>(sphere.num_vertices, sphere.triangles)), images);
  const std::uint32_t n = sphere.num_vertices;
  // the first face of the input is where the wood is rooted
  for (const std::uint32_t v : sphere.triangles[0])
    EXPECT_GE(images.vertices[v], n - 3);
  // halfedge 6u leads from u to its red parent: parents change from family to family only
  std::set<std::uint32_t> parents;
  for (std::uint32_t u = 0; u + 3 < n; ++u)
    if (u == 0 || layout.target(6 * u) != layout.target(6 * (u - 1))) {
      EXPECT_TRUE(parents.insert(layout.target(6 * u)).second);
    }
}

// What a layout of a triangulation that was renumbered answers wrongly, or nothing.
template <class Layout>
std::string difference_when_renumbered(const test::Polygon_soup& soup, bool wants_halfedges)
{
  typedef typename Layout::Index Index;
  CGAL::Closed_triangulation<Index> closed(CGAL::Simple_triangulation<Index>(soup.num_vertices, soup.faces));
  CGAL::Input_images<Index> images;
  images.wants_halfedges = wants_halfedges;
  closed.renumber(wants_halfedges);
  const Layout layout(std::move(closed), images);
  return test::Surface_oracle<Layout>(layout, soup, images.vertices, images.halfedges).difference();
}

TEST(Schnyder_parents_layout, of_a_renumbered_triangulation_is_that_of_the_input)
{
  test::Surface_options triangles;
  triangles.has_polygons = false;
  for (unsigned int seed = 0; seed < test::scaled(1000) + 10; ++seed) {
    const test::Polygon_soup soup = test::random_surface(seed, triangles);
    ASSERT_EQ(difference_when_renumbered<CGAL::Schnyder_parents_layout<>>(soup, true), "") << seed;
    ASSERT_EQ(difference_when_renumbered<CGAL::Schnyder_parents_layout<6>>(soup, false), "") << seed;
  }
}

TEST(Closed_triangulation, is_scattered_if_large_and_in_a_bad_order)
{
  const auto is_scattered = [](const test::Soup& soup) {
    return CGAL::Closed_triangulation<>(CGAL::Corner_table<>(soup.num_vertices, soup.triangles)).is_scattered();
  };
  const test::Soup large = test::octasphere(7);
  EXPECT_FALSE(is_scattered(large));
  EXPECT_TRUE(is_scattered(test::shuffled(large, 1)));
  EXPECT_FALSE(is_scattered(test::shuffled(test::octasphere(4), 1)));
  EXPECT_FALSE(CGAL::Closed_triangulation<>().is_scattered());
}

TEST(Schnyder_parents_layout, of_a_scattered_mesh_is_that_of_the_input)
{
  const test::Soup soup = test::shuffled(test::octasphere(7), 1);
  EXPECT_EQ(test::difference_from_soup<CGAL::Schnyder_parents_layout<>>(test::soup_of(soup)), "");
}

// What an Input_order_layout renumbers of a soup, or nothing.
template <class Layout>
std::string renumbered(const test::Polygon_soup& soup, bool are_faces_kept)
{
  CGAL::Input_images<typename Layout::Index> images;
  images.wants_halfedges = true;
  const Layout layout = test::layout_of<Layout>(soup, images);
  for (std::size_t v = 0; v < images.vertices.size(); ++v)
    if (images.vertices[v] != v)
      return "vertex " + std::to_string(v);
  std::size_t side = 0;
  for (std::size_t f = 0; are_faces_kept && f < soup.faces.size(); side += soup.faces[f++].size()) {
    if (layout.face(images.halfedges[side]) != f)
      return "face " + std::to_string(f);
    const auto corners = layout.vertices_of_face(static_cast<typename Layout::Index>(f));
    if (std::count(soup.faces[f].begin(), soup.faces[f].end(), corners[0]) != 1)
      return "vertices of face " + std::to_string(f);
  }
  return "";
}

TEST(Input_order_layout, keeps_the_order_of_the_input)
{
  typedef CGAL::Schnyder_parents_layout<> Layout;
  for (unsigned int seed = 0; seed < test::scaled(300) + 10; ++seed) {
    const test::Polygon_soup soup = test::random_surface(seed);
    ASSERT_EQ(renumbered<CGAL::Input_order_layout<Layout>>(soup, false), "") << seed;
    typedef CGAL::Input_order_layout<Layout, CGAL::Input_order::VERTICES_AND_FACES> Ordered;
    ASSERT_EQ(renumbered<Ordered>(soup, true), "") << seed;
    ASSERT_EQ(test::difference_from_soup<Ordered>(soup), "") << seed;
  }
}

} // namespace
