// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_RING_OFFSETS_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_RING_OFFSETS_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Mesh_defect_exception.h>
#include <CGAL/Compact_surface_mesh/internal/Emptied_on_move.h>
#include <CGAL/Compact_surface_mesh/internal/Large_array.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Ring_triangles.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace internal {

/*
The L and R tables of a laced ring, as offsets: LR, section 6. An entry of b bits per ring slot, in pairs, one
pair per ring edge. The lowest bits of a pair say whether the slots skip warts; both are set, which is not the
meaning then, if an offset is too long for b - 1 bits, a slot is irregular, or both skip warts.

    short entry   bit 0: whether the slot skips a wart; others: tip minus ring edge, modulo the size of the rings
    long pair     the other bits of both entries, those of the first one above those of the second:
                  bits 0, 1: whether the slots skip warts; 2, 3: whether they are irregular; others: half of where
                  {tip, tip, opposites of corners 1 and 2 of each irregular slot} stand

The lowest of all offsets stands for the tip that is the apex of the largest border.
*/
template <class Index, class Entry>
class Ring_offsets
{
  typedef Ring_triangles<Index> Triangles;
  typedef std::numeric_limits<Entry> Limits;
  static_assert(!Limits::is_signed && 2 * Limits::digits <= 64, "Entry must be an unsigned integer type of few bits");

public:
  static constexpr const char* name() { return "laced-ring-offsets"; }
  // of a sphere, for which a long pair has at most six references
  static constexpr std::size_t max_vertices()
  {
    return (std::min)(std::size_t((std::numeric_limits<Index>::max)() / 9 + 1), std::size_t(max_long() / 6));
  }

  // of the expander, one for each ring that is tried
  static constexpr std::array<std::size_t, 6> periods() { return { { 0, 1024, 512, 256, 128, 64 } }; }

  // How many bits these tables take.
  static std::size_t num_bits(const Triangles& triangles)
  {
    return triangles.num_ring_slots() * Limits::digits + num_long(triangles) * std::numeric_limits<Index>::digits;
  }

  Ring_offsets() = default;

  explicit Ring_offsets(const Triangles& triangles)
    : m_ring_size(triangles.rings().size()), m_apex(triangles.main_apex())
  {
    const std::size_t size = num_long(triangles);
    if (size > max_long())
      throw Mesh_defect_exception(Mesh_defect::too_many_elements, triangles.num_vertices());
    m_long.reserve(size);
    m_entries.reserve(triangles.num_ring_slots());
    for (std::size_t slot = 0; slot < triangles.num_ring_slots(); slot += 2)
      if (is_long(triangles, slot))
        push_long(triangles, slot);
      else
        for (std::size_t s = slot; s < slot + 2; ++s)
          m_entries.push_back(static_cast<Entry>(2 * offset(triangles, s) + (triangles.is_wart_skipped(s) ? 1 : 0)));
  }

  Index tip(std::size_t slot) const
  {
    if (is_long(slot))
      return m_long[place(slot) + slot % 2];
    // of two's complement; the lowest offset is -half
    const std::int64_t half = std::int64_t(1) << (Limits::digits - 2), raw = m_entries[slot] / 2;
    const std::int64_t difference = raw >= half ? raw - 2 * half : raw;
    if (difference == -half)
      return m_apex;
    const std::int64_t size = m_ring_size, tip = static_cast<std::int64_t>(slot / 2) + difference;
    return static_cast<Index>(tip < 0 ? tip + size : tip >= size ? tip - size : tip);
  }

  bool is_wart_skipped(std::size_t slot) const
  {
    return is_long(slot) ? ((word(slot) >> slot % 2) & 1) != 0 : (m_entries[slot] & 1) != 0;
  }

  bool is_irregular(std::size_t slot) const { return is_long(slot) && ((word(slot) >> (2 + slot % 2)) & 1) != 0; }

  // whether the pair of the slot is long
  bool is_long(std::size_t slot) const { return (m_entries[slot] & m_entries[slot ^ 1] & 1) != 0; }

  // of corner k = 1 or 2 of an irregular slot
  Index opposite(std::size_t slot, unsigned k) const
  {
    const bool is_behind_other = slot % 2 == 1 && is_irregular(slot - 1);
    return m_long[place(slot) + (is_behind_other ? 3 : 1) + k];
  }

  std::size_t entry_bytes() const { return m_entries.capacity() * sizeof(Entry); }
  std::size_t long_bytes() const { return m_long.capacity() * sizeof(Index); }

private:
  static constexpr std::uint64_t max_long() { return std::uint64_t(2) << (2 * Limits::digits - 6); }

  // The offset as b - 1 bits.
  static std::uint64_t offset(const Triangles& triangles, std::size_t slot)
  {
    const std::uint64_t lowest = std::uint64_t(1) << (Limits::digits - 2);
    if (triangles.tip(slot) == triangles.main_apex())
      return lowest;
    return static_cast<std::uint64_t>(difference(triangles, slot)) % (2 * lowest);
  }

  static std::int64_t difference(const Triangles& triangles, std::size_t slot)
  {
    const std::int64_t size = triangles.rings().size(), tip = triangles.tip(slot);
    const std::int64_t difference = tip - static_cast<std::int64_t>(slot / 2);
    return 2 * difference > size ? difference - size : -2 * difference > size ? difference + size : difference;
  }

  static bool is_short(const Triangles& triangles, std::size_t slot)
  {
    const Index tip = triangles.tip(slot);
    if (tip >= triangles.rings().size())
      return tip == triangles.main_apex();
    const std::int64_t half = std::int64_t(1) << (Limits::digits - 2), d = difference(triangles, slot);
    return -half < d && d < half;
  }

  static bool is_long(const Triangles& triangles, std::size_t even_slot)
  {
    const std::size_t odd_slot = even_slot + 1;
    return triangles.is_irregular(even_slot) || triangles.is_irregular(odd_slot) || !is_short(triangles, even_slot)
           || !is_short(triangles, odd_slot)
           || (triangles.is_wart_skipped(even_slot) && triangles.is_wart_skipped(odd_slot));
  }

  static std::size_t num_long(const Triangles& triangles)
  {
    std::size_t count = 0;
    for (std::size_t slot = 0; slot < triangles.num_ring_slots(); slot += 2)
      if (is_long(triangles, slot))
        count += 2 + (triangles.is_irregular(slot) ? 2 : 0) + (triangles.is_irregular(slot + 1) ? 2 : 0);
    return count;
  }

  void push_long(const Triangles& triangles, std::size_t even_slot)
  {
    std::uint64_t word = m_long.size() / 2 * 16;
    m_long.push_back(triangles.tip(even_slot));
    m_long.push_back(triangles.tip(even_slot + 1));
    for (std::size_t s = 0; s < 2; ++s) {
      if (triangles.is_wart_skipped(even_slot + s))
        word |= std::uint64_t(1) << s;
      if (!triangles.is_irregular(even_slot + s))
        continue;
      word |= std::uint64_t(4) << s;
      m_long.push_back(triangles.opposite(even_slot + s, 1));
      m_long.push_back(triangles.opposite(even_slot + s, 2));
    }
    m_entries.push_back(static_cast<Entry>(2 * (word >> (Limits::digits - 1)) + 1));
    m_entries.push_back(static_cast<Entry>(2 * word + 1));
  }

  std::uint64_t word(std::size_t slot) const
  {
    return std::uint64_t(m_entries[slot & ~std::size_t(1)] / 2) << (Limits::digits - 1) | m_entries[slot | 1] / 2;
  }

  std::size_t place(std::size_t slot) const { return static_cast<std::size_t>(word(slot) / 16 * 2); }

  Emptied_on_move<Index> m_ring_size, m_apex;
  Large_array<Entry> m_entries;
  std::vector<Index> m_long;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_RING_OFFSETS_H
