// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_IO_GOCAD_H
#define CGAL_COMPACT_SURFACE_MESH_IO_GOCAD_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/IO/internal/read_mesh.h>

#include <CGAL/IO/GOCAD.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/IO/GOCAD.h>

#include <fstream>
#include <iostream>
#include <string>
#include <utility>

namespace CGAL {
namespace IO {

/*!
\ingroup PkgCompactSurfaceMeshIO

reads the mesh `mesh`, which must be empty, from a stream in the \ref IOStreamGocad. Coordinates are read as by
`read_OBJ()`.

\param is the input stream; its failbit is set on failure
\param name_and_color receives the name and the color that the file gives the mesh; on failure it is unchanged
\param mesh the mesh, which stays as it was on failure
\param np a sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`, `verbose`

\returns whether it is read
*/
template <class P, class L, class CGAL_NP_TEMPLATE_PARAMETERS>
bool read_GOCAD(std::istream& is, std::pair<std::string, std::string>& name_and_color,
                Compact_surface_mesh<P, L>& mesh, const CGAL_NP_CLASS& np = parameters::default_values())
{
  std::pair<std::string, std::string> read_name_and_color;
  const bool is_read = internal::read_mesh(is, mesh, np, [&](auto& soup) {
    return read_GOCAD(is, read_name_and_color, soup.points, soup.polygons,
                      parameters::verbose(internal::is_verbose(np)));
  });
  if (is_read)
    name_and_color.swap(read_name_and_color);
  return is_read;
}

/// \ingroup PkgCompactSurfaceMeshIO
/// reads the mesh `mesh`, which must be empty, from a stream as the function above does.
template <class P, class L, class CGAL_NP_TEMPLATE_PARAMETERS>
bool read_GOCAD(std::istream& is, Compact_surface_mesh<P, L>& mesh,
                const CGAL_NP_CLASS& np = parameters::default_values())
{
  std::pair<std::string, std::string> name_and_color;
  return read_GOCAD(is, name_and_color, mesh, np);
}

/// \ingroup PkgCompactSurfaceMeshIO
/// reads the mesh `mesh`, which must be empty, from the file `fname`, as the functions above do.
template <class P, class L, class CGAL_NP_TEMPLATE_PARAMETERS>
bool read_GOCAD(const std::string& fname, std::pair<std::string, std::string>& name_and_color,
                Compact_surface_mesh<P, L>& mesh, const CGAL_NP_CLASS& np = parameters::default_values())
{
  std::ifstream is(fname);
  return read_GOCAD(is, name_and_color, mesh, np);
}

/// \ingroup PkgCompactSurfaceMeshIO
/// reads the mesh `mesh`, which must be empty, from the file `fname`, as the functions above do.
template <class P, class L, class CGAL_NP_TEMPLATE_PARAMETERS>
bool read_GOCAD(const std::string& fname, Compact_surface_mesh<P, L>& mesh,
                const CGAL_NP_CLASS& np = parameters::default_values())
{
  std::pair<std::string, std::string> name_and_color;
  return read_GOCAD(fname, name_and_color, mesh, np);
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_IO_GOCAD_H
