// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_TEMPORARY_FILE_H
#define TEST_COMPACT_SURFACE_MESH_TEMPORARY_FILE_H

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <system_error>

namespace test {

/// The name of a file that goes with this object. There is no such file yet.
class Temporary_file
{
public:
  /// `ending` is that of the name, as in ".off".
  explicit Temporary_file(const std::string& ending)
  {
    static std::random_device random;
    do
      m_path = std::filesystem::temp_directory_path()
               / ("compact_surface_mesh_" + std::to_string(random()) + std::to_string(random()) + ending);
    while (std::filesystem::exists(m_path));
  }

  Temporary_file(const Temporary_file&) = delete;
  Temporary_file& operator=(const Temporary_file&) = delete;

  ~Temporary_file()
  {
    std::error_code ignored;
    std::filesystem::remove(m_path, ignored);
  }

  std::string name() const { return m_path.string(); }

  std::string bytes() const
  {
    std::ifstream is(m_path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(is), std::istreambuf_iterator<char>());
  }

  void set_bytes(const std::string& bytes) const { std::ofstream(m_path, std::ios::binary) << bytes; }

private:
  std::filesystem::path m_path;
};

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_TEMPORARY_FILE_H
