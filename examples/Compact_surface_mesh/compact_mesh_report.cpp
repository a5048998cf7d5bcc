// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Compares Compact_surface_mesh with Surface_mesh on a mesh of yours: memory, time, and
// whether the algorithms of CGAL and Boost give the same answers on both.

#include "cgal_answers.h"
#include "comparison.h"
#include "schnyder_embedding.h"
#include "schnyder_svg.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace example;

const int rounds = 5;

struct Arguments
{
  std::string mesh;
  std::string layout = CGAL::Schnyder_parents_layout<>::name();
  std::string svg;
};

std::string layout_names()
{
  std::string names;
  for_each_layout(Layouts(), [&](auto type) { names += decltype(type)::type::name() + ' '; });
  return names + "all";
}

[[noreturn]] void exit_with_usage()
{
  std::cerr << "compact_mesh_report MESH [--layout NAME|all] [--svg FILE]\n"
               "  MESH      an OFF, PLY, OBJ or STL file with a oriented triangle mesh,\n"
               "            sphere or sphere:N (a sphere of about N vertices),\n"
               "            or random:N[:SEED] (a uniform random triangulation of N vertices)\n"
               "  --layout  which layouts to compare: "
            << layout_names()
            << "\n"
               "  --svg     draws a Schnyder wood of MESH, which should be small, to FILE\n";
  std::exit(2);
}

Arguments parsed(int argc, char* argv[])
{
  Arguments arguments;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--layout" || word == "--svg") {
      if (++i == argc)
        exit_with_usage();
      (word == "--svg" ? arguments.svg : arguments.layout) = argv[i];
    } else if (word.empty() || word[0] == '-' || !arguments.mesh.empty())
      exit_with_usage();
    else
      arguments.mesh = word;
  }
  if (arguments.mesh.empty() || (' ' + layout_names() + ' ').find(' ' + arguments.layout + ' ') == std::string::npos)
    exit_with_usage();
  return arguments;
}

// One line a step, with the time since the start of the program.
void show_progress(const std::string& step)
{
  static const auto start = std::chrono::steady_clock::now();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  std::cerr << std::fixed << std::setprecision(2) << std::setw(8) << elapsed.count() << " s  " << step << std::endl;
}

/// \name Table
/// @{

struct Construction_and_traversals
{
  template <class Structure, class Labeled>
  std::vector<Timed_kernel> operator()(Type<Structure>, const std::shared_ptr<const Labeled>& labeled,
                                       const Triangle_soup& soup) const
  {
    std::vector<Timed_kernel> kernels = traversals(labeled);
    kernels.push_back(construction_from_soup<Structure>(soup));
    return kernels;
  }
};

const int first_width = 31, width = 21;

// The width of the column of a mesh.
int width_for(const std::string& name) { return (std::max)(width, static_cast<int>(name.size()) + 2); }

std::string fixed(double x, int digits)
{
  std::ostringstream out;
  out << std::fixed << std::setprecision(digits) << x;
  return out.str();
}

void print_row(const Comparison& comparison, const std::string& name, const std::vector<std::string>& cells)
{
  std::cout << std::left << std::setw(first_width) << name << std::right;
  for (std::size_t i = 0; i < cells.size(); ++i)
    std::cout << std::setw(width_for(comparison.meshes()[i].name)) << cells[i];
  std::cout << '\n';
}

// Time, and its ratio to both times of Surface_mesh.
void print_times(const Comparison& comparison, const std::string& name, const std::vector<Timing>& timings,
                 double scale)
{
  std::vector<std::string> cells;
  for (const Timing& t : timings)
    cells.push_back(fixed(t.seconds * scale, 1) + "  " + fixed(t.seconds / timings[0].seconds, 2) + "  " +
                    fixed(t.seconds / timings[1].seconds, 2));
  print_row(comparison, name, cells);
}

template <class Cell>
std::vector<std::string> cells_of(const Comparison& comparison, const Cell& cell)
{
  std::vector<std::string> cells;
  for (const Compared_mesh& m : comparison.meshes())
    cells.push_back(cell(m));
  return cells;
}

void print_table(const Triangle_soup& soup, const Comparison& comparison)
{
  const double n = static_cast<double>(soup.points.size());
  print_row(comparison, "", cells_of(comparison, [](const Compared_mesh& m) { return m.name; }));
  print_row(comparison, "", cells_of(comparison, [](const Compared_mesh& m) { return m.order_name(); }));
  print_row(comparison, "references per vertex",
            cells_of(comparison, [=](const Compared_mesh& m) { return fixed(m.connectivity_bytes / 4 / n, 2); }));
  print_row(comparison, "connectivity bytes per vertex",
            cells_of(comparison, [=](const Compared_mesh& m) { return fixed(m.connectivity_bytes / n, 2); }));
  print_row(comparison, "times, as ns per vertex",
            std::vector<std::string>(comparison.meshes().size(), "ns  /input  /our"));
  for (const std::string way : { "call", "stars", "ranges", "circulators", "operators", "Boost" }) {
    std::cout << way << '\n';
    for (std::size_t k = 0; k < comparison.kernels().size(); ++k)
      if (comparison.kernels()[k].way == way)
        print_times(comparison, "  " + comparison.kernels()[k].name, comparison.times(k, rounds), 1e9 / n);
  }
  std::cout << "\nMedians of " << rounds << " interleaved runs; /input, /our: ratios to Surface_mesh in the order of "
               "the input, and\nin the order of our parents layouts. Surface_mesh has no stars: it is timed one "
               "operator at a time.\n\n";
}

/// @}

/// \name Algorithms
/// @{

template <class Layout>
void compare_answers(const Triangle_soup& soup)
{
  show_progress("running algorithms of CGAL and Boost on Surface_mesh");
  const Surface_mesh surface_mesh = surface_mesh_of(soup);
  const std::vector<Answer> expected = cgal_answers<Kernel>(surface_mesh, Surface_mesh::Vertex_index(0));
  show_progress("running algorithms of CGAL and Boost on " + Layout::name());
  std::vector<typename CGAL::Compact_surface_mesh<Point, Layout>::Vertex_index> image(soup.points.size());
  const CGAL::Compact_surface_mesh<Point, Layout> mesh(
      soup.points, soup.triangles, CGAL::parameters::vertex_to_vertex_map(CGAL::make_property_map(image)));
  const std::vector<Answer> answers = cgal_answers<Kernel>(mesh, image[0]);

  const int question_width = 50, answer_width = width_for(Layout::name());
  std::cout << std::left << std::setw(question_width) << "algorithms" << std::right << std::setw(width)
            << "Surface_mesh" << std::setw(answer_width) << Layout::name() << std::setw(14) << "ms" << std::setw(10) << "ms"
            << '\n';
  for (std::size_t i = 0; i < answers.size(); ++i)
    std::cout << std::left << std::setw(question_width) << answers[i].question << std::right << std::setprecision(12)
              << std::defaultfloat << std::setw(width) << expected[i].value << std::setw(answer_width) << answers[i].value
              << std::fixed << std::setprecision(2) << std::setw(14) << 1000 * expected[i].seconds << std::setw(10)
              << 1000 * answers[i].seconds << '\n';
}

/// @}

void draw(const Triangle_soup& soup, const std::string& file)
{
  show_progress("drawing a Schnyder wood to " + file);
  std::ofstream out(file);
  write_schnyder_wood(out, CGAL::Compact_surface_mesh<Point>(soup.points, soup.triangles));
  out.close();
  if (!out)
    throw std::runtime_error("cannot write " + file);
}

void report(const Arguments& arguments)
{
  show_progress("reading " + arguments.mesh);
  Triangle_soup soup = soup_of_argument(arguments.mesh);
  if (arguments.mesh.rfind("random:", 0) == 0)
    embed(soup);
  const auto wants = [&](const std::string& name) { return arguments.layout == "all" || name == arguments.layout; };
  const std::size_t v = soup.points.size(), f = soup.triangles.size();
  {
    const Comparison comparison(soup, wants, show_progress, Construction_and_traversals(), Layouts());
    std::cout << arguments.mesh << ": " << v << " vertices, " << f << " faces\n\n";
    print_table(soup, comparison);
  }
  bool is_first = true;
  for_each_layout(Layouts(), [&](auto type) {
    using Layout = typename decltype(type)::type;
    if (is_first && wants(Layout::name())) {
      is_first = false;
      compare_answers<Layout>(soup);
    }
  });
  if (!arguments.svg.empty())
    draw(soup, arguments.svg);
  show_progress("done");
}

} // namespace

int main(int argc, char* argv[])
{
  const Arguments arguments = parsed(argc, argv);
  try {
    report(arguments);
  } catch (const std::exception& e) {
    std::cerr << arguments.mesh << ": " << e.what() << std::endl;
    return 1;
  }
  return 0;
}
