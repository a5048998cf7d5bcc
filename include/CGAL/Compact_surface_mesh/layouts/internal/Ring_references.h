// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_RING_REFERENCES_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_RING_REFERENCES_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Mesh_defect_exception.h>
#include <CGAL/Compact_surface_mesh/internal/Large_array.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Ring_triangles.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace internal {

/*
The L and R tables of a laced ring, as references: LR, section 4. One entry per ring slot:

    bits    meaning
    0       whether the slot is irregular
    1       whether it skips a wart
    others  regular: the tip; irregular: where {tip, opposite of corner 1, opposite of corner 2} stand
*/
template <class Index>
class Ring_references
{
  typedef Ring_triangles<Index> Triangles;

public:
  static constexpr const char* name() { return "laced-ring"; }
  // of a sphere, for which there are at most three vertices in two to be referred to
  static constexpr std::size_t max_vertices() { return (std::numeric_limits<Index>::max)() / 9 + 1; }

  // of the expander, one for each ring that is tried: the longest corridors are the cheapest
  static constexpr std::array<std::size_t, 3> periods() { return { { 0, 0, 0 } }; }

  // How many bits these tables take.
  static std::size_t num_bits(const Triangles& triangles)
  {
    return (triangles.num_ring_slots() + 3 * num_irregular(triangles)) * std::numeric_limits<Index>::digits;
  }

  Ring_references() = default;

  explicit Ring_references(const Triangles& triangles)
  {
    const std::size_t num_slots = triangles.num_ring_slots(), num_long = num_irregular(triangles);
    if ((std::max)(triangles.num_vertices(), num_long) > std::size_t((std::numeric_limits<Index>::max)() / 4) + 1)
      throw Mesh_defect_exception(Mesh_defect::too_many_elements, triangles.num_vertices());
    m_entries.reserve(num_slots);
    m_irregular.reserve(3 * num_long);
    for (std::size_t slot = 0; slot < num_slots; ++slot) {
      const Index tip = triangles.tip(slot), wart = triangles.is_wart_skipped(slot) ? 2 : 0;
      if (triangles.is_irregular(slot)) {
        m_entries.push_back(static_cast<Index>(4 * (m_irregular.size() / 3) + wart + 1));
        m_irregular.insert(m_irregular.end(), { tip, triangles.opposite(slot, 1), triangles.opposite(slot, 2) });
      } else
        m_entries.push_back(static_cast<Index>(4 * tip + wart));
    }
  }

  Index tip(std::size_t slot) const
  {
    const Index entry = m_entries[slot];
    return entry & 1 ? m_irregular[3 * std::size_t(entry / 4)] : entry / 4;
  }

  bool is_wart_skipped(std::size_t slot) const { return (m_entries[slot] & 2) != 0; }
  bool is_irregular(std::size_t slot) const { return (m_entries[slot] & 1) != 0; }
  bool is_long(std::size_t) const { return false; }
  // of corner k = 1 or 2 of an irregular slot
  Index opposite(std::size_t slot, unsigned k) const { return m_irregular[3 * std::size_t(m_entries[slot] / 4) + k]; }

  std::size_t entry_bytes() const { return m_entries.capacity() * sizeof(Index); }
  std::size_t long_bytes() const { return m_irregular.capacity() * sizeof(Index); }

private:
  static std::size_t num_irregular(const Triangles& triangles)
  {
    std::size_t count = 0;
    for (std::size_t slot = 0; slot < triangles.num_ring_slots(); ++slot)
      count += triangles.is_irregular(slot) ? 1 : 0;
    return count;
  }

  Large_array<Index> m_entries;
  std::vector<Index> m_irregular;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_RING_REFERENCES_H
