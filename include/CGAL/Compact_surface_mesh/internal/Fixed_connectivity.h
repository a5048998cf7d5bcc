// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_INTERNAL_FIXED_CONNECTIVITY_H
#define CGAL_COMPACT_SURFACE_MESH_INTERNAL_FIXED_CONNECTIVITY_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <type_traits>

namespace CGAL {

namespace internal {

template <class... >
inline constexpr bool connectivity_can_be_edited = false;

// The members of Surface_mesh that edit connectivity, so that a program which calls one
// is told what to do. They are members only: free functions would make concept checks
// take the mesh for a MutableFaceGraph.
template <class Vertex_index, class Halfedge_index, class Face_index>
class Fixed_connectivity
{
public:
  template <class... Args> Vertex_index add_vertex(const Args&...) { return refuse<Vertex_index, Args...>(); }
  template <class... Args> Halfedge_index add_edge(const Args&...) { return refuse<Halfedge_index, Args...>(); }
  template <class... Args> Face_index add_face(const Args&...) { return refuse<Face_index, Args...>(); }
  template <class... Args> void remove_vertex(const Args&...) { refuse<void, Args...>(); }
  template <class... Args> void remove_edge(const Args&...) { refuse<void, Args...>(); }
  template <class... Args> void remove_face(const Args&...) { refuse<void, Args...>(); }
  template <class... Args> void set_target(const Args&...) { refuse<void, Args...>(); }
  template <class... Args> void set_face(const Args&...) { refuse<void, Args...>(); }
  template <class... Args> void set_next(const Args&...) { refuse<void, Args...>(); }
  template <class... Args> void set_next_only(const Args&...) { refuse<void, Args...>(); }
  template <class... Args> void set_prev_only(const Args&...) { refuse<void, Args...>(); }
  template <class... Args> void set_halfedge(const Args&...) { refuse<void, Args...>(); }
  template <class... Args> void resize(const Args&...) { refuse<void, Args...>(); }
  template <class... Args> void set_vertex_halfedge_to_border_halfedge(const Args&...) { refuse<void, Args...>(); }
  template <class... Args> bool join(const Args&...) { return refuse<bool, Args...>(); }
  template <class Other> Fixed_connectivity& operator+=(const Other&)
  {
    refuse<void, Other>();
    return *this;
  }

private:
  template <class Result, class... Args>
  static Result refuse()
  {
    static_assert(connectivity_can_be_edited<Result, Args...>,
                  "The connectivity of a CGAL::Compact_surface_mesh is fixed. Edit a CGAL::Surface_mesh,"
                  " and construct a Compact_surface_mesh from it when you are done.");
    if constexpr (!std::is_void<Result>::value)
      return Result();
  }
};

} // namespace internal

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_INTERNAL_FIXED_CONNECTIVITY_H
