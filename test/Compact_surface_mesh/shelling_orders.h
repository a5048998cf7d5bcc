// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_SHELLING_ORDERS_H
#define TEST_COMPACT_SURFACE_MESH_SHELLING_ORDERS_H

#include <CGAL/Schnyder_woods/Shelling_order.h>

namespace test {

const CGAL::Shelling_order all_orders[] = {CGAL::Shelling_order::LAST_IN_FIRST_OUT,
                                           CGAL::Shelling_order::FIRST_IN_FIRST_OUT,
                                           CGAL::Shelling_order::RANDOM};

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_SHELLING_ORDERS_H
