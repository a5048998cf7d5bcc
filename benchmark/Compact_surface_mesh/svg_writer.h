// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef BENCHMARK_COMPACT_SURFACE_MESH_SVG_WRITER_H
#define BENCHMARK_COMPACT_SURFACE_MESH_SVG_WRITER_H

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

/// Writes the shapes of one drawing.
class Svg_writer
{
public:
  Svg_writer(std::ostream& out, double width, double height) : m_out(out)
  {
    m_out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\"" << height
          << "\" font-family=\"sans-serif\" font-size=\"12\">\n"
          << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  }

  ~Svg_writer() { m_out << "</svg>\n"; }

  Svg_writer(const Svg_writer&) = delete;
  Svg_writer& operator=(const Svg_writer&) = delete;

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

  void dot(double x, double y, const std::string& color)
  {
    m_out << "<circle cx=\"" << x << "\" cy=\"" << y << "\" r=\"4\" fill=\"" << color
          << "\" fill-opacity=\"0.8\"/>\n";
  }

  void bar(double x, double y, double width, double height, const std::string& color)
  {
    m_out << "<rect x=\"" << x << "\" y=\"" << y << "\" width=\"" << width << "\" height=\"" << height
          << "\" fill=\"" << color << "\"/>\n";
  }

private:
  std::ostream& m_out;
};

/// Names, in the order in which they were met, each with a color that no other has among the first twenty.
class Colored_names
{
public:
  void meet(const std::string& name)
  {
    if (std::find(m_names.begin(), m_names.end(), name) == m_names.end())
      m_names.push_back(name);
  }

  const std::vector<std::string>& names() const { return m_names; }

  std::string color(const std::string& name) const
  {
    static const std::vector<std::string> colors = { "#777777", "#000000", "#e69f00", "#56b4e9", "#d55e00",
                                                     "#0072b2", "#009e73", "#cc79a7", "#8c564b", "#bcbd22",
                                                     "#17becf", "#9467bd", "#aec7e8", "#ffbb78", "#98df8a",
                                                     "#ff9896", "#c5b0d5", "#393b79", "#637939", "#843c39" };
    return colors[static_cast<std::size_t>(std::find(m_names.begin(), m_names.end(), name) - m_names.begin()) %
                  colors.size()];
  }

private:
  std::vector<std::string> m_names;
};

#endif // BENCHMARK_COMPACT_SURFACE_MESH_SVG_WRITER_H
