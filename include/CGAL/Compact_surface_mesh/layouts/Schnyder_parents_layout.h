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
#include <CGAL/Compact_surface_mesh/Input_images.h>
#include <CGAL/Compact_surface_mesh/internal/Divided_index.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Mask.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Masked_triangles.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_parents_builder.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_parents_numbering.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_parents_operators.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_parents_records.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_parents_sides.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_parents_star.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_parents_zone.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_triangles.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/for_each_face_from.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/wood_of_triangulation.h>
#include <CGAL/Schnyder_woods/internal/Schnyder_wood.h>

#include <boost/config.hpp>
#include <boost/container/small_vector.hpp>

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

The class `Schnyder_parents_layout` stores the connectivity of a mesh in four, five or six
references per vertex: the parents of the vertex in the three trees of a Schnyder wood, and its
first child in one of them, whose siblings are numbered consecutively. Faces and edges cost
nothing: every vertex owns three edges and two faces.

With four references, 16 bytes a vertex for a 32-bit `Index`, all queries take constant time.
Some walk along a list of at most `max_walk_length()` vertices; with five references
fewer do, with six none.

Off borders, special edges of the wood and polygons, in the <em>core</em>, vertex \f$u\f$ has the
halfedges \f$6u + k\f$: \f$k = 0, 2, 4\f$ run to its red, blue and black parent, \f$k + 1\f$ back, and
the faces \f$2u\f$ and \f$2u + 1\f$. Everywhere, opposite halfedges differ in the last bit, and halfedge
\f$h\f$ belongs to edge \f$h/2\f$. What is not in the core comes last in all numberings. There queries
also take time logarithmic in the number of components, borders, handles and vertices with
several fans, and `halfedge(u, v)` time linear in the numbers of fans and special edges of `u` and `v`.

Borders cost nothing, and neither do their edges; a component costs 15 words at most, a further
border of a component 31, a handle 62, and a vertex with \f$k\f$ fans \f$11k - 7\f$. A polygon has
hidden diagonals, or a hidden vertex, which has a record as others have; then all edges, faces and
vertices have a bit with its rank directory.

The structure combines Schnyder's trees (W. Schnyder, <em>Embedding planar graphs on the
grid</em>, SODA 1990), their generalization to all genera (L. Castelli Aleardi, habilitation, 2022) and the
renumbering of L. Castelli Aleardi and O. Devillers, <em>Array-based
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
  typedef internal::Schnyder_parents_operators<Records, Index_, internal::Schnyder_core_zone<Index_>> Core;
  typedef typename Core::Side Side;
  typedef typename Core::Face Face;
  typedef internal::Schnyder_parents_zone<Records, Index_> Zone;
  typedef internal::Schnyder_parents_operators<Records, Index_, internal::Schnyder_inner_zone<Records, Index_>> Inner;
  typedef internal::Schnyder_parents_numbering<Index_> Numbering;
  typedef internal::Schnyder_triangles<internal::Schnyder_parents_operators<Records, Index_, Zone>, Numbering, Index_>
    Triangles;
  typedef internal::Mask<Index_, true> Mask;
  typedef internal::Masked_triangles<Triangles, Mask, Index_> Everything;
  template <class Operators>
  using Star = internal::Schnyder_parents_star<Operators, Index_>;
  typedef boost::container::small_vector<Index_, 32> Neighbors;
  typedef boost::container::small_vector<std::pair<Index_, Index_>, 32> Corners;

public:
  /// the integer type of all indices.
  typedef Index_ Index;
  /// names a halfedge, and converts from and to its index.
#ifdef DOXYGEN_RUNNING
  typedef unspecified_type Halfedge;
#else
  typedef internal::Divided_index<Index_> Halfedge;
#endif

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
  builds the layout of `t`, in the time that the shelling takes, which is nearly linear.
  The input's order of vertices is not kept.
  \param t the triangulation; it is empty afterwards
  \param images tells what becomes of the elements of the input
  \param order in which order the shelling that finds the Schnyder wood takes vertices
  \param seed of `Shelling_order::RANDOM`
  \throws Mesh_defect_exception if the mesh has more than `max_vertices()` vertices, where those
  count as well that are hidden, but not at apices, and the further sectors of vertices at special edges
  */
  Schnyder_parents_layout(Closed_triangulation<Index>&& t, Input_images<Index>& images,
                          Shelling_order order = Shelling_order::LAST_IN_FIRST_OUT, unsigned int seed = 0)
  {
    if (t.first_apex() > max_vertices())
      throw Mesh_defect_exception(Mesh_defect::too_many_elements, t.first_apex());
    if (t.is_scattered())
      t.renumber(images.wants_halfedges);
    const internal::Schnyder_wood wood = internal::shelled_wood(t, order, seed);
    internal::Schnyder_parents_builder<References, Index> builder(t, wood, m_records, m_numbering);
    builder();
    internal::Schnyder_parents_sides<References, Index>(t, wood, builder).number_slots(m_records, m_numbering);

    std::vector<Index> halfedges;
    if (images.wants_halfedges || t.simple().has_hidden())
      halfedges = internal::numbers_of_halfedges(t, builder.sides(), triangles());
    std::vector<Index> vertices = builder.release_records_of_vertices();
    vertices.resize(t.first_copy());
    for (Index& x : vertices)
      x = triangles().vertex(x);
    if (t.simple().has_hidden())
      m_mask = Mask(triangles(), t, vertices, halfedges);
    if (m_mask.empty())
      m_numbering.keep_slots();
    m_mask.write_images(t, std::move(vertices), halfedges, images);
    t = Closed_triangulation<Index>();
  }

  /// \name Counts
  /// in constant time.
  /// @{

  /// returns the number of vertices.
  std::size_t num_vertices() const { return everything().num_vertices(); }
  /// returns the number of halfedges.
  std::size_t num_halfedges() const { return everything().num_halfedges(); }
  /// returns the number of edges.
  std::size_t num_edges() const { return num_halfedges() / 2; }
  /// returns the number of faces.
  std::size_t num_faces() const { return everything().num_faces(); }
  /// @}

  /// \name Navigation
  /// All in constant time, but see above for what is not in the core.
  /// @{

  /// returns the next halfedge counterclockwise around the face of `h`.
  BOOST_FORCEINLINE Halfedge next(Halfedge h) const
  {
    if (BOOST_LIKELY(is_in_core(h))) {
      const Side s = core().next(side(h));
      if (BOOST_LIKELY(s.x < m_numbering.core))
        return Halfedge::of(s.x, s.k);
    }
    return next_outside(h);
  }

  /// returns the halfedge whose next one is `h`.
  BOOST_FORCEINLINE Halfedge prev(Halfedge h) const
  {
    if (BOOST_LIKELY(is_in_core(h))) {
      const Side s = core().prev(side(h));
      if (BOOST_LIKELY(s.x < m_numbering.core))
        return Halfedge::of(s.x, s.k);
    }
    return prev_outside(h);
  }

  /// returns the other halfedge of the edge of `h`.
  static Halfedge opposite(Halfedge h) { return Halfedge::with_code(h.code() ^ 1); }

  /// returns the vertex where `h` starts.
  BOOST_FORCEINLINE Index source(Halfedge h) const
  {
    if (BOOST_LIKELY(is_in_core(h)))
      return core().source(side(h));
    return source_outside(h);
  }

  /// returns the vertex where `h` ends.
  BOOST_FORCEINLINE Index target(Halfedge h) const
  {
    if (BOOST_LIKELY(is_in_core(h)))
      return core().target(side(h));
    return target_outside(h);
  }

  /// returns the face to the left of `h`, `null_index()` on a border.
  BOOST_FORCEINLINE Index face(Halfedge h) const
  {
    if (BOOST_LIKELY(is_in_core(h))) {
      const auto f = core().face(side(h));
      if (BOOST_LIKELY(f.x < m_numbering.core))
        return 2 * f.x + f.owner;
    }
    return face_outside(h);
  }

  /// returns whether `h` is known to be a side of a triangle: all are that are not on borders, unless there are
  /// polygons or double edges; then those in the core.
  BOOST_FORCEINLINE bool is_in_triangle(Halfedge h) const
  {
    return BOOST_LIKELY(is_in_core(h)) || is_in_triangle_outside(h);
  }

  /// returns the vertices of the triangle of `h` counterclockwise, from its target on, if `is_in_triangle(h)`.
  BOOST_FORCEINLINE std::array<Index, 3> vertices_of_triangle(Halfedge h) const
  {
    if (BOOST_UNLIKELY(!is_in_core(h)))
      return vertices_of_triangle_outside(h);
    switch (h.remainder()) {
    case 0:
      return vertices_of_a(h.quotient());
    case 5:
      return vertices_of_b(h.quotient());
    default:
      return { core().target(side(h)), third_vertex(h), core().source(side(h)) };
    }
  }

  /// returns the edge of `h`.
  static Index edge(Halfedge h) { return h / 2; }
  /// returns the halfedge of `e` that starts at the vertex which owns `e`.
  static Halfedge halfedge_of_edge(Index e) { return static_cast<Index>(2 * e); }

  /// returns a halfedge whose target is `v`, always the same: a border halfedge if `v` lies on a
  /// border, `null_index()` if `v` is isolated.
  BOOST_FORCEINLINE Halfedge halfedge_of_vertex(Index v) const
  {
    if (BOOST_LIKELY(v < m_numbering.core))
      return Halfedge::of(v, 1);
    return halfedge_of_vertex_outside(v);
  }

  /// returns a halfedge whose face is `f`, always the same.
  BOOST_FORCEINLINE Halfedge halfedge_of_face(Index f) const
  {
    if (BOOST_LIKELY(f / 2 < m_numbering.core))
      return Halfedge::of(f / 2, f & 1 ? 5 : 0);
    return halfedge_of_face_outside(f);
  }

  /// returns the target of `halfedge_of_face(f)`.
  BOOST_FORCEINLINE Index vertex_of_face(Index f) const
  {
    const Index x = f / 2;
    if (BOOST_LIKELY(x < m_numbering.core))
      return chosen(f & 1, x, m_records.red_parent(x));
    return target_outside(halfedge_of_face_outside(f));
  }

  /// returns the halfedge from `u` to `v`, `null_index()` if they are not adjacent.
  Halfedge halfedge(Index u, Index v) const
  {
    const Index core = m_numbering.core;
    if (BOOST_UNLIKELY(u >= core || v >= core))
      return halfedge_outside(u, v);
    for (unsigned word = 0; word < 3; ++word)
      if (m_records.parent(u, word) == v)
        return Halfedge::of(u, 2 * word);
    for (unsigned word = 0; word < 3; ++word)
      if (m_records.parent(v, word) == u)
        return Halfedge::of(v, 2 * word + 1);
    return null_index();
  }

  /// @}

  /// \name Whole Stars
  /// @{

  /// calls `visit(u)` for each vertex `u` adjacent to `v`, once each, in no particular order.
  template <class Visitor>
  BOOST_FORCEINLINE void for_each_adjacent_vertex(Index v, Visitor&& visit) const
  {
    if (BOOST_UNLIKELY(v >= m_numbering.core)) {
      for_each_adjacent_vertex_outside(v, visit);
      return;
    }
    Star<Core>(core(), v).for_each_neighbor(visit);
  }

  /// calls `visit(u, w)` for each face at `v`, once each, in no particular order, where `u` follows
  /// and `w` precedes `v` in the face counterclockwise: a triangle is (`v`,`u`,`w`).
  template <class Visitor>
  BOOST_FORCEINLINE void for_each_incident_triangle(Index v, Visitor&& visit) const
  {
    if (BOOST_UNLIKELY(v >= m_numbering.core)) {
      for_each_incident_triangle_outside(v, visit);
      return;
    }
    Star<Core>(core(), v).for_each_triangle(visit);
  }

  /// returns the number of edges at `v`, in time linear in that number.
  Index degree(Index v) const
  {
    if (BOOST_UNLIKELY(v >= m_numbering.core))
      return degree_outside(v);
    return Star<Core>(core(), v).degree();
  }

  /// returns the vertices of `f` counterclockwise, from the target of `halfedge_of_face(f)` on;
  /// of a polygon, only the first three.
  std::array<Index, 3> vertices_of_face(Index f) const
  {
    const Index x = f / 2;
    if (BOOST_UNLIKELY(x >= m_numbering.core))
      return vertices_of_face_outside(f);
    return f & 1 ? vertices_of_b(x) : vertices_of_a(x);
  }

  /// calls `visit(f, u, v, w)` for each face `f` in their order, where `u`, `v`, `w` are `vertices_of_face(f)`.
  template <class Visitor>
  BOOST_FORCEINLINE void for_each_face(Visitor&& visit) const
  {
    const Index core = m_numbering.core;
    for (Index x = 0; x < core; ++x) {
      const std::array<Index, 3> a = vertices_of_a(x), b = vertices_of_b(x);
      visit(static_cast<Index>(2 * x), a[0], a[1], a[2]);
      visit(static_cast<Index>(2 * x + 1), b[0], b[1], b[2]);
    }
    internal::for_each_face_from(static_cast<Index>(2 * core), *this, visit);
  }

  /// @}

  /// \name Memory
  /// @{

  /// returns the arrays that the layout holds, with the bytes that they have allocated.
  std::vector<std::pair<std::string, std::size_t>> memory() const
  {
    return { { "records", m_records.records.capacity() * sizeof(typename Records::Record) },
             { "long lists", m_records.long_lists.capacity() * sizeof(typename Records::Long_lists) },
             { "borders and handles", m_numbering.bytes() },
             { "mask of polygons", m_mask.bytes() } };
  }

  /// @}

private:
  // The vertices of A(x) and B(x), by labels; outside of the core, records that have these vertices. Both that label 1
  // may have are at hand.
  BOOST_FORCEINLINE std::array<Index, 3> vertices_of_a(Index x) const
  {
    const Index p = m_records.red_parent(x);
    return { p, chosen(m_records.is_first(x), m_records.blue_parent(p), static_cast<Index>(x - 1)), x };
  }
  BOOST_FORCEINLINE std::array<Index, 3> vertices_of_b(Index x) const
  {
    return { x, chosen(m_records.is_leaf(x), m_records.blue_parent(x), m_records.last_child(x)),
             m_records.black_parent(x) };
  }
  // Masks take one of two, where processors cannot guess which it is.
  static Index chosen(bool first, Index a, Index b)
  {
    return static_cast<Index>(b ^ ((a ^ b) & static_cast<Index>(0 - static_cast<Index>(first))));
  }

  Core core() const { return Core{ m_records, {} }; }
  Inner inner() const { return Inner{ m_records, { m_records, m_numbering } }; }
  Triangles triangles() const { return Triangles({ m_records, Zone{ m_records, m_numbering } }, m_numbering); }
  Everything everything() const { return Everything(triangles(), m_mask); }
  bool is_in_core(Halfedge h) const { return h.code() < 8 * m_numbering.core; }
  static Side side(Halfedge h) { return { h.quotient(), h.remainder() }; }

  BOOST_NOINLINE Index third_vertex(Halfedge h) const { return target(next(h)); }

  // Outside of the core too, most elements have their slots as numbers; the others are elsewhere.
  BOOST_NOINLINE Halfedge next_outside(Halfedge h) const
  {
    return BOOST_LIKELY(keeps_slot(side(h))) ? number(inner().next(side(h))) : next_elsewhere(h);
  }
  BOOST_NOINLINE Halfedge prev_outside(Halfedge h) const
  {
    return BOOST_LIKELY(keeps_slot(side(h))) ? number(inner().prev(side(h))) : prev_elsewhere(h);
  }
  BOOST_NOINLINE Index source_outside(Halfedge h) const
  {
    return BOOST_LIKELY(keeps_slot(side(h))) ? vertex(inner().source(side(h))) : source_elsewhere(h);
  }
  BOOST_NOINLINE Index target_outside(Halfedge h) const
  {
    return BOOST_LIKELY(keeps_slot(side(h))) ? vertex(inner().target(side(h))) : target_elsewhere(h);
  }
  BOOST_NOINLINE Index face_outside(Halfedge h) const
  {
    return BOOST_LIKELY(keeps_slot(side(h))) ? number(inner().face(side(h))) : face_elsewhere(h);
  }
  BOOST_NOINLINE Halfedge halfedge_of_vertex_outside(Index v) const
  {
    return BOOST_LIKELY(v < m_numbering.end_of_kept) ? Halfedge::of(v, 1) : halfedge_of_vertex_elsewhere(v);
  }
  BOOST_NOINLINE Halfedge halfedge_of_face_outside(Index f) const
  {
    return BOOST_LIKELY(f / 2 < m_numbering.end_of_kept) ? number(Side{ f / 2, f & 1 ? 5u : 0u })
                                                         : halfedge_of_face_elsewhere(f);
  }

  bool keeps_slot(Side s) const { return s.x < m_numbering.end_of_kept && !m_records.is_irregular(s.x, s.k / 2); }
  Halfedge number(Side s) const { return BOOST_LIKELY(keeps_slot(s)) ? Halfedge::of(s.x, s.k) : number_elsewhere(s); }
  Index number(Face f) const
  {
    return BOOST_LIKELY(f.x < m_numbering.end_of_kept) ? static_cast<Index>(2 * f.x + f.owner) : number_elsewhere(f);
  }
  Index vertex(Index x) const { return BOOST_LIKELY(x < m_numbering.border) ? x : vertex_elsewhere(x); }

  BOOST_NOINLINE Halfedge next_elsewhere(Halfedge h) const { return everything().next(h); }
  BOOST_NOINLINE Halfedge prev_elsewhere(Halfedge h) const { return everything().prev(h); }
  BOOST_NOINLINE Index source_elsewhere(Halfedge h) const { return everything().source(h); }
  BOOST_NOINLINE Index target_elsewhere(Halfedge h) const { return everything().target(h); }
  BOOST_NOINLINE Index face_elsewhere(Halfedge h) const { return everything().face(h); }
  BOOST_NOINLINE Halfedge halfedge_of_vertex_elsewhere(Index v) const { return everything().halfedge_of_vertex(v); }
  BOOST_NOINLINE Halfedge halfedge_of_face_elsewhere(Index f) const { return everything().halfedge_of_face(f); }
  BOOST_NOINLINE Halfedge number_elsewhere(Side s) const { return triangles().halfedge(s); }
  BOOST_NOINLINE Index number_elsewhere(Face f) const { return triangles().face(f); }
  BOOST_NOINLINE Index vertex_elsewhere(Index x) const { return triangles().vertex(x); }
  BOOST_NOINLINE Index halfedge_outside(Index u, Index v) const { return everything().halfedge(u, v); }

  BOOST_NOINLINE bool is_in_triangle_outside(Halfedge h) const
  {
    return keeps_slot(side(h)) || (m_mask.empty() && !h.is_null() && triangles().face(h) != null_index());
  }

  BOOST_NOINLINE std::array<Index, 3> vertices_of_triangle_outside(Halfedge h) const
  {
    const std::array<Index, 3> v =
      keeps_slot(side(h)) ? vertices_outside(inner().face(side(h))) : vertices_of_face_outside(face_outside(h));
    const Index target = target_outside(h);
    const std::size_t first = v[0] == target ? 0 : v[1] == target ? 1 : 2;
    return { v[first], v[(first + 1) % 3], v[(first + 2) % 3] };
  }

  BOOST_NOINLINE std::array<Index, 3> vertices_of_face_outside(Index f) const
  {
    if (f / 2 < m_numbering.end_of_kept)
      return vertices_outside({ f / 2, f & 1 ? Face::B : Face::A });
    if (m_mask.empty()) {
      const Face face = m_numbering.face_of_slot(m_numbering.faces.slot(f));
      if (face.owner != Face::hole)
        return vertices_outside(face);
    }
    const Halfedge h = halfedge_of_face_outside(f), g = next_outside(h), k = next_outside(g);
    return { target_outside(h), target_outside(g), target_outside(k) };
  }

  std::array<Index, 3> vertices_outside(Face f) const
  {
    std::array<Index, 3> v = f.owner == Face::A ? vertices_of_a(f.x) : vertices_of_b(f.x);
    for (Index& x : v)
      x = vertex(x);
    return v;
  }

  // Whether v, outside of the core, has a star as in the core, but for the numbers of its neighbors.
  bool has_plain_star(Index v) const
  {
    return m_mask.empty() && v < m_numbering.border && !m_records.has_more_sectors(v);
  }

  // The visitors of stars are called where they are passed to: if a function that is not inlined got their
  // addresses, compilers would keep in memory what they refer to, in the core too. So stars outside are put down first.
  template <class Visitor>
  void for_each_adjacent_vertex_outside(Index v, Visitor&& visit) const
  {
    Neighbors neighbors;
    find_neighbors(v, neighbors);
    for (const Index u : neighbors)
      visit(u);
  }

  template <class Visitor>
  void for_each_incident_triangle_outside(Index v, Visitor&& visit) const
  {
    Corners corners;
    find_corners(v, corners);
    for (const auto& corner : corners)
      visit(corner.first, corner.second);
  }

  BOOST_NOINLINE void find_neighbors(Index v, Neighbors& neighbors) const
  {
    if (has_plain_star(v))
      Star<Inner>(inner(), v).for_each_neighbor([&](Index x) { neighbors.push_back(vertex(x)); });
    else
      everything().for_each_adjacent_vertex(v, [&](Index u) { neighbors.push_back(u); });
  }

  BOOST_NOINLINE void find_corners(Index v, Corners& corners) const
  {
    if (has_plain_star(v))
      Star<Inner>(inner(), v).for_each_triangle(
        [&](Index x, Index y) { corners.emplace_back(vertex(x), vertex(y)); });
    else
      everything().for_each_incident_triangle(v, [&](Index u, Index w) { corners.emplace_back(u, w); });
  }

  BOOST_NOINLINE Index degree_outside(Index v) const
  {
    return has_plain_star(v) ? Star<Inner>(inner(), v).degree() : everything().degree(v);
  }

  Records m_records;
  Numbering m_numbering;
  Mask m_mask;
};

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_SCHNYDER_PARENTS_LAYOUT_H
