// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef COMPACT_SURFACE_MESH_EXAMPLES_COMPARISON_H
#define COMPACT_SURFACE_MESH_EXAMPLES_COMPARISON_H

// One surface in several structures, and the times of the same kernels on all of them.

#include "compared_meshes.h"
#include "interleaved_times.h"
#include "mesh_kernels.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace example {

/// The kernels, in the order in which `Compared_mesh` holds them.
const std::vector<std::string> kernel_names = { "vertex degree", "vertex normal", "face", "breadth-first search" };

/// A mesh, as a comparison sees it.
struct Compared_mesh
{
  std::string name;
  std::string order;
  double connectivity_bytes;
  Timed_function build; // from the soup, points included
  std::vector<Timed_function> by_stars, by_operators;
  Timed_function bfs_by_boost;
  std::vector<double> sums_over_faces; // with the labels, by stars and by operators
};

/// The first two meshes are `Surface_mesh` in the order of the input, and in the order of the
/// parents layouts. The others are the layouts, all in that second order: those that keep
/// the input's are given it.
class Comparison
{
public:
  using Progress = std::function<void(const std::string&)>;
  using Selection = std::function<bool(const std::string&)>;

  Comparison(const Triangle_soup& soup, const Selection& wants, const Progress& progress)
    : m_soup(soup), m_labels(soup.points.size()), m_progress(progress)
  {
    std::iota(m_labels.begin(), m_labels.end(), 0u);
    order_soup();
    progress("building Surface_mesh in the order of the input");
    const auto surface_mesh = labeled_surface_mesh(m_soup, m_labels);
    add("Surface_mesh", "input's order", surface_mesh, connectivity_bytes(surface_mesh->mesh),
        [this] { return number_of_vertices(surface_mesh_of(m_soup)); });
    progress("building Surface_mesh in our order");
    const auto reordered = labeled_surface_mesh(m_ordered_soup, m_ordered_labels);
    add("Surface_mesh", "our order", reordered, connectivity_bytes(reordered->mesh),
        [this] { return number_of_vertices(surface_mesh_of(m_ordered_soup)); });
    for_each_layout([&](auto type) {
      using Layout = typename decltype(type)::type;
      if (wants(Layout::name()))
        add_layout<Layout>();
    });
    m_ordered_labels = std::vector<std::uint32_t>();
  }

  const std::vector<Compared_mesh>& meshes() const { return m_meshes; }

  std::vector<Timing> build_times(int rounds) const
  {
    m_progress("timing: building");
    return times([](const Compared_mesh& m) { return m.build; }, rounds);
  }

  std::vector<Timing> star_times(std::size_t kernel, int rounds) const
  {
    m_progress("timing: " + kernel_names[kernel] + ", whole stars");
    return checked_times(kernel, [=](const Compared_mesh& m) { return m.by_stars[kernel]; }, rounds);
  }

  std::vector<Timing> operator_times(std::size_t kernel, int rounds) const
  {
    m_progress("timing: " + kernel_names[kernel] + ", one operator at a time");
    return checked_times(kernel, [=](const Compared_mesh& m) { return m.by_operators[kernel]; }, rounds);
  }

  std::vector<Timing> boost_bfs_times(int rounds) const
  {
    m_progress("timing: breadth-first search by Boost");
    return checked_times(3, [](const Compared_mesh& m) { return m.bfs_by_boost; }, rounds);
  }

private:
  // Sets the soup in the order of the parents layouts.
  void order_soup()
  {
    m_progress("ordering vertices and faces by a Schnyder wood");
    const auto mesh = labeled_compact_mesh<CGAL::Schnyder_parents_layout<> >(m_soup, m_labels);
    m_ordered_soup = soup_of_mesh(mesh->mesh);
    m_ordered_labels = mesh->label;
  }

  template <class Layout>
  void add_layout()
  {
    using Mesh = CGAL::Compact_surface_mesh<Point, Layout>;
    m_progress("building " + Layout::name());
    auto labeled = labeled_compact_mesh<Layout>(m_soup, m_labels);
    if (labeled->label == m_labels)
      labeled = labeled_compact_mesh<Layout>(m_ordered_soup, m_ordered_labels);
    add(Layout::name(), "our order", labeled, static_cast<double>(labeled->mesh.connectivity_bytes()),
        [this] { return number_of_vertices(Mesh(m_soup.points, m_soup.triangles)); });
  }

  template <class Mesh>
  static double number_of_vertices(const Mesh& mesh) { return static_cast<double>(num_vertices(mesh)); }

  template <class Mesh>
  void add(const std::string& name, const std::string& order,
           const std::shared_ptr<const Labeled_mesh<Mesh> >& labeled, double bytes, const Timed_function& build)
  {
    using Stars = std::conditional_t<std::is_same<Mesh, Surface_mesh>::value, By_operators, By_stars>;
    const auto bfs = std::make_shared<Breadth_first_search<Mesh> >(labeled->mesh, labeled->vertex_with_label(0));
    const auto label = [&](auto v) { return labeled->label[v]; };
    m_meshes.push_back({ name, order, bytes, build, kernels<Stars>(labeled, bfs), kernels<By_operators>(labeled, bfs),
                         [labeled, bfs] { return bfs->run_by_boost(); },
                         { sum_over_faces<Stars>(labeled->mesh, label),
                           sum_over_faces<By_operators>(labeled->mesh, label) } });
    if (m_meshes.back().sums_over_faces != m_meshes.front().sums_over_faces)
      throw std::logic_error("the faces of " + name + " are not those of Surface_mesh");
  }

  template <class Access, class Mesh>
  static std::vector<Timed_function> kernels(const std::shared_ptr<const Labeled_mesh<Mesh> >& labeled,
                                             const std::shared_ptr<Breadth_first_search<Mesh> >& bfs)
  {
    return { [labeled] { return sum_of_degrees<Access>(labeled->mesh); },
             [labeled] { return sum_of_normals<Access>(labeled->mesh); },
             [labeled] { return sum_over_faces<Access>(labeled->mesh, [](auto v) { return v.idx(); }); },
             [labeled, bfs] { return bfs->template run<Access>(); } };
  }

  template <class Choice>
  std::vector<Timing> times(const Choice& choice, int rounds) const
  {
    std::vector<Timed_function> functions;
    for (const Compared_mesh& m : m_meshes)
      functions.push_back(choice(m));
    return interleaved_times(functions, rounds);
  }

  // Only the sum over faces depends on the order, which the second mesh shares with the layouts.
  template <class Choice>
  std::vector<Timing> checked_times(std::size_t kernel, const Choice& choice, int rounds) const
  {
    const std::vector<Timing> result = times(choice, rounds);
    const double expected = result[1].result;
    for (std::size_t i = kernel == 2 ? 1 : 0; i < result.size(); ++i)
      if (!(std::abs(result[i].result - expected) <= 1e-9 * std::abs(expected)))
        throw std::logic_error(kernel_names[kernel] + ": " + m_meshes[i].name + " has another result");
    return result;
  }

  const Triangle_soup& m_soup;
  std::vector<std::uint32_t> m_labels;
  Triangle_soup m_ordered_soup;
  std::vector<std::uint32_t> m_ordered_labels;
  Progress m_progress;
  std::vector<Compared_mesh> m_meshes;
};

} // namespace example

#endif // COMPACT_SURFACE_MESH_EXAMPLES_COMPARISON_H
