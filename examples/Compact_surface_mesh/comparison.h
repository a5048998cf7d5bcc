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
#include <tuple>
#include <vector>

namespace example {

/// lists the construction of a mesh from a soup, which must live as long.
template <class Structure>
Timed_kernel construction_from_soup(const Triangle_soup& soup)
{
  return { "construction from a soup", "call", false, [&soup]() -> Timed_function {
            return [&soup] { return static_cast<double>(num_vertices(Structure::mesh_of(soup))); };
          } };
}

/// How the vertices of a mesh are numbered: as in the input, as by the parents layouts, or in
/// an order that only this mesh has.
enum class Vertex_order { INPUT, OURS, OWN };

/// A mesh, as a comparison sees it.
struct Compared_mesh
{
  std::string name;
  Vertex_order order;
  double connectivity_bytes;
  std::vector<Timed_kernel> kernels;
  double sum_over_faces; ///< with the labels

  std::string order_name() const
  {
    return order == Vertex_order::INPUT ? "input's order" : order == Vertex_order::OURS ? "our order" : "own order";
  }
};

/// The first two meshes are `Surface_mesh` in the order of the input, and in the order of the
/// parents layouts. Then come other structures in the order of the input, and the layouts:
/// those that keep the order of what they are built from are given the one or the other.
class Comparison
{
public:
  using Progress = std::function<void(const std::string&)>;
  using Selection = std::function<bool(const std::string&)>;

  /// \param soup the surface
  /// \param wants says by its name whether a layout or one of the `Others` takes part
  /// \param progress is told what is being done
  /// \param kernels returns the list of kernels, as `kernels(Type<Structure>(), labeled_mesh, soup)`
  ///   where `soup` is what the mesh is built from
  /// \param layouts the list of layouts
  /// \param given the order, `INPUT` or `OURS`, that layouts are given which keep it
  /// \throws std::runtime_error if a vertex has no face
  template <class Kernels, class List, class... Others>
  Comparison(const Triangle_soup& soup, const Selection& wants, const Progress& progress, const Kernels& kernels,
             List layouts, std::tuple<Others...> = std::tuple<>(), Vertex_order given = Vertex_order::OURS)
    : m_soup(soup), m_labels(soup.points.size()), m_progress(progress)
  {
    std::iota(m_labels.begin(), m_labels.end(), 0u);
    check_vertices();
    order_soup();
    add<Surface_mesh_structure>(Vertex_order::INPUT, m_soup, m_labels, kernels);
    add<Surface_mesh_structure>(Vertex_order::OURS, m_ordered_soup, m_ordered_labels, kernels);
    [[maybe_unused]] const auto add_other = [&](auto type) {
      using Structure = typename decltype(type)::type;
      if (wants(Structure::name()))
        add<Structure>(Vertex_order::INPUT, m_soup, m_labels, kernels);
    };
    (add_other(Type<Others>()), ...);
    for_each_layout(layouts, [&](auto type) {
      using Structure = Compact_structure<typename decltype(type)::type>;
      if (wants(Structure::name()))
        add_layout<Structure>(given, kernels);
    });
    m_ordered_labels = std::vector<std::uint32_t>();
  }

  const std::vector<Compared_mesh>& meshes() const { return m_meshes; }

  /// the kernels, which are those of any mesh.
  const std::vector<Timed_kernel>& kernels() const { return m_meshes.front().kernels; }

  /// times a kernel on all meshes.
  /// \throws std::logic_error if a mesh has another result
  std::vector<Timing> times(std::size_t kernel, int rounds) const
  {
    const Timed_kernel& k = kernels()[kernel];
    m_progress("timing: " + k.name + ", " + k.way);
    std::vector<Timed_function> functions;
    for (const Compared_mesh& m : m_meshes)
      functions.push_back(m.kernels[kernel].prepare());
    const std::vector<Timing> result = interleaved_times(functions, rounds);
    for (std::size_t i = 0; i < result.size(); ++i) {
      const Vertex_order order = m_meshes[i].order;
      if (k.depends_on_numbers && order == Vertex_order::OWN)
        continue;
      const double expected = result[k.depends_on_numbers && order == Vertex_order::OURS ? 1 : 0].result;
      if (!(std::abs(result[i].result - expected) <= k.tolerance * std::abs(expected)))
        throw std::logic_error(k.name + ", " + k.way + ": " + m_meshes[i].name + " has another result");
    }
    return result;
  }

private:
  void check_vertices() const
  {
    std::vector<bool> has_face(m_soup.points.size(), false);
    for (const Triangle& t : m_soup.triangles)
      for (const std::uint32_t v : t)
        has_face[v] = true;
    for (std::size_t v = 0; v < has_face.size(); ++v)
      if (!has_face[v])
        throw std::runtime_error("vertex " + std::to_string(v) + " has no face, and such meshes are not compared");
  }

  // Sets the soup in the order of the parents layouts.
  void order_soup()
  {
    m_progress("ordering vertices and faces by a Schnyder wood");
    const auto mesh = labeled_mesh(Type<Compact_structure<CGAL::Schnyder_parents_layout<> > >(), m_soup, m_labels);
    m_ordered_soup = soup_of_mesh(mesh->mesh);
    m_ordered_labels = mesh->label;
  }

  template <class Structure, class Kernels>
  void add_layout(Vertex_order given, const Kernels& kernels)
  {
    m_progress("building " + Structure::name());
    const auto labeled = labeled_mesh(Type<Structure>(), m_soup, m_labels);
    if (labeled->label == m_ordered_labels)
      add<Structure>(Vertex_order::OURS, labeled, m_soup, kernels);
    else if (labeled->label != m_labels)
      add<Structure>(Vertex_order::OWN, labeled, m_soup, kernels);
    else if (given == Vertex_order::OURS)
      add<Structure>(Vertex_order::OURS, m_ordered_soup, m_ordered_labels, kernels);
    else
      add<Structure>(Vertex_order::INPUT, labeled, m_soup, kernels);
  }

  template <class Structure, class Kernels>
  void add(Vertex_order order, const Triangle_soup& soup, const std::vector<std::uint32_t>& labels,
           const Kernels& kernels)
  {
    m_progress("building " + Structure::name());
    add<Structure>(order, labeled_mesh(Type<Structure>(), soup, labels), soup, kernels);
  }

  template <class Structure, class Kernels>
  void add(Vertex_order order, const std::shared_ptr<const Labeled_mesh<typename Structure::Mesh> >& labeled,
           const Triangle_soup& soup, const Kernels& kernels)
  {
    const Vertex_numbers<typename Structure::Mesh> number(labeled->mesh);
    const double sum = sum_over_faces<By_operators>(labeled->mesh, [&](auto v) { return labeled->label[number(v)]; });
    m_meshes.push_back({ Structure::name(), order, Structure::connectivity_bytes(labeled->mesh),
                         kernels(Type<Structure>(), labeled, soup), sum });
    if (sum != m_meshes.front().sum_over_faces)
      throw std::logic_error("the faces of " + Structure::name() + " are not those of Surface_mesh");
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
