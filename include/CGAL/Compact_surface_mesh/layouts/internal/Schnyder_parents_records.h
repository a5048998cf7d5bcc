// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_PARENTS_RECORDS_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_PARENTS_RECORDS_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/internal/Large_array.h>

#include <boost/config.hpp>

#include <cstddef>
#include <limits>
#include <vector>

// Tests count here how long the walks along lists are.
#ifndef CGAL_SCHNYDER_PARENTS_LAYOUT_COUNT_STEP
#  define CGAL_SCHNYDER_PARENTS_LAYOUT_COUNT_STEP
#endif

namespace CGAL {
namespace internal {

/*
The arrays of the parents layout: one record per vertex, or per sector of a vertex. In the words of a record the
lower four bits are flags, the others an index.

  word | index                               | flags
  -----+-------------------------------------+-------------------------------------------
    0  | red parent P                        | first, last: first, last red sibling
       |                                     | first_in_black: of its black parent's list
       |                                     | has_in_blue
    1  | blue parent W                       | has_in_black
       |                                     | more_in_black: not last of Q's list
       |                                     | more_in_blue: not last of W's list
       |                                     | irregular: of the edge to W, see Schnyder_parents_numbering
    2  | black parent Q                      | far: a leaf whose word 3 is as under 15
       |                                     | has_sectors: the vertex has further records
       |                                     | has_fans: the vertex has further fans
       |                                     | irregular: of the edge to Q
    3  | number of red children              | that number:
       |   0: last in-black, else first in-blue
       |   1..14: first red child
       |   15: position in the table of long lists
    4  | 5 references: last in-black, else first in-blue; 6: last in-black
    5  | 6 references: first in-blue

A missing parent is the vertex itself. Red siblings have consecutive indices. The
lists of a vertex v are, in the order of this word's first and last:

  in-black, counterclockwise from the red edge out of v: the vertices with black parent v
  in-blue, counterclockwise to the red edge out of v:    the vertices with blue parent v

In-black is walked counterclockwise and in-blue clockwise, both away from the red edge;
the ends of these walks are stored where there is a word for them. Where there is none, a
list of more than `max_walk` vertices gets an entry in the table of long lists, so that
no walk is longer.
*/
template <int References, class Index>
class Schnyder_parents_records
{
  static_assert(4 <= References && References <= 6, "a record has 4, 5 or 6 references");

public:
  enum : unsigned { flag_bits = 4, flag_mask = 15 };
  enum : Index { first = 1, last = 2, first_in_black = 4, has_in_blue = 8 };   // word 0
  enum : Index { has_in_black = 1, more_in_black = 2, more_in_blue = 4 };      // word 1
  enum : Index { far = 1, has_sectors = 2, has_fans = 4 };                     // word 2
  enum : Index { irregular = 8 };                                              // words 1 and 2
  enum : unsigned { many = 15 };                                               // word 3

  static constexpr std::size_t max_walk = 32;
  static constexpr std::size_t max_records = std::size_t(1) << (std::numeric_limits<Index>::digits - flag_bits);

  struct alignas(References == 4 ? 4 * sizeof(Index) : sizeof(Index)) Record
  {
    Index word[References];
  };

  // What a record has no room for.
  struct Long_lists
  {
    Index first_child, last_child, last_in_black, first_in_blue;
  };

  Large_array<Record> records;
  std::vector<Long_lists> long_lists;

  Index parent(Index x, unsigned word) const { return records[x].word[word] >> flag_bits; }
  Index red_parent(Index x) const { return parent(x, 0); }
  Index blue_parent(Index x) const { return parent(x, 1); }
  Index black_parent(Index x) const { return parent(x, 2); }

  bool is_first(Index x) const { return records[x].word[0] & first; }
  bool is_last(Index x) const { return records[x].word[0] & last; }
  bool is_first_in_black(Index x) const { return records[x].word[0] & first_in_black; }
  bool in_blue(Index x) const { return records[x].word[0] & has_in_blue; }
  bool in_black(Index x) const { return records[x].word[1] & has_in_black; }
  bool more_black(Index x) const { return records[x].word[1] & more_in_black; }
  bool more_blue(Index x) const { return records[x].word[1] & more_in_blue; }

  bool has_more_sectors(Index x) const { return records[x].word[2] & has_sectors; }
  bool is_irregular(Index x, unsigned word) const { return word != 0 && (records[x].word[word] & irregular) != 0; }
  bool has_more_fans(Index x) const { return records[x].word[2] & has_fans; }

  unsigned child_count(Index x) const { return static_cast<unsigned>(records[x].word[3]) & flag_mask; }
  bool is_leaf(Index x) const { return child_count(x) == 0; }
  const Long_lists& lists(Index x) const { return long_lists[records[x].word[3] >> flag_bits]; }

  // Both for inner nodes of the red tree only.
  Index first_child(Index x) const
  {
    const Index c = records[x].word[3];
    return BOOST_LIKELY((c & flag_mask) != many) ? c >> flag_bits : long_lists[c >> flag_bits].first_child;
  }
  Index last_child(Index x) const
  {
    const Index c = records[x].word[3];
    return BOOST_LIKELY((c & flag_mask) != many) ? (c >> flag_bits) + (c & flag_mask) - 1
                                                 : long_lists[c >> flag_bits].last_child;
  }

  Index number_of_children(Index x) const
  {
    const unsigned count = child_count(x);
    return BOOST_LIKELY(count != many) ? count : lists(x).last_child - lists(x).first_child + 1;
  }

  // The last one of in-black, which is not empty, where a record has it.
  bool has_last_in_black(Index x) const { return References >= 5 || (is_leaf(x) && !(records[x].word[2] & far)); }
  Index last_in_black(Index x) const { return parent(x, References >= 5 ? 4 : 3); }

  // The same elsewhere; `start` is the first one.
  template <class NextInBlack>
  Index searched_last_in_black(Index x, Index start, const NextInBlack& next_in_black) const
  {
    const unsigned count = child_count(x);
    if (count == 0 || count == many)
      return lists(x).last_in_black;
    while (more_black(start)) {
      CGAL_SCHNYDER_PARENTS_LAYOUT_COUNT_STEP
      start = next_in_black(start);
    }
    return start;
  }

  // The first one counterclockwise of in-blue, which is not empty and whose last one is `start`.
  Index first_in_blue(Index x, Index start) const
  {
    if constexpr (References == 6)
      return parent(x, 5);
    else {
      const Index c = records[x].word[3];
      const unsigned count = c & flag_mask;
      if (References == 5 && !in_black(x))
        return parent(x, 4);
      if (count == 0 && (References == 5 || !(in_black(x) || (records[x].word[2] & far))))
        return c >> flag_bits;
      if (count == many || (count == 0 && (records[x].word[2] & far)))
        return long_lists[c >> flag_bits].first_in_blue;
      while (more_blue(start)) {
        CGAL_SCHNYDER_PARENTS_LAYOUT_COUNT_STEP
        start = next_in_blue(start);
      }
      return start;
    }
  }

  // The next one clockwise in the in-blue list of blue_parent(x), if there are more.
  Index next_in_blue(Index x) const { return is_leaf(x) ? black_parent(x) : first_child(x); }
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_PARENTS_RECORDS_H
