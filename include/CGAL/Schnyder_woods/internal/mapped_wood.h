// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_INTERNAL_MAPPED_WOOD_H
#define CGAL_SCHNYDER_WOODS_INTERNAL_MAPPED_WOOD_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Schnyder_woods/internal/Rooted_surface.h>
#include <CGAL/Schnyder_woods/internal/Schnyder_wood.h>

#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>

// A wood between a corner table and the property maps of a user.

namespace CGAL {
namespace internal {

// Writes colors and directions: -1 and false at the edges of the root face.
template <class FaceGraph, class HalfedgeColorMap, class HalfedgeOutgoingMap>
void write_wood(const Rooted_surface<FaceGraph>& surface, const Schnyder_wood& wood, HalfedgeColorMap color,
                HalfedgeOutgoingMap outgoing)
{
  for (std::size_t h = 0; h < surface.halfedges.size(); ++h) {
    put(color, surface.halfedges[h], static_cast<int>(wood.color(h)));
    put(outgoing, surface.halfedges[h], wood.is_outgoing(h));
  }
  for (const std::uint32_t h : root_face(surface.table, surface.base))
    for (const std::uint32_t side : { h, surface.table.opposite(h) }) {
      put(color, surface.halfedges[side], -1);
      put(outgoing, surface.halfedges[side], false);
    }
}

// Writes special edges as well.
template <class FaceGraph, class HalfedgeColorMap, class HalfedgeOutgoingMap, class EdgeIsSpecialMap>
void write_wood(const FaceGraph& g, const Rooted_surface<FaceGraph>& surface, const Schnyder_wood& wood,
                HalfedgeColorMap color, HalfedgeOutgoingMap outgoing, EdgeIsSpecialMap is_special)
{
  write_wood(surface, wood, color, outgoing);
  for (std::size_t h = 0; h < surface.halfedges.size(); ++h)
    put(is_special, edge(surface.halfedges[h], g), wood.is_special(h));
}

// The wood in these maps; copies with other colors than 0, 1 and 2 are uncolored. The edges of
// the root face are as the shelling leaves them, whatever the maps say.
template <class FaceGraph, class HalfedgeColorMap, class HalfedgeOutgoingMap, class EdgeIsSpecialMap>
Schnyder_wood read_wood(const FaceGraph& g, const Rooted_surface<FaceGraph>& surface, HalfedgeColorMap color,
                        HalfedgeOutgoingMap outgoing, EdgeIsSpecialMap is_special)
{
  Schnyder_wood wood(surface.halfedges.size());
  for (std::size_t h = 0; h < surface.halfedges.size(); ++h) {
    const int c = get(color, surface.halfedges[h]);
    wood.set_copy(h, 0 <= c && c < 3 ? static_cast<Schnyder_color>(c) : uncolored, get(outgoing, surface.halfedges[h]));
    if (get(is_special, edge(surface.halfedges[h], g)))
      wood.set_special(h, surface.table.opposite(static_cast<std::uint32_t>(h)));
  }
  if (!surface.is_empty())
    color_root_edges(surface.table, surface.base, wood);
  return wood;
}

// A wood without special edges.
template <class FaceGraph, class HalfedgeColorMap, class HalfedgeOutgoingMap>
Schnyder_wood read_wood(const FaceGraph& g, const Rooted_surface<FaceGraph>& surface, HalfedgeColorMap color,
                        HalfedgeOutgoingMap outgoing)
{
  typedef typename boost::graph_traits<FaceGraph>::edge_descriptor edge_descriptor;
  return read_wood(g, surface, color, outgoing, Constant_property_map<edge_descriptor, bool>(false));
}

} // namespace internal
} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_INTERNAL_MAPPED_WOOD_H
