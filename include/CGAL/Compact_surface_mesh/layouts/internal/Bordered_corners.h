// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_BORDERED_CORNERS_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_BORDERED_CORNERS_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/Corner_table.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Triangle_numbering.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

// What a table makes of a closed triangulation.
template <class Index>
struct Corner_images
{
  std::vector<Index> vertices; // of each vertex that is neither a copy nor an apex
  std::vector<Index> corners;  // of each corner; empty if all corners keep their numbers
};

/*
The operators of a triangle mesh with borders, over a table of corners in which every border is closed by
triangles around an apex.

A `Table` has the triangles of a closed triangulation without caps in an order of its own, with the corners
3t, 3t+1 and 3t+2 of triangle t counterclockwise. Corner 3t of a triangle at an apex is where the border
halfedge starts, so the apex is at 3t+2. As in Corner_table, corners also name the halfedges that start there.
What is opposite to a halfedge at an apex is asked for only by what is next on a border.
A table is default constructible (empty), copyable and, when moved from, empty, and has

    typedef Index;
    Table(Closed_triangulation<Index>& t, Corner_images<Index>& images); // may take the table of t
    std::size_t num_vertices() const;           // those that are neither copies nor apices
    std::size_t num_triangles() const;          // of all kinds; the images tell which there are
    Index opposite(Index c) const;
    Index source(Index c) const;                // not asked at an apex; of a copy, the vertex that it is a copy of
    Index target(Index c) const;
    Index halfedge_of_vertex(Index v) const;    // with target v, on a border if there is one; null if v is isolated
    std::vector<std::pair<std::string, std::size_t>> memory() const;
*/
template <class Table, class Numbering = Triangle_numbering<typename Table::Index>>
class Bordered_corners
{
public:
  typedef typename Table::Index Index;

  Bordered_corners() = default;

  // `t` must have no caps.
  Bordered_corners(Closed_triangulation<Index>& t, Corner_images<Index>& images)
  {
    const std::size_t num_triangles = t.table().num_faces();
    const bool has_copies = !t.copies().empty();
    m_table = Table(t, images);
    m_numbering = numbering(num_triangles, t.num_open_faces(), images.corners);
    if (has_copies)
      link_fans();
  }

  static constexpr Index null() { return Corner_table<Index>::null(); }

  std::size_t num_vertices() const { return m_table.num_vertices(); }
  std::size_t num_halfedges() const { return m_numbering.num_halfedges(); }
  std::size_t num_faces() const { return m_numbering.num_faces(); }

  BOOST_FORCEINLINE Index next(Index h) const
  {
    return is_border(h) ? next_on_border(h) : Corner_table<Index>::next(h);
  }
  BOOST_FORCEINLINE Index prev(Index h) const
  {
    return is_border(h) ? prev_on_border(h) : Corner_table<Index>::prev(h);
  }
  BOOST_FORCEINLINE Index opposite(Index h) const { return halfedge_at(m_table.opposite(corner(h))); }
  BOOST_FORCEINLINE Index source(Index h) const { return m_table.source(corner(h)); }
  BOOST_FORCEINLINE Index target(Index h) const { return m_table.target(corner(h)); }
  BOOST_FORCEINLINE Index face(Index h) const { return is_border(h) ? null() : Corner_table<Index>::face(h); }
  static Index halfedge_of_face(Index f) { return 3 * f; }

  Index halfedge_of_vertex(Index v) const
  {
    const Index c = m_table.halfedge_of_vertex(v);
    return c == null() ? c : halfedge_at(c);
  }

  Index halfedge(Index u, Index v) const
  {
    const Index out = halfedge_of_vertex(u), in = halfedge_of_vertex(v);
    if (out == null() || in == null())
      return null();
    Index g = out, h = in; // into u and v
    do {
      if (source(g) == v)
        return opposite(g);
      if (source(h) == u)
        return h;
      g = opposite(next(g));
      h = opposite(next(h));
    } while (g != out && h != in);
    return null();
  }

  // The halfedge that starts at corner c of the table, which is at no apex.
  BOOST_FORCEINLINE Index halfedge_at(Index c) const { return m_numbering.halfedge(m_table, c); }

  // The corner where h starts.
  BOOST_FORCEINLINE Index corner(Index h) const { return m_numbering.corner(m_table, h); }

  const Table& table() const { return m_table; }
  std::size_t border_bytes() const { return m_numbering.bytes(); }
  std::size_t fan_bytes() const { return (m_next.capacity() + m_prev.capacity()) * sizeof(m_next[0]); }

private:
  bool is_border(Index h) const { return m_numbering.is_border(h); }
  Numbering numbering(std::size_t num_triangles, std::size_t num_faces,
                      const std::vector<Index>& corners) const
  {
    if (corners.empty())
      return Numbering(num_triangles, num_faces);
    std::vector<Triangle_kind> kinds(m_table.num_triangles(), Triangle_kind::none);
    for (std::size_t f = 0; f < num_triangles; ++f)
      kinds[corners[3 * f] / 3] = f < num_faces ? Triangle_kind::face : Triangle_kind::border;
    return Numbering(kinds);
  }

  // Where a vertex has several fans, borders go from each one to the next.
  void link_fans()
  {
    std::vector<std::pair<Index, Index>> fans; // a vertex, and the border halfedge into one of its fans
    for (std::size_t h = 3 * num_faces(); h < num_halfedges(); ++h)
      fans.emplace_back(target(static_cast<Index>(h)), static_cast<Index>(h));
    std::sort(fans.begin(), fans.end());
    for (std::size_t i = 0, end; i < fans.size(); i = end) {
      for (end = i; end < fans.size() && fans[end].first == fans[i].first;)
        ++end;
      if (end - i == 1)
        continue;
      for (std::size_t j = i; j < end; ++j) {
        const Index h = fans[j].second, g = fans[j + 1 == end ? i : j + 1].second;
        m_next.emplace_back(h, next_in_fan(g));
        m_prev.emplace_back(next_in_fan(g), h);
      }
    }
    for (auto* links : { &m_next, &m_prev }) {
      std::sort(links->begin(), links->end());
      links->shrink_to_fit();
    }
  }

  // The neighboring triangle around the apex has the halfedge that follows in the same fan.
  Index next_in_fan(Index h) const
  {
    return halfedge_at(Corner_table<Index>::next(m_table.opposite(corner(h) + 1)));
  }
  Index prev_in_fan(Index h) const
  {
    return halfedge_at(Corner_table<Index>::prev(m_table.opposite(corner(h) + 2)));
  }

  BOOST_NOINLINE Index next_on_border(Index h) const { return linked(m_next, h, [&] { return next_in_fan(h); }); }
  BOOST_NOINLINE Index prev_on_border(Index h) const { return linked(m_prev, h, [&] { return prev_in_fan(h); }); }

  template <class Otherwise>
  static Index linked(const std::vector<std::pair<Index, Index>>& links, Index h, const Otherwise& otherwise)
  {
    if (links.empty())
      return otherwise();
    const auto it = std::lower_bound(links.begin(), links.end(), std::make_pair(h, Index(0)));
    return it == links.end() || it->first != h ? otherwise() : it->second;
  }

  Table m_table;
  Numbering m_numbering;
  std::vector<std::pair<Index, Index>> m_next, m_prev; // between the fans of a vertex, sorted
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_BORDERED_CORNERS_H
