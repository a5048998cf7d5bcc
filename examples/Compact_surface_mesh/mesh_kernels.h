// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef COMPACT_SURFACE_MESH_EXAMPLES_MESH_KERNELS_H
#define COMPACT_SURFACE_MESH_EXAMPLES_MESH_KERNELS_H

// The traversals that are timed. Each is written once, over two ways to go around a
// vertex and a face:
//   By_operators  one operator at a time, with CGAL's ranges, as programs for Surface_mesh do
//   By_stars      whole stars, as Compact_surface_mesh offers them
// and returns a number that tells whether it did its work: the same for all meshes of the
// same surface, but for rounding, and for sum_over_faces() only if they number vertices alike.

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace example {

struct By_operators
{
  template <class Vertex, class Mesh>
  static std::size_t degree(Vertex v, const Mesh& mesh)
  {
    // the loop of Surface_mesh::degree()
    std::size_t d = 0;
    const auto first = halfedge(v, mesh);
    auto h = first;
    do {
      ++d;
      h = opposite(next(h, mesh), mesh);
    } while (h != first);
    return d;
  }

  template <class Vertex, class Mesh, class Visitor>
  static void for_each_adjacent_vertex(Vertex v, const Mesh& mesh, Visitor visit)
  {
    for (const auto u : CGAL::vertices_around_target(halfedge(v, mesh), mesh))
      visit(u);
  }

  template <class Vertex, class Mesh, class Visitor>
  static void for_each_incident_triangle(Vertex v, const Mesh& mesh, Visitor visit)
  {
    for (const auto h : CGAL::halfedges_around_target(halfedge(v, mesh), mesh))
      visit(target(next(h, mesh), mesh), source(h, mesh));
  }

  template <class Face, class Mesh>
  static auto vertices_of_face(Face f, const Mesh& mesh)
  {
    std::array<typename boost::graph_traits<Mesh>::vertex_descriptor, 3> result;
    auto it = result.begin();
    for (const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      *it++ = v;
    return result;
  }
};

struct By_stars
{
  template <class Vertex, class Mesh>
  static std::size_t degree(Vertex v, const Mesh& mesh) { return mesh.degree(v); }

  template <class Vertex, class Mesh, class Visitor>
  static void for_each_adjacent_vertex(Vertex v, const Mesh& mesh, Visitor visit)
  {
    mesh.for_each_adjacent_vertex(v, visit);
  }

  template <class Vertex, class Mesh, class Visitor>
  static void for_each_incident_triangle(Vertex v, const Mesh& mesh, Visitor visit)
  {
    mesh.for_each_incident_triangle(v, visit);
  }

  template <class Face, class Mesh>
  static auto vertices_of_face(Face f, const Mesh& mesh) { return mesh.vertices_of_face(f); }
};

/// Degree: returns the sum of the squares of all degrees.
template <class Access, class Mesh>
double sum_of_degrees(const Mesh& mesh)
{
  std::uint64_t sum = 0;
  for (const auto v : vertices(mesh)) {
    const std::size_t d = Access::degree(v, mesh);
    sum += d * d;
  }
  return static_cast<double>(sum);
}

/// Vertex normals, weighted by area: returns the sum of their squared lengths.
template <class Access, class Mesh>
double sum_of_normals(const Mesh& mesh)
{
  double sum = 0;
  for (const auto v : vertices(mesh)) {
    const auto p = mesh.point(v);
    double x = 0, y = 0, z = 0;
    Access::for_each_incident_triangle(v, mesh, [&](auto u, auto w) {
      const auto a = mesh.point(u) - p, b = mesh.point(w) - p;
      x += a.y() * b.z() - a.z() * b.y();
      y += a.z() * b.x() - a.x() * b.z();
      z += a.x() * b.y() - a.y() * b.x();
    });
    sum += x * x + y * y + z * z;
  }
  return sum;
}

/// Three vertices of each face: returns a sum that depends on them and on their orientation.
/// \param label numbers vertices
template <class Access, class Mesh, class Label>
double sum_over_faces(const Mesh& mesh, const Label& label)
{
  std::uint64_t sum = 0;
  for (const auto f : faces(mesh)) {
    const auto v = Access::vertices_of_face(f, mesh);
    const std::uint64_t a = label(v[0]), b = label(v[1]), c = label(v[2]);
    sum += (a - b) * (b - c) * (c - a);
  }
  return static_cast<double>(sum >> 12); // exact
}

/// Breadth-first search: returns the sum of all distances.
template <class Mesh>
class Breadth_first_search
{
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;

public:
  Breadth_first_search(const Mesh& mesh, Vertex source)
    : m_mesh(mesh), m_source(source), m_distance(num_vertices(mesh)), m_queue(num_vertices(mesh))
  {}

  template <class Access>
  double run()
  {
    start();
    std::size_t begin = 0, end = 0;
    m_queue[end++] = m_source;
    std::uint64_t sum = 0;
    while (begin < end) {
      const Vertex v = m_queue[begin++];
      const std::uint32_t d = m_distance[v];
      sum += d;
      Access::for_each_adjacent_vertex(v, m_mesh, [&](Vertex u) {
        if (m_distance[u] == unseen) {
          m_distance[u] = d + 1;
          m_queue[end++] = u;
        }
      });
    }
    return static_cast<double>(sum);
  }

  /// the same by Boost.Graph.
  double run_by_boost()
  {
    start();
    std::uint64_t sum = 0;
    boost::breadth_first_search(m_mesh, m_source,
                                boost::visitor(boost::make_bfs_visitor(Distances{ m_distance.data(), &sum }))
                                    .vertex_index_map(get(boost::vertex_index, m_mesh)));
    return static_cast<double>(sum);
  }

private:
  static constexpr std::uint32_t unseen = (std::numeric_limits<std::uint32_t>::max)();

  struct Distances
  {
    using event_filter = boost::on_tree_edge;
    std::uint32_t* distance;
    std::uint64_t* sum;

    template <class Edge>
    void operator()(Edge e, const Mesh& mesh) const
    {
      const std::uint32_t d = distance[source(e, mesh)] + 1;
      distance[target(e, mesh)] = d;
      *sum += d;
    }
  };

  void start()
  {
    m_distance.assign(m_distance.size(), unseen);
    m_distance[m_source] = 0;
  }

  const Mesh& m_mesh;
  Vertex m_source;
  std::vector<std::uint32_t> m_distance;
  std::vector<Vertex> m_queue;
};

} // namespace example

#endif // COMPACT_SURFACE_MESH_EXAMPLES_MESH_KERNELS_H
