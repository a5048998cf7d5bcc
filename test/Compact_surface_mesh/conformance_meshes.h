// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_CONFORMANCE_MESHES_H
#define TEST_COMPACT_SURFACE_MESH_CONFORMANCE_MESHES_H

// The same meshes as Surface_mesh and as Compact_surface_mesh, small ones of every kind in
// generic position, so that few answers depend on the order of elements; and which element of the
// one is which of the other. The order of includes is that of a program in which
// Compact_surface_mesh took the place of Surface_mesh.

#include "bumpy_sphere.h"
#include "closed_surfaces.h"

#include <CGAL/Compact_surface_mesh.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace test {

typedef CGAL::Compact_surface_mesh<Point> Compact_mesh;

/// A mesh whose elements have names: their indices in the Surface_mesh that it was made of.
template <class Mesh_>
class Named_mesh
{
public:
  typedef Mesh_ Mesh;
  typedef typename Mesh::Vertex_index Vertex;
  typedef typename Mesh::Halfedge_index Halfedge;
  typedef typename Mesh::Edge_index Edge;
  typedef typename Mesh::Face_index Face;

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  /// Copies `source`, the indices of whose elements become their names.
  explicit Named_mesh(const Surface_mesh& source)
    : m_vertices(source.number_of_vertices()), m_halfedges(source.number_of_halfedges()),
      m_faces(source.number_of_faces())
  {
    if constexpr (std::is_same<Mesh, Surface_mesh>::value) {
      mesh = source;
      fill(m_vertices);
      fill(m_halfedges);
      fill(m_faces);
    } else
      mesh = Mesh(source,
                  CGAL::parameters::vertex_to_vertex_map(map(m_vertices, get(boost::vertex_index, source)))
                    .halfedge_to_halfedge_map(map(m_halfedges, get(boost::halfedge_index, source)))
                    .face_to_face_map(map(m_faces, get(boost::face_index, source))));
    invert();
  }

  /// Makes a Surface_mesh all of whose elements have the indices of those of `other`.
  template <class Other>
  explicit Named_mesh(const Named_mesh<Other>& other)
    : m_vertices(other.vertices().begin(), other.vertices().end()),
      m_halfedges(other.halfedges().begin(), other.halfedges().end()),
      m_faces(other.faces().begin(), other.faces().end())
  {
    typedef typename Mesh::size_type Index;
    const Other& g = other.mesh;
    for (const auto v : g.vertices())
      mesh.add_vertex(g.point(v));
    for (Index e = 0; e < g.number_of_edges(); ++e)
      mesh.add_edge();
    for (Index f = 0; f < g.number_of_faces(); ++f)
      mesh.add_face();
    for (const auto h : g.halfedges()) {
      mesh.set_target(Halfedge(h), Vertex(g.target(h)));
      mesh.set_next(Halfedge(h), Halfedge(g.next(h)));
      mesh.set_face(Halfedge(h), g.is_border(h) ? Mesh::null_face() : Face(g.face(h)));
    }
    for (const auto v : g.vertices())
      mesh.set_halfedge(Vertex(v), Halfedge(g.halfedge(v)));
    for (const auto f : g.faces())
      mesh.set_halfedge(Face(f), Halfedge(g.halfedge(f)));
    invert();
  }

  std::size_t name(Vertex v) const { return m_vertex_names.at(v); }
  std::size_t name(Halfedge h) const { return m_halfedge_names.at(h); }
  std::size_t name(Edge e) const { return name(halfedge(e, mesh)) / 2; }
  std::size_t name(Face f) const { return f == Mesh::null_face() ? none : m_face_names.at(f); }

  /// The names of a range of elements, in ascending order.
  template <class Range>
  std::multiset<std::size_t> names(const Range& range) const
  {
    std::multiset<std::size_t> result;
    for (const auto& element : range)
      result.insert(name(element));
    return result;
  }

  /// \name Elements
  /// by ascending names.
  /// @{
  const std::vector<Vertex>& vertices() const { return m_vertices; }
  const std::vector<Halfedge>& halfedges() const { return m_halfedges; }
  const std::vector<Edge>& edges() const { return m_edges; }
  const std::vector<Face>& faces() const { return m_faces; }
  /// @}

  Vertex vertex(std::size_t name) const { return m_vertices.at(name); }
  Halfedge halfedge_of(std::size_t name) const { return m_halfedges.at(name); }
  Face face_of(std::size_t name) const { return m_faces.at(name); }

  const Point& point(Vertex v) const { return mesh.point(v); }

  Mesh mesh;

private:
  template <class Element, class IndexMap>
  static auto map(std::vector<Element>& elements, const IndexMap& index)
  {
    return boost::make_iterator_property_map(elements.begin(), index);
  }

  template <class Element>
  static void fill(std::vector<Element>& elements)
  {
    for (std::size_t i = 0; i < elements.size(); ++i)
      elements[i] = Element(static_cast<typename Mesh::size_type>(i));
  }

  void invert()
  {
    for (std::size_t i = 0; i < m_halfedges.size(); i += 2)
      m_edges.push_back(edge(m_halfedges[i], mesh));
    m_vertex_names = inverse(m_vertices);
    m_halfedge_names = inverse(m_halfedges);
    m_face_names = inverse(m_faces);
  }

  template <class Element>
  static std::vector<std::size_t> inverse(const std::vector<Element>& elements)
  {
    std::vector<std::size_t> names(elements.size(), none);
    for (std::size_t i = 0; i < elements.size(); ++i)
      names.at(elements[i]) = i;
    return names;
  }

  std::vector<Vertex> m_vertices;
  std::vector<Halfedge> m_halfedges;
  std::vector<Edge> m_edges;
  std::vector<Face> m_faces;
  std::vector<std::size_t> m_vertex_names, m_halfedge_names, m_face_names;
};

/// The type of the mesh of a `Named_mesh`, which may be a constant reference.
template <class Named>
using Mesh_of = typename std::decay_t<Named>::Mesh;

/// A mesh, three times.
struct Mesh_pair
{
  Mesh_pair(std::string mesh_name, const Surface_mesh& source)
    : name(std::move(mesh_name)), expected(source), compact(source), twin(compact)
  {}

  std::string name;
  Named_mesh<Surface_mesh> expected;
  Named_mesh<Compact_mesh> compact;
  Named_mesh<Surface_mesh> twin; ///< in which all elements have the same indices as in `compact`
};

/// \name Surfaces
/// @{

/// Moves each vertex by up to `distance` along each axis, as no other one.
inline Surface_mesh displaced(Surface_mesh mesh, double distance)
{
  for (const auto v : mesh.vertices()) {
    const double i = static_cast<double>(v.idx()) + 1;
    mesh.point(v) = mesh.point(v) + distance * Kernel::Vector_3(std::sin(i * i), std::sin(1.3 * i * i + 1),
                                                                std::sin(0.7 * i * i + 2));
  }
  return mesh;
}

/// A mesh, `scale` times as large, then moved.
inline Surface_mesh placed(Surface_mesh mesh, double scale, const Kernel::Vector_3& translation)
{
  for (const auto v : mesh.vertices())
    mesh.point(v) = CGAL::ORIGIN + scale * (mesh.point(v) - CGAL::ORIGIN) + translation;
  return mesh;
}

/// A plate with three holes, its triangles cut into 4^levels: genus 3, no self-intersections, 64
/// vertices, with one level 268.
inline Surface_mesh plate_of_genus_3(unsigned int levels = 1)
{
  const Soup soup = surface_of_cubes({7, 3, 1}, [](const std::array<int, 3>& c) {
    return c[0] % 2 == 0 || c[1] != 1;
  });
  Surface_mesh mesh;
  for (std::uint32_t i = 0; i < soup.num_vertices; ++i)
    mesh.add_vertex(Point(0.3 * (i / 8), 0.35 * (i / 2 % 4), 0.4 * (i % 2)));
  for (const Triangle& t : soup.triangles)
    mesh.add_face(Surface_mesh::Vertex_index(t[0]), Surface_mesh::Vertex_index(t[1]), Surface_mesh::Vertex_index(t[2]));
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(levels));
  return displaced(std::move(mesh), 0.01);
}

/// A sphere without three vertices and their faces, and without two further faces.
inline Surface_mesh sphere_with_holes()
{
  const Surface_mesh sphere = bumpy_sphere(2);
  const std::set<Surface_mesh::size_type> lost_vertices = {0, 60, 111}, lost_faces = {130, 250};
  Surface_mesh mesh;
  std::vector<Surface_mesh::Vertex_index> image(sphere.number_of_vertices());
  for (const auto v : sphere.vertices())
    if (lost_vertices.count(v) == 0)
      image[v] = mesh.add_vertex(sphere.point(v));
  for (const auto f : sphere.faces()) {
    std::vector<Surface_mesh::Vertex_index> corners;
    for (const auto v : sphere.vertices_around_face(sphere.halfedge(f)))
      corners.push_back(image[v]);
    if (lost_faces.count(f) == 0 && std::count(corners.begin(), corners.end(), Surface_mesh::null_vertex()) == 0)
      mesh.add_face(corners);
  }
  return mesh;
}

/// The graph of a function over a square of n times n cells, each cut into two triangles.
inline Surface_mesh bumpy_disk(Surface_mesh::size_type n = 12)
{
  Surface_mesh mesh;
  for (Surface_mesh::size_type i = 0; i <= n; ++i)
    for (Surface_mesh::size_type j = 0; j <= n; ++j) {
      const double x = double(i) / n, y = double(j) / n;
      mesh.add_vertex(Point(x, y, 0.3 * std::sin(3 * x + 0.2) * std::cos(4 * y + x)));
    }
  const auto vertex = [n](Surface_mesh::size_type i, Surface_mesh::size_type j) {
    return Surface_mesh::Vertex_index(i * (n + 1) + j);
  };
  for (Surface_mesh::size_type i = 0; i < n; ++i)
    for (Surface_mesh::size_type j = 0; j < n; ++j) {
      const bool is_rising = (i * i + j) % 3 == 0;
      mesh.add_face(vertex(i, j), vertex(i + 1, j), is_rising ? vertex(i + 1, j + 1) : vertex(i, j + 1));
      mesh.add_face(is_rising ? vertex(i, j) : vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  return displaced(std::move(mesh), 0.1 / n);
}

/// Spheres that contain each other or do not, and a disk; no two of the same size.
inline Surface_mesh several_components()
{
  Surface_mesh mesh = placed(bumpy_sphere(1), 3, Kernel::Vector_3(0, 0, 0));
  CGAL::copy_face_graph(placed(bumpy_sphere(2), 1, Kernel::Vector_3(0.2, 0.3, 0.1)), mesh);
  CGAL::copy_face_graph(placed(bumpy_sphere(1), 0.7, Kernel::Vector_3(5, 0.4, 0.2)), mesh);
  CGAL::copy_face_graph(placed(bumpy_disk(5), 2, Kernel::Vector_3(-1, -1, 5)), mesh);
  return mesh;
}

/// A sphere of triangles, quadrilaterals and pentagons.
inline Surface_mesh sphere_of_polygons()
{
  Surface_mesh mesh = bumpy_sphere(2);
  std::vector<Surface_mesh::Edge_index> candidates(mesh.edges().begin(), mesh.edges().end());
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const auto h = mesh.halfedge(candidates[i * 7 % candidates.size()]);
    if (i % 3 != 0 || mesh.degree(mesh.face(h)) + mesh.degree(mesh.face(mesh.opposite(h))) > 7
        || mesh.degree(mesh.source(h)) < 4 || mesh.degree(mesh.target(h)) < 4)
      continue;
    CGAL::Euler::join_face(h, mesh);
  }
  mesh.collect_garbage();
  return mesh;
}
/// @}

/// \name Pairs
/// @{

inline const Mesh_pair& sphere_pair()
{
  static const Mesh_pair pair("a sphere", bumpy_sphere(2));
  return pair;
}

inline const Mesh_pair& genus_3_pair()
{
  static const Mesh_pair pair("a surface of genus 3", plate_of_genus_3());
  return pair;
}

inline const Mesh_pair& borders_pair()
{
  static const Mesh_pair pair("a sphere with holes", sphere_with_holes());
  return pair;
}

inline const Mesh_pair& disk_pair()
{
  static const Mesh_pair pair("a disk", bumpy_disk());
  return pair;
}

inline const Mesh_pair& components_pair()
{
  static const Mesh_pair pair("several components", several_components());
  return pair;
}

inline const Mesh_pair& polygons_pair()
{
  static const Mesh_pair pair("a sphere of polygons", sphere_of_polygons());
  return pair;
}

typedef std::vector<const Mesh_pair*> Mesh_pairs;

inline Mesh_pairs connected_closed_pairs() { return {&sphere_pair(), &genus_3_pair()}; }
inline Mesh_pairs connected_triangle_pairs()
{
  return {&sphere_pair(), &genus_3_pair(), &borders_pair(), &disk_pair()};
}
inline Mesh_pairs triangle_pairs()
{
  return {&sphere_pair(), &genus_3_pair(), &borders_pair(), &disk_pair(), &components_pair()};
}
inline Mesh_pairs all_pairs()
{
  return {&sphere_pair(), &genus_3_pair(), &borders_pair(), &disk_pair(), &components_pair(), &polygons_pair()};
}
/// @}

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_CONFORMANCE_MESHES_H
