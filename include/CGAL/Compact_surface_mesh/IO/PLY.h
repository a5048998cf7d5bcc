// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_IO_PLY_H
#define CGAL_COMPACT_SURFACE_MESH_IO_PLY_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Compact_surface_mesh.h>
#include <CGAL/Compact_surface_mesh/IO/internal/Attributed_soup.h>
#include <CGAL/Compact_surface_mesh/IO/internal/PLY_file.h>
#include <CGAL/Compact_surface_mesh/IO/internal/PLY_properties.h>
#include <CGAL/Compact_surface_mesh/IO/internal/read_mesh.h>
#include <CGAL/Compact_surface_mesh/internal/Mesh_filling.h>
#include <CGAL/boost/graph/graph_traits_Compact_surface_mesh.h>

#include <CGAL/IO/Color.h>
#include <CGAL/IO/io.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <initializer_list>
#include <iostream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// Takes the polygons, the points and the normals that are wanted out of `file`. A missing coordinate is 0.
template <class Soup>
void take_soup(PLY_file& file, Soup& soup)
{
  const std::vector<PLY_column> xyz[3] = { file.vertices.take({ "x" }), file.vertices.take({ "y" }),
                                           file.vertices.take({ "z" }) };
  const auto coordinate = [&](int k, std::size_t i) { return xyz[k].empty() ? 0. : xyz[k][0].numbers[i]; };
  soup.points.reserve(file.vertices.size());
  for (std::size_t i = 0; i < file.vertices.size(); ++i)
    soup.points.push_back(object_of_file<typename Soup::Point>(coordinate(0, i), coordinate(1, i), coordinate(2, i)));
  soup.polygons.swap(file.polygons);
  if (!soup.vertex_normals.is_wanted)
    return;
  const std::vector<PLY_column> normal = file.vertices.take({ "nx", "ny", "nz" });
  if (!normal.empty())
    for (std::size_t i = 0; i < soup.points.size(); ++i)
      soup.vertex_normals.values.push_back(object_of_file<typename Soup::Normal>(
        normal[0].numbers[i], normal[1].numbers[i], normal[2].numbers[i]));
}

// Takes colors out of `table` if they are wanted and there, by either of the names that CGAL's reader of soups knows.
inline void take_colors(PLY_table& table, Soup_attribute<Color>& colors)
{
  if (!colors.is_wanted)
    return;
  if (table.has_colors({ "red", "green", "blue" }))
    colors.values = table.take_colors({ "red", "green", "blue" });
  else if (table.has_colors({ "r", "g", "b" }))
    colors.values = table.take_colors({ "r", "g", "b" });
}

// Reads a soup with the attributes that are wanted.
template <class Soup>
void read_PLY_soup(std::istream& is, Soup& soup)
{
  PLY_file file(is);
  take_soup(file, soup);
  take_colors(file.vertices, soup.vertex_colors);
  take_colors(file.faces, soup.face_colors);
}

// The pairs of vertices by which a file names edges or halfedges.
class PLY_vertex_pairs
{
public:
  // Takes the pairs out of `table`. Throws if a vertex is not less than `num_vertices`.
  PLY_vertex_pairs(PLY_table& table, std::initializer_list<const char*> names,
                   std::initializer_list<const char*> other_names, std::size_t num_vertices)
    : m_size(table.size()), m_columns(table.take(names))
  {
    if (m_columns.empty())
      m_columns = table.take(other_names);
    if (m_columns.empty() && m_size != 0)
      throw std::runtime_error("edges or halfedges do not name their vertices");
    for (const PLY_column& column : m_columns)
      for (std::size_t i = 0; i < m_size; ++i)
        if (!(column.numbers[i] >= 0 && column.numbers[i] < static_cast<double>(num_vertices)))
          throw std::runtime_error("an edge or a halfedge names a vertex that does not exist");
  }

  // Calls visit(u, v) for each pair.
  template <class Visitor>
  void for_each(const Visitor& visit) const
  {
    for (std::size_t i = 0; i < m_size; ++i)
      visit(static_cast<std::size_t>(m_columns[0].numbers[i]), static_cast<std::size_t>(m_columns[1].numbers[i]));
  }

private:
  std::size_t m_size;
  std::vector<PLY_column> m_columns;
};

// Makes the mesh of a file and stores normals, colors and all properties in it.
template <class Mesh>
bool read_PLY_with_properties(std::istream& is, Mesh& mesh, std::string& comments, bool verbose)
{
  return reported_to(is, attempt([&] {
    Mesh_filling<Mesh> filling(mesh);
    Soup_filling<Mesh, parameters::Default_named_parameters> soup_filling(filling, parameters::default_values());
    auto soup = soup_filling.empty_soup();
    PLY_file file(is);
    soup.vertex_normals.is_wanted = file.vertices.has("nx") && file.vertices.has("ny") && file.vertices.has("nz");
    soup.vertex_colors.is_wanted = file.vertices.has_colors({ "red", "green", "blue" });
    soup.face_colors.is_wanted = file.faces.has_colors({ "red", "green", "blue" });
    take_soup(file, soup);
    take_colors(file.vertices, soup.vertex_colors);
    take_colors(file.faces, soup.face_colors);
    const PLY_vertex_pairs edge_ends(file.edges, { "vertex1", "vertex2" }, { "v0", "v1" }, soup.points.size());
    const PLY_vertex_pairs halfedge_ends(file.halfedges, { "source", "target" }, {}, soup.points.size());
    soup_filling.fill(soup, soup.face_colors.is_wanted || !file.faces.columns().empty()
                              || !file.faces.lists().empty());

    const auto& vertices = soup_filling.vertices;
    const auto halfedge = [&](std::size_t u, std::size_t v) { // null if there is none
      return u == v ? mesh.null_halfedge() : mesh.halfedge(vertices[u], vertices[v]);
    };
    std::vector<typename Mesh::Edge_index> edges;
    edge_ends.for_each([&](std::size_t u, std::size_t v) {
      const auto h = halfedge(u, v);
      edges.push_back(h.is_valid() ? mesh.edge(h) : mesh.null_edge());
    });
    std::vector<typename Mesh::Halfedge_index> halfedges;
    halfedge_ends.for_each([&](std::size_t u, std::size_t v) { halfedges.push_back(halfedge(u, v)); });
    store_properties(filling, file.vertices, "v:", vertices);
    store_properties(filling, file.faces, "f:", soup_filling.faces);
    store_properties(filling, file.edges, "e:", edges);
    store_properties(filling, file.halfedges, "h:", halfedges);
    comments = file.comments;
    filling.finish();
    return true;
  }, verbose));
}

inline void print_PLY_header(std::ostream& os, const std::string& comments)
{
  const std::string own_comment = "Generated by the CGAL library";
  os << "ply\nformat " << (get_mode(os) == BINARY ? "binary_little_endian" : "ascii") << " 1.0\n"
     << "comment " << own_comment << '\n';
  std::istringstream lines(comments);
  for (std::string line; std::getline(lines, line);)
    if (line != own_comment) // which is there if the comments were read
      os << "comment " << line << '\n';
}

} // namespace internal

/*!
\ingroup PkgCompactSurfaceMeshIO

reads the mesh `mesh`, which must be empty, from a stream in the \ref IOStreamPLY, text or binary.

Normals (`nx`, `ny`, `nz`) become the property map `"v:normal"`, colors (`red`, `green`, `blue`, as bytes)
`"v:color"` and `"f:color"`. Each other property that is a number becomes a property map of the type
that it has in the file, whose name is that of the property with the prefix `v:`, `f:`, `e:` or `h:`. Edges
are named by the properties `vertex1` and `vertex2`, halfedges by `source` and `target`; those that the mesh
does not have are ignored. From \cgal 6 on, properties that are lists become property maps of vectors. So it is
with `Surface_mesh`.

\param is the input stream, opened with `std::ios::binary` for a binary file; its failbit is set on failure
\param mesh the mesh, which stays as it was on failure
\param comments receives the lines of comment in the header
\param verbose whether to print what is wrong

\returns whether it is read
*/
template <class P, class L>
bool read_PLY(std::istream& is, Compact_surface_mesh<P, L>& mesh, std::string& comments, bool verbose = true)
{
  return internal::read_PLY_with_properties(is, mesh, comments, verbose);
}

/// \ingroup PkgCompactSurfaceMeshIO
/// calls the function above.
template <class P, class L>
bool read_PLY(std::istream& is, Compact_surface_mesh<P, L>& mesh)
{
  std::string comments;
  return read_PLY(is, mesh, comments);
}

/*!
\ingroup PkgCompactSurfaceMeshIO

reads the mesh `mesh`, which must be empty, from a stream in the \ref IOStreamPLY, text or binary, and only
those attributes for which property maps are given, as is done with `Surface_mesh`.

\param is the input stream, opened with `std::ios::binary` for a binary file; its failbit is set on failure
\param mesh the mesh, which stays as it was on failure
\param np a sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`, `vertex_normal_map`,
  `vertex_color_map`, `face_color_map`, `verbose`

\returns whether it is read
*/
template <class P, class L, class CGAL_NP_TEMPLATE_PARAMETERS>
bool read_PLY(std::istream& is, Compact_surface_mesh<P, L>& mesh, const CGAL_NP_CLASS& np)
{
  return internal::read_mesh(is, mesh, np, [&](auto& soup) {
    internal::read_PLY_soup(is, soup);
    return true;
  });
}

/// \ingroup PkgCompactSurfaceMeshIO
/// reads the mesh `mesh`, which must be empty, from the file `fname`, as the function above does.
template <class P, class L, class CGAL_NP_TEMPLATE_PARAMETERS>
bool read_PLY(const std::string& fname, Compact_surface_mesh<P, L>& mesh,
              const CGAL_NP_CLASS& np = parameters::default_values())
{
  std::ifstream is(fname, std::ios::binary);
  return read_PLY(is, mesh, np);
}

/*!
\ingroup PkgCompactSurfaceMeshIO

writes the mesh `mesh` with all its property maps of a simple type to a stream in the \ref IOStreamPLY, binary if
this is the \link PkgStreamSupportEnumRef mode \endlink of the stream.

The property maps `"v:normal"`, `"v:color"` and `"f:color"`, or those that are given in place of them, become the
properties that PLY has for them. Other maps are written if their values are numbers, those of 64-bit integers as 32
bits, and from \cgal 6 on also if their values are vectors of numbers of at most 32 bits or `double`.

\param os the output stream, opened with `std::ios::binary` for a binary file
\param mesh the mesh
\param comments lines for the header
\param np a sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`, `vertex_normal_map`,
  `vertex_color_map`, `face_color_map`, `stream_precision`

\returns whether it is written
*/
template <class P, class L, class CGAL_NP_TEMPLATE_PARAMETERS>
bool write_PLY(std::ostream& os, const Compact_surface_mesh<P, L>& mesh, const std::string& comments,
               const CGAL_NP_CLASS& np = parameters::default_values())
{
  using Mesh = Compact_surface_mesh<P, L>;
  if (!os.good())
    return false;
  set_stream_precision_from_NP(os, np);
  const internal::PLY_property_writer<Mesh, typename Mesh::Vertex_index> vertices(mesh, "v:", np);
  const internal::PLY_property_writer<Mesh, typename Mesh::Face_index> faces(mesh, "f:", np);
  const internal::PLY_property_writer<Mesh, typename Mesh::Edge_index> edges(mesh, "e:", np);
  const internal::PLY_property_writer<Mesh, typename Mesh::Halfedge_index> halfedges(mesh, "h:", np);
  internal::print_PLY_header(os, comments);
  os << "element vertex " << mesh.number_of_vertices() << '\n';
  vertices.print_header(os);
  const bool has_large_faces = std::any_of(mesh.faces().begin(), mesh.faces().end(), [&](const auto& f) {
    return mesh.degree(f) > (std::numeric_limits<std::uint8_t>::max)();
  });
  os << "element face " << mesh.number_of_faces() << '\n'
     << "property list " << (has_large_faces ? "uint" : "uchar") << " int vertex_indices\n";
  faces.print_header(os);
  if (!edges.empty()) {
    os << "element edge " << mesh.number_of_edges() << "\nproperty int vertex1\nproperty int vertex2\n";
    edges.print_header(os);
  }
  if (!halfedges.empty()) {
    os << "element halfedge " << mesh.number_of_halfedges() << "\nproperty int source\nproperty int target\n";
    halfedges.print_header(os);
  }
  os << "end_header\n";

  const auto print_vertex = [&](typename Mesh::Vertex_index v) {
    internal::print_PLY_number(os, static_cast<std::int32_t>(v.idx()));
  };
  for (const auto v : mesh.vertices())
    vertices.print(os, v);
  for (const auto f : mesh.faces()) {
    internal::print_PLY_list_size(os, mesh.degree(f), has_large_faces);
    for (const auto v : vertices_around_face(mesh.halfedge(f), mesh))
      print_vertex(v);
    faces.print(os, f);
  }
  if (!edges.empty())
    for (const auto e : mesh.edges()) {
      print_vertex(mesh.vertex(e, 0));
      print_vertex(mesh.vertex(e, 1));
      edges.print(os, e);
    }
  if (!halfedges.empty())
    for (const auto h : mesh.halfedges()) {
      print_vertex(mesh.source(h));
      print_vertex(mesh.target(h));
      halfedges.print(os, h);
    }
  os.flush();
  return os.good();
}

/// \ingroup PkgCompactSurfaceMeshIO
/// writes the mesh `mesh` as the function above does, without comments.
template <class P, class L, class CGAL_NP_TEMPLATE_PARAMETERS>
bool write_PLY(std::ostream& os, const Compact_surface_mesh<P, L>& mesh,
               const CGAL_NP_CLASS& np = parameters::default_values())
{
  return write_PLY(os, mesh, std::string(), np);
}

/// \ingroup PkgCompactSurfaceMeshIO
/// writes the mesh `mesh` to the file `fname` as the function above does, binary unless the named parameter
/// `use_binary_mode` is `false`.
template <class P, class L, class CGAL_NP_TEMPLATE_PARAMETERS>
bool write_PLY(const std::string& fname, const Compact_surface_mesh<P, L>& mesh, const std::string& comments,
               const CGAL_NP_CLASS& np = parameters::default_values())
{
  const bool is_binary =
    parameters::choose_parameter(parameters::get_parameter(np, internal_np::use_binary_mode), true);
  std::ofstream os(fname, is_binary ? std::ios::out | std::ios::binary : std::ios::out);
  set_mode(os, is_binary ? BINARY : ASCII);
  return write_PLY(os, mesh, comments, np);
}

/// \ingroup PkgCompactSurfaceMeshIO
/// writes the mesh `mesh` to the file `fname` as the function above does, without comments.
template <class P, class L, class CGAL_NP_TEMPLATE_PARAMETERS>
bool write_PLY(const std::string& fname, const Compact_surface_mesh<P, L>& mesh,
               const CGAL_NP_CLASS& np = parameters::default_values())
{
  return write_PLY(fname, mesh, std::string(), np);
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_IO_PLY_H
