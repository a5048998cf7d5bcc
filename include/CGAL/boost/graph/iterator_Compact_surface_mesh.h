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

// Where an iterator stands, which started at a halfedge.

template <class Mesh>
using Halfedge_step = typename Mesh::Halfedge_index (Mesh::*)(typename Mesh::Halfedge_index) const;

template <class Mesh, Halfedge_step<Mesh> next, Halfedge_step<Mesh> prev>
class At_halfedge
{
  using Halfedge = typename Mesh::Halfedge_index;

public:
  At_halfedge() = default;
  explicit At_halfedge(Halfedge h) : m_halfedge(h) {}

  BOOST_FORCEINLINE Halfedge halfedge() const { return m_halfedge; }
  BOOST_FORCEINLINE bool is_at(Halfedge start) const { return m_halfedge == start; }
  BOOST_FORCEINLINE bool equals(const Mesh&, const At_halfedge& other) const { return m_halfedge == other.m_halfedge; }

  BOOST_FORCEINLINE void advance(const Mesh& g, Halfedge) { m_halfedge = (g.*next)(m_halfedge); }
  void retreat(const Mesh& g, Halfedge) { m_halfedge = (g.*prev)(m_halfedge); }

private:
  Halfedge m_halfedge;
};

template <class Mesh>
using Around_target = At_halfedge<Mesh, &Mesh::next_around_target, &Mesh::prev_around_target>;
template <class Mesh>
using Around_source = At_halfedge<Mesh, &Mesh::next_around_source, &Mesh::prev_around_source>;
template <class Mesh>
using Around_face = At_halfedge<Mesh, &Mesh::next, &Mesh::prev>;

// The third vertex of a triangle is the source of the first side: so one step of three takes time.
template <class Mesh>
class Around_face_vertices
{
  using Halfedge = typename Mesh::Halfedge_index;

public:
  Around_face_vertices() = default;
  explicit Around_face_vertices(Halfedge h) : m_halfedge(h) {}

  BOOST_FORCEINLINE auto vertex(const Mesh& g, Halfedge start) const
  {
    return m_is_third ? g.source(start) : g.target(m_halfedge);
  }
  BOOST_FORCEINLINE bool is_at(Halfedge start) const { return m_halfedge == start && !m_is_third; }
  BOOST_FORCEINLINE bool equals(const Mesh& g, const Around_face_vertices& other) const
  {
    if (BOOST_LIKELY(m_is_third == other.m_is_third))
      return m_halfedge == other.m_halfedge;
    return halfedge(g) == other.halfedge(g);
  }

  BOOST_FORCEINLINE void advance(const Mesh& g, Halfedge start)
  {
    if (m_halfedge == start || !g.layout().is_in_triangle(start.name()))
      m_halfedge = g.next(m_halfedge);
    else {
      if (m_is_third)
        m_halfedge = start;
      m_is_third = !m_is_third;
    }
  }

  void retreat(const Mesh& g, Halfedge start)
  {
    if (!g.layout().is_in_triangle(start.name()))
      m_halfedge = g.prev(m_halfedge);
    else if (m_is_third || m_halfedge == start) {
      m_halfedge = g.next(start);
      m_is_third = !m_is_third;
    } else
      m_halfedge = start;
  }

private:
  BOOST_NOINLINE Halfedge halfedge(const Mesh& g) const { return m_is_third ? g.next(m_halfedge) : m_halfedge; }

  Halfedge m_halfedge; // of the second vertex, where it stands at the third one
  bool m_is_third = false;
};

// What an iterator shows of where it stands.
struct Show_halfedge
{
  template <class Mesh, class Position, class Halfedge>
  static BOOST_FORCEINLINE auto get(const Mesh&, const Position& p, Halfedge) { return p.halfedge(); }
};
struct Show_edge
{
  template <class Mesh, class Position, class Halfedge>
  static BOOST_FORCEINLINE auto get(const Mesh& g, const Position& p, Halfedge) { return g.edge(p.halfedge()); }
};
struct Show_opposite_edge
{
  template <class Mesh, class Position, class Halfedge>
  static BOOST_FORCEINLINE auto get(const Mesh& g, const Position& p, Halfedge)
  {
    return g.edge(g.opposite(p.halfedge()));
  }
};
struct Show_source
{
  template <class Mesh, class Position, class Halfedge>
  static BOOST_FORCEINLINE auto get(const Mesh& g, const Position& p, Halfedge) { return g.source(p.halfedge()); }
};
struct Show_vertex
{
  template <class Mesh, class Position, class Halfedge>
  static BOOST_FORCEINLINE auto get(const Mesh& g, const Position& p, Halfedge start) { return p.vertex(g, start); }
};

// Iterators count how often they came back to where they started, as those past the end have done once.
template <class Derived, class Mesh, class Position, class Show, class Category>
class Around_iterator
{
  static constexpr bool is_circulator = std::is_same<Category, Bidirectional_circulator_tag>::value;
  using Halfedge = typename Mesh::Halfedge_index;

public:
  using iterator_category = Category;
  using value_type = decltype(Show::get(std::declval<const Mesh&>(), Position(), Halfedge()));
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
    : m_mesh(&g), m_position(h), m_start(h), m_round(h.is_valid() ? round : 1)
  {}

  BOOST_FORCEINLINE reference operator*() const { return Show::get(*m_mesh, m_position, m_start); }
  pointer operator->() const { return pointer(**this); }

  explicit operator bool() const { return m_mesh != nullptr; }
  bool operator==(void*) const { return m_mesh == nullptr; }
  BOOST_FORCEINLINE bool operator==(const Derived& other) const
  {
    return (is_circulator || m_round == other.m_round) && m_mesh == other.m_mesh
        && (m_mesh == nullptr || m_position.equals(*m_mesh, other.m_position));
  }
  BOOST_FORCEINLINE bool operator!=(const Derived& other) const { return !(*this == other); }

  BOOST_FORCEINLINE Derived& operator++()
  {
    m_position.advance(*m_mesh, m_start);
    if (!is_circulator && m_position.is_at(m_start))
      ++m_round;
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
    if (!is_circulator && m_position.is_at(m_start))
      --m_round;
    m_position.retreat(*m_mesh, m_start);
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
  Halfedge m_start;
  int m_round = 0;
};

} // namespace internal

template <class P, class L>
class Halfedge_around_target_iterator<Compact_surface_mesh<P, L> >
  : public internal::Around_iterator<Halfedge_around_target_iterator<Compact_surface_mesh<P, L> >,
                                     Compact_surface_mesh<P, L>, internal::Around_target<Compact_surface_mesh<P, L> >,
                                     internal::Show_halfedge, std::bidirectional_iterator_tag>
{
  using Base = typename Halfedge_around_target_iterator::Around_iterator;

public:
  using Base::Base;
};

template <class P, class L>
class Halfedge_around_source_iterator<Compact_surface_mesh<P, L> >
  : public internal::Around_iterator<Halfedge_around_source_iterator<Compact_surface_mesh<P, L> >,
                                     Compact_surface_mesh<P, L>, internal::Around_source<Compact_surface_mesh<P, L> >,
                                     internal::Show_halfedge, std::bidirectional_iterator_tag>
{
  using Base = typename Halfedge_around_source_iterator::Around_iterator;

public:
  using Base::Base;
};

template <class P, class L>
class Halfedge_around_face_iterator<Compact_surface_mesh<P, L> >
  : public internal::Around_iterator<Halfedge_around_face_iterator<Compact_surface_mesh<P, L> >,
                                     Compact_surface_mesh<P, L>, internal::Around_face<Compact_surface_mesh<P, L> >,
                                     internal::Show_halfedge, std::bidirectional_iterator_tag>
{
  using Base = typename Halfedge_around_face_iterator::Around_iterator;

public:
  using Base::Base;
};

template <class P, class L>
class Halfedge_around_target_circulator<Compact_surface_mesh<P, L> >
  : public internal::Around_iterator<Halfedge_around_target_circulator<Compact_surface_mesh<P, L> >,
                                     Compact_surface_mesh<P, L>, internal::Around_target<Compact_surface_mesh<P, L> >,
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
                                     Compact_surface_mesh<P, L>, internal::Around_source<Compact_surface_mesh<P, L> >,
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
                                     Compact_surface_mesh<P, L>, internal::Around_face<Compact_surface_mesh<P, L> >,
                                     internal::Show_halfedge, Bidirectional_circulator_tag>
{
  using Base = typename Halfedge_around_face_circulator::Around_iterator;

public:
  using Base::Base;
};

template <class P, class L>
class Vertex_around_target_iterator<Compact_surface_mesh<P, L> >
  : public internal::Around_iterator<Vertex_around_target_iterator<Compact_surface_mesh<P, L> >,
                                     Compact_surface_mesh<P, L>, internal::Around_target<Compact_surface_mesh<P, L> >,
                                     internal::Show_source, std::bidirectional_iterator_tag>
{
  using Base = typename Vertex_around_target_iterator::Around_iterator;

public:
  using Base::Base;
};

template <class P, class L>
class Vertex_around_target_circulator<Compact_surface_mesh<P, L> >
  : public internal::Around_iterator<Vertex_around_target_circulator<Compact_surface_mesh<P, L> >,
                                     Compact_surface_mesh<P, L>, internal::Around_target<Compact_surface_mesh<P, L> >,
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
                                     internal::Around_face_vertices<Compact_surface_mesh<P, L> >,
                                     internal::Show_vertex, std::bidirectional_iterator_tag>
{
  using Base = typename Vertex_around_face_iterator::Around_iterator;

public:
  using Base::Base;
};

template <class P, class L>
class Vertex_around_face_circulator<Compact_surface_mesh<P, L> >
  : public internal::Around_iterator<Vertex_around_face_circulator<Compact_surface_mesh<P, L> >,
                                     Compact_surface_mesh<P, L>,
                                     internal::Around_face_vertices<Compact_surface_mesh<P, L> >,
                                     internal::Show_vertex, Bidirectional_circulator_tag>
{
  using Base = typename Vertex_around_face_circulator::Around_iterator;

public:
  using Base::Base;
};

template <class P, class L>
class In_edge_iterator<Compact_surface_mesh<P, L> >
  : public internal::Around_iterator<In_edge_iterator<Compact_surface_mesh<P, L> >,
                                     Compact_surface_mesh<P, L>, internal::Around_target<Compact_surface_mesh<P, L> >,
                                     internal::Show_edge, std::bidirectional_iterator_tag>
{
  using Base = typename In_edge_iterator::Around_iterator;

public:
  using Base::Base;
};

template <class P, class L>
class Out_edge_iterator<Compact_surface_mesh<P, L> >
  : public internal::Around_iterator<Out_edge_iterator<Compact_surface_mesh<P, L> >,
                                     Compact_surface_mesh<P, L>, internal::Around_target<Compact_surface_mesh<P, L> >,
                                     internal::Show_opposite_edge, std::bidirectional_iterator_tag>
{
  using Base = typename Out_edge_iterator::Around_iterator;

public:
  using Base::Base;
};

} // namespace CGAL

#endif // DOXYGEN_RUNNING

#endif // CGAL_BOOST_GRAPH_ITERATOR_COMPACT_SURFACE_MESH_H
