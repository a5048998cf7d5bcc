// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Simple_triangulation, made of polygon soups and of graphs: that it is simple, that what is
// not hidden of it is the user's mesh, and what it refuses.

#include "damaged_soups.h"
#include "generated_surfaces.h"
#include "glued_polygons.h"
#include "refusals.h"
#include "simple_triangulation_oracle.h"
#include "soup_oracle.h"
#include "test_scale.h"

#include <CGAL/Compact_surface_mesh/Simple_triangulation.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iostream>
#include <limits>
#include <list>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using CGAL::Corner_table;
using CGAL::Mesh_defect;
using CGAL::Simple_triangulation;
using test::Defect;
using test::Glued_polygons;
using test::Polygon_soup;
using test::error_of_triangulation;
using test::refusal;
using test::text;
using test::thrown_by;

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;

template <class Index = std::uint32_t>
Simple_triangulation<Index> simple(const Polygon_soup& soup)
{
  return Simple_triangulation<Index>(soup.num_vertices, soup.faces);
}

template <class Index = std::uint32_t>
Simple_triangulation<Index> simple(const Surface_mesh& mesh)
{
  return Simple_triangulation<Index>(mesh, get(boost::vertex_index, mesh));
}

template <class Index = std::uint32_t>
Simple_triangulation<Index> simple(const Glued_polygons& polygons)
{
  return simple<Index>(test::graph_of<Surface_mesh>(polygons));
}

std::size_t num_centers(const Simple_triangulation<>& simple)
{
  return static_cast<std::size_t>(std::count(simple.stands_for().begin(), simple.stands_for().end(),
                                             Corner_table<>::null()));
}

std::size_t num_splits(const Simple_triangulation<>& simple)
{
  return simple.stands_for().size() - num_centers(simple);
}

// Whether the two hold the same.
bool are_equal(const Simple_triangulation<>& a, const Simple_triangulation<>& b)
{
  const Corner_table<>&s = a.table(), &t = b.table();
  bool equal = s.num_vertices() == t.num_vertices() && s.num_halfedges() == t.num_halfedges()
               && a.num_user_vertices() == b.num_user_vertices() && a.num_user_faces() == b.num_user_faces()
               && a.stands_for() == b.stands_for();
  for (std::uint32_t h = 0; equal && h < s.num_halfedges(); ++h)
    equal = s.source(h) == t.source(h) && s.opposite(h) == t.opposite(h) && a.is_hidden(h) == b.is_hidden(h)
            && a.face_of_triangle(h / 3) == b.face_of_triangle(h / 3);
  return equal;
}

// A prism over a polygon of `k` sides.
Polygon_soup prism(std::size_t k)
{
  Polygon_soup soup{2 * k, {{}, {}}};
  const long long n = static_cast<long long>(k);
  for (long long i = 0; i < n; ++i) {
    soup.faces[0].push_back(n - 1 - i);
    soup.faces[1].push_back(n + i);
    soup.faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  return soup;
}

// The quads between two circles of `k` vertices.
Polygon_soup annulus(std::size_t k)
{
  Polygon_soup soup = prism(k);
  soup.faces.erase(soup.faces.begin(), soup.faces.begin() + 2);
  return soup;
}

// Quads around two hubs, each of degree `k`, which are the last vertices.
Polygon_soup quads_around_hubs(std::size_t k)
{
  const long long n = 2 * static_cast<long long>(k);
  Polygon_soup soup{2 * k + 2, {}};
  for (long long i = 0; i < n; i += 2) {
    soup.faces.push_back({n, i, i + 1, (i + 2) % n});
    soup.faces.push_back({n + 1, (i + 3) % n, (i + 2) % n, i + 1});
  }
  return soup;
}

Polygon_soup moebius_strip(std::size_t k, bool triangles)
{
  Polygon_soup soup{2 * k, {}};
  const long long n = static_cast<long long>(k);
  for (long long i = 0; i < n; ++i) {
    const long long a = i, d = n + i, b = i + 1 < n ? i + 1 : n, c = i + 1 < n ? n + i + 1 : 0;
    if (triangles) {
      soup.faces.push_back({a, b, c});
      soup.faces.push_back({a, c, d});
    } else
      soup.faces.push_back({a, b, c, d});
  }
  return soup;
}

std::vector<Polygon_soup> small_polygon_surfaces()
{
  std::vector<Polygon_soup> surfaces = test::small_surfaces();
  for (const std::size_t k : {3, 4, 5, 6, 7, 8, 9, 12})
    for (const Polygon_soup& soup : {test::polygon(k), test::pillow(k), prism(k), annulus(k), quads_around_hubs(k)})
      surfaces.push_back(soup);
  for (const std::size_t n : {5, 6, 8, 9})
    for (std::size_t s = 2; s < n; ++s) {
      const Polygon_soup soup = test::helical_torus(n, s, false).soup;
      if (thrown_by([&] { simple(soup); }).empty()) // it has no double edges
        surfaces.push_back(soup);
    }
  return surfaces;
}

// What Simple_triangulation does wrong with `soup`, or nothing. `met` counts the defects that it names.
std::string error_of_construction(const Polygon_soup& soup, test::Thrown_counts& met)
{
  const std::set<Defect> defects = test::Soup_oracle(soup).polygon_defects();
  Simple_triangulation<> made;
  const std::string error = test::error_of_refusal(defects, thrown_by([&] { made = simple(soup); }), met);
  return error.empty() && defects.empty() ? error_of_triangulation(made, soup) : error;
}

} // namespace

TEST(Simple_triangulation, of_triangles_is_their_corner_table_and_hides_nothing)
{
  for (const Polygon_soup& soup : test::small_surfaces()) {
    const Simple_triangulation<> made = simple(soup);
    ASSERT_EQ("", test::Soup_oracle(soup).difference(made.table())) << soup;
    ASSERT_FALSE(made.has_hidden());
    ASSERT_EQ("", error_of_triangulation(made, soup)) << soup;
    ASSERT_TRUE(are_equal(made, Corner_table<>(soup.num_vertices, soup.faces))) << soup;
    ASSERT_TRUE(are_equal(made, simple(test::glued_by_ends(soup)))) << soup;
  }
}

TEST(Simple_triangulation, of_nothing_is_empty)
{
  const Simple_triangulation<> none;
  EXPECT_EQ(0u, none.num_user_vertices() + none.num_user_faces() + none.table().num_halfedges());
  EXPECT_FALSE(none.has_hidden());
  EXPECT_TRUE(are_equal(none, simple(Polygon_soup{0, {}})));
  EXPECT_TRUE(are_equal(none, simple(Surface_mesh())));
  EXPECT_EQ(7u, simple(Polygon_soup{7, {}}).num_user_vertices());
}

TEST(Simple_triangulation, holds_the_polygons_of_any_range_of_ranges_of_integers)
{
  const Polygon_soup soup{6, {{0, 1, 2}, {2, 1, 3, 4}, {4, 3, 5}}};
  std::list<std::list<short>> lists_of_short;
  std::vector<std::vector<unsigned char>> vectors_of_char;
  for (const auto& face : soup.faces) {
    lists_of_short.emplace_back(face.begin(), face.end());
    vectors_of_char.emplace_back(face.begin(), face.end());
  }
  const int quads[2][4] = {{0, 1, 2, 3}, {3, 2, 4, 5}};
  EXPECT_EQ("", error_of_triangulation(simple(soup), soup));
  EXPECT_TRUE(are_equal(simple(soup), Simple_triangulation<>(6, lists_of_short)));
  EXPECT_TRUE(are_equal(simple(soup), Simple_triangulation<>(6, vectors_of_char)));
  EXPECT_EQ("", error_of_triangulation(Simple_triangulation<>(6, quads),
                                       Polygon_soup{6, {{0, 1, 2, 3}, {3, 2, 4, 5}}}));
}

TEST(Simple_triangulation, of_small_polygon_meshes_is_the_same_mesh)
{
  std::mt19937 rng(1);
  for (const Polygon_soup& surface : small_polygon_surfaces())
    for (int repetition = 0; repetition < 10; ++repetition) {
      const Polygon_soup soup = repetition == 0 ? surface : test::shuffled(surface, rng);
      ASSERT_EQ("nothing", refusal([&] { simple(soup); })) << soup;
      const Simple_triangulation<> made = simple(soup);
      ASSERT_EQ("", error_of_triangulation(made, soup)) << soup;
      ASSERT_TRUE(are_equal(made, simple(test::glued_by_ends(soup)))) << soup;
      ASSERT_EQ("", error_of_triangulation(simple<std::uint8_t>(soup), soup)) << soup;
      ASSERT_EQ("", error_of_triangulation(simple<std::uint64_t>(soup), soup)) << soup;
    }
}

TEST(Simple_triangulation, has_no_center_where_a_fan_will_do)
{
  EXPECT_EQ(0u, num_centers(simple(test::polygon(8))));
  EXPECT_EQ(1u, num_centers(simple(test::polygon(9))));
  EXPECT_EQ(0u, num_centers(simple(test::pillow(4)))); // the two diagonals of the quad
  EXPECT_EQ(0u, num_centers(simple(test::pillow(6))));
  // both quads want the diagonal of 0 and 1
  EXPECT_EQ(0u, num_centers(simple(Polygon_soup{6, {{0, 2, 1, 3}, {0, 4, 1, 5}}})));
  EXPECT_EQ(0u, num_centers(simple(quads_around_hubs(20))));
  const Polygon_soup complete = test::helical_torus(5, 2, false).soup; // all vertices are adjacent
  EXPECT_EQ(5u, num_centers(simple(complete)));
  EXPECT_EQ("", error_of_triangulation(simple(complete), complete));
}

TEST(Simple_triangulation, splits_the_edges_of_tiny_tori)
{
  const auto splits = [](std::size_t n, std::size_t s, bool triangles) {
    const Glued_polygons torus = test::helical_torus(n, s, triangles);
    const Simple_triangulation<> made = simple(torus);
    EXPECT_EQ("", error_of_triangulation(made, torus)) << torus;
    return num_splits(made);
  };
  EXPECT_EQ(6u, splits(3, 2, true)); // 9 edges, 3 pairs of ends
  EXPECT_EQ(6u, splits(4, 2, true)); // 12 edges, 6 pairs of ends
  EXPECT_EQ(3u, splits(6, 3, true)); // vertex k+3 is k-3
  EXPECT_EQ(0u, splits(7, 3, true));
  EXPECT_EQ(2u, splits(4, 2, false));
  EXPECT_EQ(0u, splits(5, 2, false));
  EXPECT_EQ(4u, splits(8, 4, false));
}

TEST(Simple_triangulation, takes_border_edges_with_the_same_ends_for_two)
{
  Glued_polygons apart = test::glued_by_ends({3, {{0, 1, 2}, {0, 2, 1}}});
  ASSERT_FALSE(simple(apart).has_hidden());
  test::Glued_polygons pillow = apart;
  for (int num_unglued = 1; num_unglued <= 3; ++num_unglued) {
    apart.opposite[pillow.opposite[num_unglued - 1]] = Glued_polygons::none;
    apart.opposite[num_unglued - 1] = Glued_polygons::none;
    EXPECT_EQ(std::size_t(num_unglued), num_splits(simple(apart)));
    EXPECT_EQ("", error_of_triangulation(simple(apart), apart)) << apart;
  }
  const Surface_mesh mesh = test::graph_of<Surface_mesh>(apart);
  EXPECT_EQ(text(Mesh_defect::double_edge, 0), refusal([&] { Corner_table<>(mesh, get(boost::vertex_index, mesh)); }));
  Glued_polygons same_direction{{4, {{0, 1, 2}, {0, 1, 3}}}, std::vector<std::size_t>(6, Glued_polygons::none)};
  EXPECT_EQ("", error_of_triangulation(simple(same_direction), same_direction));
  const Surface_mesh second = test::graph_of<Surface_mesh>(same_direction);
  EXPECT_EQ(Mesh_defect::double_edge,
            thrown_by([&] { Corner_table<>(second, get(boost::vertex_index, second)); }).at(0).first);
}

TEST(Simple_triangulation, of_random_surfaces_is_the_same_mesh)
{
  test::Surface_options options;
  for (unsigned int seed = 0; seed < (std::max<std::size_t>)(100, test::scaled(3000)); ++seed) {
    const Polygon_soup soup = test::random_surface(seed, options);
    const Simple_triangulation<> made = simple(soup);
    ASSERT_EQ("", error_of_triangulation(made, soup)) << "seed " << seed << ", " << soup;
    ASSERT_TRUE(are_equal(made, simple(test::glued_by_ends(soup)))) << "seed " << seed << ", " << soup;
  }
}

TEST(Simple_triangulation, of_randomly_glued_polygons_is_the_same_mesh)
{
  std::size_t total_splits = 0, total_centers = 0;
  const std::size_t num_meshes = (std::max<std::size_t>)(2000, test::scaled(30000));
  for (unsigned int seed = 0; seed < num_meshes; ++seed) {
    std::mt19937 rng(seed);
    const Glued_polygons polygons = test::random_glued_polygons(rng);
    const Simple_triangulation<> made = simple(polygons);
    ASSERT_EQ("", error_of_triangulation(made, polygons)) << "seed " << seed << ", " << polygons;
    total_splits += num_splits(made);
    total_centers += num_centers(made);
  }
  EXPECT_LT(num_meshes, total_splits);
  EXPECT_LT(num_meshes / 10, total_centers);
}

TEST(Simple_triangulation, of_a_surface_mesh_follows_the_order_of_faces_and_halfedges)
{
  Surface_mesh mesh;
  CGAL::make_grid(5, 4, mesh);
  CGAL::Euler::split_face(mesh.halfedge(Surface_mesh::Face_index(3)),
                          mesh.next(mesh.next(mesh.halfedge(Surface_mesh::Face_index(3)))), mesh);
  CGAL::Euler::remove_face(mesh.halfedge(Surface_mesh::Face_index(7)), mesh);
  const auto inner = std::find_if(mesh.halfedges().begin(), mesh.halfedges().end(),
                                  [&](auto h) { return !mesh.is_border(mesh.edge(h)); });
  CGAL::Euler::join_face(*inner, mesh);
  mesh.remove_vertex(mesh.add_vertex());
  ASSERT_TRUE(mesh.has_garbage());
  std::map<Surface_mesh::Vertex_index, std::size_t> number;
  for (const auto v : mesh.vertices()) // from the end, to see that the map is used
    number.emplace(v, mesh.number_of_vertices() - 1 - number.size());
  const auto vertex_index = boost::make_assoc_property_map(number);
  const Glued_polygons polygons = test::polygons_of(mesh, vertex_index);
  EXPECT_EQ(19u, polygons.soup.faces.size()); // 20 + 1 - 1 - 1
  EXPECT_EQ("", error_of_triangulation(Simple_triangulation<>(mesh, vertex_index), polygons)) << polygons;
}

TEST(Simple_triangulation, of_a_polyhedron_splits_double_edges)
{
  Polyhedron mesh;
  const Kernel::Point_3 p(0, 0, 0);
  CGAL::make_tetrahedron(p, p, p, p, mesh);
  CGAL::Euler::join_vertex(halfedge(*edges(mesh).begin(), mesh), mesh);
  const auto made = [&] {
    CGAL::set_halfedgeds_items_id(mesh);
    return Simple_triangulation<>(mesh, get(boost::vertex_index, mesh));
  };
  EXPECT_EQ(Mesh_defect::degenerate_face, thrown_by(made).at(0).first); // two digons
  for (const auto f : std::vector<Polyhedron::Face_handle>(faces(mesh).begin(), faces(mesh).end()))
    if (CGAL::degree(f, mesh) == 2)
      CGAL::Euler::add_center_vertex(halfedge(f, mesh), mesh);
  EXPECT_EQ(2u, num_splits(made()));
  EXPECT_EQ("", error_of_triangulation(made(), test::polygons_of(mesh, get(boost::vertex_index, mesh))));
}

TEST(Simple_triangulation, takes_vertices_with_several_open_fans_as_surface_mesh_makes_them)
{
  Surface_mesh mesh;
  std::vector<Surface_mesh::Vertex_index> v;
  for (int i = 0; i < 9; ++i)
    v.push_back(mesh.add_vertex());
  const Polygon_soup soup{9, {{0, 1, 2, 3}, {0, 4, 5}, {6, 0, 7, 8}}};
  mesh.add_face(v[0], v[1], v[2], v[3]);
  mesh.add_face(v[0], v[4], v[5]);
  mesh.add_face(v[6], v[0], v[7], v[8]);
  ASSERT_EQ(3u, mesh.number_of_faces());
  const Simple_triangulation<> made = simple(mesh);
  EXPECT_EQ(5u, made.table().num_faces());
  EXPECT_EQ(9u, made.table().num_vertices());
}

TEST(Simple_triangulation, names_each_defect_of_minimal_soups_however_they_are_numbered)
{
  const Polygon_soup tetra = test::tetrahedron(), cube = prism(4);
  Polygon_soup two_cones = test::disjoint_union(tetra, cube);
  test::merge_vertices(two_cones, 0, 4);
  Polygon_soup cone_and_quad = test::disjoint_union(cube, {4, {{0, 1, 2, 3}}});
  test::merge_vertices(cone_and_quad, 0, 8);
  const std::vector<std::pair<Mesh_defect, Polygon_soup>> minimal{
    {Mesh_defect::index_out_of_range, {4, {{0, 1, 2, 4}}}},
    {Mesh_defect::index_out_of_range, {4, {{0, 1, 2}, {-1, 1, 0, 3}}}},
    {Mesh_defect::index_out_of_range, {4, {{0, 1, 4294967296LL, 2}}}},
    {Mesh_defect::index_out_of_range, {4, {{0, 1, 2, (std::numeric_limits<long long>::min)()}}}},
    {Mesh_defect::degenerate_face, {3, {{0, 1, 2}, {0, 1}}}},
    {Mesh_defect::degenerate_face, {4, {{0, 1, 2, 3}, {}}}},
    {Mesh_defect::degenerate_face, {4, {{0, 1, 2}, {3}}}},
    {Mesh_defect::repeated_vertex, {4, {{0, 1, 0, 3}}}},
    {Mesh_defect::repeated_vertex, {4, {{0, 1, 2, 3, 0}}}},
    {Mesh_defect::repeated_vertex, {10, {{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 4}}}},
    {Mesh_defect::repeated_vertex, {3, {{0, 1, 2}, {0, 0, 1}}}},
    {Mesh_defect::nonmanifold_edge, {8, {{0, 1, 2, 5}, {0, 1, 3, 6}, {1, 0, 4, 7}}}},
    {Mesh_defect::nonmanifold_edge, {4, {{0, 1, 2, 3}, {0, 1, 2, 3}, {3, 2, 1, 0}}}},
    {Mesh_defect::duplicate_face, {4, {{0, 1, 2, 3}, {0, 1, 2, 3}}}},
    {Mesh_defect::duplicate_face, {9, {{0, 1, 2, 3, 4, 5, 6, 7, 8}, {4, 5, 6, 7, 8, 0, 1, 2, 3}}}},
    {Mesh_defect::inconsistent_orientation, {4, {{0, 1, 2, 3}, {0, 1, 3, 2}}}},
    {Mesh_defect::inconsistent_orientation, {4, {{0, 1, 2, 3}, {0, 1, 2}}}},
    {Mesh_defect::inconsistent_orientation, {6, {{0, 1, 2, 3}, {0, 1, 4, 5}}}},
    {Mesh_defect::inconsistent_orientation, moebius_strip(5, false)},
    {Mesh_defect::inconsistent_orientation, moebius_strip(5, true)},
    {Mesh_defect::nonmanifold_vertex, two_cones},
    {Mesh_defect::nonmanifold_vertex, cone_and_quad},
  };
  std::mt19937 rng(1);
  for (const auto& defect_and_soup : minimal)
    for (int repetition = 0; repetition < 100; ++repetition) {
      const Polygon_soup soup = repetition == 0 ? defect_and_soup.second : test::shuffled(defect_and_soup.second, rng);
      const std::vector<Defect> thrown = thrown_by([&] { simple(soup); });
      ASSERT_EQ(1u, thrown.size()) << soup;
      EXPECT_EQ(text(defect_and_soup.first, 0), text(thrown[0].first, 0)) << soup;
      EXPECT_EQ(1u, test::Soup_oracle(soup).polygon_defects().count(thrown[0])) << soup << ": " << text(thrown);
    }
}

TEST(Simple_triangulation, tells_what_can_repair_unoriented_soups)
{
  EXPECT_NE(std::string::npos, refusal([] { simple(moebius_strip(4, false)); }).find("orient_polygon_soup"));
}

TEST(Simple_triangulation, throws_exactly_when_a_random_soup_has_a_defect_and_names_one)
{
  test::expect_random_soups_are_right(
      small_polygon_surfaces(), (std::max<std::size_t>)(3000, test::scaled(50000)), error_of_construction,
      {Mesh_defect::index_out_of_range, Mesh_defect::degenerate_face, Mesh_defect::repeated_vertex,
       Mesh_defect::nonmanifold_edge, Mesh_defect::duplicate_face, Mesh_defect::inconsistent_orientation,
       Mesh_defect::nonmanifold_vertex});
}

TEST(Simple_triangulation, of_a_graph_refuses_what_no_soup_shows)
{
  Glued_polygons closed_fan_and_another = test::glued_by_ends(prism(3));
  Polygon_soup& soup = closed_fan_and_another.soup;
  soup.faces.push_back({0, 6, 7, 8});
  soup.num_vertices = 9;
  closed_fan_and_another.opposite.resize(22, Glued_polygons::none);
  EXPECT_EQ(text(Mesh_defect::nonmanifold_vertex, 0), refusal([&] { simple(closed_fan_and_another); }));

  const auto refusal_of_face = [&](const std::vector<long long>& face) {
    const Glued_polygons apart{{4, {{0, 1, 2, 3}, face}},
                               std::vector<std::size_t>(4 + face.size(), Glued_polygons::none)};
    return refusal([&] { simple(apart); });
  };
  EXPECT_EQ(text(Mesh_defect::degenerate_face, 1), refusal_of_face({0, 1}));
  EXPECT_EQ(text(Mesh_defect::degenerate_face, 1), refusal_of_face({0}));
  EXPECT_EQ(text(Mesh_defect::repeated_vertex, 1), refusal_of_face({0, 1, 0, 2}));

  const Surface_mesh mesh = test::graph_of<Surface_mesh>(test::glued_by_ends(test::pillow(4)));
  const auto shifted = [&](long long shift) { // an index map that is wrong
    std::map<Surface_mesh::Vertex_index, long long> number;
    for (const auto v : mesh.vertices())
      number.emplace(v, static_cast<long long>(v.idx()) + shift);
    return refusal([&] { Simple_triangulation<>(mesh, boost::make_assoc_property_map(number)); });
  };
  EXPECT_EQ("nothing", shifted(0));
  EXPECT_EQ(text(Mesh_defect::index_out_of_range, 0), shifted(1));
  EXPECT_EQ(text(Mesh_defect::index_out_of_range, 0), shifted(-1));
}

TEST(Simple_triangulation, refuses_more_elements_than_its_index_type_can_number)
{
  using Narrow = Simple_triangulation<std::uint8_t>; // 254 vertices and 84 triangles at most
  const auto refusal_of = [](const Polygon_soup& soup) { return refusal([&] { simple<std::uint8_t>(soup); }); };
  const auto with_vertices = [](Polygon_soup soup, std::size_t n) {
    soup.num_vertices = n;
    return soup;
  };
  EXPECT_EQ("nothing", refusal_of(test::polygon(84)));
  EXPECT_EQ("", error_of_triangulation(simple<std::uint8_t>(test::polygon(84)), test::polygon(84)));
  EXPECT_EQ(text(Mesh_defect::too_many_elements, 85), refusal_of(test::polygon(85)));
  EXPECT_EQ("nothing", refusal_of(with_vertices(test::polygon(9), 253)));
  EXPECT_EQ(text(Mesh_defect::too_many_elements, 255), refusal_of(with_vertices(test::polygon(9), 254)));
  EXPECT_EQ("nothing", refusal_of(with_vertices(test::polygon(8), 254)));
  EXPECT_EQ(text(Mesh_defect::too_many_elements, 255), refusal_of(with_vertices(test::polygon(8), 255)));
  EXPECT_EQ("nothing", refusal_of(test::quad_grid(6, 7)));
  EXPECT_EQ(text(Mesh_defect::too_many_elements, 86), refusal_of(test::quad_grid(1, 43)));
  EXPECT_EQ(text(Mesh_defect::too_many_elements, 128), refusal_of(test::quad_grid(1, 64)));
  EXPECT_EQ(text(Mesh_defect::too_many_elements, 85),
            refusal([] { Narrow(10, std::vector<std::vector<int>>(85, std::vector<int>{0, 1, 2, 3})); }));
  Glued_polygons torus = test::helical_torus(4, 2, true);
  for (const std::size_t n : {248, 249}) {
    torus.soup.num_vertices = n;
    EXPECT_EQ(n == 248 ? "nothing" : text(Mesh_defect::too_many_elements, 255),
              refusal([&] { simple<std::uint8_t>(torus); }));
  }
}

TEST(Simple_triangulation, is_empty_when_moved_from)
{
  Simple_triangulation<> made = simple(prism(9)), other(std::move(made));
  EXPECT_EQ(0u, made.num_user_vertices() + made.num_user_faces() + made.table().num_vertices());
  EXPECT_FALSE(made.has_hidden());
  EXPECT_EQ("", error_of_triangulation(other, prism(9)));
}

// Were anything quadratic in sizes or degrees, this would not end.
TEST(Simple_triangulation, takes_polygons_and_hubs_of_100_000_sides)
{
  const std::size_t k = test::scaled(100000);
  for (const Polygon_soup& soup : {test::polygon(k), test::pillow(k), prism(k), annulus(k), quads_around_hubs(k)})
    EXPECT_EQ("", error_of_triangulation(simple(soup), soup));
}
