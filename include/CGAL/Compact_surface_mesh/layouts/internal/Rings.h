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

#include <boost/config.hpp>

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

  BOOST_FORCEINLINE Index next(Index v) const
  {
    const Index w = v + 1;
    return BOOST_LIKELY(!is_start(w)) ? w : first_of(v);
  }

  BOOST_FORCEINLINE Index prev(Index v) const { return BOOST_LIKELY(v != 0 && !is_start(v)) ? v - 1 : last_of(v); }

  // next(next(v))
  BOOST_FORCEINLINE Index second_next(Index v) const
  {
    return BOOST_LIKELY(m_starts.empty() && v + 2 < m_size) ? v + 2 : next(next(v));
  }

  std::size_t bytes() const
  {
    return m_starts.capacity() * sizeof(Index) + m_is_start.capacity() * sizeof(std::uint64_t);
  }

private:
  // whether a cycle starts at v, which is not 0, or the last one ends before it
  bool is_start(Index v) const { return m_starts.empty() ? v == m_size : (m_is_start[v / 64] >> (v % 64)) & 1; }

  BOOST_NOINLINE Index first_of(Index v) const
  {
    return m_starts.empty() ? 0 : *(std::upper_bound(m_starts.begin(), m_starts.end(), v) - 1);
  }

  BOOST_NOINLINE Index last_of(Index v) const
  {
    return (m_starts.empty() ? Index(m_size) : *std::upper_bound(m_starts.begin(), m_starts.end(), v)) - 1;
  }

  Emptied_on_move<Index> m_size;
  std::vector<Index> m_starts; // and at last m_size; empty if there is one cycle only
  std::vector<std::uint64_t> m_is_start;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_RINGS_H
