// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef BENCHMARK_COMPACT_SURFACE_MESH_PAPERS_BARS_H
#define BENCHMARK_COMPACT_SURFACE_MESH_PAPERS_BARS_H

// Draws columns of tables in the manner of CD18's figure 14: a panel for each column, in it a group of bars for each
// mesh, and a bar for each structure. A red stroke is the paper's figure.

#include "papers_table.h"
#include "svg_writer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

class Papers_bars
{
public:
  /// \param tables have the same columns
  /// \param columns the names of those that are drawn
  Papers_bars(std::ostream& out, const std::vector<Papers_table>& tables, const std::vector<std::string>& columns,
              const std::string& machine)
    : m_tables(tables), m_names(names_of_rows(tables)),
      m_svg(out, left + groups_width() + margin, top() + static_cast<double>(columns.size()) * panel_height)
  {
    m_svg.text(margin, 24, "start", "CD18's table 3 and figure 14, run again; red strokes are the paper's figures",
               "font-size=\"16\" font-weight=\"bold\"");
    m_svg.text(margin, 44, "start", machine, "fill=\"#555\"");
    draw_legend();
    double y = top();
    for (const std::string& column : columns) {
      draw_panel(column, y);
      y += panel_height;
    }
  }

private:
  static constexpr double margin = 20, left = 70, bar_width = 9, gap = 24, panel_height = 270, bars_height = 190,
                          least_width = 760, legend_column = 190;

  static Colored_names names_of_rows(const std::vector<Papers_table>& tables)
  {
    Colored_names names;
    for (const Papers_table& table : tables)
      for (const Papers_row& row : table.rows)
        names.meet(row.name);
    return names;
  }

  double group_width() const { return bar_width * static_cast<double>(m_names.names().size()) + gap; }
  double groups_width() const
  {
    return (std::max)(least_width, group_width() * static_cast<double>(m_tables.size()));
  }
  double top() const { return 70 + 18 * std::ceil(static_cast<double>(m_names.names().size()) / 4); }

  void draw_legend()
  {
    for (std::size_t i = 0; i < m_names.names().size(); ++i) {
      const double x = margin + legend_column * static_cast<double>(i % 4), y = 64 + 18 * static_cast<double>(i / 4);
      m_svg.bar(x, y - 9, bar_width, bar_width, m_names.color(m_names.names()[i]));
      m_svg.text(x + 14, y, "start", m_names.names()[i]);
    }
  }

  // The largest number in a column, a paper's included.
  double most(const std::string& column) const
  {
    double result = 0;
    for (const Papers_table& table : m_tables)
      for (const Papers_row& row : table.rows) {
        const Papers_cell& cell = row.cells[table.column(column)];
        for (const Figure& f : { cell.measured, cell.paper })
          if (f.is_number())
            result = (std::max)(result, f.number);
      }
    return result;
  }

  // A step of 1, 2 or 5 times a power of ten, of which at most eight fit.
  static double step_of_axis(double most)
  {
    const double power = std::pow(10., std::floor(std::log10(most / 8)));
    for (const double factor : { 1., 2., 5. })
      if (most / (factor * power) <= 8)
        return factor * power;
    return 10 * power;
  }

  void draw_panel(const std::string& column, double y)
  {
    const double largest = most(column), bottom = y + 30 + bars_height;
    m_svg.text(margin, y + 16, "start", column, "font-size=\"14\" font-weight=\"bold\"");
    if (!(largest > 0))
      return;
    const double step = step_of_axis(largest), scale = bars_height / largest;
    for (double value = 0; value <= largest; value += step) {
      m_svg.line(left, bottom - scale * value, left + groups_width(), bottom - scale * value, "stroke=\"#ddd\"");
      m_svg.text(left - 6, bottom - scale * value + 4, "end", Figure(value).printed(step < 1 ? 1 : 0),
                 "font-size=\"10\" fill=\"#555\"");
    }
    double x = left + gap / 2;
    for (const Papers_table& table : m_tables) {
      draw_group(table, table.column(column), x, bottom, scale);
      m_svg.text(x + (group_width() - gap) / 2, bottom + 16, "middle", table.mesh, "font-size=\"10\"");
      x += group_width();
    }
  }

  void draw_group(const Papers_table& table, std::size_t column, double x, double bottom, double scale)
  {
    for (const Papers_row& row : table.rows) {
      const auto& names = m_names.names();
      const double left_side =
          x + bar_width * static_cast<double>(std::find(names.begin(), names.end(), row.name) - names.begin());
      const Papers_cell& cell = row.cells[column];
      if (cell.measured.is_number())
        m_svg.bar(left_side, bottom - scale * cell.measured.number, bar_width - 1, scale * cell.measured.number,
                  m_names.color(row.name));
      if (cell.paper.is_number())
        m_svg.line(left_side - 1, bottom - scale * cell.paper.number, left_side + bar_width,
                   bottom - scale * cell.paper.number, "stroke=\"#d00000\" stroke-width=\"2\"");
    }
  }

  const std::vector<Papers_table>& m_tables;
  Colored_names m_names;
  Svg_writer m_svg;
};

#endif // BENCHMARK_COMPACT_SURFACE_MESH_PAPERS_BARS_H
