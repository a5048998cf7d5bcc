// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef BENCHMARK_COMPACT_SURFACE_MESH_OPERATOR_KERNELS_H
#define BENCHMARK_COMPACT_SURFACE_MESH_OPERATOR_KERNELS_H

// Single operators, called for all elements in the order in which they are stored, or for pairs
// of vertices in random order. Calls are independent, or each waits for the result before it.
// And a chain of them: a walk over the surface.

#include "../../examples/Compact_surface_mesh/compared_meshes.h"
#include "../../examples/Compact_surface_mesh/mesh_kernels.h"

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace example {

/// returns a number that is known when the descriptor is: its index, or its address where it is a handle.
template <class Descriptor>
auto bits(Descriptor d) -> decltype(static_cast<std::size_t>(d.idx()))
{
  return static_cast<std::size_t>(d.idx());
}

template <class Handle>
auto bits(Handle h) -> decltype(reinterpret_cast<std::size_t>(h.operator->()))
{
  return reinterpret_cast<std::size_t>(h.operator->());
}

inline std::size_t bits(bool b) { return b ? 1 : 0; }

/// What is written here is computed.
inline volatile std::size_t computed;

template <class Arguments, class Operator>
void call_independently(const Arguments& arguments, const Operator& f)
{
  std::size_t sum = 0;
  for (const auto& a : arguments)
    sum += bits(f(a));
  computed = sum;
}

template <class Arguments, class Operator>
void call_dependently(const Arguments& arguments, const Operator& f)
{
  const volatile std::size_t unknown_zero = 0;
  const std::size_t zero = unknown_zero;
  std::size_t sum = 0, last = 0;
  for (std::size_t i = 0; i < arguments.size(); ++i)
    sum += last = bits(f(arguments[i + (last & zero)]));
  computed = sum;
}

/// adds the kernels that call `f` for all `arguments()`. Their result is the sum of `check(f(a))`,
/// which is not timed.
template <class Arguments, class Operator, class Check>
void add_operator(std::vector<Timed_kernel>& kernels, const std::string& name, const Arguments& arguments,
                  const Operator& f, const Check& check)
{
  const auto add = [&](const std::string& kind, const auto& call) {
    kernels.push_back({ name + ", " + kind, "operators", false, [=]() -> Timed_function {
                         const auto all = std::make_shared<decltype(arguments())>(arguments());
                         std::uint64_t sum = 0;
                         for (const auto& a : *all)
                           sum += check(f(a));
                         return [=] {
                           call(*all, f);
                           return static_cast<double>(sum);
                         };
                       } });
  };
  add("independent", [](const auto& all, const auto& g) { call_independently(all, g); });
  add("dependent", [](const auto& all, const auto& g) { call_dependently(all, g); });
}

/// Chain: walks `steps` triangles far, straight on for sixteen of them, then to a random side:
/// returns the sum of the vertices that are met.
template <class Mesh, class Halfedge, class Number>
double walk(const Mesh& mesh, Halfedge h, std::size_t steps, const Number& number)
{
  std::mt19937 random(1);
  std::uint64_t sum = 0;
  bool turns_left = false;
  for (std::size_t i = 0; i < steps; ++i) {
    turns_left = i % 16 == 0 ? random() % 2 == 0 : !turns_left;
    h = next(h, mesh);
    if (turns_left)
      h = next(h, mesh);
    h = opposite(h, mesh);
    sum += number(target(h, mesh));
  }
  return static_cast<double>(sum);
}

/// returns the halfedge between the vertex with label 0 and its neighbor with the least label.
template <class Labeled>
auto first_halfedge(const Labeled& labeled)
{
  const auto range = CGAL::halfedges_around_target(halfedge(labeled.vertex_with_label(0), labeled.mesh), labeled.mesh);
  const Vertex_numbers<std::remove_const_t<decltype(labeled.mesh)> > number(labeled.mesh);
  const auto label = [&](auto h) { return labeled.label[number(source(h, labeled.mesh))]; };
  return *std::min_element(range.begin(), range.end(), [&](auto a, auto b) { return label(a) < label(b); });
}

/// lists the operators of a `Labeled_mesh`.
template <class Labeled>
std::vector<Timed_kernel> operator_kernels(const std::shared_ptr<const Labeled>& labeled)
{
  using Mesh = std::remove_const_t<decltype(labeled->mesh)>;
  using Graph = boost::graph_traits<Mesh>;
  using Vertex = typename Graph::vertex_descriptor;
  using Halfedge = typename Graph::halfedge_descriptor;
  using Face = typename Graph::face_descriptor;
  const Mesh& mesh = labeled->mesh; // which the lists of arguments keep
  const Vertex_numbers<Mesh> number(mesh);
  const auto label = [labeled, number](Vertex v) { return labeled->label[number(v)]; };

  const auto all_vertices = [labeled] {
    const auto range = vertices(labeled->mesh);
    return std::vector<Vertex>(range.begin(), range.end());
  };
  const auto all_halfedges = [labeled] {
    const auto range = halfedges(labeled->mesh);
    return std::vector<Halfedge>(range.begin(), range.end());
  };
  const auto number_of_halfedge = [index = get(boost::halfedge_index, mesh)](Halfedge h) {
    return static_cast<std::uint64_t>(get(index, h));
  };
  const auto number_of_face = [index = get(boost::face_index, mesh)](Face f) {
    return f == Graph::null_face() ? 0 : static_cast<std::uint64_t>(get(index, f));
  };

  std::vector<Timed_kernel> kernels;
  const auto add = [&](const std::string& name, const auto& f, const auto& check) {
    add_operator(kernels, name, all_halfedges, f, check);
  };
  add("next", [&mesh](Halfedge h) { return next(h, mesh); }, number_of_halfedge);
  add("prev", [&mesh](Halfedge h) { return prev(h, mesh); }, number_of_halfedge);
  add("opposite", [&mesh](Halfedge h) { return opposite(h, mesh); }, number_of_halfedge);
  add("source", [&mesh](Halfedge h) { return source(h, mesh); }, label);
  add("target", [&mesh](Halfedge h) { return target(h, mesh); }, label);
  add("face", [&mesh](Halfedge h) { return face(h, mesh); }, number_of_face);
  add_operator(kernels, "halfedge of vertex", all_vertices, [&mesh](Vertex v) { return halfedge(v, mesh); },
               [&mesh, label](Halfedge h) { return label(target(h, mesh)); });

  // of every two pairs, one is an edge
  const auto pairs = [labeled] {
    std::vector<Vertex> v = labeled->vertices_by_label();
    std::shuffle(v.begin(), v.end(), std::mt19937(1));
    std::vector<std::pair<Vertex, Vertex> > result;
    result.reserve(2 * v.size());
    for (std::size_t i = 0; i < v.size(); ++i) {
      result.emplace_back(v[i], source(halfedge(v[i], labeled->mesh), labeled->mesh));
      result.emplace_back(v[i], v[(i + 1) % v.size()]);
    }
    return result;
  };
  add_operator(kernels, "adjacency", pairs,
               [&mesh](const std::pair<Vertex, Vertex>& p) {
                 return halfedge(p.first, p.second, mesh).second;
               },
               [](bool b) { return b ? 1 : 0; });

  kernels.push_back({ "chain next, opposite, target", "operators", true, [=]() -> Timed_function {
                       const Halfedge start = first_halfedge(*labeled);
                       return [=] { return walk(labeled->mesh, start, num_vertices(labeled->mesh), number); };
                     } });
  return kernels;
}

} // namespace example

#endif // BENCHMARK_COMPACT_SURFACE_MESH_OPERATOR_KERNELS_H
