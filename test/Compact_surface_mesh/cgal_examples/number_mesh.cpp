// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Writes a mesh with the numbers that its vertices, halfedges, edges and faces have in a Compact_surface_mesh, for
// read_numbered_mesh.h:
//
//   number_mesh INPUT OUTPUT [--input-order]
//
//   --input-order   vertices and faces have the numbers of the input

#include "surface_mesh_in_input_order.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Compact_surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

template <class Mesh>
void write_numbered(std::ostream& out, const Mesh& mesh)
{
  out.precision(17);
  out << "numbered\n"
      << mesh.number_of_vertices() << ' ' << mesh.number_of_edges() << ' ' << mesh.number_of_faces() << '\n';
  for (const auto v : mesh.vertices())
    out << mesh.point(v) << ' ' << mesh.halfedge(v).idx() << '\n';
  for (const auto h : mesh.halfedges()) {
    if (mesh.opposite(h).idx() != (h.idx() ^ 1) || mesh.edge(h).idx() != h.idx() / 2)
      throw std::runtime_error("halfedges are not numbered as those of Surface_mesh");
    out << mesh.target(h).idx() << ' ' << mesh.next(h).idx() << ' ' << mesh.face(h).idx() << '\n';
  }
  for (const auto f : mesh.faces())
    out << mesh.halfedge(f).idx() << '\n';
}

template <class Mesh>
void renumber(const std::string& input, const std::string& output)
{
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(input, mesh) && !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(input, mesh))
    throw std::runtime_error(input + " is no mesh");
  std::ofstream out(output);
  write_numbered(out, mesh);
  if (!out)
    throw std::runtime_error("cannot write " + output);
}

int main(int argc, char* argv[])
{
  try {
    if (argc == 3)
      renumber<CGAL::Compact_surface_mesh<Point> >(argv[1], argv[2]);
    else if (argc == 4 && argv[3] == std::string("--input-order"))
      renumber<CGAL::Surface_mesh_in_input_order<Point> >(argv[1], argv[2]);
    else
      throw std::runtime_error("number_mesh INPUT OUTPUT [--input-order]");
  } catch (const std::exception& e) {
    std::cerr << "number_mesh: " << e.what() << std::endl;
    return EXIT_FAILURE;
  }
}
