// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_RANKED_EDGES_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_RANKED_EDGES_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/internal/Ranked_bits.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace internal {

// Numbers edges in the order of their first halfedges, by a bit per halfedge with its rank directory.
template <class Index>
class Ranked_edges
{
public:
  Ranked_edges() = default;

  template <class Layout, class Corners>
  Ranked_edges(const Layout& layout, const Corners&, bool)
    : m_is_first(layout.num_halfedges(),
                 [&layout](std::size_t h) { return h < layout.opposite(static_cast<Index>(h)); })
  {}

  std::size_t count() const { return m_is_first.count(); }

  template <class Layout, class Corners>
  Index edge(const Layout& layout, const Corners&, Index h) const
  {
    return static_cast<Index>(m_is_first.rank((std::min)(h, layout.opposite(h))));
  }

  template <class Corners>
  Index halfedge(const Corners&, Index e) const
  {
    return static_cast<Index>(m_is_first.select(e));
  }

  std::size_t bytes() const { return m_is_first.bytes(); }

private:
  Ranked_bits m_is_first; // whether h < opposite(h)
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_RANKED_EDGES_H
