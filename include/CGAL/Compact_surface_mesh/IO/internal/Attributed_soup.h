// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// A polygon soup with attributes, as a file holds it.

#ifndef CGAL_COMPACT_SURFACE_MESH_IO_INTERNAL_ATTRIBUTED_SOUP_H
#define CGAL_COMPACT_SURFACE_MESH_IO_INTERNAL_ATTRIBUTED_SOUP_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

template <class T>
struct Soup_attribute
{
  bool is_wanted = false;
  std::vector<T> values; // one for each element, or none
};

template <class Point_>
struct Attributed_soup
{
  using Point = Point_;
  using Kernel = typename Kernel_traits<Point>::Kernel;
  using FT = typename Kernel::FT;
  using Normal = typename Kernel::Vector_3;
  using Texture = typename Kernel::Point_2;
  // What readers of CGAL make that take any double: exact types take only finite ones.
  using Read_point = std::conditional_t<std::is_floating_point<FT>::value, Point, Simple_cartesian<double>::Point_3>;

  std::vector<Point> points;
  std::vector<std::vector<std::size_t> > polygons;
  Soup_attribute<Normal> vertex_normals;
  Soup_attribute<Color> vertex_colors;
  Soup_attribute<Texture> vertex_textures;
  Soup_attribute<Color> face_colors;
};

// `value` as an FT. Throws if it is not finite and FT is exact: such types do not take it.
template <class FT>
FT number_of_file(double value)
{
  if constexpr (!std::is_floating_point<FT>::value)
    if (!std::isfinite(value))
      throw std::runtime_error("a number that is not finite cannot be exact");
  return FT(value);
}

// The point or vector with these coordinates.
template <class T>
T object_of_file(double x, double y, double z)
{
  using FT = typename Kernel_traits<T>::Kernel::FT;
  return T(number_of_file<FT>(x), number_of_file<FT>(y), number_of_file<FT>(z));
}

// Makes the points that read(points) reads those of `soup`. Throws as number_of_file() does.
template <class Soup, class Read>
bool read_points(Soup& soup, const Read& read)
{
  if constexpr (std::is_same<typename Soup::Read_point, typename Soup::Point>::value)
    return read(soup.points);
  else {
    std::vector<typename Soup::Read_point> points;
    if (!read(points))
      return false;
    for (const auto& p : points)
      soup.points.push_back(object_of_file<typename Soup::Point>(p.x(), p.y(), p.z()));
    return true;
  }
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_IO_INTERNAL_ATTRIBUTED_SOUP_H
