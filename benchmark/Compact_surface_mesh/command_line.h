// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef BENCHMARK_COMPACT_SURFACE_MESH_COMMAND_LINE_H
#define BENCHMARK_COMPACT_SURFACE_MESH_COMMAND_LINE_H

// What the programs here are told: sizes, options and what is selected by regular expressions;
// and the files that they are told to write.

#include "positive_number.h"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <functional>
#include <ostream>
#include <regex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// An option `--name VALUE` and where its value is to be written.
using Text_option = std::pair<const char*, std::string*>;

/// reads `[N...] [--rounds R] [OPTIONS]`, and returns the numbers `N`.
/// \param exit_with_usage is called where the command line is wrong, and does not return
inline std::vector<std::size_t> read_command_line(int argc, char* argv[], const std::vector<Text_option>& options,
                                                  int& rounds, const std::function<void()>& exit_with_usage)
{
  std::vector<std::size_t> sizes;
  const auto number = [&](const char* word) {
    const unsigned long n = positive_number(word);
    if (n == 0)
      exit_with_usage();
    return n;
  };
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto option = std::find_if(options.begin(), options.end(), [&](const auto& o) { return word == o.first; });
    if (option == options.end() && word != "--rounds")
      sizes.push_back(number(argv[i]));
    else if (++i == argc)
      exit_with_usage();
    else if (word == "--rounds")
      rounds = static_cast<int>(number(argv[i]));
    else
      *option->second = argv[i];
  }
  return sizes;
}

/// returns whether a part of `name` matches the regular expression `pattern`; always if that is empty.
inline bool matches(const std::string& name, const std::string& pattern)
{
  return std::regex_search(name, std::regex(pattern));
}

/// calls `write(out)` with a stream to `file`, unless the name is empty.
/// \throws std::runtime_error if that cannot be written
template <class Write>
void write_file(const std::string& file, const Write& write)
{
  if (file.empty())
    return;
  std::ofstream out(file);
  write(out);
  out.close();
  if (!out)
    throw std::runtime_error("cannot write " + file);
}

#endif // BENCHMARK_COMPACT_SURFACE_MESH_COMMAND_LINE_H
