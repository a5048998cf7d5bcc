// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_INTERNAL_EMPTIED_ON_MOVE_H
#define CGAL_COMPACT_SURFACE_MESH_INTERNAL_EMPTIED_ON_MOVE_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <utility>

namespace CGAL {
namespace internal {

// A number beside arrays, which becomes 0 as these become empty when they are moved
// from. With it the compiler's own copy and move operations are right.
template <class T>
class Emptied_on_move
{
public:
  Emptied_on_move(T value = 0) : m_value(value) {}
  Emptied_on_move(const Emptied_on_move&) = default;
  Emptied_on_move(Emptied_on_move&& other) noexcept : m_value(std::exchange(other.m_value, T(0))) {}
  Emptied_on_move& operator=(const Emptied_on_move&) = default;
  Emptied_on_move& operator=(Emptied_on_move&& other) noexcept
  {
    m_value = std::exchange(other.m_value, T(0));
    return *this;
  }

  operator T() const { return m_value; }
  T& operator*() { return m_value; }

private:
  T m_value;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_INTERNAL_EMPTIED_ON_MOVE_H
