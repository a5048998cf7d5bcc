// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_DESCRIPTOR_ITERATOR_H
#define CGAL_COMPACT_SURFACE_MESH_DESCRIPTOR_ITERATOR_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/descriptors.h>

#include <CGAL/Iterator_range.h>

#include <boost/iterator/iterator_facade.hpp>

#include <cstddef>
#include <iterator>

namespace CGAL {

namespace Compact_surface_mesh_descriptors {

/*!
\ingroup PkgCompactSurfaceMeshRef

A random access iterator over all elements of one kind, in the order of their indices.
It knows the element only, not the mesh, and is dereferenced by value: so references
to what it yields can be kept, and it can be reversed.

\tparam Descriptor the type of the elements: a \ref Compact_surface_mesh_descriptors::Descriptor "Descriptor"
*/
template <class Descriptor>
class Descriptor_iterator
#ifndef DOXYGEN_RUNNING
  : public boost::iterator_facade<Descriptor_iterator<Descriptor>, const Descriptor,
                                  std::random_access_iterator_tag, Descriptor>
#endif
{
  using Index = typename Descriptor::size_type;

public:
  /// creates an iterator that must be assigned to before use.
  Descriptor_iterator() = default;

  /// creates the iterator that yields `d`.
  explicit Descriptor_iterator(Descriptor d) : m_index(d.idx()) {}

  /// returns the element that comes `n` elements later.
  Descriptor operator[](std::ptrdiff_t n) const { return *(*this + n); }

private:
  friend class boost::iterator_core_access;

  void increment() { ++m_index; }
  void decrement() { --m_index; }
  void advance(std::ptrdiff_t n) { m_index = static_cast<Index>(m_index + static_cast<Index>(n)); }
  bool equal(const Descriptor_iterator& other) const { return m_index == other.m_index; }
  Descriptor dereference() const { return Descriptor(Valid_index<Index>{ m_index }); }
  std::ptrdiff_t distance_to(const Descriptor_iterator& other) const
  {
    return static_cast<std::ptrdiff_t>(other.m_index) - static_cast<std::ptrdiff_t>(m_index);
  }

  Index m_index = Descriptor().idx();
};

#ifndef DOXYGEN_RUNNING
// The elements with indices from 0 to n-1.
template <class Descriptor>
Iterator_range<Descriptor_iterator<Descriptor> > first_descriptors(std::size_t n)
{
  using Iterator = Descriptor_iterator<Descriptor>;
  using Index = typename Descriptor::size_type;
  return CGAL::make_range(Iterator(Descriptor(Index(0))), Iterator(Descriptor(static_cast<Index>(n))));
}
#endif

} // namespace Compact_surface_mesh_descriptors

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_DESCRIPTOR_ITERATOR_H
