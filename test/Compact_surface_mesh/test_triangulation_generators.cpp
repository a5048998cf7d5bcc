// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The two sources of triangulations that other tests draw from: the uniform random
// generator and the enumeration of the small ones.

#include "small_triangulations.h"

#include <CGAL/Schnyder_woods/random_planar_triangulation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace {

using test::Triangle;
using test::Triangles;

CGAL::Random random_source(unsigned int seed)
{
  std::cout << "seed " << seed << std::endl;
  return CGAL::Random(seed);
}

// Tutte's number of rooted simple triangulations with n vertices.
std::size_t tutte_number(std::size_t n)
{
  double product = 2; // 2 (4k + 1)! / ((k + 1)! (3k + 2)!), small enough here to be exact
  const std::size_t k = n - 3;
  for (std::size_t i = 3 * k + 3; i <= 4 * k + 1; ++i)
    product *= static_cast<double>(i);
  for (std::size_t i = 2; i <= k + 1; ++i)
    product /= static_cast<double>(i);
  return k == 0 ? 1 : static_cast<std::size_t>(std::llround(product));
}

// By its definition alone: says what keeps these triangles from being a simple
// triangulation of the sphere with all of the n vertices, or nothing. Each directed
// edge must occur once and have its reverse; the triangles at a vertex must form one
// cycle; then the surface is closed, and connected with Euler characteristic 2.
template <class Index>
std::string defect(const std::vector<std::array<Index, 3> >& triangles, std::size_t n)
{
  if (triangles.size() != 2 * n - 4)
    return "number of triangles";
  std::vector<std::array<std::size_t, 3> > edges; // source, target, vertex to the left
  for (const std::array<Index, 3>& t : triangles)
    for (int i = 0; i < 3; ++i) {
      if (t[i] >= n)
        return "vertex out of range";
      edges.push_back({{t[i], t[(i + 1) % 3], t[(i + 2) % 3]}});
    }
  std::sort(edges.begin(), edges.end());
  const auto left_of = [&](std::size_t v, std::size_t w) {
    const auto it = std::lower_bound(edges.begin(), edges.end(), std::array<std::size_t, 3>{{v, w, 0}});
    return it != edges.end() && (*it)[0] == v && (*it)[1] == w ? (*it)[2] : n;
  };
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (edges[i][0] == edges[i][1])
      return "loop";
    if (i > 0 && edges[i][0] == edges[i - 1][0] && edges[i][1] == edges[i - 1][1])
      return "double edge";
    if (left_of(edges[i][1], edges[i][0]) == n)
      return "border";
  }
  std::vector<bool> is_reached(n, false);
  std::vector<std::size_t> reached(1, 0);
  is_reached[0] = true;
  for (std::size_t r = 0; r < reached.size(); ++r) {
    const std::size_t v = reached[r];
    const auto first = std::lower_bound(edges.begin(), edges.end(), std::array<std::size_t, 3>{{v, 0, 0}});
    std::size_t degree = 0, link_length = 0;
    for (auto it = first; it != edges.end() && (*it)[0] == v; ++it, ++degree)
      if (!is_reached[(*it)[1]]) {
        is_reached[(*it)[1]] = true;
        reached.push_back((*it)[1]);
      }
    if (degree == 0)
      return "isolated vertex";
    std::size_t w = (*first)[1];
    do { w = left_of(v, w); ++link_length; } while (w != (*first)[1] && link_length <= degree);
    if (link_length != degree)
      return "non-manifold vertex";
  }
  return reached.size() == n ? "" : "several components";
}

// All words of `size` letters with `num_ones` ones, in lexicographic order.
template <class Function>
void for_each_word(std::size_t size, std::size_t num_ones, Function function)
{
  std::vector<bool> word(size, false);
  std::fill(word.end() - static_cast<std::ptrdiff_t>(num_ones), word.end(), true);
  do
    function(word);
  while (std::next_permutation(word.begin(), word.end()));
}

// How far the numbers of occurrences are, in standard deviations of the chi-square
// statistic, from those of a uniform distribution with this mean number.
template <class Key>
double deviation_from_uniform(const std::map<Key, std::size_t>& occurrences, std::size_t mean)
{
  double chi_square = 0;
  for (const auto& key_and_count : occurrences) {
    const double difference = static_cast<double>(key_and_count.second) - static_cast<double>(mean);
    chi_square += difference * difference / static_cast<double>(mean);
  }
  const double degrees_of_freedom = static_cast<double>(occurrences.size()) - 1;
  return std::abs(chi_square - degrees_of_freedom) / std::sqrt(2 * degrees_of_freedom);
}

// How often each rooted triangulation with n vertices comes from a word and a choice
// of the root.
std::map<Triangles, std::size_t> occurrences_over_all_words(std::size_t n)
{
  std::map<Triangles, std::size_t> occurrences;
  for_each_word(4 * n - 10, n - 3, [&](const std::vector<bool>& word) {
    for (const bool root_at_second : {false, true}) {
      const Triangles t = CGAL::internal::triangulation_of_word<std::uint32_t>(word, root_at_second);
      ++occurrences[test::Oriented_map(t).code(0)];
    }
  });
  return occurrences;
}

} // namespace

TEST(Small_triangulations, are_as_many_as_tutte_counts_when_rooted)
{
  const std::size_t expected[] = {1, 3, 13, 68, 399, 2530, 16965};
  for (int n = 4; n <= 10; ++n) {
    EXPECT_EQ(expected[n - 4], test::rooted_count(test::all_sphere_triangulations(n))) << "n = " << n;
    EXPECT_EQ(expected[n - 4], tutte_number(static_cast<std::size_t>(n))) << "n = " << n;
  }
}

TEST(Small_triangulations, are_as_many_as_known_up_to_mirror_images)
{
  const std::size_t expected[] = {1, 1, 2, 5, 14, 50, 233};
  for (int n = 4; n <= 10; ++n)
    EXPECT_EQ(expected[n - 4], test::unoriented_count(test::all_sphere_triangulations(n))) << "n = " << n;
}

TEST(Small_triangulations, are_simple_triangulations_of_the_sphere)
{
  for (int n = 4; n <= 9; ++n)
    for (const Triangles& t : test::all_sphere_triangulations(n))
      ASSERT_EQ("", defect(t, static_cast<std::size_t>(n))) << "n = " << n;
}

TEST(Small_triangulations, have_a_canonical_code_that_does_not_depend_on_names_but_on_orientation)
{
  std::mt19937 rng(1); // std::shuffle() does not take a CGAL::Random
  std::size_t num_chiral = 0;
  for (const Triangles& t : test::all_sphere_triangulations(8)) {
    std::vector<std::uint32_t> name(8);
    std::iota(name.begin(), name.end(), 10u);
    std::shuffle(name.begin(), name.end(), rng);
    Triangles renamed = t;
    for (Triangle& r : renamed) {
      for (std::uint32_t& v : r)
        v = name[v];
      std::rotate(r.begin(), r.begin() + rng() % 3, r.end());
    }
    std::shuffle(renamed.begin(), renamed.end(), rng);
    EXPECT_EQ(t, test::canonical_code(renamed));
    num_chiral += t != test::canonical_code(test::mirrored(renamed)) ? 1 : 0;
  }
  EXPECT_EQ(test::all_sphere_triangulations(8).size(), 14 + num_chiral / 2);
}

TEST(Random_planar_triangulation, comes_from_equally_many_words_whichever_it_is)
{
  for (std::size_t n = 3; n <= 9; ++n) {
    const std::map<Triangles, std::size_t> occurrences = occurrences_over_all_words(n);
    EXPECT_EQ(tutte_number(n), occurrences.size()) << "n = " << n;
    for (const auto& triangulation_and_count : occurrences)
      ASSERT_EQ(2 * (n - 2) * (2 * n - 5), triangulation_and_count.second) << "n = " << n;
  }
}

TEST(Random_planar_triangulation, can_be_every_enumerated_one_with_every_root)
{
  for (int n = 4; n <= 8; ++n) {
    std::set<Triangles> enumerated, generated;
    for (const Triangles& t : test::all_sphere_triangulations(n))
      for (const Triangles& code : test::Oriented_map(t).all_codes())
        enumerated.insert(code);
    for (const auto& triangulation_and_count : occurrences_over_all_words(static_cast<std::size_t>(n)))
      generated.insert(triangulation_and_count.first);
    EXPECT_TRUE(enumerated == generated) << "n = " << n;
  }
}

TEST(Random_planar_triangulation, comes_from_a_word_that_is_drawn_uniformly)
{
  CGAL::Random rng = random_source(9);
  const std::size_t num_words = 84, mean = 500; // 9 letters, 3 ones
  std::map<std::vector<bool>, std::size_t> occurrences;
  for (std::size_t i = 0; i < mean * num_words; ++i)
    ++occurrences[CGAL::internal::random_binary_word(9, 3, rng)];
  EXPECT_EQ(num_words, occurrences.size());
  for (const auto& word_and_count : occurrences)
    ASSERT_EQ(3, std::count(word_and_count.first.begin(), word_and_count.first.end(), true));
  EXPECT_LT(deviation_from_uniform(occurrences, mean), 4);
}

TEST(Random_planar_triangulation, is_drawn_uniformly)
{
  CGAL::Random rng = random_source(2);
  for (std::size_t n = 5; n <= 8; ++n) {
    const std::size_t num_classes = tutte_number(n), mean = 500;
    std::map<Triangles, std::size_t> occurrences;
    for (std::size_t i = 0; i < mean * num_classes; ++i)
      ++occurrences[test::Oriented_map(CGAL::random_planar_triangulation(n, rng)).code(0)];
    EXPECT_EQ(num_classes, occurrences.size()) << "n = " << n;
    EXPECT_LT(deviation_from_uniform(occurrences, mean), 4) << "n = " << n;
  }
}

TEST(Random_planar_triangulation, is_a_simple_triangulation_of_the_sphere_with_its_root_in_front)
{
  CGAL::Random rng = random_source(3);
  for (const std::size_t n : {3, 4, 5, 6, 7, 10, 20, 50, 100, 1000, 10000, 100000})
    for (int repetition = 0; repetition < (n <= 100 ? 200 : 2); ++repetition) {
      const auto triangles = CGAL::random_planar_triangulation(n, rng);
      ASSERT_EQ("", defect(triangles, n)) << "n = " << n << ", repetition " << repetition;
      ASSERT_EQ(0u, triangles[0][0]);
      ASSERT_EQ(1u, triangles[0][1]);
    }
}

TEST(Random_planar_triangulation, with_three_vertices_is_a_triangle_with_two_sides)
{
  CGAL::Random rng = random_source(4);
  EXPECT_EQ((Triangles{{0, 1, 2}, {2, 1, 0}}), CGAL::random_planar_triangulation(3, rng));
}

TEST(Random_planar_triangulation, has_the_degrees_of_the_known_distribution)
{
  const std::size_t n = 1000000;
  CGAL::Random rng = random_source(5);
  std::vector<std::size_t> degree(n, 0);
  for (const Triangle& t : CGAL::random_planar_triangulation(n, rng))
    for (const std::uint32_t v : t)
      ++degree[v];
  for (int i = 3; i <= 12; ++i) {
    double probability = 16. * (i - 2) / i;
    for (int k = 1; k <= i; ++k)
      probability *= 3. / 16 * (k < i ? double(i - 1 + k) / k : 1.);
    // The degrees depend on each other, which makes the number vary less than that
    // of independent ones.
    const double deviation = std::sqrt(double(n) * probability * (1 - probability));
    const auto number = std::count(degree.begin(), degree.end(), static_cast<std::size_t>(i));
    EXPECT_NEAR(double(n) * probability, double(number), 5 * deviation) << "degree " << i;
  }
}

TEST(Random_planar_triangulation, is_determined_by_the_state_of_the_random_source)
{
  CGAL::Random rng = random_source(6), same_rng(6);
  const auto first = CGAL::random_planar_triangulation(1000, rng);
  const auto second = CGAL::random_planar_triangulation(1000, rng);
  EXPECT_EQ(first, CGAL::random_planar_triangulation(1000, same_rng));
  EXPECT_EQ(second, CGAL::random_planar_triangulation(1000, same_rng));
  EXPECT_NE(first, second);
}

TEST(Random_planar_triangulation, does_not_depend_on_the_index_type)
{
  CGAL::Random rng = random_source(7), same_rng(7);
  const auto narrow = CGAL::random_planar_triangulation<std::uint16_t>(10000, rng);
  const auto wide = CGAL::random_planar_triangulation<std::uint64_t>(10000, same_rng);
  ASSERT_EQ(narrow.size(), wide.size());
  for (std::size_t i = 0; i < wide.size(); ++i)
    for (int j = 0; j < 3; ++j)
      ASSERT_EQ(wide[i][j], narrow[i][j]);
}

TEST(Random_planar_triangulation, is_refused_where_the_index_type_cannot_number_its_halfedges)
{
  CGAL::Random rng = random_source(8);
  const auto refused = [&](auto index, std::size_t n) {
    try {
      CGAL::random_planar_triangulation<decltype(index)>(n, rng);
    } catch (const CGAL::Mesh_defect_exception& e) {
      return e.defect() == CGAL::Mesh_defect::too_many_elements && e.element() == n;
    }
    return false;
  };
  const std::size_t most = 2 + 65535 / 6;
  EXPECT_FALSE(refused(std::uint16_t(), most));
  EXPECT_TRUE(refused(std::uint16_t(), most + 1));
  EXPECT_TRUE(refused(std::uint32_t(), 2 + 4294967295u / 6 + 1));
  EXPECT_TRUE(refused(std::uint64_t(), static_cast<std::size_t>(-1)));
  EXPECT_EQ("", defect(CGAL::random_planar_triangulation<std::uint16_t>(most, rng), most));
}
