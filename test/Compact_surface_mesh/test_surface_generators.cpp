// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The surfaces that other tests draw from: are they what they are said to be?

#include "generated_surfaces.h"
#include "surface_oracle.h"
#include "test_scale.h"

#include <boost/pending/disjoint_sets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using test::Polygon_soup;
using test::Soup;
using test::Soup_halfedges;

// What a polygon soup is made of.
struct Census
{
  std::size_t num_isolated_vertices = 0, num_edges = 0, num_border_halfedges = 0, num_components = 0;
  std::size_t max_sides = 0, max_fans = 0;
  std::ptrdiff_t genus = 0; // of all components together, if they are closed
  std::string defect;       // what keeps it from being an oriented manifold
};

// The faces at v, in fans from one border to the other, or in a closed one.
void count_fans(const Soup_halfedges& halfedges, std::size_t v, Census& census)
{
  std::vector<std::size_t> starts;
  std::size_t num_faces = 0, num_seen = 0;
  for (std::size_t i = 0; i < halfedges.degree(v); ++i) {
    const std::size_t h = halfedges.out(v, i);
    if (halfedges.is_border(h))
      starts.push_back(h);
    else
      ++num_faces;
  }
  census.num_border_halfedges += starts.size();
  if (starts.empty() && num_faces > 0)
    starts.push_back(halfedges.out(v, 0));
  for (const std::size_t start : starts) {
    std::size_t h = start;
    do {
      h = halfedges.next(halfedges.opposite(h));
      ++num_seen;
    } while (h != start && !halfedges.is_border(halfedges.opposite(h)));
  }
  if (num_seen != num_faces)
    census.defect = "fans at " + std::to_string(v);
  census.num_isolated_vertices += num_faces == 0 ? 1 : 0;
  census.max_fans = (std::max)(census.max_fans, starts.size());
}

Census census_of(const Polygon_soup& soup)
{
  Census census;
  std::vector<std::size_t> rank(soup.num_vertices), parent(soup.num_vertices);
  boost::disjoint_sets<std::size_t*, std::size_t*> components(rank.data(), parent.data());
  for (std::size_t v = 0; v < soup.num_vertices; ++v)
    components.make_set(v);
  for (const auto& face : soup.faces) {
    census.max_sides = (std::max)(census.max_sides, face.size());
    if (face.size() < 3 || std::set<long long>(face.begin(), face.end()).size() != face.size()
        || *std::min_element(face.begin(), face.end()) < 0
        || *std::max_element(face.begin(), face.end()) >= static_cast<long long>(soup.num_vertices)) {
      census.defect = "vertices of a face";
      return census;
    }
    for (const long long v : face)
      components.union_set(static_cast<std::size_t>(v), static_cast<std::size_t>(face[0]));
  }
  const Soup_halfedges halfedges(soup); // throws if an edge occurs twice in one direction
  census.num_edges = halfedges.num_halfedges() / 2;
  for (std::size_t v = 0; v < soup.num_vertices; ++v) {
    count_fans(halfedges, v, census);
    census.num_components += components.find_set(v) == v ? 1 : 0;
  }
  const std::ptrdiff_t euler_characteristic = static_cast<std::ptrdiff_t>(soup.num_vertices + soup.faces.size())
                                              - static_cast<std::ptrdiff_t>(census.num_edges);
  census.genus = static_cast<std::ptrdiff_t>(census.num_components) - euler_characteristic / 2;
  return census;
}

void expect_closed(const Soup& soup, std::size_t genus, std::size_t num_vertices)
{
  EXPECT_EQ(soup.num_vertices, num_vertices);
  const Census census = census_of(test::soup_of(soup));
  EXPECT_EQ(census.defect, "");
  EXPECT_EQ(census.num_border_halfedges, 0u);
  EXPECT_EQ(census.num_isolated_vertices, 0u);
  EXPECT_EQ(census.num_components, 1u);
  EXPECT_EQ(census.genus, static_cast<std::ptrdiff_t>(genus));
}

TEST(Torus_triangulations, are_1_with_7_and_7_with_8_and_112_with_9_and_2109_with_10_vertices)
{
  const std::vector<std::size_t> counts = {1, 7, 112, 2109};
  for (int n = 7; n <= test::largest_exhaustive() + 1; ++n) {
    const std::vector<test::Triangles> all = test::all_torus_triangulations(n);
    EXPECT_EQ(test::unoriented_count(all), counts[static_cast<std::size_t>(n) - 7]) << n;
    for (const auto& triangles : all)
      if (n < 10)
        expect_closed(Soup{static_cast<std::uint32_t>(n), triangles}, 1, static_cast<std::size_t>(n));
  }
  EXPECT_THROW(test::all_torus_triangulations(6), std::invalid_argument);
}

TEST(Closed_surfaces, have_the_genus_and_the_vertices_that_are_asked_for)
{
  for (unsigned int seed = 0; seed < test::scaled(1000); ++seed) {
    const std::uint32_t genus = seed % 5, n = (genus == 0 ? 4 : 4 * genus + 3) + seed % 83;
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_closed(test::closed_surface(genus, n, seed), genus, n);
  }
  for (const std::uint32_t genus : {10, 50, 200})
    for (const std::uint32_t n : {4 * genus + 3, 16 * genus + 7, 16 * genus + 8, 30 * genus})
      expect_closed(test::closed_surface(genus, n, genus), genus, n);
  EXPECT_THROW(test::closed_surface(2, 10, 1), std::invalid_argument);
  EXPECT_THROW(test::closed_surface(0, 3, 1), std::invalid_argument);
}

TEST(Closed_surfaces, differ_from_seed_to_seed_and_are_the_same_from_the_same_seed)
{
  std::set<test::Triangles> codes;
  for (unsigned int seed = 0; seed < 20; ++seed) {
    const Soup surface = test::closed_surface(2, 20, seed);
    EXPECT_EQ(surface.triangles, test::closed_surface(2, 20, seed).triangles);
    codes.insert(test::canonical_code(surface.triangles));
  }
  EXPECT_EQ(codes.size(), 20u);
  codes.clear();
  for (unsigned int seed = 0; seed < 20; ++seed) // here by flips alone
    codes.insert(test::canonical_code(test::closed_surface(2, 11, seed).triangles));
  EXPECT_GT(codes.size(), 10u);
}

TEST(Closed_surfaces, lose_no_edge_by_flips_there_and_back)
{
  test::Flippable_surface surface(test::closed_surface(3, 60, 1));
  const test::Triangles code = test::canonical_code(surface.soup().triangles);
  std::size_t num_flips = 0;
  for (std::size_t h = 0; h < surface.num_halfedges(); ++h) {
    if (!surface.flip(h))
      continue;
    ++num_flips; // the new edge is side 1 of the triangle
    EXPECT_TRUE(surface.flip(h / 3 * 3 + 1));
    EXPECT_EQ(test::canonical_code(surface.soup().triangles), code) << h;
  }
  EXPECT_GT(num_flips, surface.num_halfedges() / 2);
}

TEST(Regular_surfaces, have_the_genus_and_the_vertices_that_are_asked_for)
{
  for (const std::uint32_t k : {1, 2, 3, 100})
    expect_closed(test::chain_of_tori(k), k, 4 * k + 3);
  for (const int m : {1, 2, 3, 10})
    expect_closed(test::octahedron(m), 0, 4 * static_cast<std::size_t>(m * m) + 2);
  for (const int k : {1, 2, 3, 5})
    expect_closed(test::scaffold(k, 0), static_cast<std::size_t>(2 * k * k * k - 3 * k * k + 1),
                  static_cast<std::size_t>(8 * k * k * k));
  expect_closed(test::scaffold(2, 2), 5, 1144);
  for (const std::uint32_t a : {3, 4, 7})
    for (const std::uint32_t b : {3, 5})
      expect_closed(test::torus_grid(a, b), 1, a * b);
  expect_closed(test::sphere_with_far_handles(10, 1), 1, 38);
  expect_closed(test::sphere_with_far_handles(10002, 100), 100, 10002);
  EXPECT_THROW(test::sphere_with_far_handles(100, 50), std::invalid_argument);
}

TEST(Regular_surfaces, keep_what_they_promise_at_a_million_vertices)
{
  const std::uint32_t n = static_cast<std::uint32_t>(test::scaled(1000000)), genus = n / 100;
  const Soup sphere = test::sphere_with_far_handles(n, genus);
  EXPECT_LT(sphere.num_vertices, n + n / 50);
  expect_closed(sphere, genus, sphere.num_vertices);
}

TEST(Regular_surfaces, have_vertices_of_degree_4_and_6_on_an_octahedron)
{
  const Polygon_soup soup = test::soup_of(test::octahedron(7));
  const Soup_halfedges halfedges(soup);
  std::map<std::size_t, std::size_t> num_of_degree;
  for (std::size_t v = 0; v < soup.num_vertices; ++v)
    ++num_of_degree[halfedges.degree(v)];
  EXPECT_EQ(num_of_degree, (std::map<std::size_t, std::size_t>{{4, 6}, {6, 192}}));
}

TEST(Regular_surfaces, have_opposite_triangles_in_the_same_order_on_an_octahedron)
{
  const Soup soup = test::octahedron(5);
  const std::size_t half = soup.triangles.size() / 2;
  std::map<std::uint32_t, std::uint32_t> opposite;
  for (std::size_t f = 0; f < 2 * half; ++f) {
    const test::Triangle& t = soup.triangles[f];
    const test::Triangle& u = soup.triangles[(f + half) % (2 * half)];
    for (const std::size_t i : {0, 1, 2}) { // a point reflection turns triangles over
      const auto insertion = opposite.insert({t[i], u[2 - i]});
      EXPECT_EQ(insertion.first->second, u[2 - i]) << f;
    }
  }
  for (const auto& pair : opposite) {
    EXPECT_NE(pair.first, pair.second);
    EXPECT_EQ(opposite.at(pair.second), pair.first);
  }
}

TEST(Regular_surfaces, have_small_degrees_in_a_chain_of_tori)
{
  const Soup_halfedges halfedges(test::soup_of(test::chain_of_tori(50)));
  for (std::size_t v = 0; v < halfedges.num_vertices(); ++v)
    EXPECT_LE(halfedges.degree(v), 10u); // no vertex belongs to three tori
}

TEST(Surfaces_with_borders, have_the_borders_and_components_that_are_asked_for)
{
  for (const std::size_t num_borders : {0, 1, 30}) {
    const Census census = census_of(test::soup_of(test::mesh_with_borders(1000, num_borders, 1)));
    EXPECT_EQ(census.defect, "");
    EXPECT_EQ(census.num_border_halfedges, 3 * num_borders);
    EXPECT_EQ(census.max_fans, 1u); // borders have no common vertices
    EXPECT_EQ(census.num_components, 1u);
  }
  for (const std::uint32_t num_components : {1, 7, 100}) {
    const Soup soup = test::many_components(1000, num_components, 1);
    const Census census = census_of(test::soup_of(soup));
    EXPECT_EQ(soup.num_vertices, 1000u);
    EXPECT_EQ(census.defect, "");
    EXPECT_EQ(census.num_border_halfedges, 0u);
    EXPECT_EQ(census.num_components, num_components);
    EXPECT_EQ(census.genus, 0);
  }
}

TEST(Polygons, are_disks_and_pillows_and_grids)
{
  for (const std::size_t k : {3, 4, 100}) {
    const Census disk = census_of(test::polygon(k)), pillow = census_of(test::pillow(k));
    EXPECT_EQ(disk.defect + pillow.defect, "");
    EXPECT_EQ(disk.num_border_halfedges, k);
    EXPECT_EQ(pillow.num_border_halfedges, 0u);
    EXPECT_EQ(pillow.genus, 0);
    EXPECT_EQ(pillow.max_sides, k);
  }
  const Polygon_soup grid = test::quad_grid(3, 5);
  const Census census = census_of(grid);
  EXPECT_EQ(grid.faces.size(), 15u);
  EXPECT_EQ(census.defect, "");
  EXPECT_EQ(census.num_border_halfedges, 16u);
  EXPECT_EQ(census.num_edges, 38u);
}

TEST(Random_surfaces, are_manifolds_of_all_kinds)
{
  std::map<std::string, std::size_t> num_of_kind;
  for (unsigned int seed = 0; seed < test::scaled(5000); ++seed) {
    const Polygon_soup soup = test::random_surface(seed);
    const Census census = census_of(soup);
    ASSERT_EQ(census.defect, "") << "seed " << seed << ", " << soup;
    num_of_kind["closed"] += census.num_border_halfedges == 0 ? 1 : 0;
    num_of_kind["closed with handles"] += census.num_border_halfedges == 0 && census.genus > 0 ? 1 : 0;
    num_of_kind["with borders"] += census.num_border_halfedges > 0 ? 1 : 0;
    num_of_kind["with three fans at a vertex"] += census.max_fans > 2 ? 1 : 0;
    num_of_kind["with triangles only"] += census.max_sides == 3 ? 1 : 0;
    num_of_kind["with quads"] += census.max_sides == 4 ? 1 : 0;
    num_of_kind["with more than 20 sides"] += census.max_sides > 20 ? 1 : 0;
    num_of_kind["with isolated vertices"] += census.num_isolated_vertices > 0 ? 1 : 0;
    num_of_kind["without isolated vertices"] += census.num_isolated_vertices == 0 ? 1 : 0;
    num_of_kind["with three components or more"] += census.num_components - census.num_isolated_vertices > 2 ? 1 : 0;
  }
  EXPECT_EQ(num_of_kind.size(), 10u);
  for (const auto& kind : num_of_kind)
    EXPECT_GE(kind.second, test::scaled(5000) / 50) << kind.first;
}

TEST(Random_surfaces, consist_of_what_is_allowed)
{
  test::Surface_options closed, triangles, connected;
  closed.has_borders = closed.has_isolated_vertices = false;
  triangles.has_polygons = triangles.has_isolated_vertices = false;
  connected.max_components = 1;
  connected.max_genus = 0;
  connected.has_borders = connected.has_isolated_vertices = false;
  for (unsigned int seed = 0; seed < test::scaled(1000); ++seed) {
    EXPECT_EQ(census_of(test::random_surface(seed, closed)).num_border_halfedges, 0u) << seed;
    EXPECT_LE(census_of(test::random_surface(seed, triangles)).max_sides, 3u) << seed;
    EXPECT_EQ(census_of(test::random_surface(seed, triangles)).num_isolated_vertices, 0u) << seed;
    EXPECT_EQ(census_of(test::random_surface(seed, connected)).num_components, 1u) << seed;
    EXPECT_EQ(census_of(test::random_surface(seed, connected)).genus, 0) << seed;
  }
}

TEST(Random_surfaces, have_polygons_of_many_triangles)
{
  test::Surface_options options;
  options.max_components = 1;
  options.has_borders = options.has_isolated_vertices = false;
  std::size_t num_found = 0;
  for (unsigned int seed = 0; seed < test::scaled(1000); ++seed) {
    const Polygon_soup soup = test::random_surface(seed, options);
    num_found += soup.faces.size() > 2 && census_of(soup).max_sides > 12 ? 1 : 0; // not a pillow
  }
  EXPECT_GE(num_found, test::scaled(1000) / 20);
}

TEST(Random_surfaces, may_be_large)
{
  test::Surface_options options;
  options.max_vertices = 3000;
  options.max_genus = 200;
  std::ptrdiff_t genus = 0;
  for (unsigned int seed = 0; seed < test::scaled(100); ++seed) {
    const Census census = census_of(test::random_surface(seed, options));
    EXPECT_EQ(census.defect, "") << seed;
    genus = (std::max)(genus, census.num_border_halfedges == 0 ? census.genus : 0);
  }
  if (test::scaled(100) == 100) {
    EXPECT_GE(genus, 100);
  }
}

TEST(Soup_halfedges, refuse_an_edge_that_occurs_twice_in_one_direction)
{
  EXPECT_THROW(Soup_halfedges(Polygon_soup{4, {{0, 1, 2}, {0, 1, 3}}}), std::invalid_argument);
}

} // namespace
