// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef BENCHMARK_COMPACT_SURFACE_MESH_PAPERS_MEASUREMENT_H
#define BENCHMARK_COMPACT_SURFACE_MESH_PAPERS_MEASUREMENT_H

// Measures what the papers' tables show, on one mesh.

#include "../../examples/Compact_surface_mesh/comparison.h"
#include "all_layouts.h"
#include "closed_surface.h"
#include "operator_kernels.h"
#include "papers_figures.h"
#include "papers_meshes.h"
#include "papers_structures.h"
#include "papers_table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace papers {

using example::Timed_kernel;
using example::Timing;
using example::Type;

/// The kernels of the tables. What each structure stores is noted when it is built.
struct Kernels
{
  struct Stored
  {
    double references, bytes;
  };

  template <class Structure, class Labeled>
  std::vector<Timed_kernel> operator()(Type<Structure>, const std::shared_ptr<const Labeled>& labeled,
                                       const Triangle_soup& soup) const
  {
    stored->push_back({ num_references(labeled->mesh), Structure::connectivity_bytes(labeled->mesh) });
    std::vector<Timed_kernel> kernels = example::degrees_and_normals<example::Stars_and_operators>(labeled);
    for (Timed_kernel& kernel : example::navigation_kernels<example::Dependent_calls>(labeled))
      kernels.push_back(std::move(kernel));
    kernels.push_back(example::construction_from_soup<Structure>(soup));
    return kernels;
  }

  std::vector<Stored>* stored;
};

/// One mesh in all structures, in the order of the input where they keep it.
class Measurement
{
public:
  /// \param wants says by its name whether a structure takes part; winged-edge always does
  Measurement(const Mesh& mesh, int rounds, std::function<bool(const std::string&)> wants)
    : m_mesh(mesh), m_soup(mesh.make()), m_rounds(rounds), m_wants(std::move(wants)),
      m_comparison(m_soup, [this](const std::string& name) { return name == winged_edge() || m_wants(name); },
                   [](const std::string&) {}, Kernels{ &m_stored }, All_layouts(), Other_structures(),
                   example::Vertex_order::INPUT),
      m_n(static_cast<double>(m_soup.points.size()))
  {
    for (std::size_t i = 0; i < m_comparison.meshes().size(); ++i)
      if (i != 1) // Surface_mesh in our order
        m_rows.push_back(i);
  }

  Measurement(const Measurement&) = delete;
  Measurement& operator=(const Measurement&) = delete;

  /// CD18's table 1: memory, in references, bits of these, and all bytes; and operators in ns per call, each waiting
  /// for the result of the one before.
  Papers_table storage_and_operators() const
  {
    Papers_table table = empty_table("CD18 table 1", "the bounds that it states");
    const auto add_stored = [&](const std::string& unit, double scale, bool is_bits) {
      add_column(table, { unit + " per vertex", is_bits ? 1 : 2 }, [&](std::size_t i) -> Papers_cell {
        const Stated_costs* stated = find(stated_costs, name(i));
        return { scale * m_stored[i].references / m_n,
                 stated != nullptr && is_bits == (name(i) == ring_of_bits()) ? stated->references : "" };
      });
    };
    add_stored("references", 1, false);
    add_stored("bits", 32, true);
    add_column(table, { "bytes per vertex", 2 },
               [&](std::size_t i) -> Papers_cell { return { m_stored[i].bytes / m_n, {} }; });
    const double num_halfedges = 3. * static_cast<double>(m_soup.triangles.size());
    for (const char* const op : { "next", "prev", "opposite", "source", "target", "adjacency" }) {
      const std::vector<Timing> timings = times(std::string(op) + ", dependent", "operators");
      const double calls = op == std::string("adjacency") ? 2 * m_n : num_halfedges;
      add_column(table, { std::string(op) + " ns", 2 },
                 [&](std::size_t i) -> Papers_cell { return { 1e9 * timings[i].seconds / calls, {} }; });
    }
    add_bounds(table, "navigation", &Bounds::navigation, &Stated_costs::navigation);
    add_bounds(table, "vertex access", &Bounds::vertex_access, &Stated_costs::vertex_access);
    add_bounds(table, "adjacency", &Bounds::adjacency, &Stated_costs::adjacency);
    return table;
  }

  /// CD18's table 2: the first three columns, construction. Its row is the one of the nearest size.
  Papers_table construction() const
  {
    const Construction_times& paper =
        *std::min_element(construction_times.begin(), construction_times.end(), [&](const auto& a, const auto& b) {
          return std::abs(std::log(m_n / static_cast<double>(a.num_vertices))) <
                 std::abs(std::log(m_n / static_cast<double>(b.num_vertices)));
        });
    Papers_table table = empty_table("CD18 table 2", "its row of " + std::to_string(paper.num_vertices) +
                                                         " vertices; half-edges come from a file there, and for "
                                                         "CDS6n wood and arrays are added");
    table.columns = { { "from soup s", 4 }, { "its ns per vertex", 1 }, { "wood and layout s", 4 },
                      { "their ns per vertex", 1 } };
    const auto cells = [](double seconds, double seconds_of_paper, double n, double n_of_paper) {
      return std::vector<Papers_cell>{ { seconds, seconds_of_paper },
                                       { 1e9 * seconds / n, 1e9 * seconds_of_paper / n_of_paper } };
    };
    const double nan = std::nan("");
    const double n_of_paper = static_cast<double>(paper.num_vertices);
    const std::vector<Timing> from_soup = times("construction from a soup", "call");
    const auto [wood, layouts] = wood_and_layouts();
    std::size_t next_layout = 0;
    for (const std::size_t i : m_rows) {
      Papers_row row{ name(i), cells(from_soup[i].seconds, name(i) == "half-edge" ? paper.half_edges : nan, m_n,
                                     n_of_paper) };
      for (Papers_cell& cell :
           cells(is_layout(i) ? layouts[next_layout++].seconds : nan,
                 name(i) == degree_columns[2].structure ? paper.wood + paper.layout : nan, m_n, n_of_paper))
        row.cells.push_back(std::move(cell));
      table.rows.push_back(std::move(row));
    }
    Papers_row row{ "Schnyder wood alone", std::vector<Papers_cell>(2) };
    for (Papers_cell& cell : cells(wood.seconds, paper.wood, m_n, n_of_paper))
      row.cells.push_back(std::move(cell));
    table.rows.push_back(std::move(row));
    return table;
  }

  /// CD18's table 3 and figure 14: degrees and normals in ns per vertex, one operator at a time and by whole stars, and
  /// as ratios to winged-edge with one operator at a time.
  Papers_table degrees_and_normals() const
  {
    const auto row = std::find_if(degree_times.begin(), degree_times.end(),
                                  [&](const Degree_times& r) { return r.mesh == m_mesh.degrees_of; });
    Papers_table table = empty_table("CD18 table 3 and figure 14",
                                     row == degree_times.end() ? ""
                                                               : std::string(row->mesh) + ", " + m_mesh.kinship);
    const auto paper = [&](std::size_t i, double divisor) -> Figure {
      const Degree_column* column = find(degree_columns, name(i));
      if (row == degree_times.end() || column == nullptr)
        return {};
      const bool has_slow_form = column->ns == &Degree_times::cds6n && divisor == 1;
      return { (*row).*column->ns / divisor,
               has_slow_form ? " (slow form " + Figure(row->cds6n_slow).printed(0) + ')' : "" };
    };
    const std::size_t winged = *std::find_if(m_rows.begin(), m_rows.end(),
                                             [&](std::size_t i) { return name(i) == winged_edge(); });
    for (const std::string kernel : { "degree", "vertex normals" }) {
      const std::string name_of_columns = kernel == "degree" ? "degree" : "normals";
      const auto paper_of_kernel = [&](std::size_t i, double divisor) {
        return kernel == "degree" ? paper(i, divisor) : Figure();
      };
      const std::vector<Timing> one_by_one = times(kernel, "operators"), stars = times(kernel, "stars");
      const double unit = one_by_one[winged].seconds;
      add_column(table, { name_of_columns + " ns", 1 }, [&](std::size_t i) -> Papers_cell {
        return { 1e9 * one_by_one[i].seconds / m_n, paper_of_kernel(i, 1) };
      });
      add_column(table, { name_of_columns + ratio_suffix(), 2 }, [&](std::size_t i) -> Papers_cell {
        return { one_by_one[i].seconds / unit,
                 row == degree_times.end() ? Figure() : paper_of_kernel(i, row->winged_edge) };
      });
      add_column(table, { name_of_columns + " by stars ns", 1 }, [&](std::size_t i) -> Papers_cell {
        return { is_layout(i) ? Figure(1e9 * stars[i].seconds / m_n) : Figure(), {} };
      });
      add_column(table, { name_of_columns + " by stars" + ratio_suffix(), 2 }, [&](std::size_t i) -> Papers_cell {
        return { is_layout(i) ? Figure(stars[i].seconds / unit) : Figure(), {} };
      });
    }
    return table;
  }

  /// LR's table 1: references and bits per triangle.
  Papers_table ring_costs_per_triangle() const
  {
    const auto row = std::find_if(ring_costs.begin(), ring_costs.end(),
                                  [&](const Ring_costs& r) { return r.mesh == m_mesh.rings_of; });
    const bool has_row = row != ring_costs.end();
    Papers_table table =
        empty_table("LR table 1", has_row ? std::string(row->mesh) + ", " + m_mesh.kinship : std::string());
    table.columns = { { "triangles", 0 }, { "% of valence 6", 1 }, { "LR references per triangle", 3 },
                      { "SQuad references per triangle", 3 }, { "bit-efficient LR bits per triangle", 2 },
                      { "all its bits per triangle", 2 } };
    const double triangles = static_cast<double>(m_soup.triangles.size());
    Papers_row ours{ m_mesh.name, { { triangles, {} }, { percentage_of_valence_6(m_soup), {} } } };
    const auto add = [&](const std::string& structure, double Kernels::Stored::*what, double scale, double paper) {
      const auto i = std::find_if(m_rows.begin(), m_rows.end(), [&](std::size_t k) { return name(k) == structure; });
      ours.cells.push_back({ i == m_rows.end() ? Figure() : Figure(scale * (m_stored[*i].*what) / triangles), paper });
    };
    const double nan = std::nan("");
    if (has_row) {
      ours.cells[0].paper = static_cast<double>(row->num_triangles);
      ours.cells[1].paper = row->valence_6;
    }
    add("laced-ring", &Kernels::Stored::references, 1, has_row ? row->laced_ring_rpt : nan);
    add("squad", &Kernels::Stored::references, 1, has_row ? row->squad_rpt : nan);
    add(ring_of_bits(), &Kernels::Stored::references, 32, has_row ? row->laced_ring_bpt : nan);
    add(ring_of_bits(), &Kernels::Stored::bytes, 8, nan);
    table.rows.push_back(std::move(ours));
    return table;
  }

  /// is what the names of columns with ratios end with.
  static std::string ratio_suffix() { return " ratio"; }

private:
  static std::string winged_edge() { return Winged_edge_arrays::name(); }

  // The structure whose cost LR counts in bits.
  static std::string ring_of_bits() { return "laced-ring-offsets"; }

  const std::string& name(std::size_t i) const { return m_comparison.meshes()[i].name; }

  bool is_layout(std::size_t i) const
  {
    bool result = false;
    example::for_each_layout(All_layouts(), [&](auto type) { result = result || decltype(type)::type::name() == name(i); });
    return result;
  }

  Papers_table empty_table(const std::string& name, const std::string& beside) const
  {
    return { name, m_mesh.name, m_soup.points.size(), beside, {}, {} };
  }

  // Adds a column; `cell(i)` is that of the i-th mesh of the comparison.
  template <class Cell>
  void add_column(Papers_table& table, const Papers_column& column, const Cell& cell) const
  {
    table.columns.push_back(column);
    if (table.rows.empty())
      for (const std::size_t i : m_rows)
        table.rows.push_back({ name(i), {} });
    for (std::size_t r = 0; r < m_rows.size(); ++r)
      table.rows[r].cells.push_back(cell(m_rows[r]));
  }

  void add_bounds(Papers_table& table, const std::string& column, const char* Bounds::*ours,
                  const char* Stated_costs::*stated) const
  {
    add_column(table, { column, 0 }, [&](std::size_t i) -> Papers_cell {
      const Bounds* bounds = find(our_bounds, name(i));
      const Stated_costs* costs = find(stated_costs, name(i));
      return { bounds ? bounds->*ours : "", costs ? costs->*stated : "" };
    });
  }

  // The times of a kernel on all meshes of the comparison.
  std::vector<Timing> times(const std::string& kernel, const std::string& way) const
  {
    const auto& kernels = m_comparison.kernels();
    for (std::size_t k = 0; k < kernels.size(); ++k)
      if (kernels[k].name == kernel && kernels[k].way == way)
        return m_comparison.times(k, m_rounds);
    throw std::logic_error("there is no kernel " + kernel + ", " + way);
  }

  // The times of a wood, and of all layouts that are wanted with their woods.
  std::pair<Timing, std::vector<Timing> > wood_and_layouts() const
  {
    const example::Closed_surface surface(m_mesh.name, CGAL::Corner_table<>(m_soup.points.size(), m_soup.triangles));
    if (!surface.is_connected())
      throw std::runtime_error(m_mesh.name + ": has several components");
    std::vector<example::Timed_function> functions = { [&] { return surface.shell(); } };
    example::for_each_layout(All_layouts(), [&](auto type) {
      using Layout = typename decltype(type)::type;
      if (m_wants(Layout::name()))
        functions.push_back([&] { return surface.build_layout<Layout>(); });
    });
    std::vector<Timing> layouts = example::interleaved_times(functions, m_rounds);
    const Timing wood = layouts.front();
    layouts.erase(layouts.begin());
    return { wood, layouts };
  }

  Mesh m_mesh;
  Triangle_soup m_soup;
  int m_rounds;
  std::function<bool(const std::string&)> m_wants;
  std::vector<Kernels::Stored> m_stored; // one a mesh of the comparison
  example::Comparison m_comparison;
  double m_n;
  std::vector<std::size_t> m_rows; // the meshes of the comparison that are shown
};

} // namespace papers

#endif // BENCHMARK_COMPACT_SURFACE_MESH_PAPERS_MEASUREMENT_H
