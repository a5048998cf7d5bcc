// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef COMPACT_SURFACE_MESH_EXAMPLES_INTERLEAVED_TIMES_H
#define COMPACT_SURFACE_MESH_EXAMPLES_INTERLEAVED_TIMES_H

// Times that can be compared: all candidates run in turn, again and again, so that what
// else the machine does meets them alike. It is processor time that is taken, for the same
// reason.

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <functional>
#include <vector>

namespace example {

/// What is timed: a function that returns its result.
using Timed_function = std::function<double()>;

struct Timing
{
  double seconds; // the median
  double result;
};

inline double seconds_of(const Timed_function& function, std::size_t calls, double& result)
{
  const std::clock_t start = std::clock();
  for (std::size_t i = 0; i < calls; ++i)
    result = function();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / static_cast<double>(calls);
}

/// runs each of `functions` once to warm up and then `rounds` times. A function that takes
/// less than 5 ms is called several times a round. An empty function gets zeros.
inline std::vector<Timing> interleaved_times(const std::vector<Timed_function>& functions, int rounds = 5)
{
  std::vector<Timing> timings(functions.size(), Timing{ 0, 0 });
  std::vector<std::size_t> calls(functions.size(), 1);
  std::vector<std::vector<double> > seconds(functions.size());
  for (int round = -1; round < rounds; ++round)
    for (std::size_t i = 0; i < functions.size(); ++i) {
      if (!functions[i])
        continue;
      const double s = seconds_of(functions[i], calls[i], timings[i].result);
      if (round < 0)
        calls[i] = s < 0.005 ? static_cast<std::size_t>(0.005 / (s + 1e-7)) + 1 : 1;
      else
        seconds[i].push_back(s);
    }
  for (std::size_t i = 0; i < functions.size(); ++i)
    if (!seconds[i].empty()) {
      const auto median = seconds[i].begin() + seconds[i].size() / 2;
      std::nth_element(seconds[i].begin(), median, seconds[i].end());
      timings[i].seconds = *median;
    }
  return timings;
}

} // namespace example

#endif // COMPACT_SURFACE_MESH_EXAMPLES_INTERLEAVED_TIMES_H
