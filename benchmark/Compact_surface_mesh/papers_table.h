// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef BENCHMARK_COMPACT_SURFACE_MESH_PAPERS_TABLE_H
#define BENCHMARK_COMPACT_SURFACE_MESH_PAPERS_TABLE_H

// A table of what is measured with the paper's figure beside each number, printed and written as
// comma-separated values.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <limits>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/// A number, perhaps with a remark, or a text, or nothing.
struct Figure
{
  Figure() = default;
  Figure(double n, std::string remark = "") : number(n), text(std::move(remark)) {}
  Figure(std::string t) : text(std::move(t)) {}
  Figure(const char* t) : text(t) {}

  bool is_number() const { return !std::isnan(number); }
  bool is_empty() const { return !is_number() && text.empty(); }

  std::string printed(int digits) const
  {
    if (!is_number())
      return text;
    std::ostringstream out;
    out << std::fixed << std::setprecision(digits) << number << text;
    return out.str();
  }

  double number = std::numeric_limits<double>::quiet_NaN();
  std::string text;
};

struct Papers_cell
{
  Figure measured, paper;
};

struct Papers_column
{
  std::string name;
  int digits; ///< behind the point
};

struct Papers_row
{
  std::string name;
  std::vector<Papers_cell> cells; ///< one a column
};

/// A table of the papers, run again on one mesh.
struct Papers_table
{
  std::string name; ///< as "CD18 table 3"
  std::string mesh;
  std::size_t num_vertices;
  std::string beside; ///< whose figures the papers' are
  std::vector<Papers_column> columns;
  std::vector<Papers_row> rows;

  /// returns the number of the column with that name.
  std::size_t column(const std::string& wanted) const
  {
    return static_cast<std::size_t>(
        std::find_if(columns.begin(), columns.end(), [&](const Papers_column& c) { return c.name == wanted; }) -
        columns.begin());
  }

  /// returns whether a paper has a figure in column `c`.
  bool has_paper(std::size_t c) const
  {
    return std::any_of(rows.begin(), rows.end(), [=](const Papers_row& r) { return !r.cells[c].paper.is_empty(); });
  }
};

/// prints a table. A column with the papers' figures is followed by one with them.
inline std::ostream& operator<<(std::ostream& out, const Papers_table& table)
{
  std::vector<std::vector<std::string> > lines(table.rows.size() + 1, std::vector<std::string>(1));
  for (std::size_t r = 0; r < table.rows.size(); ++r)
    lines[r + 1][0] = table.rows[r].name;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const bool has_paper = table.has_paper(c);
    lines[0].push_back(table.columns[c].name);
    if (has_paper)
      lines[0].push_back("paper");
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
      const Papers_cell& cell = table.rows[r].cells[c];
      lines[r + 1].push_back(cell.measured.printed(table.columns[c].digits));
      if (has_paper)
        lines[r + 1].push_back(cell.paper.printed(table.columns[c].digits));
    }
  }
  std::vector<std::size_t> widths(lines[0].size(), 0);
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i)
      widths[i] = (std::max)(widths[i], line[i].size());
  out << '\n' << table.name << ": " << table.mesh;
  if (table.num_vertices != 0)
    out << ", " << table.num_vertices << " vertices";
  out << '\n';
  if (!table.beside.empty())
    out << "  paper: " << table.beside << '\n';
  for (const auto& line : lines) {
    out << "  " << std::left << std::setw(static_cast<int>(widths[0])) << line[0] << std::right;
    for (std::size_t i = 1; i < line.size(); ++i)
      out << "  " << std::setw(static_cast<int>(widths[i])) << line[i];
    out << '\n';
  }
  return out << std::flush;
}

/// writes all tables as one list of figures.
inline void write_csv(std::ostream& out, const std::vector<Papers_table>& tables, const std::string& machine)
{
  const auto written = [](const Figure& f) {
    std::ostringstream text;
    text << std::setprecision(6);
    if (f.is_number())
      text << f.number;
    else if (!f.is_empty())
      text << '"' << f.text << '"';
    return text.str();
  };
  out << "# " << machine << "\ntable,mesh,vertices,structure,quantity,measured,paper,paper_figures_of\n";
  for (const Papers_table& table : tables)
    for (const Papers_row& row : table.rows)
      for (std::size_t c = 0; c < table.columns.size(); ++c) {
        const Papers_cell& cell = row.cells[c];
        if (!cell.measured.is_empty() || !cell.paper.is_empty())
          out << table.name << ",\"" << table.mesh << "\"," << table.num_vertices << ',' << row.name << ",\""
              << table.columns[c].name << "\"," << written(cell.measured) << ',' << written(cell.paper) << ",\""
              << (cell.paper.is_empty() ? "" : table.beside) << "\"\n";
      }
}

#endif // BENCHMARK_COMPACT_SURFACE_MESH_PAPERS_TABLE_H
