// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The meshes of CGAL's data: each is built, and is the mesh of the file, or refused for
// what Surface_mesh and CGAL's own functions say of it.

#include "layout_of_soup.h"
#include "test_scale.h"

#include <CGAL/Compact_surface_mesh.h>
#include <CGAL/Compact_surface_mesh/layouts/Corner_table_layout.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <map>
#include <set>
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
  const std::set<std::string> formats = { ".off", ".obj", ".ply", ".stl", ".ts" };
  std::vector<std::filesystem::path> files;
  const std::filesystem::path folder = CGAL::data_file_path("meshes");
  if (std::filesystem::is_directory(folder))
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (formats.count(entry.path().extension().string()) != 0)
        files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// The vertices at which a closed fan of faces meets another fan.
bool has_nonmanifold_vertices(const Soup& soup)
{
  std::vector<std::map<std::size_t, std::size_t>> links(soup.points.size()); // of neighbors, counterclockwise
  for (const auto& polygon : soup.polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i)
      links[polygon[i]][polygon[(i + 1) % polygon.size()]] = polygon[(i + polygon.size() - 1) % polygon.size()];
  for (const auto& link : links) {
    std::set<std::size_t> ends;
    for (const auto& l : link)
      ends.insert(l.second);
    std::size_t num_open = 0, num_closed = 0;
    std::set<std::size_t> seen;
    const auto walk = [&](std::size_t u) {
      for (auto it = link.find(u); it != link.end() && seen.insert(it->first).second;)
        it = link.find(it->second);
    };
    for (const auto& l : link)
      if (ends.count(l.first) == 0) {
        ++num_open;
        walk(l.first);
      }
    for (const auto& l : link)
      if (seen.count(l.first) == 0) {
        ++num_closed;
        walk(l.first);
      }
    if (num_closed > 1 || (num_closed == 1 && num_open != 0))
      return true;
  }
  return false;
}

// The defects of a soup by other means than those of this package. A mesh may have
// several of them; none means that the mesh must be taken.
std::vector<CGAL::Mesh_defect> defects_of(const Soup& soup)
{
  using CGAL::Mesh_defect;
  std::vector<Mesh_defect> defects;
  for (const auto& polygon : soup.polygons) {
    std::vector<std::size_t> sorted = polygon;
    std::sort(sorted.begin(), sorted.end());
    if (sorted.size() < 3)
      defects.push_back(Mesh_defect::degenerate_face);
    if (std::unique(sorted.begin(), sorted.end()) != sorted.end())
      defects.push_back(Mesh_defect::repeated_vertex);
    if (!sorted.empty() && sorted.back() >= soup.points.size())
      defects.push_back(Mesh_defect::index_out_of_range);
  }
  if (!defects.empty())
    return defects;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> faces_along; // by directed edges
  for (std::size_t f = 0; f < soup.polygons.size(); ++f)
    for (std::size_t i = 0; i < soup.polygons[f].size(); ++i)
      faces_along[{ soup.polygons[f][i], soup.polygons[f][(i + 1) % soup.polygons[f].size()] }].push_back(f);
  for (const auto& edge : faces_along) {
    const auto reversed = faces_along.find({ edge.first.second, edge.first.first });
    const std::size_t num_reversed = reversed == faces_along.end() ? 0 : reversed->second.size();
    if (edge.second.size() + num_reversed > 2)
      defects.push_back(Mesh_defect::nonmanifold_edge);
    if (edge.second.size() > 1) {
      defects.push_back(Mesh_defect::inconsistent_orientation);
      defects.push_back(Mesh_defect::duplicate_face); // one of the two
    }
  }
  if (defects.empty() && has_nonmanifold_vertices(soup))
    defects.push_back(Mesh_defect::nonmanifold_vertex);
  return defects;
}

struct Topology
{
  std::size_t num_components, num_borders;
  long long genus;
};

// What CGAL's functions say of a mesh; the genus is that of all components together.
template <class Mesh>
Topology topology_of(Mesh& mesh)
{
  auto component = mesh.template add_property_map<typename Mesh::Face_index, std::size_t>("f:component").first;
  Topology t;
  t.num_components = CGAL::Polygon_mesh_processing::connected_components(mesh, component);
  std::vector<typename Mesh::Halfedge_index> borders;
  CGAL::Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(borders));
  t.num_borders = borders.size();
  long long num_isolated = 0;
  for (const auto v : vertices(mesh))
    num_isolated += mesh.is_isolated(v) ? 1 : 0;
  const long long euler = static_cast<long long>(num_vertices(mesh)) - num_isolated - num_edges(mesh) + num_faces(mesh);
  t.genus = static_cast<long long>(t.num_components) - (euler + static_cast<long long>(t.num_borders)) / 2;
  return t;
}

test::Polygon_soup soup_for_oracle(const Soup& soup)
{
  test::Polygon_soup result{ soup.points.size(), {} };
  for (const auto& polygon : soup.polygons)
    result.faces.emplace_back(polygon.begin(), polygon.end());
  return result;
}

// Whether the mesh class makes of the soup that mesh, with its points, as an oriented map, and
// CGAL's functions say of it what they say of the Surface_mesh of the same soup.
std::string difference_of_class(const Soup& soup, Topology& topology)
{
  std::vector<Compact_mesh::Vertex_index> images(soup.points.size());
  Compact_mesh mesh(soup.points, soup.polygons,
                    CGAL::parameters::vertex_to_vertex_map(CGAL::make_property_map(images)));
  for (std::size_t i = 0; i < soup.points.size(); ++i)
    if (mesh.point(images[i]) != soup.points[i])
      return "point of vertex " + std::to_string(i);
  if (!mesh.is_valid())
    return "is_valid()";
  topology = topology_of(mesh);
  // CGAL does not take vertices with several fans here: their order is free, and with it the number of borders
  if (CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(soup.polygons)) {
    Surface_mesh surface_mesh;
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, surface_mesh);
    if (num_vertices(mesh) != num_vertices(surface_mesh) || num_faces(mesh) != num_faces(surface_mesh)
        || num_edges(mesh) != num_edges(surface_mesh) || num_halfedges(mesh) != num_halfedges(surface_mesh))
      return "counts of Surface_mesh";
    const Topology expected = topology_of(surface_mesh);
    if (topology.num_components != expected.num_components || topology.num_borders != expected.num_borders
        || topology.genus != expected.genus)
      return "topology of Surface_mesh";
  }
  const std::vector<std::uint32_t> vertex(images.begin(), images.end());
  return test::Surface_oracle<Compact_mesh::Layout>(mesh.layout(), soup_for_oracle(soup), vertex).difference();
}

template <class Layout, class... Order>
void expect_layout(const test::Polygon_soup& soup, Order... order)
{
  EXPECT_EQ(test::difference_from_soup<Layout>(soup, order...), "") << Layout::name();
}

void expect_all_layouts(const test::Polygon_soup& soup)
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
  std::size_t num_built = 0, num_refused = 0, num_with_borders = 0, num_with_handles = 0, num_with_polygons = 0;
  const std::size_t largest_file = test::scaled(1000) >= 1000 ? std::size_t(-1) : 200000;
  std::cout << std::setw(40) << "mesh" << std::setw(10) << "vertices" << std::setw(8) << "faces" << std::setw(12)
            << "components" << std::setw(9) << "borders" << std::setw(7) << "genus" << '\n';
  for (const auto& file : files) {
    if (std::filesystem::file_size(file) > largest_file)
      continue;
    SCOPED_TRACE(file.filename().string());
    Soup soup;
    if (!CGAL::IO::read_polygon_soup(file.string(), soup.points, soup.polygons)) {
      std::cout << std::setw(40) << file.filename().string() << "  cannot be read by CGAL\n";
      continue;
    }
    const auto defects = defects_of(soup);
    std::cout << std::setw(40) << file.filename().string() << std::setw(10) << soup.points.size() << std::setw(8)
              << soup.polygons.size();
    try {
      Topology topology{ 0, 0, 0 };
      EXPECT_EQ(difference_of_class(soup, topology), "");
      EXPECT_TRUE(defects.empty()) << "built in spite of defect " << static_cast<int>(defects.front());
      expect_all_layouts(soup_for_oracle(soup));
      ++num_built;
      num_with_borders += topology.num_borders != 0 ? 1 : 0;
      num_with_handles += topology.genus > 0 ? 1 : 0;
      num_with_polygons += std::any_of(soup.polygons.begin(), soup.polygons.end(),
                                       [](const auto& p) { return p.size() != 3; }) ? 1 : 0;
      std::cout << std::setw(12) << topology.num_components << std::setw(9) << topology.num_borders << std::setw(7)
                << topology.genus << '\n';
    } catch (const CGAL::Mesh_defect_exception& e) {
      EXPECT_NE(std::find(defects.begin(), defects.end(), e.defect()), defects.end()) << e.what();
      ++num_refused;
      std::cout << "  refused: " << e.what() << '\n';
    }
  }
  std::cout << num_built << " built (" << num_with_borders << " with borders, " << num_with_handles << " with handles, "
            << num_with_polygons << " with polygons), " << num_refused << " refused\n";
  EXPECT_GT(num_built, num_refused);
  EXPECT_GT(num_refused, 0u);
  EXPECT_GT(num_with_borders, 0u);
  EXPECT_GT(num_with_handles, 0u);
  EXPECT_GT(num_with_polygons, 0u);
}

} // namespace
