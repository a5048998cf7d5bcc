// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Files of all formats: what is read and written is what Surface_mesh reads and writes.

#include "read_mesh_oracle.h"

#include "binary_off.h"
#include "damaged_soups.h"
#include "generated_surfaces.h"
#include "temporary_file.h"

#include <CGAL/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/layouts/Corner_table_layout.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/io.h>
#include <CGAL/boost/graph/iterator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;
using CGAL::IO::Color;
using test::Polygon_soup;
using test::Temporary_file;
using test::difference;

template <class Kernel_, class Layout_>
struct Types
{
  using Kernel = Kernel_;
  using Layout = Layout_;
};

using Default_layout = CGAL::Schnyder_parents_layout<4>;
using All_types = ::testing::Types<Types<CGAL::Exact_predicates_inexact_constructions_kernel, Default_layout>,
                                   Types<CGAL::Exact_predicates_exact_constructions_kernel, Default_layout>,
                                   Types<CGAL::Simple_cartesian<float>, CGAL::Corner_table_layout<> > >;

// Points that differ, and that every format keeps.
template <class Point>
std::vector<Point> points_of(const Polygon_soup& soup)
{
  std::vector<Point> points;
  for (std::size_t i = 0; i < soup.num_vertices; ++i)
    points.emplace_back(static_cast<double>(i), static_cast<double>(i * 7 % 101) / 4,
                        -static_cast<double>(i * i % 103));
  return points;
}

std::vector<std::vector<std::size_t>> polygons_of(const Polygon_soup& soup)
{
  std::vector<std::vector<std::size_t>> polygons;
  for (const auto& face : soup.faces)
    polygons.emplace_back(face.begin(), face.end());
  return polygons;
}

bool has_only_triangles(const Polygon_soup& soup)
{
  return std::all_of(soup.faces.begin(), soup.faces.end(), [](const auto& face) { return face.size() == 3; });
}

struct Format
{
  std::string ending;
  bool is_binary;
  bool has_only_triangles;
};

const std::vector<Format> formats = { { ".off", false, false }, { ".obj", false, false }, { ".stl", false, true },
                                      { ".stl", true, true },   { ".ply", false, false }, { ".ply", true, false },
                                      { ".ts", false, true } };

template <class Types>
struct Mesh_files
  : public ::testing::Test
{
  using Kernel = typename Types::Kernel;
  using Point = typename Kernel::Point_3;
  using Vector = typename Kernel::Vector_3;
  using Texture = typename Kernel::Point_2;
  using Surface_mesh = CGAL::Surface_mesh<Point>;
  using Mesh = CGAL::Compact_surface_mesh<Point, typename Types::Layout>;
  using V = typename Mesh::Vertex_index;
  using H = typename Mesh::Halfedge_index;
  using E = typename Mesh::Edge_index;
  using F = typename Mesh::Face_index;
  // CGAL does not write soups of exact points, and does not read doubles from PLY where coordinates are floats.
  using Written_point = std::conditional_t<std::is_same<typename Kernel::FT, float>::value, Point,
                                           CGAL::Simple_cartesian<double>::Point_3>;
  using SV = typename Surface_mesh::Vertex_index;
  using SE = typename Surface_mesh::Edge_index;
  using SH = typename Surface_mesh::Halfedge_index;
  using SF = typename Surface_mesh::Face_index;

  // Expects that read(mesh) answers and makes the same for both meshes.
  template <class Read>
  static void expect_same(const Read& read)
  {
    Surface_mesh expected;
    Mesh mesh;
    const bool is_read = read(expected);
    EXPECT_EQ(read(mesh), is_read);
    if (is_read) {
      EXPECT_EQ(difference(expected, mesh), "");
    }
  }

  // Vertices with several fans are doubled to orient a soup.
  static bool has_oriented_soup_different_points(const std::string& name)
  {
    Surface_mesh mesh;
    return PMP::IO::read_polygon_mesh(name, mesh)
        && test::Read_mesh_oracle<Surface_mesh, Mesh>(mesh, Mesh()).is_applicable();
  }

  static void expect_same_from_file(const std::string& name)
  {
    expect_same([&](auto& mesh) { return CGAL::IO::read_polygon_mesh(name, mesh); });
    if (has_oriented_soup_different_points(name))
      expect_same([&](auto& mesh) { return PMP::IO::read_polygon_mesh(name, mesh); });
  }

  // The surface as a mesh and its Surface_mesh, with the same order of elements.
  static std::pair<Mesh, Surface_mesh> pair_of(const Polygon_soup& soup)
  {
    std::pair<Mesh, Surface_mesh> pair(Mesh(points_of<Point>(soup), polygons_of(soup)), Surface_mesh());
    for (const auto v : pair.first.vertices())
      pair.second.add_vertex(pair.first.point(v));
    for (const auto f : pair.first.faces()) {
      std::vector<SV> polygon;
      for (const auto v : vertices_around_face(pair.first.halfedge(f), pair.first))
        polygon.emplace_back(v.idx());
      if (!pair.second.add_face(polygon).is_valid())
        throw std::runtime_error("not for Surface_mesh");
    }
    return pair;
  }

  template <class Element, class T, class Any_mesh>
  static void add_map(Any_mesh& mesh, const std::string& name, const T& first, const T& others)
  {
    auto map = mesh.template add_property_map<Element, T>(name, others).first;
    if (map.begin() != map.end())
      *map.begin() = first;
  }

  template <class Any_mesh>
  static void add_off_attributes(Any_mesh& mesh)
  {
    using Vertex = typename Any_mesh::Vertex_index;
    add_map<Vertex, Vector>(mesh, "v:normal", Vector(1, 2, 3), Vector(-1, 0.5, 0));
    add_map<Vertex, Color>(mesh, "v:color", Color(1, 2, 3), Color(200, 100, 255));
    add_map<Vertex, Texture>(mesh, "v:texcoord", Texture(0.25, 0.5), Texture(1, 0));
    add_map<typename Any_mesh::Face_index, Color>(mesh, "f:color", Color(7, 8, 9), Color(0, 255, 1));
  }

  template <class Element, class Any_mesh>
  static void add_numbers(Any_mesh& mesh, const std::string& prefix)
  {
    add_map<Element, std::int8_t>(mesh, prefix + "int8", -5, 100);
    add_map<Element, std::uint8_t>(mesh, prefix + "uint8", 255, 10);
    add_map<Element, std::int16_t>(mesh, prefix + "int16", -30000, 5);
    add_map<Element, std::uint16_t>(mesh, prefix + "uint16", 65535, 0);
    add_map<Element, std::int32_t>(mesh, prefix + "int32", -2000000000, 1);
    add_map<Element, std::uint32_t>(mesh, prefix + "uint32", 4000000000u, 2);
    add_map<Element, float>(mesh, prefix + "float", 0.5f, -1.25f);
    add_map<Element, double>(mesh, prefix + "double", 0.125, 1024.);
    add_map<Element, bool>(mesh, prefix + "not_written", true, false);
    // written by CGAL 6; Surface_mesh prints bytes in lists as letters
    add_list<Element, std::int16_t>(mesh, prefix + "int16_list", -30000, 5);
    add_list<Element, std::uint16_t>(mesh, prefix + "uint16_list", 65535, 0);
    add_list<Element, std::int32_t>(mesh, prefix + "int32_list", -2000000000, 1);
    add_list<Element, std::uint32_t>(mesh, prefix + "uint32_list", 4000000000u, 2);
    add_list<Element, float>(mesh, prefix + "float_list", 0.5f, -1.25f);
    add_list<Element, double>(mesh, prefix + "double_list", 0.125, 1024.);
  }

  template <class Element, class T, class Any_mesh>
  static void add_list(Any_mesh& mesh, const std::string& name, T a, T b)
  {
    add_map<Element, std::vector<T> >(mesh, name, { a, b, a }, { b });
  }

  template <class Any_mesh>
  static void add_ply_attributes(Any_mesh& mesh)
  {
    using Vertex = typename Any_mesh::Vertex_index;
    add_map<Vertex, Vector>(mesh, "v:normal", Vector(1, 2, 3), Vector(-1, 0.5, 0));
    add_map<Vertex, Color>(mesh, "v:color", Color(1, 2, 3), Color(200, 100, 255, 7));
    add_map<typename Any_mesh::Face_index, Color>(mesh, "f:color", Color(7, 8, 9), Color(0, 255, 1));
    add_numbers<Vertex>(mesh, "v:");
    add_numbers<typename Any_mesh::Face_index>(mesh, "f:");
  }

  // Surface_mesh's PLY has one byte for the number of sides, and exact coordinates as text even if it is binary.
  static bool is_written_well_by_surface_mesh(const Polygon_soup& soup, bool is_binary)
  {
    return std::all_of(soup.faces.begin(), soup.faces.end(), [](const auto& face) { return face.size() < 256; })
        && !(is_binary && std::is_class<typename Kernel::FT>::value);
  }

  template <class Any_mesh>
  static std::string written(const Any_mesh& mesh, const std::string& ending, bool is_binary)
  {
    const Temporary_file file(ending);
    EXPECT_TRUE(CGAL::IO::write_polygon_mesh(file.name(), mesh, parameters::use_binary_mode(is_binary)));
    std::string bytes = file.bytes();
    const std::size_t name = bytes.find(file.name()); // GOCAD's files hold it
    return name == std::string::npos ? bytes : bytes.replace(name, file.name().size(), "");
  }

  // Surfaces that Surface_mesh takes too, whatever the order of faces.
  static std::vector<Polygon_soup> surfaces()
  {
    std::vector<Polygon_soup> result{ { 0, {} }, { 3, {} }, { 4, { { 2, 0, 1 } } }, test::torus(), test::polygon(5),
                                      test::quad_grid(3, 4), test::polygon(300),
                                      test::disjoint_union(test::torus(), test::tetrahedron()) };
    test::Surface_options options;
    options.has_borders = false;
    for (unsigned int seed = 0; seed < 8; ++seed)
      result.push_back(test::random_surface(seed, options));
    return result;
  }
};

TYPED_TEST_SUITE(Mesh_files, All_types);

TYPED_TEST(Mesh_files, are_read_as_surface_mesh_reads_them)
{
  using Fixture = Mesh_files<TypeParam>;
  std::vector<Polygon_soup> surfaces = Fixture::surfaces();
  for (unsigned int seed = 0; seed < 12; ++seed)
    surfaces.push_back(test::random_surface(seed));
  for (const Polygon_soup& soup : surfaces) {
    SCOPED_TRACE(soup.num_vertices);
    const auto points = points_of<typename Fixture::Written_point>(soup);
    const auto polygons = polygons_of(soup);
    for (const Format& format : formats) {
      if (format.has_only_triangles && !has_only_triangles(soup))
        continue;
      SCOPED_TRACE(format.ending);
      const Temporary_file file(format.ending == ".obj" ? ".OBJ" : format.ending);
      ASSERT_TRUE(CGAL::IO::write_polygon_soup(file.name(), points, polygons,
                                               parameters::use_binary_mode(format.is_binary).stream_precision(17)));
      Fixture::expect_same_from_file(file.name());
    }
  }
}

TYPED_TEST(Mesh_files, are_read_from_streams)
{
  using Fixture = Mesh_files<TypeParam>;
  const Polygon_soup soup = test::torus();
  const auto points = points_of<typename Fixture::Written_point>(soup);
  const auto polygons = polygons_of(soup);
  const auto with_stream = [&](const std::string& bytes, const auto& read) {
    Fixture::expect_same([&](auto& mesh) {
      std::istringstream is(bytes);
      return read(is, mesh);
    });
  };
  std::ostringstream off, obj, ts, ply, stl, binary_ply, binary_stl;
  CGAL::IO::set_binary_mode(binary_ply);
  CGAL::IO::set_binary_mode(binary_stl);
  CGAL::IO::write_OFF(off, points, polygons);
  CGAL::IO::write_OBJ(obj, points, polygons);
  CGAL::IO::write_GOCAD(ts, points, polygons);
  CGAL::IO::write_PLY(ply, points, polygons);
  CGAL::IO::write_PLY(binary_ply, points, polygons);
  CGAL::IO::write_STL(stl, points, polygons);
  CGAL::IO::write_STL(binary_stl, points, polygons);
  with_stream(off.str(), [](std::istream& is, auto& mesh) { return CGAL::IO::read_OFF(is, mesh); });
  with_stream(off.str(), [](std::istream& is, auto& mesh) { return static_cast<bool>(is >> mesh); });
  with_stream(obj.str(), [](std::istream& is, auto& mesh) { return CGAL::IO::read_OBJ(is, mesh); });
  std::pair<std::string, std::string> name_and_color;
  with_stream(ts.str(), [](std::istream& is, auto& mesh) { return CGAL::IO::read_GOCAD(is, mesh); });
  with_stream(ts.str(), [&](std::istream& is, auto& mesh) { return CGAL::IO::read_GOCAD(is, name_and_color, mesh); });
  EXPECT_EQ(name_and_color.first, "anonymous");
  for (const std::string& bytes : { ply.str(), binary_ply.str() }) {
    with_stream(bytes, [](std::istream& is, auto& mesh) { return CGAL::IO::read_PLY(is, mesh); });
    with_stream(bytes, [](std::istream& is, auto& mesh) {
      return CGAL::IO::read_PLY(is, mesh, parameters::verbose(true));
    });
    std::string comments;
    with_stream(bytes, [&](std::istream& is, auto& mesh) { return CGAL::IO::read_PLY(is, mesh, comments); });
    EXPECT_EQ(comments, "Generated by the CGAL library\n");
  }
  for (const std::string& bytes : { stl.str(), binary_stl.str() })
    with_stream(bytes, [](std::istream& is, auto& mesh) { return CGAL::IO::read_STL(is, mesh); });
}

TYPED_TEST(Mesh_files, are_written_as_surface_mesh_writes_them)
{
  using Fixture = Mesh_files<TypeParam>;
  for (const Polygon_soup& soup : Fixture::surfaces()) {
    SCOPED_TRACE(soup.num_vertices);
    const auto pair = Fixture::pair_of(soup);
    for (const Format& format : formats) {
      if (format.has_only_triangles && !has_only_triangles(soup))
        continue;
      if (format.ending == ".ply" && !Fixture::is_written_well_by_surface_mesh(soup, format.is_binary))
        continue;
      SCOPED_TRACE(format.ending);
      EXPECT_EQ(Fixture::written(pair.first, format.ending, format.is_binary),
                Fixture::written(pair.second, format.ending, format.is_binary));
    }
    std::ostringstream os, expected;
    os << pair.first;
    expected << pair.second;
    EXPECT_EQ(os.str(), expected.str());
  }
}

TYPED_TEST(Mesh_files, keep_polygons_of_many_sides)
{
  using Fixture = Mesh_files<TypeParam>;
  const auto pair = Fixture::pair_of(test::polygon(300));
  for (const Format& format : formats)
    if (!format.has_only_triangles) {
      SCOPED_TRACE(format.ending);
      const Temporary_file file(format.ending);
      ASSERT_TRUE(CGAL::IO::write_polygon_mesh(file.name(), pair.first,
                                               parameters::use_binary_mode(format.is_binary)));
      typename Fixture::Mesh mesh;
      ASSERT_TRUE(CGAL::IO::read_polygon_mesh(file.name(), mesh));
      EXPECT_EQ(difference(pair.second, mesh), "");
    }
}

TYPED_TEST(Mesh_files, hold_the_attributes_of_off)
{
  using Fixture = Mesh_files<TypeParam>;
  for (const Polygon_soup& soup : Fixture::surfaces()) {
    SCOPED_TRACE(soup.num_vertices);
    auto pair = Fixture::pair_of(soup);
    Fixture::add_off_attributes(pair.first);
    Fixture::add_off_attributes(pair.second);
    std::ostringstream os, expected;
    os << pair.first;
    expected << pair.second;
    ASSERT_EQ(os.str(), expected.str());
    EXPECT_EQ(Fixture::written(pair.first, ".off", false), Fixture::written(pair.second, ".off", false));
    Fixture::expect_same([&](auto& mesh) {
      std::istringstream is(os.str());
      return static_cast<bool>(is >> mesh);
    });
    const Temporary_file file(".off");
    file.set_bytes(os.str());
    Fixture::expect_same_from_file(file.name());
  }
}

TYPED_TEST(Mesh_files, hold_some_of_the_attributes_of_off)
{
  using Fixture = Mesh_files<TypeParam>;
  const std::string rest = "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const std::string& bytes : {
         "OFF\n" + rest, "COFF\n" + rest, std::string("COFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 10 20 30\n"),
         std::string("COFF 3 1 0\n0 0 0 5 6 7\n1 0 0 1 2 3\n0 1 0 0 0 1\n3 0 1 2\n"),
         std::string("COFF 3 1 0\n0 0 0 5 6 7 8\n1 0 0 1 2 3 4\n0 1 0 0 0 1 2\n3 0 1 2 9 8 7 6\n"),
         std::string("NOFF 3 1 0\n0 0 0 5 6 7\n1 0 0 1 2 3\n0 1 0 0 0 1\n3 0 1 2\n"),
         std::string("# a comment\nSTCOFF\n3 1 0\n\n0 0 0 1 2 3 0.5 0.25\n1 0 0 4 5 6 1 1\n"
                     "0 1 0 7 8 9 0 0 # and one\n3 0 1 2\n") }) {
    SCOPED_TRACE(bytes);
    Fixture::expect_same([&](auto& mesh) {
      std::istringstream is(bytes);
      return static_cast<bool>(is >> mesh);
    });
  }
}

// The values of a property map in the order of the points, which must differ.
template <class Mesh, class T>
std::vector<T> values_by_vertex(const Mesh& mesh, const std::string& name)
{
  std::map<typename Mesh::Point, T> values;
  const auto map = mesh.template find_property_map<typename Mesh::Vertex_index, T>(name);
  for (const auto v : mesh.vertices())
    values.emplace(mesh.point(v), map[v]);
  std::vector<T> result;
  for (const auto& value : values)
    result.push_back(value.second);
  return result;
}

// The colors of the faces in the order of their sets of points.
template <class Mesh>
std::vector<Color> colors_of_faces(const Mesh& mesh)
{
  std::map<std::set<typename Mesh::Point>, Color> colors;
  const auto map = mesh.template find_property_map<typename Mesh::Face_index, Color>("f:color");
  for (const auto f : mesh.faces()) {
    std::set<typename Mesh::Point> points;
    for (const auto v : vertices_around_face(mesh.halfedge(f), mesh))
      points.insert(mesh.point(v));
    colors.emplace(points, map[f]);
  }
  std::vector<Color> result;
  for (const auto& color : colors)
    result.push_back(color.second);
  return result;
}

// Surface_mesh's reader takes undefined values for what is tested here.
TYPED_TEST(Mesh_files, may_lack_colors_of_some_elements_of_off)
{
  using Mesh = typename Mesh_files<TypeParam>::Mesh;
  Mesh mesh;
  std::istringstream is("COFF 4 2 0\n0 0 0\n1 0 0 6\n2 1 0 0.5 1 0\n3 0 0\n3 0 1 2\n3 3 2 1 7 8 9 10");
  ASSERT_TRUE(is >> mesh);
  EXPECT_EQ((values_by_vertex<Mesh, Color>(mesh, "v:color")),
            (std::vector<Color>{ Color(0, 0, 0), Color(178, 38, 25), Color(127, 255, 0), Color(0, 0, 0) }));
  EXPECT_EQ(colors_of_faces(mesh), (std::vector<Color>{ Color(0, 0, 0), Color(7, 8, 9) }));
}

TYPED_TEST(Mesh_files, may_have_texture_coordinates_without_colors)
{
  using Mesh = typename Mesh_files<TypeParam>::Mesh;
  using Texture = typename Mesh_files<TypeParam>::Texture;
  Mesh mesh;
  std::istringstream is("ST4OFF 3 1 0\n0 0 0 1 1 2 1\n2 0 0 2 3 4 2\n4 2 0 2 5 6 1\n3 0 1 2\n");
  ASSERT_TRUE(is >> mesh);
  EXPECT_EQ((values_by_vertex<Mesh, Texture>(mesh, "v:texcoord")),
            (std::vector<Texture>{ Texture(1, 2), Texture(1.5, 2), Texture(5, 6) }));
}

// Surface_mesh's reader does not skip the sizes of colors.
TYPED_TEST(Mesh_files, of_off_may_be_binary)
{
  using Fixture = Mesh_files<TypeParam>;
  using Mesh = typename Fixture::Mesh;
  using Vector = typename Fixture::Vector;
  using Texture = typename Fixture::Texture;
  Mesh mesh;
  std::istringstream is(test::binary_off_of_tetrahedron());
  ASSERT_TRUE(is >> mesh);
  EXPECT_EQ(mesh.number_of_faces(), 4u);
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_EQ((values_by_vertex<Mesh, Vector>(mesh, "v:normal")), std::vector<Vector>(4, Vector(1, 2, 3)));
  EXPECT_EQ((values_by_vertex<Mesh, Color>(mesh, "v:color")), std::vector<Color>(4, Color(255, 127, 0)));
  EXPECT_EQ((values_by_vertex<Mesh, Texture>(mesh, "v:texcoord")), std::vector<Texture>(4, Texture(0.5, 0.25)));
  const Color black(0, 0, 0);
  const auto colors = colors_of_faces(mesh);
  EXPECT_EQ(std::count(colors.begin(), colors.end(), black), 3);
  EXPECT_EQ(std::count(colors.begin(), colors.end(), Color(0, 0, 255)), 1);
}

TYPED_TEST(Mesh_files, hold_all_properties_of_ply)
{
  using Fixture = Mesh_files<TypeParam>;
  for (const Polygon_soup& soup : Fixture::surfaces()) {
    SCOPED_TRACE(soup.num_vertices);
    auto pair = Fixture::pair_of(soup);
    Fixture::add_ply_attributes(pair.first);
    Fixture::add_ply_attributes(pair.second);
    for (const bool is_binary : { false, true }) {
      if (!Fixture::is_written_well_by_surface_mesh(soup, is_binary))
        continue;
      EXPECT_EQ(Fixture::written(pair.first, ".ply", is_binary), Fixture::written(pair.second, ".ply", is_binary));
      // the two number edges and halfedges differently
      auto mesh = pair.first;
      Fixture::template add_numbers<typename Fixture::E>(mesh, "e:");
      const Temporary_file file(".ply");
      file.set_bytes(Fixture::written(mesh, ".ply", is_binary));
      Fixture::expect_same_from_file(file.name()); // CGAL reads no halfedges from files
      Fixture::template add_numbers<typename Fixture::H>(mesh, "h:");
      const std::string bytes = Fixture::written(mesh, ".ply", is_binary);
      Fixture::expect_same([&](auto& m) {
        std::istringstream is(bytes);
        return CGAL::IO::read_PLY(is, m);
      });
      auto surface_mesh = pair.second;
      Fixture::template add_numbers<typename Fixture::SE>(surface_mesh, "e:");
      Fixture::template add_numbers<typename Fixture::SH>(surface_mesh, "h:");
      const std::string surface_bytes = Fixture::written(surface_mesh, ".ply", is_binary);
      Fixture::expect_same([&](auto& m) {
        std::istringstream is(surface_bytes);
        return CGAL::IO::read_PLY(is, m);
      });
    }
  }
}

TYPED_TEST(Mesh_files, give_attributes_to_the_maps_of_the_caller)
{
  using Fixture = Mesh_files<TypeParam>;
  const auto read_off = [](std::istream& is, auto& mesh, const auto& np) { return CGAL::IO::read_OFF(is, mesh, np); };
  const auto read_ply = [](std::istream& is, auto& mesh, const auto& np) { return CGAL::IO::read_PLY(is, mesh, np); };
  const auto expect_maps = [](const std::string& bytes, const auto& read) {
    Fixture::expect_same([&](auto& mesh) {
      using Any_mesh = std::decay_t<decltype(mesh)>;
      using Vertex = typename Any_mesh::Vertex_index;
      const auto point = mesh.template add_property_map<Vertex, typename Fixture::Point>("v:my_point").first;
      const auto color = mesh.template add_property_map<Vertex, Color>("v:my_color").first;
      const auto face_color =
        mesh.template add_property_map<typename Any_mesh::Face_index, Color>("f:my_color").first;
      std::istringstream is(bytes);
      const bool is_read = read(is, mesh, parameters::vertex_point_map(point).vertex_color_map(color)
                                                     .face_color_map(face_color));
      for (const auto v : vertices(mesh))
        mesh.point(v) = get(point, v); // by which the meshes are compared
      return is_read;
    });
  };
  auto mesh = Fixture::pair_of(test::torus()).first;
  Fixture::add_off_attributes(mesh);
  std::ostringstream off;
  off << mesh;
  expect_maps(off.str(), read_off);
  mesh.remove_all_property_maps();
  mesh.template add_property_map<typename Fixture::V, Color>("v:color", Color(1, 2, 3));
  mesh.template add_property_map<typename Fixture::F, Color>("f:color", Color(4, 5, 6));
  std::ostringstream ply;
  ASSERT_TRUE(CGAL::IO::write_PLY(ply, mesh, "a comment\nand one more"));
  expect_maps(ply.str(), read_ply);
  std::istringstream is(ply.str());
  typename Fixture::Mesh with_comments;
  std::string comments;
  ASSERT_TRUE(CGAL::IO::read_PLY(is, with_comments, comments));
  EXPECT_EQ(comments, "Generated by the CGAL library\na comment\nand one more\n");
}

TYPED_TEST(Mesh_files, take_attributes_from_the_maps_of_the_caller)
{
  using Fixture = Mesh_files<TypeParam>;
  auto pair = Fixture::pair_of(test::quad_grid(2, 3));
  const auto write = [](auto& mesh) {
    using Any_mesh = std::decay_t<decltype(mesh)>;
    using Vertex = typename Any_mesh::Vertex_index;
    using Point = typename Fixture::Point;
    using Vector = typename Fixture::Vector;
    using Texture = typename Fixture::Texture;
    Fixture::add_off_attributes(mesh);
    const auto np = parameters::
      vertex_point_map(mesh.template add_property_map<Vertex, Point>("v:p", Point(1, 2, 3)).first)
     .vertex_normal_map(mesh.template add_property_map<Vertex, Vector>("v:n", Vector(4, 5, 6)).first)
     .vertex_color_map(mesh.template add_property_map<Vertex, Color>("v:c", Color(1, 2, 3)).first)
     .vertex_texture_map(mesh.template add_property_map<Vertex, Texture>("v:t", Texture(7, 8)).first)
     .face_color_map(mesh.template add_property_map<typename Any_mesh::Face_index, Color>("f:c").first)
     .stream_precision(3);
    std::ostringstream off, obj;
    CGAL::IO::write_OFF(off, mesh, np);
    CGAL::IO::write_OBJ(obj, mesh, np);
    const Temporary_file file(".off");
    CGAL::IO::write_OFF(file.name(), mesh, np);
    return off.str() + obj.str() + file.bytes();
  };
  EXPECT_EQ(write(pair.first), write(pair.second));
}

// Surface_mesh's writer of PLY does not look at given maps.
TYPED_TEST(Mesh_files, of_ply_hold_the_maps_of_the_caller)
{
  using Fixture = Mesh_files<TypeParam>;
  using Mesh = typename Fixture::Mesh;
  using V = typename Fixture::V;
  using Vector = typename Fixture::Vector;
  auto written = Fixture::pair_of(test::quad_grid(2, 3)).first;
  written.template add_property_map<V, Color>("v:color", Color(9, 9, 9));
  const auto point = written.template add_property_map<V, typename Fixture::Point>("v:p").first;
  for (const auto v : written.vertices())
    put(point, v, typename Fixture::Point(v.idx(), 1, 2));
  const auto normal = written.template add_property_map<V, Vector>("v:n", Vector(1, 2, 3)).first;
  const auto color = written.template add_property_map<V, Color>("v:c", Color(4, 5, 6)).first;
  const auto face_color = written.template add_property_map<typename Fixture::F, Color>("f:c", Color(7, 8, 9)).first;
  std::stringstream stream;
  ASSERT_TRUE(CGAL::IO::write_PLY(stream, written, parameters::vertex_point_map(point).vertex_normal_map(normal)
                                                              .vertex_color_map(color).face_color_map(face_color)));
  Mesh mesh;
  ASSERT_TRUE(CGAL::IO::read_PLY(stream, mesh));
  for (const auto v : mesh.vertices())
    EXPECT_EQ(mesh.point(v), typename Fixture::Point(mesh.point(v).x(), 1, 2));
  const std::size_t n = written.number_of_vertices();
  EXPECT_EQ((values_by_vertex<Mesh, Color>(mesh, "v:color")), std::vector<Color>(n, Color(4, 5, 6)));
  EXPECT_EQ((values_by_vertex<Mesh, Vector>(mesh, "v:normal")), std::vector<Vector>(n, Vector(1, 2, 3)));
  EXPECT_EQ(colors_of_faces(mesh), std::vector<Color>(written.number_of_faces(), Color(7, 8, 9)));
}

TYPED_TEST(Mesh_files, keep_the_property_maps_that_the_mesh_has)
{
  using Fixture = Mesh_files<TypeParam>;
  auto written = Fixture::pair_of(test::torus()).first;
  Fixture::add_off_attributes(written);
  std::stringstream stream;
  stream << written;
  typename Fixture::Mesh mesh;
  const auto number = mesh.template add_property_map<typename Fixture::V, int>("v:number", 7).first;
  const auto color = mesh.template add_property_map<typename Fixture::V, Color>("v:color").first;
  ASSERT_TRUE(stream >> mesh);
  for (const auto v : mesh.vertices()) {
    EXPECT_EQ(number[v], 7);
    EXPECT_NE(color[v], Color());
  }
}

TYPED_TEST(Mesh_files, of_soups_are_repaired_and_oriented)
{
  using Fixture = Mesh_files<TypeParam>;
  for (unsigned int seed = 0; seed < 40; ++seed) {
    std::mt19937 rng(seed);
    Polygon_soup soup = test::random_surface(seed);
    for (int i = 0; i < 3; ++i)
      test::damage(soup, rng);
    const auto n = static_cast<long long>(soup.num_vertices);
    if (std::any_of(soup.faces.begin(), soup.faces.end(), [n](const auto& face) {
          return face.size() < 3 || std::any_of(face.begin(), face.end(), [n](long long v) { return v < 0 || v >= n; });
        }))
      continue; // CGAL's repair does not take them
    SCOPED_TRACE(seed);
    const Temporary_file file(".off");
    ASSERT_TRUE(CGAL::IO::write_polygon_soup(file.name(), points_of<typename Fixture::Written_point>(soup),
                                             polygons_of(soup)));
    const auto answer = [&](auto& mesh) {
      const bool is_read = PMP::IO::read_polygon_mesh(file.name(), mesh);
      return std::make_tuple(is_read, mesh.number_of_vertices(), mesh.number_of_edges(), mesh.number_of_faces());
    };
    typename Fixture::Surface_mesh expected; // several vertices may have one point
    typename Fixture::Mesh mesh;
    EXPECT_EQ(answer(mesh), answer(expected));
    EXPECT_TRUE(mesh.is_valid());
  }
}

} // namespace
