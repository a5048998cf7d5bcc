// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Property maps follow the elements when one mesh becomes another. Their value types can only be
// found by asking for one after the other, so it is said here which are asked for.

#ifndef CGAL_COMPACT_SURFACE_MESH_INTERNAL_SIMPLE_PROPERTY_MAPS_H
#define CGAL_COMPACT_SURFACE_MESH_INTERNAL_SIMPLE_PROPERTY_MAPS_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Compact_surface_mesh_fwd.h>
#include <CGAL/Compact_surface_mesh/internal/versions_of_cgal.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Origin.h>
#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>

#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace internal {

// Whether a graph has named property maps as Surface_mesh has them: so do Surface_mesh, Compact_surface_mesh
// and what derives from one of them.
template <class P> std::true_type has_named_property_maps(const Surface_mesh<P>*);
template <class P, class L> std::true_type has_named_property_maps(const Compact_surface_mesh<P, L>*);
std::false_type has_named_property_maps(const void*);

template <class Graph>
inline constexpr bool has_property_maps =
  decltype(has_named_property_maps(static_cast<const Graph*>(nullptr)))::value;

template <class... >
struct Value_types
{};

using Numbers_and_texts =
  Value_types<bool, char, signed char, unsigned char, short, unsigned short, int, unsigned int, long, unsigned long,
              long long, unsigned long long, float, double, long double, std::pair<int, int>, std::string, IO::Color>;

// The values of the kernel of a point; a point without kernel has none.
template <class Kernel, class = void>
struct Values_of_kernel
{
  using type = Value_types<>;
};

template <class Kernel>
struct Values_of_kernel<Kernel, std::void_t<typename Kernel::FT, typename Kernel::Point_3, typename Kernel::Vector_3,
                                            typename Kernel::Point_2, typename Kernel::Vector_2> >
{
  using type = Value_types<typename Kernel::FT, typename Kernel::Point_3, typename Kernel::Vector_3,
                           typename Kernel::Point_2, typename Kernel::Vector_2>;
};

template <class Map, class Visitor>
bool visit_found(const std::optional<Map>& map, const Visitor& visit)
{
  if (map)
    visit(*map);
  return map.has_value();
}

// Calls visit(map) if the mesh has a map with this name and one of these types of values.
template <class Element, class Mesh, class Visitor, class... T>
bool visit_map(const Mesh& mesh, const std::string& name, const Visitor& visit, Value_types<T...>)
{
  return (visit_found(optional_map(mesh.template property_map<Element, T>(name)), visit) || ...);
}

// Calls visit(name, map) for the property maps of a kind of elements whose values are simple. Points and what
// Surface_mesh keeps in such maps for itself are left out.
template <class Element, class Mesh, class Visitor>
void for_each_simple_map(const Mesh& mesh, const Visitor& visit)
{
  using Point = typename Mesh::Point;
  using Values = typename Values_of_kernel<typename Kernel_traits<Point>::Kernel>::type;
  for (const std::string& name : mesh.template properties<Element>()) {
    if (name == "v:point" || name == "v:removed" || name == "e:removed" || name == "f:removed")
      continue;
    const auto visit_it = [&](const auto& map) { visit(name, map); };
    visit_map<Element>(mesh, name, visit_it, Numbers_and_texts()) || visit_map<Element>(mesh, name, visit_it, Values())
      || visit_map<Element>(mesh, name, visit_it, Value_types<Point>());
  }
}

template <class Element, class Mesh>
bool has_simple_maps(const Mesh& mesh)
{
  bool has = false;
  for_each_simple_map<Element>(mesh, [&has](const auto&...) { has = true; });
  return has;
}

// Whether the simple property maps of a graph cannot be copied without knowing what becomes of halfedges.
template <class Graph>
bool maps_need_halfedges(const Graph& g)
{
  if constexpr (has_property_maps<Graph>)
    return has_simple_maps<typename Graph::Halfedge_index>(g) || has_simple_maps<typename Graph::Edge_index>(g)
        || has_simple_maps<typename Graph::Face_index>(g);
  else
    return false;
}

// What elements get that have no image: CGAL's points and vectors are not initialized by default.
template <class T>
T simple_default()
{
  if constexpr (std::is_convertible<Origin, T>::value)
    return ORIGIN;
  else if constexpr (std::is_convertible<Null_vector, T>::value)
    return NULL_VECTOR;
  else
    return T();
}

// Copies the simple property maps of a kind of elements to `target`, where for_each_pair(visit) calls
// visit(element of the source, element of the target).
template <class Element, class Image, class Source, class Target, class ForEachPair>
void copy_simple_maps(const Source& source, Target& target, const ForEachPair& for_each_pair)
{
  for_each_simple_map<Element>(source, [&](const std::string& name, const auto& map) {
    using T = typename std::decay_t<decltype(map)>::value_type;
    auto image_map = target.template add_property_map<Image, T>(name, simple_default<T>()).first;
    for_each_pair([&](const Element& element, const Image& image) { image_map[image] = map[element]; });
  });
}

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_INTERNAL_SIMPLE_PROPERTY_MAPS_H
