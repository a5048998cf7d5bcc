// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Times of whole algorithms of CGAL, of copying and of construction, in all structures and on
// all inputs, as ratios to Surface_mesh.

#include "all_layouts.h"
#include "end_to_end_kernels.h"
#include "other_structures.h"
#include "ratio_driver.h"

#include <memory>
#include <string>

int main(int argc, char* argv[])
{
  using namespace example;
  return ratio_driver::main(argc, argv, [](const Triangle_soup& soup, const Comparison::Selection& wants) {
    return std::make_unique<const Comparison>(soup, wants, [](const std::string&) {}, End_to_end(),
                                              All_layouts(), Other_structures());
  });
}
