// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The properties of a mesh in a PLY file: those of a simple type, normals and colors.

#ifndef CGAL_COMPACT_SURFACE_MESH_IO_INTERNAL_PLY_PROPERTIES_H
#define CGAL_COMPACT_SURFACE_MESH_IO_INTERNAL_PLY_PROPERTIES_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/IO/internal/PLY_file.h>
#include <CGAL/Compact_surface_mesh/IO/internal/read_mesh.h>
#include <CGAL/Compact_surface_mesh/internal/Mesh_filling.h>
#include <CGAL/Compact_surface_mesh/internal/versions_of_cgal.h>

#include <CGAL/IO/Color.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/io.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <ostream>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// Makes the columns of `table`, whose rows are the values of `elements`, property maps of the mesh. The
// elements may be null.
template <class Mesh, class Element>
void store_properties(Mesh_filling<Mesh>& filling, const PLY_table& table, const std::string& prefix,
                      const std::vector<Element>& elements)
{
  for (const std::vector<PLY_column>* const columns : { &table.columns(), &table.lists() })
    for (const PLY_column& column : *columns)
      column.visit([&](const auto& values) {
        using T = typename std::decay_t<decltype(values)>::value_type;
        const auto map = filling.template add_property_map<Element, T>(prefix + column.name).first;
        for (std::size_t i = 0; i < elements.size(); ++i)
          if (elements[i].is_valid())
            put(map, elements[i], values[i]);
      });
}

// Prints a number and, in text, a space.
template <class T>
void print_PLY_number(std::ostream& os, T value)
{
  if (get_mode(os) == BINARY)
    os.write(reinterpret_cast<const char*>(&value), sizeof(value));
  else
    os << +value << ' '; // a byte as a number
}

// Prints the number of elements of a list, as one byte if the lists are not long.
inline void print_PLY_list_size(std::ostream& os, std::size_t size, bool are_long)
{
  if (are_long)
    print_PLY_number(os, static_cast<std::uint32_t>(size));
  else
    print_PLY_number(os, static_cast<std::uint8_t>(size));
}

template <class Number, class T>
Number as_number(const T& value)
{
  if constexpr (std::is_arithmetic<T>::value)
    return static_cast<Number>(value);
  else
    return static_cast<Number>(CGAL::to_double(value));
}

// The type of the numbers of a point, a normal or a color in a file.
template <class T>
struct Written_number
{
  using type = std::conditional_t<std::is_same<typename Kernel_traits<T>::Kernel::FT, float>::value, float, double>;
};

template <>
struct Written_number<Color>
{
  using type = std::uint8_t;
};

// Prints the properties of the elements of one kind.
template <class Mesh, class Element>
class PLY_property_writer
{
  using Point = typename Mesh::Point;
  using Vector = typename Kernel_traits<Point>::Kernel::Vector_3;

public:
  // Chooses the property maps of `mesh` that PLY can hold, `prefix` being that of their names, and those that the
  // caller gives in place of some.
  template <class NamedParameters>
  PLY_property_writer(const Mesh& mesh, const std::string& prefix, const NamedParameters& np)
    : m_mesh(mesh)
  {
    std::vector<std::string> names = mesh.template properties<Element>();
    if constexpr (is_of_vertices) {
      add_name<internal_np::vertex_normal_map_t, NamedParameters>("v:normal", names);
      add_name<internal_np::vertex_color_map_t, NamedParameters>("v:color", names);
    } else if constexpr (is_of_faces)
      add_name<internal_np::face_color_map_t, NamedParameters>("f:color", names);
    for (const std::string& name : names) {
      const std::string short_name = name.compare(0, prefix.size(), prefix) == 0 ? name.substr(prefix.size()) : name;
      if (!add_special(name, np))
        add_number<std::int8_t>(name, short_name) || add_number<std::uint8_t>(name, short_name)
          || add_number<std::int16_t>(name, short_name) || add_number<std::uint16_t>(name, short_name)
          || add_number<std::int32_t>(name, short_name) || add_number<std::uint32_t>(name, short_name)
          || add_number<std::int64_t, std::int32_t>(name, short_name)
          || add_number<std::uint64_t, std::uint32_t>(name, short_name)
          || add_number<float>(name, short_name) || add_number<double>(name, short_name)
          || (CGAL::internal::is_with_cgal_6
              && (add_list<std::int8_t>(name, short_name) || add_list<std::uint8_t>(name, short_name)
                  || add_list<std::int16_t>(name, short_name) || add_list<std::uint16_t>(name, short_name)
                  || add_list<std::int32_t>(name, short_name) || add_list<std::uint32_t>(name, short_name)
                  || add_list<float>(name, short_name) || add_list<double>(name, short_name)));
    }
  }

  bool empty() const { return m_printers.empty(); }

  void print_header(std::ostream& os) const { os << m_header.str(); }

  void print(std::ostream& os, const Element& element) const
  {
    for (const auto& printer : m_printers)
      printer(os, element);
    if (get_mode(os) == ASCII)
      os << '\n';
  }

private:
  static constexpr bool is_of_vertices = std::is_same<Element, typename Mesh::Vertex_index>::value;
  static constexpr bool is_of_faces = std::is_same<Element, typename Mesh::Face_index>::value;

  // Adds `name` to `names` if the caller gives a map for it.
  template <class Tag, class NamedParameters>
  static void add_name(const char* name, std::vector<std::string>& names)
  {
    if (is_given<NamedParameters, Tag> && std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
  }

  // Adds the map `name`, or that which the caller gives in place of it, if it holds points, normals or colors.
  template <class NamedParameters>
  bool add_special(const std::string& name, const NamedParameters& np)
  {
    const std::initializer_list<const char*> rgba = { "red", "green", "blue", "alpha" };
    if constexpr (is_of_vertices)
      return (name == "v:point" && add_object<Point>(name, internal_np::vertex_point, np, { "x", "y", "z" }))
          || (name == "v:normal" && add_object<Vector>(name, internal_np::vertex_normal_map, np, { "nx", "ny", "nz" }))
          || (name == "v:color" && add_object<Color>(name, internal_np::vertex_color_map, np, rgba));
    else if constexpr (is_of_faces)
      return name == "f:color" && add_object<Color>(name, internal_np::face_color_map, np, rgba);
    else
      return false;
  }

  // Adds the map for `tag` that the caller gives, or else the map `name` if its values are of type T.
  template <class T, class Tag, class NamedParameters>
  bool add_object(const std::string& name, Tag tag, const NamedParameters& np,
                  std::initializer_list<const char*> columns)
  {
    if constexpr (is_given<NamedParameters, Tag>) {
      add_object_map(parameters::get_parameter(np, tag), columns);
      return true;
    } else {
      const auto map = m_mesh.template find_property_map<Element, T>(name);
      if (map)
        add_object_map(map, columns);
      return static_cast<bool>(map);
    }
  }

  // Adds a map whose values are written as several numbers.
  template <class Map>
  void add_object_map(const Map& map, std::initializer_list<const char*> columns)
  {
    using Written = typename Written_number<typename boost::property_traits<Map>::value_type>::type;
    const int n = static_cast<int>(columns.size());
    for (const char* column : columns)
      property_header(m_header, PLY_property<Written>(column));
    m_printers.push_back([map, n](std::ostream& os, const Element& element) {
      for (int i = 0; i < n; ++i)
        print_PLY_number(os, as_number<Written>(get(map, element)[i]));
    });
  }

  // Adds the map `name` if its values are of type T, to be written as numbers of type Written.
  template <class T, class Written = T>
  bool add_number(const std::string& name, const std::string& short_name)
  {
    const auto map = m_mesh.template find_property_map<Element, T>(name);
    if (!map)
      return false;
    property_header(m_header, PLY_property<Written>(short_name.c_str()));
    m_printers.push_back([map](std::ostream& os, const Element& element) {
      print_PLY_number(os, static_cast<Written>(get(map, element)));
    });
    return true;
  }

  // Adds the map `name` if its values are vectors of numbers of type T.
  template <class T>
  bool add_list(const std::string& name, const std::string& short_name)
  {
    const auto map = m_mesh.template find_property_map<Element, std::vector<T> >(name);
    if (!map)
      return false;
    const bool has_long_lists = std::any_of(map.begin(), map.end(), [](const std::vector<T>& list) {
      return list.size() > (std::numeric_limits<std::uint8_t>::max)();
    });
    m_header << "property list " << (has_long_lists ? "uint " : "uchar ");
    property_header_type<T>(m_header);
    m_header << ' ' << short_name << '\n';
    m_printers.push_back([map, has_long_lists](std::ostream& os, const Element& element) {
      const std::vector<T>& list = get(map, element);
      print_PLY_list_size(os, list.size(), has_long_lists);
      for (const T number : list)
        print_PLY_number(os, number);
    });
    return true;
  }

  const Mesh& m_mesh;
  std::ostringstream m_header;
  std::vector<std::function<void(std::ostream&, const Element&)> > m_printers;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_IO_INTERNAL_PLY_PROPERTIES_H
