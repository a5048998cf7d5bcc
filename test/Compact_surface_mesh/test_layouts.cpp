// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// All layouts against the corner table: every operator on every element.

#include "generated_triangulations.h"
#include "generated_surfaces.h"
#include "layout_of_soup.h"
#include "layout_oracle.h"
#include "scattered_layout.h"
#include "shelling_orders.h"
#include "small_triangulations.h"
#include "test_scale.h"

#include <CGAL/Compact_surface_mesh/layouts/Corner_table_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/Input_order_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/Laced_ring_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/SOT_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/SQuad_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/Schnyder_fronts_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/Schnyder_parents_layout.h>
#include <CGAL/Schnyder_woods/random_planar_triangulation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

// Whether the constructor of the layout takes an order of shelling.
template <class Layout>
struct Stands_on_a_wood : std::false_type
{};
template <int References, class Index>
struct Stands_on_a_wood<CGAL::Schnyder_parents_layout<References, Index>> : std::true_type
{};
template <int References, bool has_targets, class Index>
struct Stands_on_a_wood<CGAL::Schnyder_fronts_layout<References, has_targets, Index>> : std::true_type
{};

// Whether it takes time linear in the degree of a vertex to find it from an edge, so that all targets of a star
// take a time of the square of its degree.
template <class Layout>
struct Walks_to_targets : std::false_type
{};
template <class Index>
struct Walks_to_targets<CGAL::SOT_layout<Index>> : std::true_type
{};
template <class Index>
struct Walks_to_targets<CGAL::SQuad_layout<Index>> : std::true_type
{};
template <int References, class Index>
struct Walks_to_targets<CGAL::Schnyder_fronts_layout<References, false, Index>> : std::true_type
{};

// Builds the layout in all ways that its constructor offers, and compares each.
template <class Layout>
struct All_woods
{
  template <class Triangles>
  static std::string difference(std::size_t n, const Triangles& triangles)
  {
    return of_all_orders([&](auto... arguments) {
      return test::difference_from_table<Layout>(n, triangles, arguments...);
    });
  }

  static std::string difference(const test::Polygon_soup& soup)
  {
    return of_all_orders([&](auto... arguments) { return test::difference_from_soup<Layout>(soup, arguments...); });
  }

private:
  template <class Difference>
  static std::string of_all_orders(const Difference& difference_with)
  {
    if constexpr (Stands_on_a_wood<Layout>::value) {
      for (const CGAL::Shelling_order order : test::all_orders) {
        const std::string difference = difference_with(order, 7u);
        if (!difference.empty())
          return difference + " (order " + std::to_string(static_cast<int>(order)) + ")";
      }
      return "";
    } else
      return difference_with();
  }
};

template <class Layout>
std::string difference(const test::Soup& soup)
{
  return All_woods<Layout>::difference(soup.num_vertices, soup.triangles);
}

template <class Layout>
class Layouts : public testing::Test
{};

typedef testing::Types<CGAL::Corner_table_layout<>,
                       CGAL::Schnyder_parents_layout<4>,
                       CGAL::Schnyder_parents_layout<5>,
                       CGAL::Schnyder_parents_layout<6>,
                       CGAL::Schnyder_fronts_layout<6>,
                       CGAL::Schnyder_fronts_layout<5>,
                       CGAL::Schnyder_fronts_layout<4>,
                       CGAL::Schnyder_fronts_layout<5, true>,
                       CGAL::Corner_table_layout<std::uint64_t>,
                       test::Scattered_layout<>,
                       CGAL::SOT_layout<>,
                       CGAL::SQuad_layout<>,
                       CGAL::SQuad_layout<std::uint64_t>,
                       CGAL::Laced_ring_layout<>,
                       CGAL::Laced_ring_layout<std::uint32_t, std::uint16_t>,
                       CGAL::Schnyder_parents_layout<4, std::uint64_t>,
                       CGAL::Input_order_layout<>,
                       CGAL::Input_order_layout<CGAL::Corner_table_layout<>, CGAL::Input_order::VERTICES_AND_FACES>>
    All_layouts;
TYPED_TEST_SUITE(Layouts, All_layouts);

TYPED_TEST(Layouts, agree_with_the_corner_table_on_all_rooted_triangulations_with_up_to_9_vertices)
{
  for (int n = 4; n <= test::largest_exhaustive(); ++n)
    for (const auto& map : test::all_sphere_triangulations(n))
      for (const auto& rooted : test::Oriented_map(map).all_codes()) {
        const std::string difference = All_woods<TypeParam>::difference(n, rooted);
        ASSERT_EQ(difference, "") << "triangles " << testing::PrintToString(rooted);
      }
}

TYPED_TEST(Layouts, agree_with_the_corner_table_on_random_triangulations)
{
  const std::uint32_t largest = static_cast<std::uint32_t>(test::scaled(1000000));
  for (std::uint32_t n = 10; n <= largest; n *= 10) {
    CGAL::Random random(n);
    const auto triangles = CGAL::random_planar_triangulation(n, random);
    ASSERT_EQ(All_woods<TypeParam>::difference(n, triangles), "") << "seed and vertices " << n;
  }
}

TYPED_TEST(Layouts, agree_with_the_corner_table_on_many_small_random_triangulations)
{
  for (unsigned int seed = 0; seed < test::scaled(1000); ++seed) {
    CGAL::Random random(seed);
    const std::uint32_t n = 10 + seed % 60;
    const auto triangles = CGAL::random_planar_triangulation(n, random);
    ASSERT_EQ(All_woods<TypeParam>::difference(n, triangles), "") << "seed " << seed << ", vertices " << n;
  }
}

TYPED_TEST(Layouts, agree_with_the_corner_table_on_stacked_triangulations_and_hubs)
{
  const std::uint32_t n = static_cast<std::uint32_t>(test::scaled(100000));
  EXPECT_EQ(difference<TypeParam>(test::stacked_triangulation(n, 1)), "");
  const std::uint32_t m = Walks_to_targets<TypeParam>::value ? (std::min)(n, 2000u) : n;
  EXPECT_EQ(difference<TypeParam>(test::stacked_at_hub(m)), "");
  EXPECT_EQ(difference<TypeParam>(test::double_wheel(m)), "");
  // families and lists around the lengths at which they move to the side table
  for (std::uint32_t k = 5; k < 45; ++k) {
    EXPECT_EQ(difference<TypeParam>(test::stacked_at_hub(k)), "") << k;
    EXPECT_EQ(difference<TypeParam>(test::double_wheel(k)), "") << k;
    EXPECT_EQ(difference<TypeParam>(test::shuffled(test::double_wheel(k), k)), "") << k;
  }
}

TYPED_TEST(Layouts, agree_with_the_corner_table_on_regular_spheres)
{
  for (int subdivisions = 0; subdivisions <= (test::scaled(1000) >= 1000 ? 7 : 4); ++subdivisions) {
    const test::Soup sphere = test::octasphere(subdivisions);
    EXPECT_EQ(difference<TypeParam>(sphere), "") << subdivisions;
    EXPECT_EQ(difference<TypeParam>(test::shuffled(sphere, 5)), "") << subdivisions;
  }
}

TYPED_TEST(Layouts, are_right_on_all_rooted_tori_with_up_to_9_vertices)
{
  for (int n = 7; n <= (std::min)(9, test::largest_exhaustive()); ++n)
    for (const auto& map : test::all_torus_triangulations(n))
      for (const auto& rooted : test::Oriented_map(map).all_codes()) {
        const std::string difference = All_woods<TypeParam>::difference(n, rooted);
        ASSERT_EQ(difference, "") << "triangles " << testing::PrintToString(rooted);
      }
}

TYPED_TEST(Layouts, are_right_on_random_closed_surfaces)
{
  for (unsigned int seed = 0; seed < test::scaled(300); ++seed) {
    const std::uint32_t genus = seed % 5 == 0 ? 30 : 1 + seed % 4;
    const test::Soup soup = test::closed_surface(genus, 8 * genus + 12 + seed % 20, seed);
    ASSERT_EQ(All_woods<TypeParam>::difference(soup.num_vertices, soup.triangles), "") << "seed " << seed;
  }
  const test::Soup large = test::closed_surface(200, 3000, 1);
  ASSERT_EQ(All_woods<TypeParam>::difference(large.num_vertices, large.triangles), "");
}

// The genera are 10,000 and 5,577.
TYPED_TEST(Layouts, are_right_on_surfaces_with_many_handles)
{
  const std::uint32_t n = static_cast<std::uint32_t>(test::scaled(200000));
  const test::Soup sphere = test::sphere_with_far_handles(n, n / 20);
  EXPECT_EQ((test::difference_from_table<TypeParam>(sphere.num_vertices, sphere.triangles)), "");
  const int k = (std::max)(2, static_cast<int>(std::lround(std::cbrt(n / 60))));
  const test::Soup scaffold = test::scaffold(k, 1);
  EXPECT_EQ((test::difference_from_table<TypeParam>(scaffold.num_vertices, scaffold.triangles)), "");
}

TYPED_TEST(Layouts, are_right_on_random_surfaces_of_all_kinds)
{
  test::Surface_options triangles;
  triangles.has_polygons = false;
  for (unsigned int seed = 0; seed < test::scaled(1000); ++seed) {
    const test::Polygon_soup of_polygons = test::random_surface(seed), of_triangles = test::random_surface(seed, triangles);
    ASSERT_EQ(All_woods<TypeParam>::difference(of_polygons), "") << "seed " << seed;
    ASSERT_EQ(All_woods<TypeParam>::difference(of_triangles), "") << "seed " << seed << ", triangles";
  }
}

TYPED_TEST(Layouts, are_right_on_large_surfaces_of_all_kinds)
{
  test::Surface_options options;
  options.max_vertices = static_cast<std::uint32_t>(test::scaled(20000)) + 50;
  options.max_genus = 200;
  for (unsigned int seed = 0; seed < 4; ++seed)
    ASSERT_EQ(All_woods<TypeParam>::difference(test::random_surface(seed, options)), "") << "seed " << seed;
  const std::size_t n = test::scaled(1000) + 20;
  ASSERT_EQ(All_woods<TypeParam>::difference(test::quad_grid(n, 10)), "");
  for (const std::size_t k : {3, 4, 8, 9, 100})
    for (const test::Polygon_soup& soup : {test::polygon(k), test::pillow(k)})
      ASSERT_EQ(All_woods<TypeParam>::difference(soup), "") << k << " sides";
}

// A closed surface, in which the stars of some vertices become polygons, or holes. Few vertices are near one.
test::Polygon_soup with_large_polygons(std::uint32_t genus, unsigned int seed)
{
  const test::Soup surface = test::closed_surface(genus, 400, seed);
  const std::size_t least_degree = seed % 2 == 0 ? 4 : 9;
  std::mt19937 rng(seed);
  std::vector<std::map<std::uint32_t, std::uint32_t>> links(surface.num_vertices); // counterclockwise
  for (const auto& t : surface.triangles)
    for (int i = 0; i < 3; ++i)
      links[t[i]][t[(i + 1) % 3]] = t[(i + 2) % 3];
  std::vector<bool> is_taken(surface.num_vertices, false), is_removed(surface.num_vertices, false);
  test::Polygon_soup soup{surface.num_vertices, {}};
  std::size_t num_polygons = 1 + seed % 4;
  for (int attempt = 0; attempt < 1000 && num_polygons > 0; ++attempt) {
    const std::uint32_t v = static_cast<std::uint32_t>(rng() % surface.num_vertices);
    const auto& link = links[v];
    if (is_taken[v] || link.size() < least_degree
        || std::any_of(link.begin(), link.end(), [&](const auto& l) { return is_taken[l.first]; }))
      continue;
    std::vector<long long> polygon;
    for (std::uint32_t u = link.begin()->first; polygon.size() < link.size(); u = link.at(u)) {
      polygon.push_back(u);
      is_taken[u] = true;
    }
    is_taken[v] = is_removed[v] = true;
    if (seed % 5 != 4)
      soup.faces.push_back(polygon);
    --num_polygons;
  }
  for (const auto& t : surface.triangles)
    if (std::none_of(t.begin(), t.end(), [&](std::uint32_t v) { return is_removed[v]; }))
      soup.faces.push_back({t[0], t[1], t[2]});
  return soup;
}

TYPED_TEST(Layouts, are_right_where_few_polygons_lie_among_many_triangles)
{
  for (unsigned int seed = 0; seed < 60; ++seed)
    ASSERT_EQ(All_woods<TypeParam>::difference(with_large_polygons(seed % 3, seed)), "") << "seed " << seed;
}

TYPED_TEST(Layouts, tell_halfedges_only_if_they_are_wanted)
{
  const test::Polygon_soup soup = test::pillow(5);
  CGAL::Input_images<typename TypeParam::Index> images;
  images.wants_halfedges = true;
  test::layout_of<TypeParam>(soup, images);
  EXPECT_EQ(images.halfedges.size(), 10u);
  images.wants_halfedges = false;
  test::layout_of<TypeParam>(soup, images);
  EXPECT_TRUE(images.halfedges.empty());
  EXPECT_EQ(images.vertices.size(), 5u);
}

// With everything that a layout can hold.
TYPED_TEST(Layouts, of_all_kinds_of_elements_can_be_copied_and_moved)
{
  for (unsigned int seed = 0; seed < 20; ++seed) {
    const test::Polygon_soup soup = test::random_surface(seed);
    CGAL::Input_images<typename TypeParam::Index> images;
    TypeParam layout = test::layout_of<TypeParam>(soup, images);
    const auto difference = [&](const TypeParam& l) {
      return test::Surface_oracle<TypeParam>(l, soup, images.vertices).difference();
    };
    const TypeParam copy = layout;
    const TypeParam moved = std::move(layout);
    ASSERT_EQ(difference(copy), "") << seed;
    ASSERT_EQ(difference(moved), "") << seed;
    ASSERT_EQ(layout.num_vertices() + layout.num_halfedges() + layout.num_edges() + layout.num_faces(), 0u) << seed;
  }
}

TYPED_TEST(Layouts, take_the_triangle_with_two_sides)
{
  const std::vector<std::array<int, 3>> triangles = { { 0, 1, 2 }, { 2, 1, 0 } };
  EXPECT_EQ(All_woods<TypeParam>::difference(3, triangles), "");
}

TYPED_TEST(Layouts, are_empty_without_a_mesh)
{
  TypeParam layout;
  EXPECT_EQ(layout.num_vertices(), 0u);
  EXPECT_EQ(layout.num_halfedges(), 0u);
  EXPECT_EQ(layout.num_edges(), 0u);
  EXPECT_EQ(layout.num_faces(), 0u);

  CGAL::Input_images<typename TypeParam::Index> images;
  layout = TypeParam(CGAL::Closed_triangulation<typename TypeParam::Index>(), images);
  EXPECT_EQ(layout.num_halfedges(), 0u);
  EXPECT_TRUE(images.vertices.empty());
}

TYPED_TEST(Layouts, can_be_copied_and_are_empty_after_a_move)
{
  typedef typename TypeParam::Index Index;
  const test::Soup sphere = test::octasphere(2);
  const CGAL::Corner_table<Index> table(sphere.num_vertices, sphere.triangles);
  CGAL::Input_images<Index> images;
  TypeParam layout(CGAL::Closed_triangulation<Index>(CGAL::Corner_table<Index>(table)), images);
  const TypeParam copy = layout;
  EXPECT_EQ((test::Layout_oracle<TypeParam, Index>(copy, table, images.vertices).difference()), "");
  const TypeParam moved = std::move(layout);
  EXPECT_EQ((test::Layout_oracle<TypeParam, Index>(moved, table, images.vertices).difference()), "");
  EXPECT_EQ(layout.num_vertices(), 0u);
  EXPECT_EQ(layout.num_halfedges(), 0u);
  EXPECT_EQ(layout.num_faces(), 0u);
}

TYPED_TEST(Layouts, find_no_halfedge_between_vertices_that_are_not_adjacent)
{
  typedef typename TypeParam::Index Index;
  const test::Soup sphere = test::shuffled(test::octasphere(2), 3);
  CGAL::Input_images<Index> images;
  const TypeParam layout(
      CGAL::Closed_triangulation<Index>(CGAL::Corner_table<Index>(sphere.num_vertices, sphere.triangles)), images);
  std::size_t num_adjacent = 0;
  for (Index u = 0; u < layout.num_vertices(); ++u)
    for (Index v = 0; v < layout.num_vertices(); ++v) {
      const Index h = layout.halfedge(u, v);
      if (h == TypeParam::null_index())
        continue;
      ++num_adjacent;
      EXPECT_EQ(layout.source(h), u);
      EXPECT_EQ(layout.target(h), v);
    }
  EXPECT_EQ(num_adjacent, layout.num_halfedges());
}

template <class Layout>
void expect_input_order()
{
  test::Surface_options options;
  options.has_polygons = false;
  for (unsigned int seed = 0; seed < 50; ++seed) {
    const test::Polygon_soup soup = test::random_surface(seed, options);
    CGAL::Input_images<> images;
    test::layout_of<Layout>(soup, images);
    ASSERT_EQ(images.vertices.size(), soup.num_vertices);
    for (std::uint32_t v = 0; v < soup.num_vertices; ++v)
      ASSERT_EQ(images.vertices[v], v) << "seed " << seed;
  }
}

TEST(Schnyder_fronts_layout, of_six_or_five_references_keeps_the_order_of_the_vertices)
{
  static_assert(CGAL::Schnyder_fronts_layout<6>::keeps_vertex_order, "");
  static_assert(CGAL::Schnyder_fronts_layout<5>::keeps_vertex_order, "");
  static_assert(!CGAL::Schnyder_fronts_layout<4>::keeps_vertex_order, "");
  static_assert(!CGAL::Schnyder_fronts_layout<5, true>::keeps_vertex_order, "");
  expect_input_order<CGAL::Schnyder_fronts_layout<6>>();
  expect_input_order<CGAL::Schnyder_fronts_layout<5>>();
}

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
