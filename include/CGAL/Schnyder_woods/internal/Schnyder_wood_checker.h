// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_INTERNAL_SCHNYDER_WOOD_CHECKER_H
#define CGAL_SCHNYDER_WOODS_INTERNAL_SCHNYDER_WOOD_CHECKER_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Corner_table.h>
#include <CGAL/Schnyder_woods/Schnyder_wood_rules.h>
#include <CGAL/Schnyder_woods/internal/Schnyder_wood.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace internal {

/*
Checks whether a wood of a closed connected triangulation is a g-Schnyder wood, rule by
rule of definition 3.1 and proposition 3.5 of the habilitation of L. Castelli Aleardi (2022), with
one correction: the edges of color 2 may also end at V_0 and V_1, at sectors other than the
root sectors, so that the tree is that of color 2 with the edges V_0 V_2 and V_1 V_2.

A special edge counts as two edges with a special face between them. A sector of a
vertex is what lies, counterclockwise, between two successive ones of its special
faces, its edge out of color 2 and the root face.
*/
template <class Index>
class Schnyder_wood_checker
{
  typedef Corner_table<Index> Table;

public:
  // `base` runs from V_1 to V_0 along the root face. For each further root there is one
  // halfedge that starts there.
  Schnyder_wood_checker(const Table& table, const Schnyder_wood& wood, Index base,
                        const std::vector<Index>& further_roots)
    : m_table(table), m_wood(wood), m_base(base), m_further_roots(further_roots),
      m_kind(table.num_vertices(), inner), m_first(table.num_vertices(), Table::null())
  {
    for (std::size_t h = 0; h < table.num_halfedges(); ++h)
      if (wood.is_out(h, red) || m_first[table.source(static_cast<Index>(h))] == Table::null())
        m_first[table.source(static_cast<Index>(h))] = static_cast<Index>(h);
    m_kind[table.target(base)] = v0;
    m_kind[table.source(base)] = v1;
    m_kind[table.source(table.prev(base))] = sink;
    for (const Index h : further_roots)
      m_kind[table.source(h)] = sink;
    m_first[table.target(base)] = table.opposite(base);
    m_first[table.source(base)] = table.opposite(table.prev(base));
  }

  bool operator()(Schnyder_wood_rules rules) const
  {
    if (!is_locally_right())
      return false;
    if (rules != Schnyder_wood_rules::LOCAL && !has_cut_graph())
      return false;
    return rules != Schnyder_wood_rules::CELLULAR ||
           (is_cellular(blue, m_table.next(m_base)) && is_cellular(black, m_table.prev(m_base)));
  }

private:
  bool is_locally_right() const
  {
    for (Index h = 0; h < m_table.num_halfedges(); ++h)
      if (!is_edge_right(h))
        return false;
    for (std::size_t v = 0; v < m_first.size(); ++v)
      if (!is_vertex_right(static_cast<Index>(v)))
        return false;
    return true;
  }

  // Whether the edges of color 2 and two root edges are a forest that spans all vertices and
  // leads to the roots, and are, with the special edges, a graph whose complement is an open
  // disk. Both follow from numbers of edges, as each vertex that is no root has one red
  // edge out.
  bool has_cut_graph() const
  {
    const std::size_t num_special = num_special_edges(), num_roots = 1 + m_further_roots.size();
    return num_special == 2 * genus() + m_further_roots.size() &&
           num_components([this](Index h) { return has_color(h, red); }) == num_roots &&
           num_regions([this](Index h) { return has_color(h, red) || m_wood.is_special(h); }) == 1 + num_special;
  }

  enum Kind : unsigned char { inner, v0, v1, sink };

  struct Token
  {
    Schnyder_color color;
    bool is_out;
    bool operator==(const Token& t) const { return color == t.color && is_out == t.is_out; }
  };
  typedef std::vector<Token> Sector;

  bool is_edge_right(Index h) const
  {
    const Index o = m_table.opposite(h);
    if (m_wood.color(h) == uncolored)
      return false;
    if (m_wood.is_special(h)) // the special face is to the right of h
      return m_wood.is_out(h, blue) || m_wood.is_in(h, black);
    return m_wood.color(h) == m_wood.color(o) && m_wood.is_outgoing(h) != m_wood.is_outgoing(o);
  }

  bool is_vertex_right(Index v) const
  {
    if (m_kind[v] == sink)
      return is_sink(v);
    if (m_kind[v] == inner && !m_wood.is_out(m_first[v], red))
      return false;
    const std::vector<Sector> sectors = sectors_of(v);
    auto first = sectors.begin(), last = sectors.end();
    if (m_kind[v] == v0 && !all_are_in(*first++, blue))
      return false;
    if (m_kind[v] == v1 && !all_are_in(*--last, black))
      return false;
    return std::all_of(first, last, is_sector_right);
  }

  bool is_sink(Index v) const
  {
    Index h = m_first[v];
    do {
      if (!m_wood.is_in(h, red) || m_wood.is_special(h))
        return false;
      h = m_table.next_around_source(h);
    } while (h != m_first[v]);
    return true;
  }

  static bool all_are_in(const Sector& sector, Schnyder_color c)
  {
    return std::all_of(sector.begin(), sector.end(), [c](const Token& t) { return t == Token{ c, false }; });
  }

  // Edges in of color 1, one out of color 0, edges in of color 2, one out of color 1, edges in
  // of color 0.
  static bool is_sector_right(const Sector& sector)
  {
    auto token = sector.begin();
    const auto pass = [&](Schnyder_color c, bool is_out) {
      const bool is_there = token != sector.end() && *token == Token{ c, is_out };
      token += is_there ? 1 : 0;
      return is_there;
    };
    while (pass(black, false)) {}
    if (!pass(blue, true))
      return false;
    while (pass(red, false)) {}
    if (!pass(black, true))
      return false;
    while (pass(blue, false)) {}
    return token == sector.end();
  }

  // The sectors of v, counterclockwise: from its edge out of color 2 on, at V_0 and V_1 from
  // the root face on.
  std::vector<Sector> sectors_of(Index v) const
  {
    std::vector<Sector> sectors(1);
    Index h = m_first[v];
    do {
      const Index o = m_table.opposite(h);
      if (m_wood.is_special(h)) {
        sectors.back().push_back(Token{ m_wood.color(o), !m_wood.is_outgoing(o) });
        sectors.emplace_back();
      }
      if (!is_root_edge(h) && (m_kind[v] != inner || h != m_first[v]))
        sectors.back().push_back(Token{ m_wood.color(h), m_wood.is_outgoing(h) });
      h = m_table.next_around_source(h);
    } while (h != m_first[v]);
    return sectors;
  }

  // Whether the edges of color c and a root edge are a graph that is connected but for the
  // further roots, and parts the surface into disks: Euler's formula tells how many.
  bool is_cellular(Schnyder_color c, Index root_edge) const
  {
    const auto is_in_graph = [&](Index h) {
      return has_color(h, c) || h == root_edge || m_table.opposite(h) == root_edge || h == m_base ||
             m_table.opposite(h) == m_base;
    };
    return num_components(is_in_graph) == 1 + m_further_roots.size() &&
           num_regions(is_in_graph) == 1 + 2 * genus() + 2 * m_further_roots.size();
  }

  bool is_root_edge(Index h) const
  {
    return m_table.face(h) == m_table.face(m_base) || m_table.face(m_table.opposite(h)) == m_table.face(m_base);
  }

  bool has_color(Index h, Schnyder_color c) const { return m_wood.color(h) == c; }

  std::size_t genus() const { return (m_table.num_faces() + 4 - 2 * m_table.num_vertices()) / 4; }

  std::size_t num_special_edges() const
  {
    std::size_t num_copies = 0;
    for (std::size_t h = 0; h < m_table.num_halfedges(); ++h)
      num_copies += m_wood.is_special(h) ? 1 : 0;
    return num_copies / 2;
  }

  // The number of components of the graph of all vertices with the edges of these copies.
  template <class Is_in_graph>
  std::size_t num_components(const Is_in_graph& is_in_graph) const
  {
    Merger vertices(m_table.num_vertices());
    for (Index h = 0; h < m_table.num_halfedges(); ++h)
      if (is_in_graph(h))
        vertices.merge(m_table.source(h), m_table.target(h));
    return vertices.num_sets();
  }

  // The number of regions into which the copies of this graph part the surface, special faces
  // included.
  template <class Is_in_graph>
  std::size_t num_regions(const Is_in_graph& is_in_graph) const
  {
    const std::size_t num_faces = m_table.num_faces();
    Merger faces(num_faces + num_special_edges());
    std::size_t special_face = num_faces;
    for (Index h = 0; h < m_table.num_halfedges(); ++h) {
      const Index o = m_table.opposite(h);
      if (h > o)
        continue;
      if (!m_wood.is_special(h)) {
        if (!is_in_graph(h))
          faces.merge(m_table.face(h), m_table.face(o));
        continue;
      }
      for (const Index side : { h, o })
        if (!is_in_graph(side))
          faces.merge(m_table.face(side), special_face);
      ++special_face;
    }
    return faces.num_sets();
  }

  // Disjoint sets of integers.
  class Merger
  {
  public:
    explicit Merger(std::size_t size)
      : m_rank(size, 0), m_parent(size), m_sets(Map(m_rank.begin()), Map(m_parent.begin())), m_num_sets(size)
    {
      for (std::size_t i = 0; i < size; ++i)
        m_sets.make_set(i);
    }

    Merger(const Merger&) = delete;
    Merger& operator=(const Merger&) = delete;

    void merge(std::size_t i, std::size_t j)
    {
      const std::size_t a = m_sets.find_set(i), b = m_sets.find_set(j);
      if (a == b)
        return;
      m_sets.link(a, b);
      --m_num_sets;
    }

    std::size_t num_sets() const { return m_num_sets; }

  private:
    typedef boost::iterator_property_map<std::vector<std::size_t>::iterator,
                                         boost::typed_identity_property_map<std::size_t>> Map;

    std::vector<std::size_t> m_rank, m_parent;
    boost::disjoint_sets<Map, Map> m_sets;
    std::size_t m_num_sets;
  };

  const Table& m_table;
  const Schnyder_wood& m_wood;
  const Index m_base;
  const std::vector<Index> m_further_roots;
  std::vector<Kind> m_kind;
  std::vector<Index> m_first; // where the sectors of each vertex start
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_INTERNAL_SCHNYDER_WOOD_CHECKER_H
