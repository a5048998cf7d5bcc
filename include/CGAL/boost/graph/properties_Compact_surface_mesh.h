// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The property maps of a Compact_surface_mesh by tag: indices, points and edge lengths,
// dynamic maps, and the named maps of Mesh_3. One table, Map_by_tag, says what they are;
// the rest of the file puts it where CGAL and Boost look for it.

#ifndef CGAL_PROPERTIES_COMPACT_SURFACE_MESH_H
#define CGAL_PROPERTIES_COMPACT_SURFACE_MESH_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/boost/graph/graph_traits_Compact_surface_mesh.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>
#include <CGAL/squared_distance_2.h>
#include <CGAL/squared_distance_3.h>
#include <CGAL/tags.h>

#include <boost/graph/properties.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <set>
#include <type_traits>
#include <utility>

namespace CGAL {

#ifndef DOXYGEN_RUNNING

namespace internal {

/// \name Maps
/// @{

// The index of a vertex, halfedge, edge or face. Not writable.
template <class Descriptor>
struct Descriptor_index_map
{
  using key_type = Descriptor;
  using value_type = typename Descriptor::size_type;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  value_type operator[](const key_type& d) const { return d.idx(); }
  friend value_type get(const Descriptor_index_map&, const key_type& d) { return d.idx(); }
};

// The length of an edge.
template <class Mesh>
class Edge_length_map
{
public:
  using key_type = typename Mesh::Edge_index;
  using value_type = typename Kernel_traits<typename Mesh::Point>::Kernel::FT;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  Edge_length_map() = default;
  explicit Edge_length_map(const Mesh& mesh) : m_mesh(&mesh) {}

  value_type operator[](const key_type& e) const
  {
    const auto h = m_mesh->halfedge(e);
    return approximate_sqrt(squared_distance(m_mesh->point(m_mesh->source(h)), m_mesh->point(m_mesh->target(h))));
  }
  friend value_type get(const Edge_length_map& map, const key_type& e) { return map[e]; }

private:
  const Mesh* m_mesh = nullptr;
};

// Values beside a mesh, which does not know of them: so several threads may make and drop
// such maps of one mesh. Copies share the values, and the last one takes them along.
template <class Descriptor, class T>
class Dynamic_descriptor_map
{
public:
  using key_type = Descriptor;
  using value_type = T;
  using reference = T&;
  using category = boost::lvalue_property_map_tag;

  Dynamic_descriptor_map() = default;
  explicit Dynamic_descriptor_map(std::size_t n) : m_values(new T[n]()) {}
  Dynamic_descriptor_map(std::size_t n, const T& value) : m_values(new T[n]) { std::fill_n(m_values.get(), n, value); }

  reference operator[](const key_type& d) const { return m_values[static_cast<std::ptrdiff_t>(d.idx())]; }
  friend reference get(const Dynamic_descriptor_map& map, const key_type& d) { return map[d]; }
  friend void put(const Dynamic_descriptor_map& map, const key_type& d, const T& value) { map[d] = value; }

private:
  std::shared_ptr<T[]> m_values;
};

/// @}

/// \name Table
/// of the maps that `get(tag, mesh)` yields: `type`, and `make()` from the mesh.
/// @{

template <class Mesh, class Tag>
struct Map_by_tag
{};

// A map that every mesh has.
template <class Map>
struct Intrinsic_map
{
  using type = Map;
  static constexpr bool is_intrinsic = true;
};

template <class Descriptor>
struct Index_map
  : Intrinsic_map<Descriptor_index_map<Descriptor> >
{
  template <class Mesh> static Descriptor_index_map<Descriptor> make(const Mesh&) { return {}; }
};

template <class Mesh> struct Map_by_tag<Mesh, boost::vertex_index_t> : Index_map<typename Mesh::Vertex_index> {};
template <class Mesh> struct Map_by_tag<Mesh, boost::halfedge_index_t> : Index_map<typename Mesh::Halfedge_index> {};
template <class Mesh> struct Map_by_tag<Mesh, boost::edge_index_t> : Index_map<typename Mesh::Edge_index> {};
template <class Mesh> struct Map_by_tag<Mesh, boost::face_index_t> : Index_map<typename Mesh::Face_index> {};

template <class Mesh>
struct Map_by_tag<Mesh, boost::vertex_point_t>
  : Intrinsic_map<typename Mesh::template Property_map<typename Mesh::Vertex_index, typename Mesh::Point> >
{
  static auto make(const Mesh& mesh) { return mesh.points(); }
};

template <class Mesh>
struct Map_by_tag<Mesh, boost::edge_weight_t>
  : Intrinsic_map<Edge_length_map<Mesh> >
{
  static auto make(const Mesh& mesh) { return Edge_length_map<Mesh>(mesh); }
};

// The whole mesh is one patch, with subdomain 1 inside and 0 outside.
template <class Mesh>
struct Map_by_tag<Mesh, face_patch_id_t<void> >
{
  using type = Constant_property_map<typename Mesh::Face_index, std::pair<int, int> >;
  static constexpr bool is_intrinsic = false;

  static type make(const Mesh&) { return type(std::make_pair(0, 1)); }
};

// A map with the name Derived::name(). It is added to a mesh that may be changed, and found,
// or null, in one that may not.
template <class Mesh, class Key, class T, class Derived>
struct Named_map
{
  using type = typename Mesh::template Property_map<Key, T>;
  static constexpr bool is_intrinsic = false;

  static type make(const Mesh& mesh) { return mesh.template find_property_map<Key, T>(Derived::name()); }
  static type make(Mesh& mesh)
  {
    return mesh.template add_property_map<Key, T>(Derived::name(), Derived::value()).first;
  }
  static T value() { return T(); }
};

template <class Mesh>
struct Map_by_tag<Mesh, edge_is_feature_t>
  : Named_map<Mesh, typename Mesh::Edge_index, bool, Map_by_tag<Mesh, edge_is_feature_t> >
{
  static const char* name() { return "e:is_feature"; }
};

template <class Mesh>
struct Map_by_tag<Mesh, vertex_feature_degree_t>
  : Named_map<Mesh, typename Mesh::Vertex_index, int, Map_by_tag<Mesh, vertex_feature_degree_t> >
{
  static const char* name() { return "v:nfe"; }
};

template <class Mesh, class T>
struct Map_by_tag<Mesh, vertex_incident_patches_t<T> >
  : Named_map<Mesh, typename Mesh::Vertex_index, std::set<T>, Map_by_tag<Mesh, vertex_incident_patches_t<T> > >
{
  static const char* name() { return "v:ip"; }
};

template <class Mesh, class T>
struct Map_by_tag<Mesh, face_patch_id_t<T> >
  : Named_map<Mesh, typename Mesh::Face_index, T, Map_by_tag<Mesh, face_patch_id_t<T> > >
{
  static const char* name() { return "f:patch_id"; }
  static T value() { return T(1); }
};

template <class Mesh>
struct Map_by_tag<Mesh, vertex_time_stamp_t>
  : Named_map<Mesh, typename Mesh::Vertex_index, std::size_t, Map_by_tag<Mesh, vertex_time_stamp_t> >
{
  static const char* name() { return "v:time_stamp"; }
};

template <class Mesh>
struct Map_by_tag<Mesh, halfedge_time_stamp_t>
  : Named_map<Mesh, typename Mesh::Halfedge_index, std::size_t, Map_by_tag<Mesh, halfedge_time_stamp_t> >
{
  static const char* name() { return "h:time_stamp"; }
};

template <class Mesh>
struct Map_by_tag<Mesh, face_time_stamp_t>
  : Named_map<Mesh, typename Mesh::Face_index, std::size_t, Map_by_tag<Mesh, face_time_stamp_t> >
{
  static const char* name() { return "f:time_stamp"; }
};

/// @}

// What boost::property_map tells of it, const and not being the same: maps are handles.
template <class Mesh, class Tag, class = void>
struct Map_types_by_tag
{};

template <class Mesh, class Tag>
struct Map_types_by_tag<Mesh, Tag, std::void_t<typename Map_by_tag<Mesh, Tag>::type> >
{
  using type = typename Map_by_tag<Mesh, Tag>::type;
  using const_type = type;
};

template <class Mesh, class Tag, class = void>
struct Is_intrinsic_tag : Tag_false {};

template <class Mesh, class Tag>
struct Is_intrinsic_tag<Mesh, Tag, std::void_t<typename Map_by_tag<Mesh, Tag>::type> >
  : Boolean_tag<Map_by_tag<Mesh, Tag>::is_intrinsic>
{};

template <class Mesh, class Tag>
using Enable_if_intrinsic = std::enable_if_t<Is_intrinsic_tag<Mesh, Tag>::value, typename Map_by_tag<Mesh, Tag>::type>;

// What an owner of dynamic maps may call: they go with their last copy.
template <class Descriptor, class T, class Mesh>
void remove_property(Dynamic_descriptor_map<Descriptor, T>, const Mesh&)
{}

} // namespace internal

template <class P, class L, class Tag>
struct graph_has_property<Compact_surface_mesh<P, L>, Tag>
  : internal::Is_intrinsic_tag<Compact_surface_mesh<P, L>, Tag>::type
{};

template <class P, class L, class Tag>
struct graph_has_property<const Compact_surface_mesh<P, L>, Tag>
  : internal::Is_intrinsic_tag<Compact_surface_mesh<P, L>, Tag>::type
{};

#endif // DOXYGEN_RUNNING

/// \relates Compact_surface_mesh
/// returns the property map of `tag`: indices, points, edge weights; or finds a named one,
/// which is null if the mesh has no map of that name.
template <class P, class L, class Tag>
auto get(Tag, const Compact_surface_mesh<P, L>& g)
#ifndef DOXYGEN_RUNNING
  -> typename internal::Map_by_tag<Compact_surface_mesh<P, L>, Tag>::type
#endif
{
  return internal::Map_by_tag<Compact_surface_mesh<P, L>, Tag>::make(g);
}

/// \relates Compact_surface_mesh
/// returns the property map of `tag`: indices, points, edge weights; or finds a named one,
/// and adds it if the mesh has no map of that name.
template <class P, class L, class Tag>
auto get(Tag, Compact_surface_mesh<P, L>& g)
#ifndef DOXYGEN_RUNNING
  -> typename internal::Map_by_tag<Compact_surface_mesh<P, L>, Tag>::type
#endif
{
  return internal::Map_by_tag<Compact_surface_mesh<P, L>, Tag>::make(g);
}

#ifndef DOXYGEN_RUNNING

// The value of `key` in the property map of `tag`: its index, point or edge weight.
template <class P, class L, class Tag>
auto get(Tag tag, const Compact_surface_mesh<P, L>& g,
         const typename internal::Enable_if_intrinsic<Compact_surface_mesh<P, L>, Tag>::key_type& key)
  -> typename boost::property_traits<typename internal::Map_by_tag<Compact_surface_mesh<P, L>, Tag>::type>::reference
{
  return get(get(tag, g), key);
}

// Moves vertex `v` to `point`.
template <class P, class L>
void put(vertex_point_t tag, const Compact_surface_mesh<P, L>& g,
         const typename Compact_surface_mesh<P, L>::Vertex_index& v, const P& point)
{
  put(get(tag, g), v, point);
}

#endif // DOXYGEN_RUNNING

} // namespace CGAL

#ifndef DOXYGEN_RUNNING

namespace boost {

template <class P, class L, class Tag>
struct property_map<CGAL::Compact_surface_mesh<P, L>, Tag>
  : CGAL::internal::Map_types_by_tag<CGAL::Compact_surface_mesh<P, L>, Tag>
{};

template <class P, class L, class Tag>
struct property_map<const CGAL::Compact_surface_mesh<P, L>, Tag>
  : CGAL::internal::Map_types_by_tag<CGAL::Compact_surface_mesh<P, L>, Tag>
{};

} // namespace boost

// The four dynamic maps: each a new one, in which all elements have the value `value`. They
// need specialisations and an overload apart, since CGAL has some for every graph.
#define CGAL_COMPACT_SURFACE_MESH_DYNAMIC_MAP(TAG, DESCRIPTOR, NUM_ELEMENTS)                \
  namespace boost {                                                                         \
  template <class P, class L, class T>                                                      \
  struct property_map<CGAL::Compact_surface_mesh<P, L>, CGAL::TAG<T> >                      \
  {                                                                                         \
    using descriptor = typename CGAL::Compact_surface_mesh<P, L>::DESCRIPTOR;               \
    using type = CGAL::internal::Dynamic_descriptor_map<descriptor, T>;                     \
    using const_type = type;                                                                \
  };                                                                                        \
  template <class P, class L, class T>                                                      \
  struct property_map<const CGAL::Compact_surface_mesh<P, L>, CGAL::TAG<T> >                \
    : property_map<CGAL::Compact_surface_mesh<P, L>, CGAL::TAG<T> >                         \
  {};                                                                                       \
  }                                                                                         \
  namespace CGAL {                                                                          \
  template <class P, class L, class T>                                                      \
  internal::Dynamic_descriptor_map<typename Compact_surface_mesh<P, L>::DESCRIPTOR, T>      \
  get(const TAG<T>&, const Compact_surface_mesh<P, L>& g)                                   \
  {                                                                                         \
    return internal::Dynamic_descriptor_map<                                                \
             typename Compact_surface_mesh<P, L>::DESCRIPTOR, T>(g.NUM_ELEMENTS());          \
  }                                                                                         \
  template <class P, class L, class T>                                                      \
  internal::Dynamic_descriptor_map<typename Compact_surface_mesh<P, L>::DESCRIPTOR, T>      \
  get(const TAG<T>&, const Compact_surface_mesh<P, L>& g, const T& value)                   \
  {                                                                                         \
    return { g.NUM_ELEMENTS(), value };                                                     \
  }                                                                                         \
  }

CGAL_COMPACT_SURFACE_MESH_DYNAMIC_MAP(dynamic_vertex_property_t, Vertex_index, num_vertices)
CGAL_COMPACT_SURFACE_MESH_DYNAMIC_MAP(dynamic_halfedge_property_t, Halfedge_index, num_halfedges)
CGAL_COMPACT_SURFACE_MESH_DYNAMIC_MAP(dynamic_edge_property_t, Edge_index, num_edges)
CGAL_COMPACT_SURFACE_MESH_DYNAMIC_MAP(dynamic_face_property_t, Face_index, num_faces)

#undef CGAL_COMPACT_SURFACE_MESH_DYNAMIC_MAP

#endif // DOXYGEN_RUNNING

#endif // CGAL_PROPERTIES_COMPACT_SURFACE_MESH_H
