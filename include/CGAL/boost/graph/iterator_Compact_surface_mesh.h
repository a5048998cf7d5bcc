// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Makes Compact_surface_mesh a model of HalfedgeListGraph and FaceListGraph, and of the
// concepts of Boost.Graph on which these stand. There is no function of the mutable
// concepts, so that concept checks tell the truth.

#ifndef CGAL_BOOST_GRAPH_ITERATOR_COMPACT_SURFACE_MESH_H
#define CGAL_BOOST_GRAPH_ITERATOR_COMPACT_SURFACE_MESH_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Compact_surface_mesh_fwd.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/circulator_bases.h>

#include <boost/config.hpp>

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>

#ifndef DOXYGEN_RUNNING

// CGAL's iterators and circulators around vertices and faces, specialized: they do the same, but all of it is
// inlined. A step takes some hundred bytes of code, and compilers call what is so large, with the
// iterator in memory.

namespace CGAL {
namespace internal {

// Where an iterator stands, and how often it came back to the halfedge where it started. Circulators do not count.

template <class Mesh>
using Halfedge_step = typename Mesh::Halfedge_index (Mesh::*)(typename Mesh::Halfedge_index) const;

template <class Mesh, bool counts, Halfedge_step<Mesh> next, Halfedge_step<Mesh> prev>
class At_halfedge
{
  using Halfedge = typename Mesh::Halfedge_index;

public:
  At_halfedge() = default;
  BOOST_FORCEINLINE At_halfedge(Halfedge h, const Mesh&, unsigned round)
    : m_halfedge(h), m_start(h), m_round(h.is_valid() ? round : 1)
  {}

  BOOST_FORCEINLINE Halfedge halfedge() const { return m_halfedge; }
  BOOST_FORCEINLINE bool equals(const Mesh&, const At_halfedge& other) const
  {
    return (!counts || m_round == other.m_round) && m_halfedge == other.m_halfedge;
  }

  BOOST_FORCEINLINE void advance(const Mesh& g)
  {
    m_halfedge = (g.*next)(m_halfedge);
    if (counts && m_halfedge == m_start)
      ++m_round;
  }

  void retreat(const Mesh& g)
  {
    if (counts && m_halfedge == m_start)
      --m_round;
    m_halfedge = (g.*prev)(m_halfedge);
  }

private:
  Halfedge m_halfedge, m_start;
  unsigned m_round = 0;
};

template <class Mesh, bool counts>
using Around_target = At_halfedge<Mesh, counts, &Mesh::next_around_target, &Mesh::prev_around_target>;
template <class Mesh, bool counts>
using Around_source = At_halfedge<Mesh, counts, &Mesh::next_around_source, &Mesh::prev_around_source>;
template <class Mesh, bool counts>
using Around_face = At_halfedge<Mesh, counts, &Mesh::next, &Mesh::prev>;

// In a triangle all three vertices are read at once, and every step is a third of a round. Around other faces
// the position is that of their sides; this part is called, so that the rest is small enough to be
// inlined. Loops around triangles are unrolled: they count from a constant to a constant, and compare nothing else.
template <class Mesh, bool counts>
class Around_face_vertices
{
  using Halfedge = typename Mesh::Halfedge_index;
  using Vertex = typename Mesh::Vertex_index;

public:
  Around_face_vertices() = default;
  BOOST_FORCEINLINE Around_face_vertices(Halfedge h, const Mesh& g, unsigned round)
    : m_halfedge(h), m_start(h), m_thirds(3 * round)
  {
    if (m_thirds == 0)
      read(g, is_in_triangle(g));
  }

  BOOST_FORCEINLINE Vertex vertex() const { return m_vertex; }

  BOOST_FORCEINLINE bool equals(const Mesh& g, const Around_face_vertices& other) const
  {
    if (BOOST_LIKELY(m_was_in_triangle && m_start == other.m_start))
      return m_thirds == other.m_thirds;
    return is_same(g, *this, other);
  }

  BOOST_FORCEINLINE void advance(const Mesh& g)
  {
    if (BOOST_LIKELY(m_was_in_triangle)) {
      m_thirds = counts || m_thirds < 2 ? m_thirds + 1 : 0;
      const Vertex first = m_vertex;
      m_vertex = m_second;
      m_second = m_third;
      m_third = first;
    } else {
      m_halfedge = called_next(g, m_halfedge);
      m_vertex = called_target(g, m_halfedge);
      if (counts && m_halfedge == m_start)
        m_thirds += 3;
    }
  }

  void retreat(const Mesh& g)
  {
    const bool in_triangle = is_in_triangle(g);
    if (in_triangle)
      m_thirds = counts || m_thirds > 0 ? m_thirds - 1 : 2;
    else {
      if (counts && m_halfedge == m_start)
        m_thirds -= 3;
      m_halfedge = g.prev(m_halfedge);
    }
    read(g, in_triangle);
  }

private:
  BOOST_FORCEINLINE bool is_in_triangle(const Mesh& g) const { return g.layout().is_in_triangle(m_start.name()); }

  BOOST_FORCEINLINE void read(const Mesh& g, bool in_triangle)
  {
    m_was_in_triangle = in_triangle;
    if (BOOST_LIKELY(in_triangle)) {
      const auto v = g.layout().vertices_of_triangle(m_start.name());
      m_vertex = Vertex(v[m_thirds % 3]);
      m_second = Vertex(v[(m_thirds + 1) % 3]);
      m_third = Vertex(v[(m_thirds + 2) % 3]);
    } else
      m_vertex = called_target(g, m_halfedge);
  }

  Halfedge halfedge(const Mesh& g) const
  {
    if (!is_in_triangle(g) || m_thirds % 3 == 0)
      return m_halfedge;
    return m_thirds % 3 == 1 ? g.next(m_halfedge) : g.prev(m_halfedge);
  }

  static BOOST_NOINLINE bool is_same(const Mesh& g, Around_face_vertices a, Around_face_vertices b)
  {
    if (a.m_start == b.m_start) // around no face, the first vertex is past the end
      return !a.m_start.is_valid() || (a.m_thirds == b.m_thirds && a.m_halfedge == b.m_halfedge);
    return a.halfedge(g) == b.halfedge(g) && (!counts || a.m_thirds / 3 == b.m_thirds / 3);
  }
  static BOOST_NOINLINE Halfedge called_next(const Mesh& g, Halfedge h) { return g.next(h); }
  static BOOST_NOINLINE Vertex called_target(const Mesh& g, Halfedge h) { return h.is_valid() ? g.target(h) : Vertex(); }

  Halfedge m_halfedge, m_start;
  unsigned m_thirds = 0;          // of a round
  bool m_was_in_triangle = false; // when the vertices were read
  Vertex m_vertex, m_second, m_third; // the latter two in triangles
};

// What an iterator shows of where it stands.
struct Show_halfedge
{
  template <class Mesh, class Position>
  static BOOST_FORCEINLINE auto get(const Mesh&, const Position& p) { return p.halfedge(); }
};
struct Show_edge
{
  template <class Mesh, class Position>
  static BOOST_FORCEINLINE auto get(const Mesh& g, const Position& p) { return g.edge(p.halfedge()); }
};
struct Show_opposite_edge
{
  template <class Mesh, class Position>
  static BOOST_FORCEINLINE auto get(const Mesh& g, const Position& p) { return g.edge(g.opposite(p.halfedge())); }
};
struct Show_source
{
  template <class Mesh, class Position>
  static BOOST_FORCEINLINE auto get(const Mesh& g, const Position& p) { return g.source(p.halfedge()); }
};
struct Show_vertex
{
  template <class Mesh, class Position>
  static BOOST_FORCEINLINE auto get(const Mesh&, const Position& p) { return p.vertex(); }
};

// Iterators past the end have come back once to where they started.
template <class Derived, class Mesh, template <class, bool> class Position_of, class Show, class Category>
class Around_iterator
{
  using Position = Position_of<Mesh, !std::is_same<Category, Bidirectional_circulator_tag>::value>;
  using Halfedge = typename Mesh::Halfedge_index;

public:
  using iterator_category = Category;
  using value_type = decltype(Show::get(std::declval<const Mesh&>(), Position()));
  using reference = value_type;
  using difference_type = std::ptrdiff_t;
  using size_type = std::size_t;

  class pointer
  {
  public:
    explicit pointer(const value_type& v) : m_value(v) {}
    const value_type* operator->() const { return &m_value; }

  private:
    value_type m_value;
  };

  Around_iterator() = default;
  BOOST_FORCEINLINE Around_iterator(Halfedge h, const Mesh& g, int round = 0)
    : m_mesh(&g), m_position(h, g, static_cast<unsigned>(round))
  {}

  BOOST_FORCEINLINE reference operator*() const { return Show::get(*m_mesh, m_position); }
  pointer operator->() const { return pointer(**this); }

  explicit operator bool() const { return m_mesh != nullptr; }
  bool operator==(void*) const { return m_mesh == nullptr; }
  BOOST_FORCEINLINE bool operator==(const Derived& other) const
  {
    return m_mesh == other.m_mesh && (m_mesh == nullptr || m_position.equals(*m_mesh, other.m_position));
  }
  BOOST_FORCEINLINE bool operator!=(const Derived& other) const { return !(*this == other); }

  BOOST_FORCEINLINE Derived& operator++()
  {
    m_position.advance(*m_mesh);
    return derived();
  }
  BOOST_FORCEINLINE Derived operator++(int)
  {
    Derived old(derived());
    ++*this;
    return old;
  }
  Derived& operator--()
  {
    m_position.retreat(*m_mesh);
    return derived();
  }
  Derived operator--(int)
  {
    Derived old(derived());
    --*this;
    return old;
  }

private:
  BOOST_FORCEINLINE Derived& derived() { return static_cast<Derived&>(*this); }

  const Mesh* m_mesh = nullptr;
  Position m_position;
};

} // namespace internal

template <class P, class L>
class Halfedge_around_target_iterator<Compact_surface_mesh<P, L> >
  : public internal::Around_iterator<Halfedge_around_target_iterator<Compact_surface_mesh<P, L> >,
                                     Compact_surface_mesh<P, L>, internal::Around_target,
                                     internal::Show_halfedge, std::bidirectional_iterator_tag>
{
  using Base = typename Halfedge_around_target_iterator::Around_iterator;

public:
  using Base::Base;
};

template <class P, class L>
class Halfedge_around_source_iterator<Compact_surface_mesh<P, L> >
  : public internal::Around_iterator<Halfedge_around_source_iterator<Compact_surface_mesh<P, L> >,
                                     Compact_surface_mesh<P, L>, internal::Around_source,
                                     internal::Show_halfedge, std::bidirectional_iterator_tag>
{
  using Base = typename Halfedge_around_source_iterator::Around_iterator;

public:
  using Base::Base;
};

template <class P, class L>
class Halfedge_around_face_iterator<Compact_surface_mesh<P, L> >
  : public internal::Around_iterator<Halfedge_around_face_iterator<Compact_surface_mesh<P, L> >,
                                     Compact_surface_mesh<P, L>, internal::Around_face,
                                     internal::Show_halfedge, std::bidirectional_iterator_tag>
{
  using Base = typename Halfedge_around_face_iterator::Around_iterator;

public:
  using Base::Base;
};

template <class P, class L>
class Halfedge_around_target_circulator<Compact_surface_mesh<P, L> >
  : public internal::Around_iterator<Halfedge_around_target_circulator<Compact_surface_mesh<P, L> >,
                                     Compact_surface_mesh<P, L>, internal::Around_target,
                                     internal::Show_halfedge, Bidirectional_circulator_tag>
{
  using Base = typename Halfedge_around_target_circulator::Around_iterator;

public:
  using Base::Base;
  Halfedge_around_target_circulator(typename Compact_surface_mesh<P, L>::Vertex_index v,
                                    const Compact_surface_mesh<P, L>& g)
    : Base(g.halfedge(v), g)
  {}
};

template <class P, class L>
class Halfedge_around_source_circulator<Compact_surface_mesh<P, L> >
  : public internal::Around_iterator<Halfedge_around_source_circulator<Compact_surface_mesh<P, L> >,
                                     Compact_surface_mesh<P, L>, internal::Around_source,
                                     internal::Show_halfedge, Bidirectional_circulator_tag>
{
  using Base = typename Halfedge_around_source_circulator::Around_iterator;

public:
  using Base::Base;
  Halfedge_around_source_circulator(typename Compact_surface_mesh<P, L>::Vertex_index v,
                                    const Compact_surface_mesh<P, L>& g)
    : Base(g.opposite(g.halfedge(v)), g)
  {}
};

template <class P, class L>
class Halfedge_around_face_circulator<Compact_surface_mesh<P, L> >
  : public internal::Around_iterator<Halfedge_around_face_circulator<Compact_surface_mesh<P, L> >,
                                     Compact_surface_mesh<P, L>, internal::Around_face,
                                     internal::Show_halfedge, Bidirectional_circulator_tag>
{
  using Base = typename Halfedge_around_face_circulator::Around_iterator;

public:
  using Base::Base;
};

template <class P, class L>
class Vertex_around_target_iterator<Compact_surface_mesh<P, L> >
  : public internal::Around_iterator<Vertex_around_target_iterator<Compact_surface_mesh<P, L> >,
                                     Compact_surface_mesh<P, L>, internal::Around_target,
                                     internal::Show_source, std::bidirectional_iterator_tag>
{
  using Base = typename Vertex_around_target_iterator::Around_iterator;

public:
  using Base::Base;
};

template <class P, class L>
class Vertex_around_target_circulator<Compact_surface_mesh<P, L> >
  : public internal::Around_iterator<Vertex_around_target_circulator<Compact_surface_mesh<P, L> >,
                                     Compact_surface_mesh<P, L>, internal::Around_target,
                                     internal::Show_source, Bidirectional_circulator_tag>
{
  using Base = typename Vertex_around_target_circulator::Around_iterator;

public:
  using Base::Base;
};

template <class P, class L>
class Vertex_around_face_iterator<Compact_surface_mesh<P, L> >
  : public internal::Around_iterator<Vertex_around_face_iterator<Compact_surface_mesh<P, L> >,
                                     Compact_surface_mesh<P, L>,
                                     internal::Around_face_vertices,
                                     internal::Show_vertex, std::bidirectional_iterator_tag>
{
  using Base = typename Vertex_around_face_iterator::Around_iterator;

public:
  Vertex_around_face_iterator() = default;
  BOOST_FORCEINLINE Vertex_around_face_iterator(typename Compact_surface_mesh<P, L>::Halfedge_index h,
                                                const Compact_surface_mesh<P, L>& g, int round = 0)
    : Base(h, g, round)
  {}
};

template <class P, class L>
class Vertex_around_face_circulator<Compact_surface_mesh<P, L> >
  : public internal::Around_iterator<Vertex_around_face_circulator<Compact_surface_mesh<P, L> >,
                                     Compact_surface_mesh<P, L>,
                                     internal::Around_face_vertices,
                                     internal::Show_vertex, Bidirectional_circulator_tag>
{
  using Base = typename Vertex_around_face_circulator::Around_iterator;

public:
  Vertex_around_face_circulator() = default;
  BOOST_FORCEINLINE Vertex_around_face_circulator(typename Compact_surface_mesh<P, L>::Halfedge_index h,
                                                const Compact_surface_mesh<P, L>& g, int round = 0)
    : Base(h, g, round)
  {}
};

// The same as CGAL's function, inlined.
template <class P, class L>
BOOST_FORCEINLINE Iterator_range<Vertex_around_face_iterator<Compact_surface_mesh<P, L> > >
vertices_around_face(typename Compact_surface_mesh<P, L>::Halfedge_index h, const Compact_surface_mesh<P, L>& g)
{
  using Iterator = Vertex_around_face_iterator<Compact_surface_mesh<P, L> >;
  return make_range(Iterator(h, g), Iterator(h, g, 1));
}

template <class P, class L>
class In_edge_iterator<Compact_surface_mesh<P, L> >
  : public internal::Around_iterator<In_edge_iterator<Compact_surface_mesh<P, L> >,
                                     Compact_surface_mesh<P, L>, internal::Around_target,
                                     internal::Show_edge, std::bidirectional_iterator_tag>
{
  using Base = typename In_edge_iterator::Around_iterator;

public:
  using Base::Base;
};

template <class P, class L>
class Out_edge_iterator<Compact_surface_mesh<P, L> >
  : public internal::Around_iterator<Out_edge_iterator<Compact_surface_mesh<P, L> >,
                                     Compact_surface_mesh<P, L>, internal::Around_target,
                                     internal::Show_opposite_edge, std::bidirectional_iterator_tag>
{
  using Base = typename Out_edge_iterator::Around_iterator;

public:
  using Base::Base;
};

} // namespace CGAL

#endif // DOXYGEN_RUNNING

#endif // CGAL_BOOST_GRAPH_ITERATOR_COMPACT_SURFACE_MESH_H
