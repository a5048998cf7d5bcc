// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef BENCHMARK_COMPACT_SURFACE_MESH_END_TO_END_KERNELS_H
#define BENCHMARK_COMPACT_SURFACE_MESH_END_TO_END_KERNELS_H

// Work that a program calls whole: each is written once, for any FaceListGraph.

#include "../../examples/Compact_surface_mesh/comparison.h"
#include "../../examples/Compact_surface_mesh/names_of_cgal_6.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Random.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/squared_distance_3.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <ostream>
#include <streambuf>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace example {

/// The area.
template <class Mesh>
double area(const Mesh& mesh) { return CGAL::to_double(CGAL::Polygon_mesh_processing::area(mesh)); }

/// Connected components, by an array: returns their number.
template <class Mesh>
class Connected_components
{
public:
  explicit Connected_components(const Mesh& mesh) : m_mesh(mesh), m_component(num_faces(mesh)) {}

  double operator()()
  {
    return static_cast<double>(CGAL::Polygon_mesh_processing::connected_components(
        m_mesh, boost::make_iterator_property_map(m_component.begin(), get(boost::face_index, m_mesh))));
  }

private:
  const Mesh& m_mesh;
  std::vector<std::size_t> m_component;
};

/// CGAL's vertex normals, into an array: returns the sum of squares of a coordinate.
template <class Mesh>
class Vertex_normals
{
public:
  explicit Vertex_normals(const Mesh& mesh) : m_mesh(mesh), m_normal(num_vertices(mesh)) {}

  double operator()()
  {
    CGAL::Polygon_mesh_processing::compute_vertex_normals(
        m_mesh, boost::make_iterator_property_map(m_normal.begin(), get(boost::vertex_index, m_mesh)));
    double sum = 0;
    for (const Vector& normal : m_normal)
      sum += normal.x() * normal.x();
    return sum;
  }

private:
  const Mesh& m_mesh;
  std::vector<Vector> m_normal;
};

template <class Mesh>
using Tree = CGAL::AABB_tree<AABB_traits_3<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh> > >;

/// An AABB tree of the faces: returns their number.
template <class Mesh>
double build_tree(const Mesh& mesh)
{
  Tree<Mesh> tree(faces(mesh).begin(), faces(mesh).end(), mesh);
  tree.build();
  return static_cast<double>(tree.size());
}

/// returns whether triangles are so long and thin that their boxes overlap everywhere, and a tree is of
/// no use: those of a drawn random triangulation are.
inline bool has_crowded_boxes(const Triangle_soup& soup)
{
  double area = 0, squares = 0;
  for (const Triangle& t : soup.triangles) {
    const Point &p = soup.points[t[0]], &q = soup.points[t[1]], &r = soup.points[t[2]];
    area += std::sqrt(CGAL::squared_area(p, q, r));
    squares += (std::max)({ CGAL::squared_distance(p, q), CGAL::squared_distance(q, r), CGAL::squared_distance(r, p) });
  }
  return squares > 100 * area;
}

/// 10,000 random points in the box of the mesh: returns the sum of their distances to it.
template <class Mesh>
class Distance_queries
{
public:
  explicit Distance_queries(const Mesh& mesh) : m_tree(faces(mesh).begin(), faces(mesh).end(), mesh), m_points(10000)
  {
    m_tree.accelerate_distance_queries();
    const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
    CGAL::Random random(1);
    for (Point& p : m_points) {
      const double x = random.get_double(box.xmin(), box.xmax()), y = random.get_double(box.ymin(), box.ymax());
      p = Point(x, y, random.get_double(box.zmin(), box.zmax()));
    }
    (*this)(); // the tree puts off some of its work
  }

  double operator()() const
  {
    double sum = 0;
    for (const Point& p : m_points)
      sum += std::sqrt(m_tree.squared_distance(p));
    return sum;
  }

private:
  Tree<Mesh> m_tree;
  std::vector<Point> m_points;
};

/// A stream buffer that counts lines and forgets them.
class Line_counter : public std::streambuf
{
public:
  std::size_t num_lines() const { return m_num_lines; }

protected:
  int overflow(int c) override
  {
    m_num_lines += c == '\n' ? 1 : 0;
    return c == traits_type::eof() ? 0 : c;
  }

  std::streamsize xsputn(const char* s, std::streamsize n) override
  {
    m_num_lines += static_cast<std::size_t>(std::count(s, s + n, '\n'));
    return n;
  }

private:
  std::size_t m_num_lines = 0;
};

/// An OFF file in text that nobody keeps: returns its number of lines, but those of the heading.
template <class Mesh>
double write_off(const Mesh& mesh)
{
  Line_counter lines;
  std::ostream out(&lines);
  CGAL::IO::write_OFF(out, mesh);
  return static_cast<double>(lines.num_lines());
}

template <class Mesh>
double copy(const Mesh& mesh)
{
  const Mesh other(mesh);
  return static_cast<double>(num_vertices(other));
}

/// builds a mesh from a graph by `copy_face_graph()`, or by its constructor if it is compact.
template <class Mesh>
double construct_from_graph(Type<Mesh>, const Surface_mesh& graph)
{
  Mesh mesh;
  CGAL::copy_face_graph(graph, mesh);
  return static_cast<double>(num_vertices(mesh));
}

template <class Layout>
double construct_from_graph(Type<CGAL::Compact_surface_mesh<Point, Layout> >, const Surface_mesh& graph)
{
  return static_cast<double>(num_vertices(CGAL::Compact_surface_mesh<Point, Layout>(graph)));
}

/// lists all such work.
struct End_to_end
{
  template <class Structure, class Labeled>
  std::vector<Timed_kernel> operator()(Type<Structure>, const std::shared_ptr<const Labeled>& labeled,
                                       const Triangle_soup& soup) const
  {
    using Mesh = typename Structure::Mesh;
    std::vector<Timed_kernel> kernels;
    const auto add = [&](const std::string& name, const auto& f) {
      kernels.push_back({ name, "call", false, [=]() -> Timed_function { return [=] { return f(labeled->mesh); }; } });
    };
    const auto add_object = [&](const std::string& name, auto type, double tolerance) {
      kernels.push_back({ name, "call", false, [=]() -> Timed_function {
                           const auto object = std::make_shared<typename decltype(type)::type>(labeled->mesh);
                           return [=] { return (*object)(); };
                         },
                         tolerance });
    };
    add("area", [](const Mesh& mesh) { return area(mesh); });
    add_object("connected_components", Type<Connected_components<Mesh> >(), 0.);
    add_object("compute_vertex_normals", Type<Vertex_normals<Mesh> >(), 1e-4); // depends on where it starts
    add("AABB tree", [](const Mesh& mesh) { return build_tree(mesh); });
    if (!has_crowded_boxes(soup))
      add_object("10,000 distances by AABB tree", Type<Distance_queries<Mesh> >(), 1e-9);
    add("write OFF", [](const Mesh& mesh) { return write_off(mesh); });
    add("copy", [](const Mesh& mesh) { return copy(mesh); });
    kernels.push_back(construction_from_soup<Structure>(soup));
    kernels.push_back({ "construction from a Surface_mesh", "call", false, [&soup]() -> Timed_function {
                         const auto graph = std::make_shared<Surface_mesh>(surface_mesh_of(soup));
                         return [graph] { return construct_from_graph(Type<Mesh>(), *graph); };
                       } });
    return kernels;
  }
};

} // namespace example

#endif // BENCHMARK_COMPACT_SURFACE_MESH_END_TO_END_KERNELS_H
