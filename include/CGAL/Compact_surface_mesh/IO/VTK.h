// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The VTP format of VTK, for programs that are compiled with it.

#ifndef CGAL_COMPACT_SURFACE_MESH_IO_VTK_H
#define CGAL_COMPACT_SURFACE_MESH_IO_VTK_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/IO/internal/Attributed_soup.h>
#include <CGAL/Compact_surface_mesh/IO/internal/read_mesh.h>

#include <CGAL/IO/VTK.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/IO/VTK.h>

#include <string>

#if defined(CGAL_USE_VTK) || defined(DOXYGEN_RUNNING)

namespace CGAL {
namespace IO {

namespace internal {

template <class Soup, class NamedParameters>
bool read_VTP_soup(const std::string& fname, Soup& soup, const NamedParameters& np)
{
  return read_points(soup, [&](auto& points) {
    return read_VTP(fname, points, soup.polygons, parameters::verbose(is_verbose(np)));
  });
}

} // namespace internal

/*!
\ingroup PkgCompactSurfaceMeshIO

reads the mesh `mesh`, which must be empty, from the file `fname` in the \ref IOStreamVTK. It needs VTK.

\param fname the name of the file
\param mesh the mesh, which stays as it was on failure
\param np a sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`, `verbose`

\returns whether it is read
*/
template <class P, class L, class CGAL_NP_TEMPLATE_PARAMETERS>
bool read_VTP(const std::string& fname, Compact_surface_mesh<P, L>& mesh,
              const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::read_mesh(mesh, np, [&](auto& soup) { return internal::read_VTP_soup(fname, soup, np); });
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_USE_VTK

#endif // CGAL_COMPACT_SURFACE_MESH_IO_VTK_H
