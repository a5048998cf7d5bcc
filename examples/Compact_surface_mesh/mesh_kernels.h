// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef COMPACT_SURFACE_MESH_EXAMPLES_MESH_KERNELS_H
#define COMPACT_SURFACE_MESH_EXAMPLES_MESH_KERNELS_H

// The traversals that are timed. Each is written once, for any FaceListGraph, over four ways to
// go around a vertex and a face:
//   By_stars        whole stars, as Compact_surface_mesh offers them
//   By_ranges       CGAL's ranges
//   By_circulators  CGAL's circulators
//   By_operators    one operator at a time
// and returns a number that tells whether it did its work: the same for all meshes of the
// same surface, but for rounding, and for sum_over_faces() only if they number vertices alike.

#include "interleaved_times.h"

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <queue>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace example {

using CGAL::is_border; // for graphs of other namespaces

/// \name Ways Around
/// Those of `for_each_incident_triangle()` skip what is no face unless the mesh `is_closed`.
/// @{

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
    const auto first = halfedge(v, mesh);
    auto h = first;
    do {
      visit(source(h, mesh));
      h = opposite(next(h, mesh), mesh);
    } while (h != first);
  }

  template <class Vertex, class Mesh, class Visitor>
  static void for_each_incident_triangle(Vertex v, const Mesh& mesh, bool is_closed, Visitor visit)
  {
    const auto first = halfedge(v, mesh);
    auto h = first;
    do {
      const auto out = next(h, mesh);
      if (is_closed || !is_border(h, mesh))
        visit(target(out, mesh), source(h, mesh));
      h = opposite(out, mesh);
    } while (h != first);
  }

  template <class Face, class Mesh>
  static auto vertices_of_face(Face f, const Mesh& mesh)
  {
    using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
    const auto h0 = halfedge(f, mesh), h1 = next(h0, mesh), h2 = next(h1, mesh);
    return std::array<Vertex, 3>{ { target(h0, mesh), target(h1, mesh), target(h2, mesh) } };
  }
};

struct By_ranges
{
  template <class Vertex, class Mesh>
  static std::size_t degree(Vertex v, const Mesh& mesh)
  {
    const auto range = CGAL::halfedges_around_target(halfedge(v, mesh), mesh);
    return static_cast<std::size_t>(std::distance(range.begin(), range.end()));
  }

  template <class Vertex, class Mesh, class Visitor>
  static void for_each_adjacent_vertex(Vertex v, const Mesh& mesh, Visitor visit)
  {
    for (const auto u : CGAL::vertices_around_target(halfedge(v, mesh), mesh))
      visit(u);
  }

  template <class Vertex, class Mesh, class Visitor>
  static void for_each_incident_triangle(Vertex v, const Mesh& mesh, bool is_closed, Visitor visit)
  {
    for (const auto h : CGAL::halfedges_around_target(halfedge(v, mesh), mesh))
      if (is_closed || !is_border(h, mesh))
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

struct By_circulators
{
  template <class Vertex, class Mesh>
  static std::size_t degree(Vertex v, const Mesh& mesh)
  {
    std::size_t d = 0;
    const CGAL::Halfedge_around_target_circulator<Mesh> first(halfedge(v, mesh), mesh);
    auto it = first;
    do
      ++d;
    while (++it != first);
    return d;
  }

  template <class Vertex, class Mesh, class Visitor>
  static void for_each_adjacent_vertex(Vertex v, const Mesh& mesh, Visitor visit)
  {
    const CGAL::Vertex_around_target_circulator<Mesh> first(halfedge(v, mesh), mesh);
    auto it = first;
    do
      visit(*it);
    while (++it != first);
  }

  template <class Vertex, class Mesh, class Visitor>
  static void for_each_incident_triangle(Vertex v, const Mesh& mesh, bool is_closed, Visitor visit)
  {
    const CGAL::Halfedge_around_target_circulator<Mesh> first(halfedge(v, mesh), mesh);
    auto it = first;
    do
      if (is_closed || !is_border(*it, mesh))
        visit(target(next(*it, mesh), mesh), source(*it, mesh));
    while (++it != first);
  }

  template <class Face, class Mesh>
  static auto vertices_of_face(Face f, const Mesh& mesh)
  {
    std::array<typename boost::graph_traits<Mesh>::vertex_descriptor, 3> result;
    CGAL::Vertex_around_face_circulator<Mesh> it(halfedge(f, mesh), mesh);
    for (auto& v : result)
      v = *it++;
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
  static void for_each_incident_triangle(Vertex v, const Mesh& mesh, bool, Visitor visit)
  {
    mesh.for_each_incident_triangle(v, visit);
  }
};

/// `By_stars` if `Mesh` has them, otherwise `By_operators`, which asks no more than is needed.
template <class Mesh, class = void>
struct Fastest_way
{
  using type = By_operators;
};

template <class Mesh>
struct Fastest_way<Mesh, std::void_t<decltype(&Mesh::vertices_of_face)> >
{
  using type = By_stars;
};

/// calls `visit(u, v, w)` with the first three vertices of each face.
template <class Access, class Mesh, class Visitor>
void for_each_face(const Mesh& mesh, const Visitor& visit)
{
  if constexpr (std::is_same<Access, By_stars>::value)
    mesh.for_each_face([&](auto, auto u, auto v, auto w) { visit(u, v, w); });
  else
    for (const auto f : faces(mesh)) {
      const auto v = Access::vertices_of_face(f, mesh);
      visit(v[0], v[1], v[2]);
    }
}

/// @}

/// \name Kernels
/// @{

/// Degree: returns the sum of the squares of the degrees of all vertices in `range`.
template <class Access, class Mesh, class Range>
double sum_of_degrees(const Mesh& mesh, const Range& range)
{
  std::uint64_t sum = 0;
  for (const auto v : range) {
    const std::size_t d = Access::degree(v, mesh);
    sum += d * d;
  }
  return static_cast<double>(sum);
}

/// Degree, in the order in which vertices are stored.
template <class Access, class Mesh>
double sum_of_degrees(const Mesh& mesh) { return sum_of_degrees<Access>(mesh, vertices(mesh)); }

/// Vertex normals, weighted by area: returns the sum of their squared lengths.
template <class Access, class Mesh>
double sum_of_normals(const Mesh& mesh, bool is_closed)
{
  const auto point = get(CGAL::vertex_point, mesh);
  double sum = 0;
  for (const auto v : vertices(mesh)) {
    const auto p = get(point, v);
    double x = 0, y = 0, z = 0;
    Access::for_each_incident_triangle(v, mesh, is_closed, [&](auto u, auto w) {
      const auto a = get(point, u) - p, b = get(point, w) - p;
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
  for_each_face<Access>(mesh, [&](auto u, auto v, auto w) {
    const std::uint64_t a = label(u), b = label(v), c = label(w);
    sum += (a - b) * (b - c) * (c - a);
  });
  return static_cast<double>(sum >> 12); // exact
}

/// The numbers of the vertices of a mesh, from 0 on.
template <class Mesh>
class Vertex_numbers
{
public:
  explicit Vertex_numbers(const Mesh& mesh) : m_index(get(boost::vertex_index, mesh)) {}

  template <class Vertex>
  std::size_t operator()(Vertex v) const { return static_cast<std::size_t>(get(m_index, v)); }

private:
  decltype(get(boost::vertex_index, std::declval<const Mesh&>())) m_index;
};

/// Breadth-first search: returns the sum of all distances.
template <class Mesh>
class Breadth_first_search
{
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;

public:
  Breadth_first_search(const Mesh& mesh, Vertex source)
    : m_mesh(mesh), m_number(mesh), m_source(source), m_distance(num_vertices(mesh)), m_queue(num_vertices(mesh))
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
      const std::uint32_t d = m_distance[m_number(v)];
      sum += d;
      Access::for_each_adjacent_vertex(v, m_mesh, [&](Vertex u) {
        std::uint32_t& distance = m_distance[m_number(u)];
        if (distance == unseen) {
          distance = d + 1;
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
                                boost::visitor(boost::make_bfs_visitor(Distances{ m_number, m_distance.data(), &sum }))
                                    .vertex_index_map(get(boost::vertex_index, m_mesh)));
    return static_cast<double>(sum);
  }

private:
  static constexpr std::uint32_t unseen = (std::numeric_limits<std::uint32_t>::max)();

  struct Distances
  {
    using event_filter = boost::on_tree_edge;
    Vertex_numbers<Mesh> number;
    std::uint32_t* distance;
    std::uint64_t* sum;

    template <class Edge>
    void operator()(Edge e, const Mesh& mesh) const
    {
      const std::uint32_t d = distance[number(source(e, mesh))] + 1;
      distance[number(target(e, mesh))] = d;
      *sum += d;
    }
  };

  void start()
  {
    m_distance.assign(m_distance.size(), unseen);
    m_distance[m_number(m_source)] = 0;
  }

  const Mesh& m_mesh;
  Vertex_numbers<Mesh> m_number;
  Vertex m_source;
  std::vector<std::uint32_t> m_distance;
  std::vector<Vertex> m_queue;
};

/// Dijkstra's algorithm, with lengths of edges: returns the sum of all distances.
template <class Mesh>
class Shortest_paths
{
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;

public:
  Shortest_paths(const Mesh& mesh, Vertex source)
    : m_mesh(mesh), m_number(mesh), m_source(source), m_distance(num_vertices(mesh))
  {}

  template <class Access>
  double run()
  {
    const auto point = get(CGAL::vertex_point, m_mesh);
    using Entry = std::pair<double, Vertex>;
    const auto is_farther = [](const Entry& a, const Entry& b) { return a.first > b.first; };
    std::priority_queue<Entry, std::vector<Entry>, decltype(is_farther)> queue(is_farther);
    m_distance.assign(m_distance.size(), (std::numeric_limits<double>::max)());
    m_distance[m_number(m_source)] = 0;
    queue.push(Entry(0, m_source));
    double sum = 0;
    while (!queue.empty()) {
      const auto [distance, v] = queue.top();
      queue.pop();
      if (distance > m_distance[m_number(v)])
        continue;
      sum += distance;
      const double d = distance;
      const auto p = get(point, v);
      Access::for_each_adjacent_vertex(v, m_mesh, [&](Vertex u) {
        double& known = m_distance[m_number(u)];
        const double found = d + std::sqrt((get(point, u) - p).squared_length());
        if (found < known) {
          known = found;
          queue.push(Entry(found, u));
        }
      });
    }
    return sum;
  }

  /// the same by Boost.Graph.
  double run_by_boost()
  {
    const auto index = get(boost::vertex_index, m_mesh);
    boost::dijkstra_shortest_paths(m_mesh, m_source,
                                   boost::vertex_index_map(index).distance_map(
                                       boost::make_iterator_property_map(m_distance.begin(), index)));
    return std::accumulate(m_distance.begin(), m_distance.end(), 0.);
  }

private:
  const Mesh& m_mesh;
  Vertex_numbers<Mesh> m_number;
  Vertex m_source;
  std::vector<double> m_distance;
};

/// @}

/// \name Lists of Kernels
/// @{

/// A kernel on one mesh. `prepare()` does what is not timed; the memory for it is free again
/// when the function that it returns is destroyed.
struct Timed_kernel
{
  std::string name;
  std::string way;
  bool depends_on_numbers; ///< whether the result is the same only if vertices are numbered alike
  std::function<Timed_function()> prepare;
  double tolerance = 1e-9; ///< relative, of the result
};

/// Adds a kernel by whole stars, and by one operator at a time. `prepare(Access())` prepares it.
struct Stars_and_operators
{
  template <class Mesh, class Prepare>
  static void add(std::vector<Timed_kernel>& kernels, const std::string& name, bool depends_on_numbers,
                  const Prepare& prepare)
  {
    add_way(kernels, name, "stars", depends_on_numbers, prepare, typename Fastest_way<Mesh>::type());
    add_way(kernels, name, "operators", depends_on_numbers, prepare, By_operators());
  }

protected:
  template <class Prepare, class Access>
  static void add_way(std::vector<Timed_kernel>& kernels, const std::string& name, const std::string& way,
                      bool depends_on_numbers, const Prepare& prepare, Access access)
  {
    kernels.push_back({ name, way, depends_on_numbers, [=]() -> Timed_function { return prepare(access); } });
  }
};

/// Adds a kernel for each way.
struct Each_way : Stars_and_operators
{
  template <class Mesh, class Prepare>
  static void add(std::vector<Timed_kernel>& kernels, const std::string& name, bool depends_on_numbers,
                  const Prepare& prepare)
  {
    Stars_and_operators::add<Mesh>(kernels, name, depends_on_numbers, prepare);
    add_way(kernels, name, "ranges", depends_on_numbers, prepare, By_ranges());
    add_way(kernels, name, "circulators", depends_on_numbers, prepare, By_circulators());
  }
};

/// lists a search, in each way and by Boost.
template <class Search, class Labeled>
void add_search(std::vector<Timed_kernel>& kernels, const std::string& name,
                const std::shared_ptr<const Labeled>& labeled)
{
  const auto start = [labeled] { return std::make_shared<Search>(labeled->mesh, labeled->vertex_with_label(0)); };
  Each_way::add<decltype(labeled->mesh)>(kernels, name, false, [=](auto access) {
    return [search = start(), labeled] { return search->template run<decltype(access)>(); };
  });
  kernels.push_back({ name, "Boost", false, [=]() -> Timed_function {
                       return [search = start(), labeled] { return search->run_by_boost(); };
                     } });
}

/// lists the traversals that CD18 times, degrees and normals, of a `Labeled_mesh`, in the ways that `Ways` adds.
template <class Ways, class Labeled>
std::vector<Timed_kernel> degrees_and_normals(const std::shared_ptr<const Labeled>& labeled)
{
  using Mesh = std::remove_const_t<decltype(labeled->mesh)>;
  std::vector<Timed_kernel> kernels;
  Ways::template add<Mesh>(kernels, "degree", false, [=](auto access) {
    return [=] { return sum_of_degrees<decltype(access)>(labeled->mesh); };
  });
  Ways::template add<Mesh>(kernels, "vertex normals", false, [=](auto access) {
    return [=, is_closed = CGAL::is_closed(labeled->mesh)] {
      return sum_of_normals<decltype(access)>(labeled->mesh, is_closed);
    };
  });
  return kernels;
}

/// lists all traversals of a `Labeled_mesh`.
template <class Labeled>
std::vector<Timed_kernel> traversals(const std::shared_ptr<const Labeled>& labeled)
{
  using Mesh = std::remove_const_t<decltype(labeled->mesh)>;
  std::vector<Timed_kernel> kernels = degrees_and_normals<Each_way>(labeled);
  Each_way::add<Mesh>(kernels, "degree in random order", false, [=](auto access) {
    auto order = labeled->vertices_by_label();
    std::shuffle(order.begin(), order.end(), std::mt19937(1));
    return [=, order = std::move(order)] { return sum_of_degrees<decltype(access)>(labeled->mesh, order); };
  });
  Each_way::add<Mesh>(kernels, "vertices of faces", true, [=](auto access) {
    return [=] { return sum_over_faces<decltype(access)>(labeled->mesh, Vertex_numbers<Mesh>(labeled->mesh)); };
  });
  add_search<Breadth_first_search<Mesh> >(kernels, "breadth-first search", labeled);
  add_search<Shortest_paths<Mesh> >(kernels, "Dijkstra", labeled);
  return kernels;
}

/// @}

} // namespace example

#endif // COMPACT_SURFACE_MESH_EXAMPLES_MESH_KERNELS_H
