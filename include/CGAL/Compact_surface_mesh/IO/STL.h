// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_IO_STL_H
#define CGAL_COMPACT_SURFACE_MESH_IO_STL_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/IO/internal/Attributed_soup.h>
#include <CGAL/Compact_surface_mesh/IO/internal/read_mesh.h>

#include <CGAL/IO/STL.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/IO/STL.h>

#include <fstream>
#include <iostream>
#include <string>

namespace CGAL {
namespace IO {

namespace internal {

template <class Soup, class NamedParameters>
bool read_STL_soup(std::istream& is, Soup& soup, const NamedParameters& np)
{
  return read_points(soup, [&](auto& points) {
    return read_STL(is, points, soup.polygons, parameters::verbose(is_verbose(np)));
  });
}

} // namespace internal

/*!
\ingroup PkgCompactSurfaceMeshIO

reads the mesh `mesh`, which must be empty, from a stream in the \ref IOStreamSTL, text or binary. Equal points
are one vertex.

\param is the input stream, opened with `std::ios::binary` for a binary file; its failbit is set on failure
\param mesh the mesh, which stays as it was on failure
\param np a sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`, `verbose`

\returns whether it is read
*/
template <class P, class L, class CGAL_NP_TEMPLATE_PARAMETERS>
bool read_STL(std::istream& is, Compact_surface_mesh<P, L>& mesh,
              const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::read_mesh(is, mesh, np, [&](auto& soup) { return internal::read_STL_soup(is, soup, np); });
}

/// \ingroup PkgCompactSurfaceMeshIO
/// reads the mesh `mesh`, which must be empty, from the file `fname`, as the function above does.
template <class P, class L, class CGAL_NP_TEMPLATE_PARAMETERS>
bool read_STL(const std::string& fname, Compact_surface_mesh<P, L>& mesh,
              const CGAL_NP_CLASS& np = parameters::default_values())
{
  std::ifstream is(fname, std::ios::binary);
  return read_STL(is, mesh, np);
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_IO_STL_H
