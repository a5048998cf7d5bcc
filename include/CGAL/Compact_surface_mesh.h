// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// All of Compact_surface_mesh by one include: the class and its layouts, what makes it a graph for the algorithms
// of CGAL and Boost, its input and output, and CGAL's functions that fill meshes.

#ifndef CGAL_COMPACT_SURFACE_MESH_H
#define CGAL_COMPACT_SURFACE_MESH_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Compact_surface_mesh.h>
#include <CGAL/Compact_surface_mesh/heat_method_3.h> // with Surface_mesh, whose readers CGAL's headers then find
#include <CGAL/boost/graph/graph_traits_Compact_surface_mesh.h>
#include <CGAL/boost/graph/properties_Compact_surface_mesh.h>
#include <CGAL/boost/graph/property_maps_Compact_surface_mesh.h>
#include <CGAL/Compact_surface_mesh/IO/3MF.h>
#include <CGAL/Compact_surface_mesh/IO/polygon_mesh_io.h>
#include <CGAL/Compact_surface_mesh/IO/repaired_polygon_mesh_io.h>
#include <CGAL/Compact_surface_mesh/convex_hull_3.h>
#include <CGAL/Compact_surface_mesh/mesh_3.h>
#include <CGAL/Compact_surface_mesh/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Compact_surface_mesh/surface_mesh_topology.h>
#include <CGAL/boost/graph/copy_face_graph_Compact_surface_mesh.h>
#include <CGAL/boost/graph/generators_Compact_surface_mesh.h>

#endif // CGAL_COMPACT_SURFACE_MESH_H
