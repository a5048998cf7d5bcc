// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The numbers that benchmarks quote from the papers agree with what the papers say of them elsewhere.

#include "../../benchmark/Compact_surface_mesh/papers_figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace {

// CD18 4.2 gives the averages over the rows of table 3.
TEST(Papers_figures, ratios_of_degree_times_have_the_averages_of_the_text)
{
  for (const papers::Average_ratio& average : papers::average_ratios)
    for (const papers::Degree_column& column : papers::degree_columns)
      if (std::string(column.structure) == average.structure) {
        double sum = 0;
        for (const papers::Degree_times& row : papers::degree_times)
          sum += row.*column.ns / row.winged_edge;
        EXPECT_NEAR(sum / static_cast<double>(papers::degree_times.size()), average.degree, 0.005)
            << average.structure;
      }
}

// LR 8: 1 + f references, f = 6 T_0 + 3 T_irregular for a mesh without border whose ring has nearly all vertices; and
// 32 bits for each reference, half as many for the first one. Percentages have two digits.
TEST(Papers_figures, costs_of_rings_follow_from_the_counts_of_triangles)
{
  for (const papers::Ring_costs& row : papers::ring_costs) {
    const double references = 1 + 0.01 * (6 * row.t0 + 3 * row.t_irregular);
    EXPECT_NEAR(references, row.laced_ring_rpt, 0.004) << row.mesh;
    const double bits = 16 + 0.32 * (6 * row.bits_t0 + row.bits_t_long + 3 * row.bits_t_irregular);
    EXPECT_NEAR(bits, row.laced_ring_bpt, 0.07) << row.mesh;
  }
}

// LR's abstract.
TEST(Papers_figures, medians_of_rings_are_those_of_the_abstract)
{
  std::vector<double> references, bits;
  for (const papers::Ring_costs& row : papers::ring_costs) {
    references.push_back(row.laced_ring_rpt);
    bits.push_back(row.laced_ring_bpt);
  }
  const auto median = [](std::vector<double>& values) {
    std::sort(values.begin(), values.end());
    return (values[values.size() / 2] + values[(values.size() - 1) / 2]) / 2;
  };
  EXPECT_NEAR(median(references), 1.08, 0.005);
  EXPECT_NEAR(median(bits), 26.2, 0.05);
}

// CD18 1.2 and 4.4 quote LR's and SQuad's extremes per vertex, which has two triangles.
TEST(Papers_figures, extremes_of_rings_are_those_that_the_other_paper_quotes)
{
  const auto extremes = [](double papers::Ring_costs::*cost) {
    const auto range = std::minmax_element(papers::ring_costs.begin(), papers::ring_costs.end(),
                                           [=](const auto& a, const auto& b) { return a.*cost < b.*cost; });
    return std::make_pair(2 * (*range.first).*cost, 2 * (*range.second).*cost);
  };
  EXPECT_NEAR(extremes(&papers::Ring_costs::laced_ring_rpt).first, 2.04, 0.001);
  EXPECT_NEAR(extremes(&papers::Ring_costs::laced_ring_rpt).second, 3.16, 0.007);
  EXPECT_NEAR(extremes(&papers::Ring_costs::squad_rpt).first, 4.05, 0.005);
  EXPECT_NEAR(extremes(&papers::Ring_costs::squad_rpt).second, 4.3, 0.001);
  EXPECT_NEAR(extremes(&papers::Ring_costs::laced_ring_bpt).first, 37, 0.5);
  EXPECT_NEAR(extremes(&papers::Ring_costs::laced_ring_bpt).second, 90, 0.6);
}

TEST(Papers_figures, times_of_constructions_grow_with_the_size)
{
  for (std::size_t i = 1; i < papers::construction_times.size(); ++i) {
    const papers::Construction_times &a = papers::construction_times[i - 1], &b = papers::construction_times[i];
    EXPECT_LT(a.num_vertices, b.num_vertices);
    EXPECT_LT(a.half_edges, b.half_edges);
    EXPECT_LT(a.wood, b.wood);
    EXPECT_LT(a.layout, b.layout) << b.num_vertices;
  }
}

} // namespace
