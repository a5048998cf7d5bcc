// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_WOOD_OF_TRIANGULATION_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_WOOD_OF_TRIANGULATION_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Schnyder_woods/Shelling_order.h>
#include <CGAL/Schnyder_woods/internal/Extremal_wood_search.h>
#include <CGAL/Schnyder_woods/internal/Schnyder_wood.h>
#include <CGAL/Schnyder_woods/internal/Shelling.h>

#include <CGAL/assertions.h>
#include <CGAL/use.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace internal {

// Calls visit(base, further_roots, component) for each component of t, where base is that of its main root and
// the further roots are named by halfedges out of them.
template <class Index, class Visitor>
void for_each_rooted_component(const Closed_triangulation<Index>& t, Visitor&& visit)
{
  std::vector<Index> further_roots;
  for (const auto& component : t.components()) {
    further_roots.clear();
    for (std::size_t i = component.first_root + 1; i < component.end_root; ++i)
      further_roots.push_back(Corner_table<Index>::prev(t.roots()[i].base));
    visit(t.roots()[component.first_root].base, further_roots, component);
  }
}

// The Schnyder wood of all components that their shelling finds.
template <class Index>
Schnyder_wood shelled_wood(const Closed_triangulation<Index>& t, Shelling_order order, unsigned int seed)
{
  Schnyder_wood wood(t.table().num_halfedges());
  Shelling<Index> shelling(t.table(), wood, order, seed);
  for_each_rooted_component(t, [&](Index base, const std::vector<Index>& further_roots, const auto& component) {
    const bool is_simple = shelling(base, further_roots, component.num_faces, [](Index) {});
    CGAL_assertion(is_simple);
    CGAL_USE(is_simple);
  });
  return wood;
}

// Makes a wood of all components one without clockwise faces.
template <class Index>
void make_wood_extremal(const Closed_triangulation<Index>& t, Schnyder_wood& wood)
{
  Extremal_wood_search<Index> search(t.table(), wood);
  for_each_rooted_component(t, [&](Index base, const std::vector<Index>& further_roots, const auto&) {
    search.fix_roots(base, further_roots);
  });
  search(Extremal_wood::WITHOUT_CLOCKWISE_FACES);
}

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_WOOD_OF_TRIANGULATION_H
