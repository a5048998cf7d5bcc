// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_INTERNAL_MESH_FILLING_H
#define CGAL_COMPACT_SURFACE_MESH_INTERNAL_MESH_FILLING_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/internal/Mesh_construction.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace internal {

template <class Descriptor, class T>
class Dynamic_descriptor_map;

// Whether `Map` is a dynamic map of a mesh.
template <class Map>
struct Is_dynamic_map : std::false_type {};

template <class Descriptor, class T>
struct Is_dynamic_map<Dynamic_descriptor_map<Descriptor, T> > : std::true_type {};

// Refuses maps that have no room for the elements to come.
template <class Map>
void check_map_of_empty_mesh()
{
  static_assert(!Is_dynamic_map<Map>::value,
                "A dynamic property map of an empty mesh has no values: give one from add_property_map().");
}

// An empty mesh that is filled. Unless finish() was called, the mesh is as it was when this object is gone.
template <class Mesh>
class Mesh_filling
{
public:
  // Throws if `mesh` is not empty.
  explicit Mesh_filling(Mesh& mesh)
    : m_mesh(mesh)
  {
    if (!mesh.is_empty())
      throw std::runtime_error("the mesh is not empty");
  }

  Mesh_filling(const Mesh_filling&) = delete;
  Mesh_filling& operator=(const Mesh_filling&) = delete;

  ~Mesh_filling()
  {
    if (m_is_finished)
      return;
    m_mesh.clear_without_removing_property_maps();
    for (const auto& remove : m_removals)
      remove();
  }

  const Mesh& mesh() const { return m_mesh; }

  // Makes the mesh that of a polygon soup, with the parameters of its constructor. The points go to a map of the mesh
  // if one comes last.
  template <class Points, class Polygons, class NamedParameters, class... PointMap>
  void take_soup(const Points& points, const Polygons& polygons, const NamedParameters& np,
                 const PointMap&... point_map)
  {
    (check_map_of_empty_mesh<PointMap>(), ...);
    Mesh_construction<Mesh, Mesh_filling>(m_mesh, *this).take_soup(points, polygons, np, point_map...);
  }

  // Makes the mesh that of a graph, likewise.
  template <class FaceGraph, class NamedParameters, class... PointMap>
  void copy_graph(const FaceGraph& g, const NamedParameters& np, const PointMap&... point_map)
  {
    (check_map_of_empty_mesh<PointMap>(), ...);
    Mesh_construction<Mesh, Mesh_filling>(m_mesh, *this).copy_graph(g, np, point_map...);
  }

  // Adds a property map, or finds the one that the mesh has, as the function of the mesh does.
  template <class Element, class T>
  auto add_property_map(const std::string& name, const T& default_value = T())
  {
    if (!m_mesh.template find_property_map<Element, T>(name))
      m_removals.push_back([this, name] {
        auto map = m_mesh.template find_property_map<Element, T>(name);
        if (map)
          m_mesh.remove_property_map(map);
      });
    return m_mesh.template add_property_map<Element, T>(name, default_value);
  }

  void finish() { m_is_finished = true; }

private:
  Mesh& m_mesh;
  std::vector<std::function<void()> > m_removals;
  bool m_is_finished = false;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_INTERNAL_MESH_FILLING_H
