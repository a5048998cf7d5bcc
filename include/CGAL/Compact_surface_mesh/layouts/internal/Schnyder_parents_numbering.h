// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_PARENTS_NUMBERING_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_PARENTS_NUMBERING_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/internal/Emptied_on_move.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Filled_slots.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_fans.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_special_copies.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Search_directory.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace internal {

/*
How the elements of the parents layout are numbered. The records are, in this order:

  [0, core)             vertices whose neighbors have one sector and one fan each and are numbered
                        as their records, and with nothing hidden around them
  [core, border)        other vertices off the border
  [border, caps)        families of apices of borders
  [caps, isolated)      families of apices of caps, of three vertices each
  [isolated, sectors)   isolated vertices
  [sectors, end)        further sectors, sorted by their vertices, which their idle words 0 name, and
                        counterclockwise

Records off the border have slots for their three edges and two faces, others for their blue and
black edge and the face B, and every cap has one for its face. Slots that nothing lives in are
filled by the last ones: those of the edges and faces that V_0 and V_1 of a component do not have,
of the second copy of a special edge, and of vertices that are further fans of another one.
*/
template <class Index>
struct Schnyder_parents_numbering
{
  Emptied_on_move<Index> core, border, caps, isolated, sectors, end;
  Filled_slots<Index> vertices, edges, faces;
  Schnyder_special_copies<Index> copies;
  Schnyder_fans<Index> fans;
  Search_directory<Index> search_sectors; // by their vertices

  // Elements of regular records before this one have their slots as numbers, and nothing is hidden.
  Emptied_on_move<Index> end_of_kept;

  void keep_slots()
  {
    end_of_kept = static_cast<Index>((std::min)({ std::size_t(border), edges.count() / 3, faces.count() / 2 }));
  }

  bool on_border(Index x) const { return border <= x && x < isolated; }

  // The slots of edges are named by their records and k = 0, 2, 4 for red, blue, black.
  Index edge_slot(Index x, unsigned k) const
  {
    return static_cast<Index>(x < border ? 3 * x + k / 2 : border + 2 * place(x) + k / 2 - 1);
  }
  Index record_of_edge(Index slot) const
  {
    return slot < 3 * border ? slot / 3 : record((slot - border) / 2);
  }
  unsigned k_of_edge(Index slot) const
  {
    return static_cast<unsigned>(slot < 3 * border ? 2 * (slot % 3) : 2 + 2 * ((slot - border) & 1));
  }
  Index num_edge_slots() const { return static_cast<Index>(border + 2 * place(end)); }

  // Owner is 0 for A and 1 for B.
  Index face_slot(Index x, unsigned owner) const
  {
    return static_cast<Index>(x < border ? 2 * x + owner : border + place(x));
  }
  Index cap_slot(Index x) const { return static_cast<Index>(border + place(end) + (x - caps) / 3); }
  Index num_face_slots() const { return cap_slot(isolated); }

  // A cap's face is a hole, named by the first record of the family.
  Schnyder_face<Index> face_of_slot(Index slot) const
  {
    typedef Schnyder_face<Index> Face;
    const Index first = cap_slot(caps);
    if (slot >= first)
      return { caps + 3 * (slot - first), Face::hole };
    return { slot < 2 * border ? slot / 2 : record(slot - border),
             slot < 2 * border && slot % 2 == 0 ? Face::A : Face::B };
  }

  std::size_t bytes() const
  {
    return vertices.bytes() + edges.bytes() + faces.bytes() + copies.bytes() + fans.bytes()
           + search_sectors.bytes();
  }

private:
  // The records from border on count without the isolated ones, which own nothing.
  Index place(Index x) const { return static_cast<Index>(x < sectors ? Index(x) : x - (sectors - isolated)); }
  Index record(Index place) const
  {
    return static_cast<Index>(place < isolated ? Index(place) : place + (sectors - isolated));
  }
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_PARENTS_NUMBERING_H
