// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Searches by a directory are compared with those without.

#include <CGAL/Compact_surface_mesh/layouts/internal/Search_directory.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace {

template <class Index>
void check(const std::vector<Index>& keys)
{
  const auto key = [&](std::size_t i) { return keys[i]; };
  const CGAL::internal::Search_directory<Index> directory(keys.size(), key);
  EXPECT_LE(directory.bytes(), keys.size() / 2 * sizeof(Index));
  const auto check_search = [&](Index wanted) {
    const auto expected = std::lower_bound(keys.begin(), keys.end(), wanted) - keys.begin();
    ASSERT_EQ(directory.lower_bound(keys.size(), wanted, key), static_cast<std::size_t>(expected))
        << "of " << wanted << " among " << keys.size();
  };
  check_search(0);
  check_search((std::numeric_limits<Index>::max)());
  for (const Index k : keys) {
    check_search(k);
    check_search(static_cast<Index>(k - 1));
    check_search(static_cast<Index>(k + 1));
  }
}

template <class Index>
class Search_directory : public ::testing::Test
{};

using Indices = ::testing::Types<std::uint16_t, std::uint32_t>;
TYPED_TEST_SUITE(Search_directory, Indices);

TYPED_TEST(Search_directory, finds_what_a_binary_search_finds)
{
  std::mt19937 random(1);
  const double max = (std::numeric_limits<TypeParam>::max)();
  for (const double last : {1., 20., 1000., max}) // with many equal keys, and with few
    for (const double exponent : {1., 8.})        // evenly, and most of them at the beginning
      for (std::size_t size = 0; size < 300; ++size) {
        std::vector<TypeParam> keys(size);
        std::uniform_real_distribution<> uniform;
        for (TypeParam& k : keys)
          k = static_cast<TypeParam>(last * std::pow(uniform(random), exponent));
        std::sort(keys.begin(), keys.end());
        check(keys);
      }
}

TYPED_TEST(Search_directory, of_equal_keys_finds_the_first)
{
  check(std::vector<TypeParam>(100, 7));
  check(std::vector<TypeParam>(100, 0));
  check(std::vector<TypeParam>(100, (std::numeric_limits<TypeParam>::max)()));
}

TYPED_TEST(Search_directory, of_few_keys_takes_no_memory)
{
  const CGAL::internal::Search_directory<TypeParam> directory(15,
                                                              [](std::size_t i) { return static_cast<TypeParam>(i); });
  EXPECT_EQ(directory.bytes(), 0u);
  EXPECT_EQ(CGAL::internal::Search_directory<TypeParam>().bytes(), 0u);
}

} // namespace
