// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The structures to which the papers compare theirs, beside the corner table.

#include "../../benchmark/Compact_surface_mesh/half_edge_arrays.h"
#include "../../benchmark/Compact_surface_mesh/winged_edge_arrays.h"
#include "closed_surfaces.h"
#include "small_triangulations.h"
#include "test_scale.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using Table = CGAL::Corner_table<>;

// What `structure` answers otherwise than `table` first, or nothing.
template <class Structure>
std::string difference(const Structure& structure, const Table& table)
{
  if (structure.num_vertices() != table.num_vertices() || structure.num_halfedges() != table.num_halfedges())
    return "counts";
  // a table has no double edges: a halfedge is known by its ends
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> by_ends;
  for (std::uint32_t h = 0; h < structure.num_halfedges(); ++h)
    if (!by_ends.emplace(std::make_pair(structure.source(h), structure.target(h)), h).second)
      return "two halfedges have the ends of " + std::to_string(h);
  std::vector<std::uint32_t> image(table.num_halfedges());
  for (std::uint32_t h = 0; h < image.size(); ++h) {
    const auto it = by_ends.find(std::make_pair(table.source(h), table.target(h)));
    if (it == by_ends.end())
      return "no halfedge has the ends of " + std::to_string(h);
    image[h] = it->second;
  }
  for (std::uint32_t h = 0; h < image.size(); ++h) {
    if (structure.next(image[h]) != image[table.next(h)])
      return "next of " + std::to_string(h);
    if (structure.prev(image[h]) != image[table.prev(h)])
      return "prev of " + std::to_string(h);
    if (structure.opposite(image[h]) != image[table.opposite(h)])
      return "opposite of " + std::to_string(h);
  }
  for (std::uint32_t v = 0; v < table.num_vertices(); ++v)
    if (structure.target(structure.halfedge_of_vertex(v)) != v)
      return "halfedge of vertex " + std::to_string(v);
  return "";
}

template <class Structure>
std::string difference(std::size_t num_vertices, const test::Triangles& triangles)
{
  const Table table(num_vertices, triangles);
  return difference(Structure(table), table);
}

template <class Structure>
class Papers_structures : public testing::Test
{};

typedef testing::Types<Half_edge_arrays, Winged_edge_arrays> Structures;
TYPED_TEST_SUITE(Papers_structures, Structures);

TYPED_TEST(Papers_structures, agree_with_the_corner_table_on_all_small_spheres_and_tori)
{
  for (int n = 4; n <= 8; ++n)
    for (const auto& triangles : test::all_sphere_triangulations(n))
      ASSERT_EQ(difference<TypeParam>(n, triangles), "") << testing::PrintToString(triangles);
  for (int n = 7; n <= 8; ++n)
    for (const auto& triangles : test::all_torus_triangulations(n))
      ASSERT_EQ(difference<TypeParam>(n, triangles), "") << testing::PrintToString(triangles);
}

TYPED_TEST(Papers_structures, agree_with_the_corner_table_on_random_surfaces)
{
  for (unsigned int seed = 0; seed < test::scaled(60); ++seed) {
    const test::Soup soup = test::shuffled(test::closed_surface(seed % 4, 20 + 10 * seed, seed), seed);
    ASSERT_EQ(difference<TypeParam>(soup.num_vertices, soup.triangles), "") << "seed " << seed;
  }
}

TYPED_TEST(Papers_structures, store_19_references_a_vertex)
{
  const test::Soup soup = test::regular_sphere(static_cast<std::uint32_t>(test::scaled(100000)));
  const TypeParam structure(Table(soup.num_vertices, soup.triangles));
  // 6n - 12 halfedges of three references, n vertices of one
  EXPECT_EQ(structure.num_references(), 19 * soup.num_vertices - 36);
}

TYPED_TEST(Papers_structures, refuse_borders)
{
  const test::Triangles triangle = { { 0, 1, 2 } };
  EXPECT_THROW(TypeParam(Table(3, triangle)), std::invalid_argument);
}

} // namespace
