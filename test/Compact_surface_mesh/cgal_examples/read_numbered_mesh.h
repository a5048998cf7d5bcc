// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef READ_NUMBERED_MESH_H
#define READ_NUMBERED_MESH_H

#include <CGAL/Surface_mesh.h>

#include <cstdint>
#include <fstream>
#include <iostream>
#include <string>

namespace CGAL {

// Reads what number_mesh writes: a Surface_mesh whose vertices, halfedges, edges and faces have the numbers that they
// have in a Compact_surface_mesh.
template <class Point>
bool read_numbered_mesh(std::istream& in, Surface_mesh<Point>& mesh)
{
  using Mesh = Surface_mesh<Point>;
  using Vertex = typename Mesh::Vertex_index;
  using Halfedge = typename Mesh::Halfedge_index;
  using Face = typename Mesh::Face_index;
  std::string word;
  std::uint32_t num_vertices, num_edges, num_faces;
  if (!(in >> word >> num_vertices >> num_edges >> num_faces) || word != "numbered" || !mesh.is_empty())
    return false;

  for (std::uint32_t e = 0; e < num_edges; ++e)
    mesh.add_edge();
  for (std::uint32_t f = 0; f < num_faces; ++f)
    mesh.add_face();
  double x, y, z;
  std::uint32_t target, next, face, halfedge;
  for (std::uint32_t v = 0; v < num_vertices && in >> x >> y >> z >> halfedge; ++v)
    mesh.set_halfedge(mesh.add_vertex(Point(x, y, z)), Halfedge(halfedge));
  for (std::uint32_t h = 0; h < 2 * num_edges && in >> target >> next >> face; ++h) {
    mesh.set_target(Halfedge(h), Vertex(target));
    mesh.set_next(Halfedge(h), Halfedge(next));
    mesh.set_face(Halfedge(h), Face(face));
  }
  for (std::uint32_t f = 0; f < num_faces && in >> halfedge; ++f)
    mesh.set_halfedge(Face(f), Halfedge(halfedge));
  return in && mesh.is_valid(false);
}

namespace IO {

template <class Point>
bool read_numbered_mesh(const std::string& file, Surface_mesh<Point>& mesh)
{
  std::ifstream in(file);
  return CGAL::read_numbered_mesh(in, mesh);
}

} // namespace IO

namespace Polygon_mesh_processing {
namespace IO {

using CGAL::IO::read_numbered_mesh;

} // namespace IO
} // namespace Polygon_mesh_processing

} // namespace CGAL

#endif // READ_NUMBERED_MESH_H
