// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_INTERNAL_NONSEPARATING_CHORDS_H
#define CGAL_SCHNYDER_WOODS_INTERNAL_NONSEPARATING_CHORDS_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Corner_table.h>
#include <CGAL/Schnyder_woods/internal/Schnyder_wood.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace internal {

/*
Finds the chords at which a shelling that is stuck can go on: those that do not separate
the region D that is left to conquer. The others are called bridges; a bridge
stays one, because D only shrinks.

There are two ways to tell. A search from both sides of one chord, one face each in turn,
ends when they meet or when the smaller side is exhausted. A flood of D, which crosses
chords only where it has no other way, tells all chords at once: those that it crosses are
a spanning tree of the pieces between chords, the others do not separate D, and may all be
opened. A flood is made at first, and then when the searches since the last one have cost
as much as it will. So all of this takes O(|D|) time per flood, and as each flood finds
something to open, there are at most as many floods as special edges.

Of the faces, D has those whose copies in the wood have no color: a face off D has
two colored ones at least.
*/
template <class Index>
class Nonseparating_chords
{
  typedef Corner_table<Index> Table;

public:
  Nonseparating_chords(const Table& table, const Schnyder_wood& wood) : m_table(table), m_wood(wood) {}

  // A new component is shelled.
  void clear()
  {
    m_newest.clear();
    m_is_active = false;
  }

  // Before the first flood of a component nothing needs to be noted.
  bool is_active() const { return m_is_active; }

  // Notes that the edge of h has become a chord.
  void note(Index h) { m_newest.push_back(h); }

  // whether the face of h is in D
  bool is_inside(Index h) const
  {
    const std::size_t first = h - h % 3;
    return m_wood.color(first) == uncolored && m_wood.color(first + 1) == uncolored;
  }

  // Calls open(h) for a chord or several, which make their edges special, and returns
  // whether there were any. `inside` is a halfedge with its face in D, which has num_faces faces;
  // is_conquered(v) tells whether vertex v is on the boundary of D.
  template <class Is_conquered, class Open>
  bool open_some(Index inside, std::size_t num_faces, const Is_conquered& is_conquered, const Open& open)
  {
    if (!m_is_active || m_cost > num_faces)
      return flood(inside, is_conquered, open);
    while (!m_newest.empty()) {
      const Index h = m_newest.back();
      m_newest.pop_back();
      if (m_wood.is_special(h) || is_bridge(h) || !is_inside(h) || !is_inside(m_table.opposite(h)))
        continue;
      if (sides_meet(h)) {
        open(h);
        return true;
      }
      set_bridge(h);
    }
    return false;
  }

private:
  // Of each face: which of its halfedges are bridges, and which search has seen it.
  enum : unsigned char { first_bridge = 1, seen = 8, seen_right = 16 };

  template <class Is_conquered, class Open>
  bool flood(Index inside, const Is_conquered& is_conquered, const Open& open)
  {
    m_mark.resize(m_table.num_faces(), 0);
    m_newest.clear(); // bridges all, soon
    m_is_active = true;
    m_cost = 0;
    bool any = false;
    std::vector<Index> faces, chords;
    visit(inside, seen, faces);
    for (std::size_t i = 0;;) {
      for (; i < faces.size(); ++i)
        for (const Index h : halfedges_of(faces[i])) {
          const Index o = m_table.opposite(h);
          if (m_wood.is_special(h) || !is_inside(o))
            continue;
          if (is_conquered(m_table.source(h)) && is_conquered(m_table.source(o)))
            chords.push_back(h);
          else if (!(m_mark[Table::face(o)] & seen))
            visit(o, seen, faces);
        }
      if (chords.empty())
        break;
      const Index h = chords.back(), o = m_table.opposite(h);
      chords.pop_back();
      if (!(m_mark[Table::face(o)] & seen)) {
        set_bridge(h);
        visit(o, seen, faces);
      } else if (!is_bridge(h) && !m_wood.is_special(h)) {
        open(h);
        any = true;
      }
    }
    forget(faces);
    return any;
  }

  // Whether the faces on both sides of chord h are still connected when it is cut.
  bool sides_meet(Index h)
  {
    const unsigned char mark[2] = { seen, seen_right };
    bool meet = false, exhausted = false;
    for (std::vector<Index>& side : m_side)
      side.clear();
    visit(h, mark[0], m_side[0]);
    visit(m_table.opposite(h), mark[1], m_side[1]);
    for (std::size_t i = 0; !meet && !exhausted; ++i)
      for (int s = 0; s < 2 && !meet && !exhausted; ++s) {
        exhausted = i == m_side[s].size();
        if (!exhausted)
          meet = expand(m_side[s][i], h, mark[s], m_side[s]);
      }
    m_cost += m_side[0].size() + m_side[1].size();
    forget(m_side[0]);
    forget(m_side[1]);
    return meet;
  }

  // Sees the neighbors of face f, and returns whether the other side has seen one of them.
  bool expand(Index f, Index chord, unsigned char mark, std::vector<Index>& faces)
  {
    for (const Index h : halfedges_of(f)) {
      const Index o = m_table.opposite(h);
      if (h == chord || o == chord || m_wood.is_special(h) || is_bridge(h) || !is_inside(o))
        continue;
      const unsigned char by = m_mark[Table::face(o)] & (seen | seen_right);
      if (by == 0)
        visit(o, mark, faces);
      else if (by != mark)
        return true;
    }
    return false;
  }

  static std::array<Index, 3> halfedges_of(Index f)
  {
    const Index h = static_cast<Index>(3 * f);
    return { h, Table::next(h), Table::prev(h) };
  }

  void visit(Index h, unsigned char mark, std::vector<Index>& faces)
  {
    m_mark[Table::face(h)] |= mark;
    faces.push_back(Table::face(h));
  }

  void forget(const std::vector<Index>& faces)
  {
    for (const Index f : faces)
      m_mark[f] &= static_cast<unsigned char>(~(seen | seen_right));
  }

  bool is_bridge(Index h) const { return (m_mark[Table::face(h)] & (first_bridge << h % 3)) != 0; }

  void set_bridge(Index h)
  {
    for (const Index side : { h, m_table.opposite(h) })
      m_mark[Table::face(side)] |= static_cast<unsigned char>(first_bridge << side % 3);
  }

  const Table& m_table;
  const Schnyder_wood& m_wood;
  bool m_is_active = false;
  std::vector<Index> m_newest; // chords since the last flood, none of which is known to be a bridge
  std::size_t m_cost = 0;      // faces that were searched since then
  std::vector<unsigned char> m_mark;
  std::vector<Index> m_side[2];
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_INTERNAL_NONSEPARATING_CHORDS_H
