// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_WOODED_MESH_H
#define TEST_COMPACT_SURFACE_MESH_WOODED_MESH_H

// Surface meshes of the generated surfaces, and woods on them.

#include "generated_triangulations.h"
#include "shelling_orders.h"

#include <CGAL/Schnyder_woods/g_schnyder_wood.h>
#include <CGAL/Schnyder_woods/is_schnyder_wood.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace test {

typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Halfedge_index Halfedge;
typedef Mesh::Edge_index Edge;
typedef Mesh::Face_index Face;

template <class Triangles>
Mesh mesh_of(std::size_t n, const Triangles& triangles)
{
  Mesh mesh;
  for (std::size_t i = 0; i < n; ++i)
    mesh.add_vertex(Point(0, 0, 0));
  for (const auto& t : triangles)
    mesh.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
  return mesh;
}

inline Mesh mesh_of(const Soup& soup)
{
  return mesh_of(soup.num_vertices, soup.triangles);
}

/// A mesh with maps for a g-Schnyder wood. At first they hold nothing that is one.
struct Wooded_mesh
{
  explicit Wooded_mesh(Mesh m, Halfedge r = Halfedge(0), std::vector<Vertex> further = {})
    : mesh(std::move(m)),
      root(r),
      further_roots(std::move(further)),
      color(mesh.add_property_map<Halfedge, int>("h:color", 7).first),
      outgoing(mesh.add_property_map<Halfedge, bool>("h:outgoing", true).first),
      is_special(mesh.add_property_map<Edge, bool>("e:is_special", true).first)
  {}

  Wooded_mesh(const Wooded_mesh&) = delete;

  void shell(CGAL::Shelling_order order = CGAL::Shelling_order::LAST_IN_FIRST_OUT, unsigned int seed = 3)
  {
    CGAL::g_schnyder_wood(mesh, root, color, outgoing, is_special, order, seed, further_roots);
  }

  bool is_right(CGAL::Schnyder_wood_rules rules = CGAL::Schnyder_wood_rules::CELLULAR) const
  {
    return CGAL::is_g_schnyder_wood(mesh, root, color, outgoing, is_special, rules, further_roots);
  }

  std::size_t num_special_edges() const
  {
    std::size_t count = 0;
    for (const Edge e : mesh.edges())
      count += is_special[e] ? 1 : 0;
    return count;
  }

  std::size_t genus() const
  {
    return (2 + mesh.number_of_edges() - mesh.number_of_vertices() - mesh.number_of_faces()) / 2;
  }

  Mesh mesh;
  Halfedge root;
  std::vector<Vertex> further_roots;
  Mesh::Property_map<Halfedge, int> color;
  Mesh::Property_map<Halfedge, bool> outgoing;
  Mesh::Property_map<Edge, bool> is_special;
};

/// Up to `num_roots` random vertices. No vertex is equal or adjacent to two of them and the
/// vertex opposite to halfedge `root`.
inline std::vector<Vertex> random_further_roots(const Mesh& mesh, Halfedge root, std::size_t num_roots,
                                                unsigned int seed)
{
  std::mt19937 rng(seed);
  std::vector<bool> is_taken(mesh.number_of_vertices(), false);
  const auto star = [&](Vertex v) {
    std::vector<Vertex> vertices{v};
    for (const Vertex u : vertices_around_target(mesh.halfedge(v), mesh))
      vertices.push_back(u);
    return vertices;
  };
  const auto take = [&](Vertex v) {
    for (const Vertex u : star(v))
      is_taken[u] = true;
  };
  take(mesh.target(mesh.next(root)));
  std::vector<Vertex> roots;
  for (std::size_t tries = 10 * num_roots; tries > 0 && roots.size() < num_roots; --tries) {
    const Vertex v(static_cast<std::uint32_t>(rng() % mesh.number_of_vertices()));
    const std::vector<Vertex> vertices = star(v);
    if (std::any_of(vertices.begin(), vertices.end(), [&](Vertex u) { return is_taken[u]; }))
      continue;
    take(v);
    roots.push_back(v);
  }
  return roots;
}

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_WOODED_MESH_H
