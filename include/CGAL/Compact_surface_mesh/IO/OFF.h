// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_IO_OFF_H
#define CGAL_COMPACT_SURFACE_MESH_IO_OFF_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Compact_surface_mesh.h>
#include <CGAL/Compact_surface_mesh/IO/internal/OFF_file.h>
#include <CGAL/Compact_surface_mesh/IO/internal/read_mesh.h>
#include <CGAL/boost/graph/graph_traits_Compact_surface_mesh.h>
#include <CGAL/boost/graph/properties_Compact_surface_mesh.h>

#include <CGAL/IO/Color.h>
#include <CGAL/IO/OFF/File_writer_OFF.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <fstream>
#include <iostream>
#include <string>
#include <type_traits>

namespace CGAL {
namespace IO {

/*!
\ingroup PkgCompactSurfaceMeshIO

reads the mesh `mesh`, which must be empty, from a stream in the \ref IOStreamOFF, text or binary.

The attributes that the file has, by its header, become the property maps `"v:normal"`, `"v:color"`, `"f:color"` and
`"v:texcoord"`, unless property maps for them are given. Elements without a color are black where others have one.

\param is the input stream, opened with `std::ios::binary` for a binary file; its failbit is set on failure
\param mesh the mesh, which stays as it was on failure
\param np a sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`, `vertex_normal_map`,
  `vertex_color_map`, `vertex_texture_map`, `face_color_map`, `verbose`

\returns whether it is read
*/
template <class P, class L, class CGAL_NP_TEMPLATE_PARAMETERS>
bool read_OFF(std::istream& is, Compact_surface_mesh<P, L>& mesh,
              const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::read_mesh(is, mesh, np, [&](auto& soup) {
    internal::OFF_file file(is);
    soup.vertex_normals.is_wanted |= file.header().has_normals();
    soup.vertex_colors.is_wanted |= file.header().has_colors();
    soup.vertex_textures.is_wanted |= file.header().has_textures();
    soup.face_colors.is_wanted |= file.header().has_colors();
    file.read(soup);
    return true;
  });
}

/// \ingroup PkgCompactSurfaceMeshIO
/// reads the mesh `mesh`, which must be empty, from the file `fname`, as the function above does.
template <class P, class L, class CGAL_NP_TEMPLATE_PARAMETERS>
bool read_OFF(const std::string& fname, Compact_surface_mesh<P, L>& mesh,
              const CGAL_NP_CLASS& np = parameters::default_values())
{
  std::ifstream is(fname, std::ios::binary);
  return read_OFF(is, mesh, np);
}

namespace internal {

// A property map whose values are written if there is one.
template <class Map>
struct Written_map
{
  Map map;
  bool is_there;
};

// The map that the caller gives, or else that of the mesh, if it shall be written and is not empty.
template <class Element, class T, class Mesh, class NamedParameters, class Tag>
auto written_map(const Mesh& mesh, bool with_own_maps, const char* name, const NamedParameters& np, Tag tag)
{
  if constexpr (parameters::is_default_parameter<NamedParameters, Tag>::value) {
    const auto map = mesh.template find_property_map<Element, T>(name);
    return Written_map<std::decay_t<decltype(map)> >{ map, with_own_maps && map && map.begin() != map.end() };
  } else {
    const auto map = parameters::get_parameter(np, tag);
    return Written_map<std::decay_t<decltype(map)> >{ map, true };
  }
}

template <class Mesh, class NamedParameters>
bool print_OFF(std::ostream& os, const Mesh& mesh, bool with_own_maps, const NamedParameters& np)
{
  using Vertex_index = typename Mesh::Vertex_index;
  using Point = typename boost::property_traits<
                  typename GetVertexPointMap<Mesh, NamedParameters>::const_type>::value_type;
  using Kernel = typename Kernel_traits<Point>::Kernel;
  if (!os.good())
    return false;
  set_stream_precision_from_NP(os, np);
  const auto point = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                  get_const_property_map(CGAL::vertex_point, mesh));
  const auto normal = written_map<Vertex_index, typename Kernel::Vector_3>(
                        mesh, with_own_maps, "v:normal", np, internal_np::vertex_normal_map);
  const auto color = written_map<Vertex_index, Color>(
                       mesh, with_own_maps, "v:color", np, internal_np::vertex_color_map);
  const auto texture = written_map<Vertex_index, typename Kernel::Point_2>(
                         mesh, with_own_maps, "v:texcoord", np, internal_np::vertex_texture_map);
  const auto face_color = written_map<typename Mesh::Face_index, Color>(
                            mesh, with_own_maps, "f:color", np, internal_np::face_color_map);

  File_writer_OFF writer;
  writer.write_header(os, mesh.number_of_vertices(), mesh.number_of_halfedges(), mesh.number_of_faces(),
                      color.is_there || face_color.is_there, normal.is_there, texture.is_there);
  for (const auto v : mesh.vertices()) {
    const auto& p = get(point, v);
    writer.write_vertex(to_double(p.x()), to_double(p.y()), to_double(p.z()));
    if (normal.is_there) {
      const auto& n = get(normal.map, v);
      writer.write_vertex_normal(to_double(n.x()), to_double(n.y()), to_double(n.z()));
    }
    if (color.is_there) {
      const Color& c = get(color.map, v);
      writer.write_vertex_color(c.red(), c.green(), c.blue());
    }
    if (texture.is_there) {
      const auto& t = get(texture.map, v);
      writer.write_vertex_texture(to_double(t.x()), to_double(t.y()));
    }
  }
  writer.write_facet_header();
  for (const auto f : mesh.faces()) {
    writer.write_facet_begin(mesh.degree(f));
    for (const auto v : vertices_around_face(mesh.halfedge(f), mesh))
      writer.write_facet_vertex_index(v.idx());
    if (face_color.is_there) {
      const Color& c = get(face_color.map, f);
      writer.write_face_color(c.red(), c.green(), c.blue());
    }
    writer.write_facet_end();
  }
  writer.write_footer();
  return os.good();
}

} // namespace internal

/*!
\ingroup PkgCompactSurfaceMeshIO

writes the mesh `mesh` to a stream in the \ref IOStreamOFF, with its property maps `"v:normal"`, `"v:color"`,
`"v:texcoord"` and `"f:color"`, unless other property maps are given.

\param os the output stream
\param mesh the mesh
\param np a sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`, `vertex_normal_map`,
  `vertex_color_map`, `vertex_texture_map`, `face_color_map`, `stream_precision`

\returns whether it is written
*/
template <class P, class L, class CGAL_NP_TEMPLATE_PARAMETERS>
bool write_OFF(std::ostream& os, const Compact_surface_mesh<P, L>& mesh,
               const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::print_OFF(os, mesh, true, np);
}

/// \ingroup PkgCompactSurfaceMeshIO
/// writes the mesh `mesh` to the file `fname`, with the attributes for which property maps are given and no others,
/// as is done with `Surface_mesh`.
template <class P, class L, class CGAL_NP_TEMPLATE_PARAMETERS>
bool write_OFF(const std::string& fname, const Compact_surface_mesh<P, L>& mesh,
               const CGAL_NP_CLASS& np = parameters::default_values())
{
  std::ofstream os(fname);
  return internal::print_OFF(os, mesh, false, np);
}

} // namespace IO

/// \relates Compact_surface_mesh
/// writes the mesh in the \ref IOStreamOFF, as `IO::write_OFF()` does.
template <class P, class L>
std::ostream& operator<<(std::ostream& os, const Compact_surface_mesh<P, L>& mesh)
{
  IO::write_OFF(os, mesh);
  return os;
}

/// \relates Compact_surface_mesh
/// reads the mesh, which must be empty, in the \ref IOStreamOFF, as `IO::read_OFF()` does.
template <class P, class L>
std::istream& operator>>(std::istream& is, Compact_surface_mesh<P, L>& mesh)
{
  IO::read_OFF(is, mesh);
  return is;
}

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_IO_OFF_H
