// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Makes Compact_surface_mesh a model of HalfedgeListGraph and FaceListGraph, and of the
// concepts of Boost.Graph on which these stand. There is no function of the mutable
// concepts, so that concept checks tell the truth.

#ifndef CGAL_BOOST_GRAPH_TRAITS_COMPACT_SURFACE_MESH_H
#define CGAL_BOOST_GRAPH_TRAITS_COMPACT_SURFACE_MESH_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Compact_surface_mesh.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/iterator_Compact_surface_mesh.h>

#include <boost/config.hpp>
#include <boost/graph/graph_traits.hpp>

#include <utility>

#ifndef DOXYGEN_RUNNING // what the documented concepts ask for

namespace boost {

template <class Point, class Layout>
struct graph_traits<CGAL::Compact_surface_mesh<Point, Layout> >
{
private:
  using Mesh = CGAL::Compact_surface_mesh<Point, Layout>;

public:
  using vertex_descriptor = typename Mesh::Vertex_index;
  using halfedge_descriptor = typename Mesh::Halfedge_index;
  using edge_descriptor = typename Mesh::Edge_index;
  using face_descriptor = typename Mesh::Face_index;

  using directed_category = typename Mesh::directed_category;
  using edge_parallel_category = typename Mesh::edge_parallel_category;
  using traversal_category = typename Mesh::traversal_category;

  using vertex_iterator = typename Mesh::Vertex_iterator;
  using halfedge_iterator = typename Mesh::Halfedge_iterator;
  using edge_iterator = typename Mesh::Edge_iterator;
  using face_iterator = typename Mesh::Face_iterator;

  using in_edge_iterator = CGAL::In_edge_iterator<Mesh>;
  using out_edge_iterator = CGAL::Out_edge_iterator<Mesh>;
  using adjacency_iterator = CGAL::Vertex_around_target_iterator<Mesh>;

  using vertices_size_type = typename Mesh::vertices_size_type;
  using halfedges_size_type = typename Mesh::halfedges_size_type;
  using edges_size_type = typename Mesh::edges_size_type;
  using faces_size_type = typename Mesh::faces_size_type;
  using degree_size_type = typename Mesh::degree_size_type;

  using vertex_property_type = typename Mesh::vertex_property_type;

  static vertex_descriptor null_vertex() { return vertex_descriptor(); }
  static halfedge_descriptor null_halfedge() { return halfedge_descriptor(); }
  static face_descriptor null_face() { return face_descriptor(); }
};

template <class Point, class Layout>
struct graph_traits<const CGAL::Compact_surface_mesh<Point, Layout> >
  : graph_traits<CGAL::Compact_surface_mesh<Point, Layout> >
{};

} // namespace boost

namespace CGAL {

/// \name HalfedgeGraph
/// @{

template <class P, class L>
BOOST_FORCEINLINE typename Compact_surface_mesh<P, L>::Vertex_index
source(typename Compact_surface_mesh<P, L>::Halfedge_index h, const Compact_surface_mesh<P, L>& g)
{
  return g.source(h);
}

template <class P, class L>
BOOST_FORCEINLINE typename Compact_surface_mesh<P, L>::Vertex_index
source(typename Compact_surface_mesh<P, L>::Edge_index e, const Compact_surface_mesh<P, L>& g)
{
  return g.source(g.halfedge(e));
}

template <class P, class L>
BOOST_FORCEINLINE typename Compact_surface_mesh<P, L>::Vertex_index
target(typename Compact_surface_mesh<P, L>::Halfedge_index h, const Compact_surface_mesh<P, L>& g)
{
  return g.target(h);
}

template <class P, class L>
BOOST_FORCEINLINE typename Compact_surface_mesh<P, L>::Vertex_index
target(typename Compact_surface_mesh<P, L>::Edge_index e, const Compact_surface_mesh<P, L>& g)
{
  return g.target(g.halfedge(e));
}

template <class P, class L>
BOOST_FORCEINLINE typename Compact_surface_mesh<P, L>::Halfedge_index
next(typename Compact_surface_mesh<P, L>::Halfedge_index h, const Compact_surface_mesh<P, L>& g)
{
  return g.next(h);
}

template <class P, class L>
BOOST_FORCEINLINE typename Compact_surface_mesh<P, L>::Halfedge_index
prev(typename Compact_surface_mesh<P, L>::Halfedge_index h, const Compact_surface_mesh<P, L>& g)
{
  return g.prev(h);
}

template <class P, class L>
BOOST_FORCEINLINE typename Compact_surface_mesh<P, L>::Halfedge_index
opposite(typename Compact_surface_mesh<P, L>::Halfedge_index h, const Compact_surface_mesh<P, L>& g)
{
  return g.opposite(h);
}

template <class P, class L>
BOOST_FORCEINLINE typename Compact_surface_mesh<P, L>::Edge_index
edge(typename Compact_surface_mesh<P, L>::Halfedge_index h, const Compact_surface_mesh<P, L>& g)
{
  return g.edge(h);
}

template <class P, class L>
std::pair<typename Compact_surface_mesh<P, L>::Edge_index, bool>
edge(typename Compact_surface_mesh<P, L>::Vertex_index u, typename Compact_surface_mesh<P, L>::Vertex_index v,
     const Compact_surface_mesh<P, L>& g)
{
  using Edge_index = typename Compact_surface_mesh<P, L>::Edge_index;
  const auto h = g.halfedge(u, v);
  return h.is_valid() ? std::make_pair(g.edge(h), true) : std::make_pair(Edge_index(), false);
}

template <class P, class L>
BOOST_FORCEINLINE typename Compact_surface_mesh<P, L>::Halfedge_index
halfedge(typename Compact_surface_mesh<P, L>::Edge_index e, const Compact_surface_mesh<P, L>& g)
{
  return g.halfedge(e);
}

template <class P, class L>
BOOST_FORCEINLINE typename Compact_surface_mesh<P, L>::Halfedge_index
halfedge(typename Compact_surface_mesh<P, L>::Vertex_index v, const Compact_surface_mesh<P, L>& g)
{
  return g.halfedge(v);
}

template <class P, class L>
std::pair<typename Compact_surface_mesh<P, L>::Halfedge_index, bool>
halfedge(typename Compact_surface_mesh<P, L>::Vertex_index u, typename Compact_surface_mesh<P, L>::Vertex_index v,
         const Compact_surface_mesh<P, L>& g)
{
  const auto h = g.halfedge(u, v);
  return std::make_pair(h, h.is_valid());
}

/// @}

/// \name FaceGraph
/// @{

template <class P, class L>
BOOST_FORCEINLINE typename Compact_surface_mesh<P, L>::Face_index
face(typename Compact_surface_mesh<P, L>::Halfedge_index h, const Compact_surface_mesh<P, L>& g)
{
  return g.face(h);
}

template <class P, class L>
BOOST_FORCEINLINE typename Compact_surface_mesh<P, L>::Halfedge_index
halfedge(typename Compact_surface_mesh<P, L>::Face_index f, const Compact_surface_mesh<P, L>& g)
{
  return g.halfedge(f);
}

/// @}

/// \name Degrees
/// @{

template <class P, class L>
typename Compact_surface_mesh<P, L>::size_type
degree(typename Compact_surface_mesh<P, L>::Vertex_index v, const Compact_surface_mesh<P, L>& g)
{
  return g.degree(v);
}

template <class P, class L>
typename Compact_surface_mesh<P, L>::size_type
degree(typename Compact_surface_mesh<P, L>::Face_index f, const Compact_surface_mesh<P, L>& g)
{
  return g.degree(f);
}

template <class P, class L>
typename Compact_surface_mesh<P, L>::size_type
out_degree(typename Compact_surface_mesh<P, L>::Vertex_index v, const Compact_surface_mesh<P, L>& g)
{
  return g.degree(v);
}

template <class P, class L>
typename Compact_surface_mesh<P, L>::size_type
in_degree(typename Compact_surface_mesh<P, L>::Vertex_index v, const Compact_surface_mesh<P, L>& g)
{
  return g.degree(v);
}

/// @}

/// \name VertexListGraph, HalfedgeListGraph, EdgeListGraph and FaceListGraph
/// @{

template <class P, class L>
typename Compact_surface_mesh<P, L>::size_type num_vertices(const Compact_surface_mesh<P, L>& g)
{
  return g.num_vertices();
}

template <class P, class L>
typename Compact_surface_mesh<P, L>::size_type num_halfedges(const Compact_surface_mesh<P, L>& g)
{
  return g.num_halfedges();
}

template <class P, class L>
typename Compact_surface_mesh<P, L>::size_type num_edges(const Compact_surface_mesh<P, L>& g)
{
  return g.num_edges();
}

template <class P, class L>
typename Compact_surface_mesh<P, L>::size_type num_faces(const Compact_surface_mesh<P, L>& g)
{
  return g.num_faces();
}

template <class P, class L>
typename Compact_surface_mesh<P, L>::Vertex_range vertices(const Compact_surface_mesh<P, L>& g)
{
  return g.vertices();
}

template <class P, class L>
typename Compact_surface_mesh<P, L>::Halfedge_range halfedges(const Compact_surface_mesh<P, L>& g)
{
  return g.halfedges();
}

template <class P, class L>
typename Compact_surface_mesh<P, L>::Edge_range edges(const Compact_surface_mesh<P, L>& g)
{
  return g.edges();
}

template <class P, class L>
typename Compact_surface_mesh<P, L>::Face_range faces(const Compact_surface_mesh<P, L>& g)
{
  return g.faces();
}

/// @}

/// \name IncidenceGraph, BidirectionalGraph and AdjacencyGraph
/// All three ranges go clockwise around `v` and start at the same neighbor.
/// @{

template <class P, class L>
BOOST_FORCEINLINE Iterator_range<Out_edge_iterator<Compact_surface_mesh<P, L> > >
out_edges(typename Compact_surface_mesh<P, L>::Vertex_index v, const Compact_surface_mesh<P, L>& g)
{
  using Iterator = Out_edge_iterator<Compact_surface_mesh<P, L> >;
  const auto h = g.halfedge(v);
  return CGAL::make_range(Iterator(h, g), Iterator(h, g, 1));
}

template <class P, class L>
BOOST_FORCEINLINE Iterator_range<In_edge_iterator<Compact_surface_mesh<P, L> > >
in_edges(typename Compact_surface_mesh<P, L>::Vertex_index v, const Compact_surface_mesh<P, L>& g)
{
  using Iterator = In_edge_iterator<Compact_surface_mesh<P, L> >;
  const auto h = g.halfedge(v);
  return CGAL::make_range(Iterator(h, g), Iterator(h, g, 1));
}

template <class P, class L>
BOOST_FORCEINLINE Iterator_range<Vertex_around_target_iterator<Compact_surface_mesh<P, L> > >
adjacent_vertices(typename Compact_surface_mesh<P, L>::Vertex_index v, const Compact_surface_mesh<P, L>& g)
{
  return g.vertices_around_target(g.halfedge(v));
}

/// @}

/// \name Validity
/// As for Surface_mesh in CGAL 6, descriptors of no element are told before anything is asked of them.
/// @{

template <class P, class L>
bool is_valid_vertex_descriptor(typename Compact_surface_mesh<P, L>::Vertex_index v,
                                const Compact_surface_mesh<P, L>& g, bool verbose = false)
{
  return g.is_valid(v, verbose);
}

template <class P, class L>
bool is_valid_halfedge_descriptor(typename Compact_surface_mesh<P, L>::Halfedge_index h,
                                  const Compact_surface_mesh<P, L>& g, bool verbose = false)
{
  return g.is_valid(h, verbose);
}

template <class P, class L>
bool is_valid_edge_descriptor(typename Compact_surface_mesh<P, L>::Edge_index e,
                              const Compact_surface_mesh<P, L>& g, bool verbose = false)
{
  return g.is_valid(e, verbose);
}

template <class P, class L>
bool is_valid_face_descriptor(typename Compact_surface_mesh<P, L>::Face_index f,
                              const Compact_surface_mesh<P, L>& g, bool verbose = false)
{
  return g.is_valid(f, verbose);
}

/// @}

/// does nothing: there is no order of edges to normalize.
template <class P, class L>
void normalize_border(const Compact_surface_mesh<P, L>&)
{}

/// makes `g` empty and keeps its property maps.
template <class P, class L>
void remove_all_elements(Compact_surface_mesh<P, L>& g)
{
  g.clear_without_removing_property_maps();
}

} // namespace CGAL

#endif // DOXYGEN_RUNNING

#endif // CGAL_BOOST_GRAPH_TRAITS_COMPACT_SURFACE_MESH_H
