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
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_parents_numbering.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_parents_records.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_sectors.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_wood_sides.h>
#include <CGAL/Schnyder_woods/internal/Schnyder_wood.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

/*
Numbers the vertices of a closed triangulation by its Schnyder wood, and writes their
records. Families of red siblings get consecutive indices, depth first: that is the
order with the best locality. Families outside the core are numbered from the end of the
records off the border downward, and last come the families of the apices.

One turn around each vertex, when its family is numbered, finds all that its records
hold; indices of vertices that are not numbered yet are translated at the end.
*/
template <int References, class Index>
class Schnyder_parents_builder
{
  typedef Schnyder_parents_records<References, Index> Records;
  typedef Schnyder_parents_numbering<Index> Numbering;
  typedef Corner_table<Index> Table;

public:
  Schnyder_parents_builder(const Closed_triangulation<Index>& t, const Schnyder_wood& wood,
                           Records& records, Numbering& numbering)
    : m_triangulation(t), m_table(t.table()), m_wood(wood), m_records(records), m_numbering(numbering),
      m_num_vertices(t.first_apex()), m_red_edge(red_edges_out(m_table, wood, m_num_vertices)),
      m_sectors(m_table, wood, m_red_edge)
  {}

  // Writes the records and all of the numbering but what is dead.
  // Throws Mesh_defect_exception if there are too many records.
  void operator()()
  {
    const std::size_t num_records = m_num_vertices + m_sectors.num_further();
    if (num_records > Records::max_records)
      throw Mesh_defect_exception(Mesh_defect::too_many_elements, num_records);
    reserve_huge_pages(m_number, num_records);
    m_number.resize(num_records);
    m_records.records.assign(num_records, typename Records::Record{});
    set_bounds();
    number_isolated_vertices();
    number_border_families();
    number_fans();
    find_core();
    while (!m_stack.empty()) {
      const Index v = m_stack.back();
      m_stack.pop_back();
      turn(v);
    }
    CGAL_assertion(m_next_number == m_end_of_plain);
    m_numbering.core = m_next_number;
    sort_sectors();
    translate();
    m_records.long_lists.shrink_to_fit();
  }

  // The sides of the halfedges, once the records are written.
  Schnyder_wood_sides<Index> sides() const { return { m_table, m_wood, m_sectors, m_number }; }

  // The record of each vertex but the apices, and of further sectors behind them.
  std::vector<Index> release_records_of_vertices() { return std::move(m_number); }

private:
  typedef typename Closed_triangulation<Index>::Root Root;

  // What a turn around a vertex finds in one of its sectors. Vertices, and further sectors
  // of other vertices, are named as by Schnyder_sectors.
  struct Sector
  {
    explicit Sector(Index name, bool is_first)
      : name(name), is_first(is_first)
    {}

    Index name;
    bool is_first, is_last = false;
    Index blue_out = Table::null(), black_out = Table::null(); // halfedges
    std::size_t children = 0, in_black = 0, in_blue = 0;
    Index last_in_black = 0, first_in_blue = 0;
  };

  void set_bounds()
  {
    std::size_t num_border_vertices = 0, num_caps = 0;
    for (const Root& root : m_triangulation.roots())
      if (m_triangulation.is_cap(root))
        ++num_caps;
      else
        num_border_vertices += root.degree;
    const std::size_t num_isolated =
        static_cast<std::size_t>(std::count(m_red_edge.begin(), m_red_edge.end(), Table::null()));
    m_numbering.end = static_cast<Index>(m_number.size());
    m_numbering.sectors = static_cast<Index>(m_num_vertices);
    m_numbering.isolated = static_cast<Index>(m_num_vertices - num_isolated);
    m_numbering.caps = static_cast<Index>(m_numbering.isolated - 3 * num_caps);
    m_numbering.border = static_cast<Index>(m_numbering.caps - num_border_vertices);
    m_end_of_free = m_end_of_plain = m_numbering.border;
  }

  void number_isolated_vertices()
  {
    Index x = m_numbering.isolated;
    for (std::size_t v = 0; v < m_num_vertices; ++v)
      if (m_red_edge[v] == Table::null())
        m_number[v] = x++;
  }

  // Families around apices are cyclic: the idle red parents of their ends name each other.
  void number_border_families()
  {
    Index border = m_numbering.border, cap = m_numbering.caps;
    for (const Root& root : m_triangulation.roots()) {
      const std::vector<Index> family = m_triangulation.vertices_around(root);
      Index& next = m_triangulation.is_cap(root) ? cap : border;
      const Index begin = next, end = static_cast<Index>(begin + family.size());
      next = end;
      for (std::size_t i = 0; i < family.size(); ++i) {
        m_number[family[i]] = static_cast<Index>(begin + i);
        set_index(begin + i, 0, static_cast<Index>(begin + i));
      }
      set_index(begin, 0, end - 1);
      set_index(end - 1, 0, begin);
      mark_ends(begin, end);
      m_stack.insert(m_stack.end(), family.rbegin(), family.rend());
    }
  }

  void number_fans()
  {
    m_numbering.fans = Schnyder_fans<Index>(m_triangulation.copies(), m_triangulation.first_copy(), m_number);
    for (const auto& fan : m_numbering.fans)
      set_flag(fan.record, 2, Records::has_fans, true);
    m_numbering.vertices = Filled_slots<Index>(m_num_vertices, m_numbering.fans.further_fans(), true);
  }

  // Vertices are not in the core if something is hidden around them, or if they or a neighbor
  // have several sectors, or a neighbor is not numbered as its record.
  void find_core()
  {
    const bool has_hidden = m_triangulation.simple().has_hidden();
    if (!has_hidden && m_sectors.num_further() == 0 && m_triangulation.copies().empty())
      return;
    m_is_outside.assign(m_num_vertices, false);
    for (const Index v : m_sectors.multiple_vertices())
      exclude_star(v);
    if (has_hidden)
      for (std::size_t h = 0; h < 3 * m_triangulation.num_open_faces(); ++h) {
        const Index c = m_triangulation.current_halfedge(static_cast<Index>(h));
        if (m_triangulation.is_hidden(c)) { // and so is its opposite, but on a border
          exclude(m_table.source(c));
          exclude(m_table.target(c));
          exclude(m_table.target(m_table.next(c)));
        }
      }
    const bool has_hidden_vertices = !m_triangulation.simple().stands_for().empty();
    if (has_hidden_vertices)
      find_families_of_hidden_vertices();
    if (has_hidden_vertices || !m_triangulation.copies().empty())
      for (std::size_t v = 0; v < m_num_vertices; ++v)
        if (is_on_border(static_cast<Index>(v))
            && (has_hidden_vertices || m_number[v] >= m_numbering.vertices.count()
                || m_records.has_more_fans(m_number[v])))
          exclude_star(static_cast<Index>(v));
  }

  // Hidden vertices shift the numbers of those behind them, so their families come last.
  void find_families_of_hidden_vertices()
  {
    const auto& simple = m_triangulation.simple();
    const auto is_child = [this](Index v) { return m_red_edge[v] != Table::null() && !is_on_border(v); };
    const auto parent = [this](Index v) { return m_sectors.sector(m_table, m_table.next(m_red_edge[v])); };
    m_has_hidden_child.assign(m_number.size(), false);
    for (std::size_t i = 0; i < simple.stands_for().size(); ++i) {
      const Index v = static_cast<Index>(simple.num_user_vertices() + i);
      if (is_child(v))
        m_has_hidden_child[parent(v)] = true;
    }
    for (std::size_t i = 0; i < m_num_vertices; ++i) {
      const Index v = static_cast<Index>(i);
      if (is_child(v) && m_has_hidden_child[parent(v)]) {
        exclude_star(v);
        --m_end_of_plain;
      }
    }
  }

  bool is_on_border(Index v) const
  {
    return m_red_edge[v] != Table::null() && m_table.target(m_red_edge[v]) >= m_num_vertices;
  }

  void exclude(Index v)
  {
    if (v < m_num_vertices)
      m_is_outside[v] = true;
  }

  void exclude_star(Index v)
  {
    exclude(v);
    Index h = m_red_edge[v];
    do {
      exclude(m_table.target(h));
      h = m_table.next_around_source(h);
    } while (h != m_red_edge[v]);
  }

  void turn(Index v)
  {
    const std::size_t pushed = m_stack.size();
    const Index red_out = m_red_edge[v];
    Sector sector(v, true);
    for (Index h = m_table.next_around_source(red_out); h != red_out; h = m_table.next_around_source(h)) {
      if (BOOST_UNLIKELY(m_wood.is_special(h))) { // its two copies belong to two sectors
        const Index o = m_table.opposite(h);
        note(sector, h, m_wood.color(o), !m_wood.is_outgoing(o), o);
        finish(sector);
        sector = Sector(m_sectors.sector(m_table, h), false);
      }
      note(sector, h, m_wood.color(h), m_wood.is_outgoing(h), m_table.next(h));
    }
    sector.is_last = true;
    finish(sector);
    std::reverse(m_stack.begin() + static_cast<std::ptrdiff_t>(pushed), m_stack.end());
  }

  // Notes a copy of the edge of h, at whose other end is the corner `far`.
  void note(Sector& sector, Index h, Schnyder_color color, bool out, Index far)
  {
    switch (color) {
    case black:
      if (out)
        sector.black_out = h;
      else {
        ++sector.in_black;
        sector.last_in_black = m_sectors.sector(m_table, far);
      }
      break;
    case blue:
      if (out)
        sector.blue_out = h;
      else if (sector.in_blue++ == 0)
        sector.first_in_blue = m_sectors.sector(m_table, far);
      break;
    default:
      ++sector.children;
      m_stack.push_back(m_table.vertex(far));
    }
  }

  void finish(const Sector& sector)
  {
    const Index x = sector.is_first ? m_number[sector.name] : sector.name;
    const Index first_child = number_children(sector, x);
    const Index blue_out = sector.blue_out, black_out = sector.black_out;
    set_index(x, 1, blue_out == Table::null() ? sector.name : m_sectors.sector(m_table, m_table.next(blue_out)));
    set_index(x, 2, black_out == Table::null() ? sector.name
                                               : m_sectors.sector(m_table, m_table.opposite(black_out)));
    set_flag(x, 0, Records::has_in_blue, sector.in_blue != 0);
    set_flag(x, 1, Records::has_in_black, sector.in_black != 0);
    if (blue_out != Table::null())
      set_flag(x, 1, Records::more_in_blue, m_wood.is_in(m_table.next(blue_out), blue));
    if (black_out != Table::null()) {
      const Index back = m_table.opposite(black_out);
      set_flag(x, 1, Records::more_in_black, m_wood.is_out(m_table.prev(back), black));
      set_flag(x, 0, Records::first_in_black, m_wood.is_out(m_table.next(black_out), red));
    }
    set_flag(x, 2, Records::has_sectors, sector.is_first && !sector.is_last);
    write_lists(x, sector, first_child);
  }

  // The children of the sector are the last ones on the stack.
  Index number_children(const Sector& sector, Index x)
  {
    if (sector.children == 0)
      return 0;
    const auto family = m_stack.end() - static_cast<std::ptrdiff_t>(sector.children);
    const bool is_outside = !m_is_outside.empty()
        && std::any_of(family, m_stack.end(), [this](Index u) { return m_is_outside[u]; });
    Index first = m_next_number;
    if (is_outside) {
      Index& end = !m_has_hidden_child.empty() && m_has_hidden_child[sector.name] ? m_end_of_free : m_end_of_plain;
      first = end = static_cast<Index>(end - sector.children);
    } else
      m_next_number = static_cast<Index>(m_next_number + sector.children);
    Index number = first;
    for (auto u = family; u != m_stack.end(); ++u) {
      m_number[*u] = number;
      set_index(number++, 0, x);
    }
    mark_ends(first, number);
    return first;
  }

  // Lists of more than `max_walk` elements are noted in the table of long lists, and those
  // that cannot be walked from the red edge on, because a special edge is between.
  void write_lists(Index x, const Sector& s, Index first_child)
  {
    const bool is_leaf = s.children == 0;
    const bool both = s.in_black != 0 && s.in_blue != 0;
    const Index one = s.in_black != 0 ? s.last_in_black : s.first_in_blue;
    const bool long_black = s.in_black > Records::max_walk || (s.in_black != 0 && !s.is_first);
    const bool long_blue = s.in_blue > Records::max_walk || (s.in_blue != 0 && !s.is_last);
    const bool far = References == 4 ? (is_leaf ? both && long_blue : long_black || long_blue)
                                     : References == 5 && !is_leaf && both && long_blue;
    if (far || s.children >= Records::many) {
      set_index(x, 3, static_cast<Index>(m_records.long_lists.size()));
      set_flag(x, 3, Records::many, !is_leaf);
      set_flag(x, 2, Records::far, is_leaf);
      m_records.long_lists.push_back({ first_child, static_cast<Index>(first_child + s.children - 1),
                                       s.last_in_black, s.first_in_blue });
    } else {
      set_index(x, 3, is_leaf ? (References == 4 ? one : s.first_in_blue) : first_child);
      set_flag(x, 3, static_cast<Index>(s.children), true);
    }
    if (References == 5)
      set_index(x, 4, one);
    if (References == 6) {
      set_index(x, 4, s.last_in_black);
      set_index(x, References - 1, s.first_in_blue);
    }
  }

  // The records of further sectors, which stand by their names, are sorted by their vertices.
  void sort_sectors()
  {
    const std::size_t num_further = m_sectors.num_further();
    const std::vector<Index> names = m_sectors.further_sectors_by(m_number);
    const std::vector<typename Records::Record> unsorted(
        m_records.records.begin() + static_cast<std::ptrdiff_t>(m_num_vertices), m_records.records.end());
    for (std::size_t i = 0; i < num_further; ++i) {
      const Index x = static_cast<Index>(m_num_vertices + i);
      m_records.records[x] = unsorted[names[i] - m_num_vertices];
      m_number[names[i]] = x;
      set_index(x, 0, m_number[m_sectors.vertex_of_further(names[i])]);
      if (m_records.is_leaf(x))
        continue;
      for (Index child = m_records.first_child(x); child <= m_records.last_child(x); ++child)
        set_index(child, 0, x);
    }
    m_numbering.search_sectors = Search_directory<Index>(num_further, [this](std::size_t i) {
      return m_records.red_parent(static_cast<Index>(m_num_vertices + i));
    });
  }

  // Replaces what the records hold of the names of vertices and sectors by records.
  void translate()
  {
    for (std::size_t x = 0; x < m_records.records.size(); ++x) {
      if (m_numbering.isolated <= x && x < m_numbering.sectors)
        continue;
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
  Numbering& m_numbering;
  const std::size_t m_num_vertices; // without apices
  Large_array<Index> m_red_edge;    // the halfedge from each vertex to its red parent; null if isolated
  Schnyder_sectors<Index> m_sectors;
  std::vector<Index> m_number;      // the record of each vertex and further sector
  std::vector<bool> m_is_outside;   // of the core; empty if no vertex is
  std::vector<bool> m_has_hidden_child; // of each vertex and further sector; empty if none has
  std::vector<Index> m_stack;       // vertices whose children have no numbers yet
  // the next number in the core, and the ends of what is free outside it, without and with hidden siblings
  Index m_next_number = 0, m_end_of_plain = 0, m_end_of_free = 0;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_PARENTS_BUILDER_H
