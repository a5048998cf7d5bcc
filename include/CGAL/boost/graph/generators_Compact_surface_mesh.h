// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// CGAL's generators of small meshes, for a mesh that can be filled but not edited: the same vertices and faces in the
// same order, but for the faces of the icosahedron and of a triangulated hexahedron, and the same halfedge as answer.
// All need an empty mesh. They have the template parameters of CGAL's functions in front, as callers name them where the
// type of the points cannot be deduced. Those that take nothing but points of a kernel are there for classes that derive
// from the mesh, too: for such points they are more specialized than CGAL's.

#ifndef CGAL_BOOST_GRAPH_GENERATORS_COMPACT_SURFACE_MESH_H
#define CGAL_BOOST_GRAPH_GENERATORS_COMPACT_SURFACE_MESH_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Compact_surface_mesh.h>
#include <CGAL/Compact_surface_mesh/internal/Mesh_filling.h>
#include <CGAL/Compact_surface_mesh/internal/versions_of_cgal.h>
#include <CGAL/boost/graph/properties_Compact_surface_mesh.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

namespace internal {

template <std::size_t size>
using Faces_of_size = std::vector<std::array<std::size_t, size> >;

// Makes the empty mesh `g` that of a soup and returns the halfedge from vertex `u` of the soup to `v`, null if they
// are not adjacent.
template <class P, class L, class Points, class Faces>
typename Compact_surface_mesh<P, L>::Halfedge_index
fill_with_soup(Compact_surface_mesh<P, L>& g, const Points& points, const Faces& faces, std::size_t u, std::size_t v)
{
  using Mesh = Compact_surface_mesh<P, L>;
  std::vector<typename Mesh::Vertex_index> vertices(points.size());
  Mesh_filling<Mesh> filling(g);
  filling.take_soup(points, faces, parameters::vertex_to_vertex_map(make_property_map(vertices)));
  filling.finish();
  const std::size_t n = vertices.size();
  return u < n && v < n ? g.halfedge(vertices[u], vertices[v]) : Mesh::null_halfedge();
}

template <class P, class L>
Compact_surface_mesh<P, L>& base_mesh(Compact_surface_mesh<P, L>& g)
{
  return g;
}

template <class Derived>
using Base_mesh = std::remove_reference_t<decltype(base_mesh(std::declval<Derived&>()))>;

// The answer of a generator for a class that derives from the mesh; nothing for others.
template <class Derived>
using Halfedge_of_derived =
  std::enable_if_t<!std::is_same<Derived, Base_mesh<Derived> >::value, typename Base_mesh<Derived>::Halfedge_index>;

// The i-th of n points of a horizontal circle, clockwise as seen from above, from that with the largest x on.
template <class Point, class FT>
Point point_of_circle(std::size_t i, std::size_t n, const Point& center, const FT& radius, const FT& height)
{
  const double angle = 2 * CGAL_PI * static_cast<double>(i) / static_cast<double>(n);
  return Point(center.x() + radius * FT(std::cos(angle)), center.y() + height,
               center.z() - radius * FT(std::sin(angle)));
}

} // namespace internal

/*!
\ingroup PkgCompactSurfaceMeshRef
makes the empty mesh `g` a triangle.
\returns its halfedge that is not on the border and has the target `p0`
\throws std::runtime_error if `g` is not empty
*/
template <class = void, class Point, class P, class L>
typename Compact_surface_mesh<P, L>::Halfedge_index
make_triangle(const Point& p0, const Point& p1, const Point& p2, Compact_surface_mesh<P, L>& g)
{
  return internal::fill_with_soup(g, std::array<Point, 3>{ { p0, p1, p2 } },
                                  internal::Faces_of_size<3>{ { { 0, 1, 2 } } }, 2, 0);
}

#ifndef DOXYGEN_RUNNING
template <class Derived, template <class> class Kernel_point, class K>
internal::Halfedge_of_derived<Derived>
make_triangle(const Kernel_point<K>& p0, const Kernel_point<K>& p1, const Kernel_point<K>& p2, Derived& g)
{
  return make_triangle(p0, p1, p2, internal::base_mesh(g));
}
#endif

/*!
\ingroup PkgCompactSurfaceMeshRef
makes the empty mesh `g` a face with four sides.
\returns its halfedge that is not on the border and has the target `p0`
\throws std::runtime_error if `g` is not empty
*/
template <class = void, class Point, class P, class L>
typename Compact_surface_mesh<P, L>::Halfedge_index
make_quad(const Point& p0, const Point& p1, const Point& p2, const Point& p3, Compact_surface_mesh<P, L>& g)
{
  return internal::fill_with_soup(g, std::array<Point, 4>{ { p0, p1, p2, p3 } },
                                  internal::Faces_of_size<4>{ { { 0, 1, 2, 3 } } }, 3, 0);
}

#ifndef DOXYGEN_RUNNING
template <class Derived, template <class> class Kernel_point, class K>
internal::Halfedge_of_derived<Derived>
make_quad(const Kernel_point<K>& p0, const Kernel_point<K>& p1, const Kernel_point<K>& p2,
          const Kernel_point<K>& p3, Derived& g)
{
  return make_quad(p0, p1, p2, p3, internal::base_mesh(g));
}
#endif

/*!
\ingroup PkgCompactSurfaceMeshRef
makes the empty mesh `g` a hexahedron with the base `p0`, `p1`, `p2`, `p3`, above which lie `p5`, `p6`, `p7`, `p4`.
\param p0,p1,p2,p3,p4,p5,p6,p7 the points of the vertices
\param g the mesh
\param np a sequence of \ref bgl_namedparameters "Named Parameters", of use from \cgal 6 on:
  `do_not_triangulate_faces`, whose default is `true`; if it is `false`, each face is cut into two triangles
\returns the halfedge of the base from `p0` to `p3`, or that from `p3` to `p2` if faces are cut
\throws std::runtime_error if `g` is not empty
*/
template <class = void, class Point, class NamedParameters = parameters::Default_named_parameters, class P, class L>
typename Compact_surface_mesh<P, L>::Halfedge_index
make_hexahedron(const Point& p0, const Point& p1, const Point& p2, const Point& p3, const Point& p4, const Point& p5,
                const Point& p6, const Point& p7, Compact_surface_mesh<P, L>& g,
                const NamedParameters& np = parameters::default_values())
{
  const std::size_t above[] = { 5, 6, 7, 4 };
  internal::Faces_of_size<4> faces = { { { 4, 5, 6, 7 } }, { { 3, 2, 1, 0 } } };
  for (const std::size_t i : { 1, 0, 3, 2 }) {
    const std::size_t j = (i + 1) % 4;
    faces.push_back({ { j, above[j], above[i], i } });
  }
  const std::array<Point, 8> points{ { p0, p1, p2, p3, p4, p5, p6, p7 } };
  if (parameters::choose_parameter(parameters::get_parameter(np, internal::Do_not_triangulate_faces()), true))
    return internal::fill_with_soup(g, points, faces, 0, 3);
  internal::Faces_of_size<3> triangles;
  for (const auto& f : faces) {
    triangles.push_back({ { f[0], f[1], f[2] } });
    triangles.push_back({ { f[0], f[2], f[3] } });
  }
  return internal::fill_with_soup(g, points, triangles, 3, 2);
}

/*!
\ingroup PkgCompactSurfaceMeshRef
makes the empty mesh `g` the hexahedron `cuboid`.
\param cuboid an `Iso_cuboid_3` of any kernel
\param g the mesh
\param np as for the function above, and `geom_traits`: a model of `Kernel` that constructs the vertices of `cuboid`
\returns as the function above
\throws std::runtime_error if `g` is not empty
*/
template <class IsoCuboid, class = void, class NamedParameters = parameters::Default_named_parameters, class P, class L>
typename Compact_surface_mesh<P, L>::Halfedge_index
make_hexahedron(const IsoCuboid& cuboid, Compact_surface_mesh<P, L>& g,
                const NamedParameters& np = parameters::default_values())
{
  using Traits = typename GetGeomTraits<Compact_surface_mesh<P, L>, NamedParameters>::type;
  const Traits traits = parameters::choose_parameter<Traits>(
    parameters::get_parameter(np, internal_np::geom_traits));
  const auto vertex = traits.construct_vertex_3_object();
  return make_hexahedron(vertex(cuboid, 0), vertex(cuboid, 1), vertex(cuboid, 2), vertex(cuboid, 3),
                         vertex(cuboid, 4), vertex(cuboid, 5), vertex(cuboid, 6), vertex(cuboid, 7), g, np);
}

#ifndef DOXYGEN_RUNNING
template <class Derived, template <class> class Kernel_point, class K>
internal::Halfedge_of_derived<Derived>
make_hexahedron(const Kernel_point<K>& p0, const Kernel_point<K>& p1, const Kernel_point<K>& p2,
                const Kernel_point<K>& p3, const Kernel_point<K>& p4, const Kernel_point<K>& p5,
                const Kernel_point<K>& p6, const Kernel_point<K>& p7, Derived& g)
{
  return make_hexahedron(p0, p1, p2, p3, p4, p5, p6, p7, internal::base_mesh(g));
}
#endif

/*!
\ingroup PkgCompactSurfaceMeshRef
makes the empty mesh `g` a tetrahedron, which is oriented outward if `p3` lies on the positive side of the plane through
`p0`, `p1` and `p2`.
\returns the halfedge from `p1` to `p0` in their face with `p2`
\throws std::runtime_error if `g` is not empty
*/
template <class = void, class Point, class P, class L>
typename Compact_surface_mesh<P, L>::Halfedge_index
make_tetrahedron(const Point& p0, const Point& p1, const Point& p2, const Point& p3, Compact_surface_mesh<P, L>& g)
{
  const internal::Faces_of_size<3> faces = { { { 2, 1, 0 } }, { { 0, 3, 2 } }, { { 2, 3, 1 } }, { { 1, 3, 0 } } };
  return internal::fill_with_soup(g, std::array<Point, 4>{ { p0, p1, p2, p3 } }, faces, 1, 0);
}

#ifndef DOXYGEN_RUNNING
template <class Derived, template <class> class Kernel_point, class K>
internal::Halfedge_of_derived<Derived>
make_tetrahedron(const Kernel_point<K>& p0, const Kernel_point<K>& p1, const Kernel_point<K>& p2,
                 const Kernel_point<K>& p3, Derived& g)
{
  return make_tetrahedron(p0, p1, p2, p3, internal::base_mesh(g));
}
#endif

/*!
\ingroup PkgCompactSurfaceMeshRef
makes the empty mesh `g` a prism of triangles, oriented outward, whose axis is parallel to the y-axis.
\param nb_vertices the number of vertices of a base, at least three
\param g the mesh
\param base_center the center of the lower base
\param height the distance of the bases
\param radius the radius of the circles through the vertices of the bases
\param is_closed whether to make the bases, as fans around their centers
\returns the halfedge from the first vertex of the upper base to the second one
\throws std::runtime_error if `g` is not empty
*/
template <class = void, class Point, class P, class L>
typename Compact_surface_mesh<P, L>::Halfedge_index
make_regular_prism(typename Compact_surface_mesh<P, L>::size_type nb_vertices, Compact_surface_mesh<P, L>& g,
                   const Point& base_center = Point(0, 0, 0),
                   typename Kernel_traits<Point>::Kernel::FT height = 1.0,
                   typename Kernel_traits<Point>::Kernel::FT radius = 1.0, bool is_closed = true)
{
  CGAL_precondition(nb_vertices >= 3);
  using FT = typename Kernel_traits<Point>::Kernel::FT;
  const std::size_t n = nb_vertices, top = 2 * n, bottom = 2 * n + 1;
  std::vector<Point> points;
  for (const FT& y : { height, FT(0) })
    for (std::size_t i = 0; i < n; ++i)
      points.push_back(internal::point_of_circle(i, n, base_center, radius, y));
  internal::Faces_of_size<3> faces;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    faces.push_back({ { i, n + j, j } });
    faces.push_back({ { i, n + i, n + j } });
  }
  if (is_closed) {
    points.emplace_back(base_center.x(), base_center.y() + height, base_center.z());
    points.push_back(base_center);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      faces.push_back({ { top, i, j } });
      faces.push_back({ { bottom, n + j, n + i } });
    }
  }
  return internal::fill_with_soup(g, points, faces, 0, 1);
}

/*!
\ingroup PkgCompactSurfaceMeshRef
makes the empty mesh `g` a pyramid of triangles, oriented outward, whose axis is parallel to the y-axis.
\param nb_vertices the number of vertices of the base, at least three
\param g the mesh
\param base_center the center of the base
\param height the distance of the apex from the base
\param radius the radius of the circle through the vertices of the base
\param is_closed whether to make the base, as a fan around its center
\returns the halfedge from the first vertex of the base to the apex
\throws std::runtime_error if `g` is not empty
*/
template <class = void, class Point, class P, class L>
typename Compact_surface_mesh<P, L>::Halfedge_index
make_pyramid(typename Compact_surface_mesh<P, L>::size_type nb_vertices, Compact_surface_mesh<P, L>& g,
             const Point& base_center = Point(0, 0, 0),
             typename Kernel_traits<Point>::Kernel::FT height = 1.0,
             typename Kernel_traits<Point>::Kernel::FT radius = 1.0, bool is_closed = true)
{
  CGAL_precondition(nb_vertices >= 3);
  using FT = typename Kernel_traits<Point>::Kernel::FT;
  const std::size_t n = nb_vertices, apex = n, bottom = n + 1;
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i)
    points.push_back(internal::point_of_circle(i, n, base_center, radius, FT(0)));
  points.emplace_back(base_center.x(), base_center.y() + height, base_center.z());
  internal::Faces_of_size<3> faces;
  for (std::size_t i = 0; i < n; ++i)
    faces.push_back({ { i, (i + 1) % n, apex } });
  if (is_closed) {
    points.push_back(base_center);
    for (std::size_t i = 0; i < n; ++i)
      faces.push_back({ { (i + 1) % n, i, bottom } });
  }
  return internal::fill_with_soup(g, points, faces, 0, apex);
}

/*!
\ingroup PkgCompactSurfaceMeshRef
makes the empty mesh `g` an icosahedron, oriented outward.
\param g the mesh
\param center its center
\param radius the distance of its vertices from the center
\returns null, as the function for other meshes does: it asks for a halfedge between vertices that are not adjacent
\throws std::runtime_error if `g` is not empty
*/
template <class = void, class Point, class P, class L>
typename Compact_surface_mesh<P, L>::Halfedge_index
make_icosahedron(Compact_surface_mesh<P, L>& g, const Point& center = Point(0, 0, 0),
                 typename Kernel_traits<Point>::Kernel::FT radius = 1.0)
{
  using FT = typename Kernel_traits<Point>::Kernel::FT;
  // the corners of three rectangles whose sides have the golden ratio, each in a plane of coordinates
  const FT golden = (FT(1) + approximate_sqrt(FT(5))) / FT(2);
  const FT a = radius / approximate_sqrt(FT(1) + golden * golden), b = a * golden;
  std::vector<Point> points;
  const auto add = [&](const FT& x, const FT& y, const FT& z) {
    points.emplace_back(center.x() + x, center.y() + y, center.z() + z);
  };
  for (const FT& y : { a, FT(-a) })
    for (const FT& z : { b, FT(-b) })
      add(FT(0), y, z);
  for (const FT& x : { a, FT(-a) })
    for (const FT& y : { b, FT(-b) })
      add(x, y, FT(0));
  for (const FT& x : { b, FT(-b) })
    for (const FT& z : { a, FT(-a) })
      add(x, FT(0), z);
  // the five faces around vertex 0, the five around its antipode 3, and ten between them
  const std::size_t upper[] = { 2, 8, 4, 6, 10 }, lower[] = { 7, 5, 9, 1, 11 };
  internal::Faces_of_size<3> faces;
  for (std::size_t i = 0; i < 5; ++i) {
    const std::size_t j = (i + 1) % 5;
    faces.push_back({ { 0, upper[i], upper[j] } });
    faces.push_back({ { 3, lower[j], lower[i] } });
    faces.push_back({ { upper[i], lower[j], upper[j] } });
    faces.push_back({ { upper[i], lower[i], lower[j] } });
  }
  return internal::fill_with_soup(g, points, faces, 5, 0);
}

/*!
\ingroup PkgCompactSurfaceMeshRef
makes the empty mesh `g` a grid of `i` times `j` cells.
\param i the number of cells along the first coordinate
\param j the number of cells along the second coordinate
\param g the mesh
\param calculator a functor: `calculator(a, b)` returns the point of the vertex with the coordinates `a` and `b`
\param triangulated whether to cut each cell into two triangles
\returns the halfedge from the second vertex to the first one, which is on the border
\throws std::runtime_error if `g` is not empty
*/
template <class = void, class CoordinateFunctor, class P, class L>
typename Compact_surface_mesh<P, L>::Halfedge_index
make_grid(typename Compact_surface_mesh<P, L>::size_type i, typename Compact_surface_mesh<P, L>::size_type j,
          Compact_surface_mesh<P, L>& g, const CoordinateFunctor& calculator, bool triangulated = false)
{
  using Size = typename Compact_surface_mesh<P, L>::size_type;
  const std::size_t width = std::size_t(i) + 1;
  std::vector<P> points;
  for (Size b = 0; b <= j; ++b)
    for (Size a = 0; a <= i; ++a)
      points.push_back(internal::converted_point<P>(calculator(a, b)));
  internal::Faces_of_size<3> triangles;
  internal::Faces_of_size<4> squares;
  for (Size a = 0; a < i; ++a)
    for (Size b = 0; b < j; ++b) {
      const std::size_t v = b * width + a, above = v + width;
      if (triangulated) {
        triangles.push_back({ { v, v + 1, above } });
        triangles.push_back({ { v + 1, above + 1, above } });
      } else
        squares.push_back({ { v, v + 1, above + 1, above } });
    }
  return triangulated ? internal::fill_with_soup(g, points, triangles, 1, 0)
                      : internal::fill_with_soup(g, points, squares, 1, 0);
}

/*!
\ingroup PkgCompactSurfaceMeshRef
makes the empty mesh `g` a grid of `i` times `j` unit squares in the plane `z = 0`, as the function above does.
*/
template <class = void, class P, class L>
typename Compact_surface_mesh<P, L>::Halfedge_index
make_grid(typename Compact_surface_mesh<P, L>::size_type i, typename Compact_surface_mesh<P, L>::size_type j,
          Compact_surface_mesh<P, L>& g, bool triangulated = false)
{
  using Size = typename Compact_surface_mesh<P, L>::size_type;
  return make_grid(i, j, g, [](Size a, Size b) { return P(a, b, 0); }, triangulated);
}

} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_GENERATORS_COMPACT_SURFACE_MESH_H
