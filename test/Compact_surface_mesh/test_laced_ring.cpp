// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The laced ring beneath its operators: that there is a ring, that triangles are sorted by their edges on it
// as the paper does, and that what is stored is what the paper's formula says.

#include "closed_surfaces.h"
#include "generated_surfaces.h"
#include "generated_triangulations.h"
#include "layout_of_soup.h"
#include "layout_oracle.h"
#include "refusals.h"
#include "test_scale.h"

#include <CGAL/Compact_surface_mesh/layouts/Laced_ring_layout.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace {

// Sorts the triangles of a closed connected surface by nothing but the numbers of their vertices.
class Kinds_of_triangles
{
public:
  Kinds_of_triangles(const test::Soup& soup, const std::vector<std::uint32_t>& numbers, std::size_t ring_size)
    : m_table(soup.num_vertices, soup.triangles), m_numbers(numbers), m_ring_size(ring_size),
      m_skips_wart(soup.triangles.size(), false)
  {
    for (std::uint32_t f = 0; f < m_table.num_faces(); ++f)
      for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h)
        if (num_ring_edges(f) == 0 && num_ring_edges(neighbor(h)) == 2)
          m_skips_wart[f] = true;

  }

  std::size_t num_edges_on_ring() const
  {
    std::size_t count = 0;
    for (std::uint32_t f = 0; f < m_table.num_faces(); ++f)
      count += num_ring_edges(f);
    return count / 2;
  }

  CGAL::Laced_ring_counts counts() const
  {
    CGAL::Laced_ring_counts counts = { m_ring_size, m_table.num_vertices() - m_ring_size, 0, 0, 0, 0 };
    for (std::uint32_t f = 0; f < m_table.num_faces(); ++f) {
      if (is_t0(f)) {
        ++counts.num_t0;
        continue;
      }
      counts.num_skipped_warts += m_skips_wart[f] ? 1 : 0;
      const std::uint32_t h = 3 * f;
      counts.num_irregular += is_t0(neighbor(h)) || is_t0(neighbor(h + 1)) || is_t0(neighbor(h + 2)) ? 1 : 0;
    }
    return counts;
  }

private:
  std::uint32_t neighbor(std::uint32_t h) const { return m_table.face(m_table.opposite(h)); }
  bool is_t0(std::uint32_t f) const { return num_ring_edges(f) == 0 && !m_skips_wart[f]; }

  std::size_t num_ring_edges(std::uint32_t f) const
  {
    std::size_t count = 0;
    for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
      const std::size_t u = m_numbers[m_table.source(h)], v = m_numbers[m_table.target(h)];
      if (u < m_ring_size && v < m_ring_size && ((u + 1) % m_ring_size == v || (v + 1) % m_ring_size == u))
        ++count;
    }
    return count;
  }

  const CGAL::Corner_table<> m_table;
  const std::vector<std::uint32_t>& m_numbers;
  const std::size_t m_ring_size;
  std::vector<bool> m_skips_wart;
};

template <class Layout>
std::size_t bytes(const Layout& layout, const std::vector<std::string>& arrays)
{
  std::size_t sum = 0;
  for (const auto& array : layout.memory())
    if (std::find(arrays.begin(), arrays.end(), array.first) != arrays.end())
      sum += array.second;
  return sum;
}

const std::vector<std::string> tables = { "L and R", "irregular and long", "T0", "isolated vertices" };

// What differs from the paper's sections 4.3 and 5, and from its formulas of the cost in section 8.
template <class Layout>
void check_counts_and_cost(const test::Soup& soup)
{
  CGAL::Input_images<> images;
  const Layout layout = test::layout_of<Layout>(test::soup_of(soup), images);
  const CGAL::Laced_ring_counts counts = layout.counts();
  const Kinds_of_triangles kinds(soup, images.vertices, counts.num_ring_vertices);
  const CGAL::Laced_ring_counts expected = kinds.counts();
  EXPECT_EQ(kinds.num_edges_on_ring(), counts.num_ring_vertices);
  EXPECT_EQ(counts.num_isolated_vertices, expected.num_isolated_vertices);
  EXPECT_EQ(counts.num_t0, expected.num_t0);
  EXPECT_EQ(counts.num_skipped_warts, expected.num_skipped_warts);
  EXPECT_EQ(counts.num_irregular, expected.num_irregular);
  const std::size_t entry_bytes = Layout::name() == "laced-ring" ? 4 : 2;
  EXPECT_EQ(bytes(layout, tables), 2 * entry_bytes * counts.num_ring_vertices
                                       + 4 * (6 * counts.num_t0 + 3 * counts.num_irregular + counts.num_long
                                              + counts.num_isolated_vertices));
}

template <class Layout>
class Laced_rings : public testing::Test
{};
typedef testing::Types<CGAL::Laced_ring_layout<>, CGAL::Laced_ring_layout<std::uint32_t, std::uint16_t>> Both_forms;
TYPED_TEST_SUITE(Laced_rings, Both_forms);

TYPED_TEST(Laced_rings, have_the_kinds_of_triangles_and_the_cost_that_the_paper_says)
{
  const std::uint32_t n = static_cast<std::uint32_t>(test::scaled(20000)) + 100;
  for (const test::Soup& soup :
       { test::octasphere(1), test::octasphere(5), test::random_triangulation(n, 1), test::stacked_triangulation(n, 2),
         test::double_wheel(n), test::shuffled(test::globe(100, 100), 3), test::torus_grid(30, 50),
         test::closed_surface(20, n, 4), test::sphere_with_far_handles(n, 50) })
    check_counts_and_cost<TypeParam>(soup);
}

TYPED_TEST(Laced_rings, pass_all_or_nearly_all_vertices_of_regular_meshes)
{
  for (const test::Soup& soup : { test::octasphere(6), test::globe(200, 200), test::torus_grid(100, 100) }) {
    CGAL::Input_images<> images;
    const TypeParam layout = test::layout_of<TypeParam>(test::soup_of(soup), images);
    EXPECT_LE(layout.counts().num_isolated_vertices, soup.num_vertices / 1000);
    EXPECT_LE(100 * layout.counts().num_t0, 2 * soup.triangles.size());
  }
}

// With the numbers of triangles and edges, for which there are lists of what is off the ring.
TYPED_TEST(Laced_rings, of_regular_meshes_take_two_hundredths_more_in_all_than_the_formula)
{
  for (const test::Soup& soup : { test::octasphere(6), test::globe(200, 200), test::torus_grid(100, 100) }) {
    CGAL::Input_images<> images;
    const TypeParam layout = test::layout_of<TypeParam>(test::soup_of(soup), images);
    std::size_t all = 0;
    for (const auto& array : layout.memory())
      all += array.second;
    EXPECT_LE(100 * all, 102 * bytes(layout, tables));
  }
}

// There, faces and edges are numbered by lists that are not empty.
TYPED_TEST(Laced_rings, are_right_on_regular_meshes_with_few_handles_and_borders)
{
  for (const test::Soup& soup : { test::sphere_with_far_handles(3000, 5), test::torus_grid(30, 40),
                                  test::mesh_with_borders(3000, 3, 1), test::shuffled(test::globe(40, 40), 3) })
    EXPECT_EQ(test::difference_from_soup<TypeParam>(test::soup_of(soup)), "");
}

// The hubs are far away from all but a few vertices.
TEST(Laced_ring, of_offsets_refers_to_what_is_far_away_by_long_references)
{
  CGAL::Input_images<> images;
  typedef CGAL::Laced_ring_layout<std::uint32_t, std::uint16_t> Layout;
  const Layout layout = test::layout_of<Layout>(test::soup_of(test::double_wheel(100000)), images);
  EXPECT_GT(layout.counts().num_long, 10000u);
}

// Up to their bound any sphere, behind it one whose ring is good enough, or none.
template <class Layout>
void check_bound(std::uint32_t largest)
{
  const std::uint32_t most = static_cast<std::uint32_t>(Layout::max_vertices());
  std::size_t num_refused = 0;
  for (std::uint32_t n = most; n <= largest; n += 1 + n / 20)
    for (const test::Soup& soup :
         { test::random_triangulation(n, 4), test::double_wheel(n), test::stacked_at_hub(n) }) {
      std::string difference;
      const auto thrown =
          test::thrown_by([&] { difference = test::difference_from_table<Layout>(n, soup.triangles); });
      EXPECT_EQ(difference, "") << n;
      if (thrown.empty())
        continue;
      ++num_refused;
      EXPECT_EQ(thrown[0].first, CGAL::Mesh_defect::too_many_elements) << n;
      EXPECT_GT(n, most);
    }
  EXPECT_GT(num_refused, 0u);
}

TEST(Laced_ring, of_few_bits_holds_as_many_vertices_as_it_says)
{
  check_bound<CGAL::Laced_ring_layout<std::uint8_t>>(60);
  if (test::scaled(1000) < 1000)
    return; // the others take long
  check_bound<CGAL::Laced_ring_layout<std::uint16_t>>(12000);
  check_bound<CGAL::Laced_ring_layout<std::uint16_t, std::uint8_t>>(4000);
}

TEST(Filled_slots, have_numbers_without_holes)
{
  typedef CGAL::internal::Filled_slots<std::uint32_t> Filled_slots;
  std::mt19937 rng(1);
  for (std::uint32_t num_slots = 0; num_slots < 60; ++num_slots)
    for (unsigned int k = 0; k < 20; ++k) { // the dead ones more or less near the end
      std::vector<std::uint32_t> dead, live;
      for (std::uint32_t slot = 0; slot < num_slots; ++slot)
        (rng() % 20 < (slot % 3 == 0 ? k : slot + k > num_slots ? 20 - k : 1) ? dead : live).push_back(slot);
      const std::size_t num_dead = dead.size();
      const Filled_slots slots(num_slots, std::move(dead));
      ASSERT_EQ(slots.count(), live.size());
      EXPECT_LE(slots.bytes(), 2 * num_dead * sizeof(std::uint32_t));
      std::vector<bool> is_used(live.size(), false);
      for (const std::uint32_t slot : live) {
        const std::uint32_t number = slots.number(slot);
        ASSERT_LT(number, live.size());
        ASSERT_FALSE(is_used[number]);
        is_used[number] = true;
        EXPECT_EQ(slots.slot(number), slot);
        EXPECT_TRUE(slot >= live.size() || number == slot);
      }
    }
}

TEST(Rings, go_round_each_cycle)
{
  typedef CGAL::internal::Rings<std::uint32_t> Rings;
  for (const std::vector<std::uint32_t>& sizes :
       { std::vector<std::uint32_t>{ 5 }, { 4, 4 }, { 60, 4, 4, 64 }, { 64, 64, 7, 200, 4 } }) {
    std::vector<std::uint32_t> starts, next;
    for (const std::uint32_t size : sizes) {
      const std::uint32_t start = static_cast<std::uint32_t>(next.size());
      starts.push_back(start);
      for (std::uint32_t i = 1; i < size; ++i)
        next.push_back(start + i);
      next.push_back(start);
    }
    const Rings rings(next.size(), std::move(starts));
    ASSERT_EQ(rings.size(), next.size());
    for (std::uint32_t v = 0; v < next.size(); ++v) {
      EXPECT_EQ(rings.next(v), next[v]);
      EXPECT_EQ(rings.prev(next[v]), v);
    }
  }
}

} // namespace
