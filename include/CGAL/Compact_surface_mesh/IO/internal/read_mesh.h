// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// How what a file says becomes a mesh, whatever the format.

#ifndef CGAL_COMPACT_SURFACE_MESH_IO_INTERNAL_READ_MESH_H
#define CGAL_COMPACT_SURFACE_MESH_IO_INTERNAL_READ_MESH_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Compact_surface_mesh.h>
#include <CGAL/Compact_surface_mesh/IO/internal/Attributed_soup.h>
#include <CGAL/Compact_surface_mesh/internal/Mesh_filling.h>
#include <CGAL/boost/graph/properties_Compact_surface_mesh.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>

#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

using CGAL::internal::Mesh_filling;

template <class NamedParameters>
bool is_verbose(const NamedParameters& np)
{
  return parameters::choose_parameter(parameters::get_parameter(np, internal_np::verbose), false);
}

// Returns false, and prints the reason if `verbose`.
inline bool refuse(const std::string& reason, bool verbose)
{
  if (verbose)
    std::cerr << "Error: " << reason << std::endl;
  return false;
}

template <class NamedParameters>
bool refuse_ending(const std::string& fname, const NamedParameters& np)
{
  return refuse("no format for meshes is known by the ending of the file name " + fname, is_verbose(np));
}

// Returns what read() returns, or false if it throws.
template <class Read>
bool attempt(const Read& read, bool verbose)
{
  try {
    return read();
  } catch (const std::exception& e) {
    return refuse(e.what(), verbose);
  } catch (...) {
    return refuse("something was thrown that is no exception of C++", verbose);
  }
}

template <class NamedParameters, class Tag>
constexpr bool is_given = !parameters::is_default_parameter<NamedParameters, Tag>::value;

template <class Map, class Values, class Elements>
void put_all(const Map& map, const Values& values, const Elements& elements)
{
  CGAL::internal::check_map_of_empty_mesh<Map>();
  CGAL_assertion(values.size() <= elements.size());
  for (typename Values::size_type i = 0; i < values.size(); ++i)
    put(map, elements[i], values[i]);
}

// Makes `filling` the mesh of a soup, and tells what became of its vertices and, where this is wanted, of its faces.
template <class Mesh, class NamedParameters>
class Soup_filling
{
  using Point_map = typename GetVertexPointMap<Mesh, NamedParameters>::type;
  template <class Tag> static constexpr bool is_given = internal::is_given<NamedParameters, Tag>;

public:
  using Soup = Attributed_soup<typename boost::property_traits<Point_map>::value_type>;

  Soup_filling(Mesh_filling<Mesh>& filling, const NamedParameters& np) : m_filling(filling), m_np(np) {}

  // An empty soup in which the attributes are wanted for which the caller gives property maps.
  static Soup empty_soup()
  {
    Soup soup;
    soup.vertex_normals.is_wanted = is_given<internal_np::vertex_normal_map_t>;
    soup.vertex_colors.is_wanted = is_given<internal_np::vertex_color_map_t>;
    soup.vertex_textures.is_wanted = is_given<internal_np::vertex_texture_map_t>;
    soup.face_colors.is_wanted = is_given<internal_np::face_color_map_t>;
    return soup;
  }

  // Stores the attributes that are wanted in the maps that the caller gives, or in the mesh.
  void fill(const Soup& soup, bool wants_faces)
  {
    if constexpr (is_given<internal_np::vertex_point_t>)
      assign(soup, wants_faces, parameters::get_parameter(m_np, internal_np::vertex_point));
    else
      assign(soup, wants_faces);
    const Color black(0, 0, 0);
    store(soup.vertex_normals, internal_np::vertex_normal_map, "v:normal", vertices, NULL_VECTOR);
    store(soup.vertex_colors, internal_np::vertex_color_map, "v:color", vertices, black);
    store(soup.vertex_textures, internal_np::vertex_texture_map, "v:texcoord", vertices, ORIGIN);
    store(soup.face_colors, internal_np::face_color_map, "f:color", faces, black);
  }

  std::vector<typename Mesh::Vertex_index> vertices;
  std::vector<typename Mesh::Face_index> faces;

private:
  template <class... PointMap>
  void assign(const Soup& soup, bool wants_faces, const PointMap&... point_map)
  {
    vertices.resize(soup.points.size());
    const auto np = parameters::vertex_to_vertex_map(make_property_map(vertices));
    if (wants_faces) {
      faces.resize(soup.polygons.size());
      m_filling.take_soup(soup.points, soup.polygons, np.face_to_face_map(make_property_map(faces)), point_map...);
    } else
      m_filling.take_soup(soup.points, soup.polygons, np, point_map...);
  }

  template <class T, class Tag, class Element, class Default>
  void store(const Soup_attribute<T>& attribute, Tag tag, const char* name, const std::vector<Element>& elements,
             const Default& default_value)
  {
    if (!attribute.is_wanted)
      return;
    if constexpr (is_given<Tag>)
      put_all(parameters::get_parameter(m_np, tag), attribute.values, elements);
    else
      put_all(m_filling.template add_property_map<Element>(name, T(default_value)).first, attribute.values, elements);
  }

  Mesh_filling<Mesh>& m_filling;
  const NamedParameters& m_np;
};

// Makes `mesh`, which must be empty, the mesh of the soup that read(soup) reads. Returns false if this fails, and
// then leaves the mesh as it was.
template <class Mesh, class NamedParameters, class Read>
bool read_mesh(Mesh& mesh, const NamedParameters& np, const Read& read)
{
  return attempt([&] {
    Mesh_filling<Mesh> filling(mesh);
    Soup_filling<Mesh, NamedParameters> soup_filling(filling, np);
    auto soup = soup_filling.empty_soup();
    if (!read(soup))
      return false;
    soup_filling.fill(soup, !soup.face_colors.values.empty());
    filling.finish();
    return true;
  }, is_verbose(np));
}

// Sets the failbit of `is` if its reading failed.
inline bool reported_to(std::istream& is, bool success)
{
  if (!success)
    is.setstate(std::ios::failbit);
  return success;
}

// Does the same for a soup that is read from `is`.
template <class Mesh, class NamedParameters, class Read>
bool read_mesh(std::istream& is, Mesh& mesh, const NamedParameters& np, const Read& read)
{
  return reported_to(is, read_mesh(mesh, np, read));
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_IO_INTERNAL_READ_MESH_H
