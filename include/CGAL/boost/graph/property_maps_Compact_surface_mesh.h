// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_BOOST_GRAPH_PROPERTY_MAPS_COMPACT_SURFACE_MESH_H
#define CGAL_BOOST_GRAPH_PROPERTY_MAPS_COMPACT_SURFACE_MESH_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/boost/graph/graph_traits_Compact_surface_mesh.h>
#include <CGAL/boost/graph/properties_Compact_surface_mesh.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/property_maps.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <utility>

#ifndef DOXYGEN_RUNNING

// The triangle and the point of a face by which AABB trees know it, specialized: they do the same, but read vertices
// at once. One operator after the other, processors would mispredict one branch or two for each.

namespace CGAL {

template <class P, class L, class VertexPointMap>
struct One_point_from_face_descriptor_map<Compact_surface_mesh<P, L>, VertexPointMap>
{
  typedef Compact_surface_mesh<P, L> Mesh;
  typedef typename boost::graph_traits<Mesh>::face_descriptor key_type;
  typedef typename boost::property_traits<VertexPointMap>::value_type value_type;
  typedef typename boost::property_traits<VertexPointMap>::reference reference;
  typedef boost::readable_property_map_tag category;

  One_point_from_face_descriptor_map() = default;
  One_point_from_face_descriptor_map(const Mesh* pm) : m_pm(const_cast<Mesh*>(pm)), m_vpm(get(vertex_point, *m_pm)) {}
  One_point_from_face_descriptor_map(const Mesh* pm, VertexPointMap vpm) : m_pm(const_cast<Mesh*>(pm)), m_vpm(vpm) {}

  friend reference get(const One_point_from_face_descriptor_map& map, key_type f)
  {
    return get(map.m_vpm, typename Mesh::Vertex_index(map.m_pm->layout().vertex_of_face(f)));
  }

  friend reference get(const One_point_from_face_descriptor_map& map, const std::pair<key_type, const Mesh*>& f)
  {
    return get(map, f.first);
  }

  Mesh* m_pm = nullptr;
  VertexPointMap m_vpm;
};

template <class P, class L, class VertexPointMap>
struct Triangle_from_face_descriptor_map<Compact_surface_mesh<P, L>, VertexPointMap>
{
  typedef Compact_surface_mesh<P, L> Mesh;
  typedef typename boost::property_traits<VertexPointMap>::value_type Point_3;
  typedef typename boost::graph_traits<Mesh>::face_descriptor key_type;
  typedef typename Kernel_traits<Point_3>::Kernel::Triangle_3 value_type;
  typedef value_type reference;
  typedef boost::readable_property_map_tag category;

  Triangle_from_face_descriptor_map() = default;
  Triangle_from_face_descriptor_map(const Mesh* tm) : m_tm(const_cast<Mesh*>(tm)), m_vpm(get(vertex_point, *m_tm)) {}
  Triangle_from_face_descriptor_map(const Mesh* tm, VertexPointMap vpm) : m_tm(const_cast<Mesh*>(tm)), m_vpm(vpm) {}

  friend value_type get(const Triangle_from_face_descriptor_map& map, key_type f)
  {
    const std::array<typename Mesh::Vertex_index, 3> v = map.m_tm->vertices_of_face(f);
    return value_type(get(map.m_vpm, v[0]), get(map.m_vpm, v[1]), get(map.m_vpm, v[2]));
  }

  friend value_type get(const Triangle_from_face_descriptor_map& map, const std::pair<key_type, const Mesh*>& f)
  {
    return get(map, f.first);
  }

  Mesh* m_tm = nullptr;
  VertexPointMap m_vpm;
};

// The same of a graph whose type is const.

template <class P, class L, class VertexPointMap>
struct One_point_from_face_descriptor_map<const Compact_surface_mesh<P, L>, VertexPointMap>
  : One_point_from_face_descriptor_map<Compact_surface_mesh<P, L>, VertexPointMap>
{
  using Base = One_point_from_face_descriptor_map<Compact_surface_mesh<P, L>, VertexPointMap>;
  using Base::Base;
};

template <class P, class L, class VertexPointMap>
struct Triangle_from_face_descriptor_map<const Compact_surface_mesh<P, L>, VertexPointMap>
  : Triangle_from_face_descriptor_map<Compact_surface_mesh<P, L>, VertexPointMap>
{
  using Base = Triangle_from_face_descriptor_map<Compact_surface_mesh<P, L>, VertexPointMap>;
  using Base::Base;
};

} // namespace CGAL

#endif // DOXYGEN_RUNNING

#endif // CGAL_BOOST_GRAPH_PROPERTY_MAPS_COMPACT_SURFACE_MESH_H
