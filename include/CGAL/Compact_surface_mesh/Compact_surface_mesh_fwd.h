// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_FWD_H
#define CGAL_COMPACT_SURFACE_MESH_FWD_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <cstdint>

/// \file Compact_surface_mesh_fwd.h
/// Forward declarations of the package Compact_surface_mesh.

namespace CGAL {

// without default arguments, which stand at the definition
template <int References, class Index>
class Schnyder_parents_layout;

template <class Point_, class Layout_ = Schnyder_parents_layout<4, std::uint32_t> >
class Compact_surface_mesh;

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_FWD_H
