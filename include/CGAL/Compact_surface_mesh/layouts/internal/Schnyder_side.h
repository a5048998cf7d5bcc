// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_SIDE_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_SIDE_H

#include <CGAL/license/Compact_surface_mesh.h>

namespace CGAL {
namespace internal {

// A halfedge, named by the record x that owns its edge: k = 0, 2, 4 runs from x along its red, blue, black
// edge out, and k + 1 back.
template <class Index>
struct Schnyder_side
{
  // Integer is wider than Index where indices are narrow: arithmetic promotes them.
  template <class Integer>
  Schnyder_side(Integer x, unsigned k)
    : x(static_cast<Index>(x)), k(k)
  {}

  Index x;
  unsigned k;
};

// A face, named by the record x that owns it: A is left of the red edge out of x, B right of the black one.
template <class Index>
struct Schnyder_face
{
  enum Owner : unsigned { A = 0, B = 1, hole = 2 };

  template <class Integer>
  Schnyder_face(Integer x, Owner owner)
    : x(static_cast<Index>(x)), owner(owner)
  {}

  Index x;
  Owner owner; // hole: x is a vertex around the apex
};

// The zones of a mesh differ in the answers to what the operators of layouts ask below. In the core, all
// neighbors of a record are ordinary vertices.
template <class Index>
struct Schnyder_core_zone
{
  static constexpr bool has_holes = false;
  static bool may_face_hole(Index) { return false; }
  static bool on_border(Index) { return false; }
  static Index vertex(Index x) { return x; }
  static Index last_sector(Index x) { return x; }
  static Index next_fan(Index x) { return x; }
  static Index prev_fan(Index x) { return x; }
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_SIDE_H
