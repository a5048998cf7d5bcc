// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The road by which every mesh enters: Corner_table, made of soups and of graphs, and
// Closed_triangulation. What they hold, and what they refuse.

#include "damaged_soups.h"
#include "generated_triangulations.h"
#include "layout_oracle.h"
#include "small_triangulations.h"
#include "soup_oracle.h"
#include "test_scale.h"

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/Corner_table.h>
#include <CGAL/Compact_surface_mesh/layouts/Corner_table_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/Schnyder_parents_layout.h>

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
using CGAL::Mesh_defect_exception;
using test::Defect;
using test::Polygon_soup;
using test::Soup;
using test::Soup_oracle;
using test::Triangles;

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;

const Triangles tetrahedron{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};

Corner_table<> table_of(const Polygon_soup& soup) { return Corner_table<>(soup.num_vertices, soup.faces); }

// The defect that `make()` throws, if it throws.
template <class Make>
std::vector<Defect> thrown_by(const Make& make)
{
  try {
    make();
  } catch (const Mesh_defect_exception& e) {
    return {Defect(e.defect(), e.element())};
  }
  return {};
}

// For messages.
std::string text(const std::vector<Defect>& thrown)
{
  return thrown.empty() ? "nothing" : Mesh_defect_exception(thrown[0].first, thrown[0].second).what();
}

template <class Make>
std::string refusal(const Make& make) { return text(thrown_by(make)); }

std::string text(Mesh_defect defect, std::size_t element) { return text({Defect(defect, element)}); }

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

// What is wrong with a closed triangulation of the table, or nothing.
std::string error_of_closing(Corner_table<>&& open)
{
  const Corner_table<> copy = open;
  const Closed_triangulation<> closed(std::move(open));
  const Corner_table<>& table = closed.table();
  const std::size_t num_sides = copy.num_halfedges();
  if (closed.num_open_faces() != copy.num_faces() || closed.first_copy() != copy.num_vertices()
      || closed.first_apex() + closed.roots().size() != table.num_vertices())
    return "wrong counts";
  for (std::uint32_t h = 0; h < table.num_halfedges(); ++h) {
    const std::uint32_t o = table.opposite(h);
    if (o == table.null() || table.opposite(o) != h || table.source(o) != table.target(h))
      return "is not closed";
  }
  const auto original = [&](std::uint32_t v) { return v < closed.first_copy() ? v : closed.copies()[v - closed.first_copy()]; };
  for (std::uint32_t h = 0; h < num_sides; ++h) {
    const std::uint32_t g = closed.current_halfedge(h);
    if (original(table.source(g)) != copy.source(h) || original(table.target(g)) != copy.target(h))
      return "a halfedge is lost";
    if (copy.opposite(h) != copy.null() && table.opposite(g) != closed.current_halfedge(copy.opposite(h)))
      return "an edge is lost";
    if (copy.opposite(h) == copy.null() && table.target(table.next(table.opposite(g))) < closed.first_apex())
      return "a border has no apex";
  }
  std::size_t num_faces = 0, num_roots = 0;
  for (const auto& component : closed.components()) {
    if (component.first_root != num_roots || component.end_root <= num_roots)
      return "wrong roots";
    num_faces += component.num_faces;
    num_roots = component.end_root;
    for (std::size_t i = component.first_root; i < component.end_root; ++i) {
      const auto& root = closed.roots()[i];
      std::set<std::uint32_t> around;
      std::uint32_t h = table.prev(root.base);
      for (std::uint32_t j = 0; j < root.degree; ++j, h = table.next_around_source(h))
        around.insert(table.target(h));
      if (table.source(h) != root.apex || h != table.prev(root.base) || around.size() != root.degree)
        return "wrong root";
      if (root.degree > closed.roots()[component.first_root].degree)
        return "the main root is not the largest one";
    }
  }
  return num_faces == table.num_faces() && num_roots == closed.roots().size() ? "" : "faces or roots of no component";
}

// What Corner_table and Closed_triangulation do wrong with `soup`, or nothing. `met`
// counts the defects that they name.
std::string error_of_construction(const Polygon_soup& soup, std::map<std::string, std::size_t>& met)
{
  const Soup_oracle oracle(soup);
  const std::set<Defect> defects = oracle.defects();
  Corner_table<> table;
  const auto judge = [&](const std::set<Defect>& expected, const std::vector<Defect>& thrown) -> std::string {
    ++met[thrown.empty() ? "nothing" : text(thrown[0].first, 0)];
    if (expected.empty())
      return thrown.empty() ? "" : "is refused: " + text(thrown);
    if (thrown.empty())
      return "is taken, but " + text({*expected.begin()});
    return expected.count(thrown[0]) != 0 ? "" : "is refused for what is not so: " + text(thrown);
  };
  std::string error = judge(defects, thrown_by([&] { table = table_of(soup); }));
  if (!error.empty() || !defects.empty())
    return error;
  error = oracle.difference(table);
  if (!error.empty())
    return "differs: " + error;
  return error_of_closing(std::move(table));
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
  const unsigned int seed = 2;
  const std::size_t num_soups = (std::max<std::size_t>)(3000, test::scaled(100000));
  std::cout << "seed " << seed << ", " << num_soups << " soups" << std::endl;
  std::mt19937 rng(seed);
  const std::vector<Polygon_soup> surfaces = test::small_surfaces();
  std::map<std::string, std::size_t> met, ignored;
  for (std::size_t i = 0; i < num_soups; ++i) {
    const Polygon_soup soup = test::random_soup(surfaces, rng);
    const std::string error = error_of_construction(soup, met);
    const auto fails = [&](const Polygon_soup& s) { return !error_of_construction(s, ignored).empty(); };
    if (!error.empty()) {
      const Polygon_soup smallest = test::smallest_failing(soup, fails);
      FAIL() << "soup " << i << " " << error << "\n" << soup << "\nand so fails "
             << smallest << ", which " << error_of_construction(smallest, ignored);
    }
  }
  for (const Mesh_defect defect : {Mesh_defect::index_out_of_range, Mesh_defect::not_a_triangle,
                                   Mesh_defect::repeated_vertex, Mesh_defect::nonmanifold_edge,
                                   Mesh_defect::duplicate_face, Mesh_defect::inconsistent_orientation,
                                   Mesh_defect::nonmanifold_vertex})
    EXPECT_LT(num_soups / 500, met[text(defect, 0)]) << text(defect, 0);
  EXPECT_LT(num_soups / 20, met["nothing"]);
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

TEST(Closed_triangulation, closes_borders_parts_vertices_and_caps_closed_components)
{
  const auto closed = [](const Polygon_soup& soup) { return Closed_triangulation<>(table_of(soup)); };
  EXPECT_EQ(0u, closed({0, {}}).roots().size());
  EXPECT_EQ(0u, closed({3, {}}).components().size()); // isolated vertices
  const auto bow_tie = closed({5, {{0, 1, 2}, {0, 3, 4}}});
  EXPECT_EQ(std::vector<std::uint32_t>(1, 0), bow_tie.copies());
  EXPECT_EQ(2u, bow_tie.components().size());
  EXPECT_FALSE(bow_tie.is_cap(bow_tie.roots()[0]));
  const auto two = closed(test::disjoint_union(test::torus(), test::tetrahedron()));
  ASSERT_EQ(2u, two.components().size());
  EXPECT_EQ(16u, two.components()[0].num_faces);
  EXPECT_EQ(6u, two.components()[1].num_faces);
  EXPECT_TRUE(two.is_cap(two.roots()[0]) && two.is_cap(two.roots()[1]));

  // an annulus: its larger border is the main root
  Polygon_soup annulus = test::soup_of(test::globe(3, 7));
  annulus.faces.erase(std::remove_if(annulus.faces.begin(), annulus.faces.end(), [](const std::vector<long long>& f) {
    return f[0] == 1;
  }), annulus.faces.end());
  annulus.faces.erase(annulus.faces.begin()); // at the other pole
  const auto closed_annulus = closed(annulus);
  ASSERT_EQ(1u, closed_annulus.components().size());
  EXPECT_EQ(2u, closed_annulus.roots().size());
  EXPECT_GT(closed_annulus.roots()[0].degree, closed_annulus.roots()[1].degree);
}

TEST(Closed_triangulation, removes_its_caps)
{
  const Polygon_soup soup = test::disjoint_union(test::disjoint_union(test::tetrahedron(), {3, {{0, 1, 2}}}), test::torus());
  Closed_triangulation<> closed(table_of(soup));
  EXPECT_EQ(3u, closed.roots().size());
  closed.remove_caps();
  ASSERT_EQ(1u, closed.roots().size());
  EXPECT_EQ(3u, closed.roots()[0].degree);
  const Corner_table<> original = table_of(soup), table = closed.release_table();
  EXPECT_EQ(original.num_faces() + 3, table.num_faces());
  EXPECT_EQ(original.num_vertices() + 1, table.num_vertices());
  for (std::uint32_t h = 0; h < original.num_halfedges(); ++h) {
    EXPECT_EQ(original.source(h), table.source(h));
    if (original.opposite(h) != original.null()) {
      EXPECT_EQ(original.opposite(h), table.opposite(h));
    }
  }
}

TEST(Closed_triangulation, has_an_apex_to_the_left_of_its_base)
{
  Closed_triangulation<> closed{Corner_table<>(4, tetrahedron)};
  const Corner_table<>& table = closed.table();
  ASSERT_EQ(1u, closed.roots().size());
  EXPECT_EQ(4u, closed.first_apex());
  EXPECT_EQ(5u, table.num_vertices());
  EXPECT_EQ(4u, closed.roots()[0].apex);
  EXPECT_EQ(4u, table.target(table.next(closed.roots()[0].base)));
  std::size_t degree_of_apex = 0;
  for (std::uint32_t h = 0; h < table.num_halfedges(); ++h)
    degree_of_apex += table.source(h) == 4 ? 1 : 0;
  EXPECT_EQ(3u, degree_of_apex);
}

TEST(Closed_triangulation, is_empty_when_moved_from)
{
  const auto size = [](const Closed_triangulation<>& t) {
    return t.first_apex() + t.num_open_faces() + t.simple().num_user_vertices() + t.roots().size()
         + t.components().size() + t.table().num_vertices() + t.table().num_halfedges();
  };
  Corner_table<> table(4, tetrahedron);
  Closed_triangulation<> closed(std::move(table)), other;
  EXPECT_EQ(0u, table.num_vertices() + table.num_halfedges());
  other = std::move(closed);
  EXPECT_EQ(0u, size(closed));
  closed = Closed_triangulation<>(std::move(other));
  EXPECT_EQ(0u, size(other));
  EXPECT_NE(0u, size(closed));
}

TEST(Closed_triangulation, refuses_a_mesh_whose_apex_the_index_type_cannot_number)
{
  const Soup last = test::octasphere(0), most = test::double_wheel(43), too_many = test::double_wheel(44);
  for (const Soup& soup : {last, most})
    EXPECT_EQ("nothing", refusal([&] {
      Closed_triangulation<std::uint8_t> closed{Corner_table<std::uint8_t>(soup.num_vertices, soup.triangles)};
    }));
  EXPECT_EQ(text(Mesh_defect::too_many_elements, 86), refusal([&] {
    Closed_triangulation<std::uint8_t> closed{Corner_table<std::uint8_t>(too_many.num_vertices, too_many.triangles)};
  }));
}

template <class Layout>
struct Layout_of_narrow_indices
  : public ::testing::Test
{};
using Narrow_layouts = ::testing::Types<
  CGAL::Schnyder_parents_layout<4, std::uint8_t>, CGAL::Schnyder_parents_layout<5, std::uint8_t>,
  CGAL::Schnyder_parents_layout<6, std::uint8_t>, CGAL::Schnyder_parents_layout<4, std::uint16_t>,
  CGAL::Schnyder_parents_layout<5, std::uint16_t>, CGAL::Schnyder_parents_layout<6, std::uint16_t>,
  CGAL::Corner_table_layout<std::uint8_t>, CGAL::Corner_table_layout<std::uint16_t>>;
TYPED_TEST_SUITE(Layout_of_narrow_indices, Narrow_layouts);

TYPED_TEST(Layout_of_narrow_indices, holds_as_many_vertices_as_it_says_and_refuses_one_more)
{
  using Index = typename TypeParam::Index;
  const std::uint32_t most = static_cast<std::uint32_t>(TypeParam::max_vertices());
  for (const Soup& soup : {test::random_triangulation(most, 4), test::double_wheel(most),
                           test::stacked_at_hub(most), test::stacked_triangulation(most, 4)})
    EXPECT_EQ("", test::difference_from_table<TypeParam>(most, soup.triangles));
  const Soup soup = test::double_wheel(most + 1);
  CGAL::Input_images<Index> images;
  images.vertices.assign(1, 7);
  EXPECT_EQ(Mesh_defect::too_many_elements, thrown_by([&] {
    Closed_triangulation<Index> closed{Corner_table<Index>(soup.num_vertices, soup.triangles)};
    TypeParam(std::move(closed), images);
  }).at(0).first);
  EXPECT_EQ(std::vector<Index>(1, 7), images.vertices);
}

TEST(Schnyder_parents_layout, of_16_bit_indices_holds_4096_vertices)
{
  EXPECT_EQ(4096u, (CGAL::Schnyder_parents_layout<4, std::uint16_t>::max_vertices()));
  EXPECT_EQ(std::size_t(1) << 28, CGAL::Schnyder_parents_layout<>::max_vertices());
}

TYPED_TEST(Layout_of_narrow_indices, is_empty_when_moved_from)
{
  using Index = typename TypeParam::Index;
  const auto size = [](const TypeParam& layout) {
    std::size_t bytes = 0;
    for (const auto& array : layout.memory())
      bytes += array.second;
    return bytes + layout.num_vertices() + layout.num_halfedges() + layout.num_edges() + layout.num_faces();
  };
  CGAL::Input_images<Index> images;
  Closed_triangulation<Index> closed{Corner_table<Index>(4, tetrahedron)};
  TypeParam layout(std::move(closed), images);
  EXPECT_EQ(0u, closed.first_apex() + closed.table().num_vertices() + closed.table().num_halfedges());
  const std::size_t full = size(layout);
  TypeParam other(std::move(layout));
  EXPECT_EQ(0u, size(layout));
  layout = std::move(other);
  EXPECT_EQ(0u, size(other));
  EXPECT_EQ(full, size(layout));
  EXPECT_EQ(0u, size(TypeParam()));
}
