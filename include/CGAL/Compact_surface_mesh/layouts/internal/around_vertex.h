// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_AROUND_VERTEX_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_AROUND_VERTEX_H

#include <CGAL/license/Compact_surface_mesh.h>

namespace CGAL {
namespace internal {

// The stars of a layout by its operators, one after the other: right everywhere, on borders and
// at polygons too.

template <class Layout, class Index, class Visitor>
void for_each_halfedge_into(const Layout& layout, Index v, Visitor&& visit)
{
  const typename Layout::Halfedge first = layout.halfedge_of_vertex(v);
  if (first == Layout::null_index())
    return;
  typename Layout::Halfedge h = first;
  do {
    visit(h);
    h = layout.opposite(layout.next(h));
  } while (h != first);
}

// Calls visit(u, w) for each face at v, where u follows and w precedes v. A vertex is asked for once, since
// that may take long.
template <class Layout, class Index, class Visitor>
void for_each_corner_at(const Layout& layout, Index v, Visitor&& visit)
{
  const typename Layout::Halfedge first = layout.halfedge_of_vertex(v);
  if (first == Layout::null_index())
    return;
  const typename Layout::Index last = layout.source(first);
  typename Layout::Index preceding = last;
  typename Layout::Halfedge h = first;
  do {
    const typename Layout::Halfedge following_h = layout.opposite(layout.next(h));
    const typename Layout::Index following = following_h == first ? last : layout.source(following_h);
    if (layout.face(h) != Layout::null_index())
      visit(following, preceding);
    h = following_h;
    preceding = following;
  } while (h != first);
}

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_AROUND_VERTEX_H
