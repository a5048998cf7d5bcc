// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// What a program written for Surface_mesh may call that edits connectivity. Each line that is marked must not compile,
// and must say what to do; see compile.cmake. Two calls with arguments of the same types would be refused as one.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Compact_surface_mesh/Compact_surface_mesh.h>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Compact_surface_mesh<Point>;

template <int>
struct Other {};

int main()
{
  Mesh mesh;
  const Mesh::Vertex_index v(0);
  const Mesh::Halfedge_index h(0);
  const Mesh::Edge_index e(0);
  const Mesh::Face_index f(0);
  mesh.reserve(1, 3, 1);
  mesh.collect_garbage();
#ifdef EDIT
  mesh.add_vertex();                                        // refused
  mesh.add_vertex(Point(0, 0, 0));                          // refused
  mesh.add_edge();                                          // refused
  mesh.add_edge(v, v);                                      // refused
  mesh.add_face();                                          // refused
  mesh.add_face(v, v, v);                                   // refused
  mesh.add_face(v, v, v, v);                                // refused
  mesh.remove_vertex(v);                                    // refused
  mesh.remove_edge(e);                                      // refused
  mesh.remove_face(f);                                      // refused
  mesh.set_target(h, v);                                    // refused
  mesh.set_face(h, f);                                      // refused
  mesh.set_next(h, h);                                      // refused
  mesh.set_next_only(h, Other<0>());                        // refused
  mesh.set_prev_only(h, Other<1>());                        // refused
  mesh.set_halfedge(v, h);                                  // refused
  mesh.set_halfedge(f, h);                                  // refused
  mesh.set_vertex_halfedge_to_border_halfedge(h);           // refused
  mesh.resize(1, 3, 1);                                     // refused
  mesh.join(Mesh());                                        // refused
  mesh += Other<2>();                                       // refused
#endif
  return v.is_valid() && h.is_valid() && e.is_valid() && f.is_valid() ? 0 : 1;
}
