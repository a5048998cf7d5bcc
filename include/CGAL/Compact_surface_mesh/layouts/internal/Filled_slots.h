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
#include <CGAL/Compact_surface_mesh/layouts/internal/Search_directory.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

// Numbers a row of slots, few of which are dead, without holes: a live slot keeps its place
// as number, but for the last ones, which take the places of the dead ones. At most two words per dead slot, and one for directories.
template <class Index>
class Filled_slots
{
public:
  Filled_slots() = default;

  // `dead` is sorted. With directories, searches take less time and some memory.
  Filled_slots(std::size_t num_slots, std::vector<Index>&& dead, bool has_directories = false)
    : m_count(static_cast<Index>(num_slots - dead.size())), m_dead(std::move(dead))
  {
    const auto end = std::lower_bound(m_dead.begin(), m_dead.end(), m_count);
    const std::size_t num_moved = static_cast<std::size_t>(end - m_dead.begin());
    m_dead_behind.assign(end, m_dead.end());
    if (num_moved <= m_dead_behind.size()) {
      List live(num_moved);
      for (std::size_t i = 0; i < num_moved; ++i)
        live[i] = moved(i);
      m_moved = std::move(live);
      m_dead_behind = List();
    }
    m_dead.erase(end, m_dead.end());
    m_dead.shrink_to_fit();
    if (!has_directories)
      return;
    m_search_dead = directory(m_dead);
    m_search_behind = directory(behind());
  }

  std::size_t count() const { return m_count; }

  // The number of a live slot, in time logarithmic in the number of dead ones at worst.
  Index number(Index slot) const { return slot < m_count ? slot : number_behind(slot); }

  // The slot of a number, likewise.
  Index slot(Index number) const
  {
    const std::size_t i = position(m_search_dead, m_dead, number);
    return i == m_dead.size() || m_dead[i] != number ? number : moved(i);
  }

  std::size_t bytes() const
  {
    return (m_dead.capacity() + m_moved.capacity() + m_dead_behind.capacity()) * sizeof(Index) + m_search_dead.bytes()
           + m_search_behind.bytes();
  }

private:
  typedef std::vector<Index> List;

  static Search_directory<Index> directory(const List& list)
  {
    return Search_directory<Index>(list.size(), [&list](std::size_t i) { return list[i]; });
  }
  static std::size_t position(const Search_directory<Index>& directory, const List& list, Index wanted)
  {
    return directory.lower_bound(list.size(), wanted, [&list](std::size_t i) { return list[i]; });
  }

  const List& behind() const { return m_moved.empty() ? m_dead_behind : m_moved; }

  Index number_behind(Index slot) const
  {
    const std::size_t i = position(m_search_behind, behind(), slot);
    return m_dead[m_moved.empty() ? slot - m_count - i : i];
  }

  // The live slot behind m_count before which there are i others.
  Index moved(std::size_t i) const
  {
    if (!m_moved.empty())
      return m_moved[i];
    std::size_t begin = 0, end = m_dead_behind.size(); // of the dead slots, find how many are before it
    while (begin < end) {
      const std::size_t middle = (begin + end) / 2;
      if (m_dead_behind[middle] - m_count - middle <= i)
        begin = middle + 1;
      else
        end = middle;
    }
    return static_cast<Index>(m_count + i + begin);
  }

  Emptied_on_move<Index> m_count;
  List m_dead; // below m_count
  // behind it, the shorter of two lists: the live slots, or, if that one is empty, the dead ones
  List m_moved, m_dead_behind;
  Search_directory<Index> m_search_dead, m_search_behind;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_FILLED_SLOTS_H
