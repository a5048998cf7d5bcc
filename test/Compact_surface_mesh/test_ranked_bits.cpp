// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Ranks and selections are compared with counts.

#include <CGAL/Compact_surface_mesh/internal/Ranked_bits.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <vector>

namespace {

void check(const std::vector<bool>& bits)
{
  const CGAL::internal::Ranked_bits ranked(bits.size(), [&](std::size_t i) { return bits[i]; });
  std::size_t count = 0;
  for (std::size_t i = 0; i < bits.size(); ++i) {
    ASSERT_EQ(ranked[i], bits[i]) << i << " of " << bits.size();
    ASSERT_EQ(ranked.rank(i), count) << i << " of " << bits.size();
    if (bits[i]) {
      ASSERT_EQ(ranked.select(count), i) << "of " << bits.size();
      ++count;
    }
  }
  EXPECT_EQ(ranked.rank(bits.size()), count);
  EXPECT_EQ(ranked.count(), count);
}

std::vector<bool> random_bits(std::size_t size, double density)
{
  std::mt19937 random(static_cast<unsigned int>(size));
  std::bernoulli_distribution is_set(density);
  std::vector<bool> bits(size);
  for (std::size_t i = 0; i < size; ++i)
    bits[i] = is_set(random);
  return bits;
}

TEST(Ranked_bits, are_counted_and_found_at_all_densities)
{
  for (const double density : {0., 0.001, 0.1, 0.5, 0.9, 0.999, 1.})
    for (const std::size_t size : {1, 63, 64, 65, 511, 512, 513, 1000, 100000})
      check(random_bits(size, density));
}

TEST(Ranked_bits, are_found_where_ones_stand_in_heaps)
{
  std::vector<bool> bits(200000, false);
  for (const std::size_t heap : {0, 60, 70000, 70511, 130000, 199000})
    for (std::size_t i = 0; i < 1000; ++i)
      bits[heap + i] = true;
  check(bits);
}

TEST(Ranked_bits, of_nothing_are_empty)
{
  EXPECT_TRUE(CGAL::internal::Ranked_bits().empty());
  EXPECT_EQ(CGAL::internal::Ranked_bits().count(), 0u);
}

} // namespace
