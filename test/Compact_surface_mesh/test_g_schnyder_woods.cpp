// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// g-Schnyder woods of surfaces of any genus.

#include "closed_surfaces.h"
#include "small_triangulations.h"
#include "test_scale.h"
#include "wooded_mesh.h"

#include <CGAL/Compact_surface_mesh/Mesh_defect_exception.h>
#include <CGAL/Schnyder_woods.h>
#include <CGAL/Schnyder_woods/internal/Extremal_wood_search.h>
#include <CGAL/Schnyder_woods/internal/Shelling.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using test::Edge;
using test::Face;
using test::Halfedge;
using test::Mesh;
using test::Vertex;
using test::Wooded_mesh;

// Shells components, each from its base to the next one, and makes the woods extremal.
void shell_all(const CGAL::Corner_table<std::uint32_t>& table, std::vector<std::uint32_t> bases,
               CGAL::internal::Schnyder_wood& wood, CGAL::Shelling_order order)
{
  const std::vector<std::uint32_t> no_further_roots;
  CGAL::internal::Shelling<std::uint32_t> shelling(table, wood, order);
  bases.push_back(static_cast<std::uint32_t>(table.num_halfedges()));
  for (std::size_t i = 0; i + 1 < bases.size(); ++i)
    ASSERT_TRUE(shelling(bases[i], no_further_roots, (bases[i + 1] - bases[i]) / 3, [](std::uint32_t) {}));
  CGAL::internal::Extremal_wood_search<std::uint32_t> search(table, wood);
  for (std::size_t i = 0; i + 1 < bases.size(); ++i)
    search.fix_roots(bases[i], no_further_roots);
  search.fix_cores();
  search(CGAL::Extremal_wood::WITHOUT_CLOCKWISE_FACES);
}

testing::AssertionResult has_right_woods(Wooded_mesh& wooded)
{
  for (const CGAL::Shelling_order order : test::all_orders) {
    wooded.shell(order);
    if (!wooded.is_right())
      return testing::AssertionFailure() << "order " << int(order) << ", root " << wooded.root << ", "
                                         << wooded.mesh.number_of_vertices() << " vertices, genus " << wooded.genus()
                                         << ", further roots: " << wooded.further_roots.size();
  }
  return testing::AssertionSuccess();
}

TEST(G_schnyder_woods, are_right_on_all_rooted_tori_with_up_to_9_vertices)
{
  for (int n = 7; n <= test::largest_exhaustive(); ++n)
    for (const auto& map : test::all_torus_triangulations(n))
      for (const auto& rooted : test::Oriented_map(map).all_codes()) {
        Mesh mesh = test::mesh_of(n, rooted);
        const Halfedge root = mesh.halfedge(Vertex(0), Vertex(1));
        Wooded_mesh wooded(std::move(mesh), root);
        ASSERT_TRUE(has_right_woods(wooded)) << testing::PrintToString(rooted);
        ASSERT_EQ(wooded.num_special_edges(), 2u);
      }
}

TEST(G_schnyder_woods, are_right_on_random_surfaces)
{
  for (unsigned int seed = 0; seed < test::scaled(600); ++seed) {
    const std::uint32_t genus = seed % 6, least = genus == 0 ? 4 : 4 * genus + 3;
    const std::uint32_t n = least + seed % 50;
    Mesh mesh = test::mesh_of(test::closed_surface(genus, n, seed));
    const Halfedge root = mesh.halfedge(Face(seed % mesh.number_of_faces()));
    Wooded_mesh wooded(std::move(mesh), root);
    ASSERT_TRUE(has_right_woods(wooded)) << "seed " << seed;
    ASSERT_EQ(wooded.num_special_edges(), 2 * genus);
  }
}

TEST(G_schnyder_woods, are_right_where_genus_is_large)
{
  for (const std::uint32_t genus : {30u, 100u})
    for (const std::uint32_t n : {4 * genus + 3, 40 * genus}) {
      Wooded_mesh wooded(test::mesh_of(test::closed_surface(genus, n, genus)));
      ASSERT_TRUE(has_right_woods(wooded));
      ASSERT_EQ(wooded.num_special_edges(), 2 * genus);
    }
}

TEST(G_schnyder_woods, are_right_on_regular_surfaces)
{
  const std::uint32_t n = static_cast<std::uint32_t>(test::scaled(20000));
  for (const test::Soup& soup : { test::torus_grid(3, n / 3), test::torus_grid(20, n / 20), test::scaffold(4, 1),
                                  test::chain_of_tori(n / 4), test::sphere_with_far_handles(n, n / 1000) }) {
    Wooded_mesh wooded(test::mesh_of(soup));
    ASSERT_TRUE(has_right_woods(wooded));
  }
}

TEST(G_schnyder_woods, may_have_further_roots)
{
  std::size_t num_roots = 0;
  for (unsigned int seed = 0; seed < test::scaled(600); ++seed) {
    const std::uint32_t genus = seed % 4, n = 30 + seed % 100;
    Mesh mesh = test::mesh_of(test::closed_surface(genus, n, seed));
    const Halfedge root = mesh.halfedge(Face(seed % mesh.number_of_faces()));
    std::vector<Vertex> further_roots = test::random_further_roots(mesh, root, 1 + seed % 6, seed);
    num_roots += further_roots.size();
    Wooded_mesh wooded(std::move(mesh), root, further_roots);
    ASSERT_TRUE(has_right_woods(wooded)) << "seed " << seed;
    ASSERT_EQ(wooded.num_special_edges(), 2 * genus + further_roots.size());
    for (const Vertex v : further_roots)
      for (const Halfedge h : halfedges_around_target(wooded.mesh.halfedge(v), wooded.mesh)) {
        ASSERT_EQ(wooded.color[h], 2);
        ASSERT_TRUE(wooded.outgoing[h]);
      }
  }
  EXPECT_GT(num_roots, test::scaled(600)) << "hardly any surface has further roots";
}

TEST(G_schnyder_woods, have_hundreds_of_roots)
{
  Mesh mesh = test::mesh_of(test::sphere_with_far_handles(static_cast<std::uint32_t>(test::scaled(10000)), 3));
  const Halfedge root(0);
  std::vector<Vertex> further_roots = test::random_further_roots(mesh, root, test::scaled(300), 1);
  Wooded_mesh wooded(std::move(mesh), root, further_roots);
  EXPECT_TRUE(has_right_woods(wooded));
}

TEST(G_schnyder_woods, are_Schnyder_woods_on_the_sphere)
{
  for (unsigned int seed = 0; seed < 20; ++seed)
    for (const CGAL::Shelling_order order : test::all_orders) {
      Wooded_mesh wooded(test::mesh_of(test::random_triangulation(50, seed)));
      wooded.shell(order);
      const auto color = wooded.mesh.add_property_map<Halfedge, int>("h:planar_color").first;
      const auto outgoing = wooded.mesh.add_property_map<Halfedge, bool>("h:planar_outgoing").first;
      CGAL::schnyder_wood(wooded.mesh, wooded.root, color, outgoing, order, 3);
      for (const Halfedge h : wooded.mesh.halfedges()) {
        ASSERT_EQ(color[h], wooded.color[h]);
        ASSERT_EQ(outgoing[h], wooded.outgoing[h]);
      }
      EXPECT_EQ(wooded.num_special_edges(), 0u);
    }
}

// The shelling and the search for extremal woods take one component after the other, in the
// same arrays.
TEST(G_schnyder_woods, of_components_are_those_of_each_component_alone)
{
  typedef CGAL::Corner_table<std::uint32_t> Table;
  for (const CGAL::Shelling_order order : { test::all_orders[0], test::all_orders[1] }) {
    test::Soup all{ 0, {} };
    std::vector<CGAL::internal::Schnyder_wood> alone;
    for (std::uint32_t i = 0; i < 30; ++i) {
      const test::Soup soup = test::closed_surface(i % 4, 20 + i, i);
      for (const test::Triangle t : soup.triangles)
        all.triangles.push_back({ t[0] + all.num_vertices, t[1] + all.num_vertices, t[2] + all.num_vertices });
      all.num_vertices += soup.num_vertices;
      const Table table(soup.num_vertices, soup.triangles);
      alone.emplace_back(table.num_halfedges());
      shell_all(table, { 0 }, alone.back(), order);
    }
    const Table table(all.num_vertices, all.triangles);
    std::vector<std::uint32_t> bases(1, 0);
    for (const auto& wood : alone)
      bases.push_back(static_cast<std::uint32_t>(bases.back() + wood.num_halfedges()));
    bases.pop_back();
    CGAL::internal::Schnyder_wood wood(table.num_halfedges());
    shell_all(table, bases, wood, order);
    for (std::size_t i = 0; i < alone.size(); ++i)
      for (std::size_t h = 0; h < alone[i].num_halfedges(); ++h) {
        ASSERT_EQ(wood.color(bases[i] + h), alone[i].color(h)) << "component " << i;
        ASSERT_EQ(wood.is_outgoing(bases[i] + h), alone[i].is_outgoing(h)) << "component " << i;
        ASSERT_EQ(wood.is_special(bases[i] + h), alone[i].is_special(h)) << "component " << i;
      }
  }
}

TEST(G_schnyder_woods, exist_on_a_polyhedron)
{
  typedef CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>> Polyhedron;
  typedef boost::graph_traits<Polyhedron> Traits;
  Polyhedron polyhedron;
  CGAL::copy_face_graph(test::mesh_of(test::torus_grid(4, 5)), polyhedron);
  std::map<Traits::halfedge_descriptor, int> colors;
  std::map<Traits::halfedge_descriptor, bool> directions;
  std::map<Traits::edge_descriptor, bool> special_edges;
  const boost::associative_property_map<decltype(colors)> color(colors);
  const boost::associative_property_map<decltype(directions)> outgoing(directions);
  const boost::associative_property_map<decltype(special_edges)> is_special(special_edges);
  const Traits::halfedge_descriptor root = *halfedges(polyhedron).begin();
  CGAL::g_schnyder_wood(polyhedron, root, color, outgoing, is_special);
  EXPECT_TRUE(CGAL::is_g_schnyder_wood(polyhedron, root, color, outgoing, is_special));
}

void expect_refused(Wooded_mesh& wooded, CGAL::Mesh_defect defect)
{
  try {
    wooded.shell();
    ADD_FAILURE() << "taken";
  } catch (const CGAL::Mesh_defect_exception& e) {
    EXPECT_EQ(e.defect(), defect);
  }
  EXPECT_EQ(wooded.color[wooded.root], 7) << "written in spite of the defect";
}

TEST(G_schnyder_woods, are_refused_on_what_is_no_connected_closed_triangulation)
{
  Wooded_mesh open(test::mesh_of(3, test::Triangles{{0, 1, 2}}));
  expect_refused(open, CGAL::Mesh_defect::border);
  test::Soup two = test::octasphere(0);
  for (const test::Triangle t : test::octasphere(0).triangles)
    two.triangles.push_back({t[0] + 6, t[1] + 6, t[2] + 6});
  two.num_vertices = 12;
  Wooded_mesh components(test::mesh_of(two));
  expect_refused(components, CGAL::Mesh_defect::several_components);
  test::Soup isolated = test::octasphere(0);
  ++isolated.num_vertices;
  Wooded_mesh vertex(test::mesh_of(isolated));
  expect_refused(vertex, CGAL::Mesh_defect::isolated_vertex);
}

TEST(G_schnyder_woods, are_refused_with_roots_that_are_close_to_each_other)
{
  const Mesh mesh = test::mesh_of(test::torus_grid(9, 9));
  const Halfedge root(0);
  const Vertex v2 = mesh.target(mesh.next(root));
  std::vector<Vertex> close{v2};
  for (const Vertex u : vertices_around_target(mesh.halfedge(v2), mesh)) {
    close.push_back(u);
    for (const Vertex w : vertices_around_target(mesh.halfedge(u), mesh))
      close.push_back(w);
  }
  for (const Vertex v : close) {
    Wooded_mesh wooded(mesh, root, {v});
    EXPECT_THROW(wooded.shell(), std::invalid_argument) << v;
    EXPECT_EQ(wooded.color[root], 7) << "written in spite of the defect";
  }
  const Vertex far = test::random_further_roots(mesh, root, 1, 1).at(0);
  Wooded_mesh twice(mesh, root, {far, far});
  EXPECT_THROW(twice.shell(), std::invalid_argument);
}

TEST(G_schnyder_woods, of_an_empty_mesh_are_empty)
{
  Wooded_mesh empty{Mesh()};
  empty.shell();
  EXPECT_TRUE(empty.is_right());
}

// The checker must find out whatever is changed in a right wood.
class The_checker_of_g_schnyder_woods : public testing::TestWithParam<int>
{
protected:
  The_checker_of_g_schnyder_woods() : wooded(mesh(), Halfedge(0), further_roots())
  {
    wooded.shell(CGAL::Shelling_order::RANDOM);
  }

  static Mesh mesh() { return test::mesh_of(test::closed_surface(GetParam(), 60, 1)); }
  static std::vector<Vertex> further_roots() { return test::random_further_roots(mesh(), Halfedge(0), 2, 1); }

  bool is_root_edge(Halfedge h) const { return wooded.color[h] == -1; }

  Wooded_mesh wooded;
};

TEST_P(The_checker_of_g_schnyder_woods, takes_the_wood_as_it_is)
{
  EXPECT_TRUE(wooded.is_right());
  EXPECT_FALSE(wooded.further_roots.empty());
}

TEST_P(The_checker_of_g_schnyder_woods, sees_another_color)
{
  for (const Halfedge h : wooded.mesh.halfedges())
    if (!is_root_edge(h))
      for (const int shift : {1, 2}) {
        const Halfedge o = wooded.mesh.opposite(h);
        const int c = wooded.color[h], co = wooded.color[o];
        wooded.color[h] = (c + shift) % 3;
        EXPECT_FALSE(wooded.is_right()) << "one copy of " << h;
        wooded.color[o] = (co + shift) % 3;
        EXPECT_FALSE(wooded.is_right()) << "both copies of " << h;
        wooded.color[h] = 3;
        wooded.color[o] = co;
        EXPECT_FALSE(wooded.is_right()) << "no color at " << h;
        wooded.color[h] = c;
      }
  EXPECT_TRUE(wooded.is_right());
}

TEST_P(The_checker_of_g_schnyder_woods, sees_another_direction)
{
  for (const Halfedge h : wooded.mesh.halfedges())
    if (!is_root_edge(h)) {
      const Halfedge o = wooded.mesh.opposite(h);
      wooded.outgoing[h] = !wooded.outgoing[h];
      EXPECT_FALSE(wooded.is_right()) << "one copy of " << h;
      wooded.outgoing[o] = !wooded.outgoing[o];
      EXPECT_FALSE(wooded.is_right()) << "both copies of " << h;
      wooded.outgoing[h] = !wooded.outgoing[h];
      wooded.outgoing[o] = !wooded.outgoing[o];
    }
  EXPECT_TRUE(wooded.is_right());
}

TEST_P(The_checker_of_g_schnyder_woods, sees_special_edges_elsewhere)
{
  for (const Edge e : wooded.mesh.edges()) {
    wooded.is_special[e] = !wooded.is_special[e];
    EXPECT_FALSE(wooded.is_right()) << e;
    wooded.is_special[e] = !wooded.is_special[e];
  }
  for (const Edge e : wooded.mesh.edges())
    for (const Edge to : wooded.mesh.edges())
      if (wooded.is_special[e] && !wooded.is_special[to]) {
        wooded.is_special[e] = false;
        wooded.is_special[to] = true;
        EXPECT_FALSE(wooded.is_right()) << e << " to " << to;
        wooded.is_special[e] = true;
        wooded.is_special[to] = false;
      }
  EXPECT_TRUE(wooded.is_right());
}

TEST_P(The_checker_of_g_schnyder_woods, sees_other_roots)
{
  const Wooded_mesh& w = wooded;
  for (const Halfedge h : w.mesh.halfedges())
    if (h != w.root) {
      try {
        EXPECT_FALSE(CGAL::is_g_schnyder_wood(w.mesh, h, w.color, w.outgoing, w.is_special,
                                             CGAL::Schnyder_wood_rules::LOCAL, w.further_roots))
          << h;
      } catch (const std::invalid_argument&) {} // too close to a further root
    }
  EXPECT_FALSE(CGAL::is_g_schnyder_wood(w.mesh, w.root, w.color, w.outgoing, w.is_special));
}

INSTANTIATE_TEST_SUITE_P(Of_genus, The_checker_of_g_schnyder_woods, testing::Values(0, 1, 3));

} // namespace
