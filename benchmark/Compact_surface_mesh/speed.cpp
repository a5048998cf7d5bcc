// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Times of traversals and of single operators in all structures, on large meshes of several
// kinds and orders, as ratios to Surface_mesh.

#include "ratio_driver.h"
#include "speed_comparison.h"

int main(int argc, char* argv[]) { return ratio_driver::main(argc, argv, speed_comparison); }
