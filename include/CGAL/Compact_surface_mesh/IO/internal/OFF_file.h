// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The data of an OFF file. CGAL's scanner reads beyond the numbers of a line that has fewer than it expects.

#ifndef CGAL_COMPACT_SURFACE_MESH_IO_INTERNAL_OFF_FILE_H
#define CGAL_COMPACT_SURFACE_MESH_IO_INTERNAL_OFF_FILE_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/IO/internal/Attributed_soup.h>

#include <CGAL/IO/Color.h>
#include <CGAL/IO/OFF/File_header_OFF.h>
#include <CGAL/IO/OFF/File_scanner_OFF.h>
#include <CGAL/IO/binary_file_io.h>
#include <CGAL/IO/io.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// Whatever does not succeed throws.
class OFF_file
{
  using Numbers = std::vector<double>;

public:
  // Reads the header.
  explicit OFF_file(std::istream& is)
    : m_is(is)
  {
    if (!is.good())
      throw std::runtime_error("cannot open file");
    is >> m_header;
    if (is.fail())
      throw std::runtime_error("the header is not that of an OFF file");
    if (m_header.n_dimensional() && m_header.dimension() != 3)
      throw std::runtime_error("the points do not have three dimensions");
  }

  const File_header_OFF& header() const { return m_header; }

  // Reads all that follows. Where some elements have colors, the others are black.
  template <class Soup>
  void read(Soup& soup)
  {
    for (std::size_t i = 0; i < m_header.size_of_vertices(); ++i)
      add_vertex(numbers_of_vertex(), soup);
    for (std::size_t i = 0; i < m_header.size_of_facets(); ++i)
      add_face(m_header.binary() ? numbers_of_binary_face() : numbers_of_line(), soup);
  }

private:
  std::size_t point_size() const { return m_header.is_homogeneous() ? 4 : 3; }
  std::size_t normal_size() const { return m_header.has_normals() ? point_size() : 0; }
  std::size_t texture_size() const { return m_header.has_textures() ? point_size() - 1 : 0; }

  // The numbers of the next line that is not empty, without its comment.
  Numbers numbers_of_line()
  {
    std::string line;
    do {
      if (!std::getline(m_is, line))
        throw std::runtime_error("the file ends too early");
      line.erase((std::min)(line.find('#'), line.size()));
    } while (line.find_first_not_of(" \t\r\f\v") == std::string::npos);
    m_words.clear();
    m_words.str(line);
    Numbers numbers;
    for (double number; m_words >> iformat(number);)
      numbers.push_back(number);
    return numbers;
  }

  Numbers numbers_of_vertex()
  {
    if (!m_header.binary())
      return numbers_of_line();
    Numbers numbers;
    add_floats(point_size() + normal_size() + (m_header.has_colors() ? 4 : 0) + texture_size(), numbers);
    return numbers;
  }

  Numbers numbers_of_binary_face()
  {
    const std::int32_t size = binary_integer();
    Numbers numbers{ static_cast<double>(size) };
    for (std::int32_t i = 0; i < size; ++i)
      numbers.push_back(binary_integer());
    const std::int32_t color_size = binary_integer();
    if (color_size < 0 || color_size > 4)
      throw std::runtime_error("a color has too many numbers");
    add_floats(static_cast<std::size_t>(color_size), numbers);
    return numbers;
  }

  std::int32_t binary_integer()
  {
    std::int32_t i = 0;
    I_Binary_read_big_endian_integer32(m_is, i);
    if (m_is.fail())
      throw std::runtime_error("the file ends too early");
    return i;
  }

  void add_floats(std::size_t n, Numbers& numbers)
  {
    for (; n != 0; --n) {
      float f = 0;
      I_Binary_read_big_endian_float32(m_is, f);
      if (m_is.fail())
        throw std::runtime_error("the file ends too early");
      numbers.push_back(f);
    }
  }

  // `numbers` are point, normal, color and texture coordinates, without those that the header does not announce.
  template <class Soup>
  void add_vertex(const Numbers& numbers, Soup& soup) const
  {
    const std::size_t color_begin = point_size() + normal_size();
    if (numbers.size() < color_begin + texture_size())
      throw std::runtime_error("a vertex has too few numbers");
    const std::size_t color_size = m_header.has_colors() ? numbers.size() - color_begin - texture_size() : 0;
    const auto last_if_homogeneous = [&](const double* first, std::size_t n) {
      return m_header.is_homogeneous() ? first[n - 1] : 1.;
    };
    const double* p = numbers.data();
    const double w = last_if_homogeneous(p, point_size());
    if (w == 0)
      throw std::runtime_error("a point lies at infinity");
    add_color(p + color_begin, color_size, soup.points.size(), soup.vertex_colors);
    soup.points.push_back(object_of_file<typename Soup::Point>(p[0] / w, p[1] / w, p[2] / w));
    if (m_header.has_normals() && soup.vertex_normals.is_wanted) {
      const double* n = p + point_size();
      const double v = last_if_homogeneous(n, normal_size());
      soup.vertex_normals.values.push_back(object_of_file<typename Soup::Normal>(n[0] / v, n[1] / v, n[2] / v));
    }
    if (m_header.has_textures() && soup.vertex_textures.is_wanted) {
      const double* t = p + color_begin + color_size;
      const double v = last_if_homogeneous(t, texture_size());
      using FT = typename Soup::FT;
      soup.vertex_textures.values.emplace_back(number_of_file<FT>(t[0] / v), number_of_file<FT>(t[1] / v));
    }
  }

  // `numbers` are the number of vertices, the vertices and a color, perhaps of no numbers.
  template <class Soup>
  void add_face(const Numbers& numbers, Soup& soup) const
  {
    if (numbers.empty() || !(numbers[0] >= 0 && numbers[0] < static_cast<double>(numbers.size())))
      throw std::runtime_error("a face does not have as many vertices as it should");
    const std::size_t size = static_cast<std::size_t>(numbers[0]);
    std::vector<std::size_t> polygon;
    for (std::size_t i = 1; i <= size; ++i) {
      if (!(numbers[i] >= 0 && numbers[i] < static_cast<double>(soup.points.size())))
        throw std::runtime_error("a face names a vertex that does not exist");
      polygon.push_back(static_cast<std::size_t>(numbers[i]));
    }
    if (m_header.has_colors())
      add_color(numbers.data() + size + 1, numbers.size() - size - 1, soup.polygons.size(), soup.face_colors);
    soup.polygons.push_back(std::move(polygon));
  }

  // Sets the color of the `i`-th element.
  void add_color(const double* first, std::size_t size, std::size_t i, Soup_attribute<Color>& colors) const
  {
    if (!colors.is_wanted || (size == 0 && colors.values.empty()))
      return;
    colors.values.resize(i, Color(0, 0, 0));
    colors.values.push_back(size == 0 ? Color(0, 0, 0) : color_of_numbers(first, size));
  }

  // An index in CGAL's table, or red, green and blue: bytes if these are integers, else from 0 to 1.
  Color color_of_numbers(const double* first, std::size_t size) const
  {
    if (size == 2)
      throw std::runtime_error("a color has two numbers");
    if (size == 1) {
      if (!(first[0] >= 0))
        throw std::runtime_error("a color has a negative index");
      const Color color = File_scanner_OFF::get_indexed_color(static_cast<int>((std::min)(first[0], 255.)));
      return Color(color.red(), color.green(), color.blue());
    }
    const bool are_bytes = !m_header.binary()
                           && std::all_of(first, first + 3, [](double c) { return std::floor(c) == c; });
    const auto byte = [&](int k) {
      const double value = are_bytes ? first[k] : 255 * first[k];
      if (!(value >= 0 && value < 256))
        throw std::runtime_error("a color is out of range");
      return static_cast<unsigned char>(value);
    };
    return Color(byte(0), byte(1), byte(2));
  }

  std::istream& m_is;
  File_header_OFF m_header;
  std::istringstream m_words; // of a line; to make one for each takes long
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_IO_INTERNAL_OFF_FILE_H
