// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Layouts with few bits for their indices: what fits in, and what is refused.

#include "damaged_soups.h"
#include "generated_surfaces.h"
#include "generated_triangulations.h"
#include "layout_of_soup.h"
#include "layout_oracle.h"
#include "refusals.h"

#include <CGAL/Compact_surface_mesh/internal/Divided_index.h>
#include <CGAL/Compact_surface_mesh/layouts/Corner_table_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/SOT_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/SQuad_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/Schnyder_fronts_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/Schnyder_parents_layout.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace {

template <class Layout>
struct Layout_of_narrow_indices
  : public ::testing::Test
{};
using Narrow_layouts = ::testing::Types<
  CGAL::Schnyder_parents_layout<4, std::uint8_t>, CGAL::Schnyder_parents_layout<5, std::uint8_t>,
  CGAL::Schnyder_parents_layout<6, std::uint8_t>, CGAL::Schnyder_parents_layout<4, std::uint16_t>,
  CGAL::Schnyder_parents_layout<5, std::uint16_t>, CGAL::Schnyder_parents_layout<6, std::uint16_t>,
  CGAL::Schnyder_fronts_layout<6, false, std::uint8_t>, CGAL::Schnyder_fronts_layout<5, false, std::uint8_t>,
  CGAL::Schnyder_fronts_layout<4, false, std::uint8_t>, CGAL::Schnyder_fronts_layout<5, true, std::uint8_t>,
  CGAL::Schnyder_fronts_layout<4, false, std::uint16_t>, CGAL::Schnyder_fronts_layout<5, true, std::uint16_t>,
  CGAL::Corner_table_layout<std::uint8_t>, CGAL::Corner_table_layout<std::uint16_t>,
  CGAL::SOT_layout<std::uint8_t>, CGAL::SQuad_layout<std::uint8_t>>;
TYPED_TEST_SUITE(Layout_of_narrow_indices, Narrow_layouts);

TYPED_TEST(Layout_of_narrow_indices, holds_as_many_vertices_as_it_says_and_refuses_one_more)
{
  using Index = typename TypeParam::Index;
  const std::uint32_t most = static_cast<std::uint32_t>(TypeParam::max_vertices());
  for (const test::Soup& soup : {test::random_triangulation(most, 4), test::double_wheel(most),
                           test::stacked_at_hub(most), test::stacked_triangulation(most, 4)})
    EXPECT_EQ("", test::difference_from_table<TypeParam>(most, soup.triangles));
  const test::Soup soup = test::double_wheel(most + 1);
  CGAL::Input_images<Index> images;
  images.vertices.assign(1, 7);
  EXPECT_EQ(CGAL::Mesh_defect::too_many_elements, test::thrown_by([&] {
    CGAL::Closed_triangulation<Index> closed{CGAL::Corner_table<Index>(soup.num_vertices, soup.triangles)};
    TypeParam(std::move(closed), images);
  }).at(0).first);
  EXPECT_EQ(std::vector<Index>(1, 7), images.vertices);
}

// Handles add records for sectors of vertices.
TYPED_TEST(Layout_of_narrow_indices, holds_a_torus_as_it_is_or_refuses_it)
{
  using Index = typename TypeParam::Index;
  std::size_t num_refused = 0;
  for (std::uint32_t n = 7; n <= 50; ++n) {
    const test::Soup torus = test::closed_surface(1, n, 1);
    const test::Polygon_soup soup = test::soup_of(torus);
    CGAL::Input_images<Index> images;
    images.vertices.assign(1, 7);
    TypeParam layout;
    const auto thrown = test::thrown_by([&] { layout = test::layout_of<TypeParam>(soup, images); });
    if (thrown.empty()) {
      EXPECT_EQ(test::Surface_oracle<TypeParam>(layout, soup, images.vertices).difference(), "") << n;
      continue;
    }
    ++num_refused;
    EXPECT_EQ(thrown[0].first, CGAL::Mesh_defect::too_many_elements) << n;
    EXPECT_EQ(images.vertices, std::vector<Index>(1, 7)) << n;
    EXPECT_GT(n + 4, TypeParam::max_vertices()) << n; // two special edges make four sectors
  }
  if (sizeof(Index) == 1) {
    EXPECT_GT(num_refused, 0u);
  } else
    EXPECT_EQ(num_refused, 0u);
}

TEST(Schnyder_parents_layout, of_16_bit_indices_holds_4096_vertices)
{
  EXPECT_EQ(4096u, (CGAL::Schnyder_parents_layout<4, std::uint16_t>::max_vertices()));
  EXPECT_EQ(std::size_t(1) << 28, CGAL::Schnyder_parents_layout<>::max_vertices());
}

TYPED_TEST(Layout_of_narrow_indices, is_empty_when_moved_from)
{
  using Index = typename TypeParam::Index;
  const auto size = [](const TypeParam& layout) {
    std::size_t bytes = 0;
    for (const auto& array : layout.memory())
      bytes += array.second;
    return bytes + layout.num_vertices() + layout.num_halfedges() + layout.num_edges() + layout.num_faces();
  };
  CGAL::Input_images<Index> images;
  CGAL::Closed_triangulation<Index> closed{CGAL::Corner_table<Index>(4, test::tetrahedron().faces)};
  TypeParam layout(std::move(closed), images);
  EXPECT_EQ(0u, closed.first_apex() + closed.table().num_vertices() + closed.table().num_halfedges());
  const std::size_t full = size(layout);
  TypeParam other(std::move(layout));
  EXPECT_EQ(0u, size(layout));
  layout = std::move(other);
  EXPECT_EQ(0u, size(other));
  EXPECT_EQ(full, size(layout));
  EXPECT_EQ(0u, size(TypeParam()));
}

template <class Index>
struct Divided_index
  : public ::testing::Test
{};
using Narrow_indices = ::testing::Types<std::uint8_t, std::uint16_t>;
TYPED_TEST_SUITE(Divided_index, Narrow_indices);

TYPED_TEST(Divided_index, stands_for_every_index_that_a_layout_has_and_for_null)
{
  using Divided = CGAL::internal::Divided_index<TypeParam>;
  const TypeParam null = std::numeric_limits<TypeParam>::max();
  EXPECT_TRUE(Divided().is_null());
  EXPECT_TRUE(Divided(null).is_null());
  EXPECT_EQ(TypeParam(Divided()), null);
  const unsigned most = 6 * static_cast<unsigned>(CGAL::Schnyder_parents_layout<4, TypeParam>::max_vertices());
  for (unsigned i = 0; i <= most; ++i) {
    const Divided d(static_cast<TypeParam>(i));
    ASSERT_EQ(unsigned(TypeParam(d)), i);
    ASSERT_EQ(d.quotient(), i / 6);
    ASSERT_EQ(d.remainder(), i % 6);
    ASSERT_EQ(Divided::of(static_cast<TypeParam>(i / 6), i % 6).code(), d.code());
    ASSERT_LT(d.code(), Divided(static_cast<TypeParam>(i + 1)).code());
  }
  for (unsigned i = most; i < null; ++i) // too large for all layouts
    ASSERT_TRUE(Divided(static_cast<TypeParam>(i)).is_null() || TypeParam(Divided(static_cast<TypeParam>(i))) == i);
}

} // namespace
