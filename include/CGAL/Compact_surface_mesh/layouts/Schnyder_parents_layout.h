// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_SCHNYDER_PARENTS_LAYOUT_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_SCHNYDER_PARENTS_LAYOUT_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/internal/Emptied_on_move.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_parents_builder.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_parents_operators.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_parents_records.h>
#include <CGAL/Schnyder_woods/internal/Schnyder_wood.h>
#include <CGAL/Schnyder_woods/internal/Shelling.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgCompactSurfaceMeshRef

The class `Schnyder_parents_layout` stores the connectivity of a triangle mesh in
four, five or six references per vertex: the parents of the vertex in the three trees of
a Schnyder wood, and its first child in one of them, whose siblings are numbered
consecutively. Faces and edges cost nothing: every vertex owns three edges and two faces.

With four references, 16 bytes a vertex for a 32-bit `Index`, all queries take constant time.
Some walk along a list of at most `max_walk_length()` vertices; with five references
fewer do, with six none.

A mesh with \f$n\f$ vertices has the halfedges \f$6u + k\f$ of vertex \f$u\f$: \f$k = 0, 2, 4\f$ run to
its red, blue and black parent, \f$k + 1\f$ back. Opposite halfedges differ in the last bit,
and halfedge \f$h\f$ belongs to edge \f$h/2\f$. The last three vertices surround the face in which
the wood is rooted; they own the three edges of that face.

The structure combines Schnyder's trees (W. Schnyder, <em>Embedding planar graphs on the
grid</em>, SODA 1990) with the renumbering of L. Castelli Aleardi and O. Devillers, <em>Array-based
compact data structures for triangulations</em>, JoCG 2018, Theorem 5; it stores parents where
that paper stores neighboring edges, so targets and adjacency take constant time.

\tparam References 4, 5 or 6
\tparam Index_ an unsigned integer type; four of its bits are flags, so that with 32 bits
meshes have at most \f$2^{28}\f$ vertices.

\cgalModels{CompactSurfaceMeshLayout}
*/
template <int References = 4, class Index_ = std::uint32_t>
class Schnyder_parents_layout
{
  typedef internal::Schnyder_parents_records<References, Index_> Records;
  typedef internal::Schnyder_parents_operators<Records, Index_, internal::Schnyder_inner_zone<Index_>> Inner;
  typedef internal::Schnyder_parents_operators<Records, Index_, internal::Schnyder_any_zone<Index_>> Any;

public:
  /// the integer type of all indices.
  typedef Index_ Index;

  /// whether `edge(h) == h / 2` and `opposite(h) == (h ^ 1)`.
  static constexpr bool edge_is_half_of_halfedge = true;

  /// returns the index of no element: the largest value of `Index`.
  static constexpr Index null_index() { return (std::numeric_limits<Index>::max)(); }
  /// returns `"schnyder-parents-4n"`, with the number of references.
  static std::string name() { return "schnyder-parents-" + std::to_string(References) + "n"; }
  /// returns the largest number of vertices that fits beside the flags in `Index`.
  static std::size_t max_vertices() { return Records::max_records; }

  /// returns the largest number of steps that any query walks along a list.
  static constexpr std::size_t max_walk_length() { return Records::max_walk; }

  /// creates the layout of the empty mesh.
  Schnyder_parents_layout() = default;

  /*!
  builds the layout of `t` in linear time. The input's order of vertices is not kept.
  \param t the triangulation; it is empty afterwards
  \param vertex_of_input gets, appended, the index of each vertex in the order of the input
  \param order in which order the shelling that finds the Schnyder wood takes vertices
  \param seed of `Shelling_order::RANDOM`
  \throws Mesh_defect_exception if the mesh has more than `max_vertices()` vertices
  */
  Schnyder_parents_layout(Closed_triangulation<Index>&& t, std::vector<Index>& vertex_of_input,
                          Shelling_order order = Shelling_order::LAST_IN_FIRST_OUT, unsigned int seed = 0)
  {
    if (t.num_user_vertices() > max_vertices())
      throw Mesh_defect_exception(Mesh_defect::too_many_elements, t.num_user_vertices());
    internal::Schnyder_wood wood(t.table().num_halfedges());
    for (const auto& root : t.roots())
      internal::Shelling<Index>(t.table(), root.base, wood, order, seed)([](Index) {});
    std::vector<Index> number = internal::Schnyder_parents_builder<References, Index>(t, wood, m_records)();
    m_border = static_cast<Index>(num_vertices() - 3 * t.roots().size());
    t = Closed_triangulation<Index>();
    if (vertex_of_input.empty())
      vertex_of_input = std::move(number);
    else
      vertex_of_input.insert(vertex_of_input.end(), number.begin(), number.end());
  }

  /// \name Counts
  /// in constant time.
  /// @{

  /// returns the number of vertices.
  std::size_t num_vertices() const { return m_records.records.size(); }
  /// returns the number of halfedges.
  std::size_t num_halfedges() const { return 2 * num_edges(); }
  /// returns the number of edges.
  // the three vertices around the root face own one edge each, the others three
  std::size_t num_edges() const { return num_vertices() + 2 * std::size_t(m_border); }
  /// returns the number of faces.
  std::size_t num_faces() const { return 2 * (std::size_t(m_border) + (num_vertices() - m_border) / 3); }
  /// @}

  /// \name Navigation
  /// All in constant time.
  /// @{

  /// returns the next halfedge counterclockwise around the face of `h`.
  BOOST_FORCEINLINE Index next(Index h) const
  {
    if (BOOST_UNLIKELY(h >= inner_halfedges()))
      return next_in_border_zone(h);
    const auto s = inner().next({ h / 6, static_cast<unsigned>(h % 6) });
    return halfedge_index(s.x, s.k);
  }

  /// returns the halfedge whose next one is `h`.
  BOOST_FORCEINLINE Index prev(Index h) const
  {
    if (BOOST_UNLIKELY(h >= inner_halfedges()))
      return prev_in_border_zone(h);
    const auto s = inner().prev({ h / 6, static_cast<unsigned>(h % 6) });
    return halfedge_index(s.x, s.k);
  }

  /// returns the other halfedge of the edge of `h`.
  static Index opposite(Index h) { return h ^ 1; }

  /// returns the vertex where `h` starts.
  BOOST_FORCEINLINE Index source(Index h) const
  {
    return any().source(side(h));
  }

  /// returns the vertex where `h` ends.
  BOOST_FORCEINLINE Index target(Index h) const
  {
    return any().target(side(h));
  }

  /// returns the face to the left of `h`.
  BOOST_FORCEINLINE Index face(Index h) const
  {
    if (BOOST_UNLIKELY(h >= inner_halfedges()))
      return face_in_border_zone(h);
    const auto f = inner().face({ h / 6, static_cast<unsigned>(h % 6) });
    return face_index(f.x, f.owner);
  }

  /// returns the edge of `h`.
  static Index edge(Index h) { return h / 2; }
  /// returns the halfedge of `e` that starts at the vertex which owns `e`.
  static Index halfedge_of_edge(Index e) { return 2 * e; }

  /// returns a halfedge whose target is `v`, always the same.
  Index halfedge_of_vertex(Index v) const
  {
    if (BOOST_LIKELY(v < m_border))
      return 6 * v + 1;
    const auto s = any().border_side(v);
    return halfedge_index(s.x, s.k);
  }

  /// returns a halfedge whose face is `f`, always the same.
  Index halfedge_of_face(Index f) const
  {
    if (BOOST_LIKELY(f < 2 * m_border))
      return 6 * (f / 2) + (f & 1 ? 5 : 0);
    const Index family = border_family((f - 2 * m_border) / 2);
    if (f & 1) {
      const auto s = any().border_side(family);
      return halfedge_index(s.x, s.k);
    }
    return halfedge_index(family + 1, 5);
  }

  /// returns the halfedge from `u` to `v`, `null_index()` if they are not adjacent.
  Index halfedge(Index u, Index v) const
  {
    if (u == v)
      return null_index();
    // the idle red parents of border vertices are no neighbors by that edge
    for (unsigned word = u < m_border ? 0 : 1; word < 3; ++word)
      if (m_records.parent(u, word) == v)
        return halfedge_index(u, 2 * word);
    for (unsigned word = v < m_border ? 0 : 1; word < 3; ++word)
      if (m_records.parent(v, word) == u)
        return halfedge_index(v, 2 * word + 1);
    return null_index();
  }

  /// @}

  /// \name Whole Stars
  /// @{

  /// calls `visit(u)` for each vertex `u` adjacent to `v`, once each, in no particular order.
  template <class Visitor>
  BOOST_FORCEINLINE void for_each_adjacent_vertex(Index v, Visitor&& visit) const
  {
    if (BOOST_UNLIKELY(v >= m_border)) {
      for_each_triangle_at_border(v, [&](Index u, Index) { visit(u); });
      return;
    }
    visit(m_records.red_parent(v));
    for_each_in_black(v, visit);
    visit(m_records.blue_parent(v));
    for_each_child(v, visit);
    visit(m_records.black_parent(v));
    for_each_in_blue(v, visit);
  }

  /// calls `visit(u, w)` for each face (`v`,`u`,`w`), counterclockwise, at `v`, once each, in
  /// no particular order.
  template <class Visitor>
  BOOST_FORCEINLINE void for_each_incident_triangle(Index v, Visitor&& visit) const
  {
    if (BOOST_UNLIKELY(v >= m_border)) {
      for_each_triangle_at_border(v, visit);
      return;
    }
    const Index red = m_records.red_parent(v), blue = m_records.blue_parent(v), black = m_records.black_parent(v);
    Index last = red;
    const auto counterclockwise = [&](Index u) {
      visit(last, u);
      last = u;
    };
    const auto clockwise = [&](Index u) {
      visit(u, last);
      last = u;
    };
    for_each_in_black(v, counterclockwise);
    counterclockwise(blue);
    for_each_child(v, counterclockwise);
    counterclockwise(black);
    last = red;
    for_each_in_blue(v, clockwise);
    clockwise(black);
  }

  /// returns the number of edges at `v`, in time linear in that number.
  Index degree(Index v) const
  {
    Index d = 0;
    const auto count = [&d](Index) { ++d; };
    if (BOOST_UNLIKELY(v >= m_border)) {
      for_each_adjacent_vertex(v, count);
      return d;
    }
    for_each_in_black(v, count);
    for_each_in_blue(v, count);
    return d + 3 + m_records.number_of_children(v);
  }

  /// returns the vertices of `f` counterclockwise, from the target of `halfedge_of_face(f)` on.
  std::array<Index, 3> vertices_of_face(Index f) const
  {
    const Index x = f / 2;
    if (BOOST_UNLIKELY(x >= m_border))
      return vertices_of_border_face(f);
    if (f & 1)
      return { x, m_records.is_leaf(x) ? m_records.blue_parent(x) : m_records.last_child(x),
               m_records.black_parent(x) };
    const Index p = m_records.red_parent(x);
    return { p, m_records.is_first(x) ? m_records.blue_parent(p) : static_cast<Index>(x - 1), x };
  }

  /// @}

  /// \name Memory
  /// @{

  /// returns the arrays that the layout holds, with the bytes that they have allocated.
  std::vector<std::pair<std::string, std::size_t>> memory() const
  {
    return { { "records", m_records.records.capacity() * sizeof(typename Records::Record) },
             { "long lists", m_records.long_lists.capacity() * sizeof(typename Records::Long_lists) } };
  }

  /// @}

private:
  // The lists of an inner vertex v: in-black counterclockwise, in-blue clockwise, both from
  // the red edge on, and the red children counterclockwise. Each loop calls its visitor in
  // one place: with two, compilers stop inlining it.
  template <class Visitor>
  BOOST_FORCEINLINE void for_each_in_black(Index v, Visitor&& visit) const
  {
    if (!m_records.in_black(v))
      return;
    const auto op = inner();
    for (Index u = op.after_red(v);; u = op.next_in_black(u)) {
      visit(u);
      if (!m_records.more_black(u))
        return;
    }
  }

  template <class Visitor>
  BOOST_FORCEINLINE void for_each_in_blue(Index v, Visitor&& visit) const
  {
    if (!m_records.in_blue(v))
      return;
    for (Index u = inner().before_red(v);; u = m_records.next_in_blue(u)) {
      visit(u);
      if (!m_records.more_blue(u))
        return;
    }
  }

  template <class Visitor>
  BOOST_FORCEINLINE void for_each_child(Index v, Visitor&& visit) const
  {
    if (m_records.is_leaf(v))
      return;
    const Index end = m_records.last_child(v) + 1;
    for (Index u = m_records.first_child(v); u != end; ++u)
      visit(u);
  }

  Inner inner() const { return Inner{ m_records, {} }; }
  Any any() const { return Any{ m_records, { m_border } }; }

  Index inner_halfedges() const { return 6 * m_border; }
  Index border_family(Index i) const { return m_border + 3 * i; }

  // From halfedges to sides and back. Of the three vertices around an apex the first one
  // owns no edge, the second its blue and its black one, the third its blue one.
  typename Any::Side side(Index h) const
  {
    if (BOOST_LIKELY(h < inner_halfedges()))
      return { h / 6, static_cast<unsigned>(h % 6) };
    const Index e = (h - inner_halfedges()) / 2, i = e % 3;
    const unsigned k = i == 1 ? 4 : 2;
    return { border_family(e / 3) + (i == 2 ? 2 : 1), k | static_cast<unsigned>(h & 1) };
  }

  Index halfedge_index(Index x, unsigned k) const
  {
    if (BOOST_LIKELY(x < m_border))
      return 6 * x + k;
    const Index family = (x - m_border) / 3, i = (x - m_border) % 3;
    const Index e = i == 2 ? 2 : (k >= 4 ? 1 : 0);
    return inner_halfedges() + 6 * family + 2 * e + (k & 1);
  }

  // A family around an apex owns two faces: the right one of its second vertex's black
  // edge, and the user's face that holds the apex.
  Index face_index(Index x, unsigned owner) const
  {
    if (BOOST_LIKELY(x < m_border))
      return 2 * x + owner;
    return 2 * (m_border + (x - m_border) / 3) + (owner == Any::hole ? 1 : 0);
  }

  BOOST_NOINLINE Index next_in_border_zone(Index h) const
  {
    const auto s = any().next(side(h));
    return halfedge_index(s.x, s.k);
  }

  BOOST_NOINLINE Index prev_in_border_zone(Index h) const
  {
    const auto s = any().prev(side(h));
    return halfedge_index(s.x, s.k);
  }

  BOOST_NOINLINE Index face_in_border_zone(Index h) const
  {
    const auto f = any().face(side(h));
    return face_index(f.x, f.owner);
  }

  BOOST_NOINLINE std::array<Index, 3> vertices_of_border_face(Index f) const
  {
    const Index h = halfedge_of_face(f), g = next(h);
    return { target(h), target(g), source(h) };
  }

  template <class Visitor>
  BOOST_NOINLINE void for_each_triangle_at_border(Index v, Visitor&& visit) const
  {
    const Index first = halfedge_of_vertex(v) ^ 1;
    Index h = first;
    do {
      const Index following = prev(h) ^ 1;
      visit(target(h), target(following));
      h = following;
    } while (h != first);
  }

  Records m_records;
  internal::Emptied_on_move<Index> m_border; // the first vertex around an apex
};

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_SCHNYDER_PARENTS_LAYOUT_H
