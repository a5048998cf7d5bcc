// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SEARCH_DIRECTORY_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SEARCH_DIRECTORY_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace internal {

// Where to search for a key in a sorted list, which is somewhere else: the range of the keys is cut into pieces of
// equal length, and the directory has the positions where they begin. A search takes constant time where
// keys are spread evenly, and logarithmic time at worst. At most one word for two keys, none for few.
template <class Index>
class Search_directory
{
public:
  Search_directory() = default;

  // key(i), for i below `size`, has the keys of the list.
  template <class KeyAt>
  Search_directory(std::size_t size, const KeyAt& key)
  {
    if (size < smallest)
      return;
    m_first = key(0);
    const std::size_t range = std::size_t(key(size - 1)) - m_first;
    while ((range >> m_shift) + 2 > size / 2)
      ++m_shift;
    m_begin.reserve((range >> m_shift) + 2);
    for (std::size_t i = 0; i < size; ++i)
      while (m_begin.size() <= (std::size_t(key(i)) - m_first) >> m_shift)
        m_begin.push_back(static_cast<Index>(i));
    m_begin.push_back(static_cast<Index>(size));
  }

  // The first position with at least this key, or `size`.
  template <class KeyAt>
  std::size_t lower_bound(std::size_t size, Index wanted, const KeyAt& key) const
  {
    std::size_t begin = 0, end = size;
    if (!m_begin.empty()) {
      if (wanted < m_first)
        return 0;
      const std::size_t piece = static_cast<std::size_t>(wanted - m_first) >> m_shift;
      if (piece + 1 >= m_begin.size())
        return size;
      begin = m_begin[piece];
      end = m_begin[piece + 1];
    }
    while (begin < end) {
      const std::size_t middle = begin + (end - begin) / 2;
      if (key(middle) < wanted)
        begin = middle + 1;
      else
        end = middle;
    }
    return begin;
  }

  std::size_t bytes() const { return m_begin.capacity() * sizeof(Index); }

private:
  enum : std::size_t { smallest = 16 };

  Index m_first = 0;
  unsigned m_shift = 0;
  std::vector<Index> m_begin; // of each piece, and the end of the last one; empty if there are few keys
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SEARCH_DIRECTORY_H
