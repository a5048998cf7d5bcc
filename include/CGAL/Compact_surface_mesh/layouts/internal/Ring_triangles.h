// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_RING_TRIANGLES_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_RING_TRIANGLES_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Corner_table.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Ring_expander.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Rings.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

/*
Gives the triangles of a closed triangulation their slots along rings, as Laced_ring says: sorts them by
the number of their ring edges, skips warts, and finds the irregular ones, which border on a triangle
without ring edge. Numbers vertices: those on the rings in their order; the other ones that have triangles;
those that have none; and, as they are, those from `first_apex` on.
*/
template <class Index>
class Ring_triangles
{
  typedef Corner_table<Index> Table;
  static constexpr Index null() { return Table::null(); }

public:
  Ring_triangles(const Table& table, std::size_t first_apex, typename Ring_expander<Index>::Result&& rings)
    : m_table(table), m_first_apex(first_apex), m_ring(std::move(rings.halfedges)),
      m_rings(m_ring.size(), std::move(rings.starts))
  {
    number_vertices();
    m_slot.assign(table.num_faces(), null());
    m_first.assign(2 * m_ring.size(), null());
    m_is_wart.assign(m_first.size(), false);
    place_along_rings();
    pair_with_warts();
    place_all_others();
    find_main_apex();
  }

  const Rings<Index>& rings() const { return m_rings; }
  std::size_t num_ring_slots() const { return 2 * m_ring.size(); }
  std::size_t num_slots() const { return m_first.size(); }
  std::size_t num_isolated() const { return m_num_isolated; }
  std::size_t num_vertices() const { return m_number.size(); }
  // the apex that is the tip of most ring slots, null if none is
  Index main_apex() const { return m_main_apex; }

  Index number(Index v) const { return m_number[v]; }
  std::vector<Index> release_numbers() { return std::move(m_number); }

  // Corner 3 * slot + k for each halfedge of the table.
  Index corner(Index h) const
  {
    const Index slot = m_slot[Table::face(h)];
    return static_cast<Index>(3 * slot + (h + 3 - m_first[slot]) % 3);
  }

  // The halfedge of the table that is corner 3 * slot, null if the slot is redundant.
  Index halfedge(std::size_t slot) const { return m_first[slot]; }

  // Whether the slot skips a wart, the triangle of the next slot on the same side.
  bool is_wart_skipped(std::size_t slot) const { return m_is_wart[slot]; }

  // The vertex of the triangle that its ring edge does not tell.
  Index tip(std::size_t slot) const
  {
    const Index h = m_first[slot];
    return h == null() ? m_rings.next(m_rings.next(static_cast<Index>(slot / 2)))
                       : m_number[m_table.source(Table::prev(h))];
  }

  bool is_irregular(std::size_t slot) const
  {
    const Index h = m_first[slot];
    return h != null() && (is_beside_t0(Table::next(h)) || is_beside_t0(Table::prev(h)));
  }

  // The corner opposite to k = 1 or 2 of an irregular slot or k = 0, 1 or 2 of one without ring edge.
  Index opposite(std::size_t slot, unsigned k) const
  {
    const Index h = m_first[slot];
    return corner(m_table.opposite(k == 0 ? h : k == 1 ? Table::next(h) : Table::prev(h)));
  }

  Index vertex(std::size_t slot, unsigned k) const
  {
    const Index h = m_first[slot];
    return m_number[m_table.source(k == 0 ? h : k == 1 ? Table::next(h) : Table::prev(h))];
  }

private:
  void number_vertices()
  {
    m_number.assign(m_table.num_vertices(), null());
    for (std::size_t i = 0; i < m_ring.size(); ++i)
      m_number[m_table.source(m_ring[i])] = static_cast<Index>(i);
    std::size_t count = m_ring.size();
    for (std::size_t h = 0; h < m_table.num_halfedges(); ++h) {
      const Index v = m_table.source(static_cast<Index>(h));
      if (m_number[v] == null() && v < m_first_apex)
        m_number[v] = static_cast<Index>(count++);
    }
    m_num_isolated = count - m_ring.size();
    for (std::size_t v = 0; v < m_number.size(); ++v)
      if (m_number[v] == null())
        m_number[v] = static_cast<Index>(v < m_first_apex ? count++ : v);
  }

  Index ring_halfedge(Index e, unsigned side) const { return side == 0 ? m_ring[e] : m_table.opposite(m_ring[e]); }

  // A triangle with two ring edges belongs to the second one.
  void place_along_rings()
  {
    for (std::size_t slot = 0; slot < m_first.size(); ++slot) {
      const Index e = static_cast<Index>(slot / 2), h = ring_halfedge(e, slot % 2);
      if (Table::face(ring_halfedge(m_rings.next(e), slot % 2)) == Table::face(h))
        continue;
      m_slot[Table::face(h)] = static_cast<Index>(slot);
      m_first[slot] = h;
    }
  }

  // A triangle without ring edge takes the redundant slot of a neighbor that has two.
  void pair_with_warts()
  {
    for (std::size_t f = 0; f < m_slot.size(); ++f)
      for (Index h = static_cast<Index>(3 * f); m_slot[f] == null() && h < 3 * f + 3; ++h) {
        const Index wart = m_slot[Table::face(m_table.opposite(h))];
        if (wart == null())
          continue;
        const std::size_t slot = 2 * std::size_t(m_rings.prev(wart / 2)) + wart % 2;
        if (m_first[slot] != null())
          continue;
        m_slot[f] = static_cast<Index>(slot);
        m_first[slot] = h;
        m_is_wart[slot] = true;
      }
  }

  // The triangles without ring edge that are left, in the order in which rings pass them.
  void place_all_others()
  {
    for (std::size_t slot = 0; slot < num_ring_slots(); ++slot) {
      const Index h = m_first[slot];
      if (h == null())
        continue;
      place(Table::face(m_table.opposite(Table::next(h))));
      place(Table::face(m_table.opposite(Table::prev(h))));
    }
    for (std::size_t f = 0; f < m_slot.size(); ++f)
      place(static_cast<Index>(f));
  }

  // An apex is at corner 2.
  void place(Index f)
  {
    if (m_slot[f] != null())
      return;
    Index h = 3 * f;
    while (h < 3 * f + 2 && m_table.source(Table::prev(h)) < m_first_apex)
      ++h;
    m_slot[f] = static_cast<Index>(m_first.size());
    m_first.push_back(m_table.source(Table::prev(h)) < m_first_apex ? 3 * f : h);
  }

  void find_main_apex()
  {
    std::vector<std::size_t> count(m_number.size() - m_first_apex, 0);
    for (std::size_t slot = 0; slot < num_ring_slots(); ++slot)
      if (tip(slot) >= m_first_apex)
        ++count[tip(slot) - m_first_apex];
    const auto most = std::max_element(count.begin(), count.end());
    if (most != count.end() && *most > 0)
      m_main_apex = static_cast<Index>(m_first_apex + static_cast<std::size_t>(most - count.begin()));
  }

  bool is_beside_t0(Index h) const { return m_slot[Table::face(m_table.opposite(h))] >= num_ring_slots(); }

  const Table& m_table;
  const std::size_t m_first_apex;
  std::vector<Index> m_ring; // halfedges, the region of the expander to their left
  Rings<Index> m_rings;
  std::size_t m_num_isolated = 0;
  Index m_main_apex = null();
  std::vector<Index> m_number;
  std::vector<Index> m_slot;   // of each face
  std::vector<Index> m_first;  // of each slot
  std::vector<bool> m_is_wart; // whether a ring slot skips a wart
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_RING_TRIANGLES_H
