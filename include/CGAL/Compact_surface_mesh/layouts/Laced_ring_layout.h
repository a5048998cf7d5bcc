// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_LACED_RING_LAYOUT_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_LACED_RING_LAYOUT_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/Input_images.h>
#include <CGAL/Compact_surface_mesh/layouts/Laced_ring_counts.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Corner_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Laced_ring.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Listed_triangle_numbering.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Ring_edges.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Ring_offsets.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Ring_references.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {

namespace internal {

template <class Index, class Entry>
struct Ring_of_entries
{
  typedef std::conditional_t<std::is_same<Index, Entry>::value, Ring_references<Index>, Ring_offsets<Index, Entry>>
      Entries;
  typedef Corner_layout<Laced_ring<Index, Entries>, Listed_triangle_numbering<Index>, Ring_edges<Index>> Layout;
};

} // namespace internal

/*!
\ingroup PkgCompactSurfaceMeshRef

The class `Laced_ring_layout` stores the connectivity of a mesh by a <em>laced ring</em>: T. Gurung, M. Luffel,
P. Lindstrom, J. Rossignac, <em>LR: Compact connectivity representation for triangle meshes</em>, 2011. Vertices are
numbered along a nearly Hamiltonian cycle of edges, the ring, so that two of the vertices of most triangles need not be
told. Two tables, L and R, hold the third vertices of the triangles to the left and right of each ring edge, about one
reference per triangle, and neighbors follow from the tables nearby.

A triangle without ring edge, \f$T_0\f$, takes six references, if it has no neighbor with two ring edges whose
redundant entry it can take (\f$T_0^w\f$); a triangle beside a \f$T_0\f$ (\f$T^i\f$) takes two more than other ones,
and a vertex on no ring (of which there are \f$m_i\f$, beside \f$m_r\f$ on rings) one. As the paper says in section
8, that makes

- \f$2 m_r + 6 n_0 + 3 n^i + m_i\f$ references, if `Entry` is `Index`;
- \f$2 m_r\f$ entries and \f$6 n_0 + 3 n^i + n^l + m_i\f$ references, if `Entry` is narrower. Entries are
  offsets then (section 6), and \f$n^l\f$ of them do not suffice, because they or that across the ring edge
  would be too long, or there is a \f$T^i\f$ there.

Regular meshes are cheap, and others, whose \f$T_0\f$ are many, are not: of uniform random triangulations, a quarter
of the triangles are \f$T_0\f$. What that makes of a mesh is told by `counts()`.

The layout takes every mesh: each component has a ring, but for one of a single triangle; handles do not matter; a
border costs an entry per edge on a ring, and a \f$T_0\f$ per other edge. Construction takes linear time; it
chooses the cheapest of several rings.

\tparam Index_ an unsigned integer type
\tparam Entry `Index_`, or a narrower unsigned integer type: that of the entries of the tables. 16 bits are what the
paper has beside an `Index_` of 32 bits.

\cgalModels{CompactSurfaceMeshLayout}
*/
template <class Index_ = std::uint32_t, class Entry = Index_>
class Laced_ring_layout
#ifndef DOXYGEN_RUNNING
  : public internal::Ring_of_entries<Index_, Entry>::Layout
#endif
{
  typedef typename internal::Ring_of_entries<Index_, Entry>::Entries Entries;
  typedef typename internal::Ring_of_entries<Index_, Entry>::Layout Base;

public:
  /// the integer type of all indices.
  typedef Index_ Index;

  /// returns `"laced-ring"`, or `"laced-ring-offsets"` if `Entry` is not `Index`.
  static std::string name() { return Entries::name(); }
  /// returns the largest number of vertices of a sphere for which `Index` and `Entry` are wide enough, whatever ring is
  /// found: about a ninth of the largest `Index`, and with entries of 16 bits no more than 22 million. Larger
  /// spheres are taken if their rings are good enough.
  static std::size_t max_vertices() { return Entries::max_vertices(); }

  /// creates the layout of the empty mesh.
  Laced_ring_layout() = default;

  /*!
  builds the layout of `t` in linear time.
  \param t the triangulation; it is empty afterwards
  \param images tells what becomes of the elements of the input
  \throws Mesh_defect_exception if `Index` or `Entry` is too narrow
  */
  Laced_ring_layout(Closed_triangulation<Index>&& t, Input_images<Index>& images)
    : Base(std::move(t), images)
  {}

  /// returns how many vertices and triangles of each kind there are, in linear time.
  Laced_ring_counts counts() const { return Base::table().counts(); }
};

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_LACED_RING_LAYOUT_H
