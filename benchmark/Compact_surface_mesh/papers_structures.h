// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef BENCHMARK_COMPACT_SURFACE_MESH_PAPERS_STRUCTURES_H
#define BENCHMARK_COMPACT_SURFACE_MESH_PAPERS_STRUCTURES_H

// The structures of the papers' tables beside the layouts, what our code of each guarantees, and what it stores.

#include "array_mesh.h"
#include "half_edge_arrays.h"
#include "papers_figures.h"
#include "winged_edge_arrays.h"

#include "../../examples/Compact_surface_mesh/compared_meshes.h"

#include <array>
#include <cstddef>
#include <string>
#include <tuple>

namespace papers {

/// The structures that are no layouts.
using Other_structures =
    std::tuple<example::Array_structure<Half_edge_arrays>, example::Array_structure<Winged_edge_arrays> >;

/// What our code guarantees in the worst case on closed meshes, where `d` is the degree of a vertex: next, previous and
/// opposite halfedge; source and target; adjacency of two vertices. A laced ring has numbers that are searched for.
struct Bounds
{
  const char* structure;
  const char* navigation;
  const char* vertex_access;
  const char* adjacency;
};

/// A structure is one line here, or has no bounds in the tables.
inline constexpr std::array<Bounds, 15> our_bounds{ {
    { "Surface_mesh", "O(1)", "O(1)", "O(d)" },
    { "half-edge", "O(1)", "O(1)", "O(d)" },
    { "winged-edge", "O(1)", "O(1)", "O(d)" },
    { "corner-table", "O(1)", "O(1)", "O(d)" },
    { "sot", "O(1)", "O(d)", "O(d^2)" },
    { "squad", "O(1)", "O(d)", "O(d^2)" },
    { "laced-ring", "O(log n)", "O(log n)", "O(d log n)" },
    { "laced-ring-offsets", "O(log n)", "O(log n)", "O(d log n)" },
    { "schnyder-fronts-6n", "O(1)", "O(d)", "O(d)" },
    { "schnyder-fronts-5n", "O(1)", "O(d)", "O(d)" },
    { "schnyder-fronts-4n", "O(1)", "O(d)", "O(d)" },
    { "schnyder-fronts-5n-targets", "O(1)", "O(1)", "O(1)" },
    { "schnyder-parents-4n", "O(1)", "O(1)", "O(1)" },
    { "schnyder-parents-5n", "O(1)", "O(1)", "O(1)" },
    { "schnyder-parents-6n", "O(1)", "O(1)", "O(1)" },
} };

/// returns the entry of `table` that is about `structure`, or null.
template <class Entry, std::size_t n>
const Entry* find(const std::array<Entry, n>& table, const std::string& structure)
{
  for (const Entry& entry : table)
    if (structure == entry.structure)
      return &entry;
  return nullptr;
}

/// \name References
/// The integers that a mesh stores for its connectivity. Bits are not counted as such, as the papers do not: a layout
/// keeps them in arrays whose names end with "bits".
/// @{

inline double num_references(const example::Surface_mesh& mesh)
{
  return mesh.number_of_vertices() + 8. * mesh.number_of_edges() + mesh.number_of_faces();
}

template <class Connectivity>
double num_references(const example::Array_mesh<Connectivity>& mesh)
{
  return static_cast<double>(mesh.connectivity().num_references());
}

template <class Layout>
double num_references(const CGAL::Compact_surface_mesh<example::Point, Layout>& mesh)
{
  const std::string bits = "bits";
  std::size_t bytes = 0;
  for (const auto& [name, size] : mesh.connectivity_memory())
    if (name.size() < bits.size() || name.compare(name.size() - bits.size(), bits.size(), bits) != 0)
      bytes += size;
  return static_cast<double>(bytes) / sizeof(typename Layout::Index);
}

/// @}

} // namespace papers

#endif // BENCHMARK_COMPACT_SURFACE_MESH_PAPERS_STRUCTURES_H
