// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// What laced rings are like on the meshes that are named, and what they cost: the columns of table 1 of
// T. Gurung, M. Luffel, P. Lindstrom, J. Rossignac, LR: Compact connectivity representation for triangle meshes, 2011.

#include "../../examples/Compact_surface_mesh/triangle_soup.h"
#include "papers_meshes.h"

#include <CGAL/Compact_surface_mesh/layouts/Laced_ring_layout.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <iomanip>
#include <iostream>
#include <string>

namespace {

template <class Layout>
Layout layout_of(const example::Triangle_soup& soup)
{
  CGAL::Input_images<> images;
  return Layout(CGAL::Closed_triangulation<>(CGAL::Corner_table<>(soup.points.size(), soup.triangles)), images);
}

// Prints the bits per triangle by the formula of section 8, and those of all that the layout allocates.
template <class Layout>
void print(const example::Triangle_soup& soup, double entries_per_reference)
{
  const Layout layout = layout_of<Layout>(soup);
  const CGAL::Laced_ring_counts c = layout.counts();
  const double n = static_cast<double>(layout.num_faces());
  const auto percentage = [n](std::size_t count) { return 100 * static_cast<double>(count) / n; };
  const double references = 2 * static_cast<double>(c.num_ring_vertices) / entries_per_reference
                            + static_cast<double>(6 * c.num_t0 + 3 * c.num_irregular + c.num_long
                                                  + c.num_isolated_vertices);
  std::size_t bytes = 0;
  for (const auto& array : layout.memory())
    bytes += array.second;
  std::cout << std::setw(8) << c.num_isolated_vertices << std::setw(7) << percentage(c.num_t0) << std::setw(7)
            << percentage(c.num_skipped_warts) << std::setw(7) << percentage(c.num_irregular) << std::setw(7)
            << percentage(c.num_long) << std::setw(8) << std::setprecision(3) << references / n << std::setw(8)
            << std::setprecision(2) << 32 * references / n << std::setw(8) << 8 * static_cast<double>(bytes) / n;
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc < 2) {
    std::cerr << "laced_rings MESH...\n"
                 "  MESH  sphere:N, random:N[:SEED] or a file\n"
                 "Prints of each: triangles, % of vertices with six of them; and for references and for offsets\n"
                 "of 16 bits: vertices off the ring, % of triangles that are T0, T0w, Ti, Tl, references and\n"
                 "bits a triangle, and bits in all\n";
    return 2;
  }
  for (int i = 1; i < argc; ++i)
    try {
      const example::Triangle_soup soup = example::soup_of_argument(argv[i]);
      const std::string name = argv[i];
      std::cout << std::left << std::setw(24) << name.substr(name.rfind('/') + 1) << std::right << std::setw(9)
                << soup.triangles.size() << std::fixed << std::setprecision(1) << std::setw(6)
                << papers::percentage_of_valence_6(soup) << std::setprecision(2) << " |";
      print<CGAL::Laced_ring_layout<> >(soup, 1);
      std::cout << " |";
      print<CGAL::Laced_ring_layout<std::uint32_t, std::uint16_t> >(soup, 2);
      std::cout << std::endl;
    } catch (const std::exception& e) {
      std::cerr << argv[i] << ": " << e.what() << std::endl;
      return 1;
    }
  return 0;
}
