// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Corner_table, made of soups and of graphs: what it holds, and what it refuses.

#include "damaged_soups.h"
#include "generated_triangulations.h"
#include "refusals.h"
#include "small_triangulations.h"
#include "soup_oracle.h"
#include "test_scale.h"

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/Corner_table.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
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
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using CGAL::Closed_triangulation;
using CGAL::Corner_table;
using CGAL::Mesh_defect;
using test::Defect;
using test::Polygon_soup;
using test::Soup;
using test::Soup_oracle;
using test::Triangles;
using test::refusal;
using test::text;
using test::thrown_by;

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;

const Triangles tetrahedron{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};

Corner_table<> table_of(const Polygon_soup& soup) { return Corner_table<>(soup.num_vertices, soup.faces); }

// Whether two tables hold the same.
template <class Index>
bool are_equal(const Corner_table<Index>& a, const Corner_table<Index>& b)
{
  bool equal = a.num_vertices() == b.num_vertices() && a.num_halfedges() == b.num_halfedges();
  for (std::size_t i = 0; equal && i < a.num_halfedges(); ++i) {
    const Index h = static_cast<Index>(i);
    equal = a.source(h) == b.source(h) && a.opposite(h) == b.opposite(h);
  }
  return equal;
}

// What Corner_table does wrong with `soup`, or nothing. `met` counts the defects that it names.
std::string error_of_construction(const Polygon_soup& soup, test::Thrown_counts& met)
{
  const Soup_oracle oracle(soup);
  const std::set<Defect> defects = oracle.defects();
  Corner_table<> table;
  const std::string error = test::error_of_refusal(defects, thrown_by([&] { table = table_of(soup); }), met);
  if (!error.empty() || !defects.empty())
    return error;
  const std::string difference = oracle.difference(table);
  return difference.empty() ? "" : "differs: " + difference;
}

} // namespace

TEST(Corner_table, holds_the_triangles_of_any_range_of_ranges_of_integers)
{
  const Corner_table<> expected(4, tetrahedron);
  ASSERT_EQ("", Soup_oracle(test::tetrahedron()).difference(expected));
  std::vector<std::array<int, 3>> arrays_of_int;
  std::vector<std::vector<std::size_t>> vectors_of_size;
  std::list<std::list<short>> lists_of_short;
  unsigned char c_array[4][3];
  for (std::size_t f = 0; f < 4; ++f) {
    const auto& t = tetrahedron[f];
    arrays_of_int.push_back({int(t[0]), int(t[1]), int(t[2])});
    vectors_of_size.push_back({t[0], t[1], t[2]});
    lists_of_short.push_back({short(t[0]), short(t[1]), short(t[2])});
    for (int i = 0; i < 3; ++i)
      c_array[f][i] = static_cast<unsigned char>(t[i]);
  }
  EXPECT_TRUE(are_equal(expected, Corner_table<>(4, arrays_of_int)));
  EXPECT_TRUE(are_equal(expected, Corner_table<>(4, vectors_of_size)));
  EXPECT_TRUE(are_equal(expected, Corner_table<>(4, lists_of_short)));
  EXPECT_TRUE(are_equal(expected, Corner_table<>(4, c_array)));
}

TEST(Corner_table, answers_all_operators_as_a_search_through_the_triangles_does)
{
  for (const Polygon_soup& soup : test::small_surfaces()) {
    ASSERT_EQ("nothing", refusal([&] { table_of(soup); })) << soup;
    ASSERT_EQ("", Soup_oracle(soup).difference(table_of(soup))) << soup;
    ASSERT_EQ("", Soup_oracle(soup).difference(Corner_table<std::uint8_t>(soup.num_vertices, soup.faces))) << soup;
    ASSERT_EQ("", Soup_oracle(soup).difference(Corner_table<std::uint64_t>(soup.num_vertices, soup.faces))) << soup;
  }
}

TEST(Corner_table, says_null_where_a_border_is)
{
  const Corner_table<> table = table_of({4, {{0, 1, 2}, {2, 1, 3}}});
  EXPECT_EQ(3u, table.opposite(1));
  EXPECT_EQ(5u, table.opposite_corner(0));
  EXPECT_EQ(5u, table.right_corner(2)); // r = o of the next corner
  EXPECT_EQ(5u, table.left_corner(1));  // l = o of the previous corner
  for (const std::uint32_t h : {0, 2, 4, 5})
    EXPECT_EQ(table.null(), table.opposite(h)) << h;
  EXPECT_EQ(1u, table.swing(4));
  EXPECT_EQ(table.null(), table.swing(1));
  EXPECT_EQ(3u, table.swing(2));
  EXPECT_EQ(table.null(), table.swing(3));
}

TEST(Corner_table, of_a_surface_mesh_with_removed_elements_lists_faces_in_its_order_from_their_halfedges_on)
{
  Surface_mesh mesh;
  const auto removed = mesh.add_vertex();
  mesh.add_vertex(); // isolated
  CGAL::make_icosahedron<Surface_mesh, Kernel::Point_3>(mesh);
  mesh.remove_vertex(removed);
  for (const int f : {0, 3, 11})
    CGAL::Euler::remove_face(mesh.halfedge(Surface_mesh::Face_index(f)), mesh);
  ASSERT_TRUE(mesh.has_garbage());
  std::map<Surface_mesh::Vertex_index, std::size_t> number;
  for (const auto v : mesh.vertices()) // from the end, to see that the map is used
    number.emplace(v, mesh.number_of_vertices() - 1 - number.size());
  const auto vertex_index = boost::make_assoc_property_map(number);
  Polygon_soup soup{number.size(), {}};
  for (const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    soup.faces.push_back({static_cast<long long>(number[mesh.source(h)]),
                          static_cast<long long>(number[mesh.target(h)]),
                          static_cast<long long>(number[mesh.target(mesh.next(h))])});
  }
  EXPECT_EQ(13u, soup.num_vertices);
  EXPECT_EQ(17u, soup.faces.size());
  EXPECT_EQ("", Soup_oracle(soup).difference(Corner_table<>(mesh, vertex_index))) << soup;

  // by an index map that does not skip what is removed
  EXPECT_EQ(Mesh_defect::index_out_of_range,
            thrown_by([&] { Corner_table<>(mesh, get(boost::vertex_index, mesh)); }).at(0).first);

  const Surface_mesh::Face_index joined(7), lost(8);
  for (const auto h : CGAL::halfedges_around_face(mesh.halfedge(joined), mesh))
    if (mesh.face(mesh.opposite(h)) == lost) {
      CGAL::Euler::join_face(h, mesh);
      break;
    }
  ASSERT_EQ(4u, mesh.degree(joined));
  const std::size_t place = 5; // two faces before it are removed
  EXPECT_EQ(text(Mesh_defect::not_a_triangle, place), refusal([&] { Corner_table<>(mesh, vertex_index); }));
}

TEST(Corner_table, of_a_polyhedron_lists_faces_in_its_order_from_their_halfedges_on)
{
  Polyhedron mesh;
  CGAL::make_icosahedron<Polyhedron, Kernel::Point_3>(mesh);
  CGAL::Euler::remove_face(halfedge(*faces(mesh).first, mesh), mesh);
  CGAL::set_halfedgeds_items_id(mesh);
  Polygon_soup soup{mesh.size_of_vertices(), {}};
  for (const auto f : faces(mesh)) {
    const auto h = f->halfedge();
    soup.faces.push_back({static_cast<long long>(h->opposite()->vertex()->id()),
                          static_cast<long long>(h->vertex()->id()),
                          static_cast<long long>(h->next()->vertex()->id())});
  }
  EXPECT_EQ("", Soup_oracle(soup).difference(Corner_table<>(mesh, get(boost::vertex_index, mesh)))) << soup;
}

TEST(Corner_table, names_each_defect_of_minimal_soups_however_they_are_numbered)
{
  const Polygon_soup tetra = test::tetrahedron();
  Polygon_soup two_cones = test::disjoint_union(tetra, tetra);
  test::merge_vertices(two_cones, 0, 4);
  Polygon_soup cone_and_triangle = test::disjoint_union(tetra, {3, {{0, 1, 2}}});
  test::merge_vertices(cone_and_triangle, 0, 4);
  Polygon_soup cone_and_two_triangles = test::disjoint_union(cone_and_triangle, {3, {{0, 1, 2}}});
  test::merge_vertices(cone_and_two_triangles, 0, 6);
  Polygon_soup pierced_cone_and_strip = test::disjoint_union({4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}},
                                                       {4, {{0, 1, 2}, {0, 2, 3}}});
  test::merge_vertices(pierced_cone_and_strip, 0, 4);
  const std::vector<std::pair<Mesh_defect, Polygon_soup>> minimal{
    {Mesh_defect::index_out_of_range, {3, {{0, 1, 3}}}},
    {Mesh_defect::index_out_of_range, {3, {{0, 1, 2}, {-1, 1, 0}}}},
    {Mesh_defect::index_out_of_range, {0, {{0, 1, 2}}}},
    {Mesh_defect::index_out_of_range, {3, {{0, 1, 4294967296LL}}}},
    {Mesh_defect::index_out_of_range, {3, {{0, 1, 4294967298LL}}}},
    {Mesh_defect::index_out_of_range, {3, {{0, 1, (std::numeric_limits<long long>::min)()}}}},
    {Mesh_defect::not_a_triangle, {3, {{0, 1, 2}, {0, 1}}}},
    {Mesh_defect::not_a_triangle, {4, {{0, 1, 2, 3}}}},
    {Mesh_defect::not_a_triangle, {4, {{0, 1, 2}, {}}}},
    {Mesh_defect::not_a_triangle, {4, {{0, 1, 2}, {3}}}},
    {Mesh_defect::repeated_vertex, {3, {{0, 1, 2}, {0, 0, 1}}}},
    {Mesh_defect::repeated_vertex, {1, {{0, 0, 0}}}},
    {Mesh_defect::nonmanifold_edge, {5, {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}}}},
    {Mesh_defect::nonmanifold_edge, {5, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}}},
    {Mesh_defect::nonmanifold_edge, {6, {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {1, 0, 5}}}},
    {Mesh_defect::duplicate_face, {3, {{0, 1, 2}, {0, 1, 2}}}},
    {Mesh_defect::inconsistent_orientation, {4, {{0, 1, 2}, {0, 1, 3}}}},
    {Mesh_defect::nonmanifold_vertex, two_cones},
    {Mesh_defect::nonmanifold_vertex, cone_and_triangle},
    {Mesh_defect::nonmanifold_vertex, cone_and_two_triangles},
    {Mesh_defect::nonmanifold_vertex, pierced_cone_and_strip},
    {Mesh_defect::nonmanifold_vertex, {5, {{0, 1, 2}, {0, 2, 1}, {0, 3, 4}, {0, 4, 3}}}},
  };
  std::mt19937 rng(1);
  for (const auto& defect_and_soup : minimal)
    for (int repetition = 0; repetition < 300; ++repetition) {
      const Polygon_soup soup = repetition == 0 ? defect_and_soup.second : test::shuffled(defect_and_soup.second, rng);
      const std::vector<Defect> thrown = thrown_by([&] { table_of(soup); });
      ASSERT_EQ(1u, thrown.size()) << soup;
      EXPECT_EQ(text(defect_and_soup.first, 0), text(thrown[0].first, 0)) << soup;
      EXPECT_EQ(1u, Soup_oracle(soup).defects().count(thrown[0])) << soup << ": " << text(thrown);
    }
}

TEST(Corner_table, names_the_first_malformed_face)
{
  const auto refusal_of = [](const std::vector<std::vector<int>>& faces) {
    return refusal([&] { Corner_table<>(4, faces); });
  };
  EXPECT_EQ(text(Mesh_defect::index_out_of_range, 1), refusal_of({{0, 1, 2}, {1, 3, -1}, {4, 4, 4}}));
  EXPECT_EQ(text(Mesh_defect::not_a_triangle, 2), refusal_of({{0, 1, 2}, {2, 1, 3}, {0, 1, 2, 9}, {9, 9, 9}}));
  EXPECT_EQ(text(Mesh_defect::repeated_vertex, 1), refusal_of({{0, 1, 2}, {3, 2, 3}, {0, 1}}));
}

TEST(Corner_table, throws_exactly_when_a_random_soup_has_a_defect_and_names_one)
{
  test::expect_random_soups_are_right(
      test::small_surfaces(), (std::max<std::size_t>)(3000, test::scaled(100000)), error_of_construction,
      {Mesh_defect::index_out_of_range, Mesh_defect::not_a_triangle, Mesh_defect::repeated_vertex,
       Mesh_defect::nonmanifold_edge, Mesh_defect::duplicate_face, Mesh_defect::inconsistent_orientation,
       Mesh_defect::nonmanifold_vertex});
}

TEST(Corner_table, refuses_more_elements_than_its_index_type_can_number)
{
  const auto triangles = [](std::size_t num_faces) { // side by side
    std::vector<std::vector<std::size_t>> faces;
    for (std::size_t f = 0; f < num_faces; ++f)
      faces.push_back({3 * f, 3 * f + 1, 3 * f + 2});
    return faces;
  };
  const auto check = [&](auto index, std::size_t limit) {
    using Table = Corner_table<decltype(index)>;
    const std::size_t most_faces = (limit - 1) / 3; // 3f < limit
    const Table table(limit - 1, triangles(most_faces));
    EXPECT_EQ(limit - 1, table.num_vertices());
    EXPECT_EQ(most_faces, table.num_faces());
    for (std::size_t h = 0; h < table.num_halfedges(); ++h)
      ASSERT_TRUE(table.source(decltype(index)(h)) == h && table.opposite(decltype(index)(h)) == Table::null());
    for (const std::size_t n : {limit, limit + 1, limit + 2, 2 * limit + 5})
      EXPECT_EQ(text(Mesh_defect::too_many_elements, n), refusal([&] { Table(n, triangles(1)); }));
    for (const std::size_t f : {most_faces + 1, most_faces + 2, 2 * most_faces + 5, limit + 10})
      EXPECT_EQ(text(Mesh_defect::too_many_elements, f), refusal([&] { Table(limit - 1, triangles(f)); }));
    for (const std::size_t v : {limit - 1, limit, limit + 1, limit + 2}) // 0, if it wrapped around
      EXPECT_EQ(text(Mesh_defect::index_out_of_range, 0),
                refusal([&] { Table(limit - 1, std::vector<std::vector<std::size_t>>{{v, 1, 2}}); }));
  };
  check(std::uint8_t(), 255);
  check(std::uint16_t(), 65535);
  for (const std::size_t n : {std::size_t(4294967295u), std::size_t(4294967296u), std::size_t(-1)})
    EXPECT_EQ(text(Mesh_defect::too_many_elements, n), refusal([&] { Corner_table<>(n, triangles(1)); }));
  const std::size_t most = std::size_t(-1);
  EXPECT_EQ(text(Mesh_defect::too_many_elements, most),
            refusal([&] { Corner_table<std::uint64_t>(most, triangles(1)); }));
}

TEST(Corner_table, is_as_it_was_when_a_face_was_split_and_unsplit)
{
  for (const Polygon_soup& soup : test::small_surfaces())
    for (std::uint32_t f = 0; f < soup.faces.size(); ++f) {
      Corner_table<> table = table_of(soup);
      const std::vector<long long> t = soup.faces[f];
      const long long x = static_cast<long long>(soup.num_vertices);
      Polygon_soup split = soup;
      ++split.num_vertices;
      split.faces[f] = {t[0], t[1], x};
      split.faces.push_back({t[1], t[2], x});
      split.faces.push_back({t[2], t[0], x});
      EXPECT_EQ(x, table.split_face(f));
      ASSERT_EQ("", Soup_oracle(split).difference(table)) << split;
      const std::uint32_t f2 = static_cast<std::uint32_t>(table.num_faces() - 1);
      table.split_face(f2);
      table.unsplit_face(f2);
      table.resize(split.num_vertices, split.faces.size());
      ASSERT_EQ("", Soup_oracle(split).difference(table)) << split;
      table.unsplit_face(f);
      table.resize(soup.num_vertices, soup.faces.size());
      ASSERT_TRUE(are_equal(table_of(soup), table)) << soup;
    }
}

TEST(Corner_table, is_empty_when_moved_from)
{
  Corner_table<> table(4, tetrahedron), other(std::move(table));
  EXPECT_EQ(0u, table.num_vertices() + table.num_halfedges() + table.num_faces() + table.bytes());
  EXPECT_TRUE(are_equal(Corner_table<>(4, tetrahedron), other));
  table = std::move(other);
  EXPECT_EQ(0u, other.num_vertices() + other.num_halfedges() + other.num_faces() + other.bytes());
  EXPECT_TRUE(are_equal(Corner_table<>(4, tetrahedron), table));
  EXPECT_EQ(0u, Corner_table<>().num_vertices() + Corner_table<>().num_halfedges());
}

// Were anything quadratic in the degrees, this would not end.
TEST(Corner_table, takes_hubs_of_a_million_triangles)
{
  const std::uint32_t n = static_cast<std::uint32_t>(test::scaled(1000000));
  const Soup wheel = test::shuffled(test::double_wheel(n), 3);
  const Corner_table<> table(n, wheel.triangles);
  ASSERT_EQ(2 * std::size_t(n) - 4, table.num_faces());
  for (std::uint32_t h = 0; h < table.num_halfedges(); ++h) {
    const std::uint32_t o = table.opposite(h);
    ASSERT_TRUE(o != table.null() && table.opposite(o) == h && table.source(o) == table.target(h)
                && table.target(o) == table.source(h)) << h;
  }
  EXPECT_EQ("nothing", refusal([&] { Closed_triangulation<>(Corner_table<>(table)); }));

  Soup bouquet{2 * n + 1, {}}; // triangles that share nothing but a vertex
  for (std::uint32_t i = 0; i < n; ++i)
    bouquet.triangles.push_back({2 * i + 1, 0, 2 * i + 2});
  EXPECT_EQ(n, Corner_table<>(2 * n + 1, bouquet.triangles).num_faces());

  for (test::Triangle t : tetrahedron) { // and among them a closed cone
    for (std::uint32_t& v : t)
      v = v == 0 ? 0 : v + 2 * n;
    bouquet.triangles.push_back(t);
  }
  EXPECT_EQ(text(Mesh_defect::nonmanifold_vertex, 0), refusal([&] { Corner_table<>(2 * n + 4, bouquet.triangles); }));

  Soup doubled = wheel;
  doubled.triangles.push_back(doubled.triangles[n / 2]);
  EXPECT_EQ(Mesh_defect::nonmanifold_edge,
            thrown_by([&] { Corner_table<>(n, doubled.triangles); }).at(0).first);
}
