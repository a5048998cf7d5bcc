// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef BENCHMARK_COMPACT_SURFACE_MESH_MACHINE_H
#define BENCHMARK_COMPACT_SURFACE_MESH_MACHINE_H

#include <fstream>
#include <sstream>
#include <string>
#include <utility>

#include <unistd.h>

/// returns the name of the processor and the sizes of its caches, as far as the system tells.
inline std::string machine_description()
{
  std::ostringstream out;
  std::ifstream cpuinfo("/proc/cpuinfo");
  std::string line;
  while (std::getline(cpuinfo, line))
    if (line.rfind("model name", 0) == 0) {
      out << "processor" << line.substr(line.find(':') + 1) << "; ";
      break;
    }
  out << "caches";
#ifdef _SC_LEVEL1_DCACHE_SIZE
  const std::pair<const char*, int> caches[] = { { "L1d", _SC_LEVEL1_DCACHE_SIZE },
                                                 { "L2", _SC_LEVEL2_CACHE_SIZE },
                                                 { "L3", _SC_LEVEL3_CACHE_SIZE } };
  for (const auto& cache : caches)
    out << ' ' << cache.first << ' ' << sysconf(cache.second) / 1024 << " KiB";
#endif
  return out.str();
}

#endif // BENCHMARK_COMPACT_SURFACE_MESH_MACHINE_H
