// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Closed_triangulation: what it adds to an open table, and that nothing is lost.

#include "damaged_soups.h"
#include "generated_triangulations.h"
#include "refusals.h"
#include "soup_oracle.h"
#include "test_scale.h"

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/Corner_table.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using CGAL::Closed_triangulation;
using CGAL::Corner_table;
using CGAL::Mesh_defect;
using test::Polygon_soup;
using test::Soup;
using test::refusal;
using test::text;

const test::Triangles tetrahedron{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};

Corner_table<> table_of(const Polygon_soup& soup) { return Corner_table<>(soup.num_vertices, soup.faces); }

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
  const auto original = [&](std::uint32_t v) {
    return v < closed.first_copy() ? v : closed.copies()[v - closed.first_copy()];
  };
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

} // namespace

TEST(Closed_triangulation, of_random_soups_is_closed_and_loses_nothing)
{
  std::mt19937 rng(2);
  const std::vector<Polygon_soup> surfaces = test::small_surfaces();
  std::size_t num_closed = 0;
  const std::size_t num_soups = (std::max<std::size_t>)(3000, test::scaled(100000));
  for (std::size_t i = 0; i < num_soups; ++i) {
    const Polygon_soup soup = test::random_soup(surfaces, rng);
    Corner_table<> table;
    if (!test::thrown_by([&] { table = table_of(soup); }).empty())
      continue;
    ASSERT_EQ("", error_of_closing(std::move(table))) << soup;
    ++num_closed;
  }
  EXPECT_LT(num_soups / 20, num_closed);
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
