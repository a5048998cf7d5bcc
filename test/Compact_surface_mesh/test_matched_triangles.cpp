// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Triangles that are given to vertices, one or two each: what SOT and SQuad stand on.

#include "generated_surfaces.h"
#include "generated_triangulations.h"
#include "layout_of_soup.h"
#include "real_mesh.h"
#include "small_triangulations.h"
#include "test_scale.h"

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/Simple_triangulation.h>
#include <CGAL/Compact_surface_mesh/layouts/SOT_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/SQuad_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Matched_triangles.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Paired_triangles.h>

#include <CGAL/IO/OFF.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace {

using Index = std::uint32_t;
using Table = CGAL::Corner_table<Index>;
using Closed = CGAL::Closed_triangulation<Index>;
using Matched = CGAL::internal::Matched_triangles<Index>;
using Paired = CGAL::internal::Paired_triangles<Index>;

Closed closed_triangulation(const test::Polygon_soup& soup)
{
  Closed t(CGAL::Simple_triangulation<Index>(soup.num_vertices, soup.faces));
  t.remove_caps();
  return t;
}

// How many vertices of each component of two triangles remain without one: one each.
std::size_t num_components_of_two_triangles(const Table& table)
{
  std::size_t num_triangles = 0;
  for (Index h = 0; h < table.num_halfedges(); h += 3)
    num_triangles += Table::face(table.opposite(h)) == Table::face(table.opposite(h + 1))
                     && Table::face(table.opposite(h)) == Table::face(table.opposite(h + 2));
  return num_triangles / 2;
}

// What is wrong with the triangles that vertices have, `paired` or one each.
std::string defect(const Closed& t, const Matched& matched, const Paired* paired)
{
  const Table& table = t.table();
  std::vector<bool> is_given(table.num_faces(), false), is_isolated(t.first_apex(), true);
  for (Index h = 0; h < table.num_halfedges(); ++h)
    if (table.target(h) < t.first_apex())
      is_isolated[table.target(h)] = false;
  std::size_t num_without = 0;
  const auto take = [&](Index h, Index v) {
    const Index f = Table::face(h);
    if (table.target(h) != v || matched.owner(f) != v || is_given[f])
      return false;
    is_given[f] = true;
    return true;
  };
  for (Index v = 0; v < t.first_apex(); ++v) {
    const Index h = matched.into(v);
    if (h == Table::null()) {
      num_without += is_isolated[v] ? 0 : 1;
      continue;
    }
    if (!take(h, v))
      return "triangle of vertex " + std::to_string(v);
    if (paired && paired->is_pair(v)) {
      if (v >= t.first_copy())
        return "two triangles of copy " + std::to_string(v);
      if (!take(matched.following(h), v) || Table::face(h) >= t.num_open_faces())
        return "two triangles of vertex " + std::to_string(v);
    }
  }
  if (num_without != num_components_of_two_triangles(table))
    return std::to_string(num_without) + " vertices without triangle";
  for (Index f = 0; f < table.num_faces(); ++f) {
    if (!is_given[f] && (matched.owner(f) != Table::null() || f >= t.num_open_faces()))
      return "triangle " + std::to_string(f);
    if (f >= t.num_open_faces() && matched.owner(f) != table.target(3 * f))
      return "triangle " + std::to_string(f) + " behind a border";
  }
  return "";
}

std::string defect(const test::Polygon_soup& soup)
{
  const Closed t = closed_triangulation(soup);
  Matched matched(t);
  const std::string of_one = defect(t, matched, nullptr);
  if (!of_one.empty())
    return of_one;
  const Paired paired(matched);
  return defect(t, matched, &paired);
}

TEST(Matched_triangles, are_one_or_two_at_each_vertex_and_on_a_border_the_one_behind_it)
{
  for (unsigned int seed = 0; seed < test::scaled(2000) + 20; ++seed)
    ASSERT_EQ(defect(test::random_surface(seed)), "") << "seed " << seed;
  test::Surface_options options;
  options.max_vertices = static_cast<std::uint32_t>(test::scaled(20000)) + 50;
  options.max_genus = 200;
  for (unsigned int seed = 0; seed < 10; ++seed)
    ASSERT_EQ(defect(test::random_surface(seed, options)), "") << "seed " << seed;
}

TEST(Matched_triangles, are_found_on_all_small_triangulations)
{
  for (int n = 4; n <= test::largest_exhaustive(); ++n)
    for (const auto& map : test::all_sphere_triangulations(n))
      for (const auto& rooted : test::Oriented_map(map).all_codes())
        ASSERT_EQ(defect(test::soup_of(static_cast<std::size_t>(n), rooted)), "") << testing::PrintToString(rooted);
  EXPECT_EQ(defect(test::pillow(3)), "");
  const std::uint32_t k = 1000;
  EXPECT_EQ(defect(test::soup_of(test::many_components(4 * k, k, 1))), "");
}

// The largest number of quads, by trying all choices for one vertex after the other.
class Most_quads
{
public:
  explicit Most_quads(const Table& table)
    : m_table(table), m_is_taken(table.num_faces(), false), m_stars(table.num_vertices())
  {
    for (Index h = 0; h < table.num_halfedges(); ++h)
      m_stars[table.target(h)].push_back(h);
    m_unpaired_allowed = 0;
    while (!can_choose(0, m_unpaired_allowed))
      ++m_unpaired_allowed;
  }

  std::size_t number() const { return m_stars.size() - m_unpaired_allowed; }

private:
  bool can_choose(std::size_t v, std::size_t num_single)
  {
    if (v == m_stars.size())
      return true;
    if (2 * (m_stars.size() - v) > num_free() + num_single)
      return false;
    for (const Index h : m_stars[v]) {
      const Index f = Table::face(h), g = Table::face(m_table.opposite(Table::next(h)));
      if (m_is_taken[f])
        continue;
      m_is_taken[f] = true;
      bool can = false;
      if (!m_is_taken[g]) {
        m_is_taken[g] = true;
        can = can_choose(v + 1, num_single);
        m_is_taken[g] = false;
      }
      can = can || (num_single > 0 && can_choose(v + 1, num_single - 1));
      m_is_taken[f] = false;
      if (can)
        return true;
    }
    return false;
  }

  std::size_t num_free() const
  {
    return static_cast<std::size_t>(std::count(m_is_taken.begin(), m_is_taken.end(), false));
  }

  const Table& m_table;
  std::vector<bool> m_is_taken;
  std::vector<std::vector<Index>> m_stars; // the halfedges into each vertex
  std::size_t m_unpaired_allowed;
};

std::size_t num_quads(const Closed& t)
{
  Matched matched(t);
  const Paired paired(matched);
  std::size_t result = 0;
  for (Index v = 0; v < t.first_apex(); ++v)
    result += paired.is_pair(v);
  return result;
}

TEST(Quads, are_as_many_as_can_be_on_small_spheres)
{
  for (int n = 4; n <= test::largest_exhaustive(); ++n)
    for (const auto& map : test::all_sphere_triangulations(n)) {
      const Closed t = closed_triangulation(test::soup_of(static_cast<std::size_t>(n), map));
      EXPECT_EQ(num_quads(t), Most_quads(t.table()).number()) << testing::PrintToString(map);
    }
}

// All that a layout holds but single bits, in integers.
template <class Layout>
std::size_t references_of(const test::Polygon_soup& soup)
{
  CGAL::Input_images<> images;
  std::size_t bytes = 0;
  for (const auto& [name, size] : test::layout_of<Layout>(soup, images).memory())
    if (name.size() < 4 || name.compare(name.size() - 4, 4, "bits") != 0)
      bytes += size;
  return bytes / sizeof(Index);
}

template <class Layout>
std::size_t references_of(const test::Soup& soup)
{
  return references_of<Layout>(test::soup_of(soup));
}

// Those along borders, too.
std::size_t num_halfedges_of(const Closed& t) { return 2 * t.num_open_faces() + t.table().num_faces(); }

TEST(References, are_one_a_halfedge_and_two_less_for_a_quad)
{
  EXPECT_EQ(references_of<CGAL::SOT_layout<>>(test::octasphere(3)), 6u * 258 - 12);
  EXPECT_EQ(references_of<CGAL::SOT_layout<>>(test::torus_grid(10, 10)), 600u);
  const test::Soup holes = test::mesh_with_borders(1000, 10, 1);
  EXPECT_EQ(references_of<CGAL::SOT_layout<>>(holes), 6u * holes.num_vertices - 12);
  test::Surface_options options;
  options.has_polygons = false;
  for (unsigned int seed = 0; seed < test::scaled(300) + 20; ++seed) {
    const test::Polygon_soup soup = test::random_surface(seed, options);
    const Closed t = closed_triangulation(soup);
    if (!t.copies().empty())
      continue;
    const std::size_t num_halfedges = num_halfedges_of(t);
    const std::size_t without = num_components_of_two_triangles(t.table());
    ASSERT_EQ(references_of<CGAL::SOT_layout<>>(soup), num_halfedges + without) << "seed " << seed;
    ASSERT_EQ(references_of<CGAL::SQuad_layout<>>(soup), num_halfedges + without - 2 * num_quads(t))
        << "seed " << seed;
  }
}

std::size_t num_vertices_with_faces(const test::Polygon_soup& soup)
{
  std::vector<bool> has_face(soup.num_vertices, false);
  for (const auto& face : soup.faces)
    for (const long long v : face)
      has_face[static_cast<std::size_t>(v)] = true;
  return static_cast<std::size_t>(std::count(has_face.begin(), has_face.end(), true));
}

TEST(References, of_real_meshes_are_six_and_little_more_than_four_a_vertex)
{
  if (test::real_mesh("cow.off").num_vertices == 0)
    GTEST_SKIP() << "CGAL's meshes are not there: run scripts/fetch_meshes";
  std::cout << std::fixed << std::setprecision(3);
  const bool all = test::scaled(1000) >= 1000;
  for (const std::string name : {"cow", "elephant", "armadillo", "bear", "bull", "bunny00", "camel", "diplodocus",
                                 "hand", "homer", "lion", "man", "nefertiti", "pig"}) {
    const test::Soup soup = test::real_mesh(name + ".off");
    const double n = soup.num_vertices;
    if (!all && n > 5000)
      continue;
    const std::size_t sot = references_of<CGAL::SOT_layout<>>(soup);
    const double squad = static_cast<double>(references_of<CGAL::SQuad_layout<>>(soup)) / n;
    std::cout << "  " << std::left << std::setw(12) << name << std::right << std::setw(8) << soup.num_vertices
              << " vertices, references a vertex: SOT " << static_cast<double>(sot) / n << ", SQuad " << squad
              << std::flush;
    EXPECT_EQ(sot, num_halfedges_of(closed_triangulation(test::soup_of(soup)))) << name;
    EXPECT_LE(squad, 4.2) << name;
    const test::Soup finer = test::subdivided(soup);
    const double of_finer = static_cast<double>(references_of<CGAL::SQuad_layout<>>(finer)) / finer.num_vertices;
    std::cout << ", subdivided " << of_finer << std::endl;
    EXPECT_LE(of_finer, 4.1) << name;
  }
}

// A mesh of CGAL's data with faces of any number of sides; none if it is no manifold.
test::Polygon_soup real_surface(const std::filesystem::path& file)
{
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  test::Polygon_soup soup{0, {}};
  if (!CGAL::IO::read_OFF(file.string(), points, soup.faces))
    return {0, {}};
  soup.num_vertices = points.size();
  try {
    closed_triangulation(soup);
  } catch (const CGAL::Mesh_defect_exception&) {
    return {0, {}};
  }
  return soup;
}

// Also where there are many borders or, as in cheese.off, handles.
TEST(References, of_all_real_meshes_of_1000_vertices_or_more_are_at_most_4_25_a_vertex)
{
  const std::filesystem::path folder = CGAL::data_file_path("meshes");
  if (!std::filesystem::is_directory(folder))
    GTEST_SKIP() << "CGAL's meshes are not there: run scripts/fetch_meshes";
  const std::size_t largest_file = test::scaled(1000) >= 1000 ? std::size_t(-1) : 400000;
  double most = 0;
  std::size_t num_meshes = 0;
  bool has_many_borders = false;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().extension() != ".off" || file.file_size() > largest_file)
      continue;
    const test::Polygon_soup soup = real_surface(file.path());
    const std::size_t n = num_vertices_with_faces(soup);
    if (n < 1000)
      continue;
    const double squad = static_cast<double>(references_of<CGAL::SQuad_layout<>>(soup)) / static_cast<double>(n);
    EXPECT_LE(squad, 4.25) << file.path().filename();
    has_many_borders = has_many_borders || file.path().filename() == "elephant-with-holes.off";
    most = (std::max)(most, squad);
    ++num_meshes;
  }
  std::cout << "  SQuad, " << num_meshes << " meshes: at most " << most << " references a vertex\n";
  EXPECT_GE(num_meshes, 20u);
  EXPECT_TRUE(has_many_borders);
}

TEST(References, of_generated_meshes_are_little_more_than_four_a_vertex)
{
  const std::uint32_t n = static_cast<std::uint32_t>(test::scaled(200000)) + 1000;
  const auto check = [](const std::string& name, const test::Soup& soup, double bound) {
    const double squad = static_cast<double>(references_of<CGAL::SQuad_layout<>>(soup)) / soup.num_vertices;
    std::cout << "  " << std::left << std::setw(30) << name << std::right << std::setw(8) << soup.num_vertices
              << " vertices, references a vertex: SQuad " << squad << std::endl;
    EXPECT_LE(squad, bound) << name;
  };
  check("regular sphere", test::regular_sphere(n), 4.2);
  check("shuffled sphere", test::shuffled(test::regular_sphere(n), 1), 4.2);
  check("torus", test::torus_grid(n / 100, 100), 4.2);
  check("random triangulation", test::random_triangulation(n, 1), 4.2);
  check("stacked triangulation", test::stacked_triangulation(n, 1), 4.25);
  check("wheels", test::double_wheel(n), 4.01);
}

} // namespace
