// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_H
#define CGAL_SCHNYDER_WOODS_H

#include <CGAL/license/Compact_surface_mesh.h>

/// \file Schnyder_woods.h
/// includes all functions on Schnyder woods.

#include <CGAL/Schnyder_woods/Extremal_wood.h>
#include <CGAL/Schnyder_woods/Schnyder_wood_rules.h>
#include <CGAL/Schnyder_woods/Shelling_order.h>
#include <CGAL/Schnyder_woods/cut_graph.h>
#include <CGAL/Schnyder_woods/cut_graph_loops.h>
#include <CGAL/Schnyder_woods/extremal_schnyder_wood.h>
#include <CGAL/Schnyder_woods/g_schnyder_wood.h>
#include <CGAL/Schnyder_woods/is_schnyder_wood.h>
#include <CGAL/Schnyder_woods/random_planar_triangulation.h>
#include <CGAL/Schnyder_woods/schnyder_drawing.h>
#include <CGAL/Schnyder_woods/schnyder_wood.h>

#endif // CGAL_SCHNYDER_WOODS_H
