// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// A PLY file in memory: polygons, and one typed column for each other property. CGAL's reader of PLY makes lists
// as long as they say before it reads them.

#ifndef CGAL_COMPACT_SURFACE_MESH_IO_INTERNAL_PLY_FILE_H
#define CGAL_COMPACT_SURFACE_MESH_IO_INTERNAL_PLY_FILE_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/internal/versions_of_cgal.h>

#include <CGAL/IO/Color.h>
#include <CGAL/IO/io.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <istream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// Numbers of one of the types of PLY.
class PLY_numbers
{
  template <class... Ts> using Vector_of_one_of = std::variant<std::vector<Ts>...>;
  using Values = Vector_of_one_of<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t, std::int32_t,
                                  std::uint32_t, float, double>;

public:
  // Throws if `type` is no name of a type.
  explicit PLY_numbers(const std::string& type) : m_values(values_of_type(type)) {}

  std::size_t size() const
  {
    return std::visit([](const auto& values) { return values.size(); }, m_values);
  }

  template <class T>
  bool have_type() const { return std::holds_alternative<std::vector<T> >(m_values); }
  bool are_integers() const { return !have_type<float>() && !have_type<double>(); }

  double operator[](std::size_t i) const
  {
    return std::visit([i](const auto& values) { return static_cast<double>(values[i]); }, m_values);
  }

  // Calls visit(values) with the vector of all numbers.
  template <class Visitor> void visit(const Visitor& visit) const { std::visit(visit, m_values); }
  template <class Visitor> void visit(const Visitor& visit) { std::visit(visit, m_values); }

private:
  static Values values_of_type(const std::string& type)
  {
    if (type == "char" || type == "int8")
      return std::vector<std::int8_t>();
    if (type == "uchar" || type == "uint8")
      return std::vector<std::uint8_t>();
    if (type == "short" || type == "int16")
      return std::vector<std::int16_t>();
    if (type == "ushort" || type == "uint16")
      return std::vector<std::uint16_t>();
    if (type == "int" || type == "int32")
      return std::vector<std::int32_t>();
    if (type == "uint" || type == "uint32")
      return std::vector<std::uint32_t>();
    if (type == "float" || type == "float32")
      return std::vector<float>();
    if (type == "double" || type == "float64")
      return std::vector<double>();
    throw std::runtime_error("a property has a type that is none: " + type);
  }

  Values m_values;
};

struct PLY_column
{
  std::string name;
  PLY_numbers numbers;
  std::optional<PLY_numbers> list_size; // where each value is a list
  std::vector<std::size_t> list_ends;   // the number of numbers up to the end of each list

  // Calls visit(values) with the vector of all values: numbers, or vectors of them.
  template <class Visitor>
  void visit(const Visitor& visitor) const
  {
    numbers.visit([&](const auto& values) {
      if (!list_size)
        visitor(values);
      else if constexpr (CGAL::internal::is_with_cgal_6) {
        std::vector<std::decay_t<decltype(values)> > lists;
        std::ptrdiff_t begin = 0;
        for (const std::size_t list_end : list_ends) {
          const std::ptrdiff_t end = static_cast<std::ptrdiff_t>(list_end);
          lists.emplace_back(values.begin() + begin, values.begin() + end);
          begin = end;
        }
        visitor(lists);
      }
    });
  }
};

// The numbers of a stream. Throws if something is no number, or missing.
class PLY_input
{
public:
  PLY_input(std::istream& is, const std::string& format)
    : m_is(is), m_is_text(format == "ascii"), m_is_big_endian(format == "binary_big_endian")
  {
    if (!m_is_text && !m_is_big_endian && format != "binary_little_endian")
      throw std::runtime_error("the format of the file is not known: " + format);
  }

  void append_to(PLY_numbers& numbers)
  {
    numbers.visit([this](auto& values) {
      values.push_back(read<typename std::decay_t<decltype(values)>::value_type>());
    });
  }

  // Appends the next list to a column of lists.
  void append_list_to(PLY_column& column)
  {
    for (std::int64_t size = size_of_list(column); size != 0; --size)
      append_to(column.numbers);
    column.list_ends.push_back(column.numbers.size());
  }

  // Returns the next value of a column of lists, empty if it is not of integers.
  std::vector<std::size_t> list(const PLY_column& column)
  {
    std::vector<std::size_t> result;
    std::int64_t size = size_of_list(column);
    column.numbers.visit([&](const auto& values) {
      using T = typename std::decay_t<decltype(values)>::value_type;
      for (; size != 0; --size) {
        const T value = read<T>();
        if constexpr (std::is_integral<T>::value)
          result.push_back(static_cast<std::size_t>(value));
      }
    });
    return result;
  }

private:
  std::int64_t size_of_list(const PLY_column& column)
  {
    std::int64_t size = 0;
    column.list_size->visit([&](const auto& sizes) {
      size = static_cast<std::int64_t>(read<typename std::decay_t<decltype(sizes)>::value_type>());
    });
    if (size < 0)
      throw std::runtime_error("a list has a negative length");
    return size;
  }

  template <class T>
  T read()
  {
    T value = T();
    if (!m_is_text) {
      char bytes[sizeof(T)];
      if (m_is.read(bytes, sizeof(T))) {
        if (m_is_big_endian)
          std::reverse(bytes, bytes + sizeof(T));
        std::memcpy(&value, bytes, sizeof(T));
      }
    } else if constexpr (sizeof(T) == 1) { // a number, not a letter
      std::conditional_t<std::is_signed<T>::value, short, unsigned short> number = 0;
      m_is >> number;
      value = static_cast<T>(number);
    } else if constexpr (std::is_floating_point<T>::value)
      m_is >> iformat(value);
    else
      m_is >> value;
    if (m_is.fail())
      throw std::runtime_error("the file ends too early, or something in it is not a number");
    return value;
  }

  std::istream& m_is;
  bool m_is_text, m_is_big_endian;
};

// The elements of one kind.
class PLY_table
{
public:
  // Appends the lists of vertices to `polygons`. Of properties with the same name, the first one counts. Other lists
  // are properties in CGAL 6, and nothing before.
  void read(PLY_input& input, std::vector<PLY_column> columns, std::size_t size,
            std::vector<std::vector<std::size_t> >& polygons)
  {
    if (m_is_read)
      throw std::runtime_error("the file has the same elements in two places");
    m_is_read = true;
    const auto polygon_column = std::find_if(columns.begin(), columns.end(), [](const PLY_column& column) {
      return column.list_size && column.numbers.are_integers()
          && (column.name == "vertex_indices" || column.name == "vertex_index");
    });
    for (; m_size < size && !columns.empty(); ++m_size) // the file holds nothing of elements without properties
      for (auto it = columns.begin(); it != columns.end(); ++it) {
        if (!it->list_size)
          input.append_to(it->numbers);
        else if (it == polygon_column)
          polygons.push_back(input.list(*it));
        else if (CGAL::internal::is_with_cgal_6)
          input.append_list_to(*it);
        else
          input.list(*it);
      }
    for (auto it = columns.begin(); it != columns.end(); ++it) {
      std::vector<PLY_column>& kept = it->list_size ? m_lists : m_columns;
      if (it != polygon_column && (!it->list_size || CGAL::internal::is_with_cgal_6) && !has(kept, it->name))
        kept.push_back(std::move(*it));
    }
  }

  std::size_t size() const { return m_size; }
  // The properties that are numbers and were not taken.
  const std::vector<PLY_column>& columns() const { return m_columns; }
  // The properties that are lists.
  const std::vector<PLY_column>& lists() const { return m_lists; }

  bool has(const std::string& name) const { return has(m_columns, name); }

  // Takes columns out of the table, and returns none if there are not all of them.
  std::vector<PLY_column> take(std::initializer_list<const char*> names)
  {
    std::vector<PLY_column> taken;
    if (!std::all_of(names.begin(), names.end(), [this](const char* name) { return has(name); }))
      return taken;
    for (const char* name : names) {
      const auto it = m_columns.begin() + (find(m_columns, name) - m_columns.cbegin());
      taken.push_back(std::move(*it));
      m_columns.erase(it);
    }
    return taken;
  }

  // Whether there are three columns with these names, of bytes or of floats from 0 to 1.
  bool has_colors(std::initializer_list<const char*> names) const
  {
    return have_type<std::uint8_t>(names) || have_type<float>(names);
  }

  // Takes the colors with these names out of the table, which must be there.
  std::vector<Color> take_colors(std::initializer_list<const char*> names)
  {
    const double scale = have_type<std::uint8_t>(names) ? 1. : 255.;
    const std::vector<PLY_column> rgb = take(names);
    const auto byte = [&](int k, std::size_t i) {
      const double value = std::floor(scale * rgb[k].numbers[i]);
      return static_cast<unsigned char>(value >= 0 ? (std::min)(value, 255.) : 0.);
    };
    std::vector<Color> colors;
    for (std::size_t i = 0; i < m_size; ++i)
      colors.emplace_back(byte(0, i), byte(1, i), byte(2, i));
    return colors;
  }

private:
  static std::vector<PLY_column>::const_iterator find(const std::vector<PLY_column>& columns, const std::string& name)
  {
    return std::find_if(columns.begin(), columns.end(),
                        [&](const PLY_column& column) { return column.name == name; });
  }

  static bool has(const std::vector<PLY_column>& columns, const std::string& name)
  {
    return find(columns, name) != columns.end();
  }

  template <class T>
  bool have_type(std::initializer_list<const char*> names) const
  {
    return std::all_of(names.begin(), names.end(), [this](const char* name) {
      return has(name) && find(m_columns, name)->numbers.template have_type<T>();
    });
  }

  std::vector<PLY_column> m_columns, m_lists;
  std::size_t m_size = 0;
  bool m_is_read = false;
};

struct PLY_header
{
  struct Element
  {
    std::string name;
    std::size_t size;
    std::vector<PLY_column> columns;
  };

  // Throws if this fails.
  explicit PLY_header(std::istream& is)
  {
    std::string word, version;
    if (!(next_line(is) >> word) || word != "ply")
      throw std::runtime_error("the file does not start as a PLY file");
    if (!(next_line(is) >> word >> format >> version))
      throw std::runtime_error("the file does not name its format");
    while (word != "end_header") {
      std::istringstream words = next_line(is);
      if (!(words >> word))
        throw std::runtime_error("the header has an empty line");
      if (word == "comment")
        comments += words.str().size() > 8 ? words.str().substr(8) + '\n' : std::string();
      else if (word == "element")
        elements.push_back(element(words));
      else if (word == "property" && elements.empty())
        throw std::runtime_error("the header has a property of no element");
      else if (word == "property")
        elements.back().columns.push_back(column(words));
    }
  }

  std::string comments, format;
  std::vector<Element> elements;

private:
  static std::istringstream next_line(std::istream& is)
  {
    std::string line;
    if (!std::getline(is, line))
      throw std::runtime_error("the header has no end");
    return std::istringstream(line);
  }

  static Element element(std::istringstream& words)
  {
    Element result;
    if (!(words >> result.name >> result.size))
      throw std::runtime_error("the header has an element without a name or a number");
    return result;
  }

  static PLY_column column(std::istringstream& words)
  {
    std::string type, name, size_type;
    words >> type;
    if (type == "list")
      words >> size_type >> type;
    if (!(words >> name))
      throw std::runtime_error("the header has a property without a type or a name");
    PLY_column result{ name, PLY_numbers(type), std::nullopt, {} };
    if (!size_type.empty())
      result.list_size.emplace(size_type);
    if (result.list_size && !result.list_size->are_integers())
      throw std::runtime_error("the length of a list is no integer");
    return result;
  }
};

// Reading throws if it fails.
struct PLY_file
{
  explicit PLY_file(std::istream& is)
  {
    if (!is.good())
      throw std::runtime_error("cannot open file");
    PLY_header header(is);
    comments = header.comments;
    PLY_input input(is, header.format);
    for (PLY_header::Element& element : header.elements) {
      PLY_table ignored_table;
      std::vector<std::vector<std::size_t> > ignored_lists;
      const std::string& name = element.name;
      const bool are_faces = name == "face" || name == "faces";
      PLY_table& table = name == "vertex" || name == "vertices" ? vertices : are_faces ? faces
                       : name == "edge" ? edges : name == "halfedge" ? halfedges : ignored_table;
      table.read(input, std::move(element.columns), element.size, are_faces ? polygons : ignored_lists);
      if (are_faces && polygons.size() != element.size)
        throw std::runtime_error("the faces have no list of vertices");
    }
  }

  std::string comments;
  PLY_table vertices, faces, edges, halfedges;
  std::vector<std::vector<std::size_t> > polygons;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_IO_INTERNAL_PLY_FILE_H
