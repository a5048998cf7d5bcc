// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The names of vertices, halfedges, edges and faces: one template for the four kinds.
//
// The namespace is not CGAL on purpose. Boost.Graph calls make_tuple() unqualified
// with descriptors as arguments (boyer_myrvold_planarity_test()), and argument
// dependent lookup would then find CGAL::make_tuple() as well.

#ifndef CGAL_COMPACT_SURFACE_MESH_DESCRIPTORS_H
#define CGAL_COMPACT_SURFACE_MESH_DESCRIPTORS_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/internal/Divided_index.h>

#include <CGAL/Handle_hash_function.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <ostream>
#include <type_traits>

namespace CGAL {

/*!
\ingroup PkgCompactSurfaceMeshRef
The names of vertices, halfedges, edges and faces of a `Compact_surface_mesh`, and the
iterators over them.
*/
namespace Compact_surface_mesh_descriptors {

/// \ingroup PkgCompactSurfaceMeshRef
/// The kind of vertices.
struct Vertex_tag
{
  /// returns `"vertex"`.
  static constexpr const char* name() { return "vertex"; }
};

/// \ingroup PkgCompactSurfaceMeshRef
/// The kind of halfedges.
struct Halfedge_tag
{
  /// returns `"halfedge"`.
  static constexpr const char* name() { return "halfedge"; }
};

/// \ingroup PkgCompactSurfaceMeshRef
/// The kind of faces.
struct Face_tag
{
  /// returns `"face"`.
  static constexpr const char* name() { return "face"; }
};

/// \ingroup PkgCompactSurfaceMeshRef
/// The kind of edges of which edge `e` has the halfedges `2e` and `2e+1`.
struct Edge_tag
{
  /// returns `"edge"`.
  static constexpr const char* name() { return "edge"; }
};

/// \ingroup PkgCompactSurfaceMeshRef
/// The kind of halfedges of a mesh each of whose vertices owns six: they keep their indices divided by six.
struct Divided_halfedge_tag
  : Halfedge_tag
{};

/// \ingroup PkgCompactSurfaceMeshRef
/// The kind of edges of a mesh with such halfedges.
struct Divided_edge_tag
  : Edge_tag
{};

/// \ingroup PkgCompactSurfaceMeshRef
/// The kind of edges whose numbers only the layout knows.
struct Listed_edge_tag
  : Edge_tag
{};

#ifndef DOXYGEN_RUNNING

template <class Tag, class Index>
class Descriptor;

template <class Index>
inline constexpr Index null_index = (std::numeric_limits<Index>::max)();

// The index of an element that exists, or one more.
template <class Index>
struct Valid_index
{
  Index value;
};

// What a descriptor stores, and how that becomes the index of an element.
template <class Tag, class Index>
class Descriptor_storage
{
public:
  constexpr Descriptor_storage() = default;
  explicit constexpr Descriptor_storage(Index i) : m_index(i) {}
  explicit constexpr Descriptor_storage(Valid_index<Index> i) : m_index(i.value) {}

  constexpr Index idx() const { return m_index; }
  constexpr Index name() const { return m_index; }
  constexpr Index key() const { return m_index; }
  constexpr bool is_valid() const { return m_index != null_index<Index>; }

protected:
  void advance(std::ptrdiff_t n) { m_index = static_cast<Index>(m_index + static_cast<Index>(n)); }

  void print(std::ostream& os) const { os << Tag::name()[0] << m_index; }

private:
  Index m_index = null_index<Index>;
};

template <class Index>
class Descriptor_storage<Divided_halfedge_tag, Index>
{
public:
  using Name = internal::Divided_index<Index>;

  constexpr Descriptor_storage() = default;
  explicit constexpr Descriptor_storage(Index i) : m_name(i) {}
  explicit constexpr Descriptor_storage(Valid_index<Index> i) : m_name(Name::of_valid(i.value)) {}
  explicit constexpr Descriptor_storage(Name name) : m_name(name) {}

  constexpr Index idx() const { return m_name; }
  constexpr Name name() const { return m_name; }
  constexpr Index key() const { return m_name.code(); }
  constexpr bool is_valid() const { return !m_name.is_null(); }

protected:
  void advance(std::ptrdiff_t n) { m_name = static_cast<Index>(idx() + static_cast<Index>(n)); }

  void print(std::ostream& os) const { os << 'h' << idx(); }

private:
  Name m_name;
};

// An edge stores the halfedge from which it was made, and its index is half of that.
// As for Surface_mesh, the null edge converts to half of the null index.
template <class Halfedge_, class Index>
class Edge_of_halfedge
{
public:
  using Halfedge = Halfedge_;

  constexpr Edge_of_halfedge() = default;
  // null_index / 2 is what the null edge converts to
  explicit constexpr Edge_of_halfedge(Index e)
    : m_halfedge(e < null_index<Index> / 2 ? static_cast<Index>(2 * e) : null_index<Index>) {}
  explicit constexpr Edge_of_halfedge(Valid_index<Index> e)
    : m_halfedge(Valid_index<Index>{ static_cast<Index>(2 * e.value) }) {}
  explicit constexpr Edge_of_halfedge(Halfedge h) : m_halfedge(h) {}

  constexpr Halfedge halfedge() const { return m_halfedge; }
  constexpr Index idx() const { return m_halfedge.idx() / 2; }
  constexpr Index key() const { return m_halfedge.key() / 2; }
  constexpr bool is_valid() const { return m_halfedge.is_valid(); }

protected:
  void advance(std::ptrdiff_t n) { m_halfedge += 2 * n; }

  void print(std::ostream& os) const { os << 'e' << idx() << " on " << m_halfedge; }

private:
  Halfedge m_halfedge;
};

template <class Index>
class Descriptor_storage<Edge_tag, Index>
  : public Edge_of_halfedge<Descriptor<Halfedge_tag, Index>, Index>
{
public:
  using Descriptor_storage::Edge_of_halfedge::Edge_of_halfedge;
};

template <class Index>
class Descriptor_storage<Divided_edge_tag, Index>
  : public Edge_of_halfedge<Descriptor<Divided_halfedge_tag, Index>, Index>
{
public:
  using Descriptor_storage::Edge_of_halfedge::Edge_of_halfedge;
};

// A listed edge stores both. Made from its index alone it knows no halfedge, and stands
// for the one that the layout keeps for the edge.
template <class Index>
class Descriptor_storage<Listed_edge_tag, Index>
{
public:
  using Halfedge = Descriptor<Halfedge_tag, Index>;

  constexpr Descriptor_storage() = default;
  explicit constexpr Descriptor_storage(Index e) : m_index(e) {}
  explicit constexpr Descriptor_storage(Valid_index<Index> e) : m_index(e.value) {}
  constexpr Descriptor_storage(Index e, Halfedge h) : m_index(e), m_halfedge(h.idx()) {}

  // null if the edge was made from its index alone
  constexpr Halfedge remembered_halfedge() const { return Halfedge(m_halfedge); }
  constexpr Index idx() const { return m_index; }
  constexpr Index key() const { return m_index; }
  constexpr bool is_valid() const { return m_index != null_index<Index>; }

protected:
  void advance(std::ptrdiff_t n)
  {
    m_index = static_cast<Index>(m_index + static_cast<Index>(n));
    m_halfedge = null_index<Index>;
  }

  void print(std::ostream& os) const
  {
    os << 'e' << m_index;
    if (m_halfedge != null_index<Index>)
      os << " on h" << m_halfedge;
  }

private:
  Index m_index = null_index<Index>;
  Index m_halfedge = null_index<Index>;
};

#endif // DOXYGEN_RUNNING

/*!
\ingroup PkgCompactSurfaceMeshRef

The class `Descriptor` names a vertex, a halfedge, an edge or a face of a
`Compact_surface_mesh` by its index, as the descriptors of `Surface_mesh` do. It does not
know the mesh: it names the element with that index in any mesh of the type.

<b>Indices.</b> The elements of a kind have the indices from 0 to their number less one. A
descriptor converts to its index.

<b>Null.</b> A default constructed descriptor names no element. It is the null descriptor of
its kind, and its index is the largest value of `Index`; only that of an edge whose kind is
`Edge_tag` or `Divided_edge_tag` is half of that. An index that is too large for a mesh with halfedges of kind
`Divided_halfedge_tag` may make it as well.

<b>Order and hash.</b> Descriptors of one kind are compared by their indices, the null
descriptor being the last, and are hashed by them, for \boost and the standard library.
Descriptors of different kinds can neither be compared nor converted.

<b>Edges.</b> An edge remembers from which of its two halfedges it was made, and
`Compact_surface_mesh::halfedge()` returns that one. Made from its index alone, it stands
for the same halfedge always. Comparison, order and hash ignore what it remembers.

\tparam Tag says of which kind the element is: `Vertex_tag` or `Face_tag`, or, depending on the
layout, `Halfedge_tag` with `Edge_tag` or `Listed_edge_tag`, or `Divided_halfedge_tag` with `Divided_edge_tag`
\tparam Index an unsigned integer type

\cgalModels{Index, LessThanComparable, Hashable}
*/
template <class Tag, class Index>
class Descriptor
#ifndef DOXYGEN_RUNNING
  : public Descriptor_storage<Tag, Index>
#endif
{
  using Storage = Descriptor_storage<Tag, Index>;

public:
  /// the type of the index.
  using size_type = Index;

#ifndef DOXYGEN_RUNNING
  using tag = Tag;
#endif

  /// creates the null descriptor.
  constexpr Descriptor() = default;

#ifdef DOXYGEN_RUNNING
  /// creates the descriptor of the element with index `i`.
  explicit Descriptor(size_type i);

  /// creates the descriptor of the edge of `h`, which remembers `h`. Not for the kind `Listed_edge_tag`; if the kind
  /// is `Divided_edge_tag`, that of `h` is `Divided_halfedge_tag`.
  explicit Descriptor(Descriptor<Halfedge_tag, Index> h);

  /// creates the descriptor of the edge with index `e`, which remembers its halfedge `h`. Only
  /// for the kind `Listed_edge_tag`.
  Descriptor(size_type e, Descriptor<Halfedge_tag, Index> h);

  /// returns the halfedge that the edge remembers. Not for the kind `Listed_edge_tag`.
  Descriptor<Halfedge_tag, Index> halfedge() const;

  /// returns the halfedge that the edge remembers, null if it was made from its index alone.
  /// Only for the kind `Listed_edge_tag`.
  Descriptor<Halfedge_tag, Index> remembered_halfedge() const;

  /// returns the index of the element.
  size_type idx() const;

  /// returns whether this is not the null descriptor.
  bool is_valid() const;
#else
  using Storage::Storage;
  using Storage::idx;
  using Storage::is_valid;

  template <class Other_tag, class Other_index>
  explicit Descriptor(const Descriptor<Other_tag, Other_index>&) = delete;
#endif

  /// returns the index of the element.
  constexpr size_type id() const { return idx(); }

  /// returns the index of the element.
  constexpr operator size_type() const { return idx(); }

  /// makes this the null descriptor.
  void reset() { *this = Descriptor(); }

  /// \name Stepping
  /// to the elements with the next and previous indices, whether they exist or not.
  /// @{

  /// steps forward.
  Descriptor& operator++() { this->advance(1); return *this; }
  /// steps backward.
  Descriptor& operator--() { this->advance(-1); return *this; }
  /// steps forward and returns where it was.
  Descriptor operator++(int) { Descriptor old(*this); ++*this; return old; }
  /// steps backward and returns where it was.
  Descriptor operator--(int) { Descriptor old(*this); --*this; return old; }
  /// steps forward `n` times; backward if `n` is negative.
  Descriptor& operator+=(std::ptrdiff_t n) { this->advance(n); return *this; }
  /// @}

  /// \name Comparison
  /// @{

  /// returns whether `a` and `b` are the same element, or null both.
  friend constexpr bool operator==(const Descriptor& a, const Descriptor& b) { return a.key() == b.key(); }
  /// returns whether `a` and `b` differ.
  friend constexpr bool operator!=(const Descriptor& a, const Descriptor& b) { return a.key() != b.key(); }
  /// returns whether the index of `a` is smaller than that of `b`.
  friend constexpr bool operator<(const Descriptor& a, const Descriptor& b) { return a.key() < b.key(); }

#ifndef DOXYGEN_RUNNING
  template <class T> friend bool operator==(const Descriptor&, const T&) = delete;
  template <class T> friend bool operator!=(const Descriptor&, const T&) = delete;
  template <class T> friend bool operator<(const Descriptor&, const T&) = delete;
#endif
  /// @}

  /// returns the hash value of `d`, for Boost.
  friend std::size_t hash_value(const Descriptor& d) { return static_cast<std::size_t>(d.idx()); }

  /// prints `d` as `v3`, `h5`, `f2` or `e4 on h8`.
  friend std::ostream& operator<<(std::ostream& os, const Descriptor& d)
  {
    d.print(os);
    return os;
  }
};

#ifndef DOXYGEN_RUNNING
// The descriptors of a mesh, by what names halfedges in its layout, and by whether edges are numbered
// by halves of these.
template <class Index, class Halfedge_name, bool edge_is_half_of_halfedge>
struct Descriptors
{
  using Vertex_index = Descriptor<Vertex_tag, Index>;
  using Halfedge_index = Descriptor<Halfedge_tag, Index>;
  using Edge_index = Descriptor<std::conditional_t<edge_is_half_of_halfedge, Edge_tag, Listed_edge_tag>, Index>;
  using Face_index = Descriptor<Face_tag, Index>;
};

template <class Index>
struct Descriptors<Index, internal::Divided_index<Index>, true>
{
  using Vertex_index = Descriptor<Vertex_tag, Index>;
  using Halfedge_index = Descriptor<Divided_halfedge_tag, Index>;
  using Edge_index = Descriptor<Divided_edge_tag, Index>;
  using Face_index = Descriptor<Face_tag, Index>;
};
#endif

} // namespace Compact_surface_mesh_descriptors

#ifndef DOXYGEN_RUNNING
namespace internal {
namespace handle {

template <class Tag, class Index>
struct Hash_functor<Compact_surface_mesh_descriptors::Descriptor<Tag, Index> >
{
  std::size_t operator()(const Compact_surface_mesh_descriptors::Descriptor<Tag, Index>& d) const
  {
    return hash_value(d);
  }
};

} // namespace handle
} // namespace internal
#endif

} // namespace CGAL

#ifndef DOXYGEN_RUNNING
namespace std {

template <class Tag, class Index>
struct hash<CGAL::Compact_surface_mesh_descriptors::Descriptor<Tag, Index> >
{
  std::size_t operator()(const CGAL::Compact_surface_mesh_descriptors::Descriptor<Tag, Index>& d) const
  {
    return hash_value(d);
  }
};

} // namespace std
#endif

#endif // CGAL_COMPACT_SURFACE_MESH_DESCRIPTORS_H
