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
#include <vector>

namespace CGAL {
namespace internal {

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

  // Makes the mesh that of a polygon soup, with the parameters of its constructor.
  template <class Points, class Polygons, class NamedParameters>
  void assign(const Points& points, const Polygons& polygons, const NamedParameters& np)
  {
    Mesh_construction<Mesh>(m_mesh).take_soup(points, polygons, np);
  }

  // Adds a property map, or finds the one that the mesh has.
  template <class Element, class T>
  auto add_property_map(const std::string& name, const T& default_value = T())
  {
    if (!m_mesh.template find_property_map<Element, T>(name))
      m_removals.push_back([this, name] {
        auto map = m_mesh.template find_property_map<Element, T>(name);
        if (map)
          m_mesh.remove_property_map(map);
      });
    return m_mesh.template add_property_map<Element, T>(name, default_value).first;
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
