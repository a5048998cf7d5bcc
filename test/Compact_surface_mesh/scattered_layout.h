// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_SCATTERED_LAYOUT_H
#define TEST_COMPACT_SURFACE_MESH_SCATTERED_LAYOUT_H

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Corner_layout.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// A table of corners in an order that is as bad as the shared part of such layouts admits: triangles of faces
/// and borders are mixed, there are numbers of no triangle, and faces start anywhere.
template <class Index_>
class Scattered_corners
{
public:
  typedef Index_ Index;

  Scattered_corners() = default;

  Scattered_corners(CGAL::Closed_triangulation<Index>& t, CGAL::internal::Corner_images<Index>& images)
    : m_halfedge(t.first_copy(), null())
  {
    const auto& table = t.table();
    std::mt19937 rng(static_cast<unsigned int>(table.num_faces()));
    std::vector<Index> triangle(table.num_faces() + table.num_faces() / 4);
    std::iota(triangle.begin(), triangle.end(), Index(0));
    std::shuffle(triangle.begin(), triangle.end(), rng);
    m_vertex.assign(3 * triangle.size(), null());
    m_opposite = m_vertex;
    images.corners.resize(table.num_halfedges());
    for (std::size_t f = 0; f < table.num_faces(); ++f) {
      const std::size_t first = f < t.num_open_faces() ? rng() % 3 : 0;
      for (std::size_t i = 0; i < 3; ++i)
        images.corners[3 * f + i] = static_cast<Index>(3 * triangle[f] + (first + i) % 3);
    }
    for (Index c = 0; c < table.num_halfedges(); ++c) {
      const Index v = table.vertex(c);
      m_vertex[images.corners[c]] = t.first_copy() <= v && v < t.first_apex() ? t.copies()[v - t.first_copy()] : v;
      m_opposite[images.corners[c]] = images.corners[table.opposite(c)];
    }
    for (std::size_t c = 0; c < table.num_halfedges(); c += c < 3 * t.num_open_faces() ? 1 : 3)
      if (table.target(static_cast<Index>(c)) < t.first_copy())
        m_halfedge[table.target(static_cast<Index>(c))] = images.corners[c];
    images.vertices.resize(t.first_copy());
    std::iota(images.vertices.begin(), images.vertices.end(), Index(0));
  }

  std::size_t num_vertices() const { return m_halfedge.size(); }
  std::size_t num_triangles() const { return m_vertex.size() / 3; }
  Index opposite(Index c) const { return m_opposite[c]; }
  Index source(Index c) const { return m_vertex[c]; }
  Index target(Index c) const { return m_vertex[c % 3 == 2 ? c - 2 : c + 1]; }
  Index halfedge_of_vertex(Index v) const { return m_halfedge[v]; }

  std::vector<std::pair<std::string, std::size_t>> memory() const
  {
    return {{"corners", (m_vertex.capacity() + m_opposite.capacity() + m_halfedge.capacity()) * sizeof(Index)}};
  }

private:
  static constexpr Index null() { return (std::numeric_limits<Index>::max)(); }

  std::vector<Index> m_vertex, m_opposite, m_halfedge;
};

/// The layout of such a table.
template <class Index = std::uint32_t>
struct Scattered_layout
  : CGAL::internal::Corner_layout<Scattered_corners<Index>>
{
  using Base = CGAL::internal::Corner_layout<Scattered_corners<Index>>;
  using Base::Base;

  static std::string name() { return "scattered"; }
};

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_SCATTERED_LAYOUT_H
