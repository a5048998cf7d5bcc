// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_LIVE_SLOTS_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_LIVE_SLOTS_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/internal/Emptied_on_move.h>
#include <CGAL/Compact_surface_mesh/internal/Ranked_bits.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Filled_slots.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

// Numbers a row of slots without holes, wherever the dead ones are: few are filled by the last slots,
// two words each; of many, live slots are counted by a bit each.
template <class Index>
class Live_slots
{
public:
  Live_slots() = default;

  // `dead` need not be sorted.
  Live_slots(std::size_t num_slots, std::vector<Index>&& dead)
  {
    std::sort(dead.begin(), dead.end());
    const std::size_t bytes_of_filled = 2 * sizeof(Index) * dead.size(), bytes_of_ranked = num_slots * 5 / 32;
    m_end_of_kept = static_cast<Index>(num_slots - dead.size());
    if (bytes_of_filled <= bytes_of_ranked || dead.empty() || dead.front() >= m_end_of_kept)
      m_filled = Filled_slots<Index>(num_slots, std::move(dead), true);
    else {
      std::vector<bool> is_dead(num_slots, false);
      for (const Index slot : dead)
        is_dead[slot] = true;
      m_ranked = Ranked_bits(num_slots, [&](std::size_t slot) { return !is_dead[slot]; });
      m_end_of_kept = dead.front();
    }
  }

  std::size_t count() const { return m_ranked.empty() ? m_filled.count() : m_ranked.count(); }

  // Live slots before this one have themselves as numbers.
  Index end_of_kept() const { return m_end_of_kept; }

  // The number of a live slot.
  Index number(Index slot) const
  {
    return m_ranked.empty() ? m_filled.number(slot) : static_cast<Index>(m_ranked.rank(slot));
  }

  // The slot of a number.
  Index slot(Index number) const
  {
    return m_ranked.empty() ? m_filled.slot(number) : static_cast<Index>(m_ranked.select(number));
  }

  std::size_t bytes() const { return m_filled.bytes() + m_ranked.bytes(); }

private:
  Filled_slots<Index> m_filled;
  Ranked_bits m_ranked; // empty if slots are filled
  Emptied_on_move<Index> m_end_of_kept;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_LIVE_SLOTS_H
