// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_CUT_GRAPH_H
#define CGAL_SCHNYDER_WOODS_CUT_GRAPH_H

// A cut graph of a surface is a graph of edges such that the surface, cut along it, is a disk.
// Borders count as cut. That a graph is one shows in its complement: the faces, glued
// together along the edges that are not cut, and at the vertices off graph and borders, are
// an open disk.

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Schnyder_woods/internal/Short_cut_graph.h>
#include <CGAL/Schnyder_woods/internal/Shortest_path_forest.h>
#include <CGAL/Schnyder_woods/internal/Surface_to_cut.h>
#include <CGAL/Schnyder_woods/internal/edge_weights.h>
#include <CGAL/Schnyder_woods/internal/prune_graph.h>
#include <CGAL/Schnyder_woods/parameters.h>

#include <CGAL/Compact_surface_mesh/internal/numbered_vertices.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Random.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgSchnyderWoodsRef

computes a short cut graph of each connected component of a mesh: edges such that the component
becomes a disk if it is cut along them. No edge of it can be spared: it has no
dangling ends.

Borders count as cut. So all borders of a component are tied together, and what is a
disk already gets no edge. A sphere gets none either; to cut it open, constrain two vertices
of it or more: the graph is then a tree that joins them.

For a base point, the graph consists of shortest paths to it, and to the borders and constrained
vertices, and of the edges that remain when the faces are glued together along a spanning tree of
the dual graph that prefers edges \f$uv\f$ of large \f$d(u) + d(v) + |uv|\f$, where \f$d\f$ is the distance
(J. Erickson and K. Whittlesey, <em>Greedy optimal homotopy and homology generators</em>, SODA 2005: the
loops of this graph are the shortest ones through its base point). What dangles is pruned. Some base
points are tried. Then the shortest graph is straightened: the same method, applied to all vertices
at which the graph branches in place of a base point, gives the shortest arcs between them that are
a cut graph; this is repeated as long as it helps, and after that base points on the graph are tried.
Of each component the shortest graph of all is kept. To find the shortest cut graph that exists is
NP-hard (J. Erickson and S. Har-Peled, <em>Optimally cutting a surface into a disk</em>, 2004).

Time O(k n log n) for k trials and a mesh of n edges. The result depends on the mesh, the
weights and the seed only.

\tparam FaceGraph a model of `FaceListGraph`, `EdgeListGraph` and `HalfedgeListGraph` with dynamic properties
\tparam EdgeIsCutMap a writable property map from edges to `bool`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param g a mesh of any genus, with faces of any degree, borders and several components
\param edge_is_cut gets whether an edge is in the cut graph; false for all border edges
\param np named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{edge_weight_map}
    \cgalParamDescription{what the edges weigh, see `parameters::edge_weight_map()`; has to come first}
    \cgalParamType{a readable property map from edges to a number type; nonnegative and finite}
    \cgalParamDefault{the lengths of the edges}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices; used only if `edge_weight_map` is not given}
    \cgalParamType{a readable property map from vertices to points of a kernel of \cgal}
    \cgalParamDefault{`get(vertex_point, g)`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_is_constrained_map}
    \cgalParamDescription{vertices that the cut graph has to go through, such as cones of a
                          parameterization; they are tied together as borders are, and the graph may
                          end at them}
    \cgalParamType{a readable property map from vertices to `bool`}
    \cgalParamDefault{no vertex}
    \cgalParamExtra{One such vertex of a sphere, or of a disk on its border, asks for no cut.}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{how many base points are tried, and how often the shortest graph is
                          then tried to be improved; borders and constrained vertices count as
                          the first base point}
    \cgalParamType{unsigned int; at least 1}
    \cgalParamDefault{8}
  \cgalParamNEnd
  \cgalParamNBegin{random_seed}
    \cgalParamDescription{the seed of the choice of base points}
    \cgalParamType{unsigned int}
    \cgalParamDefault{0}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns the weight of the cut graph

\throws std::invalid_argument if a weight is negative, or the sum of the weights is not finite;
nothing is then written.
\throws Mesh_defect_exception if `g` has \f$2^{32} - 1\f$ halfedges or more; nothing is then written.

\sa `cut_graph_loops()`, `CGAL::Seam_mesh`
*/
template <class FaceGraph, class EdgeIsCutMap, class NamedParameters = parameters::Default_named_parameters>
double cut_graph(const FaceGraph& g,
                 EdgeIsCutMap edge_is_cut,
                 const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  const auto surface = internal::surface_to_cut(g, np);
  internal::Short_cut_graph<FaceGraph> graph(surface);
  const auto num_bases = choose_parameter(get_parameter(np, internal_np::number_of_iterations), 8);
  CGAL::Random random(static_cast<unsigned int>(choose_parameter(get_parameter(np, internal_np::random_seed), 0)));
  graph(static_cast<std::size_t>((std::max<long long>)(num_bases, 1)), random);

  for (const auto e : edges(g))
    put(edge_is_cut, e, false);
  for (std::uint32_t e = 0; e < surface.edges().size(); ++e)
    if (graph.is_cut(e))
      put(edge_is_cut, surface.descriptor(e), true);
  return graph.weight();
}

/*!
\ingroup PkgSchnyderWoodsRef

computes the cut graph that comes with a g-Schnyder wood: the special edges, and their paths to
\f$V_2\f$ along edges of color 2 and the root edges \f$V_0 V_2\f$ and \f$V_1 V_2\f$, without what dangles
(L. Castelli Aleardi, habilitation, 2022, section 3.2).

Linear time; but on meshes of \cgal's data the graph is 1.3 to 3 times as long as that of `cut_graph()`
for a wood that was conquered in the order `Shelling_order::FIRST_IN_FIRST_OUT` or
`Shelling_order::RANDOM`, and 1.9 to 12 times for `Shelling_order::LAST_IN_FIRST_OUT`.

\tparam FaceGraph a model of `FaceListGraph` and `EdgeListGraph`
\tparam HalfedgeColorMap a readable property map from halfedges to `int`
\tparam EdgeIsSpecialMap a readable property map from edges to `bool`
\tparam EdgeIsCutMap a writable property map from edges to `bool`

\param g a connected closed triangle mesh
\param root a halfedge of the root face, from \f$V_1\f$ to \f$V_0\f$
\param color,is_special the wood, as `g_schnyder_wood()` writes it. It must be one whose edges of color 2
form a tree, such as the shelled one; extremal woods in general are not.
\param edge_is_cut gets whether an edge is in the cut graph
*/
template <class FaceGraph, class HalfedgeColorMap, class EdgeIsSpecialMap, class EdgeIsCutMap>
void cut_graph_of_schnyder_wood(const FaceGraph& g,
                                typename boost::graph_traits<FaceGraph>::halfedge_descriptor root,
                                HalfedgeColorMap color,
                                EdgeIsSpecialMap is_special,
                                EdgeIsCutMap edge_is_cut)
{
  typedef typename boost::graph_traits<FaceGraph>::edge_descriptor edge_descriptor;

  const auto number = internal::numbered_vertices(g);
  const std::array<edge_descriptor, 2> root_edges = { edge(next(root, g), g), edge(prev(root, g), g) };
  std::vector<std::array<std::size_t, 2>> ends;
  std::vector<char> is_cut;
  for (const edge_descriptor e : edges(g)) {
    ends.push_back({ get(number, source(e, g)), get(number, target(e, g)) });
    is_cut.push_back(get(is_special, e) || get(color, halfedge(e, g)) == 2 || e == root_edges[0]
                     || e == root_edges[1]);
  }
  internal::prune_graph(num_vertices(g), [&](std::size_t e) { return ends[e]; },
                        [](std::size_t) { return false; }, is_cut);
  std::size_t i = 0;
  for (const edge_descriptor e : edges(g))
    put(edge_is_cut, e, is_cut[i++] != 0);
}

} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_CUT_GRAPH_H
