// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_G_SCHNYDER_WOOD_H
#define CGAL_SCHNYDER_WOODS_G_SCHNYDER_WOOD_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Schnyder_woods/Shelling_order.h>
#include <CGAL/Schnyder_woods/internal/Rooted_surface.h>
#include <CGAL/Schnyder_woods/internal/Schnyder_wood.h>
#include <CGAL/Schnyder_woods/internal/mapped_wood.h>

#include <boost/graph/graph_traits.hpp>

#include <cstdint>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgSchnyderWoodsRef

computes a g-Schnyder wood of a triangulated closed surface of any genus \f$g\f$: a direction and a color of
every edge off the root face \f$(V_1, V_0, V_2)\f$, where few <em>special</em> edges have two of
each. A special edge stands for two edges with a face between them, its <em>special face</em>; each of
the two is a <em>copy</em> of the edge.

A <em>sector</em> of a vertex is what lies, counterclockwise, between two successive ones of its
special faces, its edge out of color 2 and the root face. A vertex off the root face that is no root has
one edge out of color 2, and in each of its sectors one finds, counterclockwise,

  edges in of color 1, one edge out of color 0, edges in of color 2, one edge out of color 1, edges in of color 0.

So vertices without special edges, that is, all but a few for each handle, look as in a Schnyder wood of the sphere. The edges
at \f$V_2\f$ and at further roots all come in, with color 2. The sectors of \f$V_0\f$ and \f$V_1\f$ have the same form, but
that the one next to the edge \f$V_0 V_1\f$ has edges in only, of color 0 at \f$V_0\f$ and of color 1 at \f$V_1\f$. With \f$r\f$
roots there are \f$2g + r - 1\f$ special edges. The edges of color 2 and the root edges \f$V_0 V_2\f$ and \f$V_1 V_2\f$ are a
forest that spans all vertices and leads to the roots; with the special edges, they are a cut graph,
whose complement is one open disk. `is_g_schnyder_wood()` says what else holds.

On the sphere this is `schnyder_wood()`.

The wood is found by conquering vertices, as on the sphere, and by opening an edge that does not separate
what is left to conquer where no vertex can be conquered (theorem 3.4 of the habilitation of
L. Castelli Aleardi, 2022; L. Castelli Aleardi, &Eacute;. Fusy, T. Lewiner, <em>Schnyder woods for higher genus triangulated
surfaces, with applications to encoding</em>, 2009). Which edges to open is found in a new way, in the time that it takes
to search all faces that are left, \f$k\f$ times: in the worst case once for each special edge, but 1 to 6 times
in all measurements. All in all, the time is \f$O(k (n + g) + d)\f$, where \f$d\f$ is the sum of the
squares of the degrees of the vertices at special edges. It is linear on the sphere.

The wood is written for halfedges: each gets the color of the copy that bounds its face, and whether that copy runs in its
direction. So both halfedges of an edge have the same color, and one of them is outgoing, unless the
edge is special. The copies of special edges have color 0 with the special face to
their right, or color 1 with the special face to their left.

\tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam HalfedgeColorMap a writable property map from halfedges to `int`
\tparam HalfedgeOutgoingMap a writable property map from halfedges to `bool`
\tparam EdgeIsSpecialMap a writable property map from edges to `bool`

\param g a connected closed surface, triangulated without double edges
\param root a halfedge of the root face, which runs from \f$V_1\f$ to \f$V_0\f$; \f$V_2\f$ is the third vertex of
the face
\param color gets the color, 0, 1 or 2, and -1 for the edges of the root face
\param outgoing gets whether the copy is directed from the source of the halfedge to its
target; false for the edges of the root face
\param is_special gets whether an edge is special
\param order in which order the corners that are free are conquered
\param seed of `Shelling_order::RANDOM`
\param further_roots vertices that are to have edges in of color 2 only, as \f$V_2\f$ has. No vertex may
be equal or adjacent to two of them and \f$V_2\f$.

\throws Mesh_defect_exception if `g` is not a connected closed triangle mesh, or has two edges with the same ends
\throws std::invalid_argument if a vertex is equal or adjacent to two roots. In both cases nothing is written.
*/
template <class FaceGraph, class HalfedgeColorMap, class HalfedgeOutgoingMap, class EdgeIsSpecialMap>
void g_schnyder_wood(
  const FaceGraph& g,
  typename boost::graph_traits<FaceGraph>::halfedge_descriptor root,
  HalfedgeColorMap color,
  HalfedgeOutgoingMap outgoing,
  EdgeIsSpecialMap is_special,
  Shelling_order order = Shelling_order::LAST_IN_FIRST_OUT,
  unsigned int seed = 0,
  const std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor>& further_roots = {})
{
  const internal::Rooted_surface<FaceGraph> surface(g, root, further_roots);
  if (surface.is_empty())
    return;
  const internal::Schnyder_wood wood = surface.shelled_wood(order, seed, [](std::uint32_t) {});
  internal::write_wood(g, surface, wood, color, outgoing, is_special);
}

} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_G_SCHNYDER_WOOD_H
