// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_ELEMENT_RANGES_H
#define CGAL_COMPACT_SURFACE_MESH_ELEMENT_RANGES_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Descriptor_iterator.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/iterator.h>

#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgCompactSurfaceMeshRef

The class `Element_ranges` is the part of a `Compact_surface_mesh` that goes through its
elements: through all of a kind, and around a vertex or a face. It has no data.

Ranges are made in constant time, and a step takes the time of one or two operators of the
mesh. Those around a vertex or a face refer to the mesh, which must outlive them and keep
its connectivity.

\tparam Mesh the mesh, which derives from this class
\tparam Vertex_index_, Halfedge_index_, Edge_index_, Face_index_ the descriptors

\sa \ref Compact_surface_mesh_descriptors::Descriptor_iterator "Descriptor_iterator"
*/
template <class Mesh, class Vertex_index_, class Halfedge_index_, class Edge_index_, class Face_index_>
class Element_ranges
{
  template <class D> using Iterator_over = Compact_surface_mesh_descriptors::Descriptor_iterator<D>;

public:
  /// \name All Elements
  /// Random access iterators over the elements of one kind, in the order of their indices,
  /// and the ranges of these.
  /// @{

  /// the iterator over all vertices.
  using Vertex_iterator = Iterator_over<Vertex_index_>;
  /// the iterator over all halfedges.
  using Halfedge_iterator = Iterator_over<Halfedge_index_>;
  /// the iterator over all edges.
  using Edge_iterator = Iterator_over<Edge_index_>;
  /// the iterator over all faces.
  using Face_iterator = Iterator_over<Face_index_>;

  /// the range of all vertices.
  using Vertex_range = Iterator_range<Vertex_iterator>;
  /// the range of all halfedges.
  using Halfedge_range = Iterator_range<Halfedge_iterator>;
  /// the range of all edges.
  using Edge_range = Iterator_range<Edge_iterator>;
  /// the range of all faces.
  using Face_range = Iterator_range<Face_iterator>;

#ifndef DOXYGEN_RUNNING
  // the second names that Surface_mesh has for them
  using vertex_iterator = Vertex_iterator;
  using halfedge_iterator = Halfedge_iterator;
  using edge_iterator = Edge_iterator;
  using face_iterator = Face_iterator;
#endif

  /// returns the vertices.
  Vertex_range vertices() const { return first<Vertex_index_>(mesh().number_of_vertices()); }
  /// returns the halfedges.
  Halfedge_range halfedges() const { return first<Halfedge_index_>(mesh().number_of_halfedges()); }
  /// returns the edges.
  Edge_range edges() const { return first<Edge_index_>(mesh().number_of_edges()); }
  /// returns the faces.
  Face_range faces() const { return first<Face_index_>(mesh().number_of_faces()); }

  /// returns the iterator to the vertex with index 0.
  Vertex_iterator vertices_begin() const { return vertices().begin(); }
  /// returns the iterator behind the last vertex.
  Vertex_iterator vertices_end() const { return vertices().end(); }
  /// returns the iterator to the halfedge with index 0.
  Halfedge_iterator halfedges_begin() const { return halfedges().begin(); }
  /// returns the iterator behind the last halfedge.
  Halfedge_iterator halfedges_end() const { return halfedges().end(); }
  /// returns the iterator to the edge with index 0.
  Edge_iterator edges_begin() const { return edges().begin(); }
  /// returns the iterator behind the last edge.
  Edge_iterator edges_end() const { return edges().end(); }
  /// returns the iterator to the face with index 0.
  Face_iterator faces_begin() const { return faces().begin(); }
  /// returns the iterator behind the last face.
  Face_iterator faces_end() const { return faces().end(); }
  /// @}

  /// \name Around a Vertex
  /// clockwise. A vertex is named by a halfedge that ends there, at which the range starts.
  /// @{

  /// the bidirectional iterator over the neighbors of a vertex.
  using Vertex_around_target_iterator = CGAL::Vertex_around_target_iterator<Mesh>;
  /// the bidirectional iterator over the halfedges that end at a vertex.
  using Halfedge_around_target_iterator = CGAL::Halfedge_around_target_iterator<Mesh>;
  /// the bidirectional iterator over the faces at a vertex.
  using Face_around_target_iterator = CGAL::Face_around_target_iterator<Mesh>;

  /// the range of the neighbors of a vertex.
  using Vertex_around_target_range = Iterator_range<Vertex_around_target_iterator>;
  /// the range of the halfedges that end at a vertex.
  using Halfedge_around_target_range = Iterator_range<Halfedge_around_target_iterator>;
  /// the range of the faces at a vertex.
  using Face_around_target_range = Iterator_range<Face_around_target_iterator>;

  /// the circulator over the neighbors of a vertex.
  using Vertex_around_target_circulator = CGAL::Vertex_around_target_circulator<Mesh>;
  /// the circulator over the halfedges that end at a vertex.
  using Halfedge_around_target_circulator = CGAL::Halfedge_around_target_circulator<Mesh>;
  /// the circulator over the halfedges that start at a vertex.
  using Halfedge_around_source_circulator = CGAL::Halfedge_around_source_circulator<Mesh>;
  /// the circulator over the faces at a vertex.
  using Face_around_target_circulator = CGAL::Face_around_target_circulator<Mesh>;

  /// returns the neighbors of `target(h)`, from `source(h)` on.
  Vertex_around_target_range vertices_around_target(Halfedge_index_ h) const
  {
    return CGAL::vertices_around_target(h, mesh());
  }
  /// returns the halfedges with the target of `h`, from `h` on.
  Halfedge_around_target_range halfedges_around_target(Halfedge_index_ h) const
  {
    return CGAL::halfedges_around_target(h, mesh());
  }
  /// returns the faces at `target(h)`, from `face(h)` on; a null face stands for a border.
  Face_around_target_range faces_around_target(Halfedge_index_ h) const
  {
    return CGAL::faces_around_target(h, mesh());
  }
  /// @}

  /// \name Around a Face
  /// counterclockwise. A face is named by one of its halfedges, at which the range starts;
  /// a border halfedge names its border.
  /// @{

  /// the bidirectional iterator over the vertices of a face.
  using Vertex_around_face_iterator = CGAL::Vertex_around_face_iterator<Mesh>;
  /// the bidirectional iterator over the halfedges of a face.
  using Halfedge_around_face_iterator = CGAL::Halfedge_around_face_iterator<Mesh>;
  /// the bidirectional iterator over the faces across the edges of a face.
  using Face_around_face_iterator = CGAL::Face_around_face_iterator<Mesh>;

  /// the range of the vertices of a face.
  using Vertex_around_face_range = Iterator_range<Vertex_around_face_iterator>;
  /// the range of the halfedges of a face.
  using Halfedge_around_face_range = Iterator_range<Halfedge_around_face_iterator>;
  /// the range of the faces across the edges of a face.
  using Face_around_face_range = Iterator_range<Face_around_face_iterator>;

  /// the circulator over the vertices of a face.
  using Vertex_around_face_circulator = CGAL::Vertex_around_face_circulator<Mesh>;
  /// the circulator over the halfedges of a face.
  using Halfedge_around_face_circulator = CGAL::Halfedge_around_face_circulator<Mesh>;
  /// the circulator over the faces across the edges of a face.
  using Face_around_face_circulator = CGAL::Face_around_face_circulator<Mesh>;

  /// returns the vertices of the face of `h`, from `target(h)` on.
  Vertex_around_face_range vertices_around_face(Halfedge_index_ h) const
  {
    return CGAL::vertices_around_face(h, mesh());
  }
  /// returns the halfedges of the face of `h`, from `h` on.
  Halfedge_around_face_range halfedges_around_face(Halfedge_index_ h) const
  {
    return CGAL::halfedges_around_face(h, mesh());
  }
  /// returns the faces across the edges of the face of `h`, from `face(opposite(h))` on; a null
  /// face stands for a border.
  Face_around_face_range faces_around_face(Halfedge_index_ h) const { return CGAL::faces_around_face(h, mesh()); }
  /// @}

private:
  const Mesh& mesh() const { return static_cast<const Mesh&>(*this); }

  template <class D>
  static Iterator_range<Iterator_over<D> > first(std::size_t n)
  {
    return Compact_surface_mesh_descriptors::first_descriptors<D>(n);
  }
};

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_ELEMENT_RANGES_H
