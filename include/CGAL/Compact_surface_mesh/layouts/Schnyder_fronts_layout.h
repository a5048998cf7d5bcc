// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_SCHNYDER_FRONTS_LAYOUT_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_SCHNYDER_FRONTS_LAYOUT_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/Input_images.h>
#include <CGAL/Compact_surface_mesh/internal/Divided_index.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Mask.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Masked_triangles.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_fronts_builder.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_fronts_numbering.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_fronts_operators.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_fronts_records.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/Schnyder_triangles.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/around_vertex.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/for_each_face_from.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/wood_of_triangulation.h>
#include <CGAL/Schnyder_woods/Shelling_order.h>

#include <boost/config.hpp>

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

The class `Schnyder_fronts_layout` stores the connectivity of a mesh in four, five or six references per vertex, which
are <em>fronts</em>: for each of the three edges of a Schnyder wood out of a vertex, the edges next to it around
its target. These are the structures of L. Castelli Aleardi and O. Devillers, <em>Array-based compact data structures
for triangulations</em>, Journal of Computational Geometry 9(1), 2018. They are there to compare with
`Schnyder_parents_layout`.

| references | with targets | source | vertices | `target()`, `source()`, `halfedge(u, v)` | bytes |
| :--------: | :----------: | :----- | :------- | :--------------------------------------- | :---: |
| 6 | no | theorem 2 | keep the order of the input | linear in a degree | 24 |
| 5 | no | theorem 4 | keep the order of the input | linear in a degree | 20 |
| 4 | no | theorem 5 | are renumbered | linear in a degree | 16 |
| 5 | yes | theorem 6 | are renumbered | constant | 20 |

Bytes are per vertex, for a 32-bit `Index`. The degree is that of the vertex which is looked for. Halfedges are named by
a vertex where they start or end: that one is always known in constant time, and with four references the targets of
red edges are as well. All other queries take constant time in the worst case.

Faces cost nothing, other than in theorem 7: each is to the left of one red edge or to the right of one black edge,
and never both. With four and five references, the wood is the one that has no clockwise face. Corners are halfedges.

The structures are extended from spheres to all surfaces. Where no border, special edge of the wood, polygon or
vertex with several fans is near, and nothing was moved to where nothing is, vertex \f$u\f$ has the halfedges
\f$6u + k\f$: \f$k = 0, 2, 4\f$ run along its red, blue and black edge out, and \f$k + 1\f$ back, and the faces
\f$2u\f$ and \f$2u + 1\f$. Everywhere, opposite halfedges differ in the last bit, and halfedge \f$h\f$ belongs to
edge \f$h/2\f$. Elsewhere queries also take time logarithmic in the numbers of vertices, borders, handles and
vertices with several fans.

Beside the records of its vertices, a component costs at most 20 words; a border vertex 4, or all of them eight bits
for each vertex of the mesh; a further border of a component 16, and two more records; a handle 32, and four more
records; a vertex with \f$k\f$ fans \f$6k - 2\f$, and \f$k - 1\f$ more records; and an isolated vertex 10. A polygon has
hidden diagonals, or a hidden vertex, which has a record as others have; then all edges, faces and vertices have a bit
with its rank directory.

\tparam References 4, 5 or 6
\tparam has_targets whether one of five references is to the target of an edge
\tparam Index_ an unsigned integer type; four of its bits are flags, so that with 32 bits
meshes have at most \f$2^{28}\f$ vertices.

\cgalModels{CompactSurfaceMeshLayout}
*/
template <int References = 4, bool has_targets = false, class Index_ = std::uint32_t>
class Schnyder_fronts_layout
{
  typedef internal::Schnyder_fronts_records<References, has_targets, Index_> Records;
  typedef internal::Schnyder_fronts_numbering<Index_> Numbering;
  typedef internal::Schnyder_fronts_zone<Records, Index_> Zone;
  typedef internal::Schnyder_fronts_operators<Records, Index_, internal::Schnyder_core_zone<Index_>> Core;
  typedef internal::Schnyder_triangles<internal::Schnyder_fronts_operators<Records, Index_, Zone>, Numbering, Index_>
    Triangles;
  typedef internal::Mask<Index_, true> Mask;
  typedef internal::Masked_triangles<Triangles, Mask, Index_> Everything;
  typedef internal::Schnyder_side<Index_> Side;

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
  /// whether vertices keep the order of the input.
  static constexpr bool keeps_vertex_order = !Records::is_renumbered;

  /// returns the index of no element: the largest value of `Index`.
  static constexpr Index null_index() { return (std::numeric_limits<Index>::max)(); }
  /// returns `"schnyder-fronts-4n"`, with the number of references, and `"-targets"` behind it if it has them.
  static std::string name()
  {
    return "schnyder-fronts-" + std::to_string(References) + (has_targets ? "n-targets" : "n");
  }
  /// returns the largest number of vertices that fits beside the flags in `Index`.
  static constexpr std::size_t max_vertices() { return Records::max_records; }

  /// returns the largest number of steps in which a target is found, if there are targets; else they are as many as the
  /// degree of the target.
  static constexpr std::size_t max_walk_length() { return has_targets ? 2 : max_vertices(); }

  /// creates the layout of the empty mesh.
  Schnyder_fronts_layout() = default;

  /*!
  builds the layout of `t`, in the time that the shelling takes, which is nearly linear.
  \param t the triangulation; it is empty afterwards
  \param images tells what becomes of the elements of the input
  \param order in which order the shelling that finds the Schnyder wood takes vertices
  \param seed of `Shelling_order::RANDOM`
  \throws Mesh_defect_exception if the mesh has more than `max_vertices()` vertices, where those
  count as well that are hidden, but not at apices, and the further sectors of vertices at special edges
  */
  Schnyder_fronts_layout(Closed_triangulation<Index>&& t, Input_images<Index>& images,
                         Shelling_order order = Shelling_order::LAST_IN_FIRST_OUT, unsigned int seed = 0)
  {
    if (t.first_apex() > max_vertices())
      throw Mesh_defect_exception(Mesh_defect::too_many_elements, t.first_apex());
    internal::Schnyder_wood wood = internal::shelled_wood(t, order, seed);
    if (Records::num_fronts != 6)
      internal::make_wood_extremal(t, wood);
    internal::Schnyder_fronts_builder<References, has_targets, Index> builder(t, wood, m_records, m_numbering);
    builder();

    std::vector<Index> halfedges;
    if (images.wants_halfedges || t.simple().has_hidden())
      halfedges = internal::numbers_of_halfedges(t, builder.sides(), triangles());
    std::vector<Index> vertices(builder.records_of_vertices().begin(),
                                builder.records_of_vertices().begin() + static_cast<std::ptrdiff_t>(t.first_copy()));
    for (Index& x : vertices)
      x = triangles().vertex(x);
    if (t.simple().has_hidden())
      m_mask = Mask(triangles(), t, vertices, halfedges);
    builder.mark_plain([this](Index x) {
      return m_mask.empty()
          || (m_mask.keeps_vertex(x) && m_mask.keeps_face(2 * x) && m_mask.keeps_face(2 * x + 1)
              && m_mask.keeps_halfedge(6 * x) && m_mask.keeps_halfedge(6 * x + 2) && m_mask.keeps_halfedge(6 * x + 4));
    });
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
  /// In constant time unless said otherwise, but see above for borders and what else is special.
  /// @{

  /// returns the next halfedge counterclockwise around the face of `h`.
  BOOST_FORCEINLINE Halfedge next(Halfedge h) const
  {
    return BOOST_LIKELY(is_plain(h)) ? halfedge(core().next(side(h))) : next_elsewhere(h);
  }

  /// returns the halfedge whose next one is `h`.
  BOOST_FORCEINLINE Halfedge prev(Halfedge h) const
  {
    return BOOST_LIKELY(is_plain(h)) ? halfedge(core().prev(side(h))) : prev_elsewhere(h);
  }

  /// returns the other halfedge of the edge of `h`.
  static Halfedge opposite(Halfedge h) { return Halfedge::with_code(h.code() ^ 1); }

  /// returns the vertex where `h` starts; for odd `h` in time linear in its degree, unless there are targets.
  BOOST_FORCEINLINE Index source(Halfedge h) const
  {
    return BOOST_LIKELY(is_plain(h)) ? core().source(side(h)) : source_elsewhere(h);
  }

  /// returns the vertex where `h` ends; for even `h` in time linear in its degree, unless there are targets.
  BOOST_FORCEINLINE Index target(Halfedge h) const
  {
    return BOOST_LIKELY(is_plain(h)) ? core().target(side(h)) : target_elsewhere(h);
  }

  /// returns the face to the left of `h`, `null_index()` on a border.
  BOOST_FORCEINLINE Index face(Halfedge h) const
  {
    if (BOOST_UNLIKELY(!is_plain(h)))
      return face_elsewhere(h);
    const auto f = core().face(side(h));
    return static_cast<Index>(2 * f.x + f.owner);
  }

  /// returns whether `h` is known to be a side of a triangle.
  bool is_in_triangle(Halfedge h) const { return !h.is_null() && is_plain(h); }
  /// returns the vertices of the triangle of `h` counterclockwise, from its target on, if `is_in_triangle(h)`.
  BOOST_FORCEINLINE std::array<Index, 3> vertices_of_triangle(Halfedge h) const
  {
    return { target(h), target(next(h)), source(h) };
  }

  /// returns the edge of `h`.
  static Index edge(Halfedge h) { return h / 2; }
  /// returns the halfedge of `e` that starts at the vertex which owns `e`.
  static Halfedge halfedge_of_edge(Index e) { return static_cast<Index>(2 * e); }

  /// returns a halfedge whose target is `v`, always the same: a border halfedge if `v` lies on a
  /// border, `null_index()` if `v` is isolated.
  BOOST_FORCEINLINE Halfedge halfedge_of_vertex(Index v) const
  {
    return BOOST_LIKELY(m_records.is_plain(v)) ? Halfedge::of(v, 1) : halfedge_of_vertex_elsewhere(v);
  }

  /// returns a halfedge whose face is `f`, always the same.
  BOOST_FORCEINLINE Halfedge halfedge_of_face(Index f) const
  {
    return BOOST_LIKELY(m_records.is_plain(f / 2)) ? Halfedge::of(f / 2, f & 1 ? 5 : 0) : halfedge_of_face_elsewhere(f);
  }

  /// returns the target of `halfedge_of_face(f)`.
  Index vertex_of_face(Index f) const { return target(halfedge_of_face(f)); }

  /// returns the halfedge from `u` to `v`, `null_index()` if they are not adjacent; in time linear in the degrees of
  /// neighbors of `u` and `v`, unless there are targets.
  Halfedge halfedge(Index u, Index v) const
  {
    if (BOOST_UNLIKELY(!m_records.is_plain(u) || !m_records.is_plain(v)))
      return everything().halfedge(u, v);
    for (unsigned k = 0; k < 6; k += 2)
      if (core().target(Side{ u, k }) == v)
        return Halfedge::of(u, k);
    for (unsigned k = 0; k < 6; k += 2)
      if (core().target(Side{ v, k }) == u)
        return Halfedge::of(v, k + 1);
    return null_index();
  }

  /// @}

  /// \name Whole Stars
  /// In time linear in the degree of the vertex and those of the neighbors to which it owns edges; with targets, in
  /// the degree of the vertex alone.
  /// @{

  /// calls `visit(u)` for each vertex `u` adjacent to `v`, once each, in no particular order.
  template <class Visitor>
  void for_each_adjacent_vertex(Index v, Visitor&& visit) const
  {
    internal::for_each_halfedge_into(*this, v, [&](Halfedge h) { visit(source(h)); });
  }

  /// calls `visit(u, w)` for each face at `v`, once each, in no particular order, where `u` follows
  /// and `w` precedes `v` in the face counterclockwise: a triangle is (`v`,`u`,`w`).
  template <class Visitor>
  void for_each_incident_triangle(Index v, Visitor&& visit) const
  {
    if (BOOST_UNLIKELY(!m_records.is_plain(v))) {
      internal::for_each_corner_at(*this, v, visit);
      return;
    }
    const Halfedge first = Halfedge::of(v, 1);
    const Index start = source(first);
    Index w = start;
    Halfedge h = first;
    do {
      h = opposite(next(h));
      const Index u = h.code() == first.code() ? start : source(h);
      visit(u, w);
      w = u;
    } while (h.code() != first.code());
  }

  /// returns the number of edges at `v`.
  Index degree(Index v) const
  {
    Index d = 0;
    internal::for_each_halfedge_into(*this, v, [&d](Halfedge) { ++d; });
    return d;
  }

  /// returns the vertices of `f` counterclockwise, from the target of `halfedge_of_face(f)` on;
  /// of a polygon, only the first three.
  std::array<Index, 3> vertices_of_face(Index f) const
  {
    const Halfedge h = halfedge_of_face(f);
    if (BOOST_UNLIKELY(!is_plain(h))) {
      const Halfedge g = next(h);
      return { target(h), target(g), target(next(g)) };
    }
    const Side s = side(h), t = core().next(s), u = core().prev(s);
    return { core().vertex_between(s, t), core().vertex_between(t, u), core().vertex_between(u, s) };
  }

  /// calls `visit(f, u, v, w)` for each face `f` in their order, where `u`, `v`, `w` are `vertices_of_face(f)`.
  template <class Visitor>
  void for_each_face(Visitor&& visit) const
  {
    internal::for_each_face_from(0, *this, visit);
  }

  /// @}

  /// \name Memory
  /// @{

  /// returns the arrays that the layout holds, with the bytes that they have allocated.
  std::vector<std::pair<std::string, std::size_t>> memory() const
  {
    return { { "records", m_records.records.capacity() * sizeof(typename Records::Record) },
             { "borders and handles", m_numbering.bytes() },
             { "mask of polygons", m_mask.bytes() } };
  }

  /// @}

private:
  Core core() const { return Core{ m_records, {} }; }
  Triangles triangles() const { return Triangles({ m_records, Zone{ m_records, m_numbering } }, m_numbering); }
  Everything everything() const { return Everything(triangles(), m_mask); }

  bool is_plain(Halfedge h) const { return m_records.is_plain(h.quotient()); }
  static Side side(Halfedge h) { return { h.quotient(), h.remainder() }; }
  static Halfedge halfedge(Side s) { return Halfedge::of(s.x, s.k); }

  BOOST_NOINLINE Halfedge next_elsewhere(Index h) const { return everything().next(h); }
  BOOST_NOINLINE Halfedge prev_elsewhere(Index h) const { return everything().prev(h); }
  BOOST_NOINLINE Index source_elsewhere(Index h) const { return everything().source(h); }
  BOOST_NOINLINE Index target_elsewhere(Index h) const { return everything().target(h); }
  BOOST_NOINLINE Index face_elsewhere(Index h) const { return everything().face(h); }
  BOOST_NOINLINE Halfedge halfedge_of_vertex_elsewhere(Index v) const { return everything().halfedge_of_vertex(v); }
  BOOST_NOINLINE Halfedge halfedge_of_face_elsewhere(Index f) const { return everything().halfedge_of_face(f); }

  Records m_records;
  Numbering m_numbering;
  Mask m_mask;
};

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_SCHNYDER_FRONTS_LAYOUT_H
