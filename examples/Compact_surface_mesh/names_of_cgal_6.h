// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef COMPACT_SURFACE_MESH_EXAMPLES_NAMES_OF_CGAL_6_H
#define COMPACT_SURFACE_MESH_EXAMPLES_NAMES_OF_CGAL_6_H

// What programs that work with CGAL 5 and with CGAL 6 use by the names of CGAL 6.

#include <CGAL/Compact_surface_mesh/internal/versions_of_cgal.h>

#if CGAL_COMPACT_SURFACE_MESH_WITH_CGAL_6
#include <CGAL/AABB_traits_3.h>
#include <variant>
#else
#include <CGAL/AABB_traits.h>
#include <boost/variant.hpp>
#endif

namespace example {

#if CGAL_COMPACT_SURFACE_MESH_WITH_CGAL_6
using CGAL::AABB_traits_3;
using std::get_if;
#else
template <class Kernel, class Primitive>
using AABB_traits_3 = CGAL::AABB_traits<Kernel, Primitive>;

template <class T, class Variant>
auto get_if(Variant* variant)
{
  return boost::get<T>(variant);
}
#endif

} // namespace example

#endif // COMPACT_SURFACE_MESH_EXAMPLES_NAMES_OF_CGAL_6_H
