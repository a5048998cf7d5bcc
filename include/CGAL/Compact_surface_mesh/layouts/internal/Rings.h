// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_RINGS_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_RINGS_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/internal/Emptied_on_move.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace internal {

// Cycles of consecutive numbers, one behind the other: the next and the previous number in the cycle. A
// bit per number if there are several cycles, and nothing else on the way but at their ends.
template <class Index>
class Rings
{
public:
  Rings() = default;

  // Each cycle goes from a start, which is a number in `starts`, sorted, to the one before the next start.
  Rings(std::size_t size, std::vector<Index>&& starts) : m_size(static_cast<Index>(size))
  {
    if (starts.size() < 2)
      return;
    m_starts = std::move(starts);
    m_starts.push_back(static_cast<Index>(size));
    m_starts.shrink_to_fit();
    m_is_start.assign(size / 64 + 1, 0);
    for (const Index start : m_starts)
      m_is_start[start / 64] |= std::uint64_t(1) << (start % 64);
  }

  Index size() const { return m_size; }

  Index next(Index v) const
  {
    const Index w = v + 1;
    if (m_starts.empty())
      return w == m_size ? 0 : w;
    return is_start(w) ? *(std::upper_bound(m_starts.begin(), m_starts.end(), v) - 1) : w;
  }

  Index prev(Index v) const
  {
    if (m_starts.empty())
      return (v == 0 ? static_cast<Index>(m_size) : v) - 1;
    return (is_start(v) ? *std::upper_bound(m_starts.begin(), m_starts.end(), v) : v) - 1;
  }

  std::size_t bytes() const
  {
    return m_starts.capacity() * sizeof(Index) + m_is_start.capacity() * sizeof(std::uint64_t);
  }

private:
  bool is_start(Index v) const { return (m_is_start[v / 64] >> (v % 64)) & 1; }

  Emptied_on_move<Index> m_size;
  std::vector<Index> m_starts; // and at last m_size; empty if there is one cycle only
  std::vector<std::uint64_t> m_is_start;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_RINGS_H
