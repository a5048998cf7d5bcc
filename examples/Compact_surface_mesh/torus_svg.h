// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef COMPACT_SURFACE_MESH_EXAMPLES_TORUS_SVG_H
#define COMPACT_SURFACE_MESH_EXAMPLES_TORUS_SVG_H

// Makes a torus of a regular grid, and draws a g-Schnyder wood of it on the flat torus: a
// rectangle whose opposite sides are the same.

#include "schnyder_svg.h"

#include <cmath>
#include <cstddef>
#include <ostream>
#include <utility>
#include <vector>

namespace example {

/// A torus of `columns` times `rows` squares, each cut into two triangles. Vertex (i,j) is the one
/// with index i + j * columns. It is simple if both numbers are at least 3.
struct Torus_grid
{
  int columns, rows;

  template <class Mesh>
  Mesh mesh() const
  {
    Mesh mesh;
    std::vector<typename Mesh::Vertex_index> grid;
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i)
        grid.push_back(mesh.add_vertex(typename Mesh::Point(i, j, 0)));
    const auto vertex = [&](int i, int j) {
      return grid[static_cast<std::size_t>(i % columns + j % rows * columns)];
    };
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) {
        mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
        mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
      }
    return mesh;
  }
};

/// draws a g-Schnyder wood of a mesh of `Torus_grid`. Edges have the colors of the trees, with arrows towards the
/// roots; special edges are drawn twice, with their special faces between, and the edges of the cut graph on bands.
/// What leaves the rectangle comes in again on the other side.
template <class Mesh, class ColorMap, class OutgoingMap, class SpecialMap, class CutMap>
class Torus_drawing
{
  using Vertex = typename Mesh::Vertex_index;
  using Halfedge = typename Mesh::Halfedge_index;

public:
  Torus_drawing(const Torus_grid& grid, const Mesh& mesh, Halfedge root, ColorMap color, OutgoingMap outgoing,
                SpecialMap is_special, CutMap is_cut)
    : m_grid(grid), m_mesh(mesh), m_root(root), m_color(color), m_outgoing(outgoing), m_is_special(is_special),
      m_is_cut(is_cut)
  {}

  void write(std::ostream& out) const
  {
    const double width = unit * m_grid.columns, height = unit * m_grid.rows;
    write_start(out, width + 2 * margin, height + 2 * margin);
    out << "<style>\n"
           ".cut { stroke: #ffd24d; stroke-width: 16; stroke-linecap: round }\n"
           ".special { fill: #cfe8cf; stroke: none }\n"
           ".root { fill: #e4e4e4; stroke: none }\n"
           ".frame { fill: none; stroke: #888; stroke-dasharray: 6 4 }\n"
           "text { font: italic 18px serif }\n"
           "</style>\n<clipPath id=\"frame\"><rect width=\""
        << width << "\" height=\"" << height << "\"/></clipPath>\n<g transform=\"translate(" << margin << ' ' << margin
        << ")\">\n<g clip-path=\"url(#frame)\">\n";
    write_tiled(out, "below", [&] { write_root_face_and_cut(out); });
    write_tiled(out, "wood", [&] { write_wood(out); });
    write_vertices(out);
    out << "</g>\n<rect class=\"frame\" width=\"" << width << "\" height=\"" << height << "\"/>\n</g>\n</svg>\n";
  }

private:
  static constexpr double unit = 100, margin = 10;

  // Nine times, once for each place of the rectangle from which something may come in.
  template <class Writer>
  void write_tiled(std::ostream& out, const char* name, Writer writer) const
  {
    out << "<g id=\"" << name << "\">\n";
    writer();
    out << "</g>\n";
    for (int j : { -1, 0, 1 })
      for (int i : { -1, 0, 1 })
        if (i != 0 || j != 0)
          out << "<use href=\"#" << name << "\" x=\"" << i * unit * m_grid.columns << "\" y=\""
              << j * unit * m_grid.rows << "\"/>\n";
  }

  void write_root_face_and_cut(std::ostream& out) const
  {
    write_triangle(out, m_root);
    for (const auto e : m_mesh.edges())
      if (get(m_is_cut, e)) {
        const Halfedge h = m_mesh.halfedge(e);
        write_line(out, start(h), end(h), "cut");
      }
  }

  void write_wood(std::ostream& out) const
  {
    for (const auto e : m_mesh.edges())
      if (get(m_is_special, e))
        write_special_edge(out, m_mesh.halfedge(e));
      else
        write_copy(out, m_mesh.halfedge(e), 0);
  }

  void write_vertices(std::ostream& out) const
  {
    for (const Vertex v : m_mesh.vertices())
      out << "<circle cx=\"" << place(v).x << "\" cy=\"" << place(v).y << "\" r=\"5\"/>\n";
    write_name(out, m_mesh.target(m_root), 0);
    write_name(out, m_mesh.source(m_root), 1);
    write_name(out, m_mesh.target(m_mesh.next(m_root)), 2);
  }

  Svg_point place(Vertex v) const
  {
    const int i = static_cast<int>(v), column = i % m_grid.columns, row = i / m_grid.columns;
    return { unit * (column + 0.5), unit * (m_grid.rows - row - 0.5) };
  }

  Svg_point start(Halfedge h) const { return place(m_mesh.source(h)); }

  // Where the target is if one goes along h from the source.
  Svg_point end(Halfedge h) const
  {
    const Svg_point a = start(h), b = place(m_mesh.target(h));
    const auto unrolled = [](double from, double to, double period) {
      return to - period * std::round((to - from) / period);
    };
    return { unrolled(a.x, b.x, unit * m_grid.columns), unrolled(a.y, b.y, unit * m_grid.rows) };
  }

  // The copy of the edge of h that bounds the face of h, so far to the left of h. The arrow is
  // beyond the middle, where edges leave the rectangle.
  void write_copy(std::ostream& out, Halfedge h, double distance) const
  {
    Svg_point a = shifted(h, start(h), distance), b = shifted(h, end(h), distance);
    const int c = get(m_color, h);
    const char* kind = kind_of_color(c);
    write_line(out, a, b, kind);
    if (!get(m_outgoing, h))
      std::swap(a, b);
    if (c >= 0)
      write_arrow(out, { a.x + 0.36 * (b.x - a.x), a.y + 0.36 * (b.y - a.y) }, b, kind);
  }

  void write_special_edge(std::ostream& out, Halfedge h) const
  {
    const double distance = 5;
    const Svg_point a = shifted(h, start(h), distance), b = shifted(h, end(h), distance),
                    c = shifted(h, end(h), -distance), d = shifted(h, start(h), -distance);
    out << "<polygon class=\"special\" points=\"" << a.x << ',' << a.y << ' ' << b.x << ',' << b.y << ' ' << c.x << ','
        << c.y << ' ' << d.x << ',' << d.y << "\"/>\n";
    write_copy(out, h, distance);
    write_copy(out, m_mesh.opposite(h), distance);
  }

  // y points down.
  Svg_point shifted(Halfedge h, Svg_point p, double distance) const
  {
    const Svg_point a = start(h), b = end(h);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    return { p.x + distance * (b.y - a.y) / length, p.y - distance * (b.x - a.x) / length };
  }

  void write_triangle(std::ostream& out, Halfedge h) const
  {
    const Svg_point a = start(h), b = end(h), c = end(m_mesh.next(h)), second = start(m_mesh.next(h));
    out << "<polygon class=\"root\" points=\"" << a.x << ',' << a.y << ' ' << b.x << ',' << b.y << ' '
        << c.x + b.x - second.x << ',' << c.y + b.y - second.y << "\"/>\n";
  }

  void write_name(std::ostream& out, Vertex v, int i) const
  {
    out << "<text x=\"" << place(v).x - 28 << "\" y=\"" << place(v).y - 8 << "\">V" << i << "</text>\n";
  }

  const Torus_grid m_grid;
  const Mesh& m_mesh;
  const Halfedge m_root;
  const ColorMap m_color;
  const OutgoingMap m_outgoing;
  const SpecialMap m_is_special;
  const CutMap m_is_cut;
};

} // namespace example

#endif // COMPACT_SURFACE_MESH_EXAMPLES_TORUS_SVG_H
