// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_INTERNAL_SCHNYDER_WOOD_H
#define CGAL_SCHNYDER_WOODS_INTERNAL_SCHNYDER_WOOD_H

#include <CGAL/license/Compact_surface_mesh.h>

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
// L. Castelli Aleardi, 2022, section 3.2). One byte per halfedge.
class Schnyder_wood
{
public:
  explicit Schnyder_wood(std::size_t num_halfedges = 0)
    : m_copy(num_halfedges, uncolored)
  {}

  Schnyder_color color(std::size_t h) const { return static_cast<Schnyder_color>(m_copy[h] & 3); }

  // whether the copy is directed from the source of h to its target
  bool is_outgoing(std::size_t h) const { return (m_copy[h] & outgoing) != 0; }

  bool is_out(std::size_t h, Schnyder_color c) const { return m_copy[h] == (c | outgoing); }
  bool is_in(std::size_t h, Schnyder_color c) const { return m_copy[h] == c; }

  // directs and colors the edge of h and its opposite o from the source of h to that of o
  void set_edge(std::size_t h, std::size_t o, Schnyder_color c)
  {
    m_copy[h] = static_cast<unsigned char>(c | outgoing);
    m_copy[o] = c;
  }

private:
  enum : unsigned char { outgoing = 4 };

  std::vector<unsigned char> m_copy;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_INTERNAL_SCHNYDER_WOOD_H
