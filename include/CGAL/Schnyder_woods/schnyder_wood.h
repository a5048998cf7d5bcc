// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_SCHNYDER_WOOD_H
#define CGAL_SCHNYDER_WOODS_SCHNYDER_WOOD_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Schnyder_woods/Shelling_order.h>
#include <CGAL/Schnyder_woods/internal/Rooted_surface.h>
#include <CGAL/Schnyder_woods/internal/Schnyder_wood.h>
#include <CGAL/Schnyder_woods/internal/mapped_wood.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgSchnyderWoodsRef

computes a Schnyder wood of a triangulated sphere: a direction and a color of every
edge off the root face, such that around each vertex off the root face one finds,
counterclockwise,

  one edge out of color 0, edges in of color 2, one edge out of color 1, edges in of
  color 0, one edge out of color 2, edges in of color 1,

and the edges at the three vertices \f$V_0\f$, \f$V_1\f$, \f$V_2\f$ of the root face all come in, with the
colors 0, 1, 2. The edges of each color form a tree that spans all vertices off the root
face and is rooted at \f$V_i\f$.

Linear time, by conquering vertices (W. Schnyder, SODA 1990; E. Brehm, 2000; definition 1 and
appendix A of L. Castelli Aleardi and O. Devillers, <em>Array-based compact data structures for
triangulations</em>, JoCG 2018).

The wood is written for halfedges: both halfedges of an edge get its color, and one of
them runs in its direction.

\tparam FaceGraph a model of `FaceListGraph`
\tparam HalfedgeColorMap a writable property map from halfedges to `int`
\tparam HalfedgeOutgoingMap a writable property map from halfedges to `bool`

\param g a triangulated sphere
\param root a halfedge of the root face, which runs from \f$V_1\f$ to \f$V_0\f$; \f$V_2\f$ is the third vertex of
the face
\param color gets the color, 0, 1 or 2, and -1 for the edges of the root face
\param outgoing gets whether the edge is directed from the source of the halfedge to its
target; false for the edges of the root face
\param order in which order the vertices that are free are conquered
\param seed of `Shelling_order::RANDOM`

\throws Mesh_defect_exception if `g` is not a connected closed triangle mesh of genus 0, or has
two edges with the same ends; nothing is then written.
*/
template <class FaceGraph, class HalfedgeColorMap, class HalfedgeOutgoingMap>
void schnyder_wood(const FaceGraph& g,
                   typename boost::graph_traits<FaceGraph>::halfedge_descriptor root,
                   HalfedgeColorMap color,
                   HalfedgeOutgoingMap outgoing,
                   Shelling_order order = Shelling_order::LAST_IN_FIRST_OUT,
                   unsigned int seed = 0)
{
  const internal::Rooted_surface<FaceGraph> sphere = internal::rooted_sphere(g, root);
  if (sphere.is_empty())
    return;
  const internal::Schnyder_wood wood = sphere.shelled_wood(order, seed, [](std::uint32_t) {});
  internal::write_wood(sphere, wood, color, outgoing);
}

/*!
\ingroup PkgSchnyderWoodsRef

computes a Schnyder wood with the first face of `g` as root face.

\returns the root halfedge, from \f$V_1\f$ to \f$V_0\f$
*/
template <class FaceGraph, class HalfedgeColorMap, class HalfedgeOutgoingMap>
typename boost::graph_traits<FaceGraph>::halfedge_descriptor
schnyder_wood(const FaceGraph& g, HalfedgeColorMap color, HalfedgeOutgoingMap outgoing)
{
  const auto root = internal::default_root(g);
  schnyder_wood(g, root, color, outgoing);
  return root;
}

/*!
\ingroup PkgSchnyderWoodsRef

computes a canonical ordering \f$v_1, \dots, v_n\f$ of a triangulated sphere: \f$v_1 = V_0\f$, \f$v_2 = V_1\f$ and \f$v_n =
V_2\f$ are the vertices of the root face; for \f$k \geq 3\f$ the first \f$k\f$ vertices induce a triangulated
disk, and \f$v_k\f$ lies on its boundary with neighbors among the first \f$k-1\f$ that are consecutive on
the boundary of the disk before.

Linear time: it is the order in which `schnyder_wood()` conquers vertices, reversed (H. de
Fraysseix, J. Pach, R. Pollack, 1990; section 2.2 of the habilitation of L. Castelli Aleardi, 2022).

\tparam FaceGraph a model of `FaceListGraph`
\param g a triangulated sphere
\param root a halfedge from \f$V_1\f$ to \f$V_0\f$ along the root face
\param out gets the vertices
\param order,seed as for `schnyder_wood()`
\returns `out` behind the last vertex
\throws Mesh_defect_exception as `schnyder_wood()`
*/
template <class FaceGraph, class OutputIterator>
OutputIterator canonical_ordering(const FaceGraph& g,
                                  typename boost::graph_traits<FaceGraph>::halfedge_descriptor root,
                                  OutputIterator out,
                                  Shelling_order order = Shelling_order::LAST_IN_FIRST_OUT,
                                  unsigned int seed = 0)
{
  typedef typename boost::graph_traits<FaceGraph>::vertex_descriptor vertex_descriptor;

  const internal::Rooted_surface<FaceGraph> sphere = internal::rooted_sphere(g, root);
  if (sphere.is_empty())
    return out;
  std::vector<vertex_descriptor> vertex_of_index(vertices(g).begin(), vertices(g).end());
  std::vector<vertex_descriptor> conquered;
  conquered.reserve(vertex_of_index.size());
  sphere.shelled_wood(order, seed, [&](std::uint32_t v) { conquered.push_back(vertex_of_index[v]); });
  *out++ = target(root, g);
  *out++ = source(root, g);
  return std::copy(conquered.rbegin(), conquered.rend(), out);
}

} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_SCHNYDER_WOOD_H
