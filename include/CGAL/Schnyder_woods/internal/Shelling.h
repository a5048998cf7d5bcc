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
#include <CGAL/Compact_surface_mesh/internal/Large_array.h>
#include <CGAL/Schnyder_woods/Shelling_order.h>
#include <CGAL/Schnyder_woods/internal/Nonseparating_chords.h>
#include <CGAL/Schnyder_woods/internal/Schnyder_wood.h>

#include <CGAL/Random.h>

#include <boost/config.hpp>

#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

/*
Computes the g-Schnyder wood of a closed surface by conquering one corner after the
other, and opening a chord where none is free (E. Brehm for the sphere; for any genus
section 3.2 of the habilitation of L. Castelli Aleardi, 2022).

The conquered region C starts as the root face. Its complement D lies to the left of
its boundary, which starts as V_0 -> V_1 -> V_2. A corner is a place of the boundary:
a vertex together with the boundary halfedge that starts there. A chord is an edge of D
off the boundary that joins two corners. A corner without chords is free. Conquering it
moves its faces from D to C and colors their edges.

On the sphere some corner always is free, unless D is empty. On other surfaces the boundary
may have several walks and a vertex several corners. If no corner is free, some chord
does not separate D. It is opened: its edge becomes a special one, with both of its sides on
the boundary, and each of its ends gets one corner more.

C may start with the stars of further roots as well: their edges are red and lead to the
root, and the walk around the star is one more part of the boundary.

Time linear in the size of the component, but for the search for chords to open (see
Nonseparating_chords), and for turning around vertices with several corners.
*/
template <class Index>
class Shelling
{
  typedef Corner_table<Index> Table;

public:
  // One shelling serves all components of a table.
  Shelling(const Table& table, Schnyder_wood& wood, Shelling_order order = Shelling_order::LAST_IN_FIRST_OUT,
           unsigned int seed = 0)
    : m_table(table), m_wood(wood), m_order(order), m_random(seed),
      m_corner_of_vertex(table.num_vertices(), Table::null()), m_nonseparating(table, wood)
  {}

  // Shells the component of `base`, which has num_faces faces, none of them colored.
  // `base` runs from V_1 to V_0 with the root face to its left. For each further root there
  // is one halfedge that starts there. The stars of all roots, V_2 included, share no vertex.
  // Calls conquered(v) for each corner that is conquered, with its vertex.
  // Returns whether the whole component is conquered: always, if it is simple.
  template <class HalfedgeRange, class Visitor>
  bool operator()(Index base, const HalfedgeRange& further_roots, std::size_t num_faces, Visitor&& conquered)
  {
    start(base, num_faces);
    for (const Index root : further_roots)
      if (!start_at_star(root))
        return false;
    if (m_corners[2].chords != 0)
      return false;
    const std::size_t num_corners = m_corners.size();
    conquered(vertex(2)); // V_2, before it gets a chord
    if (!conquer(2))
      return false;
    for (std::size_t c = 3; c < num_corners; ++c)
      push(static_cast<Index>(c));
    while (m_faces_left != 0) {
      if (m_queue.empty()) {
        if (!open_chords())
          return false;
        continue;
      }
      const Index corner = pop();
      m_corners[corner].is_waiting = false;
      if (m_corners[corner].chords != 0)
        continue;
      const Index v = vertex(corner);
      if (!conquer(corner))
        return false;
      conquered(v);
    }
    color_root_edges(m_table, base, m_wood);
    return true;
  }

private:
  struct Corner
  {
    Index start;      // the boundary halfedge that starts here; its face is in D
    Index next, prev; // along the boundary; next also links the corners out of use
    Index twin;       // the next corner of the same vertex, in a cycle
    Index chords;
    bool is_waiting; // in the queue; always at the ends of the root edge, which is the start of corner 0
  };

  void start(Index base, std::size_t num_faces)
  {
    m_base = base;
    m_faces_left = num_faces - 1;
    m_corners.clear();
    m_free_corner = Table::null();
    m_queue.clear();
    m_nonseparating.clear();

    for (const Index h : root_face(m_table, base))
      m_wood.set_copy(h, red, false); // the root face is not in D
    for (const Index h : { base, m_table.prev(base), m_table.next(base) })
      set_corner_of_vertex(new_corner(m_table.opposite(h)));
    m_corners[0].is_waiting = m_corners[1].is_waiting = true; // they are never conquered
    link(0, 1);
    link(1, 2);
    link(2, 0);
  }

  // The walk around the star, from its neighbor to neighbor clockwise, is boundary.
  bool start_at_star(Index root)
  {
    const Index first = static_cast<Index>(m_corners.size());
    Index h = root;
    do {
      --m_faces_left;
      m_wood.set_edge(m_table.opposite(h), h, red);
      const Index entered = new_corner(m_table.opposite(m_table.next(h)));
      if (entered != first)
        link(entered, static_cast<Index>(entered - 1));
      h = m_table.next_around_source(h);
    } while (h != root);
    const Index last = static_cast<Index>(m_corners.size() - 1);
    link(first, last);
    return enter(last, first) && enter(first, last);
  }

  Index vertex(Index corner) const { return m_table.source(m_corners[corner].start); }

  // Takes the fan of faces between the edges to the right and left neighbor.
  BOOST_FORCEINLINE bool conquer(Index corner)
  {
    const Index right = m_corners[corner].next, left = m_corners[corner].prev;
    const Index to_right = m_corners[corner].start;
    const Index from_left = m_corners[left].start, to_left = m_table.opposite(from_left);
    color_boundary(to_right, m_table.opposite(to_right), blue, true);
    color_boundary(from_left, to_left, black, false);

    // the new boundary grows from the right neighbor to the left one
    Index last = right, num_faces = 0;
    for (Index h = to_right;;) {
      ++num_faces;
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

    m_faces_left -= num_faces;
    if (m_faces_left == 0)
      return true;
    if (last == right) // the fan was one face, and the chord across it is boundary now
      for (Index end : { left, right })
        --m_corners[end].chords;
    else if (!enter(m_corners[left].next, right))
      return false;
    push(left);
    for (Index c = left; c != right; push(c))
      c = m_corners[c].next;
    return true;
  }

  // Colors the boundary edge of h on the side of D, and on the other side unless it is special.
  void color_boundary(Index h, Index opposite, Schnyder_color c, bool is_outgoing)
  {
    if (m_nonseparating.is_active() && m_wood.is_special(h))
      m_wood.set_copy(h, c, is_outgoing);
    else if (is_outgoing)
      m_wood.set_edge(h, opposite, c);
    else
      m_wood.set_edge(opposite, h, c);
  }

  // The vertices of the corners from first to before end join the boundary, one after
  // the other, so that a chord between two of them is met once. Returns false if one of them
  // had joined before.
  BOOST_FORCEINLINE bool enter(Index first, Index end)
  {
    for (Index c = first; c != end; c = m_corners[c].next) {
      if (!set_corner_of_vertex(c))
        return false;
      const Index stop = m_table.opposite(m_corners[m_corners[c].prev].start);
      Index h = m_table.next_around_source(m_corners[c].start);
      for (; h != stop; h = m_table.next_around_source(h)) {
        const Index other = m_corner_of_vertex[m_table.target(h)];
        if (other != Table::null()) {
          ++m_corners[c].chords;
          add_chord(h, other);
        }
      }
    }
    return true;
  }

  // Adds chord h to the corner that it ends in, which has the same vertex as `corner`.
  void add_chord(Index h, Index corner)
  {
    if (m_nonseparating.is_active()) { // else no vertex has twins
      m_nonseparating.note(h);
      if (m_corners[corner].twin != corner)
        corner = corner_with(m_table.opposite(h), corner).corner;
    }
    ++m_corners[corner].chords;
  }

  struct Place
  {
    Index corner;
    Index chords; // of the corner, to the right of the halfedge
  };

  // The corner that has halfedge h between its boundary halfedges. `corner` has the same vertex.
  Place corner_with(Index h, Index corner) const
  {
    Place place = { corner, 0 };
    do {
      h = m_table.next(m_table.opposite(h)); // clockwise
      if (m_corner_of_vertex[m_table.target(h)] != Table::null())
        ++place.chords;
    } while (!m_wood.is_special(h) && m_nonseparating.is_inside(m_table.opposite(h)));
    --place.chords; // the last one is boundary
    while (m_corners[place.corner].start != h)
      place.corner = m_corners[place.corner].twin;
    return place;
  }

  // Opens chords that do not separate D, and returns whether there are any. As long as
  // D has no vertex inside of double edges, there are.
  bool open_chords()
  {
    return m_nonseparating.open_some(
      m_table.opposite(m_base), m_faces_left,
      [this](Index v) { return m_corner_of_vertex[v] != Table::null(); }, [this](Index h) { open(h); });
  }

  // Makes chord h special. Its two corners become four: each of them ends at the chord, and
  // a new one starts there.
  void open(Index h)
  {
    const Index o = m_table.opposite(h);
    const Index u = split_corner(h), w = split_corner(o);
    m_wood.set_special(h, o);
    const Index after_u = m_corners[u].twin, after_w = m_corners[w].twin;
    const Index before_u = m_corners[u].prev, before_w = m_corners[w].prev;
    link(before_u, after_u);
    link(after_u, w);
    link(before_w, after_w);
    link(after_w, u);
    for (const Index corner : { u, w, after_u, after_w })
      push(corner);
  }

  // Splits the corner that has chord h, which becomes its first part; the second
  // one starts at the chord and is its next twin.
  Index split_corner(Index h)
  {
    const Place place = corner_with(h, m_corner_of_vertex[m_table.source(h)]);
    const Index index = new_corner(h);
    Corner &first = m_corners[place.corner], &second = m_corners[index];
    second.chords = static_cast<Index>(first.chords - place.chords - 1);
    second.twin = std::exchange(first.twin, index);
    first.chords = place.chords;
    if (first.prev == 0) // the second part is the one at the root edge
      std::swap(first.is_waiting, second.is_waiting);
    return place.corner;
  }

  // A corner that was in use before had no chords, no twin and no place in the queue at last.
  Index new_corner(Index start)
  {
    if (m_free_corner == Table::null()) {
      const Index corner = static_cast<Index>(m_corners.size());
      m_corners.push_back(Corner{ start, 0, 0, corner, 0, false });
      return corner;
    }
    const Index corner = std::exchange(m_free_corner, m_corners[m_free_corner].next);
    m_corners[corner].start = start;
    return corner;
  }

  void release(Index corner)
  {
    if (m_nonseparating.is_active() && m_corners[corner].twin != corner)
      part_from_twins(corner);
    m_corners[corner].next = std::exchange(m_free_corner, corner);
  }

  void part_from_twins(Index corner)
  {
    const Index following = m_corners[corner].twin;
    Index previous = following;
    while (m_corners[previous].twin != corner)
      previous = m_corners[previous].twin;
    m_corners[previous].twin = following;
    m_corners[corner].twin = corner;
    m_corner_of_vertex[vertex(corner)] = following;
  }

  // The vertex of the corner joins the boundary. Returns false if it had done so before.
  bool set_corner_of_vertex(Index corner)
  {
    return std::exchange(m_corner_of_vertex[vertex(corner)], corner) == Table::null();
  }

  // The boundary goes from `from` to `to`.
  void link(Index from, Index to)
  {
    m_corners[from].next = to;
    m_corners[to].prev = from;
  }

  // Queues a corner if it is free. It leaves the queue before it is conquered, so that no
  // other one is met there in its place.
  void push(Index corner)
  {
    Corner& c = m_corners[corner];
    if (c.chords != 0 || c.is_waiting)
      return;
    c.is_waiting = true;
    m_queue.push_back(corner);
  }

  BOOST_FORCEINLINE Index pop()
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

  const Table& m_table;
  Schnyder_wood& m_wood;
  const Shelling_order m_order;
  Random m_random;
  Index m_base = 0;
  std::size_t m_faces_left = 0;
  Large_array<Index> m_corner_of_vertex; // one of each vertex; null while it is not in C
  Large_array<Corner> m_corners;
  Index m_free_corner = Table::null();
  std::deque<Index> m_queue;
  Nonseparating_chords<Index> m_nonseparating;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_INTERNAL_SHELLING_H
