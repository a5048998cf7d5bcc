// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The overload by which all forms of CGAL's convex_hull_3() take the mesh: each of them ends in it. The header of that
// function need not be included here.

#ifndef CGAL_COMPACT_SURFACE_MESH_CONVEX_HULL_3_H
#define CGAL_COMPACT_SURFACE_MESH_CONVEX_HULL_3_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Compact_surface_mesh.h>
#include <CGAL/Compact_surface_mesh/internal/Input_report.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/use.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <list>
#include <type_traits>
#include <vector>

namespace CGAL {

namespace internal {

// The triangles of a hull: what the algorithm fills in place of a mesh of type `Mesh`. All of its functions are
// found by their argument.
template <class Mesh>
struct Hull_soup
{
  using Point = typename Mesh::Point;

  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3> > triangles;
};

} // namespace internal

} // namespace CGAL

namespace boost {

// CGAL's generators look up halfedges of what they are given, even where they are not chosen: there are none.
template <class Mesh>
struct graph_traits<CGAL::internal::Hull_soup<Mesh> >
{};

} // namespace boost

namespace CGAL {

namespace internal {

template <class Mesh>
struct Hull_point_map
{
  std::vector<typename Mesh::Point>* points;
};

template <class Mesh>
Hull_point_map<Mesh> get(vertex_point_t, Hull_soup<Mesh>& soup) { return { &soup.points }; }

template <class Mesh, class Point>
void put(const Hull_point_map<Mesh>& map, std::size_t v, const Point& p)
{
  CGAL_assertion(v == map.points->size());
  CGAL_USE(v);
  map.points->push_back(converted_point<typename Mesh::Point>(p));
}

// Its point is put next.
template <class Mesh>
std::size_t add_vertex(Hull_soup<Mesh>& soup) { return soup.points.size(); }

template <class Mesh>
void clear(Hull_soup<Mesh>& soup) { soup = Hull_soup<Mesh>(); }

template <class Mesh, class Points>
void take_points(Hull_soup<Mesh>& soup, const Points& points)
{
  for (const auto& p : points)
    soup.points.push_back(converted_point<typename Mesh::Point>(p));
}

// The polygon of points in one plane, cut into triangles.
template <class Point, class Mesh>
void copy_ch2_to_face_graph(const std::list<Point>& polygon, Hull_soup<Mesh>& soup)
{
  take_points(soup, polygon);
  for (std::size_t i = 2; i < soup.points.size(); ++i)
    soup.triangles.push_back({ { 0, i - 1, i } });
}

// The hull, as a triangulation data structure.
template <class Triangulation, class Mesh>
void copy_face_graph(const Triangulation& hull, Hull_soup<Mesh>& soup)
{
  std::size_t n = 0;
  for (auto v = hull.vertices_begin(); v != hull.vertices_end(); ++v) {
    soup.points.push_back(converted_point<typename Mesh::Point>(v->point()));
    v->info() = static_cast<std::decay_t<decltype(v->info())> >(n++);
  }
  for (auto f = hull.faces_begin(); f != hull.faces_end(); ++f) {
    std::array<std::size_t, 3> triangle;
    for (int i = 0; i < 3; ++i)
      triangle[i] = static_cast<std::size_t>(f->vertex(i)->info());
    soup.triangles.push_back(triangle);
  }
}

// Four points, of which the last sees the first three clockwise.
template <class Point, class Mesh>
void make_tetrahedron(const Point& p, const Point& q, const Point& r, const Point& s, Hull_soup<Mesh>& soup)
{
  take_points(soup, std::array<Point, 4>{ { p, q, r, s } });
  soup.triangles = { { { 0, 2, 1 } }, { { 0, 1, 3 } }, { { 1, 2, 3 } }, { { 2, 0, 3 } } };
}

} // namespace internal

/*!
\ingroup PkgCompactSurfaceMeshRef

makes `mesh` the convex hull of points, as the function of the package 3D Convex Hulls does for meshes that can be
edited. What `mesh` was before is lost, property maps included, unless there are no points. The forms of that function
without `traits`, and of the points of a graph, take `Compact_surface_mesh` as well. All of them need the header
`CGAL/convex_hull_3.h`.

\tparam InputIterator an input iterator over points
\tparam Traits a model of `ConvexHullTraits_3`

\param first,beyond the points
\param mesh the mesh; it stays as it was if something is thrown
\param traits the geometric traits
*/
template <class InputIterator,
#ifndef DOXYGEN_RUNNING // in the place of a parameter of CGAL's function, in case that a caller names it
          class = void,
#endif
          class Traits, class P, class L>
void convex_hull_3(InputIterator first, InputIterator beyond, Compact_surface_mesh<P, L>& mesh, const Traits& traits)
{
  using Mesh = Compact_surface_mesh<P, L>;
  if (first == beyond)
    return;
  internal::Hull_soup<Mesh> soup;
  convex_hull_3(first, beyond, soup, traits);
  mesh = Mesh(soup.points, soup.triangles);
}

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_CONVEX_HULL_3_H
