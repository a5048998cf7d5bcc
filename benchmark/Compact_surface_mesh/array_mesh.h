// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef BENCHMARK_COMPACT_SURFACE_MESH_ARRAY_MESH_H
#define BENCHMARK_COMPACT_SURFACE_MESH_ARRAY_MESH_H

// Points and one of the papers' structures without faces, as a graph on which our kernels run.

#include "../../examples/Compact_surface_mesh/triangle_soup.h"

#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace example {

/// A closed triangle mesh. `Connectivity` is `Half_edge_arrays` or `Winged_edge_arrays`.
template <class Connectivity>
class Array_mesh
{
public:
  using Vertex_index = CGAL::SM_Vertex_index;
  using Halfedge_index = CGAL::SM_Halfedge_index;
  /// A face is named by its halfedge with the least index, since it is stored nowhere.
  using Face_index = CGAL::SM_Face_index;

  Array_mesh() = default;

  explicit Array_mesh(const Triangle_soup& soup)
    : m_connectivity(CGAL::Corner_table<>(soup.points.size(), soup.triangles)), m_points(soup.points)
  {}

  const Connectivity& connectivity() const { return m_connectivity; }
  const std::vector<Point>& points() const { return m_points; }

private:
  Connectivity m_connectivity;
  std::vector<Point> m_points;
};

/// \name Free Functions of a FaceListGraph
/// @{

template <class C>
auto num_vertices(const Array_mesh<C>& mesh) { return mesh.connectivity().num_vertices(); }
template <class C>
auto num_halfedges(const Array_mesh<C>& mesh) { return mesh.connectivity().num_halfedges(); }

template <class Descriptor>
struct Descriptor_of_index
{
  Descriptor operator()(std::uint32_t i) const { return Descriptor(i); }
};

/// returns the descriptors of the indices below `n`.
template <class Descriptor>
auto descriptors(std::size_t n)
{
  const auto iterator = [](std::size_t i) {
    return boost::make_transform_iterator(boost::counting_iterator<std::uint32_t>(static_cast<std::uint32_t>(i)),
                                          Descriptor_of_index<Descriptor>());
  };
  return boost::make_iterator_range(iterator(0), iterator(n));
}

template <class C>
auto vertices(const Array_mesh<C>& mesh)
{
  return descriptors<typename Array_mesh<C>::Vertex_index>(num_vertices(mesh));
}

template <class C>
auto halfedges(const Array_mesh<C>& mesh)
{
  return descriptors<typename Array_mesh<C>::Halfedge_index>(num_halfedges(mesh));
}

template <class C>
auto next(typename Array_mesh<C>::Halfedge_index h, const Array_mesh<C>& mesh)
{
  return typename Array_mesh<C>::Halfedge_index(mesh.connectivity().next(h));
}

template <class C>
auto prev(typename Array_mesh<C>::Halfedge_index h, const Array_mesh<C>& mesh)
{
  return typename Array_mesh<C>::Halfedge_index(mesh.connectivity().prev(h));
}

template <class C>
auto opposite(typename Array_mesh<C>::Halfedge_index h, const Array_mesh<C>& mesh)
{
  return typename Array_mesh<C>::Halfedge_index(mesh.connectivity().opposite(h));
}

template <class C>
auto source(typename Array_mesh<C>::Halfedge_index h, const Array_mesh<C>& mesh)
{
  return typename Array_mesh<C>::Vertex_index(mesh.connectivity().source(h));
}

template <class C>
auto target(typename Array_mesh<C>::Halfedge_index h, const Array_mesh<C>& mesh)
{
  return typename Array_mesh<C>::Vertex_index(mesh.connectivity().target(h));
}

template <class C>
auto halfedge(typename Array_mesh<C>::Vertex_index v, const Array_mesh<C>& mesh)
{
  return typename Array_mesh<C>::Halfedge_index(mesh.connectivity().halfedge_of_vertex(v));
}

template <class C>
auto halfedge(typename Array_mesh<C>::Face_index f, const Array_mesh<C>&)
{
  return typename Array_mesh<C>::Halfedge_index(f);
}

/// returns the halfedge from `u` to `v`, if there is one, in time linear in the degree of `v`.
template <class C>
auto halfedge(typename Array_mesh<C>::Vertex_index u, typename Array_mesh<C>::Vertex_index v,
              const Array_mesh<C>& mesh)
{
  const auto first = halfedge(v, mesh);
  auto h = first;
  do {
    if (source(h, mesh) == u)
      return std::make_pair(h, true);
    h = opposite(next(h, mesh), mesh);
  } while (h != first);
  return std::make_pair(typename Array_mesh<C>::Halfedge_index(), false);
}

template <class C>
auto face(typename Array_mesh<C>::Halfedge_index h, const Array_mesh<C>& mesh)
{
  const auto g = next(h, mesh), k = next(g, mesh);
  return typename Array_mesh<C>::Face_index((std::min)({ h.idx(), g.idx(), k.idx() }));
}

/// returns a list of the faces.
template <class C>
auto faces(const Array_mesh<C>& mesh)
{
  std::vector<typename Array_mesh<C>::Face_index> result;
  for (const auto h : halfedges(mesh))
    if (face(h, mesh).idx() == h.idx())
      result.emplace_back(h.idx());
  return result;
}

/// @}

/// \name Property Maps
/// @{

/// The index of a descriptor. Those of faces are not contiguous.
struct Index_of_descriptor
{
  template <class Descriptor>
  friend std::size_t get(Index_of_descriptor, Descriptor d) { return d.idx(); }
};

template <class C>
Index_of_descriptor get(boost::vertex_index_t, const Array_mesh<C>&) { return {}; }
template <class C>
Index_of_descriptor get(boost::halfedge_index_t, const Array_mesh<C>&) { return {}; }
template <class C>
Index_of_descriptor get(boost::face_index_t, const Array_mesh<C>&) { return {}; }

struct Point_of_vertex
{
  const Point* points;

  friend const Point& get(Point_of_vertex map, CGAL::SM_Vertex_index v) { return map.points[v.idx()]; }
};

template <class C>
Point_of_vertex get(CGAL::vertex_point_t, const Array_mesh<C>& mesh) { return { mesh.points().data() }; }

/// @}

/// What a comparison knows of such a mesh.
template <class Connectivity>
struct Array_structure
{
  using Mesh = Array_mesh<Connectivity>;

  static std::string name() { return Connectivity::name(); }
  static Mesh mesh_of(const Triangle_soup& soup) { return Mesh(soup); }
  static double connectivity_bytes(const Mesh& mesh)
  {
    return static_cast<double>(mesh.connectivity().num_references() * sizeof(typename Connectivity::Index));
  }
};

} // namespace example

namespace boost {

template <class Connectivity>
struct graph_traits<example::Array_mesh<Connectivity> >
{
  using Mesh = example::Array_mesh<Connectivity>;
  using vertex_descriptor = typename Mesh::Vertex_index;
  using halfedge_descriptor = typename Mesh::Halfedge_index;
  using face_descriptor = typename Mesh::Face_index;

  static face_descriptor null_face() { return face_descriptor(); }
};

} // namespace boost

#endif // BENCHMARK_COMPACT_SURFACE_MESH_ARRAY_MESH_H
