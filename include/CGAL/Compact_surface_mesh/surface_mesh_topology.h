// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// What CGAL's package Surface_mesh_topology specializes for Surface_mesh by name. Its headers need not be included.

#ifndef CGAL_COMPACT_SURFACE_MESH_SURFACE_MESH_TOPOLOGY_H
#define CGAL_COMPACT_SURFACE_MESH_SURFACE_MESH_TOPOLOGY_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Compact_surface_mesh_fwd.h>

#include <CGAL/Kernel_traits.h>

#ifndef DOXYGEN_RUNNING

namespace CGAL {

template <class Mesh>
struct Get_traits;

// The kernel, and the point where a halfedge starts.
template <class P, class L>
struct Get_traits<Compact_surface_mesh<P, L> >
{
  using Mesh = Compact_surface_mesh<P, L>;
  using Kernel = typename Kernel_traits<P>::Kernel;
  using Point = typename Kernel::Point_3;
  using Vector = typename Kernel::Vector_3;

  template <class Halfedge>
  static const Point& get_point(const Mesh& mesh, Halfedge h) { return mesh.point(mesh.source(h)); }
};

namespace internal {

template <class Mesh> struct Index_from_halfedge_descriptor;
template <class Mesh> struct Halfedge_descriptor_from_index;
template <class Mesh> struct Is_index_used;

// For other graphs, these go through the halfedges.
template <class P, class L>
struct Index_from_halfedge_descriptor<Compact_surface_mesh<P, L> >
{
  using Mesh = Compact_surface_mesh<P, L>;
  using size_type = typename Mesh::size_type;
  using halfedge_descriptor = typename Mesh::Halfedge_index;

  static size_type run(const Mesh&, halfedge_descriptor h) { return h.idx(); }
};

template <class P, class L>
struct Halfedge_descriptor_from_index<Compact_surface_mesh<P, L> >
{
  using Mesh = Compact_surface_mesh<P, L>;
  using size_type = typename Mesh::size_type;
  using halfedge_descriptor = typename Mesh::Halfedge_index;

  static halfedge_descriptor run(const Mesh&, size_type i) { return halfedge_descriptor(i); }
};

template <class P, class L>
struct Is_index_used<Compact_surface_mesh<P, L> >
{
  using Mesh = Compact_surface_mesh<P, L>;
  using size_type = typename Mesh::size_type;

  static bool run(const Mesh& mesh, size_type i) { return i < mesh.number_of_halfedges(); }
};

} // namespace internal

} // namespace CGAL

#endif // DOXYGEN_RUNNING

#endif // CGAL_COMPACT_SURFACE_MESH_SURFACE_MESH_TOPOLOGY_H
