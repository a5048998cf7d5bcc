// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// What CGAL's package Mesh_3 specializes for Surface_mesh by name. Its headers need not be included.

#ifndef CGAL_COMPACT_SURFACE_MESH_MESH_3_H
#define CGAL_COMPACT_SURFACE_MESH_MESH_3_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Compact_surface_mesh_fwd.h>

#include <CGAL/boost/graph/Graph_with_descriptor_with_graph_fwd.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#ifndef DOXYGEN_RUNNING

namespace CGAL {

template <class Polyhedron, class K>
class Triangle_accessor_3;

// The faces of a polyhedral domain and their triangles.
template <class P, class L, class K>
class Triangle_accessor_3<Graph_with_descriptor_with_graph<Compact_surface_mesh<P, L> >, K>
{
  using Graph = Graph_with_descriptor_with_graph<Compact_surface_mesh<P, L> >;

public:
  using Triangle_3 = typename K::Triangle_3;
  using Triangle_iterator = typename boost::graph_traits<Graph>::face_iterator;
  using Triangle_handle = Triangle_iterator;

  Triangle_iterator triangles_begin(const Graph& g) const { return faces(g).first; }
  Triangle_iterator triangles_end(const Graph& g) const { return faces(g).second; }

  Triangle_3 triangle(const Triangle_handle& handle) const
  {
    const auto f = *handle; // it knows the mesh
    const Compact_surface_mesh<P, L>& mesh = *f.graph;
    const auto h = mesh.halfedge(f.descriptor), g = mesh.next(h);
    return Triangle_3(mesh.point(mesh.target(h)), mesh.point(mesh.target(g)),
                      mesh.point(mesh.target(mesh.next(g))));
  }
};

} // namespace CGAL

#endif // DOXYGEN_RUNNING

#endif // CGAL_COMPACT_SURFACE_MESH_MESH_3_H
