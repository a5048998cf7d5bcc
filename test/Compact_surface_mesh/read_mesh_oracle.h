// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_READ_MESH_ORACLE_H
#define TEST_COMPACT_SURFACE_MESH_READ_MESH_ORACLE_H

// What Surface_mesh makes of a file, against what Compact_surface_mesh makes of it.

#include <CGAL/Surface_mesh.h> // first: CGAL's functions then find those for Surface_mesh

#include <CGAL/Compact_surface_mesh.h>
#include <CGAL/Compact_surface_mesh/internal/versions_of_cgal.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Kernel_traits.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace test {

/// Whether a mesh is the Surface_mesh `expected` with its points and property maps. The
/// points of `expected` must differ.
template <class Surface_mesh, class Mesh>
class Read_mesh_oracle
{
  typedef typename Mesh::Point Point;
  typedef typename CGAL::Kernel_traits<Point>::Kernel Kernel;
  typedef std::tuple<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t, std::int32_t, std::uint32_t, float, double,
                     std::vector<std::int16_t>, std::vector<std::uint16_t>, std::vector<std::int32_t>,
                     std::vector<std::uint32_t>, std::vector<float>, std::vector<double>,
                     CGAL::IO::Color, typename Kernel::Vector_3, typename Kernel::Point_2, Point> Value_types;

public:
  Read_mesh_oracle(const Surface_mesh& expected, const Mesh& mesh)
    : m_expected(expected), m_mesh(mesh)
  {}

  /// Whether the points of `expected` differ.
  bool is_applicable() const
  {
    const auto& points = m_expected.points();
    return std::set<Point>(points.begin(), points.end()).size() == m_expected.number_of_vertices();
  }

  /// What differs first, or nothing.
  std::string difference()
  {
    if (m_mesh.number_of_vertices() != m_expected.number_of_vertices()
        || m_mesh.number_of_edges() != m_expected.number_of_edges()
        || m_mesh.number_of_faces() != m_expected.number_of_faces())
      return "counts";
    if (!m_mesh.is_valid())
      return "is_valid()";
    if (!map_vertices())
      return "points";
    if (!map_faces())
      return "faces";
    for (const std::string& error : { difference_of_maps(m_vertices), difference_of_maps(m_faces),
                                      difference_of_maps(m_edges), difference_of_maps(m_halfedges) })
      if (!error.empty())
        return error;
    return "";
  }

private:
  bool map_vertices()
  {
    std::map<Point, typename Mesh::Vertex_index> by_point;
    for (const auto v : m_mesh.vertices())
      by_point.emplace(m_mesh.point(v), v);
    if (by_point.size() != m_mesh.number_of_vertices())
      return false;
    for (const auto v : m_expected.vertices()) {
      const auto it = by_point.find(m_expected.point(v));
      if (it == by_point.end())
        return false;
      m_vertices.emplace(v, it->second);
    }
    return true;
  }

  bool map_faces()
  {
    for (const auto h : m_expected.halfedges()) {
      const auto image = m_mesh.halfedge(m_vertices.at(m_expected.source(h)), m_vertices.at(m_expected.target(h)));
      if (!image.is_valid() || m_mesh.is_border(image) != m_expected.is_border(h))
        return false;
      m_halfedges.emplace(h, image);
      m_edges.emplace(m_expected.edge(h), m_mesh.edge(image));
    }
    for (const auto f : m_expected.faces())
      m_faces.emplace(f, m_mesh.face(m_halfedges.at(m_expected.halfedge(f))));
    for (const auto h : m_expected.halfedges())
      if (!m_expected.is_border(h)
          && (m_mesh.face(m_halfedges.at(h)) != m_faces.at(m_expected.face(h))
              || m_mesh.next(m_halfedges.at(h)) != m_halfedges.at(m_expected.next(h))))
        return false;
    return true;
  }

  template <class Key, class Image>
  std::string difference_of_maps(const std::map<Key, Image>& images) const
  {
    const std::set<std::string> internal = { "v:connectivity", "v:removed", "f:connectivity", "f:removed", "e:removed",
                                             "h:connectivity" };
    std::set<std::string> expected;
    for (const std::string& name : m_expected.template properties<Key>())
      if (internal.count(name) == 0)
        expected.insert(name);
    const auto found = m_mesh.template properties<Image>();
    if (std::set<std::string>(found.begin(), found.end()) != expected)
      return "names of property maps";
    for (const std::string& name : expected) {
      std::string error = "type of " + name;
      std::apply([&](const auto&... values) { (compare(name, values, images, error), ...); }, Value_types());
      if (!error.empty())
        return error;
    }
    return "";
  }

  template <class T, class Key, class Image>
  void compare(const std::string& name, const T&, const std::map<Key, Image>& images, std::string& error) const
  {
    const auto expected = CGAL::internal::optional_map(m_expected.template property_map<Key, T>(name));
    if (!expected)
      return;
    const auto map = m_mesh.template find_property_map<Image, T>(name);
    if (!map)
      return;
    error.clear();
    for (const auto& image : images)
      if (get(*expected, image.first) != get(map, image.second))
        error = "values of " + name;
  }

  const Surface_mesh& m_expected;
  const Mesh& m_mesh;
  std::map<typename Surface_mesh::Vertex_index, typename Mesh::Vertex_index> m_vertices;
  std::map<typename Surface_mesh::Halfedge_index, typename Mesh::Halfedge_index> m_halfedges;
  std::map<typename Surface_mesh::Edge_index, typename Mesh::Edge_index> m_edges;
  std::map<typename Surface_mesh::Face_index, typename Mesh::Face_index> m_faces;
};

template <class Surface_mesh, class Mesh>
std::string difference(const Surface_mesh& expected, const Mesh& mesh)
{
  return Read_mesh_oracle<Surface_mesh, Mesh>(expected, mesh).difference();
}

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_READ_MESH_ORACLE_H
