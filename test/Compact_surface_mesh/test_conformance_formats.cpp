// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Files of the formats that need libraries, VTK and lib3mf, on both meshes of each pair. Where a library was not found,
// its tests are skipped or not there.

#include "conformance_answers.h"

#include "temporary_file.h"

#include <CGAL/IO/Color.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/IO/3MF.h>
#include <CGAL/boost/graph/IO/VTK.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#pragma GCC diagnostic ignored "-Wdeprecated-declarations" // of CGAL's old names, which are tested, too

namespace {

using test::Answer;
using test::expect_same_answers_in_same_order;
using test::Mesh_of;
using test::Temporary_file;
using test::triangle_pairs;
namespace PMP = CGAL::Polygon_mesh_processing;

/// The faces of a mesh, in ascending order: the corners of each, from the least one on.
template <class Mesh>
std::multiset<std::vector<double>> faces_of(const Mesh& mesh)
{
  std::multiset<std::vector<double>> result;
  for (const auto f : faces(mesh)) {
    std::vector<std::vector<double>> corners;
    for (const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      corners.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    std::vector<double> face;
    for (const auto& corner : corners)
      face.insert(face.end(), corner.begin(), corner.end());
    result.insert(face);
  }
  return result;
}

#ifdef CGAL_USE_VTK
// CGAL writes triangles only.
TEST(Conformance_formats, vtp)
{
  expect_same_answers_in_same_order(triangle_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    Answer answer;
    for (const bool is_binary : {false, true}) {
      const Temporary_file file(".vtp");
      const auto np = CGAL::parameters::use_binary_mode(is_binary).stream_precision(17);
      EXPECT_TRUE(CGAL::IO::write_VTP(file.name(), m.mesh, np));
      const std::string bytes = file.bytes();
      answer << bytes;
      Mesh meshes[2];
      EXPECT_TRUE(CGAL::IO::read_VTP(file.name(), meshes[0]));
      EXPECT_TRUE(CGAL::IO::read_polygon_mesh(file.name(), meshes[1]));
      for (const Mesh& mesh : meshes) {
        EXPECT_TRUE(faces_of(mesh) == faces_of(m.mesh)) << "binary: " << is_binary;
        answer << num_vertices(mesh) << faces_of(mesh);
      }
      EXPECT_TRUE(CGAL::IO::write_polygon_mesh(file.name(), m.mesh, np));
      EXPECT_EQ(file.bytes(), bytes);
    }
    std::ostringstream out;
    EXPECT_TRUE(CGAL::write_vtp(out, m.mesh));
    return answer << out.str();
  });
}

// For other meshes, this reader of CGAL 5 does not know the format.
TEST(Conformance_formats, vtp_is_read_and_repaired)
{
  const test::Compact_mesh& mesh = test::genus_3_pair().compact.mesh;
  const Temporary_file file(".vtp");
  EXPECT_TRUE(CGAL::IO::write_VTP(file.name(), mesh));
  test::Compact_mesh read;
  EXPECT_TRUE(PMP::IO::read_polygon_mesh(file.name(), read));
  EXPECT_TRUE(faces_of(read) == faces_of(mesh));
}

TEST(Conformance_formats, bad_files_of_vtp)
{
  expect_same_answers_in_same_order({&test::sphere_pair()}, [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    const Temporary_file file(".vtp");
    Mesh mesh;
    EXPECT_FALSE(CGAL::IO::read_VTP(file.name(), mesh)); // there is none
    EXPECT_TRUE(CGAL::IO::write_VTP(file.name(), m.mesh));
    file.set_bytes(file.bytes().substr(0, 1000));
    const bool is_read = CGAL::IO::read_VTP(file.name(), mesh);
    EXPECT_EQ(num_faces(mesh), 0u);
    return Answer() << is_read;
  });
}
#else
TEST(Conformance_formats, vtp) { GTEST_SKIP() << "VTK was not found"; }
#endif

#ifdef CGAL_LINKED_WITH_3MF
TEST(Conformance_formats, several_meshes_in_3mf)
{
  expect_same_answers_in_same_order(triangle_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    const Temporary_file file(".3mf");
    EXPECT_TRUE(CGAL::IO::write_3MF(file.name(), std::vector<Mesh>{m.mesh, m.mesh}, {"first", "second"}));
    std::vector<Mesh> meshes(1);
    EXPECT_TRUE(CGAL::IO::read_3MF(file.name(), meshes));
    EXPECT_EQ(meshes.size(), 3u);
    Answer answer;
    for (const Mesh& mesh : meshes)
      answer << num_vertices(mesh) << num_faces(mesh) << faces_of(mesh); // coordinates are floats in the file
    EXPECT_EQ(meshes.back().number_of_faces(), m.mesh.number_of_faces());
    return answer;
  });
}

TEST(Conformance_formats, bad_files_of_3mf)
{
  const Temporary_file file(".3mf");
  std::vector<test::Compact_mesh> meshes(1);
  EXPECT_FALSE(CGAL::IO::read_3MF(file.name(), meshes));
  file.set_bytes("this is no such file");
  EXPECT_FALSE(CGAL::IO::read_3MF(file.name(), meshes));
  EXPECT_EQ(meshes.size(), 1u);
}
#else
TEST(Conformance_formats, several_meshes_in_3mf) { GTEST_SKIP() << "lib3mf was not found"; }
#endif

} // namespace
