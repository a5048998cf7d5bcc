// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_CLOSED_TRIANGULATION_H
#define CGAL_COMPACT_SURFACE_MESH_CLOSED_TRIANGULATION_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Corner_table.h>
#include <CGAL/Compact_surface_mesh/Simple_triangulation.h>
#include <CGAL/Compact_surface_mesh/internal/Breadth_first_renumbering.h>
#include <CGAL/Compact_surface_mesh/internal/Emptied_on_move.h>
#include <CGAL/Compact_surface_mesh/internal/Large_array.h>

#include <CGAL/assertions.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgCompactSurfaceMeshRef

The class `Closed_triangulation` is a mesh made ready for a layout: a simple closed
triangulation, maybe of several components, with a mask that says what of it is not the
user's.

- A border is closed by a hidden vertex, an <em>apex</em>, that is joined to all of its
  vertices. A component without border gets an apex inside one of its triangles, its
  <em>cap</em>: the three triangles around the apex stand for that one. So layouts know one kind
  of root only.
- A vertex with several fans of faces, which are all open, is parted: each further fan
  gets a <em>copy</em> of the vertex. So no border passes a vertex twice.
- Diagonals of polygons and what else a `Simple_triangulation` hides remain as they are.

Unless it is renumbered, the vertices are, in this order: those of the `Simple_triangulation`, the user's ones first;
the copies; and the apices. The triangles of the `Simple_triangulation` come first, and
those around apices after them.

\tparam Index an unsigned integer type, as for `Corner_table`
*/
template <class Index = std::uint32_t>
class Closed_triangulation
{
  typedef Corner_table<Index> Table;

public:
  /*!
  A hidden apex. The halfedge `base` has the apex to its left; in the main root of a component
  it runs from \f$V_1\f$ to \f$V_0\f$, and the apex is \f$V_2\f$.
  */
  struct Root
  {
    /// the hidden vertex.
    Index apex;
    /// a halfedge opposite to it. In a cap, it lies in the face that keeps the index of the cap.
    Index base;
    /// the number of faces around it.
    Index degree;
  };

  /// A connected component.
  struct Component
  {
    /// its roots are the `roots()` from this one on; the first of them is the main one.
    Index first_root;
    /// and before this one.
    Index end_root;
    /// the number of its faces, hidden ones included.
    Index num_faces;
  };

  /// creates the empty triangulation.
  Closed_triangulation() = default;

  /*!
  closes `t`, in nearly linear time.
  \throws Mesh_defect_exception if `Index` cannot number the hidden elements
  */
  explicit Closed_triangulation(Simple_triangulation<Index>&& t)
    : m_simple(std::move(t)), m_num_open_faces(table().num_faces()), m_first_copy(table().num_vertices())
  {
    const std::vector<Index> border = border_halfedges();
    part_vertices(border);
    close_borders(border);
    find_components();
  }

  /// closes `table`, in nearly linear time.
  explicit Closed_triangulation(Table&& table)
    : Closed_triangulation(Simple_triangulation<Index>(std::move(table)))
  {}

  /// returns the triangulation, hidden vertices and faces included.
  const Table& table() const { return m_simple.table(); }

  /// returns the triangulation as it was, with what is hidden in it; its table is now closed.
  const Simple_triangulation<Index>& simple() const { return m_simple; }

  /// returns the roots, grouped by components.
  const std::vector<Root>& roots() const { return m_roots; }

  /// returns the components, without isolated vertices; none if the caps are removed.
  const std::vector<Component>& components() const { return m_components; }

  /// returns whether `root` is that of a cap.
  bool is_cap(const Root& root) const { return Table::face(root.base) < m_num_open_faces; }

  /// returns the vertices around the apex of `root` counterclockwise, in the main root of a component from
  /// \f$V_0\f$ to \f$V_1\f$.
  std::vector<Index> vertices_around(const Root& root) const
  {
    std::vector<Index> family;
    const Index first = table().opposite(table().next(root.base));
    Index h = first;
    do {
      family.push_back(table().target(h));
      h = table().next_around_source(h);
    } while (h != first);
    return family;
  }

  /// returns the number of triangles before the mesh was closed.
  std::size_t num_open_faces() const { return m_num_open_faces; }

  /// returns the first copy of a vertex; behind the last one follow the apices.
  std::size_t first_copy() const { return m_first_copy; }

  /// returns of which vertex `first_copy() + i` is a copy, for all copies.
  const std::vector<Index>& copies() const { return m_copies; }

  /// returns the first apex: the number of vertices that are not apices.
  std::size_t first_apex() const { return m_first_copy + m_copies.size(); }

  /// returns where the halfedge `h` of the triangulation that was closed is now.
  /// \pre If the triangulation was renumbered, that was remembered.
  Index current_halfedge(Index h) const
  {
    const Index c = m_current_face.empty() ? h : static_cast<Index>(3 * m_current_face[Table::face(h)] + h % 3);
    return is_split(Table::face(c)) ? table().halfedge_of_split_face(c) : c;
  }

  /// returns which vertex is now the vertex `v` of the triangulation that was closed.
  Index current_vertex(Index v) const { return m_current_vertex.empty() ? v : m_current_vertex[v]; }

  /// returns whether vertices have other numbers than in the triangulation that was closed.
  bool is_renumbered() const { return !m_current_vertex.empty(); }

  /// returns whether the edge of `h`, which does not end at an apex, is hidden.
  bool is_hidden(Index h) const
  {
    return m_simple.is_hidden(Table::face(h) < m_num_open_faces ? h : table().opposite(h));
  }

  /// returns whether it gains time to renumber it: neighbors stand far from each other in memory, and nothing is hidden
  /// in the triangulation that was closed. It looks at no more than a thousand edges.
  bool is_scattered() const
  {
    return !m_simple.has_hidden() && internal::Breadth_first_renumbering<Index>::is_scattered(table());
  }

  /*!
  renumbers vertices and triangles such that neighbors stand close to each other, in linear time: in breadth-first
  order, but copies, apices and the triangles at these remain behind all others. For layouts with an order of their own.
  \param remembers_halfedges whether `current_halfedge()` will be asked for, which takes an index per face
  \pre Nothing is hidden in the triangulation that was closed, which has not been renumbered before.
  */
  void renumber(bool remembers_halfedges)
  {
    CGAL_precondition(!m_simple.has_hidden() && !is_renumbered());
    internal::Breadth_first_renumbering<Index> numbers(table(), m_num_open_faces, m_first_copy);
    for (Index& v : m_copies)
      v = numbers.vertex(v);
    for (Root& root : m_roots)
      root.base = numbers.halfedge(root.base);
    m_simple.table().m_corner = numbers.release_corners();
    m_current_vertex = numbers.release_vertices();
    if (remembers_halfedges)
      m_current_face = numbers.release_faces();
  }

  /// removes the caps: components without border have no roots from now on.
  void remove_caps()
  {
    Table& t = m_simple.table();
    const auto is_cap_root = [this](const Root& root) { return is_cap(root); };
    const std::size_t num_caps = static_cast<std::size_t>(std::count_if(m_roots.begin(), m_roots.end(), is_cap_root));
    for (const Root& root : m_roots)
      if (is_cap(root))
        t.unsplit_face(Table::face(root.base));
    // the apices and faces of caps are the last ones
    t.resize(t.num_vertices() - num_caps, t.num_faces() - 2 * num_caps);
    m_roots.erase(std::remove_if(m_roots.begin(), m_roots.end(), is_cap_root), m_roots.end());
    m_components.clear();
  }

  /// moves the table out.
  Table release_table() { return std::move(m_simple.table()); }

private:
  bool is_split(Index f) const
  {
    return !m_components.empty() && table().vertex(3 * f + 2) >= first_apex();
  }

  std::vector<Index> border_halfedges() const
  {
    std::vector<Index> border;
    for (std::size_t h = 0; h < table().num_halfedges(); ++h)
      if (table().opposite(static_cast<Index>(h)) == Table::null())
        border.push_back(static_cast<Index>(h));
    return border;
  }

  // The first fan that is met keeps the vertex.
  void part_vertices(const std::vector<Index>& border)
  {
    if (border.empty())
      return;
    std::vector<bool> has_fan(m_first_copy, false);
    for (const Index h : border) {
      const Index v = table().source(h);
      if (has_fan[v]) {
        const Index copy = m_simple.table().add_vertex();
        for (Index g = h; g != Table::null(); g = table().next_around_source(g))
          m_simple.table().set_vertex(g, copy);
        m_copies.push_back(v);
      } else
        has_fan[v] = true;
    }
  }

  void close_borders(const std::vector<Index>& border)
  {
    if (border.empty())
      return;
    m_simple.table().reserve_further_faces(border.size());
    for (const Index h : border)
      if (table().opposite(h) == Table::null()) { // no apex yet
        const std::size_t before = table().num_faces();
        const Index apex = m_simple.table().close_border(h);
        m_roots.push_back({ apex, static_cast<Index>(3 * before), static_cast<Index>(table().num_faces() - before) });
      }
  }

  // Finds the components in the order of their first faces, gives a cap to those without
  // border, and sorts the roots. The main root is that of the largest border.
  void find_components()
  {
    const std::size_t n = first_apex();
    std::vector<unsigned char> rank(n, 0);
    internal::Large_array<Index> parent(n);
    std::iota(parent.begin(), parent.end(), Index(0));
    typedef boost::typed_identity_property_map<Index> Vertex_map;
    typedef boost::iterator_property_map<unsigned char*, Vertex_map> Rank_map;
    typedef boost::iterator_property_map<Index*, Vertex_map> Parent_map;
    boost::disjoint_sets<Rank_map, Parent_map> sets{ Rank_map(rank.data()), Parent_map(parent.data()) };
    const auto unite = [&](Index u, Index v) {
      if (parent[u] != parent[v]) // most edges need no search
        sets.union_set(u, v);
    };
    for (std::size_t h = 0; h < 3 * m_num_open_faces; h += 3) {
      const Index v = table().vertex(static_cast<Index>(h));
      unite(v, table().vertex(static_cast<Index>(h + 1)));
      unite(v, table().vertex(static_cast<Index>(h + 2)));
    }
    std::vector<unsigned char>().swap(rank);

    internal::Large_array<Index> component(n, Table::null()); // of the vertices that stand for their sets
    std::vector<Index> first_face;
    for (std::size_t f = 0; f < m_num_open_faces; ++f) {
      Index& c = component[sets.find_set(table().vertex(static_cast<Index>(3 * f)))];
      if (c == Table::null()) {
        c = static_cast<Index>(first_face.size());
        first_face.push_back(static_cast<Index>(f));
        m_components.push_back({ 0, 0, 0 });
      }
      ++m_components[c].num_faces;
    }
    const auto component_of = [&](const Root& r) { return component[sets.find_set(table().source(r.base))]; };
    for (const Root& root : m_roots) {
      Component& c = m_components[component_of(root)];
      ++c.end_root;
      c.num_faces += root.degree;
    }
    add_caps(first_face);
    std::sort(m_roots.begin(), m_roots.end(), [&](const Root& a, const Root& b) {
      return std::make_tuple(component_of(a), b.degree, a.apex) < std::make_tuple(component_of(b), a.degree, b.apex);
    });
    Index num_roots = 0;
    for (Component& c : m_components) {
      c.first_root = num_roots;
      num_roots += c.end_root;
      c.end_root = num_roots;
    }
  }

  // Every component without roots gets one, in its first face.
  void add_caps(const std::vector<Index>& first_face)
  {
    const std::size_t num_caps = static_cast<std::size_t>(
        std::count_if(m_components.begin(), m_components.end(), [](const Component& c) { return c.end_root == 0; }));
    if (num_caps == 0)
      return;
    m_simple.table().reserve_further_faces(2 * num_caps);
    for (std::size_t c = 0; c < m_components.size(); ++c)
      if (m_components[c].end_root == 0) {
        const Index f = first_face[c];
        const Index apex = m_simple.table().split_face(f);
        m_roots.push_back({ apex, static_cast<Index>(3 * f), 3 });
        m_components[c].end_root = 1;
        m_components[c].num_faces += 2;
      }
  }

  Simple_triangulation<Index> m_simple;
  internal::Emptied_on_move<std::size_t> m_num_open_faces, m_first_copy;
  std::vector<Index> m_copies;
  std::vector<Root> m_roots;
  std::vector<Component> m_components;
  internal::Large_array<Index> m_current_vertex, m_current_face; // empty if they are as they were
};

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_CLOSED_TRIANGULATION_H
