// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef BENCHMARK_COMPACT_SURFACE_MESH_PAPERS_MESHES_H
#define BENCHMARK_COMPACT_SURFACE_MESH_PAPERS_MESHES_H

// The meshes on which the papers' tables are run again: of the papers' models those that CGAL's data archive has,
// in its sampling, and random triangulations as CD18 draws them.

#include "benchmark_inputs.h"
#include "papers_figures.h"

#include <CGAL/config.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace papers {

using example::Triangle_soup;

/// A closed triangle mesh.
struct Mesh
{
  std::string name;
  std::function<Triangle_soup()> make;
  std::string degrees_of; ///< the row of CD18's table 3 that it is compared with; empty if there is none
  std::string rings_of;   ///< that of LR's table 1
  std::string kinship;    ///< to the papers' model
};

/// returns the percentage of vertices of valence 6, with which the cost of laced rings goes down.
inline double percentage_of_valence_6(const Triangle_soup& soup)
{
  std::vector<int> valence(soup.points.size(), 0);
  for (const auto& t : soup.triangles)
    for (const auto v : t)
      ++valence[v];
  return 100. * static_cast<double>(std::count(valence.begin(), valence.end(), 6)) /
         static_cast<double>(valence.size());
}

/// fills each hole that has three sides with a triangle.
inline Triangle_soup with_triangular_holes_filled(Triangle_soup soup)
{
  const CGAL::Corner_table<> table(soup.points.size(), soup.triangles);
  const auto before = [&](std::uint32_t h) { return table.prev(table.last_around_source(h)); }; // along the border
  for (std::uint32_t h = 0; h < table.num_halfedges(); ++h) {
    if (table.opposite(h) != table.null())
      continue;
    const std::uint32_t g = before(h), k = before(g);
    if (h < g && h < k && before(k) == h)
      soup.triangles.push_back({ table.target(h), table.source(h), table.source(g) });
  }
  return soup;
}

inline Triangle_soup mesh_of_archive(const std::string& name)
{
  return with_triangular_holes_filled(
      benchmark_inputs::subdivided_mesh(CGAL::data_file_path("meshes/" + name + ".off"), 0));
}

/// lists all meshes, the generated ones with about `sizes` vertices.
inline std::vector<Mesh> all_meshes(const std::vector<std::size_t>& sizes)
{
  std::vector<Mesh> meshes;
  const auto add_file = [&](const std::string& name, const std::string& degrees_of, const std::string& rings_of,
                            const std::string& kinship) {
    meshes.push_back({ name, [=] { return mesh_of_archive(name); }, degrees_of, rings_of, kinship });
  };
  add_file("bunny00", "Bunny", "bunny", "the same model in another sampling");
  add_file("ChineseDragon-10kv", "Chinese dragon", "", "the same model with 20,000 triangles");
  add_file("armadillo", "", "armadillo", "the same model with 52,000 triangles");
  add_file("elephant", "", "", "");
  add_file("cow", "", "", "");
  for (const std::size_t n : sizes) {
    const std::string number = std::to_string(n);
    const std::string row = n == 100000    ? "Random 100K vert."
                            : n == 2500000 ? "Random 2.5M vert."
                            : n == 5000000 ? "Random 5M vert."
                                           : "";
    meshes.push_back({ "random " + number, [=] { return benchmark_inputs::random_triangulation(n); }, row, "",
                       row.empty() ? "" : "drawn alike" });
    meshes.push_back({ "armadillo subdivided to " + number,
                       [=] { return example::subdivided_to(mesh_of_archive("armadillo"), n); }, "", "", "" });
  }
  return meshes;
}

/// lists the papers' models that none of `meshes` stands for.
inline std::vector<std::string> missing_models(const std::vector<Mesh>& meshes)
{
  std::vector<std::string> missing;
  const auto add = [&](const std::string& paper, const std::string& model, std::string Mesh::*row) {
    if (std::none_of(meshes.begin(), meshes.end(), [&](const Mesh& m) { return m.*row == model; }))
      missing.push_back(model + " (" + paper + ")");
  };
  for (const Degree_times& row : degree_times)
    add("CD18", row.mesh, &Mesh::degrees_of);
  for (const Ring_costs& row : ring_costs)
    add("LR", row.mesh, &Mesh::rings_of);
  return missing;
}

} // namespace papers

#endif // BENCHMARK_COMPACT_SURFACE_MESH_PAPERS_MESHES_H
