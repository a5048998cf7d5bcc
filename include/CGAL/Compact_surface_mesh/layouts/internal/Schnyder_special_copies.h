// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_SPECIAL_COPIES_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_SPECIAL_COPIES_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Corner_table.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Search_directory.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_side.h>
#include <CGAL/Schnyder_woods/internal/Schnyder_wood.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

// The two copies of each special edge, by the slots that they have as edges. Each copy has a live side, whose
// face it bounds. The edge lives in the slot of the first copy, whose dead side names the live side of the second.
template <class Index>
class Schnyder_special_copies
{
  typedef Schnyder_side<Index> Side;

public:
  struct Copy
  {
    Index slot, other;
    unsigned char live, other_live; // the last bits of the live sides
  };

  Schnyder_special_copies() = default;

  // side(h) is the side of a halfedge in the copy of its edge that bounds its face, and slot(s) the
  // slot of the edge of s. Calls second_copy(s, first) for each live side s of a second copy, with that of the first.
  template <class SideOfHalfedge, class SlotOfSide, class Visitor>
  Schnyder_special_copies(const Corner_table<Index>& table, const Schnyder_wood& wood, const SideOfHalfedge& side,
                          const SlotOfSide& slot, Visitor&& second_copy)
  {
    for (std::size_t i = 0; i < table.num_halfedges(); ++i) {
      if (!wood.is_special(i))
        continue;
      const Index h = static_cast<Index>(i), o = table.opposite(h);
      if (o < h)
        continue;
      Side first = side(h), second = side(o);
      if (slot(second) < slot(first))
        std::swap(first, second);
      const unsigned char live = first.k & 1, other_live = second.k & 1;
      m_copies.push_back({ slot(first), slot(second), live, other_live });
      m_copies.push_back({ slot(second), slot(first), other_live, live });
      second_copy(second, first);
    }
    std::sort(m_copies.begin(), m_copies.end(), [](const Copy& a, const Copy& b) { return a.slot < b.slot; });
    m_copies.shrink_to_fit();
    m_search = Search_directory<Index>(m_copies.size(), slot_at());
  }

  // The copy with this slot, null if there is none.
  const Copy* find(Index slot) const
  {
    const std::size_t i = m_search.lower_bound(m_copies.size(), slot, slot_at());
    return i == m_copies.size() || m_copies[i].slot != slot ? nullptr : &m_copies[i];
  }

  std::size_t bytes() const { return m_copies.capacity() * sizeof(Copy) + m_search.bytes(); }

private:
  auto slot_at() const
  {
    return [this](std::size_t i) { return m_copies[i].slot; };
  }

  std::vector<Copy> m_copies; // sorted by slots
  Search_directory<Index> m_search;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_SPECIAL_COPIES_H
