// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The meshes of CGAL's data: each is built, and is the mesh of the file, or refused for
// what Surface_mesh and CGAL's own functions say of it.

#include "layout_oracle.h"
#include "test_scale.h"

#include <CGAL/Compact_surface_mesh.h>
#include <CGAL/Compact_surface_mesh/layouts/Corner_table_layout.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Surface_mesh;
typedef CGAL::Compact_surface_mesh<Point> Compact_mesh;

struct Soup
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
};

// The meshes, or none where they could not be had.
std::vector<std::filesystem::path> mesh_files()
{
  std::vector<std::filesystem::path> files;
  const std::filesystem::path folder = CGAL::data_file_path("meshes");
  if (std::filesystem::is_directory(folder))
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".off")
        files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// The defects of a soup by other means than those of this package. A mesh may have
// several of them; none means that the mesh must be taken.
std::vector<CGAL::Mesh_defect> defects_of(const Soup& soup)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  using CGAL::Mesh_defect;
  std::vector<Mesh_defect> defects;
  std::vector<bool> used(soup.points.size(), false);
  std::map<std::pair<std::size_t, std::size_t>, int> num_faces_at_edge;
  for (const auto& polygon : soup.polygons) {
    if (polygon.size() != 3)
      defects.push_back(Mesh_defect::not_a_triangle);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      used[polygon[i]] = true;
      ++num_faces_at_edge[std::minmax(polygon[i], polygon[(i + 1) % polygon.size()])];
    }
    std::vector<std::size_t> sorted = polygon;
    std::sort(sorted.begin(), sorted.end());
    if (std::unique(sorted.begin(), sorted.end()) != sorted.end())
      defects.push_back(Mesh_defect::repeated_vertex);
  }
  if (std::find(used.begin(), used.end(), false) != used.end())
    defects.push_back(Mesh_defect::isolated_vertex);
  if (std::any_of(num_faces_at_edge.begin(), num_faces_at_edge.end(), [](const auto& e) { return e.second == 1; }))
    defects.push_back(Mesh_defect::border);
  if (!PMP::is_polygon_soup_a_polygon_mesh(soup.polygons)) {
    for (Mesh_defect d : { Mesh_defect::nonmanifold_edge, Mesh_defect::duplicate_face,
                           Mesh_defect::inconsistent_orientation, Mesh_defect::nonmanifold_vertex })
      defects.push_back(d);
    return defects;
  }
  Surface_mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  auto component = mesh.add_property_map<Surface_mesh::Face_index, std::size_t>("f:component").first;
  const std::size_t num_components = PMP::connected_components(mesh, component);
  if (num_components > 1)
    defects.push_back(Mesh_defect::several_components);
  const long long euler = static_cast<long long>(mesh.number_of_vertices()) - mesh.number_of_edges() + mesh.number_of_faces();
  if (CGAL::is_closed(mesh) && num_components == 1 && euler != 2)
    defects.push_back(Mesh_defect::positive_genus);
  return defects;
}

// Whether `mesh` is the mesh of the soup, with its points, as an oriented map.
std::string difference(const Soup& soup, const Compact_mesh& mesh, const std::vector<std::uint32_t>& vertex)
{
  for (std::size_t i = 0; i < soup.points.size(); ++i)
    if (mesh.point(Compact_mesh::Vertex_index(vertex[i])) != soup.points[i])
      return "point of vertex " + std::to_string(i);
  if (!CGAL::is_valid_polygon_mesh(mesh))
    return "CGAL::is_valid_polygon_mesh()";
  const CGAL::Corner_table<> table(soup.points.size(), soup.polygons);
  return test::Layout_oracle<Compact_mesh::Layout, std::uint32_t>(mesh.layout(), table, vertex).difference();
}

std::string difference_of_class(const Soup& soup)
{
  std::vector<Compact_mesh::Vertex_index> images(soup.points.size());
  const Compact_mesh mesh(soup.points, soup.polygons,
                          CGAL::parameters::vertex_to_vertex_map(CGAL::make_property_map(images)));
  return difference(soup, mesh, std::vector<std::uint32_t>(images.begin(), images.end()));
}

template <class Layout, class... Order>
void expect_layout(const Soup& soup, Order... order)
{
  EXPECT_EQ((test::difference_from_table<Layout>(soup.points.size(), soup.polygons, order...)), "") << Layout::name();
}

void expect_all_layouts(const Soup& soup)
{
  expect_layout<CGAL::Corner_table_layout<>>(soup);
  for (const auto order : { CGAL::Shelling_order::LAST_IN_FIRST_OUT, CGAL::Shelling_order::FIRST_IN_FIRST_OUT,
                            CGAL::Shelling_order::RANDOM }) {
    expect_layout<CGAL::Schnyder_parents_layout<4>>(soup, order);
    expect_layout<CGAL::Schnyder_parents_layout<5>>(soup, order);
    expect_layout<CGAL::Schnyder_parents_layout<6>>(soup, order);
  }
}

TEST(Real_meshes, are_built_as_they_are_or_refused_for_a_defect_that_they_have)
{
  const auto files = mesh_files();
  if (files.empty())
    GTEST_SKIP() << "CGAL's meshes are not there: run scripts/fetch_meshes";
  std::size_t num_built = 0, num_refused = 0;
  const std::size_t largest_file = test::scaled(1000) >= 1000 ? std::size_t(-1) : 200000;
  for (const auto& file : files) {
    if (std::filesystem::file_size(file) > largest_file)
      continue;
    SCOPED_TRACE(file.filename().string());
    Soup soup;
    if (!CGAL::IO::read_polygon_soup(file.string(), soup.points, soup.polygons))
      continue;
    const auto defects = defects_of(soup);
    std::cout << std::setw(34) << file.filename().string() << std::setw(9) << soup.points.size() << " vertices: ";
    try {
      EXPECT_EQ(difference_of_class(soup), "");
      EXPECT_TRUE(defects.empty()) << "built in spite of defect " << static_cast<int>(defects.front());
      expect_all_layouts(soup);
      ++num_built;
      std::cout << "built\n";
    } catch (const CGAL::Mesh_defect_exception& e) {
      EXPECT_NE(std::find(defects.begin(), defects.end(), e.defect()), defects.end()) << e.what();
      ++num_refused;
      std::cout << e.what() << '\n';
    }
  }
  std::cout << num_built << " built, " << num_refused << " refused\n";
  EXPECT_GT(num_built, 0u);
  EXPECT_GT(num_refused, 0u);
}

} // namespace
