// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// A clock that stands still, for programs that are compared by what they write: those that print times, and
// those whose random numbers start from the time. Calls from the program come here and not to the C library.

#include <sys/resource.h>
#include <sys/time.h>

#include <ctime>

extern "C" std::time_t time(std::time_t* result) noexcept
{
  const std::time_t now = 20221028;
  if (result != nullptr)
    *result = now;
  return now;
}

extern "C" int gettimeofday(timeval* result, void*) noexcept
{
  *result = timeval();
  return 0;
}

extern "C" int getrusage(__rusage_who_t, rusage* result) noexcept
{
  *result = rusage();
  return 0;
}
