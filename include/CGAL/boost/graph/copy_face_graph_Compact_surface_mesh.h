// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_BOOST_GRAPH_COPY_FACE_GRAPH_COMPACT_SURFACE_MESH_H
#define CGAL_BOOST_GRAPH_COPY_FACE_GRAPH_COMPACT_SURFACE_MESH_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Compact_surface_mesh.h>
#include <CGAL/Compact_surface_mesh/internal/Input_report.h>
#include <CGAL/Compact_surface_mesh/internal/Mesh_filling.h>
#include <CGAL/Compact_surface_mesh/internal/simple_property_maps.h>
#include <CGAL/boost/graph/properties_Compact_surface_mesh.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/property_map.h>

#include <type_traits>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgCompactSurfaceMeshRef

makes the empty mesh `target` a copy of `source`. This is the function of the package %BGL for meshes that
can be filled but not edited. The property maps of `target` stay. From a `Surface_mesh` or a `Compact_surface_mesh`,
simple property maps are copied as the constructor of `Compact_surface_mesh` copies them.

\tparam SourceMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
\tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"

\param source the mesh to copy
\param target the mesh to fill; it stays as it was if something is thrown
\param np1 as for the constructor of `Compact_surface_mesh` from a graph: the output iterators and maps that are told
  the elements of `target`, the points and indices of `source`
\param np2 `vertex_point_map`: a property map of `target` that gets the points in place of `target.points()`

\throws Mesh_defect_exception if `source` is no mesh that `Compact_surface_mesh` takes
\throws std::runtime_error if `target` is not empty
*/
template <class SourceMesh
#ifndef DOXYGEN_RUNNING // in the places of the parameters of CGAL's function, in case that a caller names them
          , class = void
#endif
          , class NamedParameters1 = parameters::Default_named_parameters
          , class NamedParameters2 = parameters::Default_named_parameters
          , class P, class L>
void copy_face_graph(const SourceMesh& source, Compact_surface_mesh<P, L>& target,
                     const NamedParameters1& np1 = parameters::default_values(),
                     const NamedParameters2& np2 = parameters::default_values())
{
  internal::Mesh_filling<Compact_surface_mesh<P, L> > filling(target);
  if constexpr (parameters::is_default_parameter<NamedParameters2, internal_np::vertex_point_t>::value)
    filling.copy_graph(source, np1);
  else
    filling.copy_graph(source, np1, parameters::get_parameter(np2, internal_np::vertex_point));
  filling.finish();
}

#ifndef DOXYGEN_RUNNING
namespace internal_np {

enum only_connectivity_t { only_connectivity };

} // namespace internal_np

namespace internal {

// Asks for CGAL's function, in addition to what `np` asks for.
template <class NamedParameters>
auto by_function_of_cgal(const NamedParameters& np)
{
  return Named_function_parameters<bool, internal_np::only_connectivity_t, NamedParameters>(true, np);
}

template <class NamedParameters>
inline constexpr bool is_for_function_of_cgal =
  !parameters::is_default_parameter<NamedParameters, internal_np::only_connectivity_t>::value;

} // namespace internal
#endif

/*!
\ingroup PkgCompactSurfaceMeshRef

adds a copy of `source` to `target`, as the function of the package %BGL does, and copies the property maps of
`source` whose values are simple: those that the constructor of `Compact_surface_mesh` copies from a `Surface_mesh`.
As for all graphs, isolated vertices are not copied.

\param source the mesh to copy
\param target the mesh to which it is added
\param np1 as for `CGAL::copy_face_graph()`
\param np2 as for `CGAL::copy_face_graph()`
*/
template <class P, class L, class Q
          , class NamedParameters1 = parameters::Default_named_parameters
          , class NamedParameters2 = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          , class = std::enable_if_t<!internal::is_for_function_of_cgal<NamedParameters1> >
#endif
          >
void copy_face_graph(const Compact_surface_mesh<P, L>& source, Surface_mesh<Q>& target,
                     const NamedParameters1& np1 = parameters::default_values(),
                     const NamedParameters2& np2 = parameters::default_values())
{
  using Source = Compact_surface_mesh<P, L>;
  using Target = Surface_mesh<Q>;
  std::vector<typename Target::Vertex_index> vertices(source.number_of_vertices());
  std::vector<typename Target::Halfedge_index> halfedges(source.number_of_halfedges());
  std::vector<typename Target::Face_index> faces(source.number_of_faces());
  const auto points = parameters::choose_parameter(parameters::get_parameter(np1, internal_np::vertex_point),
                                                   get(CGAL::vertex_point, source));
  copy_face_graph(source, target,
                  internal::by_function_of_cgal(parameters::vertex_point_map(points)
                                                  .vertex_to_vertex_map(make_property_map(vertices))
                                                  .halfedge_to_halfedge_map(make_property_map(halfedges))
                                                  .face_to_face_map(make_property_map(faces))),
                  np2);

  // calls visit(element, image) for the elements that have one
  const auto for_each_pair = [](const auto& elements, const auto& images) {
    return [elements, &images](auto&& visit) {
      for (const auto element : elements)
        if (images[element].is_valid())
          visit(element, images[element]);
    };
  };
  const auto vertex_pairs = for_each_pair(source.vertices(), vertices);
  const auto halfedge_pairs = for_each_pair(source.halfedges(), halfedges);
  const auto face_pairs = for_each_pair(source.faces(), faces);
  const auto edge_pairs = [&](auto&& visit) {
    for (const auto e : source.edges())
      visit(e, target.edge(halfedges[source.halfedge(e)]));
  };
  internal::copy_simple_maps<typename Source::Vertex_index, typename Target::Vertex_index>(source, target,
                                                                                           vertex_pairs);
  internal::copy_simple_maps<typename Source::Halfedge_index, typename Target::Halfedge_index>(source, target,
                                                                                               halfedge_pairs);
  internal::copy_simple_maps<typename Source::Edge_index, typename Target::Edge_index>(source, target, edge_pairs);
  internal::copy_simple_maps<typename Source::Face_index, typename Target::Face_index>(source, target, face_pairs);

  // what the caller asked to be told
  vertex_pairs(internal::correspondence(np1, internal_np::vertex_to_vertex_output_iterator,
                                        internal_np::vertex_to_vertex_map));
  halfedge_pairs(internal::correspondence(np1, internal_np::halfedge_to_halfedge_output_iterator,
                                          internal_np::halfedge_to_halfedge_map));
  face_pairs(internal::correspondence(np1, internal_np::face_to_face_output_iterator,
                                      internal_np::face_to_face_map));
}

} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_COPY_FACE_GRAPH_COMPACT_SURFACE_MESH_H
