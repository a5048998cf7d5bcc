// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_EXTREMAL_WOOD_H
#define CGAL_SCHNYDER_WOODS_EXTREMAL_WOOD_H

#include <CGAL/license/Compact_surface_mesh.h>

namespace CGAL {

/*!
\ingroup PkgSchnyderWoodsRef

Which of the two extremal woods. A face is clockwise if the three edges around it, in the
direction in which they are written, have it to their right.
*/
enum class Extremal_wood
{
  WITHOUT_CLOCKWISE_FACES,       ///< called maximal by L. Castelli Aleardi and O. Devillers (JoCG 2018)
  WITHOUT_COUNTERCLOCKWISE_FACES ///< its mirror image
};

} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_EXTREMAL_WOOD_H
