// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_FILLED_SLOTS_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_FILLED_SLOTS_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/internal/Emptied_on_move.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

// Numbers a row of slots, few of which are dead, without holes: a live slot keeps its place
// as number, but for the last ones, which take the places of the dead ones. Two words per dead slot.
template <class Index>
class Filled_slots
{
public:
  Filled_slots() = default;

  // `dead` is sorted.
  Filled_slots(std::size_t num_slots, std::vector<Index>&& dead)
    : m_count(static_cast<Index>(num_slots - dead.size())), m_dead(std::move(dead))
  {
    const auto end = std::lower_bound(m_dead.begin(), m_dead.end(), m_count);
    m_moved.reserve(static_cast<std::size_t>(end - m_dead.begin()));
    auto it = end;
    for (std::size_t slot = m_count; slot < num_slots; ++slot)
      if (it != m_dead.end() && *it == slot)
        ++it;
      else
        m_moved.push_back(static_cast<Index>(slot));
    m_dead.erase(end, m_dead.end());
    m_dead.shrink_to_fit();
  }

  std::size_t count() const { return m_count; }

  // The number of a live slot, in time logarithmic in the number of dead ones at worst.
  Index number(Index slot) const
  {
    if (slot < m_count)
      return slot;
    return m_dead[std::lower_bound(m_moved.begin(), m_moved.end(), slot) - m_moved.begin()];
  }

  // The slot of a number, likewise.
  Index slot(Index number) const
  {
    const auto it = std::lower_bound(m_dead.begin(), m_dead.end(), number);
    return it == m_dead.end() || *it != number ? number : m_moved[it - m_dead.begin()];
  }

  std::size_t bytes() const { return (m_dead.capacity() + m_moved.capacity()) * sizeof(Index); }

private:
  Emptied_on_move<Index> m_count;
  std::vector<Index> m_dead, m_moved; // below m_count, and the live slots behind it
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_FILLED_SLOTS_H
