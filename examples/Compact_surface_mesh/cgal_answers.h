// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef COMPACT_SURFACE_MESH_EXAMPLES_CGAL_ANSWERS_H
#define COMPACT_SURFACE_MESH_EXAMPLES_CGAL_ANSWERS_H

// What algorithms of CGAL and Boost answer on a mesh of any type: this is a program written
// for Surface_mesh.

#include "names_of_cgal_6.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

namespace example {

struct Answer
{
  std::string question;
  double value;
  double seconds;
};

/// returns the mean over all vertices of the cosine between the normal and the direction from
/// `center`.
template <class Kernel, class Mesh>
double mean_cosine_of_normals(const Mesh& mesh, const typename Kernel::Point_3& center)
{
  const auto normal = get(CGAL::dynamic_vertex_property_t<typename Kernel::Vector_3>(), mesh);
  CGAL::Polygon_mesh_processing::compute_vertex_normals(mesh, normal);
  const auto point = get(CGAL::vertex_point, mesh);
  double sum = 0;
  for (const auto v : vertices(mesh)) {
    const typename Kernel::Vector_3 direction = get(point, v) - center;
    const double length = std::sqrt(direction.squared_length());
    if (length > 0)
      sum += get(normal, v) * direction / length;
  }
  return sum / static_cast<double>(num_vertices(mesh));
}

/// returns the mean distance to the mesh from the corners of `box`, enlarged, and from its center.
template <class Kernel, class Mesh>
double mean_distance_to(const Mesh& mesh, const CGAL::Bbox_3& box)
{
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
  CGAL::AABB_tree<AABB_traits_3<Kernel, Primitive> > tree(faces(mesh).begin(), faces(mesh).end(), mesh);
  tree.accelerate_distance_queries();
  double sum = 0;
  for (int i = 0; i < 9; ++i) {
    const auto at = [=](int axis) {
      const double low = box.min(axis), high = box.max(axis), margin = 0.1 * (high - low);
      return i == 8 ? (low + high) / 2 : (i >> axis & 1 ? high + margin : low - margin);
    };
    sum += std::sqrt(tree.squared_distance(typename Kernel::Point_3(at(0), at(1), at(2))));
  }
  return sum / 9;
}

/// returns the largest length of a shortest path along edges from `source`.
template <class Mesh, class Vertex>
double largest_distance_along_edges(const Mesh& mesh, Vertex source)
{
  const auto distance = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
  boost::dijkstra_shortest_paths(mesh, source, boost::distance_map(distance));
  double largest = 0;
  for (const auto v : vertices(mesh))
    largest = (std::max)(largest, get(distance, v));
  return largest;
}

/// asks all questions. Distances along edges are those from `source`.
template <class Kernel, class Mesh, class Vertex>
std::vector<Answer> cgal_answers(const Mesh& mesh, Vertex source)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::vector<Answer> answers;
  const auto ask = [&](const std::string& question, const auto& answer) {
    const auto start = std::chrono::steady_clock::now();
    const double value = answer();
    answers.push_back({ question, value,
                        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() });
  };
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  const typename Kernel::Point_3 center((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2,
                                        (box.zmin() + box.zmax()) / 2);
  ask("area", [&] { return CGAL::to_double(PMP::area(mesh)); });
  ask("volume", [&] { return CGAL::to_double(PMP::volume(mesh)); });
  ask("compute_vertex_normals, mean cosine to center", [&] { return mean_cosine_of_normals<Kernel>(mesh, center); });
  ask("AABB tree, mean distance of 9 points", [&] { return mean_distance_to<Kernel>(mesh, box); });
  ask("Dijkstra, farthest vertex along edges", [&] { return largest_distance_along_edges(mesh, source); });
  return answers;
}

} // namespace example

#endif // COMPACT_SURFACE_MESH_EXAMPLES_CGAL_ANSWERS_H
