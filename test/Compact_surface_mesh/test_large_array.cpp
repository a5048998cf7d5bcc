// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#include <CGAL/Compact_surface_mesh/internal/Large_array.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <numeric>
#include <utility>

namespace {

typedef CGAL::internal::Large_array<std::uint32_t> Array;

constexpr std::size_t huge_page = std::size_t(1) << 21;
constexpr std::size_t large = 2 * huge_page / sizeof(std::uint32_t);

bool starts_huge_page(const Array& a) { return reinterpret_cast<std::uintptr_t>(a.data()) % huge_page == 0; }

TEST(Large_array, starts_a_huge_page_from_two_of_them_on)
{
  EXPECT_TRUE(starts_huge_page(Array(large)));
  EXPECT_TRUE(starts_huge_page(Array(large + 1)));
  EXPECT_TRUE(starts_huge_page(Array(3 * large)));
}

TEST(Large_array, keeps_its_elements_when_it_becomes_large_and_small_again)
{
  Array a;
  for (std::uint32_t i = 0; i < large + 1000; ++i)
    a.push_back(i);
  Array expected(large + 1000);
  std::iota(expected.begin(), expected.end(), 0u);
  EXPECT_EQ(a, expected);
  Array copy(a), moved(std::move(a));
  EXPECT_EQ(copy, moved);
  moved.resize(10);
  moved.shrink_to_fit();
  copy.resize(10);
  EXPECT_EQ(copy, moved);
  copy.swap(moved);
  EXPECT_EQ(copy, moved);
}

TEST(Large_array, has_no_more_elements_than_memory_has_bytes)
{
  CGAL::internal::Huge_page_allocator<std::uint32_t> allocator;
  EXPECT_THROW(allocator.allocate((std::numeric_limits<std::size_t>::max)() / 2), std::bad_array_new_length);
}

} // namespace
