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
    : m_out(out), m_inputs(inputs)
  {
    collect_structures();
    const double top = 78 + 18 * std::ceil(static_cast<double>(m_names.size()) / 5);
    double height = top;
    for (const Measured_input& input : inputs)
      height += height_of(input);
    m_out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\"" << height
          << "\" font-family=\"sans-serif\" font-size=\"12\">\n"
          << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    text(margin, 24, "start", "Time, as ratio to Surface_mesh", "font-size=\"16\" font-weight=\"bold\"");
    text(margin, 44, "start", machine, "fill=\"#555\"");
    draw_legend();
    double y = top;
    for (const Measured_input& input : inputs) {
      draw(input, y);
      y += height_of(input);
    }
    m_out << "</svg>\n";
  }

private:
  static constexpr double margin = 20, label_width = 280, panel_width = 400, gap = 30, row_height = 16,
                          heading_height = 52, width = margin + label_width + 2 * panel_width + 2 * gap;
  static constexpr double least = 1. / 32, most = 32; // of the axis

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
  void collect_structures()
  {
    for (const Measured_input& input : m_inputs)
      for (const Measured_structure& s : input.structures)
        if (std::find(m_names.begin(), m_names.end(), label(s)) == m_names.end())
          m_names.push_back(label(s));
  }

  static std::string label(const Measured_structure& s) { return s.name + ", " + s.order; }

  std::string color(const std::string& name) const
  {
    static const std::vector<std::string> colors = { "#777777", "#000000", "#e69f00", "#56b4e9", "#d55e00",
                                                     "#0072b2", "#009e73", "#cc79a7", "#8c564b", "#bcbd22" };
    return colors[static_cast<std::size_t>(std::find(m_names.begin(), m_names.end(), name) - m_names.begin()) %
                  colors.size()];
  }

  void text(double x, double y, const std::string& anchor, const std::string& what, const std::string& style = "")
  {
    m_out << "<text x=\"" << x << "\" y=\"" << y << "\" text-anchor=\"" << anchor << "\" " << style << '>' << what
          << "</text>\n";
  }

  void line(double x1, double y1, double x2, double y2, const std::string& style)
  {
    m_out << "<line x1=\"" << x1 << "\" y1=\"" << y1 << "\" x2=\"" << x2 << "\" y2=\"" << y2 << "\" " << style
          << "/>\n";
  }

  void dot(double x, double y, const std::string& name)
  {
    m_out << "<circle cx=\"" << x << "\" cy=\"" << y << "\" r=\"4\" fill=\"" << color(name)
          << "\" fill-opacity=\"0.8\"/>\n";
  }

  void draw_legend()
  {
    const double column = 220;
    for (std::size_t i = 0; i < m_names.size(); ++i) {
      const double x = margin + column * static_cast<double>(i % 5), y = 64 + 18 * static_cast<double>(i / 5);
      dot(x + 4, y - 4, m_names[i]);
      text(x + 14, y, "start", m_names[i]);
    }
  }

  void draw(const Measured_input& input, double y)
  {
    text(margin, y + 16, "start", input.name + ", " + std::to_string(input.num_vertices) + " vertices",
         "font-size=\"14\" font-weight=\"bold\"");
    const double left = margin + label_width, right = left + panel_width + gap, rows = y + heading_height;
    draw_panel(input, left, rows, "to Surface_mesh in the input's order", &Ratio::to_input_order);
    draw_panel(input, right, rows, "to Surface_mesh in our order", &Ratio::to_our_order);
    for (std::size_t i = 0; i < input.rows.size(); ++i)
      text(left - 10, rows + row_height * (static_cast<double>(i) + 0.75), "end",
           input.rows[i].kernel + ", " + input.rows[i].way);
  }

  void draw_panel(const Measured_input& input, double x, double y, const std::string& title, double Ratio::*ratio)
  {
    const double height = row_height * static_cast<double>(input.rows.size());
    text(x + panel_width / 2, y - 22, "middle", title);
    for (double r = least; r <= most; r *= 2) {
      line(x + x_of(r), y, x + x_of(r), y + height,
           r == 1 ? "stroke=\"black\" stroke-width=\"1.5\"" : "stroke=\"#ddd\"");
      text(x + x_of(r), y - 6, "middle", number(r), "font-size=\"10\" fill=\"#555\"");
    }
    for (std::size_t i = 0; i < input.rows.size(); ++i) {
      const double middle = y + row_height * (static_cast<double>(i) + 0.5);
      line(x, middle, x + panel_width, middle, "stroke=\"#eee\"");
      for (std::size_t s = 0; s < input.structures.size(); ++s)
        if (input.rows[i].ratios[s].ns_per_vertex > 0)
          dot(x + x_of(input.rows[i].ratios[s].*ratio), middle, label(input.structures[s]));
    }
  }

  std::ostream& m_out;
  const std::vector<Measured_input>& m_inputs;
  std::vector<std::string> m_names;
};

#endif // BENCHMARK_COMPACT_SURFACE_MESH_RATIO_PLOT_H
