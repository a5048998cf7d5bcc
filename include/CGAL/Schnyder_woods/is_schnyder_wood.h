// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_IS_SCHNYDER_WOOD_H
#define CGAL_SCHNYDER_WOODS_IS_SCHNYDER_WOOD_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Schnyder_woods/Schnyder_wood_rules.h>
#include <CGAL/Schnyder_woods/internal/Rooted_surface.h>
#include <CGAL/Schnyder_woods/internal/Schnyder_wood_checker.h>
#include <CGAL/Schnyder_woods/internal/mapped_wood.h>

#include <boost/graph/graph_traits.hpp>

#include <vector>

namespace CGAL {

/*!
\ingroup PkgSchnyderWoodsRef

returns whether `color`, `outgoing` and `is_special` are a g-Schnyder wood of `g`, as `g_schnyder_wood()` writes
it. The rules are:
- local ones: the two halfedges of each edge agree, unless it is special, and around all vertices the edges are in the
  order that is said at `g_schnyder_wood()`, sector by sector;
- those of the cut graph: there are \f$2g + r - 1\f$ special edges, where \f$r\f$ is the number of roots. The edges of
  color 2 and the root edges \f$V_0 V_2\f$ and \f$V_1 V_2\f$ are a forest that spans all vertices, and lead to the roots.
  With the special edges, they are a cut graph: its complement is one open disk;
- the cellular ones: the edges of color 0 and the root edges of \f$V_0\f$ are a connected graph that spans all vertices
  but the further roots, and part the surface into \f$2g + 2r - 1\f$ disks, special edges counted as two edges
  with a face between them; likewise the edges of color 1 and the root edges of \f$V_1\f$.

Values at the edges of the root face are ignored, but for `is_special`, which is false there.

Time almost linear in the size of the mesh (definition 3.1 and proposition 3.5 of the habilitation of
L. Castelli Aleardi, 2022; but \f$V_0\f$ and \f$V_1\f$ are allowed to have edges in of color 2 in sectors other than
the root sectors, without which some tori would have no g-Schnyder wood by the shelling of theorem 3.4).

\tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam HalfedgeColorMap a readable property map from halfedges to `int`
\tparam HalfedgeOutgoingMap a readable property map from halfedges to `bool`
\tparam EdgeIsSpecialMap a readable property map from edges to `bool`

\param g a connected closed surface, triangulated without double edges
\param root a halfedge from \f$V_1\f$ to \f$V_0\f$ along the root face
\param color,outgoing,is_special the wood
\param rules tells which rules are checked
\param further_roots the further roots

\throws Mesh_defect_exception,std::invalid_argument as `g_schnyder_wood()`
*/
template <class FaceGraph, class HalfedgeColorMap, class HalfedgeOutgoingMap, class EdgeIsSpecialMap>
bool is_g_schnyder_wood(
  const FaceGraph& g,
  typename boost::graph_traits<FaceGraph>::halfedge_descriptor root,
  HalfedgeColorMap color,
  HalfedgeOutgoingMap outgoing,
  EdgeIsSpecialMap is_special,
  Schnyder_wood_rules rules = Schnyder_wood_rules::CELLULAR,
  const std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor>& further_roots = {})
{
  const internal::Rooted_surface<FaceGraph> surface(g, root, further_roots);
  const internal::Schnyder_wood wood = internal::read_wood(g, surface, color, outgoing, is_special);
  return surface.is_empty() || surface.checker(wood)(rules);
}

/*!
\ingroup PkgSchnyderWoodsRef

returns whether `color` and `outgoing` are a Schnyder wood of `g`, as `schnyder_wood()` writes one:
whether the two halfedges of each edge agree, the rules around all vertices hold, and
the edges of each color form a tree that spans the vertices off the root face. Values at the
edges of the root face are ignored.

Time almost linear in the size of the mesh.

\tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam HalfedgeColorMap a readable property map from halfedges to `int`
\tparam HalfedgeOutgoingMap a readable property map from halfedges to `bool`

\param g a simple triangulation of the sphere
\param root a halfedge from \f$V_1\f$ to \f$V_0\f$ along the root face
\param color,outgoing the wood

\throws Mesh_defect_exception as `schnyder_wood()`
*/
template <class FaceGraph, class HalfedgeColorMap, class HalfedgeOutgoingMap>
bool is_schnyder_wood(const FaceGraph& g,
                      typename boost::graph_traits<FaceGraph>::halfedge_descriptor root,
                      HalfedgeColorMap color,
                      HalfedgeOutgoingMap outgoing)
{
  const internal::Rooted_surface<FaceGraph> sphere = internal::rooted_sphere(g, root);
  const internal::Schnyder_wood wood = internal::read_wood(g, sphere, color, outgoing);
  return sphere.is_empty() || sphere.checker(wood)(Schnyder_wood_rules::CELLULAR);
}

} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_IS_SCHNYDER_WOOD_H
