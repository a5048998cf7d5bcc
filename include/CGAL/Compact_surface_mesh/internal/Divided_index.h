// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial


#ifndef CGAL_COMPACT_SURFACE_MESH_INTERNAL_DIVIDED_INDEX_H
#define CGAL_COMPACT_SURFACE_MESH_INTERNAL_DIVIDED_INDEX_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <limits>

namespace CGAL {
namespace internal {

// The index 6q + r, kept as 8q + r: so quotient and remainder are had by a shift and a mask, and
// compilers see through what is made and taken apart again. The order is that of the indices.
// The largest value stands for itself, and indices too large for this become it.
template <class Index>
class Divided_index
{
  static constexpr Index null = (std::numeric_limits<Index>::max)();

public:
  constexpr Divided_index() = default;
  constexpr Divided_index(Index i) : m_code(i < null / 4 * 3 ? of_valid(i).m_code : null) {}

  // i is no larger than the number of halfedges of a mesh
  static constexpr Divided_index of_valid(Index i) { return with_code(static_cast<Index>(i + 2 * (i / 6))); }
  // 6q + r; q is at most an eighth of the largest value
  static constexpr Divided_index of(Index q, unsigned r) { return with_code(static_cast<Index>(8 * q + r)); }
  static constexpr Divided_index with_code(Index code)
  {
    Divided_index result;
    result.m_code = code;
    return result;
  }

  constexpr operator Index() const { return is_null() ? null : static_cast<Index>(m_code - 2 * (m_code >> 3)); }

  constexpr Index code() const { return m_code; }
  constexpr bool is_null() const { return m_code == null; }
  constexpr Index quotient() const { return static_cast<Index>(m_code >> 3); }
  constexpr unsigned remainder() const { return static_cast<unsigned>(m_code & 7); }

private:
  Index m_code = null;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_INTERNAL_DIVIDED_INDEX_H
