// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The layouts of the literature against the corner table.

#include "layout_suite.h"

#include <CGAL/Compact_surface_mesh/layouts/Laced_ring_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/SOT_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/SQuad_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/Schnyder_fronts_layout.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace test {

template <class Index>
struct Walks_to_targets<CGAL::SOT_layout<Index>> : std::true_type
{};
template <class Index>
struct Walks_to_targets<CGAL::SQuad_layout<Index>> : std::true_type
{};
template <int References, class Index>
struct Walks_to_targets<CGAL::Schnyder_fronts_layout<References, false, Index>> : std::true_type
{};

typedef testing::Types<CGAL::Schnyder_fronts_layout<6>,
                       CGAL::Schnyder_fronts_layout<5>,
                       CGAL::Schnyder_fronts_layout<4>,
                       CGAL::Schnyder_fronts_layout<5, true>,
                       CGAL::SOT_layout<>,
                       CGAL::SQuad_layout<>,
                       CGAL::SQuad_layout<std::uint64_t>,
                       CGAL::Laced_ring_layout<>,
                       CGAL::Laced_ring_layout<std::uint32_t, std::uint16_t>>
    Layouts_of_papers;
INSTANTIATE_TYPED_TEST_SUITE_P(Papers, Layouts, Layouts_of_papers);

} // namespace test

namespace {

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

} // namespace
