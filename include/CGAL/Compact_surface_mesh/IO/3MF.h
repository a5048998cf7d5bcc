// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The 3MF format, for programs that are linked with its library.

#ifndef CGAL_COMPACT_SURFACE_MESH_IO_3MF_H
#define CGAL_COMPACT_SURFACE_MESH_IO_3MF_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Compact_surface_mesh.h>
#include <CGAL/Compact_surface_mesh/IO/internal/Attributed_soup.h>
#include <CGAL/Compact_surface_mesh/IO/internal/read_mesh.h>

#include <CGAL/IO/3MF.h>
#include <CGAL/IO/Color.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/IO/3MF.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#if defined(CGAL_LINKED_WITH_3MF) || defined(DOXYGEN_RUNNING)

namespace CGAL {
namespace IO {

/*!
\ingroup PkgCompactSurfaceMeshIO

reads the meshes of the file `fname` in the \ref IOStream3MF. It needs the library lib3mf.

What this class does not take as a mesh is left out. The property map `"f:color"` is added where faces have
different colors.

\param fname the name of the file
\param output the meshes are appended to it; on failure it stays as it was
\param np a sequence of \ref bgl_namedparameters "Named Parameters": `verbose`

\returns whether the file is read
*/
template <class P, class L, class CGAL_NP_TEMPLATE_PARAMETERS>
bool read_3MF(const std::string& fname, std::vector<Compact_surface_mesh<P, L> >& output,
              const CGAL_NP_CLASS& np = parameters::default_values())
{
  using Mesh = Compact_surface_mesh<P, L>;
  const auto has_several = [](const std::vector<Color>& colors) {
    return std::adjacent_find(colors.begin(), colors.end(), std::not_equal_to<Color>()) != colors.end();
  };
  return internal::attempt([&] {
    std::vector<std::vector<typename internal::Attributed_soup<P>::Read_point> > points;
    std::vector<std::vector<std::vector<std::size_t> > > polygons;
    std::vector<std::vector<Color> > colors;
    std::vector<std::string> names;
    if (!read_3MF(fname, points, polygons, colors, names))
      return internal::refuse("cannot read the meshes", internal::is_verbose(np));
    std::vector<Mesh> meshes;
    for (std::size_t i = 0; i < points.size(); ++i) {
      Mesh mesh;
      const bool is_read = internal::read_mesh(mesh, parameters::verbose(internal::is_verbose(np)), [&](auto& soup) {
        soup.polygons.swap(polygons[i]);
        soup.face_colors.values.swap(colors[i]);
        soup.face_colors.is_wanted = has_several(soup.face_colors.values);
        return internal::read_points(soup, [&](auto& read) {
          read.swap(points[i]);
          return true;
        });
      });
      if (is_read)
        meshes.push_back(std::move(mesh));
    }
    std::move(meshes.begin(), meshes.end(), std::back_inserter(output));
    return true;
  }, internal::is_verbose(np));
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_LINKED_WITH_3MF

#endif // CGAL_COMPACT_SURFACE_MESH_IO_3MF_H
