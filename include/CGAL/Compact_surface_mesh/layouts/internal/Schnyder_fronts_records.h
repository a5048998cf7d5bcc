// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_FRONTS_RECORDS_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_FRONTS_RECORDS_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/internal/Large_array.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_side.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace internal {

/*
The arrays of the fronts layouts: one record per vertex, or per sector of a vertex. A front is a
halfedge, 8x + k for side k of record x. The front left of an edge out of x, seen along it, is the side that follows
in the left face, and the front right of it the one that precedes in the right face: both at the target.

  word            | 6 fronts    | 5 fronts        | 4 fronts
  ----------------+-------------+-----------------+-----------------------------------------
  red_left        | left of red | toleft of red   | toleft of red, or its target
  red_right       | right       | right of red    | -
  blue_left, blue | left        | the one beside a red edge into x, else the right one
  blue_right      | right       | -               | -
  black_left      | left        | left of black   | left of black
  black_right     | right       | right of black  | right of black
  other_target    |             |                 | with targets: that of the blue or black edge

  toleft: k = 1, the left front is red: it, and in 4 fronts, where it is the previous sibling, the target
          k = 2, it is blue, and followed around the target by a red edge: it
          k = 5, it is blue, and followed by a black edge: that one

The highest bit of a word is a flag. Words of missing edges, those at V_0 and V_1, have k = 7. Around
apices, which have no record, the word red_left has the preceding vertex with k = 6, and k = 7 if the apex closes
a cap; but if siblings are numbered consecutively, that of the last one has the first one. In isolated vertices, it has
the vertex itself with k = 6, in further sectors, their vertex.
The black word of V_1 has the left front of the blue edge in place of the right one of the black edge.
*/
template <int References, bool has_targets, class Index>
class Schnyder_fronts_records
{
  static_assert(has_targets ? References == 5 : 4 <= References && References <= 6,
                "a record has 4, 5 or 6 references, with targets 5");

public:
  typedef Schnyder_side<Index> Side;

  static constexpr unsigned num_fronts = References - (has_targets ? 1 : 0);
  static constexpr bool stores_targets = has_targets;
  // whether red siblings are numbered consecutively, counterclockwise
  static constexpr bool is_renumbered = num_fronts == 4;

  enum : unsigned { red_left = 0, red_right = 1, blue_left = 2, blue_right = 3, blue = num_fronts - 3,
                    black_left = num_fronts - 2, black_right = num_fronts - 1, other_target = num_fronts };
  enum : unsigned { has_in_red = 0, has_in_blue = 1, has_in_black = 2, plain = 3, black_target = 4 }; // words of flags
  enum : unsigned { border = 6, cap = 7, missing = 7 }; // k

  static constexpr std::size_t max_records = std::size_t(1) << (std::numeric_limits<Index>::digits - 4);

  struct alignas(References == 4 ? 4 * sizeof(Index) : sizeof(Index)) Record
  {
    Index word[References];
  };

  Large_array<Record> records;

  static Index code(Side s) { return static_cast<Index>(8 * s.x + s.k); }
  static Side side(Index code) { return { code >> 3, static_cast<unsigned>(code & 7) }; }

  Index code_at(Index x, unsigned word) const { return static_cast<Index>(records[x].word[word] & ~flag); }
  Side side_at(Index x, unsigned word) const { return side(code_at(x, word)); }
  Index record_at(Index x, unsigned word) const { return code_at(x, word) >> 3; }
  unsigned k_at(Index x, unsigned word) const { return static_cast<unsigned>(records[x].word[word] & 7); }

  void set_code(Index x, unsigned word, Index code)
  {
    Index& w = records[x].word[word];
    w = static_cast<Index>((w & flag) | code);
  }
  void set_side(Index x, unsigned word, Side s) { set_code(x, word, code(s)); }

  bool has(unsigned flag_word, Index x) const { return (records[x].word[flag_word] & flag) != 0; }
  void set(unsigned flag_word, Index x) { records[x].word[flag_word] |= flag; }
  void clear(unsigned flag_word, Index x) { records[x].word[flag_word] &= static_cast<Index>(~flag); }

  // Whether all around the edges out of x is as in the core.
  bool is_plain(Index x) const { return has(plain, x); }

  // Whether x has no edge of color k / 2 out, where k = 2, 4.
  bool lacks(Index x, unsigned k) const
  {
    return k_at(x, k == 4 ? black_left : num_fronts == 6 ? blue_left : blue) == missing;
  }

private:
  static constexpr Index flag = static_cast<Index>(Index(1) << (std::numeric_limits<Index>::digits - 1));
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_FRONTS_RECORDS_H
