// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_INTERNAL_VALIDITY_CHECK_H
#define CGAL_COMPACT_SURFACE_MESH_INTERNAL_VALIDITY_CHECK_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <iostream>

namespace CGAL {

namespace internal {

// Checks what the operators of a mesh answer against each other, and prints the first
// contradiction to std::cerr if it is verbose.
template <class Mesh>
class Validity_check
{
  using Vertex_index = typename Mesh::Vertex_index;
  using Halfedge_index = typename Mesh::Halfedge_index;
  using Edge_index = typename Mesh::Edge_index;
  using Face_index = typename Mesh::Face_index;

public:
  Validity_check(const Mesh& mesh, bool verbose) : m_mesh(mesh), m_verbose(verbose) {}

  bool operator()() const
  {
    return all_of(m_mesh.halfedges()) && all_of(m_mesh.vertices()) && all_of(m_mesh.edges())
        && all_of(m_mesh.faces())
        && holds(m_mesh.number_of_halfedges() == 2 * m_mesh.number_of_edges(), "number of edges",
                 m_mesh.number_of_edges());
  }

  bool operator()(Vertex_index v) const
  {
    return holds(exists(v), "index", v)
        && (m_mesh.is_isolated(v)
            || (holds(exists(m_mesh.halfedge(v)), "halfedge of", v)
                && holds(m_mesh.target(m_mesh.halfedge(v)) == v, "target of the halfedge of", v)));
  }

  bool operator()(Halfedge_index h) const
  {
    if (!holds(exists(h), "index", h))
      return false;
    const Halfedge_index next = m_mesh.next(h), prev = m_mesh.prev(h), opposite = m_mesh.opposite(h);
    return holds(exists(m_mesh.target(h)), "target of", h)
        && holds(exists(next) && m_mesh.prev(next) == h, "halfedge after", h)
        && holds(exists(prev) && m_mesh.next(prev) == h, "halfedge before", h)
        && holds(exists(opposite) && opposite != h && m_mesh.opposite(opposite) == h, "opposite of", h)
        && holds(m_mesh.source(h) == m_mesh.target(opposite), "source of", h)
        && holds(m_mesh.source(next) == m_mesh.target(h), "source of the halfedge after", h)
        && holds(m_mesh.is_border(h) || exists(m_mesh.face(h)), "face of", h)
        && holds(m_mesh.face(next) == m_mesh.face(h), "face of the halfedge after", h);
  }

  bool operator()(Edge_index e) const
  {
    if (!holds(exists(e), "index", e))
      return false;
    const Halfedge_index h = m_mesh.halfedge(e), opposite = m_mesh.opposite(h);
    return holds(m_mesh.edge(h) == e && m_mesh.edge(opposite) == e, "halfedges of", e)
        && (*this)(h) && (*this)(opposite);
  }

  bool operator()(Face_index f) const
  {
    return holds(exists(f), "index", f)
        && holds(exists(m_mesh.halfedge(f)) && m_mesh.face(m_mesh.halfedge(f)) == f, "halfedge of", f);
  }

private:
  template <class Range>
  bool all_of(const Range& elements) const
  {
    for (const auto element : elements)
      if (!(*this)(element))
        return false;
    return true;
  }

  template <class Descriptor> bool exists(Descriptor d) const { return m_mesh.has_valid_index(d); }

  template <class Element>
  bool holds(bool condition, const char* what, const Element& element) const
  {
    if (!condition && m_verbose)
      std::cerr << "Compact_surface_mesh: wrong " << what << ' ' << element << std::endl;
    return condition;
  }

  const Mesh& m_mesh;
  bool m_verbose;
};

} // namespace internal

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_INTERNAL_VALIDITY_CHECK_H
