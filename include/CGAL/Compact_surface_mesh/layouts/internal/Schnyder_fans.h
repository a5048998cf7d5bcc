// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_FANS_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_FANS_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

// The fans of the vertices that have several, linked to rings. Each fan has a record of its own; the
// first one, in the order of the records, has the vertex.
template <class Index>
class Schnyder_fans
{
public:
  struct Fan
  {
    Index record, first, prev, next;
  };

  Schnyder_fans() = default;

  // `copies` tells of which vertex first_copy, first_copy + 1, ... are copies; `record` has the record of each
  // vertex and copy.
  Schnyder_fans(const std::vector<Index>& copies, std::size_t first_copy, const std::vector<Index>& record)
  {
    std::vector<std::pair<Index, Index>> fans; // original, record
    for (std::size_t i = 0; i < copies.size(); ++i) {
      fans.emplace_back(copies[i], record[first_copy + i]);
      fans.emplace_back(copies[i], record[copies[i]]);
    }
    std::sort(fans.begin(), fans.end());
    fans.erase(std::unique(fans.begin(), fans.end()), fans.end());
    m_fans.reserve(fans.size());
    for (std::size_t i = 0, end; i < fans.size(); i = end) {
      for (end = i; end < fans.size() && fans[end].first == fans[i].first;)
        ++end;
      for (std::size_t j = i; j < end; ++j)
        m_fans.push_back({ fans[j].second, fans[i].second, fans[j == i ? end - 1 : j - 1].second,
                           fans[j + 1 == end ? i : j + 1].second });
    }
    std::sort(m_fans.begin(), m_fans.end(), [](const Fan& a, const Fan& b) { return a.record < b.record; });
  }

  bool empty() const { return m_fans.empty(); }
  typename std::vector<Fan>::const_iterator begin() const { return m_fans.begin(); }
  typename std::vector<Fan>::const_iterator end() const { return m_fans.end(); }

  // The fan with record x, null if the vertex has no other one.
  const Fan* find(Index x) const
  {
    const auto it = position(x);
    return it == m_fans.end() || it->record != x ? nullptr : &*it;
  }

  // The same if it is known to be there.
  const Fan& operator[](Index x) const { return *position(x); }

  // The records that have no vertex, sorted.
  std::vector<Index> further_fans() const
  {
    std::vector<Index> result;
    for (const Fan& fan : m_fans)
      if (fan.record != fan.first)
        result.push_back(fan.record);
    return result;
  }

  std::size_t bytes() const { return m_fans.capacity() * sizeof(Fan); }

private:
  typename std::vector<Fan>::const_iterator position(Index x) const
  {
    return std::lower_bound(m_fans.begin(), m_fans.end(), x, [](const Fan& f, Index y) { return f.record < y; });
  }

  std::vector<Fan> m_fans; // sorted by records
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_FANS_H
