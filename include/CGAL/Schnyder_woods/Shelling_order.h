// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_SHELLING_ORDER_H
#define CGAL_SCHNYDER_WOODS_SHELLING_ORDER_H

#include <CGAL/license/Compact_surface_mesh.h>

namespace CGAL {

/*!
\ingroup PkgSchnyderWoodsRef

In which order a shelling conquers the vertices that are free. All orders take linear
time and give a Schnyder wood, in general different ones.
*/
enum class Shelling_order
{
  LAST_IN_FIRST_OUT,  ///< the newest first: deep trees, best locality
  FIRST_IN_FIRST_OUT, ///< the oldest first: shallow trees
  RANDOM              ///< any of them, at random
};

} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_SHELLING_ORDER_H
