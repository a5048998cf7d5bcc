// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_INTERNAL_SCHNYDER_WOOD_H
#define CGAL_SCHNYDER_WOODS_INTERNAL_SCHNYDER_WOOD_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Corner_table.h>
#include <CGAL/Compact_surface_mesh/internal/Large_array.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace internal {

// The three colors in the words of the layouts. Counterclockwise around an inner
// vertex: blue out, red in, black out, blue in, red out, black in.
enum Schnyder_color : unsigned char { blue = 0, black = 1, red = 2, uncolored = 3 };

// A Schnyder wood of a corner table: for each halfedge the color and the direction of
// the copy of its edge that bounds the face of the halfedge. The two copies of an edge
// agree, but for the special edges of woods above genus 0 (habilitation of
// L. Castelli Aleardi, 2022, section 3.2). A special edge stands for two edges with a
// face of two sides, the special face, between them: each copy has a color and a direction of
// its own. One byte per halfedge.
class Schnyder_wood
{
public:
  explicit Schnyder_wood(std::size_t num_halfedges = 0)
    : m_copy(num_halfedges, uncolored)
  {}

  std::size_t num_halfedges() const { return m_copy.size(); }

  Schnyder_color color(std::size_t h) const { return static_cast<Schnyder_color>(m_copy[h] & color_mask); }

  // whether the copy is directed from the source of h to its target
  bool is_outgoing(std::size_t h) const { return (m_copy[h] & outgoing) != 0; }

  bool is_out(std::size_t h, Schnyder_color c) const { return (m_copy[h] & ~special) == (c | outgoing); }
  bool is_in(std::size_t h, Schnyder_color c) const { return (m_copy[h] & ~special) == c; }

  // whether the edge is special
  bool is_special(std::size_t h) const { return (m_copy[h] & special) != 0; }

  // directs and colors the ordinary edge of h and its opposite o from the source of h to that of o
  void set_edge(std::size_t h, std::size_t o, Schnyder_color c)
  {
    m_copy[h] = static_cast<unsigned char>(c | outgoing);
    m_copy[o] = c;
  }

  // directs and colors the copy that bounds the face of h, and leaves the other one
  void set_copy(std::size_t h, Schnyder_color c, bool is_outgoing)
  {
    m_copy[h] = static_cast<unsigned char>(c | (is_outgoing ? outgoing : 0) | (m_copy[h] & special));
  }

  // makes the edge of h and its opposite o a special one
  void set_special(std::size_t h, std::size_t o)
  {
    m_copy[h] |= special;
    m_copy[o] |= special;
  }

private:
  enum : unsigned char { color_mask = 3, outgoing = 4, special = 8 };

  Large_array<unsigned char> m_copy;
};

// The halfedges of the root face (V_1, V_0, V_2), from `base` on, which runs from V_1 to V_0.
template <class Index>
std::array<Index, 3> root_face(const Corner_table<Index>& table, Index base)
{
  return { base, table.next(base), table.prev(base) };
}

// With the root edges V_0 V_2 and V_1 V_2 red and V_1 V_0 blue, every vertex but V_2 and
// further roots has a red parent, and each face is the left one of a red edge or the right one of
// a black edge.
template <class Index>
void color_root_edges(const Corner_table<Index>& table, Index base, Schnyder_wood& wood)
{
  const auto color_edge = [&](Index h, Schnyder_color c) {
    wood.set_copy(h, c, true);
    wood.set_copy(table.opposite(h), c, false);
  };
  color_edge(base, blue);
  color_edge(table.next(base), red);
  color_edge(table.opposite(table.prev(base)), red);
}

} // namespace internal
} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_INTERNAL_SCHNYDER_WOOD_H
