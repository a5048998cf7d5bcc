// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// In a file of its own since two programs use it and it takes minutes to compile.

#include "speed_comparison.h"

#include "all_layouts.h"
#include "operator_kernels.h"
#include "other_structures.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

using namespace example;

namespace {

struct Traversals_and_operators
{
  template <class Structure, class Labeled>
  std::vector<Timed_kernel> operator()(Type<Structure>, const std::shared_ptr<const Labeled>& labeled,
                                       const Triangle_soup&) const
  {
    std::vector<Timed_kernel> kernels = traversals(labeled);
    for (Timed_kernel& kernel : operator_kernels(labeled))
      kernels.push_back(std::move(kernel));
    return kernels;
  }
};

} // namespace

std::unique_ptr<const Comparison> speed_comparison(const Triangle_soup& soup, const Comparison::Selection& wants)
{
  return std::make_unique<const Comparison>(soup, wants, [](const std::string&) {}, Traversals_and_operators(),
                                            All_layouts(), Other_structures());
}
