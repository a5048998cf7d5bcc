// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_ELEMENT_PROPERTIES_H
#define CGAL_COMPACT_SURFACE_MESH_ELEMENT_PROPERTIES_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/internal/Large_array.h>
#include <CGAL/Compact_surface_mesh/internal/versions_of_cgal.h>

#include <CGAL/Surface_mesh/Properties.h>

#include <cstddef>
#include <iostream>
#include <string>
#include <tuple>
#include <type_traits>
#include <typeinfo>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgCompactSurfaceMeshRef

The class `Element_properties` is the part of a `Compact_surface_mesh` that is attached
to its elements: the points of the vertices, and any number of named property maps for
each kind of element. It behaves as the same part of `Surface_mesh` does, and stores its
property maps in the same containers.

The points are the property map `"v:point"`.

\tparam Point_ any type that can be default constructed and copied
\tparam Vertex_index_, Halfedge_index_, Edge_index_, Face_index_ the descriptors
*/
template <class Point_, class Vertex_index_, class Halfedge_index_, class Edge_index_, class Face_index_>
class Element_properties
{
  using Self = Element_properties;
  template <class Key> using Container = Properties::Property_container<Self, Key>;

public:
  /// the type of the points.
  using Point = Point_;

  /// A property map from elements to values of type `T`: a model of `LvaluePropertyMap`
  /// whose key type is `I`, one of the four descriptors. Copies share the values.
  template <class I, class T>
  struct Property_map
    : Properties::Property_map_base<I, T, Property_map<I, T> >
  {
#ifndef DOXYGEN_RUNNING
    using Base = Properties::Property_map_base<I, T, Property_map<I, T> >;
    using reference = typename Base::reference;

    Property_map() = default;
    Property_map(const Base& map) : Base(map) {}
#endif
  };

#ifndef DOXYGEN_RUNNING
  // asked for by Property_container
  template <class Key, class T>
  struct Get_property_map
  {
    using type = Property_map<Key, T>;
  };
#endif

  /// \name Property Maps
  /// The values of a property map stand in the order of the indices of their elements.
  /// @{

  /*!
  adds a property map for the elements of kind `I` in which each has the value `value`,
  or finds the one that has this name and type already.
  \param name a name, by custom starting with `v:`, `h:`, `e:` or `f:`; a new name is made
    if it is empty
  \param value what the elements of a new map get
  \returns the map and whether it is new
  */
  template <class I, class T>
  std::pair<Property_map<I, T>, bool> add_property_map(std::string name = std::string(), const T value = T())
  {
    if (name.empty())
      name = "anonymous-property-" + std::to_string(m_num_anonymous++);
    return container<I>().template add<T>(name, value);
  }

  /// finds the property map with key type `I`, value type `T` and name `name`.
  /// \returns what `Surface_mesh::property_map()` returns: in \cgal 5 the map and whether
  ///   it exists, from \cgal 6 on a `std::optional`
  template <class I, class T>
  auto property_map(const std::string& name) const
  {
    return container<I>().template get<T>(name);
  }

  /// finds the property map with key type `I`, value type `T` and name `name`.
  /// \returns the map, null if there is none, whatever the version of \cgal
  template <class I, class T>
  Property_map<I, T> find_property_map(const std::string& name) const
  {
    return internal::optional_map(property_map<I, T>(name)).value_or(Property_map<I, T>());
  }

  /// removes the property map `map` and resets `map`.
  template <class I, class T>
  void remove_property_map(Property_map<I, T>& map)
  {
    container<I>().template remove<T>(map);
  }

  /// removes all property maps for elements of kind `I` but `"v:point"`.
  template <class I>
  void remove_property_maps()
  {
    container<I>().resize_property_array(std::is_same<I, Vertex_index_>::value ? 1 : 0);
  }

  /// removes all property maps but `"v:point"`.
  void remove_all_property_maps()
  {
    remove_property_maps<Vertex_index_>();
    remove_property_maps<Halfedge_index_>();
    remove_property_maps<Edge_index_>();
    remove_property_maps<Face_index_>();
  }

  /// returns the value type of the property map for elements of kind `I` with the name
  /// `name`, and `typeid(void)` if there is none.
  template <class I>
  const std::type_info& property_type(const std::string& name) const
  {
    return container<I>().get_type(name);
  }

  /// returns the names of the property maps for elements of kind `I`.
  template <class I>
  std::vector<std::string> properties() const
  {
    return container<I>().properties();
  }

  /// prints the names of all property maps.
  void property_stats(std::ostream& out = std::cout) const
  {
    print_names<Vertex_index_>(out);
    print_names<Halfedge_index_>(out);
    print_names<Edge_index_>(out);
    print_names<Face_index_>(out);
  }

  /// frees memory that the property maps hold beyond their values.
  void shrink_to_fit()
  {
    std::apply([](auto&... containers) { (containers.shrink_to_fit(), ...); }, m_containers);
  }

  /// @}

  /// \name Points
  /// @{

  /// returns the point of vertex `v`.
  const Point& point(Vertex_index_ v) const { return m_points[v]; }
  /// returns the point of vertex `v`.
  Point& point(Vertex_index_ v) { return m_points[v]; }

  /// returns the property map `"v:point"`.
  Property_map<Vertex_index_, Point> points() const { return m_points; }
  /// returns the property map `"v:point"`.
  Property_map<Vertex_index_, Point>& points() { return m_points; }

  /// @}

#ifndef DOXYGEN_RUNNING
  // for the mesh that derives from it
protected:
  Element_properties() { find_points(); }

  Element_properties(const Element_properties& other)
    : m_containers(other.m_containers), m_num_anonymous(other.m_num_anonymous)
  {
    find_points();
  }

  // leaves the other one as if default constructed
  Element_properties(Element_properties&& other) noexcept
    : Element_properties()
  {
    swap_properties(other);
  }

  Element_properties& operator=(const Element_properties& other)
  {
    Element_properties copy(other);
    swap_properties(copy);
    return *this;
  }

  Element_properties& operator=(Element_properties&& other) noexcept
  {
    Element_properties moved(std::move(other));
    swap_properties(moved);
    return *this;
  }

  ~Element_properties() = default;

  void swap_properties(Element_properties& other) noexcept
  {
    swap_container<Vertex_index_>(other);
    swap_container<Halfedge_index_>(other);
    swap_container<Edge_index_>(other);
    swap_container<Face_index_>(other);
    std::swap(m_num_anonymous, other.m_num_anonymous);
    std::swap(m_points, other.m_points);
  }

  // Gives each property map one value per element.
  void resize_properties(std::size_t num_vertices, std::size_t num_halfedges,
                         std::size_t num_edges, std::size_t num_faces)
  {
    reserve_points(num_vertices);
    container<Vertex_index_>().resize(num_vertices);
    container<Halfedge_index_>().resize(num_halfedges);
    container<Edge_index_>().resize(num_edges);
    container<Face_index_>().resize(num_faces);
  }
#endif

private:
  template <class I> Container<I>& container() { return std::get<Container<I> >(m_containers); }
  template <class I> const Container<I>& container() const { return std::get<Container<I> >(m_containers); }

  void find_points() { m_points = add_property_map<Vertex_index_, Point>("v:point").first; }

  // The array of points is not ours to allocate; it has an address from its first element on.
  void reserve_points(std::size_t n)
  {
    auto& vertices = container<Vertex_index_>();
    if (vertices.size() != 0 || n * sizeof(Point) < internal::huge_page)
      return;
    vertices.reserve(n);
    vertices.resize(1);
    internal::ask_for_huge_pages(&m_points[Vertex_index_(0)], n * sizeof(Point));
  }

  template <class I>
  void swap_container(Element_properties& other)
  {
    container<I>().swap(other.template container<I>());
  }

  template <class I>
  void print_names(std::ostream& out) const
  {
    out << I::tag::name() << " properties:\n";
    for (const std::string& name : properties<I>())
      out << '\t' << name << '\n';
  }

  std::tuple<Container<Vertex_index_>, Container<Halfedge_index_>,
             Container<Edge_index_>, Container<Face_index_> > m_containers;
  Property_map<Vertex_index_, Point> m_points;
  std::size_t m_num_anonymous = 0;
};

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_ELEMENT_PROPERTIES_H
