// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_LAYOUT_SUITE_H
#define TEST_COMPACT_SURFACE_MESH_LAYOUT_SUITE_H

// The tests that every layout passes: every operator on every element against the corner table.

#include "generated_surfaces.h"
#include "generated_triangulations.h"
#include "layout_of_soup.h"
#include "layout_oracle.h"
#include "shelling_orders.h"
#include "small_triangulations.h"
#include "test_scale.h"

#include <CGAL/Schnyder_woods/random_planar_triangulation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace test {

// Whether the constructor of the layout takes an order of shelling.
template <class Layout>
constexpr bool stands_on_a_wood =
  std::is_constructible<Layout, CGAL::Closed_triangulation<typename Layout::Index>,
                        CGAL::Input_images<typename Layout::Index>&, CGAL::Shelling_order, unsigned int>::value;

// Whether it takes time linear in the degree of a vertex to find it from an edge, so that all targets of a star
// take a time of the square of its degree.
template <class Layout>
struct Walks_to_targets : std::false_type
{};

// Builds the layout in all ways that its constructor offers, and compares each.
template <class Layout>
struct All_woods
{
  template <class Triangles>
  static std::string difference(std::size_t n, const Triangles& triangles)
  {
    return of_all_orders([&](auto... arguments) {
      return difference_from_table<Layout>(n, triangles, arguments...);
    });
  }

  static std::string difference(const Polygon_soup& soup)
  {
    return of_all_orders([&](auto... arguments) { return difference_from_soup<Layout>(soup, arguments...); });
  }

private:
  template <class Difference>
  static std::string of_all_orders(const Difference& difference_with)
  {
    if constexpr (stands_on_a_wood<Layout>) {
      for (const CGAL::Shelling_order order : all_orders) {
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
std::string difference(const Soup& soup)
{
  return All_woods<Layout>::difference(soup.num_vertices, soup.triangles);
}

template <class Layout>
class Layouts : public testing::Test
{};

TYPED_TEST_SUITE_P(Layouts);

TYPED_TEST_P(Layouts, agree_with_the_corner_table_on_all_rooted_triangulations_with_up_to_9_vertices)
{
  for (int n = 4; n <= largest_exhaustive(); ++n)
    for (const auto& map : all_sphere_triangulations(n))
      for (const auto& rooted : Oriented_map(map).all_codes()) {
        const std::string difference = All_woods<TypeParam>::difference(n, rooted);
        ASSERT_EQ(difference, "") << "triangles " << testing::PrintToString(rooted);
      }
}

TYPED_TEST_P(Layouts, agree_with_the_corner_table_on_random_triangulations)
{
  const std::uint32_t largest =
      static_cast<std::uint32_t>(scaled(Walks_to_targets<TypeParam>::value ? 100000 : 1000000));
  for (std::uint32_t n = 10; n <= largest; n *= 10) {
    CGAL::Random random(n);
    const auto triangles = CGAL::random_planar_triangulation(n, random);
    ASSERT_EQ(All_woods<TypeParam>::difference(n, triangles), "") << "seed and vertices " << n;
  }
}

TYPED_TEST_P(Layouts, agree_with_the_corner_table_on_many_small_random_triangulations)
{
  for (unsigned int seed = 0; seed < scaled(1000); ++seed) {
    CGAL::Random random(seed);
    const std::uint32_t n = 10 + seed % 60;
    const auto triangles = CGAL::random_planar_triangulation(n, random);
    ASSERT_EQ(All_woods<TypeParam>::difference(n, triangles), "") << "seed " << seed << ", vertices " << n;
  }
}

TYPED_TEST_P(Layouts, agree_with_the_corner_table_on_stacked_triangulations_and_hubs)
{
  const std::uint32_t n = static_cast<std::uint32_t>(scaled(100000));
  EXPECT_EQ(difference<TypeParam>(stacked_triangulation(n, 1)), "");
  const std::uint32_t m = Walks_to_targets<TypeParam>::value ? static_cast<std::uint32_t>(scaled(1900) + 100) : n;
  EXPECT_EQ(difference<TypeParam>(stacked_at_hub(m)), "");
  EXPECT_EQ(difference<TypeParam>(double_wheel(m)), "");
  // families and lists around the lengths at which they move to the side table
  for (std::uint32_t k = 5; k < 45; ++k) {
    EXPECT_EQ(difference<TypeParam>(stacked_at_hub(k)), "") << k;
    EXPECT_EQ(difference<TypeParam>(double_wheel(k)), "") << k;
    EXPECT_EQ(difference<TypeParam>(shuffled(double_wheel(k), k)), "") << k;
  }
}

TYPED_TEST_P(Layouts, agree_with_the_corner_table_on_regular_spheres)
{
  for (int subdivisions = 0; subdivisions <= (scaled(1000) >= 1000 ? 7 : 4); ++subdivisions) {
    const Soup sphere = octasphere(subdivisions);
    EXPECT_EQ(difference<TypeParam>(sphere), "") << subdivisions;
    EXPECT_EQ(difference<TypeParam>(shuffled(sphere, 5)), "") << subdivisions;
  }
}

TYPED_TEST_P(Layouts, are_right_on_all_rooted_tori_with_up_to_9_vertices)
{
  for (int n = 7; n <= (std::min)(9, largest_exhaustive()); ++n)
    for (const auto& map : all_torus_triangulations(n))
      for (const auto& rooted : Oriented_map(map).all_codes()) {
        const std::string difference = All_woods<TypeParam>::difference(n, rooted);
        ASSERT_EQ(difference, "") << "triangles " << testing::PrintToString(rooted);
      }
}

TYPED_TEST_P(Layouts, are_right_on_random_closed_surfaces)
{
  for (unsigned int seed = 0; seed < scaled(300); ++seed) {
    const std::uint32_t genus = seed % 5 == 0 ? 30 : 1 + seed % 4;
    const Soup soup = closed_surface(genus, 8 * genus + 12 + seed % 20, seed);
    ASSERT_EQ(All_woods<TypeParam>::difference(soup.num_vertices, soup.triangles), "") << "seed " << seed;
  }
  const std::uint32_t many = static_cast<std::uint32_t>(scaled(180)) + 20;
  const Soup large = closed_surface(many, 15 * many, 1);
  ASSERT_EQ(All_woods<TypeParam>::difference(large.num_vertices, large.triangles), "");
}

// The genera are 10,000 and 5,577.
TYPED_TEST_P(Layouts, are_right_on_surfaces_with_many_handles)
{
  const std::uint32_t n = static_cast<std::uint32_t>(scaled(200000));
  const Soup sphere = sphere_with_far_handles(n, n / 20);
  EXPECT_EQ((difference_from_table<TypeParam>(sphere.num_vertices, sphere.triangles)), "");
  const int k = (std::max)(2, static_cast<int>(std::lround(std::cbrt(n / 60))));
  const Soup scaffold = test::scaffold(k, 1);
  EXPECT_EQ((difference_from_table<TypeParam>(scaffold.num_vertices, scaffold.triangles)), "");
}

TYPED_TEST_P(Layouts, are_right_on_random_surfaces_of_all_kinds)
{
  Surface_options triangles;
  triangles.has_polygons = false;
  for (unsigned int seed = 0; seed < scaled(1000); ++seed) {
    const Polygon_soup of_polygons = random_surface(seed), of_triangles = random_surface(seed, triangles);
    ASSERT_EQ(All_woods<TypeParam>::difference(of_polygons), "") << "seed " << seed;
    ASSERT_EQ(All_woods<TypeParam>::difference(of_triangles), "") << "seed " << seed << ", triangles";
  }
}

TYPED_TEST_P(Layouts, are_right_on_large_surfaces_of_all_kinds)
{
  Surface_options options;
  options.max_vertices = static_cast<std::uint32_t>(scaled(Walks_to_targets<TypeParam>::value ? 5000 : 20000)) + 50;
  options.max_genus = 200;
  for (unsigned int seed = 0; seed < 4; ++seed)
    ASSERT_EQ(All_woods<TypeParam>::difference(random_surface(seed, options)), "") << "seed " << seed;
  const std::size_t n = scaled(1000) + 20;
  ASSERT_EQ(All_woods<TypeParam>::difference(quad_grid(n, 10)), "");
  for (const std::size_t k : {3, 4, 8, 9, 100})
    for (const Polygon_soup& soup : {polygon(k), pillow(k)})
      ASSERT_EQ(All_woods<TypeParam>::difference(soup), "") << k << " sides";
}

// A closed surface, in which the stars of some vertices become polygons, or holes. Few vertices are near one.
inline Polygon_soup with_large_polygons(std::uint32_t genus, unsigned int seed)
{
  const Soup surface = closed_surface(genus, 400, seed);
  const std::size_t least_degree = seed % 2 == 0 ? 4 : 9;
  std::mt19937 rng(seed);
  std::vector<std::map<std::uint32_t, std::uint32_t>> links(surface.num_vertices); // counterclockwise
  for (const auto& t : surface.triangles)
    for (int i = 0; i < 3; ++i)
      links[t[i]][t[(i + 1) % 3]] = t[(i + 2) % 3];
  std::vector<bool> is_taken(surface.num_vertices, false), is_removed(surface.num_vertices, false);
  Polygon_soup soup{surface.num_vertices, {}};
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

TYPED_TEST_P(Layouts, are_right_where_few_polygons_lie_among_many_triangles)
{
  for (unsigned int seed = 0; seed < scaled(60) + 6; ++seed)
    ASSERT_EQ(All_woods<TypeParam>::difference(with_large_polygons(seed % 3, seed)), "") << "seed " << seed;
}

TYPED_TEST_P(Layouts, tell_halfedges_only_if_they_are_wanted)
{
  const Polygon_soup soup = pillow(5);
  CGAL::Input_images<typename TypeParam::Index> images;
  images.wants_halfedges = true;
  layout_of<TypeParam>(soup, images);
  EXPECT_EQ(images.halfedges.size(), 10u);
  images.wants_halfedges = false;
  layout_of<TypeParam>(soup, images);
  EXPECT_TRUE(images.halfedges.empty());
  EXPECT_EQ(images.vertices.size(), 5u);
}

// With everything that a layout can hold.
TYPED_TEST_P(Layouts, of_all_kinds_of_elements_can_be_copied_and_moved)
{
  for (unsigned int seed = 0; seed < 20; ++seed) {
    const Polygon_soup soup = random_surface(seed);
    CGAL::Input_images<typename TypeParam::Index> images;
    TypeParam layout = layout_of<TypeParam>(soup, images);
    const auto difference = [&](const TypeParam& l) {
      return Surface_oracle<TypeParam>(l, soup, images.vertices).difference();
    };
    const TypeParam copy = layout;
    const TypeParam moved = std::move(layout);
    ASSERT_EQ(difference(copy), "") << seed;
    ASSERT_EQ(difference(moved), "") << seed;
    ASSERT_EQ(layout.num_vertices() + layout.num_halfedges() + layout.num_edges() + layout.num_faces(), 0u) << seed;
  }
}

TYPED_TEST_P(Layouts, take_the_triangle_with_two_sides)
{
  const std::vector<std::array<int, 3>> triangles = { { 0, 1, 2 }, { 2, 1, 0 } };
  EXPECT_EQ(All_woods<TypeParam>::difference(3, triangles), "");
}

TYPED_TEST_P(Layouts, are_empty_without_a_mesh)
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

TYPED_TEST_P(Layouts, can_be_copied_and_are_empty_after_a_move)
{
  typedef typename TypeParam::Index Index;
  const Soup sphere = octasphere(2);
  const CGAL::Corner_table<Index> table(sphere.num_vertices, sphere.triangles);
  CGAL::Input_images<Index> images;
  TypeParam layout(CGAL::Closed_triangulation<Index>(CGAL::Corner_table<Index>(table)), images);
  const TypeParam copy = layout;
  EXPECT_EQ((Layout_oracle<TypeParam, Index>(copy, table, images.vertices).difference()), "");
  const TypeParam moved = std::move(layout);
  EXPECT_EQ((Layout_oracle<TypeParam, Index>(moved, table, images.vertices).difference()), "");
  EXPECT_EQ(layout.num_vertices(), 0u);
  EXPECT_EQ(layout.num_halfedges(), 0u);
  EXPECT_EQ(layout.num_faces(), 0u);
}

TYPED_TEST_P(Layouts, find_no_halfedge_between_vertices_that_are_not_adjacent)
{
  typedef typename TypeParam::Index Index;
  const Soup sphere = shuffled(octasphere(2), 3);
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

REGISTER_TYPED_TEST_SUITE_P(Layouts,
  agree_with_the_corner_table_on_all_rooted_triangulations_with_up_to_9_vertices,
  agree_with_the_corner_table_on_random_triangulations,
  agree_with_the_corner_table_on_many_small_random_triangulations,
  agree_with_the_corner_table_on_stacked_triangulations_and_hubs,
  agree_with_the_corner_table_on_regular_spheres,
  are_right_on_all_rooted_tori_with_up_to_9_vertices,
  are_right_on_random_closed_surfaces,
  are_right_on_surfaces_with_many_handles,
  are_right_on_random_surfaces_of_all_kinds,
  are_right_on_large_surfaces_of_all_kinds,
  are_right_where_few_polygons_lie_among_many_triangles,
  tell_halfedges_only_if_they_are_wanted,
  of_all_kinds_of_elements_can_be_copied_and_moved,
  take_the_triangle_with_two_sides,
  are_empty_without_a_mesh,
  can_be_copied_and_are_empty_after_a_move,
  find_no_halfedge_between_vertices_that_are_not_adjacent);

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_LAYOUT_SUITE_H
