// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef SURFACE_MESH_IN_INPUT_ORDER_H
#define SURFACE_MESH_IN_INPUT_ORDER_H

#include <CGAL/Compact_surface_mesh.h>
#include <CGAL/Compact_surface_mesh/layouts/Input_order_layout.h>

namespace CGAL {

// A mesh whose vertices and faces have the numbers that they have in the file.
template <class Point>
using Surface_mesh_in_input_order =
  Compact_surface_mesh<Point, Input_order_layout<Schnyder_parents_layout<>, Input_order::VERTICES_AND_FACES>>;

} // namespace CGAL

#endif // SURFACE_MESH_IN_INPUT_ORDER_H
