// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_SOT_LAYOUT_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_SOT_LAYOUT_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/Input_images.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Corner_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Sorted_corners.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgCompactSurfaceMeshRef

The class `SOT_layout` stores the connectivity of a mesh as a Sorted Opposite Table (T. Gurung, J.
Rossignac, <em>SOT: Compact representation for tetrahedral meshes</em>, 2009, for triangles): each vertex has
one of its triangles, vertices and triangles are sorted alike, and only the opposite of each
halfedge is stored, those along borders included. That is six references per vertex, 6n + 12g - 12 on a closed
surface of genus g, and a bit per halfedge with its rank directory for the numbering of edges.

No vertex is stored. `source()` and `target()` turn around the vertex until they meet its triangle, in
time linear in its degree, and so does all that asks for vertices: `halfedge(u, v)` takes time linear in the
smaller of the degrees of `u` and `v`, times that of their neighbors. Along borders, `next()` and `prev()` turn around
the vertex between, likewise. All other operators take constant time.

How vertices get their triangles is a matter of the construction: here those on borders get the triangle behind
the border halfedge, so that `halfedge_of_vertex()` costs no array either, and a search from there, depth first,
gives a triangle to each vertex that it meets.

Vertices keep the order of the input, but for those on borders, which come last, and isolated ones after them.

\tparam Index_ an unsigned integer type

\cgalModels{CompactSurfaceMeshLayout}
*/
template <class Index_ = std::uint32_t>
class SOT_layout
#ifndef DOXYGEN_RUNNING
  : public internal::Corner_layout<internal::Sorted_corners<Index_, false>>
#endif
{
  typedef internal::Corner_layout<internal::Sorted_corners<Index_, false>> Base;

public:
  /// the integer type of all indices.
  typedef Index_ Index;

  /// returns `"sot"`.
  static std::string name() { return "sot"; }
  /// returns the largest number of vertices of a sphere for which `Index` is wide enough.
  // as for a corner table
  static std::size_t max_vertices() { return std::size_t(Base::null_index()) / 6 + 1; }

  /// creates the layout of the empty mesh.
  SOT_layout() = default;

  /*!
  sorts the triangles of `t` in linear time.
  \param t the triangulation; it is empty afterwards
  \param images tells what becomes of the elements of the input
  */
  SOT_layout(Closed_triangulation<Index>&& t, Input_images<Index>& images)
    : Base(std::move(t), images)
  {}
};

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_SOT_LAYOUT_H
