// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_PARENTS_BUILDER_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_PARENTS_BUILDER_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_parents_records.h>
#include <CGAL/Schnyder_woods/internal/Schnyder_wood.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

/*
Numbers the vertices of a closed triangulation by its Schnyder wood, and writes their
records. Families of red siblings get consecutive indices, depth first: that is the
order with the best locality. Last come the families of the apices.

One turn around each vertex, when its family is numbered, finds all that its record
holds; indices of vertices that are not numbered yet are translated at the end.
*/
template <int References, class Index>
class Schnyder_parents_builder
{
  typedef Schnyder_parents_records<References, Index> Records;
  typedef Corner_table<Index> Table;

public:
  Schnyder_parents_builder(const Closed_triangulation<Index>& t, const Schnyder_wood& wood, Records& records)
    : m_triangulation(t), m_table(t.table()), m_wood(wood), m_records(records),
      m_number(t.num_user_vertices()), m_red_edge(t.num_user_vertices()), m_next_number(0)
  {}

  // Writes the records and returns the number of each vertex of the input.
  std::vector<Index> operator()()
  {
    m_records.records.assign(m_number.size(), typename Records::Record{});
    find_red_edges();
    number_border_families();
    while (!m_stack.empty()) {
      const Index v = m_stack.back();
      m_stack.pop_back();
      write_record(v, turn(v));
    }
    translate();
    m_records.long_lists.shrink_to_fit();
    return std::move(m_number);
  }

private:
  // What one turn around a vertex finds: vertices by their indices in the input.
  struct Star
  {
    Index blue_out = Table::null(), black_out = Table::null(); // halfedges
    Index first_child = 0;                                     // a number
    std::size_t children = 0, in_black = 0, in_blue = 0;
    Index last_in_black = 0, first_in_blue = 0;
  };

  void find_red_edges()
  {
    for (std::size_t h = 0; h < m_table.num_halfedges(); ++h)
      if (m_wood.is_out(h, red) && m_table.source(static_cast<Index>(h)) < m_number.size())
        m_red_edge[m_table.source(static_cast<Index>(h))] = static_cast<Index>(h);
  }

  // The apices' families follow all others. They are cyclic: the idle red parents
  // of their ends name each other.
  void number_border_families()
  {
    std::size_t border = m_number.size();
    for (const auto& root : m_triangulation.roots())
      border -= family_of(root).size();
    for (const auto& root : m_triangulation.roots()) {
      const std::vector<Index> family = family_of(root);
      const Index begin = static_cast<Index>(border), end = static_cast<Index>(border + family.size());
      for (std::size_t i = 0; i < family.size(); ++i) {
        m_number[family[i]] = static_cast<Index>(begin + i);
        set_index(begin + i, 0, static_cast<Index>(begin + i));
      }
      set_index(begin, 0, end - 1);
      set_index(end - 1, 0, begin);
      mark_ends(begin, end);
      m_stack.insert(m_stack.end(), family.rbegin(), family.rend());
      border = end;
    }
  }

  // The vertices around an apex, counterclockwise from V_0 to V_1.
  std::vector<Index> family_of(const typename Closed_triangulation<Index>::Root& root) const
  {
    std::vector<Index> family;
    const Index first = m_table.opposite(m_table.next(root.base));
    Index h = first;
    do {
      family.push_back(m_table.target(h));
      h = m_table.next_around_source(h);
    } while (h != first);
    return family;
  }

  Star turn(Index v)
  {
    Star star;
    star.first_child = m_next_number;
    const std::size_t pushed = m_stack.size();
    const Index red_out = m_red_edge[v];
    for (Index h = m_table.next_around_source(red_out); h != red_out; h = m_table.next_around_source(h)) {
      const Index u = m_table.target(h);
      const bool out = m_wood.is_outgoing(h);
      switch (m_wood.color(h)) {
      case black:
        if (out)
          star.black_out = h;
        else {
          ++star.in_black;
          star.last_in_black = u;
        }
        break;
      case blue:
        if (out)
          star.blue_out = h;
        else if (star.in_blue++ == 0)
          star.first_in_blue = u;
        break;
      default:
        ++star.children;
        m_number[u] = m_next_number++;
        m_stack.push_back(u);
      }
    }
    std::reverse(m_stack.begin() + pushed, m_stack.end());
    return star;
  }

  void write_record(Index v, const Star& star)
  {
    const Index x = m_number[v];
    for (std::size_t i = 0; i < star.children; ++i)
      set_index(star.first_child + i, 0, x);
    if (star.children != 0)
      mark_ends(star.first_child, static_cast<Index>(star.first_child + star.children));

    set_index(x, 1, star.blue_out == Table::null() ? v : m_table.target(star.blue_out));
    set_index(x, 2, star.black_out == Table::null() ? v : m_table.target(star.black_out));
    set_flag(x, 0, Records::has_in_blue, star.in_blue != 0);
    set_flag(x, 1, Records::has_in_black, star.in_black != 0);
    if (star.blue_out != Table::null())
      set_flag(x, 1, Records::more_in_blue, m_wood.is_in(m_table.next(star.blue_out), blue));
    if (star.black_out != Table::null()) {
      const Index back = m_table.opposite(star.black_out);
      set_flag(x, 1, Records::more_in_black, m_wood.is_out(m_table.prev(back), black));
      set_flag(x, 0, Records::first_in_black, m_wood.is_out(m_table.next(star.black_out), red));
    }
    write_lists(x, star);
  }

  void write_lists(Index x, const Star& star)
  {
    const bool is_leaf = star.children == 0;
    const bool both = star.in_black != 0 && star.in_blue != 0;
    const Index one = star.in_black != 0 ? star.last_in_black : star.first_in_blue;
    const bool far = References == 4 ? (is_leaf ? both && star.in_blue > Records::max_walk
                                                : (std::max)(star.in_black, star.in_blue) > Records::max_walk)
                                     : References == 5 && !is_leaf && both && star.in_blue > Records::max_walk;
    if (far || star.children >= Records::many) {
      set_index(x, 3, static_cast<Index>(m_records.long_lists.size()));
      set_flag(x, 3, Records::many, !is_leaf);
      set_flag(x, 2, Records::far, is_leaf);
      m_records.long_lists.push_back({ star.first_child, static_cast<Index>(star.first_child + star.children - 1),
                                       star.last_in_black, star.first_in_blue });
    } else {
      set_index(x, 3, is_leaf ? (References == 4 ? one : star.first_in_blue) : star.first_child);
      set_flag(x, 3, static_cast<Index>(star.children), true);
    }
    if (References == 5)
      set_index(x, 4, one);
    if (References == 6) {
      set_index(x, 4, star.last_in_black);
      set_index(x, References - 1, star.first_in_blue);
    }
  }

  // Replaces what the records hold of the input's indices by numbers.
  void translate()
  {
    for (std::size_t x = 0; x < m_records.records.size(); ++x) {
      for (unsigned word : { 1u, 2u })
        translate(x, word);
      const unsigned count = m_records.child_count(static_cast<Index>(x));
      if (count == 0 && !(m_records.records[x].word[2] & Records::far))
        translate(x, 3);
      for (unsigned word = 4; word < References; ++word)
        translate(x, word);
    }
    for (auto& lists : m_records.long_lists)
      for (Index* v : { &lists.last_in_black, &lists.first_in_blue })
        *v = m_number[*v];
  }

  void translate(std::size_t x, unsigned word)
  {
    set_index(x, word, m_number[m_records.parent(static_cast<Index>(x), word)]);
  }

  void mark_ends(Index begin, Index end)
  {
    set_flag(begin, 0, Records::first, true);
    set_flag(end - 1, 0, Records::last, true);
  }

  void set_index(std::size_t x, unsigned word, Index i)
  {
    Index& w = m_records.records[x].word[word];
    w = static_cast<Index>((i << Records::flag_bits) | (w & Records::flag_mask));
  }

  void set_flag(std::size_t x, unsigned word, Index flag, bool on)
  {
    if (on)
      m_records.records[x].word[word] |= flag;
  }

  const Closed_triangulation<Index>& m_triangulation;
  const Table& m_table;
  const Schnyder_wood& m_wood;
  Records& m_records;
  std::vector<Index> m_number;   // of each vertex of the input
  std::vector<Index> m_red_edge; // the halfedge from each vertex to its red parent
  std::vector<Index> m_stack;    // vertices whose children have no numbers yet
  Index m_next_number;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_PARENTS_BUILDER_H
