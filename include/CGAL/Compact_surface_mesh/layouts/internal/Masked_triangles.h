// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_MASKED_TRIANGLES_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_MASKED_TRIANGLES_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/layouts/internal/around_vertex.h>

#include <cstddef>

namespace CGAL {
namespace internal {

// What the user sees of the triangles of a layout: themselves, if the mask is empty.
template <class Triangles, class Mask, class Index>
class Masked_triangles
{
public:
  Masked_triangles(const Triangles& triangles, const Mask& mask)
    : m_triangles(triangles), m_mask(mask)
  {}

  std::size_t num_vertices() const { return m_mask.empty() ? m_triangles.num_vertices() : m_mask.num_vertices(); }
  std::size_t num_halfedges() const { return m_mask.empty() ? m_triangles.num_halfedges() : m_mask.num_halfedges(); }
  std::size_t num_faces() const { return m_mask.empty() ? m_triangles.num_faces() : m_mask.num_faces(); }

  Index next(Index h) const { return m_mask.empty() ? m_triangles.next(h) : m_mask.next(m_triangles, h); }
  Index prev(Index h) const { return m_mask.empty() ? m_triangles.prev(h) : m_mask.prev(m_triangles, h); }
  Index source(Index h) const { return m_mask.empty() ? m_triangles.source(h) : m_mask.source(m_triangles, h); }
  Index target(Index h) const { return m_mask.empty() ? m_triangles.target(h) : m_mask.target(m_triangles, h); }
  Index face(Index h) const { return m_mask.empty() ? m_triangles.face(h) : m_mask.face(m_triangles, h); }
  Index halfedge_of_vertex(Index v) const
  {
    return m_mask.empty() ? m_triangles.halfedge_of_vertex(v) : m_mask.halfedge_of_vertex(m_triangles, v);
  }
  Index halfedge_of_face(Index f) const
  {
    return m_mask.empty() ? m_triangles.halfedge_of_face(f) : m_mask.halfedge_of_face(m_triangles, f);
  }
  Index halfedge(Index u, Index v) const
  {
    return m_mask.empty() ? m_triangles.halfedge(u, v) : m_mask.halfedge(m_triangles, u, v);
  }

  // Calls visit(u) for each vertex u adjacent to v.
  template <class Visitor>
  void for_each_adjacent_vertex(Index v, Visitor&& visit) const
  {
    if (m_mask.empty())
      m_triangles.for_each_adjacent_vertex(v, visit);
    else
      for_each_halfedge_into(visible(), v, [&](Index g) { visit(visible().source(g)); });
  }

  // Calls visit(u, w) for each face at v, where u follows and w precedes v.
  template <class Visitor>
  void for_each_incident_triangle(Index v, Visitor&& visit) const
  {
    if (m_mask.empty())
      m_triangles.for_each_incident_triangle(v, visit);
    else
      for_each_corner_at(visible(), v, visit);
  }

  // Counts the edges at v.
  Index degree(Index v) const
  {
    Index d = 0;
    if (m_mask.empty())
      m_triangles.for_each_adjacent_vertex(v, [&d](Index) { ++d; });
    else
      for_each_halfedge_into(visible(), v, [&d](Index) { ++d; });
    return d;
  }

private:
  typename Mask::template Visible_halfedges<Triangles> visible() const
  {
    return m_mask.visible_halfedges(m_triangles);
  }

  Triangles m_triangles;
  const Mask& m_mask;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_MASKED_TRIANGLES_H
