// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The reader of Polygon_mesh_processing, whose headers are only needed where it is called.

#ifndef CGAL_COMPACT_SURFACE_MESH_IO_REPAIRED_POLYGON_MESH_IO_H
#define CGAL_COMPACT_SURFACE_MESH_IO_REPAIRED_POLYGON_MESH_IO_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Compact_surface_mesh.h>
#include <CGAL/Compact_surface_mesh/IO/OFF.h>
#include <CGAL/Compact_surface_mesh/IO/PLY.h>
#include <CGAL/Compact_surface_mesh/IO/STL.h>
#include <CGAL/Compact_surface_mesh/IO/VTK.h>
#include <CGAL/Compact_surface_mesh/IO/internal/read_mesh.h>

#include <CGAL/IO/helpers.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// Reads a soup without its attributes.
template <class Soup, class NamedParameters>
bool read_soup(const std::string& fname, Soup& soup, const NamedParameters& np)
{
  const std::string ending = get_file_extension(fname);
#ifdef CGAL_USE_VTK
  if (ending == "vtp")
    return read_VTP_soup(fname, soup, np);
#endif
  if (ending == "obj" || ending == "ts")
    return read_polygon_soup(fname, soup.points, soup.polygons, parameters::verbose(is_verbose(np)));
  std::ifstream is(fname, std::ios::binary);
  if (ending == "stl")
    return read_STL_soup(is, soup, np);
  if (ending == "ply")
    read_PLY_soup(is, soup);
  else if (ending == "off")
    OFF_file(is).read(soup);
  else
    return refuse_ending(fname, np);
  return true;
}

} // namespace internal
} // namespace IO

namespace Polygon_mesh_processing {

#ifndef DOXYGEN_RUNNING
// The polygons of a soup. As this type lives here, functions of this namespace are found for it where a template is
// instantiated, be they declared before that template or not.
struct Soup_polygons
  : std::vector<std::vector<std::size_t> >
{
  using std::vector<std::vector<std::size_t> >::vector;
};
#endif

namespace IO {

/*!
\ingroup PkgCompactSurfaceMeshIO

reads a polygon soup from the file `fname`, repairs it by `repair_polygon_soup()`, orients it by
`orient_polygon_soup()`, and makes it the mesh `mesh`, which must be empty.

As for other meshes, `<CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>` has to be included.

\param fname the name of the file, whose ending names the format
\param mesh the mesh, which stays as it was on failure
\param np a sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`, `repair_polygon_soup`,
  `verbose`, and those of `repair_polygon_soup()`

\returns whether it is read
*/
template <class P, class L, class CGAL_NP_TEMPLATE_PARAMETERS>
bool read_polygon_mesh(const std::string& fname, Compact_surface_mesh<P, L>& mesh,
                       const CGAL_NP_CLASS& np = parameters::default_values())
{
  return CGAL::IO::internal::read_mesh(mesh, np, [&](auto& soup) {
    if (!CGAL::IO::internal::read_soup(fname, soup, np))
      return CGAL::IO::internal::refuse("cannot read the polygon soup", CGAL::IO::internal::is_verbose(np));
    for (const auto& polygon : soup.polygons) // the functions below take what follows for granted
      for (const std::size_t v : polygon)
        if (v >= soup.points.size())
          throw std::runtime_error("a face names a vertex that does not exist");
    Soup_polygons polygons;
    polygons.swap(soup.polygons);
    if (parameters::choose_parameter(parameters::get_parameter(np, internal_np::repair_polygon_soup), true))
      repair_polygon_soup(soup.points, polygons, np);
    if (!orient_polygon_soup(soup.points, polygons) && CGAL::IO::internal::is_verbose(np))
      std::cerr << "Vertices were doubled to orient the polygon soup" << std::endl;
    polygons.swap(soup.polygons);
    return true;
  });
}

} // namespace IO
} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_IO_REPAIRED_POLYGON_MESH_IO_H
