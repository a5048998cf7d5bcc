// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_COPIED_VERTICES_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_COPIED_VERTICES_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/layouts/internal/Filled_slots.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

// Numbers of vertices without holes, where a structure numbers vertices and copies of them together.
// Constant time where there are no copies, else logarithmic in their number.
template <class Index>
class Copied_vertices
{
public:
  Copied_vertices() = default;

  // Of each copy its own number and that of its vertex, both in the structure.
  Copied_vertices(std::size_t num_all, std::vector<std::pair<Index, Index>>&& copies) : m_copies(std::move(copies))
  {
    std::sort(m_copies.begin(), m_copies.end());
    std::vector<Index> dead;
    dead.reserve(m_copies.size());
    for (const auto& copy : m_copies)
      dead.push_back(copy.first);
    m_numbers = Filled_slots<Index>(num_all, std::move(dead));
    for (auto& copy : m_copies)
      copy.second = m_numbers.number(copy.second);
    m_copies.shrink_to_fit();
  }

  std::size_t count() const { return m_numbers.count(); }

  Index vertex(Index in_structure) const
  {
    if (m_copies.empty())
      return in_structure;
    const auto it = std::lower_bound(m_copies.begin(), m_copies.end(), std::make_pair(in_structure, Index(0)));
    return it == m_copies.end() || it->first != in_structure ? m_numbers.number(in_structure) : it->second;
  }

  Index in_structure(Index vertex) const { return m_copies.empty() ? vertex : m_numbers.slot(vertex); }

  std::size_t bytes() const { return m_copies.capacity() * sizeof(m_copies[0]) + m_numbers.bytes(); }

private:
  std::vector<std::pair<Index, Index>> m_copies; // sorted; its number in the structure, its vertex
  Filled_slots<Index> m_numbers;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_COPIED_VERTICES_H
