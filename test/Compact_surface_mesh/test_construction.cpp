// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// What large meshes cost: the bytes that they really allocate, at the end and at the peak of
// their construction, and the steps of the longest walk of an operator. This program counts
// both, so it is one of its own: it replaces the global operator new, and defines a macro
// before it includes the layouts.

#include <cstddef>

namespace test {
inline std::size_t num_steps = 0; // of all walks along the lists of a vertex
}
#define CGAL_SCHNYDER_PARENTS_LAYOUT_COUNT_STEP ++test::num_steps;
#define CGAL_SCHNYDER_FRONTS_LAYOUT_COUNT_STEP ++test::num_steps;

#include "counted_allocation.h"
#include "generated_surfaces.h"
#include "generated_triangulations.h"
#include "real_mesh.h"
#include "test_scale.h"

#include <CGAL/Compact_surface_mesh.h>
#include <CGAL/Compact_surface_mesh/layouts/Corner_table_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/Laced_ring_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/SOT_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/SQuad_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/Schnyder_fronts_layout.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/use.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace {

using test::Counted_allocation;
using test::Soup;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Surface_mesh = CGAL::Surface_mesh<Point>;
template <int References> using Parents_layout = CGAL::Schnyder_parents_layout<References>;

template <class Layout>
Layout layout_of(const Soup& soup)
{
  CGAL::Input_images<> images;
  return Layout(CGAL::Closed_triangulation<>(CGAL::Corner_table<>(soup.num_vertices, soup.triangles)), images);
}

// In the most sparing way that Surface_mesh offers.
Surface_mesh surface_mesh_of(const std::vector<Point>& points, const Soup& soup)
{
  using V = Surface_mesh::Vertex_index;
  Surface_mesh mesh;
  const std::uint32_t num_faces = static_cast<std::uint32_t>(soup.triangles.size());
  mesh.reserve(soup.num_vertices, num_faces / 2 * 3, num_faces);
  for (const Point& p : points)
    mesh.add_vertex(p);
  for (const auto& t : soup.triangles)
    EXPECT_NE(Surface_mesh::null_face(), mesh.add_face(V(t[0]), V(t[1]), V(t[2])));
  return mesh;
}

std::size_t sum_of_bytes(const std::vector<std::pair<std::string, std::size_t>>& memory)
{
  std::size_t sum = 0;
  for (const auto& array : memory)
    sum += array.second;
  return sum;
}

void print(const std::string& what, std::size_t bytes, const Soup& soup, const char* comment = "")
{
  std::cout << "  " << std::left << std::setw(44) << what << std::right << std::fixed << std::setprecision(4)
            << std::setw(9) << static_cast<double>(bytes) / soup.num_vertices << " bytes a vertex" << comment << "\n";
}

// `soup`, its triangles cut until there are about as many vertices as are wanted.
Soup subdivided_to(std::size_t num_vertices, Soup soup)
{
  while (2 * std::size_t(soup.num_vertices) < num_vertices)
    soup = test::subdivided(soup);
  return soup;
}

// The meshes of a million vertices.
class Million
  : public ::testing::TestWithParam<std::string>
{
protected:
  void SetUp() override
  {
    const std::size_t n = (std::max<std::size_t>)(20000, test::scaled(1000000));
    const std::string kind = GetParam();
    if (kind == "bunny00" || kind == "bear") {
      m_soup = test::real_mesh(kind + ".off");
      if (m_soup.num_vertices == 0)
        GTEST_SKIP() << "CGAL's meshes are not there: run scripts/fetch_meshes";
      m_soup = subdivided_to(n, m_soup);
    } else if (kind == "octahedron")
      m_soup = subdivided_to(n, test::octasphere(0));
    else if (kind == "globe") {
      const std::uint32_t num_circles = static_cast<std::uint32_t>(std::sqrt(n));
      m_soup = test::globe(num_circles, num_circles);
    } else
      m_soup = test::random_triangulation(static_cast<std::uint32_t>(n), 1);
    std::cout << kind << ", " << m_soup.num_vertices << " vertices\n";
  }

  Soup m_soup;
};

template <class Layout>
void check_bytes(const Soup& soup, double bound)
{
  const std::size_t before = Counted_allocation::live();
  {
    const Layout layout = layout_of<Layout>(soup);
    const std::size_t allocated = Counted_allocation::live() - before;
    const std::size_t reported = sum_of_bytes(layout.memory());
    print(Layout::name() + ", allocated", allocated, soup);
    print(Layout::name() + ", reported", reported, soup);
    EXPECT_NEAR(static_cast<double>(allocated), static_cast<double>(reported), 0.001 * allocated) << Layout::name();
    EXPECT_LE(static_cast<double>(allocated) / soup.num_vertices, bound) << Layout::name();
    EXPECT_EQ(soup.num_vertices, layout.num_vertices());
  }
  EXPECT_EQ(before, Counted_allocation::live()) << Layout::name();
}

TEST_P(Million, vertices_take_four_five_or_six_words_each_and_layouts_report_what_they_allocate)
{
  check_bytes<Parents_layout<4>>(m_soup, 16.1);
  check_bytes<Parents_layout<5>>(m_soup, 20.1);
  check_bytes<Parents_layout<6>>(m_soup, 24.1);
  check_bytes<CGAL::Schnyder_fronts_layout<6>>(m_soup, 24.1);
  check_bytes<CGAL::Schnyder_fronts_layout<5>>(m_soup, 20.1);
  check_bytes<CGAL::Schnyder_fronts_layout<4>>(m_soup, 16.1);
  check_bytes<CGAL::Schnyder_fronts_layout<5, true>>(m_soup, 20.1);
  check_bytes<CGAL::Corner_table_layout<>>(m_soup, 54);
  check_bytes<CGAL::SOT_layout<>>(m_soup, 25);
  check_bytes<CGAL::SQuad_layout<>>(m_soup, 18.4);
}

// A quarter of the triangles of a random triangulation are off the ring. Real meshes take more as they are, where
// sizes are scaled down, than when they are subdivided, which adds regular vertices.
TEST_P(Million, vertices_take_little_more_than_two_words_each_along_a_ring)
{
  const bool is_random = GetParam() == "random";
  check_bytes<CGAL::Laced_ring_layout<>>(m_soup, is_random ? 28 : m_soup.num_vertices < 100000 ? 9.7 : 9.4);
  check_bytes<CGAL::Laced_ring_layout<std::uint32_t, std::uint16_t>>(m_soup, is_random ? 27 : 8);
}

// The same for the mesh class, and beside it Surface_mesh.
TEST_P(Million, vertices_in_a_mesh_allocate_their_points_and_the_connectivity_bytes_alone)
{
  const std::vector<Point> points(m_soup.num_vertices);
  const std::size_t point_bytes = points.size() * sizeof(Point), before = Counted_allocation::live();
  Counted_allocation::reset_peak();
  std::size_t our_bytes, our_peak;
  {
    const CGAL::Compact_surface_mesh<Point> mesh(points, m_soup.triangles);
    our_bytes = Counted_allocation::live() - before - point_bytes;
    our_peak = Counted_allocation::peak() - before;
    print("Compact_surface_mesh, allocated but points", our_bytes, m_soup);
    print("Compact_surface_mesh, connectivity_bytes()", mesh.connectivity_bytes(), m_soup);
    EXPECT_NEAR(static_cast<double>(our_bytes), static_cast<double>(mesh.connectivity_bytes()), 0.001 * our_bytes);
    EXPECT_LE(static_cast<double>(our_bytes) / m_soup.num_vertices, 16.1);
    EXPECT_LE(mesh.references_per_vertex(), 4.03);
  }
  EXPECT_EQ(before, Counted_allocation::live());
  Counted_allocation::reset_peak();
  const Surface_mesh mesh = surface_mesh_of(points, m_soup);
  const std::size_t bytes = Counted_allocation::live() - before - point_bytes;
  const std::size_t peak = Counted_allocation::peak() - before;
  print("Surface_mesh, allocated but points", bytes, m_soup);
  print("Compact_surface_mesh, peak with points", our_peak, m_soup);
  print("Surface_mesh, peak with points", peak, m_soup);
  EXPECT_LT(our_peak, peak);
  EXPECT_LT(6 * our_bytes, bytes);
}

INSTANTIATE_TEST_SUITE_P(Meshes_of_a, Million,
                         ::testing::Values("bunny00", "bear", "octahedron", "globe", "random"),
                         [](const auto& test) { return test.param; });

// What a mesh does while nothing but `query()` is asked of it.
template <class Query>
void walk(const Query& query, std::size_t& longest)
{
  test::num_steps = 0;
  query();
  longest = (std::max)(longest, test::num_steps);
}

// The steps of the longest walk of a query.
template <class Layout>
std::size_t longest_walk(const Layout& layout)
{
  std::size_t longest = 0;
  volatile std::uint32_t sink = 0; // so that no query is optimized away
  for (std::uint32_t h = 0; h < layout.num_halfedges(); ++h) {
    walk([&] { sink = layout.next(h); }, longest);
    walk([&] { sink = layout.prev(h); }, longest);
    walk([&] { sink = layout.face(h); }, longest);
    walk([&] { sink = layout.source(h); }, longest);
    walk([&] { sink = layout.target(h); }, longest);
    walk([&] { sink = layout.halfedge(layout.source(h), layout.target(h)); }, longest);
  }
  for (std::uint32_t v = 0; v < layout.num_vertices(); ++v)
    walk([&] { sink = layout.halfedge_of_vertex(v); }, longest);
  for (std::uint32_t f = 0; f < layout.num_faces(); ++f) {
    walk([&] { sink = layout.halfedge_of_face(f); }, longest);
    walk([&] { sink = layout.vertices_of_face(f)[0]; }, longest);
  }
  CGAL_USE(sink);
  return longest;
}

template <class Layout>
std::size_t longest_walk(const Soup& soup, const std::string& name)
{
  const CGAL::Corner_table<> table(soup.num_vertices, soup.triangles);
  std::size_t longest = 0;
  for (const auto order : {CGAL::Shelling_order::LAST_IN_FIRST_OUT, CGAL::Shelling_order::FIRST_IN_FIRST_OUT,
                           CGAL::Shelling_order::RANDOM}) {
    CGAL::Input_images<> images;
    const Layout layout(CGAL::Closed_triangulation<>(CGAL::Corner_table<>(table)), images, order, 1);
    const std::size_t steps = longest_walk(layout);
    EXPECT_LE(steps, Layout::max_walk_length())
      << name << ", " << soup.num_vertices << " vertices, order " << static_cast<int>(order);
    longest = (std::max)(longest, steps);
  }
  return longest;
}

struct Longest_walks
{
  std::size_t with_4 = 0, with_5 = 0, with_6 = 0;

  void add(const std::string& name, const Soup& soup)
  {
    const std::size_t walks[] = {longest_walk<Parents_layout<4>>(soup, name),
                                 longest_walk<Parents_layout<5>>(soup, name),
                                 longest_walk<Parents_layout<6>>(soup, name)};
    if (soup.num_vertices >= 1000)
      std::cout << "  " << std::left << std::setw(32) << name << std::right << std::setw(8) << soup.num_vertices
                << " vertices: " << walks[0] << ", " << walks[1] << ", " << walks[2] << " steps\n";
    with_4 = (std::max)(with_4, walks[0]);
    with_5 = (std::max)(with_5, walks[1]);
    with_6 = (std::max)(with_6, walks[2]);
  }
};

TEST(Longest_walk, of_any_operator_is_at_most_the_stated_constant_whatever_the_degrees)
{
  const std::uint32_t n = static_cast<std::uint32_t>((std::max<std::size_t>)(2000, test::scaled(100000)));
  Longest_walks walks;
  std::cout << "the longest walks with 4, 5 and 6 references, in three orders of shelling\n";
  for (const std::uint32_t m : {n, n / 10, n / 100}) {
    walks.add("double wheel", test::double_wheel(m));
    walks.add("double wheel, shuffled", test::shuffled(test::double_wheel(m), 1));
    walks.add("double fan", {m, test::double_fan(m)});
    walks.add("double fan, shuffled", test::shuffled({m, test::double_fan(m)}, 1));
    walks.add("stacked at a hub", test::stacked_at_hub(m));
    walks.add("stacked at a hub, shuffled", test::shuffled(test::stacked_at_hub(m), 1));
    walks.add("stacked", test::stacked_triangulation(m, 1));
    walks.add("stacked, shuffled", test::shuffled(test::stacked_triangulation(m, 1), 1));
    walks.add("random", test::random_triangulation(m, 1));
    walks.add("octahedron", subdivided_to(m, test::octasphere(0)));
    walks.add("globe", test::globe(10, (std::max)(3u, m / 10)));
  }
  // lists of all lengths around the largest one that is walked along
  for (std::uint32_t m = 10; m < 120; ++m)
    for (unsigned int seed = 0; seed < 4; ++seed) {
      walks.add("stacked at a hub, seed " + std::to_string(seed),
                test::shuffled(test::stacked_at_hub(m, seed), seed));
      walks.add("double wheel, seed " + std::to_string(seed), test::shuffled(test::double_wheel(m), seed));
      walks.add("globe, seed " + std::to_string(seed), test::shuffled(test::globe(3, m), seed));
    }
  std::cout << "longest of all: " << walks.with_4 << ", " << walks.with_5 << ", " << walks.with_6
            << " steps; stated: " << Parents_layout<4>::max_walk_length() << std::endl;
  EXPECT_GT(walks.with_4, 20u); // or else nothing was counted
  EXPECT_GT(walks.with_5, 10u);
  EXPECT_EQ(0u, walks.with_6);
}

// The steps of the longest walk to a target.
std::size_t longest_walk_to_target(const Soup& soup)
{
  using Layout = CGAL::Schnyder_fronts_layout<5, true>;
  const Layout layout = layout_of<Layout>(soup);
  std::size_t longest = 0;
  volatile std::uint32_t sink = 0;
  for (std::uint32_t h = 0; h < layout.num_halfedges(); ++h)
    walk([&] { sink = layout.target(h); }, longest);
  CGAL_USE(sink);
  EXPECT_LE(longest, Layout::max_walk_length());
  return longest;
}

// Red edges that form a cycle, with handles, may make two steps of one.
TEST(Longest_walk, to_a_target_is_at_most_the_stated_constant_with_targets)
{
  std::size_t on_spheres = 0, with_handles = 0;
  for (std::uint32_t n = 10; n < 100; ++n) {
    on_spheres = (std::max)(on_spheres, longest_walk_to_target(test::random_triangulation(n, n)));
    on_spheres = (std::max)(on_spheres, longest_walk_to_target(test::shuffled(test::double_wheel(n), n)));
    with_handles = (std::max)(with_handles, longest_walk_to_target(test::closed_surface(1 + n % 20, 400, n)));
  }
  EXPECT_EQ(1u, on_spheres);
  EXPECT_GE(with_handles, 1u);
  std::cout << "longest walk to a target: " << on_spheres << " on spheres, " << with_handles << " with handles\n";
}

} // namespace
