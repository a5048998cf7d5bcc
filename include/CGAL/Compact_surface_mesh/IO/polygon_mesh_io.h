// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// All formats, by the endings of file names.

#ifndef CGAL_COMPACT_SURFACE_MESH_IO_POLYGON_MESH_IO_H
#define CGAL_COMPACT_SURFACE_MESH_IO_POLYGON_MESH_IO_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/IO/GOCAD.h>
#include <CGAL/Compact_surface_mesh/IO/OBJ.h>
#include <CGAL/Compact_surface_mesh/IO/OFF.h>
#include <CGAL/Compact_surface_mesh/IO/PLY.h>
#include <CGAL/Compact_surface_mesh/IO/STL.h>
#include <CGAL/Compact_surface_mesh/IO/VTK.h>
#include <CGAL/Compact_surface_mesh/IO/internal/read_mesh.h>

#include <CGAL/IO/helpers.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <string>

namespace CGAL {
namespace IO {

/*!
\ingroup PkgCompactSurfaceMeshIO

reads the mesh `mesh`, which must be empty, from the file `fname`, by the reader of the format that its ending
names: `off`, `obj`, `stl`, `ply`, `ts`, and `vtp` where VTK is used, in small or capital letters.

\param fname the name of the file
\param mesh the mesh, which stays as it was on failure
\param np a sequence of \ref bgl_namedparameters "Named Parameters", as for that reader

\returns whether it is read
*/
template <class P, class L, class CGAL_NP_TEMPLATE_PARAMETERS>
bool read_polygon_mesh(const std::string& fname, Compact_surface_mesh<P, L>& mesh,
                       const CGAL_NP_CLASS& np = parameters::default_values())
{
  const std::string ending = internal::get_file_extension(fname);
  if (ending == "off")
    return read_OFF(fname, mesh, np);
  if (ending == "obj")
    return read_OBJ(fname, mesh, np);
  if (ending == "stl")
    return read_STL(fname, mesh, np);
  if (ending == "ply")
    return read_PLY(fname, mesh, np);
  if (ending == "ts")
    return read_GOCAD(fname, mesh, np);
#ifdef CGAL_USE_VTK
  if (ending == "vtp")
    return read_VTP(fname, mesh, np);
#endif
  return internal::refuse_ending(fname, np);
}

/*!
\ingroup PkgCompactSurfaceMeshIO

writes the mesh `mesh` to the file `fname`, by the writer of the format that its ending names, as for
`read_polygon_mesh()`.

\param fname the name of the file
\param mesh the mesh
\param np a sequence of \ref bgl_namedparameters "Named Parameters", as for that writer

\returns whether it is written
*/
template <class P, class L, class CGAL_NP_TEMPLATE_PARAMETERS>
bool write_polygon_mesh(const std::string& fname, const Compact_surface_mesh<P, L>& mesh,
                        const CGAL_NP_CLASS& np = parameters::default_values())
{
  const std::string ending = internal::get_file_extension(fname);
  if (ending == "off")
    return write_OFF(fname, mesh, np);
  if (ending == "obj")
    return write_OBJ(fname, mesh, np);
  if (ending == "stl")
    return write_STL(fname, mesh, np);
  if (ending == "ply")
    return write_PLY(fname, mesh, np);
  if (ending == "ts")
    return write_GOCAD(fname, mesh, np);
#ifdef CGAL_USE_VTK
  if (ending == "vtp")
    return write_VTP(fname, mesh, np);
#endif
  return internal::refuse_ending(fname, np);
}

#ifndef DOXYGEN_RUNNING
// CGAL's function takes any `Graph&`, which would suit a mesh that is not const better.
template <class P, class L, class CGAL_NP_TEMPLATE_PARAMETERS>
bool write_polygon_mesh(const std::string& fname, Compact_surface_mesh<P, L>& mesh,
                        const CGAL_NP_CLASS& np = parameters::default_values())
{
  return write_polygon_mesh(fname, static_cast<const Compact_surface_mesh<P, L>&>(mesh), np);
}
#endif

} // namespace IO

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_IO_POLYGON_MESH_IO_H
