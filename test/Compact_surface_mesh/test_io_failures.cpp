// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Files that are no meshes: readers return false, say why on request, and leave the mesh as it was. No
// Surface_mesh takes part: its header is not included.

#include "binary_off.h"
#include "temporary_file.h"

#include <CGAL/Compact_surface_mesh/IO/3MF.h>
#include <CGAL/Compact_surface_mesh/IO/polygon_mesh_io.h>
#include <CGAL/Compact_surface_mesh/IO/repaired_polygon_mesh_io.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h> // after the overload that calls its functions
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>
#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <iostream>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;
using test::Temporary_file;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Compact_surface_mesh<Point> Mesh;
typedef Mesh::Vertex_index Vertex_index;
typedef CGAL::Compact_surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3> Exact_mesh;
using CGAL::IO::Color;

template <class T, class = void>
struct Is_complete : std::false_type {};
template <class T>
struct Is_complete<T, std::void_t<decltype(sizeof(T))>> : std::true_type {};

// What is printed to std::cerr and std::cout as long as this object lives.
class Printed
{
public:
  Printed() : m_err(std::cerr.rdbuf(m_text.rdbuf())), m_out(std::cout.rdbuf(m_text.rdbuf())) {}
  ~Printed()
  {
    std::cerr.rdbuf(m_err);
    std::cout.rdbuf(m_out);
  }
  std::string text() const { return m_text.str(); }

private:
  std::ostringstream m_text;
  std::streambuf* m_err;
  std::streambuf* m_out;
};

Mesh tetrahedron()
{
  return Mesh(std::vector<Point>{ Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1) },
              std::vector<std::vector<int>>{ { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } });
}

struct Bytes_of_file
{
  std::string ending, bytes;
};

// The tetrahedron as a file, with attributes where the format has some.
Bytes_of_file file_of_tetrahedron(const std::string& ending, bool is_binary = false)
{
  Mesh mesh = tetrahedron();
  mesh.add_property_map<Vertex_index, Kernel::Vector_3>("v:normal", Kernel::Vector_3(1, 0, 2));
  mesh.add_property_map<Vertex_index, Color>("v:color", Color(10, 20, 30));
  mesh.add_property_map<Mesh::Face_index, Color>("f:color", Color(40, 50, 60));
  if (ending == ".off") {
    mesh.add_property_map<Vertex_index, Kernel::Point_2>("v:texcoord", Kernel::Point_2(0.5, 1));
    std::ostringstream os;
    os << mesh;
    return { ending, os.str() };
  }
  mesh.add_property_map<Mesh::Face_index, std::uint16_t>("f:number", 300);
  mesh.add_property_map<Mesh::Edge_index, double>("e:length", 1.5);
  mesh.add_property_map<Mesh::Halfedge_index, std::int8_t>("h:side", 1);
  const Temporary_file file(ending);
  EXPECT_TRUE(CGAL::IO::write_polygon_mesh(file.name(), mesh, parameters::use_binary_mode(is_binary)));
  return { ending, file.bytes() };
}

// Files of surfaces of four points.
std::vector<Bytes_of_file> good_files()
{
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n";
  return { file_of_tetrahedron(".off"),
           { ".off", test::binary_off_of_tetrahedron() },
           { ".off", "COFF 4 2 0\n" + points + "3 0 1 2 255 0 0\n3 2 1 3\n" },
           { ".off", "COFF 4 2 0\n0 0 0 1\n1 0 0\n0 1 0 0.5 1 0\n1 1 0 7 8 9 10\n3 0 1 2\n3 2 1 3 148\n" },
           { ".off", "STN4OFF 4 1 0\n0 0 0 1 2 3 4 5 1 2 3\n2 0 0 2 2 3 4 5 1 2 3\n0 2 0 2 2 3 4 5 1 2 3\n"
                     "2 2 0 2 2 3 4 5 1 2 3\n4 0 1 3 2\n" },
           file_of_tetrahedron(".obj"),
           file_of_tetrahedron(".stl"), file_of_tetrahedron(".stl", true),
           file_of_tetrahedron(".ply"), file_of_tetrahedron(".ply", true),
           file_of_tetrahedron(".ts") };
}

template <class Any_mesh>
bool is_read_from_stream(std::istream& is, const std::string& ending, Any_mesh& mesh)
{
  if (ending == ".off")
    return static_cast<bool>(is >> mesh);
  if (ending == ".obj")
    return CGAL::IO::read_OBJ(is, mesh);
  if (ending == ".stl")
    return CGAL::IO::read_STL(is, mesh);
  if (ending == ".ts")
    return CGAL::IO::read_GOCAD(is, mesh);
  std::string comments;
  return CGAL::IO::read_PLY(is, mesh, comments, false);
}

// Expects that read(mesh) makes a valid mesh, or returns false and leaves the mesh as it was. Returns the same.
template <class Any_mesh, class Read>
bool keeps_contract(const Read& read)
{
  using Vertex = typename Any_mesh::Vertex_index;
  Any_mesh mesh;
  const auto number = mesh.template add_property_map<Vertex, int>("v:number", 7).first;
  if (read(mesh)) {
    EXPECT_TRUE(mesh.is_valid());
    for (const auto v : mesh.vertices())
      EXPECT_EQ(number[v], 7);
    return true;
  }
  EXPECT_TRUE(mesh.is_empty());
  EXPECT_EQ(mesh.number_of_faces(), 0u);
  EXPECT_EQ(mesh.template properties<Vertex>(), (std::vector<std::string>{ "v:point", "v:number" }));
  EXPECT_EQ(mesh.template properties<typename Any_mesh::Halfedge_index>(), std::vector<std::string>());
  EXPECT_EQ(mesh.template properties<typename Any_mesh::Edge_index>(), std::vector<std::string>());
  EXPECT_EQ(mesh.template properties<typename Any_mesh::Face_index>(), std::vector<std::string>());
  EXPECT_EQ(number.begin(), number.end());
  return false;
}

// Whether one of the ways to read these bytes makes a mesh. Expects the contract of all of them.
template <class Any_mesh>
bool is_read_as(const Bytes_of_file& file)
{
  const Temporary_file named(file.ending);
  named.set_bytes(file.bytes);
  const Printed printed; // CGAL's readers are not silent
  const bool from_file = keeps_contract<Any_mesh>([&](Any_mesh& mesh) {
    return CGAL::IO::read_polygon_mesh(named.name(), mesh, parameters::verbose(true));
  });
  const bool from_soup = keeps_contract<Any_mesh>([&](Any_mesh& mesh) {
    return PMP::IO::read_polygon_mesh(named.name(), mesh);
  });
  const bool from_stream = keeps_contract<Any_mesh>([&](Any_mesh& mesh) {
    std::istringstream is(file.bytes);
    const bool success = is_read_from_stream(is, file.ending, mesh);
    EXPECT_TRUE(success || is.fail());
    return success;
  });
  return from_file || from_soup || from_stream;
}

bool is_read(const Bytes_of_file& file)
{
  if (file.ending != ".obj" && file.ending != ".ts") // there CGAL divides exact numbers by zero
    is_read_as<Exact_mesh>(file);
  return is_read_as<Mesh>(file);
}

bool is_read(const std::string& ending, const std::string& bytes) { return is_read(Bytes_of_file{ ending, bytes }); }

std::string reason_of_refusal(const std::string& off)
{
  Exact_mesh mesh;
  std::istringstream is(off);
  const Printed printed;
  EXPECT_FALSE(CGAL::IO::read_OFF(is, mesh, parameters::verbose(true)));
  EXPECT_TRUE(is.fail());
  EXPECT_TRUE(mesh.is_empty());
  return printed.text();
}

TEST(Bad_files, need_no_surface_mesh)
{
  EXPECT_FALSE(Is_complete<CGAL::Surface_mesh<Point>>::value);
}

TEST(Bad_files, are_not_there_or_have_no_known_ending)
{
  Mesh mesh;
  for (const std::string ending : { ".off", ".obj", ".stl", ".ply", ".ts", ".unknown", "" }) {
    SCOPED_TRACE(ending);
    const std::string name = Temporary_file(ending).name();
    const Printed printed;
    EXPECT_FALSE(CGAL::IO::read_polygon_mesh(name, mesh));
    EXPECT_FALSE(PMP::IO::read_polygon_mesh(name, mesh));
    EXPECT_EQ(printed.text(), "");
    EXPECT_FALSE(CGAL::IO::read_polygon_mesh(name, mesh, parameters::verbose(true)));
    EXPECT_NE(printed.text(), "");
    EXPECT_TRUE(mesh.is_empty());
  }
  const Mesh written = tetrahedron();
  EXPECT_FALSE(CGAL::IO::write_polygon_mesh("tetrahedron.unknown", written));
  EXPECT_FALSE(CGAL::IO::write_polygon_mesh("tetrahedron", mesh));
  for (const std::string ending : { ".off", ".obj", ".stl", ".ply", ".ts" })
    EXPECT_FALSE(CGAL::IO::write_polygon_mesh(Temporary_file("").name() + "/no_folder" + ending, written));
}

TEST(Bad_files, are_not_read_into_a_mesh_that_is_not_empty)
{
  for (const Bytes_of_file& file : good_files()) {
    SCOPED_TRACE(file.bytes);
    const Temporary_file named(file.ending);
    named.set_bytes(file.bytes);
    Mesh mesh = tetrahedron();
    const Printed printed;
    EXPECT_FALSE(CGAL::IO::read_polygon_mesh(named.name(), mesh, parameters::verbose(true)));
    EXPECT_EQ(printed.text(), "Error: the mesh is not empty\n");
    std::istringstream is(file.bytes);
    EXPECT_FALSE(is_read_from_stream(is, file.ending, mesh));
    EXPECT_TRUE(is.fail());
    EXPECT_EQ(mesh.number_of_faces(), 4u);
    mesh.clear();
    EXPECT_TRUE(CGAL::IO::read_polygon_mesh(named.name(), mesh));
  }
}

TEST(Bad_files, name_their_defect)
{
  const std::vector<std::pair<std::string, std::string>> defects = {
    { "OFF 5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 2 0\n3 0 1 2\n3 0 1 3\n3 1 0 4\n", "more than two faces" },
    { "OFF 4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n", "in the same direction" },
    { "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 1\n", "names a vertex twice" },
    { "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n", "fewer than three sides" },
    { "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "does not exist" },
    { "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "does not exist" },
    { "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n", "too early" },
    { "OFF 2000000000 2000000000 0\n", "too early" },
    { "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n1000000000 0 1 2\n", "as many vertices" },
    { "OFF 3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", "too few numbers" },
    { "NOFF 3 1 0\n0 0 0 1 1 1\n1 0 0 1 1\n0 1 0 1 1 1\n3 0 1 2\n", "too few numbers" },
    { "STCOFF 3 1 0\n0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2\n", "too few numbers" },
    { "COFF 3 1 0\n0 0 0 5 6\n1 0 0 5 6\n0 1 0 5 6\n3 0 1 2\n", "has two numbers" },
    { "COFF 3 1 0\n0 0 0 -5000000\n1 0 0\n0 1 0\n3 0 1 2\n", "negative index" },
    { "COFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 -90000000\n", "negative index" },
    { "COFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 256 0 0\n", "out of range" },
    { "4OFF 3 1 0\n0 0 0 1\n1 0 0 0\n0 1 0 1\n3 0 1 2\n", "at infinity" },
    { "4OFF 3 1 0\n0 0 0 1\n1e300 0 0 1e-300\n0 1 0 1\n3 0 1 2\n", "not finite" },
    { "5OFF 3 1 0\n", "header" } };
  for (const auto& defect : defects) {
    SCOPED_TRACE(defect.first);
    const std::string reason = reason_of_refusal(defect.first);
    EXPECT_NE(reason.find(defect.second), std::string::npos) << reason;
  }
}

// A property map that throws what is no exception.
struct Throwing_map
{
  typedef Vertex_index key_type;
  typedef Color value_type;
  typedef Color reference;
  typedef boost::writable_property_map_tag category;
  friend void put(const Throwing_map&, Vertex_index, const Color&) { throw 7; }
};

TEST(Bad_files, leave_no_property_maps_when_they_fail_late)
{
  const Bytes_of_file off = file_of_tetrahedron(".off"), ply = file_of_tetrahedron(".ply");
  const auto np = parameters::vertex_color_map(Throwing_map());
  EXPECT_FALSE(keeps_contract<Mesh>([&](Mesh& mesh) {
    std::istringstream is(off.bytes);
    return CGAL::IO::read_OFF(is, mesh, np);
  }));
  EXPECT_FALSE(keeps_contract<Mesh>([&](Mesh& mesh) {
    std::istringstream is(ply.bytes);
    return CGAL::IO::read_PLY(is, mesh, np);
  }));
}

TEST(Bad_files, hold_numbers_that_are_not_finite)
{
  const auto number = [](float value) { return std::string(reinterpret_cast<const char*>(&value), sizeof(value)); };
  for (const float x : { std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN() }) {
    const std::string points = number(x) + number(0) + number(0) + number(1) + number(0) + number(0)
                               + number(0) + number(1) + number(0);
    const std::string ply = "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n"
                            "property float y\nproperty float z\nelement face 1\n"
                            "property list uchar uchar vertex_indices\nend_header\n";
    const std::vector<Bytes_of_file> files = {
      { ".ply", ply + points + std::string("\3\0\1\2", 4) },
      { ".stl", std::string(80, ' ') + std::string("\1\0\0\0", 4) + std::string(12, '\0') + points + "  " } };
    for (const Bytes_of_file& file : files) {
      EXPECT_FALSE(is_read_as<Exact_mesh>(file));
      EXPECT_TRUE(is_read_as<Mesh>(file));
    }
  }
}

TEST(Bad_files, name_vertices_that_do_not_exist)
{
  const std::string vertices = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                               "property float z\nelement face 1\nproperty list uchar int vertex_indices\n";
  const std::string data = "end_header\n0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_TRUE(is_read(".ply", vertices + data + "3 0 1 2\n"));
  EXPECT_FALSE(is_read(".ply", vertices + data + "3 0 1 3\n"));
  EXPECT_FALSE(is_read(".ply", vertices + data + "3 0 1 -1\n"));
  const std::string edges = "element edge 1\nproperty int vertex1\nproperty int vertex2\nproperty int number\n";
  const auto is_read_with_edge = [&](const std::string& edge) {
    Mesh mesh;
    std::istringstream is(vertices + edges + data + "3 0 1 2\n" + edge);
    std::string comments;
    return CGAL::IO::read_PLY(is, mesh, comments, false);
  };
  EXPECT_TRUE(is_read_with_edge("1 0 7\n"));
  EXPECT_TRUE(is_read_with_edge("1 1 7\n"));
  EXPECT_FALSE(is_read_with_edge("1 3 7\n"));
  EXPECT_FALSE(is_read_with_edge("-1 0 7\n"));
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_TRUE(is_read(".obj", obj + "f -3 -2 -1\n"));
  EXPECT_FALSE(is_read(".obj", obj + "f 1 2 4\n"));
  EXPECT_FALSE(is_read(".obj", obj + "f 1 2 -4\n"));
  EXPECT_FALSE(is_read(".obj", obj + "f 0 1 2\n"));
}

TEST(Bad_files, have_odd_ply_headers)
{
  const std::string start = "ply\nformat ascii 1.0\n", end = "end_header\n";
  EXPECT_FALSE(is_read(".ply", ""));
  EXPECT_FALSE(is_read(".ply", "plx\n"));
  EXPECT_FALSE(is_read(".ply", start));
  EXPECT_TRUE(is_read(".ply", start + end)); // no vertices
  EXPECT_TRUE(is_read(".ply", start + "element nothing 999999999999\n" + end));
  EXPECT_FALSE(is_read(".ply", start + "element face 1\n" + end));
  EXPECT_FALSE(is_read(".ply", start + "property int x\n" + end));
  EXPECT_FALSE(is_read(".ply", start + "element vertex 1\nproperty long x\n" + end + "1\n"));
  EXPECT_FALSE(is_read(".ply", "ply\nformat morse 1.0\n" + end));
  EXPECT_FALSE(is_read(".ply", start + "element vertex 1\nproperty int x\nelement vertex 1\nproperty int y\n" + end
                                 + "1 2\n"));
  EXPECT_FALSE(is_read(".ply", start + "element vertex 99999999999999\nproperty int x\n" + end + "1\n"));
}

TEST(Bad_files, have_lists_longer_than_the_file)
{
  const std::string end = " int vertex_indices\nend_header\n";
  const std::string text = "ply\nformat ascii 1.0\nelement face 1\nproperty list ";
  const std::string binary = "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list ";
  for (const std::string& bytes : { text + "uint" + end + "4294967295 1 2 3\n", text + "int" + end,
                                    binary + "uint" + end + "\xff\xff\xff\xff" + "abcdefghijkl",
                                    binary + "uint" + end + "\xff\xff" }) {
    Mesh mesh;
    std::istringstream is(bytes);
    std::string comments;
    const Printed printed;
    EXPECT_FALSE(CGAL::IO::read_PLY(is, mesh, comments, true));
    EXPECT_NE(printed.text().find("too early"), std::string::npos) << printed.text();
  }
  EXPECT_FALSE(is_read(".ply", text + "int" + end + "-3 0 1 2\n"));
}

TEST(Bad_files, end_too_early)
{
  for (const Bytes_of_file& file : good_files()) {
    SCOPED_TRACE(file.bytes);
    ASSERT_TRUE(is_read(file));
    std::size_t num_read = 0;
    for (std::size_t n = 0; n < file.bytes.size(); ++n)
      num_read += is_read(file.ending, file.bytes.substr(0, n)) ? 1 : 0;
    EXPECT_LT(num_read, file.bytes.size() / 2);
  }
}

TEST(Bad_files, have_wrong_bytes)
{
  std::mt19937 rng(5);
  for (const Bytes_of_file& file : good_files()) {
    SCOPED_TRACE(file.ending);
    for (int i = 0; i < 200; ++i) {
      std::string bytes = file.bytes;
      for (std::size_t k = 1 + rng() % 3; k-- > 0;)
        bytes[rng() % bytes.size()] = static_cast<char>(rng() % 2 ? rng() : 32 + rng() % 26);
      is_read(file.ending, bytes);
    }
    std::string bytes = file.bytes;
    for (char& c : bytes)
      c = static_cast<char>(rng());
    EXPECT_FALSE(is_read(file.ending, bytes)) << "seed 5";
  }
}

} // namespace
