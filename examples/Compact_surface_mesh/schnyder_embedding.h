// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef COMPACT_SURFACE_MESH_EXAMPLES_SCHNYDER_EMBEDDING_H
#define COMPACT_SURFACE_MESH_EXAMPLES_SCHNYDER_EMBEDDING_H

// Gives a triangulated sphere that has no geometry one without self-intersections.

#include "triangle_soup.h"

#include <CGAL/Compact_surface_mesh.h>
#include <CGAL/Schnyder_woods.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/property_map.h>

#include <array>
#include <cstddef>
#include <vector>

namespace example {

/// moves all vertices to Schnyder's straight-line drawing, lifted to a paraboloid, with faces looking out.
inline void embed(Triangle_soup& soup)
{
  using Mesh = CGAL::Compact_surface_mesh<Point>;
  std::vector<Mesh::Vertex_index> image(soup.points.size());
  const Mesh mesh(soup.points, soup.triangles, CGAL::parameters::vertex_to_vertex_map(CGAL::make_property_map(image)));
  const auto color = get(CGAL::dynamic_halfedge_property_t<int>(), mesh);
  const auto outgoing = get(CGAL::dynamic_halfedge_property_t<bool>(), mesh);
  const auto coordinates = get(CGAL::dynamic_vertex_property_t<std::array<std::size_t, 3> >(), mesh);
  CGAL::schnyder_drawing(mesh, CGAL::schnyder_wood(mesh, color, outgoing), color, outgoing, coordinates);

  const double sum = 2. * static_cast<double>(soup.points.size()) - 5; // of the coordinates
  for (std::size_t v = 0; v < image.size(); ++v) {
    const std::array<std::size_t, 3> c = get(coordinates, image[v]);
    const double x = static_cast<double>(c[1]) / sum, y = static_cast<double>(c[2]) / sum;
    soup.points[v] = Point(x, y, -x * x - y * y);
  }
}

} // namespace example

#endif // COMPACT_SURFACE_MESH_EXAMPLES_SCHNYDER_EMBEDDING_H
