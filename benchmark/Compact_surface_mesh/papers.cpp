// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The tables of the papers, run again with all structures here, each number beside the paper's: CD18's tables 1 to 3
// and figure 14, and LR's table 1.

#include "command_line.h"
#include "machine.h"
#include "papers_averages.h"
#include "papers_bars.h"
#include "papers_measurement.h"
#include "papers_meshes.h"
#include "papers_table.h"

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace {

struct Arguments
{
  std::vector<std::size_t> sizes;
  std::string meshes, types, tables; // regular expressions; empty for all
  std::string csv, svg;              // files
  int rounds = 5;
};

[[noreturn]] void exit_with_usage()
{
  std::cerr << "papers [N...] [OPTIONS]\n"
               "  N               about how many vertices the generated meshes have, 100000 by default; CD18's\n"
               "                  random ones have 100000, 2500000 and 5000000\n"
               "  --meshes REGEX  only meshes whose name has a match:";
  for (const auto& mesh : papers::all_meshes({ 100000 }))
    std::cerr << ' ' << mesh.name << ',';
  std::cerr << "\n"
               "  --types REGEX   beside Surface_mesh and winged-edge only structures whose name has a match\n"
               "  --tables REGEX  only tables whose name has a match: CD18 table 1, CD18 table 2,\n"
               "                  CD18 table 3 and figure 14, LR table 1\n"
               "  --rounds R      medians are taken of so many runs, 5 by default\n"
               "  --csv FILE      writes comma-separated values, too, after each mesh\n"
               "  --svg FILE      draws the bars of figure 14, too, after each mesh\n";
  std::exit(2);
}

Arguments parsed(int argc, char* argv[])
{
  Arguments arguments;
  arguments.sizes = read_command_line(argc, argv,
                                      { { "--meshes", &arguments.meshes },
                                        { "--types", &arguments.types },
                                        { "--tables", &arguments.tables },
                                        { "--csv", &arguments.csv },
                                        { "--svg", &arguments.svg } },
                                      arguments.rounds, exit_with_usage);
  if (arguments.sizes.empty())
    arguments.sizes.push_back(100000);
  return arguments;
}

void print_models(const std::vector<papers::Mesh>& meshes)
{
  std::cout << "Models of the papers that are here:";
  for (const papers::Mesh& mesh : meshes)
    if (!mesh.kinship.empty())
      std::cout << ' ' << mesh.name << " (" << mesh.kinship << "),";
  std::cout << "\nand that are not:";
  for (const std::string& model : papers::missing_models(meshes))
    std::cout << ' ' << model << ',';
  std::cout << '\n';
}

void run(const Arguments& arguments)
{
  const std::string machine = machine_description();
  const std::vector<papers::Mesh> meshes = papers::all_meshes(arguments.sizes);
  std::cout << machine << '\n';
  print_models(meshes);
  std::vector<Papers_table> all, degrees;
  for (const papers::Mesh& mesh : meshes) {
    if (!matches(mesh.name, arguments.meshes))
      continue;
    const papers::Measurement measurement(mesh, arguments.rounds, [&](const std::string& type) {
      return matches(type, arguments.types);
    });
    const auto add = [&](const std::string& name, const auto& table) {
      if (!matches(name, arguments.tables))
        return;
      all.push_back((measurement.*table)());
      std::cout << all.back();
      if (table == &papers::Measurement::degrees_and_normals)
        degrees.push_back(all.back());
    };
    add("CD18 table 1", &papers::Measurement::storage_and_operators);
    add("CD18 table 2", &papers::Measurement::construction);
    add("CD18 table 3 and figure 14", &papers::Measurement::degrees_and_normals);
    add("LR table 1", &papers::Measurement::ring_costs_per_triangle);
    write_file(arguments.csv, [&](std::ostream& out) { write_csv(out, all, machine); });
    write_file(arguments.svg, [&](std::ostream& out) {
      Papers_bars(out, degrees, { "degree ns", "normals ns", "degree ratio", "normals ratio" }, machine);
    });
  }
  if (!degrees.empty())
    std::cout << papers::averages(degrees);
}

} // namespace

int main(int argc, char* argv[])
{
  const Arguments arguments = parsed(argc, argv);
  try {
    run(arguments);
  } catch (const std::exception& e) {
    std::cerr << e.what() << std::endl;
    return 1;
  }
  return 0;
}
