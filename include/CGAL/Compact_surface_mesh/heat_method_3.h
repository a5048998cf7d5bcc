// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The intrinsic mode of CGAL's heat method flips edges of a copy of its mesh, so the copy must be a Surface_mesh. This
// is the only place where one is made of a Compact_surface_mesh that the user has not asked for. The headers of the
// heat method need not be included.

#ifndef CGAL_COMPACT_SURFACE_MESH_HEAT_METHOD_3_H
#define CGAL_COMPACT_SURFACE_MESH_HEAT_METHOD_3_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Compact_surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph_Compact_surface_mesh.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>

#include <set>
#include <vector>

#ifndef DOXYGEN_RUNNING

namespace CGAL {
namespace Heat_method_3 {

struct Intrinsic_Delaunay;

namespace internal {

template <class TriangleMesh, class Traits, class Mode, class LA, class VertexPointMap>
struct Base_helper;

// The heat method on a copy of the mesh, asked and answering in vertices of the mesh.
template <class P, class L, class Traits, class LA, class VertexPointMap>
struct Base_helper<Compact_surface_mesh<P, L>, Traits, Intrinsic_Delaunay, LA, VertexPointMap>
{
private:
  using Mesh = Compact_surface_mesh<P, L>;
  using Vertex = typename Mesh::Vertex_index;
  using Copy = Surface_mesh<typename boost::property_traits<VertexPointMap>::value_type>;
  using Copied_vertex = typename Copy::Vertex_index;
  using Copy_helper = Base_helper<Copy, Traits, Intrinsic_Delaunay, LA,
                                  typename boost::property_map<Copy, vertex_point_t>::const_type>;

  // Passes the distance of a vertex of the copy on to the map of the caller.
  template <class VertexDistanceMap>
  struct Distance_map
  {
    using key_type = Copied_vertex;
    using value_type = double;
    using reference = double;
    using category = boost::writable_property_map_tag;

    friend void put(const Distance_map& map, const key_type& v, double distance)
    {
      put(map.distances, (*map.vertex)[v], distance);
    }

    VertexDistanceMap distances;
    const std::vector<Vertex>* vertex;
  };

public:
  using type = Base_helper;
  using Vertex_const_range = std::set<Vertex>;

  Base_helper(const Mesh& mesh, VertexPointMap points)
    : m_mesh(mesh), m_copy(copied(mesh, points)), m_helper(m_copy)
  {}

  explicit Base_helper(const Mesh& mesh) : Base_helper(mesh, get(vertex_point, mesh)) {}

  // it refers to its copy of the mesh
  Base_helper(const Base_helper&) = delete;
  Base_helper& operator=(const Base_helper&) = delete;

  type& base() { return *this; }
  const type& base() const { return *this; }

  const Mesh& triangle_mesh() const { return m_mesh; }

  bool add_source(Vertex v)
  {
    if (m_image[v].is_valid()) // isolated vertices are not copied
      m_helper.base().add_source(m_image[v]);
    return m_sources.insert(v).second;
  }

  template <class Range>
  void add_sources(const Range& range)
  {
    for (const Vertex v : range)
      add_source(v);
  }

  bool remove_source(Vertex v)
  {
    if (m_image[v].is_valid())
      m_helper.base().remove_source(m_image[v]);
    return m_sources.erase(v) == 1;
  }

  void clear_sources()
  {
    m_helper.base().clear_sources();
    m_sources.clear();
  }

  const Vertex_const_range& sources() const { return m_sources; }

  template <class VertexDistanceMap>
  void estimate_geodesic_distances(VertexDistanceMap distances)
  {
    m_helper.estimate_geodesic_distances(Distance_map<VertexDistanceMap>{ distances, &m_vertex });
  }

private:
  // A copy of the mesh. Tells which vertices correspond.
  Copy copied(const Mesh& mesh, VertexPointMap points)
  {
    Copy copy;
    m_image.resize(mesh.number_of_vertices());
    copy_face_graph(mesh, copy, CGAL::internal::by_function_of_cgal(
                                  parameters::vertex_point_map(points)
                                    .vertex_to_vertex_map(make_property_map(m_image))));
    m_vertex.resize(copy.number_of_vertices());
    for (const Vertex v : mesh.vertices())
      if (m_image[v].is_valid())
        m_vertex[m_image[v]] = v;
    return copy;
  }

  const Mesh& m_mesh;
  std::vector<Copied_vertex> m_image; // of each vertex of the mesh
  std::vector<Vertex> m_vertex;       // of which each vertex of the copy is the image
  const Copy m_copy;
  Copy_helper m_helper;
  Vertex_const_range m_sources;
};

} // namespace internal
} // namespace Heat_method_3
} // namespace CGAL

#endif // DOXYGEN_RUNNING

#endif // CGAL_COMPACT_SURFACE_MESH_HEAT_METHOD_3_H
