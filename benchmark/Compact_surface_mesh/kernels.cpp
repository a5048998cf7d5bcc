// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The kernels of speed.cpp under Google Benchmark, for its statistics, filters and counters: on
// one input, in random order of repetitions, since it cannot let functions take turns call by call.

#include "benchmark_inputs.h"
#include "positive_number.h"
#include "speed_comparison.h"

#include <CGAL/config.h>

#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace example;

[[noreturn]] void exit_with_usage()
{
  std::cerr << "kernels [BENCHMARK_FLAGS] [N [INPUT [MESH]]]\n"
               "  N      about how many vertices the mesh has, 100000 by default\n"
               "  INPUT  'natural order' by default, or another input of the program speed\n"
               "  MESH   the mesh that is subdivided, or sphere; by default CGAL's meshes/armadillo.off\n";
  std::exit(2);
}

Triangle_soup soup_of_input(std::size_t n, const std::string& name, const std::string& mesh)
{
  for (const auto& input : benchmark_inputs::all_inputs(n, mesh, mesh))
    if (input.name == name)
      return input.make();
  throw std::runtime_error("there is no input " + name);
}

void register_kernels(const Compared_mesh& mesh, std::size_t num_vertices)
{
  for (const Timed_kernel& kernel : mesh.kernels)
    benchmark::RegisterBenchmark(
        (kernel.name + ", " + kernel.way + '/' + mesh.name + ", " + mesh.order_name()).c_str(),
        [&kernel, num_vertices](benchmark::State& state) {
          const Timed_function function = kernel.prepare();
          for (auto _ : state)
            benchmark::DoNotOptimize(function());
          state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(num_vertices));
        });
}

void run(std::size_t n, const std::string& input, const std::string& mesh)
{
  const Triangle_soup soup = soup_of_input(n, input, mesh);
  const auto comparison = speed_comparison(soup, [](const std::string&) { return true; });
  benchmark::AddCustomContext("input", input + ", " + std::to_string(soup.points.size()) + " vertices");
  for (const Compared_mesh& m : comparison->meshes()) {
    benchmark::AddCustomContext("connectivity bytes per vertex of " + m.name + ", " + m.order_name(),
                                std::to_string(m.connectivity_bytes / static_cast<double>(soup.points.size())));
    register_kernels(m, soup.points.size());
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::ClearRegisteredBenchmarks();
}

} // namespace

int main(int argc, char* argv[])
{
  // what the command line says comes later and counts
  std::vector<std::string> words = { argv[0], "--benchmark_enable_random_interleaving=true",
                                     "--benchmark_repetitions=5", "--benchmark_report_aggregates_only=true" };
  words.insert(words.end(), argv + 1, argv + argc);
  std::vector<char*> arguments;
  for (std::string& word : words)
    arguments.push_back(&word[0]);
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  const unsigned long n = count > 1 ? positive_number(arguments[1]) : 100000;
  if (n == 0 || count > 4)
    exit_with_usage();
  try {
    run(n, count > 2 ? arguments[2] : "natural order",
        count > 3 ? arguments[3] : CGAL::data_file_path("meshes/armadillo.off"));
  } catch (const std::exception& e) {
    std::cerr << e.what() << std::endl;
    return 1;
  }
  return 0;
}
