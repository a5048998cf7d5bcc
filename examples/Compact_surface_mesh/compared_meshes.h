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
#include <CGAL/Compact_surface_mesh/layouts/Input_order_layout.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace example {

using Surface_mesh = CGAL::Surface_mesh<Point>;

/// The layouts of this package.
using Layouts = std::tuple<CGAL::Schnyder_parents_layout<4>,
                           CGAL::Schnyder_parents_layout<5>,
                           CGAL::Schnyder_parents_layout<6>,
                           CGAL::Input_order_layout<>,
                           CGAL::Corner_table_layout<> >;

template <class T>
struct Type
{
  using type = T;
};

/// calls `visit(Type<Layout>())` for each layout of a list.
template <class... Ls, class Visitor>
void for_each_layout(std::tuple<Ls...>, const Visitor& visit)
{
  (visit(Type<Ls>()), ...);
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
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;

  Mesh mesh;
  std::vector<std::uint32_t> label; ///< in the order of the vertices

  /// returns the vertices in the order of their labels, which are 0, 1, ...
  std::vector<Vertex> vertices_by_label() const
  {
    std::vector<Vertex> result(label.size());
    auto l = label.begin();
    for (const Vertex v : vertices(mesh))
      result[*l++] = v;
    return result;
  }

  Vertex vertex_with_label(std::uint32_t wanted) const
  {
    return *std::next(vertices(mesh).begin(), std::find(label.begin(), label.end(), wanted) - label.begin());
  }
};

/// \name Structures
/// What a comparison knows of a type of mesh: its name, how it is built, and the bytes of its
/// connectivity.
/// @{

struct Surface_mesh_structure
{
  using Mesh = Surface_mesh;

  static std::string name() { return "Surface_mesh"; }
  static Mesh mesh_of(const Triangle_soup& soup) { return surface_mesh_of(soup); }
  static double connectivity_bytes(const Mesh& mesh) { return example::connectivity_bytes(mesh); }
};

template <class Layout>
struct Compact_structure
{
  using Mesh = CGAL::Compact_surface_mesh<Point, Layout>;

  static std::string name() { return Layout::name(); }
  static Mesh mesh_of(const Triangle_soup& soup) { return Mesh(soup.points, soup.triangles); }
  static double connectivity_bytes(const Mesh& mesh) { return static_cast<double>(mesh.connectivity_bytes()); }
};

/// @}

/// \name Construction
/// `labels` are those of the vertices of the soup.
/// @{

/// builds a mesh that keeps the order of the soup.
template <class Structure>
std::shared_ptr<const Labeled_mesh<typename Structure::Mesh> >
labeled_mesh(Type<Structure>, const Triangle_soup& soup, const std::vector<std::uint32_t>& labels)
{
  const auto result = std::make_shared<Labeled_mesh<typename Structure::Mesh> >();
  result->mesh = Structure::mesh_of(soup);
  result->label = labels;
  return result;
}

/// builds a mesh that has an order of its own.
template <class Layout>
std::shared_ptr<const Labeled_mesh<CGAL::Compact_surface_mesh<Point, Layout> > >
labeled_mesh(Type<Compact_structure<Layout> >, const Triangle_soup& soup, const std::vector<std::uint32_t>& labels)
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

/// @}

} // namespace example

#endif // COMPACT_SURFACE_MESH_EXAMPLES_COMPARED_MESHES_H
