// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_IO_OBJ_H
#define CGAL_COMPACT_SURFACE_MESH_IO_OBJ_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/IO/internal/read_mesh.h>

#include <CGAL/IO/OBJ.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/IO/OBJ.h>

#include <fstream>
#include <iostream>
#include <string>

namespace CGAL {
namespace IO {

/*!
\ingroup PkgCompactSurfaceMeshIO

reads the mesh `mesh`, which must be empty, from a stream in the \ref IOStreamOBJ. Normals and texture
coordinates are skipped.

Coordinates are read by the operator of `P`: with some exact number types, one whose denominator is zero ends the
program.

\param is the input stream; its failbit is set on failure
\param mesh the mesh, which stays as it was on failure
\param np a sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`, `verbose`

\returns whether it is read
*/
template <class P, class L, class CGAL_NP_TEMPLATE_PARAMETERS>
bool read_OBJ(std::istream& is, Compact_surface_mesh<P, L>& mesh,
              const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::read_mesh(is, mesh, np, [&](auto& soup) {
    return read_OBJ(is, soup.points, soup.polygons, parameters::verbose(internal::is_verbose(np)));
  });
}

/// \ingroup PkgCompactSurfaceMeshIO
/// reads the mesh `mesh`, which must be empty, from the file `fname`, as the function above does.
template <class P, class L, class CGAL_NP_TEMPLATE_PARAMETERS>
bool read_OBJ(const std::string& fname, Compact_surface_mesh<P, L>& mesh,
              const CGAL_NP_CLASS& np = parameters::default_values())
{
  std::ifstream is(fname);
  return read_OBJ(is, mesh, np);
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_IO_OBJ_H
