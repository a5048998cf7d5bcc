// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_COUNTED_ALLOCATION_H
#define TEST_COMPACT_SURFACE_MESH_COUNTED_ALLOCATION_H

// Replaces the global operators new and delete by ones that count bytes. To be included in
// one source file of a program only. For one thread.

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace test {

/// How many bytes the program asked operator new for.
class Counted_allocation
{
public:
  /// now in use
  static std::size_t live() { return m_live; }
  /// most in use at a time since reset_peak()
  static std::size_t peak() { return m_peak; }
  /// in the largest block since reset_peak()
  static std::size_t largest_block() { return m_largest_block; }
  static void reset_peak()
  {
    m_peak = m_live;
    m_largest_block = 0;
  }

  // In front of each block, as far as its alignment allows, stands its size.
  static void* allocate(std::size_t size, std::size_t alignment)
  {
    const std::size_t bytes = (size / alignment + 2) * alignment;
    void* const memory = bytes < size ? nullptr : std::aligned_alloc(alignment, bytes);
    if (memory == nullptr)
      throw std::bad_alloc();
    *static_cast<std::size_t*>(memory) = size;
    m_live += size;
    m_peak = (std::max)(m_peak, m_live);
    m_largest_block = (std::max)(m_largest_block, size);
    return static_cast<char*>(memory) + alignment;
  }

  static void release(void* block, std::size_t alignment)
  {
    if (block == nullptr)
      return;
    void* const memory = static_cast<char*>(block) - alignment;
    m_live -= *static_cast<std::size_t*>(memory);
    std::free(memory);
  }

private:
  static inline std::size_t m_live = 0, m_peak = 0, m_largest_block = 0;
};

} // namespace test

// The other forms of new and delete call these.
void* operator new(std::size_t size)
{
  return test::Counted_allocation::allocate(size, __STDCPP_DEFAULT_NEW_ALIGNMENT__);
}
void* operator new(std::size_t size, std::align_val_t alignment)
{
  return test::Counted_allocation::allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* block) noexcept
{
  test::Counted_allocation::release(block, __STDCPP_DEFAULT_NEW_ALIGNMENT__);
}
void operator delete(void* block, std::size_t) noexcept
{
  test::Counted_allocation::release(block, __STDCPP_DEFAULT_NEW_ALIGNMENT__);
}
void operator delete(void* block, std::align_val_t alignment) noexcept
{
  test::Counted_allocation::release(block, static_cast<std::size_t>(alignment));
}
void operator delete(void* block, std::size_t, std::align_val_t alignment) noexcept
{
  test::Counted_allocation::release(block, static_cast<std::size_t>(alignment));
}

#endif // TEST_COMPACT_SURFACE_MESH_COUNTED_ALLOCATION_H
