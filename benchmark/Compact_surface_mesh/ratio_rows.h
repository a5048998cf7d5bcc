// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef BENCHMARK_COMPACT_SURFACE_MESH_RATIO_ROWS_H
#define BENCHMARK_COMPACT_SURFACE_MESH_RATIO_ROWS_H

// What a comparison has measured, printed as a table and written as comma-separated values.

#include <cstddef>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

struct Measured_structure
{
  std::string name;
  std::string order;
  double bytes_per_vertex; ///< of connectivity
};

struct Ratio
{
  double ns_per_vertex;
  double to_input_order; ///< to `Surface_mesh` in the order of the input
  double to_our_order;   ///< to `Surface_mesh` in the order of the parents layouts
};

struct Ratio_row
{
  std::string kernel;
  std::string way;
  std::vector<Ratio> ratios; ///< one a structure
};

/// What is measured on one input.
struct Measured_input
{
  std::string name;
  std::size_t num_vertices;
  std::vector<Measured_structure> structures;
  std::vector<Ratio_row> rows;
};

/// Prints a table, row by row.
class Ratio_table
{
public:
  explicit Ratio_table(std::ostream& out) : m_out(out) {}

  void print_heading(const Measured_input& input) const
  {
    m_out << '\n' << input.name << ", " << input.num_vertices << " vertices\n";
    print("", input.structures, [](const Measured_structure& s) { return s.name; });
    print("", input.structures, [](const Measured_structure& s) { return s.order; });
    print("bytes per vertex", input.structures, [](const Measured_structure& s) { return fixed(s.bytes_per_vertex); });
    print("ns per vertex  /input  /our", input.structures, [](const Measured_structure&) { return std::string(); });
  }

  void print_row(const Ratio_row& row) const
  {
    print(row.kernel + ", " + row.way, row.ratios, [](const Ratio& r) {
      return fixed(r.ns_per_vertex) + "  " + fixed(r.to_input_order) + "  " + fixed(r.to_our_order);
    });
  }

private:
  static std::string fixed(double x)
  {
    std::ostringstream out;
    out << std::fixed << std::setprecision(2) << x;
    return out.str();
  }

  template <class Cells, class Text>
  void print(const std::string& name, const Cells& cells, const Text& text) const
  {
    m_out << std::left << std::setw(38) << name << std::right;
    for (const auto& cell : cells)
      m_out << std::setw(25) << text(cell);
    m_out << std::endl;
  }

  std::ostream& m_out;
};

inline void write_csv(std::ostream& out, const std::vector<Measured_input>& inputs, const std::string& machine)
{
  out << "# " << machine << '\n'
      << "input,vertices,kernel,way,structure,order,bytes_per_vertex,ns_per_vertex,"
         "ratio_to_input_order,ratio_to_our_order\n";
  for (const Measured_input& input : inputs)
    for (const Ratio_row& row : input.rows)
      for (std::size_t i = 0; i < row.ratios.size(); ++i) {
        const Measured_structure& s = input.structures[i];
        out << input.name << ',' << input.num_vertices << ",\"" << row.kernel << "\"," << row.way << ',' << s.name
            << ',' << s.order << ',' << s.bytes_per_vertex << ',' << row.ratios[i].ns_per_vertex << ','
            << row.ratios[i].to_input_order << ',' << row.ratios[i].to_our_order << '\n';
      }
}

#endif // BENCHMARK_COMPACT_SURFACE_MESH_RATIO_ROWS_H
