// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_POLYGON_SOUP_TO_POLYGON_MESH_H
#define CGAL_COMPACT_SURFACE_MESH_POLYGON_SOUP_TO_POLYGON_MESH_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Compact_surface_mesh.h>
#include <CGAL/Compact_surface_mesh/internal/Mesh_filling.h>
#include <CGAL/boost/graph/properties_Compact_surface_mesh.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <boost/iterator/transform_iterator.hpp>

#include <iterator>

namespace CGAL {
namespace Polygon_mesh_processing {

/*!
\ingroup PkgCompactSurfaceMeshRef

makes the empty mesh `mesh` that of a polygon soup. This is the function of the package Polygon Mesh Processing for
meshes that can be filled but not edited. Soups that are no mesh are refused in all builds, whether assertions
are on or off. The property maps of `mesh` stay.

\tparam PointRange a range of points, or with `point_map` of anything
\tparam PolygonRange a range of ranges of integers
\tparam NamedParameters_PS a sequence of \ref bgl_namedparameters "Named Parameters"
\tparam NamedParameters_PM a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the points of the vertices
\param polygons the indices in `points` of the vertices of each face, counterclockwise
\param mesh the mesh to fill; it stays as it was if something is thrown
\param np_ps `point_map`: a property map from the elements of `points` to points; and all that the constructor of
  `Compact_surface_mesh` from a soup takes; from \cgal 6 on also by the names `point_to_vertex_output_iterator`,
  `point_to_vertex_map`, `polygon_to_face_output_iterator` and `polygon_to_face_map`
\param np_pm `vertex_point_map`: a property map of `mesh` that gets the points in place of `mesh.points()`

\throws Mesh_defect_exception if the soup is no mesh that `Compact_surface_mesh` takes
\throws std::runtime_error if `mesh` is not empty
*/
template <
#ifndef DOXYGEN_RUNNING // in the place of a parameter of CGAL's function, in case that a caller names it
          class = void,
#endif
          class PointRange, class PolygonRange
          , class NamedParameters_PS = parameters::Default_named_parameters
          , class NamedParameters_PM = parameters::Default_named_parameters
          , class P, class L>
void polygon_soup_to_polygon_mesh(const PointRange& points, const PolygonRange& polygons,
                                  Compact_surface_mesh<P, L>& mesh,
                                  const NamedParameters_PS& np_ps = parameters::default_values(),
                                  const NamedParameters_PM& np_pm = parameters::default_values())
{
  CGAL::internal::Mesh_filling<Compact_surface_mesh<P, L> > filling(mesh);
  const auto fill = [&](const auto& point_range) {
    if constexpr (parameters::is_default_parameter<NamedParameters_PM, internal_np::vertex_point_t>::value)
      filling.take_soup(point_range, polygons, np_ps);
    else
      filling.take_soup(point_range, polygons, np_ps, parameters::get_parameter(np_pm, internal_np::vertex_point));
  };
  if constexpr (parameters::is_default_parameter<NamedParameters_PS, internal_np::point_t>::value)
    fill(points);
  else {
    const auto point_map = parameters::get_parameter(np_ps, internal_np::point_map);
    const auto point_of = [point_map](const auto& element) { return get(point_map, element); };
    fill(CGAL::make_range(boost::make_transform_iterator(std::begin(points), point_of),
                          boost::make_transform_iterator(std::end(points), point_of)));
  }
  filling.finish();
}

} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_POLYGON_SOUP_TO_POLYGON_MESH_H
