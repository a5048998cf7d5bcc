// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_FRONTS_NUMBERING_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_FRONTS_NUMBERING_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/internal/Emptied_on_move.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Live_slots.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_fans.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_sectors.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_side.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_special_copies.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Search_directory.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace internal {

/*
How the elements of the fronts layouts are numbered. The records of vertices are followed by those of further
sectors, sorted by their vertices and counterclockwise. Each record has slots for three edges and two faces. Dead are
the edges to apices and the faces there, but for one of each cap, which is its face; what V_0, V_1, isolated vertices
and further sectors do not have; the second copies of special edges; and vertices that are further fans of another one.
*/
template <class Index>
struct Schnyder_fronts_numbering
{
  Emptied_on_move<Index> sectors, end; // the first further sector, and the number of records
  Live_slots<Index> vertices, edges, faces;
  Schnyder_special_copies<Index> copies;
  Schnyder_fans<Index> fans;
  Search_directory<Index> search_sectors; // by their vertices

  // The slots of edges are named by their records and k = 0, 2, 4 for red, blue, black; owner is 0 for A and 1 for B.
  static Index edge_slot(Index x, unsigned k) { return static_cast<Index>(3 * x + k / 2); }
  static Index record_of_edge(Index slot) { return slot / 3; }
  static unsigned k_of_edge(Index slot) { return static_cast<unsigned>(2 * (slot % 3)); }
  static Index face_slot(Index x, unsigned owner) { return static_cast<Index>(2 * x + owner); }

  // Whether the elements of record x that are live are numbered by their slots.
  bool keeps_slots(Index x) const
  {
    return x < sectors && x < vertices.end_of_kept() && 3 * x + 2 < edges.end_of_kept()
        && 2 * x + 1 < faces.end_of_kept();
  }

  std::size_t bytes() const
  {
    return vertices.bytes() + edges.bytes() + faces.bytes() + copies.bytes() + fans.bytes()
           + search_sectors.bytes();
  }
};

// All records, with the answers that Schnyder_fronts_operators and Schnyder_triangles ask for.
template <class Records, class Index>
struct Schnyder_fronts_zone
{
  typedef Schnyder_face<Index> Face;

  static constexpr bool has_holes = true;
  const Records& r;
  const Schnyder_fronts_numbering<Index>& n;

  bool is_isolated(Index x) const { return is_around_apex(x) && r.record_at(x, Records::red_left) == x; }
  bool is_irregular(Schnyder_side<Index> s) const { return !r.is_plain(s.x); }
  bool on_border(Index x) const { return is_around_apex(x) && r.record_at(x, Records::red_left) != x; }

  // The neighbors of x around the apex.
  Index pred(Index x) const
  {
    const Index y = r.record_at(x, Records::red_left);
    return !Records::is_renumbered || y > x ? y : static_cast<Index>(x - 1);
  }
  Index succ(Index x) const
  {
    const Index y = r.record_at(x, Records::is_renumbered ? Records::red_left : Records::red_right);
    return !Records::is_renumbered || y + 1 < x ? y : static_cast<Index>(x + 1);
  }

  Index vertex(Index x) const { return x < n.sectors ? x : r.record_at(x, Records::red_left); }
  Index last_sector(Index x) const
  {
    return last_sector_of<Index>(x, n.sectors, n.end - n.sectors, n.search_sectors,
                                 [this](Index s) { return vertex(s); });
  }

  Index first_fan(Index x) const
  {
    const auto* fan = n.fans.find(x);
    return fan == nullptr ? x : fan->first;
  }
  Index next_fan(Index x) const
  {
    const auto* fan = n.fans.find(x);
    return fan == nullptr ? x : fan->next;
  }
  Index prev_fan(Index x) const
  {
    const auto* fan = n.fans.find(x);
    return fan == nullptr ? x : fan->prev;
  }

  // The face of a cap has the slot of A(V_0).
  Face face_of_slot(Index slot) const
  {
    const Index x = slot / 2;
    return { x, slot & 1 ? Face::B : on_border(x) ? Face::hole : Face::A };
  }
  Index slot_of_hole(Index x) const
  {
    if (r.k_at(x, Records::red_left) != Records::cap)
      return (std::numeric_limits<Index>::max)();
    while (!r.lacks(x, 2))
      x = pred(x);
    return n.face_slot(x, Face::A);
  }

private:
  bool is_around_apex(Index x) const { return x < n.sectors && r.k_at(x, Records::red_left) >= Records::border; }
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_FRONTS_NUMBERING_H
