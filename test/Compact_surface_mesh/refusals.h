// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_REFUSALS_H
#define TEST_COMPACT_SURFACE_MESH_REFUSALS_H

// What constructions throw, and whether it is so.

#include "damaged_soups.h"
#include "soup_oracle.h"

#include <CGAL/Compact_surface_mesh/Mesh_defect_exception.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace test {

/// The defect that `make()` throws, if it throws.
template <class Make>
std::vector<Defect> thrown_by(const Make& make)
{
  try {
    make();
  } catch (const CGAL::Mesh_defect_exception& e) {
    return {Defect(e.defect(), e.element())};
  }
  return {};
}

/// For messages.
inline std::string text(const std::vector<Defect>& thrown)
{
  return thrown.empty() ? "nothing" : CGAL::Mesh_defect_exception(thrown[0].first, thrown[0].second).what();
}
inline std::string text(CGAL::Mesh_defect defect, std::size_t element) { return text({Defect(defect, element)}); }

template <class Make>
std::string refusal(const Make& make) { return text(thrown_by(make)); }

/// How often each defect, at element 0, or "nothing" was thrown.
typedef std::map<std::string, std::size_t> Thrown_counts;

/// What is wrong with what was thrown for an input with these defects, or nothing.
inline std::string error_of_refusal(const std::set<Defect>& defects, const std::vector<Defect>& thrown,
                                    Thrown_counts& met)
{
  ++met[thrown.empty() ? "nothing" : text(thrown[0].first, 0)];
  if (defects.empty())
    return thrown.empty() ? "" : "is refused: " + text(thrown);
  if (thrown.empty())
    return "is taken, but " + text({*defects.begin()});
  return defects.count(thrown[0]) != 0 ? "" : "is refused for what is not so: " + text(thrown);
}

/// Expects error_of_construction(soup, met) to be nothing for random soups, and that all `defects` are met.
template <class Error_of_construction>
void expect_random_soups_are_right(const std::vector<Polygon_soup>& surfaces, std::size_t num_soups,
                                   const Error_of_construction& error_of_construction,
                                   const std::vector<CGAL::Mesh_defect>& defects)
{
  const unsigned int seed = 2;
  std::cout << "seed " << seed << ", " << num_soups << " soups" << std::endl;
  std::mt19937 rng(seed);
  Thrown_counts met, ignored;
  for (std::size_t i = 0; i < num_soups; ++i) {
    const Polygon_soup soup = random_soup(surfaces, rng);
    const std::string error = error_of_construction(soup, met);
    const auto fails = [&](const Polygon_soup& s) { return !error_of_construction(s, ignored).empty(); };
    if (!error.empty()) {
      const Polygon_soup smallest = smallest_failing(soup, fails);
      FAIL() << "soup " << i << " " << error << "\n" << soup << "\nand so fails "
             << smallest << ", which " << error_of_construction(smallest, ignored);
    }
  }
  for (const CGAL::Mesh_defect defect : defects)
    EXPECT_LT(num_soups / 500, met[text(defect, 0)]) << text(defect, 0);
  EXPECT_LT(num_soups / 20, met["nothing"]);
}

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_REFUSALS_H
