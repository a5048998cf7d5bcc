// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Schnyder woods, canonical orderings and drawings of triangulated spheres.

#include "generated_triangulations.h"
#include "small_triangulations.h"
#include "test_scale.h"
#include "wooded_mesh.h"

#include <CGAL/Schnyder_woods.h>
#include <CGAL/Compact_surface_mesh/Mesh_defect_exception.h>
#include <CGAL/Compact_surface_mesh/internal/versions_of_cgal.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace {

using test::Halfedge;
using test::Mesh;
using test::Point;
using test::Vertex;
using test::all_orders;
using test::mesh_of;
typedef Mesh::Property_map<Halfedge, int> Color_map;
typedef Mesh::Property_map<Halfedge, bool> Outgoing_map;
typedef std::array<std::size_t, 3> Coordinates;

struct Wood
{
  Wood(Mesh& mesh, Halfedge root, CGAL::Shelling_order order, unsigned int seed = 3)
    : color(mesh.add_property_map<Halfedge, int>("h:color", 7).first),
      outgoing(mesh.add_property_map<Halfedge, bool>("h:outgoing", true).first)
  {
    CGAL::schnyder_wood(mesh, root, color, outgoing, order, seed);
  }

  Color_map color;
  Outgoing_map outgoing;
};

// Whether the first k vertices of the ordering always are a disk on whose boundary the
// next vertex sees a path, straight from the definition. Quadratic time.
bool is_canonical_ordering(const Mesh& mesh, Halfedge root, const std::vector<Vertex>& order)
{
  if (order.size() != mesh.number_of_vertices() || order[0] != mesh.target(root) ||
      order[1] != mesh.source(root) || order.back() != mesh.target(mesh.next(root)))
    return false;
  std::vector<std::size_t> rank(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    rank[order[k]] = k;
  // the boundary from V_0 to V_1 around the outer face
  std::vector<Vertex> boundary = { order[0], order[1] };
  for (std::size_t k = 2; k < order.size(); ++k) {
    std::set<Vertex> neighbors;
    for (const Vertex u : vertices_around_target(mesh.halfedge(order[k]), mesh))
      if (rank[u] < k)
        neighbors.insert(u);
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < boundary.size(); ++i)
      if (neighbors.count(boundary[i]))
        places.push_back(i);
    if (places.size() != neighbors.size() || places.size() < 2 ||
        places.back() - places.front() + 1 != places.size())
      return false;
    boundary.erase(boundary.begin() + places.front() + 1, boundary.begin() + places.back());
    boundary.insert(boundary.begin() + places.front() + 1, order[k]);
  }
  return boundary.size() == 3;
}

// Whether all faces but the root face have the same orientation in the plane: with
// straight edges inside a triangle that means that no two of them cross.
bool is_plane_drawing(const Mesh& mesh, Halfedge root, const std::vector<Coordinates>& position)
{
  int sign = 0;
  for (const auto f : mesh.faces()) {
    if (f == mesh.face(root))
      continue;
    std::vector<std::array<long long, 2>> p;
    for (const Vertex v : vertices_around_face(mesh.halfedge(f), mesh))
      p.push_back({ static_cast<long long>(position[v][0]), static_cast<long long>(position[v][1]) });
    const long long area = (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]);
    const int s = area > 0 ? 1 : area < 0 ? -1 : 0;
    if (s == 0 || (sign != 0 && s != sign))
      return false;
    sign = s;
  }
  return true;
}

// The faces in the region of each color, by a flood from one of its faces that does not
// cross the paths from v. Quadratic time for all vertices.
Coordinates regions_by_flooding(const Mesh& mesh, Halfedge root, const Wood& wood, Vertex v)
{
  std::set<CGAL::SM_Edge_index> walls;
  std::array<Halfedge, 3> out;
  for (const Halfedge start : halfedges_around_target(mesh.halfedge(v), mesh)) {
    Halfedge h = mesh.opposite(start);
    if (!wood.outgoing[h])
      continue;
    const int c = wood.color[h];
    out[c] = h;
    for (;;) {
      walls.insert(mesh.edge(h));
      Halfedge following;
      for (const Halfedge g : halfedges_around_target(h, mesh))
        if (wood.outgoing[mesh.opposite(g)] && wood.color[mesh.opposite(g)] == c)
          following = mesh.opposite(g);
      if (following == Halfedge())
        break;
      h = following;
    }
  }
  Coordinates count = { 0, 0, 0 };
  for (int i = 0; i < 3; ++i) {
    // counterclockwise around v the region off path i starts at the edge out of color i + 1
    std::set<CGAL::SM_Face_index> seen = { mesh.face(root), mesh.face(out[(i + 1) % 3]) };
    std::vector<CGAL::SM_Face_index> stack = { mesh.face(out[(i + 1) % 3]) };
    while (!stack.empty()) {
      const auto f = stack.back();
      stack.pop_back();
      ++count[i];
      for (const Halfedge h : halfedges_around_face(mesh.halfedge(f), mesh))
        if (!walls.count(mesh.edge(h)) && seen.insert(mesh.face(mesh.opposite(h))).second)
          stack.push_back(mesh.face(mesh.opposite(h)));
    }
  }
  return count;
}

std::vector<Coordinates> drawing_of(Mesh& mesh, Halfedge root, const Wood& wood)
{
  auto coordinates = mesh.add_property_map<Vertex, Coordinates>("v:coordinates").first;
  CGAL::schnyder_drawing(mesh, root, wood.color, wood.outgoing, coordinates);
  return std::vector<Coordinates>(coordinates.begin(), coordinates.end());
}

void expect_all_is_right(Mesh mesh, Halfedge root, CGAL::Shelling_order order)
{
  const std::size_t n = mesh.number_of_vertices();
  const Wood wood(mesh, root, order);
  ASSERT_TRUE(CGAL::is_schnyder_wood(mesh, root, wood.color, wood.outgoing));
  for (const Halfedge h : { root, mesh.next(root), mesh.prev(root) }) {
    ASSERT_EQ(wood.color[h], -1);
    ASSERT_EQ(wood.color[mesh.opposite(h)], -1);
    ASSERT_FALSE(wood.outgoing[h]);
  }
  for (const Coordinates& c : drawing_of(mesh, root, wood))
    ASSERT_EQ(c[0] + c[1] + c[2], 2 * n - 5);
  ASSERT_TRUE(is_plane_drawing(mesh, root, drawing_of(mesh, root, wood)));
}

TEST(Schnyder_woods, are_right_on_all_rooted_triangulations_with_up_to_9_vertices)
{
  for (int n = 4; n <= test::largest_exhaustive(); ++n)
    for (const auto& map : test::all_sphere_triangulations(n))
      for (const auto& rooted : test::Oriented_map(map).all_codes()) {
        Mesh mesh = mesh_of(n, rooted);
        const Halfedge root = mesh.halfedge(Vertex(0), Vertex(1));
        for (const CGAL::Shelling_order order : all_orders) {
          SCOPED_TRACE(testing::PrintToString(rooted));
          expect_all_is_right(mesh, root, order);
          std::vector<Vertex> ordering;
          CGAL::canonical_ordering(mesh, root, std::back_inserter(ordering), order, 3);
          ASSERT_TRUE(is_canonical_ordering(mesh, root, ordering));
        }
        if (testing::Test::HasFailure())
          return;
      }
}

TEST(Schnyder_woods, are_right_on_larger_triangulations)
{
  const std::uint32_t n = static_cast<std::uint32_t>(test::scaled(20000));
  CGAL::Random random(11);
  for (Mesh mesh : { mesh_of(n, CGAL::random_planar_triangulation(n, random)), mesh_of(test::octasphere(4)),
                     mesh_of(test::stacked_triangulation(n, 5)), mesh_of(test::stacked_at_hub(n / 10)),
                     mesh_of(test::shuffled(test::double_wheel(n / 10), 2)) })
    for (const CGAL::Shelling_order order : all_orders)
      for (const unsigned int face : { 0u, mesh.number_of_faces() / 2 })
        expect_all_is_right(mesh, mesh.halfedge(CGAL::SM_Face_index(face)), order);
}

TEST(Schnyder_woods, draw_a_vertex_by_the_faces_in_its_regions)
{
  CGAL::Random random(2);
  for (int i = 0; i < 20; ++i) {
    Mesh mesh = mesh_of(30, CGAL::random_planar_triangulation(30, random));
    const Halfedge root = mesh.halfedge(CGAL::SM_Face_index(i));
    const Wood wood(mesh, root, CGAL::Shelling_order::RANDOM, i);
    const std::vector<Coordinates> drawing = drawing_of(mesh, root, wood);
    for (const Vertex v : mesh.vertices())
      if (v != mesh.source(root) && v != mesh.target(root) && v != mesh.target(mesh.next(root))) {
        ASSERT_EQ(drawing[v], regions_by_flooding(mesh, root, wood, v)) << "mesh " << i << ", vertex " << v;
      }
    const Coordinates corner = { 55, 0, 0 };
    EXPECT_EQ(drawing[mesh.target(root)], corner);
  }
}

TEST(Schnyder_woods, take_the_first_face_where_no_root_is_given)
{
  Mesh mesh = mesh_of(test::octasphere(2));
  auto color = mesh.add_property_map<Halfedge, int>("h:color").first;
  auto outgoing = mesh.add_property_map<Halfedge, bool>("h:outgoing").first;
  const Halfedge root = CGAL::schnyder_wood(mesh, color, outgoing);
  EXPECT_EQ(root, mesh.halfedge(*mesh.faces().begin()));
  EXPECT_TRUE(CGAL::is_schnyder_wood(mesh, root, color, outgoing));
}

TEST(Schnyder_woods, depend_on_the_order_of_conquests)
{
  Mesh mesh = mesh_of(test::octasphere(3));
  const Halfedge root = mesh.halfedge(CGAL::SM_Face_index(0));
  std::set<std::vector<int>> woods;
  for (const CGAL::Shelling_order order : all_orders) {
    Mesh copy = mesh;
    const Wood wood(copy, root, order);
    woods.insert(std::vector<int>(wood.color.begin(), wood.color.end()));
  }
  EXPECT_EQ(woods.size(), 3u);
}

TEST(Schnyder_woods, exist_on_a_mesh_with_removed_elements)
{
  Mesh mesh = mesh_of(test::octasphere(1));
  const Vertex extra = mesh.add_vertex(Point(1, 1, 1));
  mesh.remove_vertex(extra);
  mesh.remove_vertex(mesh.add_vertex(Point(2, 2, 2)));
  Mesh::Halfedge_index root = mesh.halfedge(CGAL::SM_Face_index(0));
  const Wood wood(mesh, root, CGAL::Shelling_order::LAST_IN_FIRST_OUT);
  EXPECT_TRUE(CGAL::is_schnyder_wood(mesh, root, wood.color, wood.outgoing));
}

TEST(Schnyder_woods, are_refused_on_what_is_no_triangulated_sphere)
{
  Mesh open = mesh_of(3, std::vector<std::array<std::uint32_t, 3>>{ { 0, 1, 2 } });
  std::vector<std::array<std::uint32_t, 3>> torus; // the triangulation with 7 vertices
  for (std::uint32_t i = 0; i < 7; ++i) {
    torus.push_back({ i, (i + 1) % 7, (i + 3) % 7 });
    torus.push_back({ i, (i + 3) % 7, (i + 2) % 7 });
  }
  Mesh handle = mesh_of(7, torus);
  const std::pair<Mesh*, CGAL::Mesh_defect> refused[] = { { &open, CGAL::Mesh_defect::border },
                                                          { &handle, CGAL::Mesh_defect::positive_genus } };
  for (const auto& r : refused) {
    Mesh& mesh = *r.first;
    try {
      Wood(mesh, mesh.halfedge(CGAL::SM_Face_index(0)), CGAL::Shelling_order::LAST_IN_FIRST_OUT);
      ADD_FAILURE() << "taken";
    } catch (const CGAL::Mesh_defect_exception& e) {
      EXPECT_EQ(e.defect(), r.second);
    }
    for (const Halfedge h : mesh.halfedges())
      EXPECT_EQ((*CGAL::internal::optional_map(mesh.property_map<Halfedge, int>("h:color")))[h], 7)
        << "written in spite of the defect";
  }
}

TEST(The_checker_of_woods, sees_every_single_change)
{
  Mesh mesh = mesh_of(test::octasphere(2));
  const Halfedge root = mesh.halfedge(CGAL::SM_Face_index(0));
  const Wood wood(mesh, root, CGAL::Shelling_order::RANDOM);
  ASSERT_TRUE(CGAL::is_schnyder_wood(mesh, root, wood.color, wood.outgoing));
  for (const Halfedge h : mesh.halfedges()) {
    if (wood.color[h] == -1)
      continue;
    const Halfedge o = mesh.opposite(h);
    const int c = wood.color[h];
    const bool out = wood.outgoing[h];
    wood.color[h] = wood.color[o] = (c + 1) % 3;
    EXPECT_FALSE(CGAL::is_schnyder_wood(mesh, root, wood.color, wood.outgoing)) << "color of " << h;
    wood.color[h] = wood.color[o] = c;
    wood.outgoing[h] = !out;
    EXPECT_FALSE(CGAL::is_schnyder_wood(mesh, root, wood.color, wood.outgoing)) << "one direction of " << h;
    wood.outgoing[o] = out;
    EXPECT_FALSE(CGAL::is_schnyder_wood(mesh, root, wood.color, wood.outgoing)) << "direction of " << h;
    wood.outgoing[h] = out;
    wood.outgoing[o] = !out;
  }
}

} // namespace
