// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_INTERNAL_SHELLING_H
#define CGAL_SCHNYDER_WOODS_INTERNAL_SHELLING_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Corner_table.h>
#include <CGAL/Schnyder_woods/internal/Schnyder_wood.h>
#include <CGAL/Schnyder_woods/Shelling_order.h>

#include <CGAL/Random.h>

#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

/*
Computes a Schnyder wood by conquering one vertex after the other (E. Brehm; appendix A
of L. Castelli Aleardi and O. Devillers, Array-based compact data structures for
triangulations, JoCG 2018). Linear time.

The conquered region C starts as the root face. Its complement D lies to the left of
its boundary, which starts as V_0 -> V_1 -> V_2. A corner is a place of the boundary:
a vertex together with the boundary halfedge that starts there. A corner is free if no
edge of D joins its vertex to another boundary vertex (a chord). Conquering a free
corner moves its faces from D to C and colors their edges.

Everything here speaks of corners, not of vertices, and of the chords of D, not of a
disk: on other surfaces boundaries only have several walks and vertices several
corners. What is missing there is the step that opens a chord when no corner is free.
*/
template <class Index>
class Shelling
{
  typedef Corner_table<Index> Table;

public:
  // `base` runs from V_1 to V_0 with the root face to its left.
  Shelling(const Table& table, Index base, Schnyder_wood& wood,
           Shelling_order order = Shelling_order::LAST_IN_FIRST_OUT, unsigned int seed = 0)
    : m_table(table), m_wood(wood), m_order(order), m_random(seed),
      m_base(base), m_faces_left(table.num_faces()), m_chords(table.num_vertices(), Table::null())
  {
    const Index v0_v2 = table.next(base), v2_v1 = table.next(v0_v2);
    const Index start[3] = { table.opposite(base), table.opposite(v2_v1), table.opposite(v0_v2) };
    m_corners.reserve(64);
    for (const Index halfedge : start) {
      m_corners.push_back(Corner{ halfedge, 0, 0, false });
      m_chords[table.source(halfedge)] = 0;
    }
    link(0, 1);
    link(1, 2);
    link(2, 0);
    m_faces_left -= 1;
    push(2);
  }

  // Conquers until no corner is free, and calls conquered(v) for each vertex in turn.
  // Returns whether the whole surface is conquered: always on a simple triangulation
  // of the sphere.
  template <class Visitor>
  bool operator()(Visitor&& conquered)
  {
    while (m_faces_left != 0 && !m_queue.empty()) {
      const Index corner = pop();
      m_corners[corner].queued = false;
      const Index v = vertex(corner);
      if (m_chords[v] != 0)
        continue;
      conquer(corner);
      conquered(v);
    }
    if (m_faces_left != 0)
      return false;
    color_root_edges();
    return true;
  }

private:
  struct Corner
  {
    Index start;       // the boundary halfedge that starts here; its face is in D
    Index next, prev;  // along the boundary; next also links the corners out of use
    bool queued;
  };

  Index vertex(Index corner) const { return m_table.source(m_corners[corner].start); }

  // Takes the fan of faces between the edges to the right and left neighbor.
  void conquer(Index corner)
  {
    const Index right = m_corners[corner].next, left = m_corners[corner].prev;
    const Index to_right = m_corners[corner].start;
    const Index from_left = m_corners[left].start, to_left = m_table.opposite(from_left);
    m_wood.set_edge(to_right, m_table.opposite(to_right), blue);
    m_wood.set_edge(to_left, from_left, black);

    // the new boundary grows from the right neighbor to the left one
    Index last = right;
    for (Index h = to_right;;) {
      --m_faces_left;
      const Index outer = m_table.opposite(m_table.next(h));
      h = m_table.next_around_source(h);
      if (h == to_left) {
        m_corners[left].start = outer;
        break;
      }
      m_wood.set_edge(m_table.opposite(h), h, red);
      const Index entered = new_corner(outer);
      link(entered, last);
      last = entered;
    }
    link(left, last);
    release(corner);

    if (m_faces_left == 0)
      return;
    if (last == right) // the fan was one face, and the chord across it is boundary now
      for (Index end : { left, right })
        --m_chords[vertex(end)];
    else
      enter(m_corners[left].next, right);
    for (Index c = left;; c = m_corners[c].next) {
      push(c);
      if (c == right)
        break;
    }
  }

  // The vertices of the corners from first to before end join the boundary, one after
  // the other, so that a chord between two of them is met once.
  void enter(Index first, Index end)
  {
    for (Index c = first; c != end; c = m_corners[c].next) {
      Index& chords = m_chords[vertex(c)];
      chords = 0;
      const Index stop = m_table.opposite(m_corners[m_corners[c].prev].start);
      Index h = m_table.next_around_source(m_corners[c].start);
      for (; h != stop; h = m_table.next_around_source(h)) {
        Index& chords_of_target = m_chords[m_table.target(h)];
        if (chords_of_target != Table::null()) {
          ++chords;
          ++chords_of_target;
        }
      }
    }
  }

  Index new_corner(Index start)
  {
    if (m_free_corner == Table::null()) {
      m_corners.push_back(Corner{ start, 0, 0, false });
      return static_cast<Index>(m_corners.size() - 1);
    }
    const Index corner = std::exchange(m_free_corner, m_corners[m_free_corner].next);
    m_corners[corner].start = start;
    return corner;
  }

  void release(Index corner) { m_corners[corner].next = std::exchange(m_free_corner, corner); }

  // The boundary goes from `from` to `to`.
  void link(Index from, Index to)
  {
    m_corners[from].next = to;
    m_corners[to].prev = from;
  }

  // Queues a corner that is free now. The corners 0 and 1, of the root edge, are never
  // conquered; a corner leaves the queue before it is conquered, so none is stale there.
  void push(Index corner)
  {
    if (corner < 2 || m_corners[corner].queued || m_chords[vertex(corner)] != 0)
      return;
    m_corners[corner].queued = true;
    m_queue.push_back(corner);
  }

  Index pop()
  {
    if (m_order == Shelling_order::RANDOM)
      std::swap(m_queue.back(), m_queue[m_random.uniform_int<std::size_t>(0, m_queue.size() - 1)]);
    Index corner;
    if (m_order == Shelling_order::FIRST_IN_FIRST_OUT) {
      corner = m_queue.front();
      m_queue.pop_front();
    } else {
      corner = m_queue.back();
      m_queue.pop_back();
    }
    return corner;
  }

  // With the root edges V_0 V_2 and V_1 V_2 red and V_1 V_0 blue, every vertex but V_2
  // has a red parent, and each face is the left one of a red edge or the right one of a black edge.
  void color_root_edges()
  {
    const Index v0_v2 = m_table.next(m_base), v2_v1 = m_table.next(v0_v2), v1_v2 = m_table.opposite(v2_v1);
    m_wood.set_edge(v0_v2, m_table.opposite(v0_v2), red);
    m_wood.set_edge(v1_v2, v2_v1, red);
    m_wood.set_edge(m_base, m_table.opposite(m_base), blue);
  }

  const Table& m_table;
  Schnyder_wood& m_wood;
  const Shelling_order m_order;
  Random m_random;
  const Index m_base;
  std::size_t m_faces_left;
  std::vector<Index> m_chords; // of each vertex; null while it is not in C
  std::vector<Corner> m_corners;
  Index m_free_corner = Table::null();
  std::deque<Index> m_queue;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_INTERNAL_SHELLING_H
