// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_PARENTS_SIDES_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_PARENTS_SIDES_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_parents_builder.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_parents_numbering.h>
#include <CGAL/Schnyder_woods/internal/Schnyder_wood.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

// What becomes of the halfedges of a closed triangulation in the parents layout, whose records are written.
template <int References, class Index>
class Schnyder_parents_sides
{
  typedef Schnyder_parents_records<References, Index> Records;
  typedef Schnyder_parents_numbering<Index> Numbering;
  typedef Schnyder_parents_builder<References, Index> Builder;
  typedef Schnyder_side<Index> Side;
  typedef Corner_table<Index> Table;

public:
  Schnyder_parents_sides(const Closed_triangulation<Index>& t, const Schnyder_wood& wood, const Builder& builder)
    : m_triangulation(t), m_table(t.table()), m_wood(wood), m_side(builder.sides())
  {}

  // Finds the slots that are dead, and the copies of special edges.
  void number_slots(Records& records, Numbering& numbering) const
  {
    Dead_slots dead;
    bury_slots_of_roots(numbering, dead);
    number_special_copies(numbering, dead);
    numbering.edges = filled(numbering.num_edge_slots(), dead.edges);
    numbering.faces = filled(numbering.num_face_slots(), dead.faces);
    for (const Side s : dead.irregular)
      records.records[s.x].word[s.k / 2] |= Records::irregular;
  }

private:
  struct Dead_slots
  {
    std::vector<Index> edges, faces;
    std::vector<Side> irregular; // dead edges, and copies of special ones
  };

  static void bury_edge(const Numbering& numbering, Side s, Dead_slots& dead)
  {
    dead.irregular.push_back(s);
    dead.edges.push_back(numbering.edge_slot(s.x, s.k));
  }

  // What V_0 and V_1 of each component do not have.
  void bury_slots_of_roots(const Numbering& numbering, Dead_slots& dead) const
  {
    for (const auto& component : m_triangulation.components()) {
      const Index base = m_triangulation.roots()[component.first_root].base;
      const Index v0 = m_side.record[m_table.target(base)];
      const Index v1 = m_side.record_of_corner(base);
      for (const Side s : { Side{ v0, 2 }, Side{ v0, 4 }, Side{ v1, 4 } })
        bury_edge(numbering, s, dead);
      for (const Index x : { v0, v1 })
        dead.faces.push_back(numbering.face_slot(x, 1));
    }
  }

  // The first copy of a special edge has the edge.
  void number_special_copies(Numbering& numbering, Dead_slots& dead) const
  {
    const auto slot = [&](Side s) { return numbering.edge_slot(s.x, s.k); };
    numbering.copies = Schnyder_special_copies<Index>(
      m_table, m_wood, m_side, slot, [&](Side second, Side first) {
        dead.irregular.push_back(first);
        bury_edge(numbering, second, dead);
      });
  }

  static Filled_slots<Index> filled(std::size_t num_slots, std::vector<Index>& dead)
  {
    std::sort(dead.begin(), dead.end());
    return Filled_slots<Index>(num_slots, std::move(dead), true);
  }

  const Closed_triangulation<Index>& m_triangulation;
  const Table& m_table;
  const Schnyder_wood& m_wood;
  const Schnyder_wood_sides<Index> m_side;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_PARENTS_SIDES_H
