// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef COMPACT_SURFACE_MESH_EXAMPLES_COMPARED_MESHES_H
#define COMPACT_SURFACE_MESH_EXAMPLES_COMPARED_MESHES_H

// The meshes that are compared: all layouts by their names, and Surface_mesh.

#include "triangle_soup.h"

#include <CGAL/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/layouts/Corner_table_layout.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace example {

using Surface_mesh = CGAL::Surface_mesh<Point>;

/// All layouts. A new one is one line here.
using Layouts = std::tuple<CGAL::Schnyder_parents_layout<4>,
                           CGAL::Schnyder_parents_layout<5>,
                           CGAL::Schnyder_parents_layout<6>,
                           CGAL::Corner_table_layout<> >;

template <class T>
struct Type
{
  using type = T;
};

/// calls `visit(Type<Layout>())` for each layout.
template <class Visitor>
void for_each_layout(const Visitor& visit)
{
  std::apply([&](auto... layouts) { (visit(Type<decltype(layouts)>()), ...); }, Layouts());
}

/// builds a `Surface_mesh`, whose arrays grow once. Vertices keep their indices.
inline Surface_mesh surface_mesh_of(const Triangle_soup& soup)
{
  Surface_mesh mesh;
  const auto num_vertices = static_cast<Surface_mesh::size_type>(soup.points.size());
  const auto num_faces = static_cast<Surface_mesh::size_type>(soup.triangles.size());
  mesh.reserve(num_vertices, num_faces + num_faces / 2, num_faces);
  for (const Point& p : soup.points)
    mesh.add_vertex(p);
  for (const Triangle& t : soup.triangles)
    if (mesh.add_face(Surface_mesh::Vertex_index(t[0]), Surface_mesh::Vertex_index(t[1]),
                      Surface_mesh::Vertex_index(t[2])) == Surface_mesh::null_face())
      throw std::runtime_error("Surface_mesh refuses a face");
  return mesh;
}

/// returns the bytes of the connectivity of a `Surface_mesh`: the indices that it stores (one a
/// vertex, four a halfedge, one a face), and the bits that say what is removed.
inline double connectivity_bytes(const Surface_mesh& mesh)
{
  const double v = mesh.number_of_vertices(), e = mesh.number_of_edges(), f = mesh.number_of_faces();
  return sizeof(Surface_mesh::size_type) * (v + 4 * 2 * e + f) + (v + e + f) / 8;
}

/// A mesh, and which vertex of the soup each of its vertices is.
template <class Mesh>
struct Labeled_mesh
{
  Mesh mesh;
  std::vector<std::uint32_t> label;

  typename Mesh::Vertex_index vertex_with_label(std::uint32_t l) const
  {
    std::uint32_t v = 0;
    while (label[v] != l)
      ++v;
    return typename Mesh::Vertex_index(v);
  }
};

/// builds a compact mesh. `labels` are those of the vertices of the soup.
template <class Layout>
std::shared_ptr<const Labeled_mesh<CGAL::Compact_surface_mesh<Point, Layout> > >
labeled_compact_mesh(const Triangle_soup& soup, const std::vector<std::uint32_t>& labels)
{
  using Mesh = CGAL::Compact_surface_mesh<Point, Layout>;
  const auto result = std::make_shared<Labeled_mesh<Mesh> >();
  std::vector<typename Mesh::Vertex_index> image(soup.points.size());
  result->mesh = Mesh(soup.points, soup.triangles,
                      CGAL::parameters::vertex_to_vertex_map(CGAL::make_property_map(image)));
  result->label.resize(labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i)
    result->label[image[i]] = labels[i];
  return result;
}

inline std::shared_ptr<const Labeled_mesh<Surface_mesh> >
labeled_surface_mesh(const Triangle_soup& soup, const std::vector<std::uint32_t>& labels)
{
  return std::make_shared<Labeled_mesh<Surface_mesh> >(Labeled_mesh<Surface_mesh>{ surface_mesh_of(soup), labels });
}

} // namespace example

#endif // COMPACT_SURFACE_MESH_EXAMPLES_COMPARED_MESHES_H
