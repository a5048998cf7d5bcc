// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_INTERNAL_EXTREMAL_WOOD_SEARCH_H
#define CGAL_SCHNYDER_WOODS_INTERNAL_EXTREMAL_WOOD_SEARCH_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Corner_table.h>
#include <CGAL/Schnyder_woods/Extremal_wood.h>
#include <CGAL/Schnyder_woods/internal/Schnyder_wood.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace internal {

/*
Turns a g-Schnyder wood into an extremal one, without clockwise or without counterclockwise
faces, in linear time and with one byte per face.

Let p be an integer for each face, 0 on fixed faces, such that p(right) - p(left) is 0 or 1 at
each edge. Reverse the edges where it is 1, and add p(left) to the colors, less 1 where
reversed (modulo 3): then the rule around vertices holds again, sector by sector. The fixed
faces are special faces, root faces and their neighbors, and the stars of further
roots. The manual has the proof.

The largest such p leaves no clockwise face. It is the distance from the fixed faces in the dual
graph, where it takes 1 to cross an edge from left to right, and 0 from right to left.
The smallest p leaves no counterclockwise face; it is minus the distance in which left and
right are exchanged.

With cores fixed, the edges of color 2 remain a forest, and with the special edges a cut
graph. A core is what of the forest lies on the paths from the special edges to the roots.
Only faces at cores may be clockwise then.
*/
template <class Index>
class Extremal_wood_search
{
  typedef Corner_table<Index> Table;

public:
  // One search serves all components of a table. The root edges have the colors of
  // color_root_edges().
  Extremal_wood_search(const Table& table, Schnyder_wood& wood)
    : m_table(table), m_wood(wood), m_state(table.num_faces(), 0)
  {}

  // Fixes what the wood of a component demands; for the roots see Shelling.
  template <class HalfedgeRange>
  void fix_roots(Index base, const HalfedgeRange& further_roots)
  {
    for (const Index h : root_face(m_table, base))
      fix_faces_at(h);
    for (const Index root : further_roots) {
      Index h = root;
      do {
        fix(h);
        h = m_table.next_around_source(h);
      } while (h != root);
    }
  }

  // Fixes the faces on both sides of the cores of all components.
  void fix_cores()
  {
    std::vector<bool> is_in_core(m_table.num_vertices(), false);
    for (std::size_t h = 0; h < m_table.num_halfedges(); ++h)
      if (m_wood.is_special(h))
        fix_path_from(static_cast<Index>(h), is_in_core);
  }

  // Changes the wood.
  void operator()(Extremal_wood which)
  {
    m_has_length_if_outgoing = which == Extremal_wood::WITHOUT_CLOCKWISE_FACES;
    find_distances();
    for (Index h = 0; h < m_table.num_halfedges(); ++h) {
      const Index o = m_table.opposite(h);
      if (m_wood.is_special(h))
        change_copy(h);
      else if (h < o)
        change_edge(m_wood.is_outgoing(h) ? h : o);
    }
  }

private:
  // Of each face: the distance modulo 3, and how final it is. Distances are found in
  // ascending order, and those that are not final differ by 1 at most.
  enum : unsigned char { distance_mask = 3, reached = 4, final = 8 };

  // Colors cannot tell a distance from one that differs by 3, so more is not kept.
  unsigned char distance(Index h) const { return m_state[m_table.face(h)] & distance_mask; }

  void fix(Index h) { m_state[m_table.face(h)] = reached; }

  void fix_faces_at(Index h)
  {
    fix(h);
    fix(m_table.opposite(h));
  }

  // Fixes the faces along the path of red edges from the source of h.
  void fix_path_from(Index h, std::vector<bool>& is_in_core)
  {
    while (!is_in_core[m_table.source(h)]) {
      is_in_core[m_table.source(h)] = true;
      const Index first = h;
      while (!m_wood.is_out(h, red)) {
        h = m_table.next_around_source(h);
        if (h == first)
          return; // a root
      }
      fix_faces_at(h);
      h = m_table.opposite(h);
    }
  }

  // What it takes to cross the edge of h from the face of h.
  unsigned char length(Index h) const { return m_wood.is_outgoing(h) == m_has_length_if_outgoing ? 1 : 0; }

  void find_distances()
  {
    std::vector<Index> now, later;
    for (Index h = 0; h < m_table.num_halfedges(); ++h) {
      if (h % 3 == 0 && m_state[m_table.face(h)] == reached)
        now.push_back(m_table.face(h));
      if (m_wood.is_special(h)) // from the special face, whose distance is 0
        reach(h, 1 - length(h), 0, now, later);
    }
    for (unsigned char level = 0; !now.empty(); level = static_cast<unsigned char>((level + 1) % 3)) {
      while (!now.empty()) {
        const Index f = now.back();
        now.pop_back();
        if (m_state[f] & final)
          continue;
        m_state[f] |= final;
        for (Index h = 3 * f, end = h + 3; h != end; ++h)
          if (!m_wood.is_special(h))
            reach(m_table.opposite(h), length(h), level, now, later);
      }
      now.swap(later);
    }
  }

  // The face of h is at most `length` away from a face at the present level.
  void reach(Index h, unsigned char length, unsigned char level, std::vector<Index>& now, std::vector<Index>& later)
  {
    unsigned char& state = m_state[m_table.face(h)];
    const unsigned char new_state = static_cast<unsigned char>(reached | (level + length) % 3);
    if (state == 0 || (length == 0 && !(state & final) && state != new_state)) {
      state = new_state;
      (length == 0 ? now : later).push_back(m_table.face(h));
    }
  }

  // The color of a copy with the face of h, or else a special face, on its left.
  Schnyder_color changed(Schnyder_color c, unsigned distance_of_left, bool is_reversed) const
  {
    const unsigned shift = m_has_length_if_outgoing ? distance_of_left : 3 - distance_of_left;
    return static_cast<Schnyder_color>((c + shift + (is_reversed ? 2 : 0)) % 3);
  }

  void change_edge(Index h)
  {
    const Index o = m_table.opposite(h);
    const bool is_reversed = distance(h) != distance(o);
    const Schnyder_color c = changed(m_wood.color(h), distance(h), is_reversed);
    m_wood.set_edge(is_reversed ? o : h, is_reversed ? h : o, c);
  }

  void change_copy(Index h)
  {
    const bool is_outgoing = m_wood.is_outgoing(h), is_reversed = distance(h) != 0;
    const Schnyder_color c = changed(m_wood.color(h), is_outgoing ? distance(h) : 0, is_reversed);
    m_wood.set_copy(h, c, is_outgoing != is_reversed);
  }

  const Table& m_table;
  Schnyder_wood& m_wood;
  bool m_has_length_if_outgoing = true;
  std::vector<unsigned char> m_state;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_INTERNAL_EXTREMAL_WOOD_SEARCH_H
