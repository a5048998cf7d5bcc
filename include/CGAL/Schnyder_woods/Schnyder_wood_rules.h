// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_SCHNYDER_WOOD_RULES_H
#define CGAL_SCHNYDER_WOODS_SCHNYDER_WOOD_RULES_H

#include <CGAL/license/Compact_surface_mesh.h>

namespace CGAL {

/*!
\ingroup PkgSchnyderWoodsRef

How many of the rules of g-Schnyder woods `is_g_schnyder_wood()` checks. Each set includes those before it.
*/
enum class Schnyder_wood_rules
{
  LOCAL,     ///< those of edges and vertices, which extremal woods keep
  CUT_GRAPH, ///< definition 3.1: also the forest and the cut graph, which extremal woods keep on demand
  CELLULAR   ///< proposition 3.5: also the graphs of colors 0 and 1, which woods by conquests have
};

} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_SCHNYDER_WOOD_RULES_H
