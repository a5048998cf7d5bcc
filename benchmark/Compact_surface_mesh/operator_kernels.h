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

/// Adds a kernel that calls `f` for all `arguments()`, each call waiting for the result of the one before. Its result
/// is the sum of `check(f(a))`, which is not timed.
struct Dependent_calls
{
  template <class Arguments, class Operator, class Check>
  static void add(std::vector<Timed_kernel>& kernels, const std::string& name, const Arguments& arguments,
                  const Operator& f, const Check& check)
  {
    add_calls(kernels, name + ", dependent", arguments, f, check,
              [](const auto& all, const auto& g) { call_dependently(all, g); });
  }

protected:
  template <class Arguments, class Operator, class Check, class Call>
  static void add_calls(std::vector<Timed_kernel>& kernels, const std::string& name, const Arguments& arguments,
                        const Operator& f, const Check& check, const Call& call)
  {
    kernels.push_back({ name, "operators", false, [=]() -> Timed_function {
                         const auto all = std::make_shared<decltype(arguments())>(arguments());
                         std::uint64_t sum = 0;
                         for (const auto& a : *all)
                           sum += check(f(a));
                         return [=] {
                           call(*all, f);
                           return static_cast<double>(sum);
                         };
                       } });
  }
};

/// Adds independent calls as well.
struct All_calls : Dependent_calls
{
  template <class Arguments, class Operator, class Check>
  static void add(std::vector<Timed_kernel>& kernels, const std::string& name, const Arguments& arguments,
                  const Operator& f, const Check& check)
  {
    add_calls(kernels, name + ", independent", arguments, f, check,
              [](const auto& all, const auto& g) { call_independently(all, g); });
    Dependent_calls::add(kernels, name, arguments, f, check);
  }
};

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

/// returns all halfedges of a `Labeled_mesh`.
template <class Labeled>
auto all_halfedges(const std::shared_ptr<const Labeled>& labeled)
{
  const auto range = halfedges(labeled->mesh);
  using Mesh = std::remove_const_t<decltype(labeled->mesh)>;
  return std::vector<typename boost::graph_traits<Mesh>::halfedge_descriptor>(range.begin(), range.end());
}

/// lists the operators that CD18 counts, of a `Labeled_mesh`: next, previous and opposite halfedge, source, target and
/// adjacency, each with the `Calls` that these add.
template <class Calls, class Labeled>
std::vector<Timed_kernel> navigation_kernels(const std::shared_ptr<const Labeled>& labeled)
{
  using Mesh = std::remove_const_t<decltype(labeled->mesh)>;
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  using Halfedge = typename boost::graph_traits<Mesh>::halfedge_descriptor;
  const Mesh& mesh = labeled->mesh; // which the lists of arguments keep
  const auto arguments = [labeled] { return all_halfedges(labeled); };
  const auto number = [index = get(boost::halfedge_index, mesh)](Halfedge h) {
    return static_cast<std::uint64_t>(get(index, h));
  };
  const auto label = [labeled, number_of = Vertex_numbers<Mesh>(mesh)](Vertex v) {
    return labeled->label[number_of(v)];
  };

  std::vector<Timed_kernel> kernels;
  Calls::add(kernels, "next", arguments, [&mesh](Halfedge h) { return next(h, mesh); }, number);
  Calls::add(kernels, "prev", arguments, [&mesh](Halfedge h) { return prev(h, mesh); }, number);
  Calls::add(kernels, "opposite", arguments, [&mesh](Halfedge h) { return opposite(h, mesh); }, number);
  Calls::add(kernels, "source", arguments, [&mesh](Halfedge h) { return source(h, mesh); }, label);
  Calls::add(kernels, "target", arguments, [&mesh](Halfedge h) { return target(h, mesh); }, label);

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
  Calls::add(kernels, "adjacency", pairs,
             [&mesh](const std::pair<Vertex, Vertex>& p) {
               return halfedge(p.first, p.second, mesh).second;
             },
             [](bool b) { return b ? 1 : 0; });
  return kernels;
}

/// lists all operators of a `Labeled_mesh`, and the chain of them.
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

  std::vector<Timed_kernel> kernels = navigation_kernels<All_calls>(labeled);
  All_calls::add(kernels, "face", [labeled] { return all_halfedges(labeled); },
                 [&mesh](Halfedge h) { return face(h, mesh); },
                 [index = get(boost::face_index, mesh)](Face f) {
                   return f == Graph::null_face() ? 0 : static_cast<std::uint64_t>(get(index, f));
                 });
  All_calls::add(kernels, "halfedge of vertex",
                 [labeled] {
                   const auto range = vertices(labeled->mesh);
                   return std::vector<Vertex>(range.begin(), range.end());
                 },
                 [&mesh](Vertex v) { return halfedge(v, mesh); },
                 [labeled, number](Halfedge h) { return labeled->label[number(target(h, labeled->mesh))]; });
  kernels.push_back({ "chain next, opposite, target", "operators", true, [=]() -> Timed_function {
                       const Halfedge start = first_halfedge(*labeled);
                       return [=] { return walk(labeled->mesh, start, num_vertices(labeled->mesh), number); };
                     } });
  return kernels;
}

} // namespace example

#endif // BENCHMARK_COMPACT_SURFACE_MESH_OPERATOR_KERNELS_H
