// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_SQUAD_LAYOUT_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_SQUAD_LAYOUT_H

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

The class `SQuad_layout` stores the connectivity of a mesh as T. Gurung, D. Laney, P. Lindstrom and J.
Rossignac do in <em>SQuad: Compact representation for triangle meshes</em> (2011): it is an `SOT_layout` in which
as many vertices as possible have a quad, two triangles beside each other at the vertex. Only the opposites of
the four sides of the quad are stored. That is a reference per halfedge, as there, and two less for each vertex that
has one: 4.14 references per vertex on random triangulations, 4.05 to 4.1 on real meshes, 4.2 where they have many
handles, and less than 4 where they have many borders, since a vertex there has a quad of one face and the border.

The quads are not found as in the paper, but by random walks of the triangles that have no vertex, each of which
ends at a vertex that has one triangle and so gets a quad. Walks are bounded, so the time is linear: it takes
about ten steps a vertex. The outcome is always the same.

`source()` and `target()` turn around the vertex until they meet its quad, in time linear in its degree, and so
does all that asks for vertices, and for what is next on a border, as with `SOT_layout`. All other operators take
constant time.

Vertices are sorted by what they have: quads, triangles, quads on borders, triangles on borders, and none if they are
isolated. In each part they keep the order of the input.

\tparam Index_ an unsigned integer type

\cgalModels{CompactSurfaceMeshLayout}
*/
template <class Index_ = std::uint32_t>
class SQuad_layout
#ifndef DOXYGEN_RUNNING
  : public internal::Corner_layout<internal::Sorted_corners<Index_, true>>
#endif
{
  typedef internal::Corner_layout<internal::Sorted_corners<Index_, true>> Base;

public:
  /// the integer type of all indices.
  typedef Index_ Index;

  /// returns `"squad"`.
  static std::string name() { return "squad"; }
  /// returns the largest number of vertices of a sphere for which `Index` is wide enough.
  // as for a corner table
  static std::size_t max_vertices() { return std::size_t(Base::null_index()) / 6 + 1; }

  /// creates the layout of the empty mesh.
  SQuad_layout() = default;

  /*!
  sorts the triangles of `t` in linear time. The search for quads takes most of it.
  \param t the triangulation; it is empty afterwards
  \param images tells what becomes of the elements of the input
  */
  SQuad_layout(Closed_triangulation<Index>&& t, Input_images<Index>& images)
    : Base(std::move(t), images)
  {}
};

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_SQUAD_LAYOUT_H
