// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Times of traversals in all layouts and in Surface_mesh, on large meshes of several kinds
// and orders, as ratios to Surface_mesh.
//
// Google Benchmark does not serve here: it runs one function after the other, and ratios want
// functions to take turns.

#include "../../examples/Compact_surface_mesh/comparison.h"
#include "positive_number.h"

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

namespace {

using namespace example;

struct Arguments
{
  std::size_t num_vertices = 1000000;
  int rounds = 5;
  bool csv = false;
  std::string mesh = "sphere"; // or a file
};

[[noreturn]] void exit_with_usage()
{
  std::cerr << "speed [N] [--mesh FILE] [--rounds R] [--csv]\n"
               "  N         about how many vertices the meshes have, 1000000 by default\n"
               "  --mesh    the mesh that is subdivided, in place of a sphere\n"
               "  --rounds  medians are taken of so many runs, 5 by default\n"
               "  --csv     prints comma-separated values\n";
  std::exit(2);
}

Arguments parsed(int argc, char* argv[])
{
  Arguments arguments;
  const auto number = [](const char* word) {
    const unsigned long n = positive_number(word);
    if (n == 0)
      exit_with_usage();
    return n;
  };
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool has_value = i + 1 < argc;
    if (word == "--csv")
      arguments.csv = true;
    else if (word == "--mesh" && has_value)
      arguments.mesh = argv[++i];
    else if (word == "--rounds" && has_value)
      arguments.rounds = static_cast<int>(number(argv[++i]));
    else
      arguments.num_vertices = number(argv[i]);
  }
  return arguments;
}

void print_machine()
{
  std::ifstream cpuinfo("/proc/cpuinfo");
  std::string line;
  while (std::getline(cpuinfo, line))
    if (line.rfind("model name", 0) == 0) {
      std::cout << "processor " << line.substr(line.find(':') + 1);
      break;
    }
  std::cout << "; caches";
#ifdef _SC_LEVEL1_DCACHE_SIZE
  const std::pair<const char*, int> caches[] = { { "L1d", _SC_LEVEL1_DCACHE_SIZE },
                                                 { "L2", _SC_LEVEL2_CACHE_SIZE },
                                                 { "L3", _SC_LEVEL3_CACHE_SIZE } };
  for (const auto& cache : caches)
    std::cout << ' ' << cache.first << ' ' << sysconf(cache.second) / 1024 << " KiB";
#endif
  std::cout << "\n\n";
}

// Prints one mesh's rows.
class Printer
{
public:
  Printer(const Arguments& arguments, const std::string& input, const Triangle_soup& soup, const Comparison& comparison)
    : m_csv(arguments.csv), m_input(input), m_num_vertices(soup.points.size()), m_comparison(comparison)
  {
    if (m_csv)
      return;
    std::cout << input << ", " << m_num_vertices << " vertices\n" << std::setw(first_width) << "";
    for (const Compared_mesh& m : comparison.meshes())
      std::cout << std::setw(width) << m.name;
    std::cout << '\n' << std::setw(first_width) << "ns per vertex  /input  /our";
    for (const Compared_mesh& m : comparison.meshes())
      std::cout << std::setw(width) << m.order;
    std::cout << '\n';
  }

  ~Printer()
  {
    if (!m_csv)
      std::cout << std::endl;
  }

  static void print_csv_heading()
  {
    std::cout << "input,vertices,kernel,way,structure,order,ns_per_vertex,ratio_to_input_order,ratio_to_our_order\n";
  }

  void operator()(const std::string& kernel, const std::string& way, const std::vector<Timing>& timings) const
  {
    if (!m_csv)
      std::cout << std::left << std::setw(first_width) << kernel + ", " + way << std::right;
    for (std::size_t i = 0; i < timings.size(); ++i) {
      std::ostringstream cell;
      const double s = timings[i].seconds;
      const char* const gap = m_csv ? "," : "  ";
      cell << std::fixed << std::setprecision(2) << s * 1e9 / static_cast<double>(m_num_vertices) << gap
           << s / timings[0].seconds << gap << s / timings[1].seconds;
      const Compared_mesh& m = m_comparison.meshes()[i];
      if (m_csv)
        std::cout << m_input << ',' << m_num_vertices << ',' << kernel << ',' << way << ',' << m.name << ',' << m.order
                  << ',' << cell.str() << '\n';
      else
        std::cout << std::setw(width) << cell.str();
    }
    if (!m_csv)
      std::cout << '\n';
    std::cout.flush();
  }

private:
  static const int first_width = 34, width = 22;

  bool m_csv;
  std::string m_input;
  std::size_t m_num_vertices;
  const Comparison& m_comparison;
};

void measure(const Arguments& arguments, const std::string& input, const Triangle_soup& soup)
{
  const Comparison comparison(
      soup, [](const std::string&) { return true; }, [](const std::string&) {});
  const Printer print(arguments, input, soup, comparison);
  for (std::size_t k = 0; k < kernel_names.size(); ++k)
    print(kernel_names[k], "stars", comparison.star_times(k, arguments.rounds));
  for (std::size_t k = 0; k < kernel_names.size(); ++k)
    print(kernel_names[k], "operators", comparison.operator_times(k, arguments.rounds));
  print(kernel_names[3], "Boost", comparison.boost_bfs_times(arguments.rounds));
}

void measure_all(const Arguments& arguments)
{
  if (arguments.csv)
    Printer::print_csv_heading();
  else
    print_machine();
  {
    const Triangle_soup soup = arguments.mesh == "sphere"
                                   ? sphere(arguments.num_vertices)
                                   : subdivided_to(read_soup(arguments.mesh), arguments.num_vertices);
    measure(arguments, "subdivided", soup);
    measure(arguments, "subdivided and shuffled", shuffled(soup, 1));
  }
  measure(arguments, "uniform random triangulation", random_soup(arguments.num_vertices, 1));
}

} // namespace

int main(int argc, char* argv[])
{
  const Arguments arguments = parsed(argc, argv);
  try {
    measure_all(arguments);
  } catch (const std::exception& e) {
    std::cerr << arguments.mesh << ": " << e.what() << std::endl;
    return 1;
  }
  return 0;
}
