// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Builds one mesh from a soup and says how long that takes. One process builds one type, so
// that its peak memory and its instructions can be measured from outside: see run_construction.

#include "all_layouts.h"

#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <iomanip>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace example;

[[noreturn]] void exit_with_usage()
{
  std::cerr << "construction TYPE MESH [--stages] | construction --soup-only MESH\n"
               "  TYPE         surface-mesh";
  for_each_layout(All_layouts(), [](auto type) { std::cerr << ", " << decltype(type)::type::name(); });
  std::cerr << "\n"
               "  MESH         sphere:N, random:N[:SEED] or a file\n"
               "  --stages     builds a layout step by step, with points in an array beside it, and times each\n"
               "  --soup-only  makes the soup and builds nothing: what is to be subtracted\n"
               "Processor times are in ns per vertex.\n";
  std::exit(2);
}

// Prints the processor time since it was last asked, in ns per vertex.
class Stopwatch
{
public:
  explicit Stopwatch(std::size_t num_vertices) : m_num_vertices(num_vertices), m_start(std::clock()) {}

  void print(const std::string& stage)
  {
    const double seconds = static_cast<double>(std::clock() - m_start) / CLOCKS_PER_SEC;
    std::cout << std::left << std::setw(24) << stage << std::right << std::fixed << std::setprecision(1)
              << std::setw(10) << 1e9 * seconds / static_cast<double>(m_num_vertices) << '\n';
    m_start = std::clock();
  }

private:
  std::size_t m_num_vertices;
  std::clock_t m_start;
};

template <class Layout>
void build_by_stages(const Triangle_soup& soup)
{
  using Index = typename Layout::Index;
  Stopwatch stopwatch(soup.points.size());
  CGAL::Corner_table<Index> table(soup.points.size(), soup.triangles);
  stopwatch.print("corner table");
  CGAL::Closed_triangulation<Index> closed(std::move(table));
  stopwatch.print("closing");
  CGAL::Input_images<Index> images;
  const Layout layout(std::move(closed), images);
  stopwatch.print("layout, wood included");
  std::vector<Point> points(soup.points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    points[images.vertices[i]] = soup.points[i];
  stopwatch.print("points");
}

template <class Build>
void build(const Triangle_soup& soup, const Build& build_mesh)
{
  Stopwatch stopwatch(soup.points.size());
  const auto mesh = build_mesh(soup);
  stopwatch.print("all");
  if (num_vertices(mesh) != soup.points.size())
    throw std::logic_error("vertices are missing");
}

// Returns whether there is such a type.
bool build(const std::string& name, const Triangle_soup& soup, bool stages)
{
  bool found = name == "surface-mesh";
  if (found)
    build(soup, surface_mesh_of);
  for_each_layout(All_layouts(), [&](auto type) {
    using Layout = typename decltype(type)::type;
    if (name != Layout::name())
      return;
    found = true;
    if (stages)
      build_by_stages<Layout>(soup);
    else
      build(soup, [](const Triangle_soup& s) {
        return CGAL::Compact_surface_mesh<Point, Layout>(s.points, s.triangles);
      });
  });
  return found;
}

} // namespace

int main(int argc, char* argv[])
{
  const bool stages = argc == 4 && argv[3] == std::string("--stages");
  if (argc != 3 && !stages)
    exit_with_usage();
  try {
    const Triangle_soup soup = soup_of_argument(argv[2]);
    if (argv[1] == std::string("--soup-only"))
      std::cout << soup.points.size() << " vertices\n";
    else if (!build(argv[1], soup, stages))
      exit_with_usage();
  } catch (const std::exception& e) {
    std::cerr << argv[2] << ": " << e.what() << std::endl;
    return 1;
  }
  return 0;
}
