// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_PAIRED_TRIANGLES_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_PAIRED_TRIANGLES_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Corner_table.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Matched_triangles.h>

#include <CGAL/Random.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace internal {

/*
Gives as many vertices as it can a second triangle, next to the first one around the vertex: the
two are a quad. Each vertex that had a triangle keeps one.

Triangles that have no vertex go for a walk: a triangle joins a vertex, if need be in place of one that the vertex
has, and that one walks on. No step loses a quad. A walk ends when it makes a further one, which takes a
vertex with one triangle beside a triangle with no vertex: there are about as many of one kind as of the
other, so if they are a part p of all then a walk takes about 1/p steps, and it takes n log(1/p) steps to
come to p. `max_steps` bounds the walks, and the time is linear.

What cannot be known beforehand is how many quads there can be at most: on a sphere n-4, less where degrees
are small. On real meshes 97 % of the vertices get one.
*/
template <class Index>
class Paired_triangles
{
  typedef Corner_table<Index> Table;

public:
  explicit Paired_triangles(Matched_triangles<Index>& matched)
    : m_matched(matched), m_is_pair(matched.num_vertices(), false), m_random(0)
  {
    for (int steps = 0; steps <= max_steps; steps = 4 * steps + 8)
      for (std::size_t f = 0; f < matched.table().num_faces(); ++f)
        if (matched.owner(static_cast<Index>(f)) == null())
          walk(static_cast<Index>(f), steps);
  }

  // Whether v has two triangles: the second one is that of matched.following(matched.into(v)). Where v is on a border,
  // it is the second one that is behind the border.
  bool is_pair(Index v) const { return m_is_pair[v]; }

private:
  enum : int { max_steps = 200 };
  enum Value { loses = -1, keeps = 0, gains = 1 };

  // The target of `into` has the triangle of `into` and, if `is_pair`, the following one.
  struct Choice
  {
    Index into;
    bool is_pair;
  };

  static constexpr Index null() { return Table::null(); }

  void walk(Index f, int steps)
  {
    for (int i = 0; i <= steps; ++i) {
      std::array<Choice, 9> kept;
      int num_kept = 0;
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        if (is_in_vain(h))
          continue;
        for (const Choice& choice : {Choice{h, true}, Choice{m_matched.preceding(h), true}, Choice{h, false}}) {
          const Value value = value_of(f, choice);
          if (value == gains) {
            choose(choice);
            return;
          }
          if (value == keeps)
            kept[num_kept++] = choice;
        }
      }
      if (num_kept == 0 || i == steps)
        return;
      f = choose(kept[m_random.uniform_int<int>(0, num_kept - 1)]);
    }
  }

  // Whether the target of h has two triangles, none of them beside that of h: all choices lose then.
  bool is_in_vain(Index h) const
  {
    const Index v = m_matched.table().target(h);
    return m_matched.is_apex(v)
           || (m_is_pair[v] && m_matched.owner(Table::face(m_matched.following(h))) != v
               && m_matched.owner(Table::face(m_matched.preceding(h))) != v);
  }

  // What the choice, of which f is a part, does to the number of quads.
  Value value_of(Index f, const Choice& choice) const
  {
    const Index v = m_matched.table().target(choice.into);
    if (m_matched.into(v) == null())
      return loses;
    if (!choice.is_pair)
      return m_is_pair[v] || is_fixed(v) ? loses : keeps;
    const Index second = Table::face(m_matched.following(choice.into));
    const Index other = Table::face(choice.into) == f ? second : Table::face(choice.into);
    const Index w = m_matched.owner(other);
    if (w == v) {
      if (!m_is_pair[v])
        return m_matched.is_copy(v) ? loses : gains;
      return m_matched.is_face(Table::face(other_into(v, other))) ? keeps : loses;
    }
    if (m_is_pair[v] || is_fixed(v))
      return loses;
    if (w == null())
      return gains;
    return m_is_pair[w] && m_matched.is_face(other) ? keeps : loses;
  }

  // A vertex on a border keeps the triangle behind it.
  bool is_fixed(Index v) const
  {
    const Index h = m_matched.into(v);
    return !m_matched.is_face(Table::face(m_is_pair[v] ? m_matched.following(h) : h));
  }

  // Of the two triangles of v, the halfedge in that which is not f.
  Index other_into(Index v, Index f) const
  {
    const Index h = m_matched.into(v);
    return Table::face(h) == f ? m_matched.following(h) : h;
  }

  // Makes a choice that loses no quad, and returns the triangle that has no vertex now, null if all of
  // those which were concerned have one.
  Index choose(const Choice& choice)
  {
    const Index v = m_matched.table().target(choice.into);
    const Index before = m_matched.into(v), second_before = m_matched.following(before);
    const Index second = Table::face(m_matched.following(choice.into));
    m_matched.set_owner(Table::face(before), null());
    if (m_is_pair[v])
      m_matched.set_owner(Table::face(second_before), null());
    take_from_pair(Table::face(choice.into));
    m_matched.give(choice.into);
    if (choice.is_pair) {
      take_from_pair(second);
      m_matched.set_owner(second, v);
    }
    const bool was_pair = m_is_pair[v];
    m_is_pair[v] = choice.is_pair;
    if (m_matched.owner(Table::face(before)) == null())
      return Table::face(before);
    return was_pair && m_matched.owner(Table::face(second_before)) == null() ? Table::face(second_before) : null();
  }

  // If f is one of two triangles of a vertex, the other one remains.
  void take_from_pair(Index f)
  {
    const Index w = m_matched.owner(f);
    if (w == null())
      return;
    const Index left = other_into(w, f);
    m_matched.set_owner(f, null());
    m_matched.give(left);
    m_is_pair[w] = false;
  }

  Matched_triangles<Index>& m_matched;
  std::vector<bool> m_is_pair;
  Random m_random;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_PAIRED_TRIANGLES_H
