// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef COMPACT_SURFACE_MESH_EXAMPLES_SCHNYDER_SVG_H
#define COMPACT_SURFACE_MESH_EXAMPLES_SCHNYDER_SVG_H

// Draws a Schnyder wood of a triangulated sphere: Schnyder's straight-line drawing, the
// edges in the colors of their trees, each with an arrow towards the root.

#include <CGAL/Schnyder_woods.h>

#include <CGAL/Dynamic_property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>

namespace example {

struct Svg_point
{
  double x, y;
};

// Starts a picture, with the styles of what is drawn.
inline void write_start(std::ostream& out, double width, double height)
{
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width << ' ' << height
      << "\">\n<style>\n"
         "line { stroke-width: 1.5 }\n"
         ".outer { stroke: #bbb; fill: none }\n"
         ".blue { stroke: #1f5fc4; fill: #1f5fc4 }\n"
         ".black { stroke: #222; fill: #222 }\n"
         ".red { stroke: #d03030; fill: #d03030 }\n"
         "circle { fill: white; stroke: #222 }\n"
         "</style>\n";
}

// The style of an edge with this color, -1 for those of the root face.
inline const char* kind_of_color(int color)
{
  const char* const kinds[] = { "outer", "blue", "black", "red" };
  return kinds[color + 1];
}

inline void write_line(std::ostream& out, Svg_point a, Svg_point b, const char* kind)
{
  out << "<line class=\"" << kind << "\" x1=\"" << a.x << "\" y1=\"" << a.y << "\" x2=\"" << b.x << "\" y2=\"" << b.y
      << "\"/>\n";
}

// The middle of the edge, pointing to b; it is smaller on short edges.
inline void write_arrow(std::ostream& out, Svg_point a, Svg_point b, const char* kind)
{
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy);
  const double size = (std::min)(9., length / 4) / length;
  const Svg_point tip = { a.x + 0.5 * dx + 0.5 * size * dx, a.y + 0.5 * dy + 0.5 * size * dy };
  const Svg_point base = { tip.x - size * dx, tip.y - size * dy };
  const double side = 0.35 * size;
  out << "<polygon class=\"" << kind << "\" points=\"" << tip.x << ',' << tip.y << ' ' << base.x - side * dy << ','
      << base.y + side * dx << ' ' << base.x + side * dy << ',' << base.y - side * dx << "\"/>\n";
}

/// writes the drawing of `g`, rooted at its first face, to `out` in SVG format. Every vertex
/// lies at its barycentric coordinates in a triangle with the corners V_0 (left), V_1 (right)
/// and V_2 (top).
/// \throws CGAL::Mesh_defect_exception if `g` is no triangulated sphere
template <class FaceGraph>
void write_schnyder_wood(std::ostream& out, const FaceGraph& g)
{
  using halfedge_descriptor = typename boost::graph_traits<FaceGraph>::halfedge_descriptor;
  using vertex_descriptor = typename boost::graph_traits<FaceGraph>::vertex_descriptor;
  const auto color = get(CGAL::dynamic_halfedge_property_t<int>(), g);
  const auto outgoing = get(CGAL::dynamic_halfedge_property_t<bool>(), g);
  const auto coordinates = get(CGAL::dynamic_vertex_property_t<std::array<std::size_t, 3> >(), g);
  const halfedge_descriptor root = CGAL::schnyder_wood(g, color, outgoing);
  CGAL::schnyder_drawing(g, root, color, outgoing, coordinates);

  const double side = 1000, height = side * std::sqrt(0.75), margin = 15;
  const double sum = 2. * static_cast<double>(num_vertices(g)) - 5;
  const auto place = [&](vertex_descriptor v) {
    const std::array<std::size_t, 3> c = get(coordinates, v);
    const double to_right = static_cast<double>(c[1]) / sum, to_top = static_cast<double>(c[2]) / sum;
    return Svg_point{ margin + side * (to_right + to_top / 2), margin + height * (1 - to_top) };
  };

  write_start(out, side + 2 * margin, height + 2 * margin);
  for (const auto e : edges(g)) {
    const halfedge_descriptor h = halfedge(e, g), along = get(outgoing, h) ? h : opposite(h, g);
    const Svg_point a = place(source(along, g)), b = place(target(along, g));
    const int c = get(color, h);
    write_line(out, a, b, kind_of_color(c));
    if (c >= 0)
      write_arrow(out, a, b, kind_of_color(c));
  }
  for (const auto v : vertices(g))
    out << "<circle cx=\"" << place(v).x << "\" cy=\"" << place(v).y << "\" r=\"3\"/>\n";
  out << "</svg>\n";
}

} // namespace example

#endif // COMPACT_SURFACE_MESH_EXAMPLES_SCHNYDER_SVG_H
