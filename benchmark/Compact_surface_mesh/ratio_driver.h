// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef BENCHMARK_COMPACT_SURFACE_MESH_RATIO_DRIVER_H
#define BENCHMARK_COMPACT_SURFACE_MESH_RATIO_DRIVER_H

// The program that compares kernels on all inputs and structures.
//
// Google Benchmark does not serve here: a ratio wants the two functions to take turns, call by call.

#include "../../examples/Compact_surface_mesh/comparison.h"
#include "benchmark_inputs.h"
#include "command_line.h"
#include "machine.h"
#include "ratio_plot.h"
#include "ratio_rows.h"

#include <CGAL/Compact_surface_mesh.h>

#include <CGAL/config.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace ratio_driver {

struct Arguments
{
  std::vector<std::size_t> sizes;
  std::string mesh = CGAL::data_file_path("meshes/armadillo.off");
  std::string scan = CGAL::data_file_path("meshes/bunny00.off");
  std::string inputs, kernels, types; // regular expressions; empty for all, or for the default
  std::string csv, svg;               // files
  int rounds = 5;
};

[[noreturn]] inline void exit_with_usage(const char* program)
{
  std::cerr << program
            << " [N...] [OPTIONS]\n"
               "  N               about how many vertices the meshes have, 1000000 by default\n"
               "  --inputs REGEX  only inputs whose name has a match:";
  for (const auto& input : benchmark_inputs::all_inputs(0, "", ""))
    std::cerr << ' ' << input.name << ',';
  std::cerr << "\n"
               "  --kernels REGEX only kernels whose row, as 'degree, stars', has a match\n"
               "  --types REGEX   beside Surface_mesh only types whose name has a match; from 5 million\n"
               "                  vertices on "
            << CGAL::Schnyder_parents_layout<>::name()
            << " only, by default\n"
               "  --mesh FILE     the mesh that is subdivided, or sphere; by default CGAL's meshes/armadillo.off\n"
               "  --scan FILE     the mesh of scan quality; by default CGAL's meshes/bunny00.off\n"
               "  --rounds R      medians are taken of so many runs, 5 by default\n"
               "  --csv FILE      writes comma-separated values, too, after each input\n"
               "  --svg FILE      draws the ratios, too, after each input\n";
  std::exit(2);
}

inline Arguments parsed(int argc, char* argv[])
{
  Arguments arguments;
  arguments.sizes = read_command_line(argc, argv,
                                      { { "--inputs", &arguments.inputs },
                                        { "--kernels", &arguments.kernels },
                                        { "--types", &arguments.types },
                                        { "--mesh", &arguments.mesh },
                                        { "--scan", &arguments.scan },
                                        { "--csv", &arguments.csv },
                                        { "--svg", &arguments.svg } },
                                      arguments.rounds, [&] { exit_with_usage(argv[0]); });
  if (arguments.sizes.empty())
    arguments.sizes.push_back(1000000);
  return arguments;
}

/// Makes the comparison of the structures that are wanted on a soup.
using Make_comparison = std::function<std::unique_ptr<const example::Comparison>(
    const example::Triangle_soup&, const example::Comparison::Selection&)>;

/// measures one input. Its meshes are freed at the end.
inline Measured_input measured(const std::string& name, const example::Triangle_soup& soup, const std::string& types,
                               const Arguments& arguments, const Make_comparison& make_comparison)
{
  const auto owner = make_comparison(soup, [&](const std::string& type) { return matches(type, types); });
  const example::Comparison& comparison = *owner;
  const double n = static_cast<double>(soup.points.size());
  Measured_input result{ name, soup.points.size(), {}, {} };
  for (const example::Compared_mesh& m : comparison.meshes())
    result.structures.push_back({ m.name, m.order_name(), m.connectivity_bytes / n });
  const Ratio_table table(std::cout);
  table.print_heading(result);
  for (std::size_t k = 0; k < comparison.kernels().size(); ++k) {
    const example::Timed_kernel& kernel = comparison.kernels()[k];
    if (!matches(kernel.name + ", " + kernel.way, arguments.kernels))
      continue;
    const std::vector<example::Timing> timings = comparison.times(k, arguments.rounds);
    Ratio_row row{ kernel.name, kernel.way, {} };
    for (const example::Timing& t : timings)
      row.ratios.push_back({ 1e9 * t.seconds / n, t.seconds / timings[0].seconds, t.seconds / timings[1].seconds });
    table.print_row(row);
    result.rows.push_back(std::move(row));
  }
  return result;
}

inline void run(const Arguments& arguments, const Make_comparison& make_comparison)
{
  const std::string machine = machine_description();
  std::cout << machine << '\n';
  std::vector<Measured_input> all;
  for (const std::size_t n : arguments.sizes) {
    const bool is_large = n >= 5000000;
    const std::string types = !arguments.types.empty() ? arguments.types
                              : is_large               ? CGAL::Schnyder_parents_layout<>::name()
                                                       : "";
    for (const auto& input : benchmark_inputs::all_inputs(n, arguments.mesh, arguments.scan)) {
      if (!matches(input.name, arguments.inputs))
        continue;
      all.push_back(measured(input.name, input.make(), types, arguments, make_comparison));
      write_file(arguments.csv, [&](std::ostream& out) { write_csv(out, all, machine); });
      write_file(arguments.svg, [&](std::ostream& out) { Ratio_plot(out, all, machine); });
    }
  }
}

/// is the main function of a program.
inline int main(int argc, char* argv[], const Make_comparison& make_comparison)
{
  const Arguments arguments = parsed(argc, argv);
  try {
    run(arguments, make_comparison);
  } catch (const std::exception& e) {
    std::cerr << e.what() << std::endl;
    return 1;
  }
  return 0;
}

} // namespace ratio_driver

#endif // BENCHMARK_COMPACT_SURFACE_MESH_RATIO_DRIVER_H
