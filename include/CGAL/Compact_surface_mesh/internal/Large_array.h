// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_INTERNAL_LARGE_ARRAY_H
#define CGAL_COMPACT_SURFACE_MESH_INTERNAL_LARGE_ARRAY_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <vector>

#ifdef __linux__
#  include <sys/mman.h>
#endif

namespace CGAL {
namespace internal {

constexpr std::size_t huge_page = std::size_t(1) << 21;

// Asks the system for huge pages behind what lies in `bytes` bytes from `begin` on and is not used yet.
// That is advice, which may be refused.
inline void ask_for_huge_pages(void* begin, std::size_t bytes)
{
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  const std::size_t before = (huge_page - reinterpret_cast<std::uintptr_t>(begin) % huge_page) % huge_page;
  if (bytes >= before + huge_page)
    madvise(static_cast<char*>(begin) + before, (bytes - before) / huge_page * huge_page, MADV_HUGEPAGE);
#else
  static_cast<void>(begin), static_cast<void>(bytes);
#endif
}

// Reserves memory for `n` elements of an empty std::vector, behind huge pages but for its ends.
template <class T>
void reserve_huge_pages(std::vector<T>& v, std::size_t n)
{
  v.reserve(n);
  ask_for_huge_pages(v.data(), n * sizeof(T));
}

// Asks the system for huge pages behind arrays that fill some. Without them, an array of ordinary pages costs
// a page fault for every 4 KiB when it is filled, and a miss of the address translation at most random accesses.
// Smaller arrays, and all where there are no huge pages, are those of std::allocator.
template <class T>
class Huge_page_allocator
{
  static constexpr std::size_t min_bytes = 2 * huge_page;

public:
  typedef T value_type;

  Huge_page_allocator() = default;
  template <class U>
  Huge_page_allocator(const Huge_page_allocator<U>&) noexcept
  {}

  T* allocate(std::size_t n)
  {
    if (n > (std::numeric_limits<std::size_t>::max)() / sizeof(T))
      throw std::bad_array_new_length();
    const std::size_t bytes = n * sizeof(T);
    if (!is_large(bytes))
      return std::allocator<T>().allocate(n);
    void* const memory = ::operator new(bytes, std::align_val_t(huge_page));
    ask_for_huge_pages(memory, bytes);
    return static_cast<T*>(memory);
  }

  void deallocate(T* p, std::size_t n) noexcept
  {
    if (is_large(n * sizeof(T)))
      ::operator delete(p, std::align_val_t(huge_page));
    else
      std::allocator<T>().deallocate(p, n);
  }

  friend bool operator==(const Huge_page_allocator&, const Huge_page_allocator&) { return true; }
  friend bool operator!=(const Huge_page_allocator&, const Huge_page_allocator&) { return false; }

private:
  static constexpr bool is_large(std::size_t bytes) { return bytes >= min_bytes; }
};

// A vector with as many elements as a mesh.
template <class T>
using Large_array = std::vector<T, Huge_page_allocator<T> >;

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_INTERNAL_LARGE_ARRAY_H
