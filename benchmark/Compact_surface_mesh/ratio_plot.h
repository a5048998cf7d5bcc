// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef BENCHMARK_COMPACT_SURFACE_MESH_RATIO_PLOT_H
#define BENCHMARK_COMPACT_SURFACE_MESH_RATIO_PLOT_H

// Draws what is measured: a line of dots for each kernel, a dot for each structure, at its ratio
// to Surface_mesh on a logarithmic axis; on the left to that in the order of the input, on the
// right to that in our order.

#include "ratio_rows.h"
#include "svg_writer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

class Ratio_plot
{
public:
  Ratio_plot(std::ostream& out, const std::vector<Measured_input>& inputs, const std::string& machine)
    : m_inputs(inputs), m_names(names_of_structures(inputs)), m_svg(out, width, height())
  {
    m_svg.text(margin, 24, "start", "Time, as ratio to Surface_mesh", "font-size=\"16\" font-weight=\"bold\"");
    m_svg.text(margin, 44, "start", machine, "fill=\"#555\"");
    draw_legend();
    double y = top();
    for (const Measured_input& input : inputs) {
      draw(input, y);
      y += height_of(input);
    }
  }

private:
  static constexpr double margin = 20, label_width = 280, panel_width = 400, gap = 30, row_height = 16,
                          heading_height = 52, width = margin + label_width + 2 * panel_width + 2 * gap;
  static constexpr double least = 1. / 32, most = 32; // of the axis

  double top() const { return 78 + 18 * std::ceil(static_cast<double>(m_names.names().size()) / 5); }

  double height() const
  {
    double result = top();
    for (const Measured_input& input : m_inputs)
      result += height_of(input);
    return result;
  }

  static double height_of(const Measured_input& input)
  {
    return heading_height + row_height * static_cast<double>(input.rows.size()) + 24;
  }

  static double x_of(double ratio)
  {
    return panel_width * std::log((std::min)(most, (std::max)(least, ratio)) / least) / std::log(most / least);
  }

  static std::string number(double ratio)
  {
    return ratio >= 1 ? std::to_string(std::lround(ratio)) : "1/" + std::to_string(std::lround(1 / ratio));
  }

  // A structure has the same color everywhere.
  static Colored_names names_of_structures(const std::vector<Measured_input>& inputs)
  {
    Colored_names names;
    for (const Measured_input& input : inputs)
      for (const Measured_structure& s : input.structures)
        names.meet(label(s));
    return names;
  }

  static std::string label(const Measured_structure& s) { return s.name + ", " + s.order; }

  void draw_legend()
  {
    const double column = 220;
    for (std::size_t i = 0; i < m_names.names().size(); ++i) {
      const double x = margin + column * static_cast<double>(i % 5), y = 64 + 18 * static_cast<double>(i / 5);
      const std::string& name = m_names.names()[i];
      m_svg.dot(x + 4, y - 4, m_names.color(name));
      m_svg.text(x + 14, y, "start", name);
    }
  }

  void draw(const Measured_input& input, double y)
  {
    m_svg.text(margin, y + 16, "start", input.name + ", " + std::to_string(input.num_vertices) + " vertices",
               "font-size=\"14\" font-weight=\"bold\"");
    const double left = margin + label_width, right = left + panel_width + gap, rows = y + heading_height;
    draw_panel(input, left, rows, "to Surface_mesh in the input's order", &Ratio::to_input_order);
    draw_panel(input, right, rows, "to Surface_mesh in our order", &Ratio::to_our_order);
    for (std::size_t i = 0; i < input.rows.size(); ++i)
      m_svg.text(left - 10, rows + row_height * (static_cast<double>(i) + 0.75), "end",
                 input.rows[i].kernel + ", " + input.rows[i].way);
  }

  void draw_panel(const Measured_input& input, double x, double y, const std::string& title, double Ratio::*ratio)
  {
    const double height = row_height * static_cast<double>(input.rows.size());
    m_svg.text(x + panel_width / 2, y - 22, "middle", title);
    for (double r = least; r <= most; r *= 2) {
      m_svg.line(x + x_of(r), y, x + x_of(r), y + height,
                 r == 1 ? "stroke=\"black\" stroke-width=\"1.5\"" : "stroke=\"#ddd\"");
      m_svg.text(x + x_of(r), y - 6, "middle", number(r), "font-size=\"10\" fill=\"#555\"");
    }
    for (std::size_t i = 0; i < input.rows.size(); ++i) {
      const double middle = y + row_height * (static_cast<double>(i) + 0.5);
      m_svg.line(x, middle, x + panel_width, middle, "stroke=\"#eee\"");
      for (std::size_t s = 0; s < input.structures.size(); ++s)
        if (input.rows[i].ratios[s].ns_per_vertex > 0)
          m_svg.dot(x + x_of(input.rows[i].ratios[s].*ratio), middle, m_names.color(label(input.structures[s])));
    }
  }

  const std::vector<Measured_input>& m_inputs;
  Colored_names m_names;
  Svg_writer m_svg;
};

#endif // BENCHMARK_COMPACT_SURFACE_MESH_RATIO_PLOT_H
