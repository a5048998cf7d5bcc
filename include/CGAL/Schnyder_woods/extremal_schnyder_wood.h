// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_EXTREMAL_SCHNYDER_WOOD_H
#define CGAL_SCHNYDER_WOODS_EXTREMAL_SCHNYDER_WOOD_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Schnyder_woods/Extremal_wood.h>
#include <CGAL/Schnyder_woods/internal/Extremal_wood_search.h>
#include <CGAL/Schnyder_woods/internal/Rooted_surface.h>
#include <CGAL/Schnyder_woods/internal/Schnyder_wood.h>
#include <CGAL/Schnyder_woods/internal/mapped_wood.h>

#include <boost/graph/graph_traits.hpp>

#include <cstdint>
#include <vector>

namespace CGAL {

namespace internal {

template <class FaceGraph>
void make_wood_extremal(const Rooted_surface<FaceGraph>& surface, Schnyder_wood& wood, Extremal_wood which,
                        bool keeps_cut_graph)
{
  Extremal_wood_search<std::uint32_t> search(surface.table, wood);
  search.fix_roots(surface.base, surface.further_roots);
  if (keeps_cut_graph)
    search.fix_cores();
  search(which);
}

} // namespace internal

/*!
\ingroup PkgSchnyderWoodsRef

turns a g-Schnyder wood into an extremal one: one without clockwise faces, or one without counterclockwise faces. No
set of faces that has no fixed face is bounded by edges in that direction either; fixed are the root face, its three
neighbors and the faces at further roots. The neighbors of the root face are exempt, unless on the sphere: when \f$V_0\f$ or
\f$V_1\f$ has special edges, they may be directed cycles, with the root edges in the directions \f$V_0 V_2\f$, \f$V_1 V_2\f$ and
\f$V_1 V_0\f$.

The local rules hold again, sector by sector (`Schnyder_wood_rules::LOCAL`), and the special edges are
the same. With special edges, those of color 2 need not be a forest any more. They still are one,
and with the special edges a cut graph (`Schnyder_wood_rules::CUT_GRAPH`), if `keeps_cut_graph` is set. Then faces are
exempt as well that have an edge on one of the paths of edges of color 2 from the special edges to the roots.
These paths are the same afterwards. The graphs of the colors 0 and 1 need not be cellular any more in either case.

Linear time. The edges are reversed across which the distance in the dual graph
from the fixed faces changes; crossing an edge takes 1 from left to right, 0 from right to left, or the other way
around. The colors follow from the distances. The manual has the proof.

\tparam FaceGraph a model of `FaceListGraph`
\tparam HalfedgeColorMap a readable and writable property map from halfedges to `int`
\tparam HalfedgeOutgoingMap a readable and writable property map from halfedges to `bool`
\tparam EdgeIsSpecialMap a readable property map from edges to `bool`

\param g a connected closed surface, triangulated without double edges
\param root a halfedge from \f$V_1\f$ to \f$V_0\f$ along the root face
\param color,outgoing,is_special the wood, as `g_schnyder_wood()` writes it
\param which tells which faces there are to be none of
\param keeps_cut_graph tells whether the forest and the cut graph of the wood are kept as such
\param further_roots the further roots of the wood

\pre `is_g_schnyder_wood(g, root, color, outgoing, is_special, rules, further_roots)`, where `rules` are
`Schnyder_wood_rules::CUT_GRAPH` with `keeps_cut_graph`, `Schnyder_wood_rules::LOCAL` without
\throws Mesh_defect_exception,std::invalid_argument as `g_schnyder_wood()`
*/
template <class FaceGraph, class HalfedgeColorMap, class HalfedgeOutgoingMap, class EdgeIsSpecialMap>
void make_schnyder_wood_extremal(
  const FaceGraph& g,
  typename boost::graph_traits<FaceGraph>::halfedge_descriptor root,
  HalfedgeColorMap color,
  HalfedgeOutgoingMap outgoing,
  EdgeIsSpecialMap is_special,
  Extremal_wood which,
  bool keeps_cut_graph = false,
  const std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor>& further_roots = {})
{
  const internal::Rooted_surface<FaceGraph> surface(g, root, further_roots);
  if (surface.is_empty())
    return;
  internal::Schnyder_wood wood = internal::read_wood(g, surface, color, outgoing, is_special);
  internal::make_wood_extremal(surface, wood, which, keeps_cut_graph);
  internal::write_wood(surface, wood, color, outgoing);
}

/*!
\ingroup PkgSchnyderWoodsRef

turns a Schnyder wood of a triangulated sphere into the one that has no clockwise, or no counterclockwise, directed
cycle. There is one of each for the root face, whatever wood is given.

Linear time (existence: P. Ossona de Mendez, 1994; S. Felsner, 2004).

\param g a triangulated sphere
\param root a halfedge from \f$V_1\f$ to \f$V_0\f$ along the root face
\param color,outgoing the wood, as `schnyder_wood()` writes it
\param which tells which cycles there are to be none of

\pre `is_schnyder_wood(g, root, color, outgoing)`
\throws Mesh_defect_exception as `schnyder_wood()`
*/
template <class FaceGraph, class HalfedgeColorMap, class HalfedgeOutgoingMap>
void make_schnyder_wood_extremal(const FaceGraph& g,
                                 typename boost::graph_traits<FaceGraph>::halfedge_descriptor root,
                                 HalfedgeColorMap color,
                                 HalfedgeOutgoingMap outgoing,
                                 Extremal_wood which)
{
  const internal::Rooted_surface<FaceGraph> sphere = internal::rooted_sphere(g, root);
  if (sphere.is_empty())
    return;
  internal::Schnyder_wood wood = internal::read_wood(g, sphere, color, outgoing);
  internal::make_wood_extremal(sphere, wood, which, false);
  internal::write_wood(sphere, wood, color, outgoing);
}

} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_EXTREMAL_SCHNYDER_WOOD_H
