// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_FRONTS_BUILDER_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_FRONTS_BUILDER_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/Mesh_defect_exception.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_family_order.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_fronts_numbering.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_fronts_operators.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_fronts_records.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_sectors.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_wood_sides.h>
#include <CGAL/Schnyder_woods/internal/Schnyder_wood.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

// Writes the records of a fronts layout and numbers their elements: first all fronts, then what the layout
// stores of them.
template <int References, bool has_targets, class Index>
class Schnyder_fronts_builder
{
  typedef Schnyder_fronts_records<References, has_targets, Index> Records;
  typedef Schnyder_fronts_records<6, false, Index> All_fronts;
  typedef Schnyder_fronts_numbering<Index> Numbering;
  typedef Corner_table<Index> Table;
  typedef Schnyder_side<Index> Side;
  typedef Schnyder_face<Index> Face;
  template <class R> using Zone = Schnyder_fronts_zone<R, Index>;
  template <class R> using Operators = Schnyder_fronts_operators<R, Index, Zone<R>>;

public:
  Schnyder_fronts_builder(const Closed_triangulation<Index>& t, const Schnyder_wood& wood, Records& records,
                          Numbering& numbering)
    : m_triangulation(t), m_table(t.table()), m_wood(wood), m_records(records), m_numbering(numbering),
      m_num_vertices(t.first_apex()), m_red_edge(red_edges_out(m_table, wood, m_num_vertices)),
      m_sectors(m_table, wood, m_red_edge)
  {}

  // Throws Mesh_defect_exception if there are too many records.
  void operator()()
  {
    const std::size_t num_records = m_num_vertices + m_sectors.num_further();
    if (num_records > Records::max_records)
      throw Mesh_defect_exception(Mesh_defect::too_many_elements, num_records);
    m_numbering.sectors = static_cast<Index>(m_num_vertices);
    m_numbering.end = static_cast<Index>(num_records);
    number_records();
    if constexpr (References == 6) {
      m_records.records.assign(num_records, {});
      write_fronts(m_records);
    } else {
      All_fronts fronts;
      fronts.records.assign(num_records, {});
      write_fronts(fronts);
      m_records.records.assign(num_records, {});
      for (std::size_t x = 0; x < num_records; ++x)
        compress(fronts, static_cast<Index>(x));
      if constexpr (Records::is_renumbered)
        write_targets();
      CGAL_assertion(has_fronts(fronts));
    }
    number_slots();
  }

  Schnyder_wood_sides<Index> sides() const { return { m_table, m_wood, m_sectors, m_number }; }

  // The record of each vertex but the apices, and of further sectors behind them.
  const std::vector<Index>& records_of_vertices() const { return m_number; }

  // Tells which records are plain: those with no vertex on the faces beside their edges around which something is
  // dead, or not numbered as its slot, or parted. keeps(x) tells whether the mask keeps the numbers of what x owns.
  template <class Predicate>
  void mark_plain(const Predicate& keeps)
  {
    std::vector<bool> is_plain(m_records.records.size());
    for (std::size_t v = 0; v < m_num_vertices; ++v) {
      const Index x = m_number[v];
      is_plain[x] = m_red_edge[v] != Table::null() && m_table.target(m_red_edge[v]) < m_num_vertices
          && m_numbering.keeps_slots(x) && keeps(x);
    }
    for (const Index x : m_irregular)
      is_plain[x] = false;
    for (const Index v : m_sectors.multiple_vertices())
      is_plain[m_number[v]] = false;
    for (std::size_t x = 0; x < is_plain.size(); ++x)
      if (is_plain[x])
        m_records.set(Records::plain, static_cast<Index>(x));
    const Schnyder_wood_sides<Index> side = sides();
    for (Index h = 0; h < m_table.num_halfedges(); h += 3) {
      const auto is_plain_at = [&](Index c) {
        const Index v = m_table.vertex(c);
        return v < m_num_vertices && is_plain[m_number[v]];
      };
      if (!is_plain_at(h) || !is_plain_at(h + 1) || !is_plain_at(h + 2))
        for (Index c = h; c < h + 3; ++c)
          m_records.clear(Records::plain, side(c).x);
    }
  }

private:
  void number_records()
  {
    if constexpr (Records::is_renumbered) {
      Schnyder_family_order<Index> order(m_triangulation, m_wood, m_red_edge);
      for (std::size_t v = 0; has_targets && v < m_num_vertices; ++v)
        m_has_even_depth.push_back(order.has_even_depth(static_cast<Index>(v)));
      m_number = order.release_numbers();
    } else {
      m_number.resize(m_num_vertices);
      std::iota(m_number.begin(), m_number.end(), Index(0));
    }
    const std::vector<Index> names = m_sectors.further_sectors_by(m_number);
    m_number.resize(m_num_vertices + names.size());
    for (std::size_t i = 0; i < names.size(); ++i)
      m_number[names[i]] = static_cast<Index>(m_num_vertices + i);
    m_numbering.search_sectors = Search_directory<Index>(
      names.size(), [&](std::size_t i) { return m_number[m_sectors.vertex_of_further(names[i])]; });
  }

  void write_fronts(All_fronts& fronts) const
  {
    const Schnyder_wood_sides<Index> side = sides();
    for (Index f = 0; f < m_table.num_halfedges(); f += 3) {
      const Side s[] = { side(f), side(f + 1), side(f + 2) };
      for (unsigned i = 0; i < 3; ++i) {
        fronts.set_side(s[i].x, s[i].k, s[(i + (s[i].k & 1 ? 2 : 1)) % 3]);
        const Index target_corner = f + (s[i].k & 1 ? i : (i + 1) % 3);
        if (m_table.vertex(target_corner) < m_num_vertices)
          fronts.set(All_fronts::has_in_red + s[i].k / 2, side.record_of_corner(target_corner));
      }
    }
    for (std::size_t v = 0; v < m_num_vertices; ++v)
      if (m_red_edge[v] == Table::null())
        fronts.set_side(m_number[v], All_fronts::red_left, { m_number[v], All_fronts::border });
    for (const auto& root : m_triangulation.roots()) {
      const std::vector<Index> family = m_triangulation.vertices_around(root);
      for (std::size_t i = 0; i < family.size(); ++i)
        fronts.set_side(m_number[family[i]], All_fronts::red_left,
                        { m_number[i == 0 ? family.back() : family[i - 1]],
                          m_triangulation.is_cap(root) ? All_fronts::cap : All_fronts::border });
    }
    for (std::size_t i = m_num_vertices; i < m_number.size(); ++i)
      fronts.set_side(m_number[i], All_fronts::red_left,
                      { m_number[m_sectors.vertex_of_further(static_cast<Index>(i))], 0 });
    for_each_root_edge([&](Index v0, Index v1) {
      fronts.set_side(v0, All_fronts::blue_left, { 0, All_fronts::missing });
      fronts.set_side(v0, All_fronts::black_left, { 0, All_fronts::missing });
      fronts.set_side(v1, All_fronts::black_left, { 0, All_fronts::missing });
    });
  }

  // Calls visit(v0, v1) for each component, with the records that have no blue and no black edge out.
  template <class Visitor>
  void for_each_root_edge(Visitor&& visit) const
  {
    for (const auto& component : m_triangulation.components()) {
      const Index base = m_triangulation.roots()[component.first_root].base;
      visit(m_number[m_table.target(base)], sides().record_of_corner(base));
    }
  }

  // Writes a record but targets.
  void compress(const All_fronts& all, Index x)
  {
    const Operators<All_fronts> op{ all, { all, m_numbering } };
    m_records.set_side(x, Records::red_left, all.side_at(x, All_fronts::red_left));
    if (all.k_at(x, All_fronts::red_left) == 2 && x < m_numbering.sectors) {
      const Index v = all.record_at(x, All_fronts::red_left);
      if (op.in_black(v))
        m_records.set_side(x, Records::red_left, op.next(Side{ v, 3 }));
    }
    if constexpr (!Records::is_renumbered)
      m_records.set_side(x, Records::red_right, op.red_right(x));
    else if (op.zone.on_border(x) && op.zone.succ(x) < x)
      m_records.set_side(x, Records::red_left, { op.zone.succ(x), all.k_at(x, All_fronts::red_left) });
    const bool lacks_black = all.lacks(x, 4);
    m_records.set_side(x, Records::blue, op.in_red(x) || all.lacks(x, 2) ? op.blue_left(x) : op.blue_right(x));
    m_records.set_side(x, Records::black_left, op.black_left(x));
    m_records.set_side(x, Records::black_right, lacks_black ? op.blue_left(x) : op.black_right(x));
    for (const unsigned flag : { All_fronts::has_in_red, All_fronts::has_in_blue, All_fronts::has_in_black })
      if (all.has(flag, x))
        m_records.set(flag, x);
  }

  void write_targets()
  {
    if constexpr (has_targets)
      for (std::size_t i = 0; i < m_number.size(); ++i)
        if (m_has_even_depth[i < m_num_vertices ? i : m_sectors.vertex_of_further(static_cast<Index>(i))])
          m_records.set(Records::black_target, m_number[i]);
    const Schnyder_wood_sides<Index> side = sides();
    for (Index h = 0; h < m_table.num_halfedges(); ++h) {
      const Side s = side(h);
      const Index target_corner = s.k & 1 ? h : m_table.next(h);
      if (m_table.vertex(target_corner) >= m_num_vertices)
        continue;
      const Index target = side.record_of_corner(target_corner);
      if (s.k / 2 == 0) {
        if (m_records.k_at(s.x, Records::red_left) == 1)
          m_records.set_side(s.x, Records::red_left, { target, 1 });
      } else if (has_targets && stores_target(s.x, s.k / 2))
        m_records.set_side(s.x, Records::other_target, { target, 0 });
    }
  }

  // Whether x stores the target of its edge of this color: red 0, blue 1, black 2.
  bool stores_target(Index x, unsigned color) const
  {
    const bool black = m_records.has(Records::has_in_red, x)
        ? m_records.has(Records::black_target, x) : !(m_records.k_at(x, Records::black_right) & 1);
    return color == (black ? 2u : 1u);
  }

  // Whether the operators find all fronts that were compressed.
  bool has_fronts(const All_fronts& all) const
  {
    const Operators<All_fronts> expected{ all, { all, m_numbering } };
    const Operators<Records> op{ m_records, { m_records, m_numbering } };
    const auto same = [](Side s, Side t) { return s.x == t.x && s.k == t.k; };
    for (Index h = 0; h < m_table.num_halfedges(); ++h) {
      const Side s = sides()(h);
      if (s.k < 2 && expected.zone.on_border(s.x))
        continue;
      const Side front = s.k == 0 ? op.red_left(s.x) : s.k == 1 ? op.red_right(s.x)
                       : s.k == 2 ? op.blue_left(s.x) : s.k == 3 ? op.blue_right(s.x)
                       : s.k == 4 ? op.black_left(s.x) : op.black_right(s.x);
      if (!same(front, all.side_at(s.x, s.k)))
        return false;
    }
    return true;
  }

  // Finds the slots that are dead, and the copies of special edges.
  void number_slots()
  {
    m_numbering.fans = Schnyder_fans<Index>(m_triangulation.copies(), m_triangulation.first_copy(), m_number);
    m_numbering.vertices = Live_slots<Index>(m_num_vertices, m_numbering.fans.further_fans());
    std::vector<Index> edges, faces;
    const auto bury_edge = [&](Index x, unsigned k) {
      m_irregular.push_back(x);
      edges.push_back(m_numbering.edge_slot(x, k));
    };
    const auto bury_face = [&](Index x, unsigned owner) { faces.push_back(m_numbering.face_slot(x, owner)); };
    const Zone<Records> zone{ m_records, m_numbering };
    for (Index x = 0; x < m_numbering.end; ++x)
      if (zone.is_isolated(x)) {
        for (const unsigned k : { 0u, 2u, 4u })
          bury_edge(x, k);
        bury_face(x, Face::A);
        bury_face(x, Face::B);
      } else if (x >= m_numbering.sectors || zone.on_border(x)) {
        bury_edge(x, 0);
        if (x >= m_numbering.sectors || zone.slot_of_hole(x) != m_numbering.face_slot(x, Face::A))
          bury_face(x, Face::A);
      }
    for_each_root_edge([&](Index v0, Index v1) {
      bury_edge(v0, 2);
      bury_edge(v0, 4);
      bury_edge(v1, 4);
      bury_face(v0, Face::B);
      bury_face(v1, Face::B);
    });
    m_numbering.copies = Schnyder_special_copies<Index>(
      m_table, m_wood, sides(), [this](Side s) { return m_numbering.edge_slot(s.x, s.k); },
      [&](Side second, Side first) {
        m_irregular.push_back(first.x);
        bury_edge(second.x, second.k);
      });
    m_numbering.edges = Live_slots<Index>(3 * std::size_t(m_numbering.end), std::move(edges));
    m_numbering.faces = Live_slots<Index>(2 * std::size_t(m_numbering.end), std::move(faces));
  }

  const Closed_triangulation<Index>& m_triangulation;
  const Table& m_table;
  const Schnyder_wood& m_wood;
  Records& m_records;
  Numbering& m_numbering;
  const std::size_t m_num_vertices; // without apices
  Large_array<Index> m_red_edge;
  Schnyder_sectors<Index> m_sectors;
  std::vector<Index> m_number;      // the record of each vertex and further sector
  std::vector<bool> m_has_even_depth;
  std::vector<Index> m_irregular;   // records with dead slots or special edges
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_SCHNYDER_FRONTS_BUILDER_H
