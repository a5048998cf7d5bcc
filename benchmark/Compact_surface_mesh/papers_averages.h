// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef BENCHMARK_COMPACT_SURFACE_MESH_PAPERS_AVERAGES_H
#define BENCHMARK_COMPACT_SURFACE_MESH_PAPERS_AVERAGES_H

// The averages over all meshes that CD18's text gives: how much slower than winged-edge.

#include "papers_figures.h"
#include "papers_measurement.h"
#include "papers_table.h"

#include <cstddef>
#include <string>
#include <vector>

namespace papers {

/// averages the columns with ratios of `tables`, which are those of CD18's table 3.
/// \pre there is a table, and all of them have the same rows and columns
inline Papers_table averages(const std::vector<Papers_table>& tables)
{
  const Papers_table& first = tables.front();
  Papers_table result{ "Averages of the ratios to winged-edge", std::to_string(tables.size()) + " meshes", 0,
                       "CD18 4.2, over its 12 meshes", {}, {} };
  for (const Papers_row& row : first.rows)
    result.rows.push_back({ row.name, {} });
  const std::string suffix = Measurement::ratio_suffix();
  for (std::size_t c = 0; c < first.columns.size(); ++c) {
    const std::string& name = first.columns[c].name;
    if (name.size() < suffix.size() || name.compare(name.size() - suffix.size(), suffix.size(), suffix) != 0)
      continue;
    result.columns.push_back(first.columns[c]);
    for (std::size_t r = 0; r < first.rows.size(); ++r) {
      double sum = 0;
      for (const Papers_table& table : tables)
        sum += table.rows[r].cells[c].measured.number;
      Papers_cell cell{ sum / static_cast<double>(tables.size()), {} };
      const Average_ratio* paper = find(average_ratios, first.rows[r].name);
      if (paper != nullptr && name == "degree" + suffix)
        cell.paper = paper->degree;
      if (paper != nullptr && name == "normals" + suffix)
        cell.paper = average_ratio_of_normals;
      result.rows[r].cells.push_back(cell);
    }
  }
  return result;
}

} // namespace papers

#endif // BENCHMARK_COMPACT_SURFACE_MESH_PAPERS_AVERAGES_H
