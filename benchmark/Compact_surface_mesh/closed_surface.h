// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef BENCHMARK_COMPACT_SURFACE_MESH_CLOSED_SURFACE_H
#define BENCHMARK_COMPACT_SURFACE_MESH_CLOSED_SURFACE_H

#include "../../test/Compact_surface_mesh/generated_triangulations.h"

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/Corner_table.h>
#include <CGAL/Compact_surface_mesh/Input_images.h>
#include <CGAL/Schnyder_woods/internal/Schnyder_wood.h>
#include <CGAL/Schnyder_woods/internal/Shelling.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace example {

/// A connected surface without border, ready to be shelled: what all layouts are built from.
class Closed_surface
{
public:
  Closed_surface(std::string name, CGAL::Corner_table<> table)
    : m_name(std::move(name)), m_triangulation(std::move(table))
  {}

  Closed_surface(std::string name, const test::Soup& soup)
    : Closed_surface(std::move(name), CGAL::Corner_table<>(soup.num_vertices, soup.triangles))
  {}

  const std::string& name() const { return m_name; }
  std::size_t num_user_vertices() const { return m_triangulation.first_copy(); }
  bool is_connected() const { return m_triangulation.components().size() == 1; }

  /// finds a Schnyder wood, and returns the number of special edges.
  double shell() const
  {
    const auto& table = m_triangulation.table();
    CGAL::internal::Schnyder_wood wood(table.num_halfedges());
    CGAL::internal::Shelling<std::uint32_t> shelling(table, wood, CGAL::Shelling_order::LAST_IN_FIRST_OUT, 0);
    const auto& component = m_triangulation.components()[0];
    shelling(m_triangulation.roots()[0].base, std::vector<std::uint32_t>(), component.num_faces, [](std::uint32_t) {});
    std::size_t num_special = 0;
    for (std::size_t h = 0; h < table.num_halfedges(); ++h)
      num_special += wood.is_special(h) ? 1 : 0;
    return static_cast<double>(num_special / 2);
  }

  /// builds a layout, with the wood that it needs, from a copy, and returns its number of vertices.
  template <class Layout>
  double build_layout() const
  {
    CGAL::Input_images<> images;
    return static_cast<double>(Layout(CGAL::Closed_triangulation<>(m_triangulation), images).num_vertices());
  }

private:
  std::string m_name;
  CGAL::Closed_triangulation<> m_triangulation;
};

} // namespace example

#endif // BENCHMARK_COMPACT_SURFACE_MESH_CLOSED_SURFACE_H
