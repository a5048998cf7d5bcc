// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The bytes that layouts really allocate for large surfaces of all kinds: per vertex, and beside
// that for each component, border, handle, fan and isolated vertex. This program counts
// them, so it is one of its own: it replaces the global operator new.

#include "counted_allocation.h"
#include "large_surfaces.h"
#include "test_scale.h"

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/Simple_triangulation.h>
#include <CGAL/Compact_surface_mesh/layouts/Corner_table_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/Input_order_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/Laced_ring_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/SOT_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/SQuad_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/Schnyder_fronts_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/Schnyder_parents_layout.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <string>
#include <type_traits>
#include <vector>

namespace {

using test::Counted_allocation;
using test::Polygon_soup;
using test::Soup;
template <int References> using Parents_layout = CGAL::Schnyder_parents_layout<References>;
template <class Entry> using Ring_layout = CGAL::Laced_ring_layout<std::uint32_t, Entry>;
using Corner_layout = CGAL::Corner_table_layout<>;

const std::vector<test::Triangle>& faces_of(const Soup& soup) { return soup.triangles; }
const std::vector<std::vector<long long>>& faces_of(const Polygon_soup& soup) { return soup.faces; }

template <class AnySoup>
CGAL::Simple_triangulation<> triangulation_of(const AnySoup& soup)
{
  return CGAL::Simple_triangulation<>(soup.num_vertices, faces_of(soup));
}

template <class Layout, class AnySoup>
Layout layout_of(const AnySoup& soup)
{
  CGAL::Input_images<> images;
  return Layout(CGAL::Closed_triangulation<>(triangulation_of(soup)), images);
}

// The bytes that a layout allocates. They must be those that it reports. A copy has no room for more
// than it holds: the parents layouts must not have, either.
template <class Layout, class AnySoup>
double bytes_of(const AnySoup& soup, std::ptrdiff_t euler_characteristic)
{
  const std::size_t before = Counted_allocation::live();
  std::size_t allocated;
  {
    const Layout layout = layout_of<Layout>(soup);
    allocated = Counted_allocation::live() - before;
    std::size_t reported = 0;
    for (const auto& array : layout.memory())
      reported += array.second;
    EXPECT_NEAR(static_cast<double>(allocated), static_cast<double>(reported), 0.001 * allocated) << Layout::name();
    const std::size_t before_copy = Counted_allocation::live();
    const Layout copy(layout);
    const double slack = static_cast<double>(allocated) - static_cast<double>(Counted_allocation::live() - before_copy);
    constexpr bool may_have_slack = std::is_same<Layout, Corner_layout>::value;
    EXPECT_LE(slack, may_have_slack ? 0.001 * allocated : 0.) << Layout::name();
    EXPECT_EQ(soup.num_vertices, copy.num_vertices()) << Layout::name();
    EXPECT_EQ(faces_of(soup).size(), copy.num_faces()) << Layout::name();
    EXPECT_EQ(euler_characteristic, static_cast<std::ptrdiff_t>(copy.num_vertices() + copy.num_faces())
                                      - static_cast<std::ptrdiff_t>(copy.num_edges())) << Layout::name();
  }
  EXPECT_EQ(before, Counted_allocation::live()) << Layout::name();
  return static_cast<double>(allocated);
}

template <class AnySoup>
double surface_mesh_bytes_of(const AnySoup& soup)
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  std::size_t num_sides = 0;
  for (const auto& face : faces_of(soup))
    num_sides += face.size();
  const std::size_t before = Counted_allocation::live();
  Mesh mesh;
  const auto size = [](std::size_t i) { return static_cast<Mesh::size_type>(i); };
  mesh.reserve(size(soup.num_vertices), size(num_sides / 2), size(faces_of(soup).size()));
  for (std::size_t v = 0; v < soup.num_vertices; ++v)
    mesh.add_vertex(Point(0, 0, 0));
  std::vector<Mesh::Vertex_index> vertices;
  for (const auto& face : faces_of(soup)) {
    vertices.clear();
    for (const auto v : face)
      vertices.push_back(Mesh::Vertex_index(size(static_cast<std::size_t>(v))));
    EXPECT_NE(Mesh::null_face(), mesh.add_face(vertices));
  }
  vertices = std::vector<Mesh::Vertex_index>();
  return static_cast<double>(Counted_allocation::live() - before - soup.num_vertices * sizeof(Point));
}

std::uint32_t million()
{
  return static_cast<std::uint32_t>((std::max<std::size_t>)(20000, test::scaled(1000000)));
}

// A surface of triangles and what it may cost beside its vertices.
struct Surface
{
  Soup soup;
  std::size_t num_components = 1, num_borders = 0, num_handles = 0, num_pinched = 0, num_isolated = 0;

  std::ptrdiff_t euler_characteristic() const
  {
    return 2 * static_cast<std::ptrdiff_t>(num_components) - 2 * static_cast<std::ptrdiff_t>(num_handles)
           - static_cast<std::ptrdiff_t>(num_borders) - static_cast<std::ptrdiff_t>(num_pinched)
           + static_cast<std::ptrdiff_t>(num_isolated);
  }

  double num_special() const
  {
    return 2. * static_cast<double>(num_handles)
           + (num_borders > num_components ? static_cast<double>(num_borders - num_components) : 0);
  }

  // At most so many words of 4 bytes: 15 a component, 31 a special edge of the wood, of which there are two a
  // handle and one a further border, and 14 a vertex with two fans. Each special edge has two further records,
  // and each further fan has one.
  double extra_words(int references) const
  {
    return 15 * static_cast<double>(num_components) + (31 + 2 * (references - 4)) * num_special()
           + (14 + references - 4) * static_cast<double>(num_pinched);
  }
};

Surface surface_of_kind(const std::string& kind, std::uint32_t n)
{
  const auto count = [&](const std::string& prefix) {
    const std::size_t number = std::stoul(kind.substr(prefix.size()));
    return number == 1 ? std::size_t(1) : test::scaled(number);
  };
  if (kind.rfind("genus_", 0) == 0) {
    const std::size_t genus = count("genus_");
    return {test::sphere_with_far_handles(n, static_cast<std::uint32_t>(genus)), 1, 0, genus};
  }
  if (kind == "scaffold") {
    const int k = test::scaffold_size(n);
    return {test::scaffold(k, 2), 1, 0, static_cast<std::size_t>(2 * k * k * k - 3 * k * k + 1)};
  }
  if (kind.rfind("borders_", 0) == 0)
    return {test::mesh_with_borders(n, count("borders_"), 1), 1, count("borders_")};
  if (kind == "large_border") {
    const std::uint32_t side = static_cast<std::uint32_t>(std::sqrt(n));
    return {test::triangle_grid(side, side), 1, 1};
  }
  if (kind.rfind("pinched_", 0) == 0)
    return {test::mesh_with_pinched_vertices(n, 2 * count("pinched_"), 1), 1, 2 * count("pinched_"), 0,
            count("pinched_")};
  const std::size_t num_components = count("components_");
  return {test::many_components(n, static_cast<std::uint32_t>(num_components), 1), num_components};
}

template <int References>
void check_bytes(const Surface& surface)
{
  const double n = surface.soup.num_vertices;
  const double bytes = bytes_of<Parents_layout<References>>(surface.soup, surface.euler_characteristic());
  std::cout << std::fixed << std::setprecision(4) << std::setw(11) << bytes / n << std::flush;
  EXPECT_LE(bytes, (4 * References + 0.1) * n + 4 * surface.extra_words(References)) << References << " references";
}

// One reference a halfedge, and two less for a quad; one a copy of a vertex, and eight for the ways from fan to
// fan; a bit per halfedge with its ranks. Euler tells how many halfedges there are.
double bound_of_opposites(const Surface& surface, double part_with_quad)
{
  const double num_pinched = static_cast<double>(surface.num_pinched);
  const double halfedges = 2 * (surface.soup.num_vertices + static_cast<double>(surface.soup.triangles.size())
                                - static_cast<double>(surface.euler_characteristic()));
  const double edge_bytes = halfedges / 8 * 9 / 8 + halfedges / 2 * 8 / 512;
  return 4 * (halfedges - 2 * part_with_quad * surface.soup.num_vertices + 9 * num_pinched) + edge_bytes + 100;
}

template <class Layout>
void check_opposites(const Surface& surface, double part_with_quad)
{
  const double bytes = bytes_of<Layout>(surface.soup, surface.euler_characteristic());
  std::cout << std::setw(11) << bytes / surface.soup.num_vertices << std::flush;
  EXPECT_LE(bytes, bound_of_opposites(surface, part_with_quad)) << Layout::name();
}

// At most so many words of 4 bytes: 20 a component, 16 a special edge, 10 a vertex with two fans, and as many further
// records as above; and for all borders a byte a vertex, and 4 words for a further fan, which is one of their vertices.
template <int References, bool has_targets>
void check_bytes_of_fronts(const Surface& surface)
{
  using Layout = CGAL::Schnyder_fronts_layout<References, has_targets>;
  const double n = surface.soup.num_vertices;
  const double bytes = bytes_of<Layout>(surface.soup, surface.euler_characteristic());
  std::cout << std::fixed << std::setprecision(4) << std::setw(11) << bytes / n << std::flush;
  const double extra_words = 20. * static_cast<double>(surface.num_components)
                             + (16 + 2 * References) * surface.num_special()
                             + (14 + References) * static_cast<double>(surface.num_pinched);
  EXPECT_LE(bytes, (4 * References + (surface.num_borders == 0 ? 0.01 : 1)) * n + 4 * extra_words) << Layout::name();
}

class Million_vertices
  : public ::testing::TestWithParam<std::string>
{};

TEST_P(Million_vertices, take_their_references_and_a_constant_for_each_component_border_handle_and_fan)
{
  const Surface surface = surface_of_kind(GetParam(), million());
  std::cout << "  " << std::left << std::setw(20) << GetParam() << std::right << std::setw(10)
            << surface.soup.num_vertices << " vertices, bytes a vertex:";
  check_bytes<4>(surface);
  check_bytes<5>(surface);
  check_bytes<6>(surface);
  check_opposites<CGAL::SOT_layout<>>(surface, 0);
  check_opposites<CGAL::SQuad_layout<>>(surface, 0.9);
  check_bytes_of_fronts<6, false>(surface);
  check_bytes_of_fronts<5, false>(surface);
  check_bytes_of_fronts<4, false>(surface);
  check_bytes_of_fronts<5, true>(surface);
  const double n = surface.soup.num_vertices;
  std::cout << std::setw(11) << bytes_of<Corner_layout>(surface.soup, surface.euler_characteristic()) / n;
  for (const double bytes : {bytes_of<Ring_layout<std::uint32_t>>(surface.soup, surface.euler_characteristic()),
                             bytes_of<Ring_layout<std::uint16_t>>(surface.soup, surface.euler_characteristic())})
    std::cout << std::setw(11) << bytes / n;
  std::cout << std::endl;
}

INSTANTIATE_TEST_SUITE_P(Surfaces_of_a, Million_vertices,
                         ::testing::Values("genus_1", "genus_100", "genus_10000", "scaffold", "borders_1",
                                           "borders_1000", "large_border", "pinched_500", "components_1",
                                           "components_1000"),
                         [](const auto& test) { return test.param; });

// The words that a layout of four references holds beside the records of the vertices.
double further_words(const Surface& surface)
{
  return bytes_of<Parents_layout<4>>(surface.soup, surface.euler_characteristic()) / 4
         - 4. * surface.soup.num_vertices;
}

void check_words(const std::string& name, double words, std::size_t count, double bound)
{
  const double each = words / static_cast<double>(count);
  std::cout << "  " << std::left << std::setw(56) << name << std::right << std::fixed << std::setprecision(2)
            << std::setw(8) << each << " words, at most " << std::setprecision(0) << bound << std::endl;
  EXPECT_LE(each, bound) << name;
}

TEST(Handles, cost_at_most_62_words_each)
{
  const std::uint32_t n = million() / 4;
  const Surface far = surface_of_kind("genus_2500", n);
  check_words("handle across a sphere", further_words(far) - further_words({test::regular_sphere(n)}), far.num_handles,
              62);
  // where handles are as many as can be, there is nothing to subtract but one component
  const std::uint32_t num_tori = n / 10;
  check_words("handle of a chain of tori", further_words({test::chain_of_tori(num_tori), 1, 0, num_tori}) - 15,
              num_tori, 62);
  const std::size_t k = static_cast<std::size_t>(std::lround(std::cbrt(n / 8)));
  const std::size_t genus = 2 * k * k * k - 3 * k * k + 1;
  check_words("handle of a coarse scaffold", further_words({test::scaffold(static_cast<int>(k), 0), 1, 0, genus}) - 15,
              genus, 62);
  const std::uint32_t few = n / 200;
  check_words("handle of a random surface", further_words({test::closed_surface(few, 5 * few, 1), 1, 0, few}) - 15, few,
              62);
}

TEST(Components, cost_at_most_15_words_each)
{
  const std::uint32_t count = million() / 100;
  for (const std::uint32_t size : {4, 5, 6, 8})
    check_words("component of " + std::to_string(size) + " vertices",
                further_words({test::many_components(size * count, count, 1), count}), count, 15);
}

TEST(Borders, cost_nothing_for_a_vertex_and_at_most_31_words_for_each_one_but_the_first)
{
  const std::uint32_t n = million() / 4, side = static_cast<std::uint32_t>(std::sqrt(n));
  check_words("component whose border has " + std::to_string(4 * side) + " vertices",
              further_words({test::triangle_grid(side, side), 1, 1}), 1, 15);
  const Surface one = surface_of_kind("borders_1", n), many = surface_of_kind("borders_1000", n);
  check_words("further border", further_words(many) - further_words(one), many.num_borders - 1, 31);
  const std::size_t most = n / 20;
  check_words("further border, where they are close to each other",
              further_words({test::mesh_with_borders(n, most, 1), 1, most}) - further_words(one), most - 1, 31);
}

TEST(Fans, cost_at_most_14_words_for_a_vertex_with_two_of_them)
{
  const std::uint32_t n = million() / 4;
  const Surface without = surface_of_kind("borders_1000", n), with = surface_of_kind("pinched_500", n);
  check_words("vertex with two fans", further_words(with) - further_words(without), with.num_pinched, 14);
}

TEST(Isolated_vertices, cost_a_record_each)
{
  Surface surface{test::regular_sphere(million() / 4)};
  const double words = further_words(surface);
  const std::uint32_t count = 1000;
  surface.soup.num_vertices += count;
  surface.num_isolated = count;
  EXPECT_EQ(words, further_words(surface));
}

TEST(Order_of_the_input, costs_8_bytes_a_vertex_and_8_a_face)
{
  using Base = Parents_layout<4>;
  const Surface surface = surface_of_kind("borders_1000", million() / 4);
  const std::ptrdiff_t chi = surface.euler_characteristic();
  const double n = surface.soup.num_vertices, f = static_cast<double>(surface.soup.triangles.size());
  const double base = bytes_of<Base>(surface.soup, chi);
  EXPECT_EQ(bytes_of<CGAL::Input_order_layout<Base>>(surface.soup, chi), base + 8 * n);
  using With_faces = CGAL::Input_order_layout<Base, CGAL::Input_order::VERTICES_AND_FACES>;
  EXPECT_EQ(bytes_of<With_faces>(surface.soup, chi), base + 8 * n + 8 * f);
}

// A layout of polygons has a record for each vertex, hidden ones included; a bit for each vertex, edge and face
// of its triangles, and for the ranks of these an eighth of that, and 8 bytes for each 512 that are the user's; and
// a word for each hidden vertex. The constant is for what is rounded up, and for the component.
double bound_of_polygons(const Polygon_soup& soup, std::ptrdiff_t euler_characteristic)
{
  const CGAL::Simple_triangulation<> t = triangulation_of(soup);
  const double records = static_cast<double>(t.table().num_vertices());
  const double faces = static_cast<double>(t.table().num_faces());
  const double edges = records + faces - static_cast<double>(euler_characteristic);
  const double user_faces = static_cast<double>(soup.faces.size());
  const double user_edges = soup.num_vertices + user_faces - static_cast<double>(euler_characteristic);
  return 16.1 * records + (records + edges + faces) / 8 * 9 / 8
         + (soup.num_vertices + user_edges + user_faces) * 8 / 512 + 4. * static_cast<double>(t.stands_for().size())
         + 1000;
}

// Surface_mesh must take more than `ratio` times as much.
void check_polygons(const std::string& name, const Polygon_soup& soup, std::ptrdiff_t euler_characteristic,
                    double ratio)
{
  const double n = static_cast<double>(soup.num_vertices);
  const double ours = bytes_of<Parents_layout<4>>(soup, euler_characteristic);
  const double corners = bytes_of<Corner_layout>(soup, euler_characteristic);
  const double bound = bound_of_polygons(soup, euler_characteristic), theirs = surface_mesh_bytes_of(soup);
  std::cout << "  " << std::left << std::setw(34) << name << std::right << std::setw(9) << soup.num_vertices
            << " vertices, bytes a vertex: " << std::fixed << std::setprecision(4) << ours / n << ", bound "
            << bound / n << "; corner table " << corners / n << "; Surface_mesh " << theirs / n << std::endl;
  EXPECT_LE(ours, bound) << name;
  EXPECT_LE(ours / n, 17.1) << name;
  EXPECT_LT(ratio * ours, theirs) << name;
}

TEST(Polygons, cost_a_record_a_vertex_and_bits)
{
  const std::uint32_t n = million(), side = static_cast<std::uint32_t>(std::sqrt(n));
  check_polygons("quads", test::quad_grid(side, side), 1, 4);
  check_polygons("triangles and one polygon", test::globe_with_polygon(10, n / 10), 2, 6);
  check_polygons("one polygon", test::polygon(n / 10), 1, 2);
}

} // namespace
