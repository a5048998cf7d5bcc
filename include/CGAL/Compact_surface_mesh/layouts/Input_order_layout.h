// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INPUT_ORDER_LAYOUT_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INPUT_ORDER_LAYOUT_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/Input_images.h>
#include <CGAL/Compact_surface_mesh/layouts/Schnyder_parents_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/internal/for_each_face_from.h>

#include <array>
#include <cstddef>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/// \ingroup PkgCompactSurfaceMeshRef
/// Which elements of an `Input_order_layout` have the indices that they have in the input.
enum class Input_order
{
  VERTICES,          ///< vertices
  VERTICES_AND_FACES ///< vertices and faces
};

namespace internal {

// A permutation of indices, both ways. Without the option it is the identity and stores nothing.
template <class Index, bool is_stored>
class Two_way_permutation
{
public:
  Two_way_permutation() = default;

  // image[i] is what input i has become
  explicit Two_way_permutation(std::vector<Index>&& image)
    : m_image(std::move(image)), m_input(m_image.size())
  {
    m_image.shrink_to_fit();
    for (std::size_t i = 0; i < m_image.size(); ++i)
      m_input[m_image[i]] = static_cast<Index>(i);
  }

  Index image(Index i) const { return m_image[i]; }
  Index input(Index i) const { return m_input[i]; }
  std::size_t bytes() const { return (m_image.capacity() + m_input.capacity()) * sizeof(Index); }

private:
  std::vector<Index> m_image, m_input;
};

template <class Index>
class Two_way_permutation<Index, false>
{
public:
  static Index image(Index i) { return i; }
  static Index input(Index i) { return i; }
  static std::size_t bytes() { return 0; }
};

} // namespace internal

/*!
\ingroup PkgCompactSurfaceMeshRef

The class `Input_order_layout` is another layout in which vertices have the indices that they have in the
input, and with `Input_order::VERTICES_AND_FACES` faces as well. It is for programs that count on this: the i-th vertex
is that of the i-th point of a soup, the i-th in `vertices(g)`, or the i-th of a file. Then `vertex_to_vertex_map` and
its kin are not needed.

This takes two indices more for each vertex, 8 bytes for a 32-bit `Index`, and as many for each face if these
keep their order, too: 16 bytes for each vertex of a triangle mesh. A query that takes or returns a vertex
or a face looks one index up. Halfedges and edges have the indices that they have in the other layout, and where
vertices lie close together in memory, their points and properties now do only if they did in the input.

\tparam Layout the layout that stores the connectivity: a model of `CompactSurfaceMeshLayout`
\tparam order which elements keep their indices

\cgalModels{CompactSurfaceMeshLayout}
*/
template <class Layout = Schnyder_parents_layout<>, Input_order order = Input_order::VERTICES>
class Input_order_layout
{
  static constexpr bool has_order_of_faces = order == Input_order::VERTICES_AND_FACES;

public:
  /// the integer type of all indices.
  using Index = typename Layout::Index;
  /// names a halfedge, as in `Layout`.
  using Halfedge = typename Layout::Halfedge;

  /// whether `edge(h) == h / 2` and `opposite(h) == (h ^ 1)`.
  static constexpr bool edge_is_half_of_halfedge = Layout::edge_is_half_of_halfedge;

  /// returns the index of no element: the largest value of `Index`.
  static constexpr Index null_index() { return Layout::null_index(); }
  /// returns the name of `Layout` with `"-input-order"` behind, or `"-input-order-of-vertices-and-faces"`.
  static std::string name()
  {
    return Layout::name() + (has_order_of_faces ? "-input-order-of-vertices-and-faces" : "-input-order");
  }
  /// returns the largest number of vertices that `Layout` can hold.
  static std::size_t max_vertices() { return Layout::max_vertices(); }

  /// creates the layout of the empty mesh.
  Input_order_layout() = default;

  /*!
  builds the layout of `t`, in the time that `Layout` takes and linear time beside that.
  \param t the triangulation; it is empty afterwards
  \param images tells what becomes of the elements of the input: of vertices, nothing
  \param arguments go to the constructor of `Layout`
  \throws Mesh_defect_exception if `Layout` does
  */
  template <class... Arguments
#ifndef DOXYGEN_RUNNING
            , class = std::enable_if_t<std::is_constructible<Layout, Closed_triangulation<Index>, Input_images<Index>&,
                                                             const Arguments&...>::value>
#endif
            >
  Input_order_layout(Closed_triangulation<Index>&& t, Input_images<Index>& images, const Arguments&... arguments)
  {
    Input_images<Index> base_images;
    base_images.wants_halfedges = images.wants_halfedges || has_order_of_faces;
    m_base = Layout(std::move(t), base_images, arguments...);
    if constexpr (has_order_of_faces)
      m_faces = Faces(first_faces(base_images.halfedges));
    m_vertices = Vertices(std::move(base_images.vertices));
    images.vertices.resize(m_base.num_vertices());
    std::iota(images.vertices.begin(), images.vertices.end(), Index(0));
    if (images.wants_halfedges)
      images.halfedges = std::move(base_images.halfedges);
    else
      images.halfedges.clear();
  }

  /// \name Counts
  /// in constant time.
  /// @{

  /// returns the number of vertices.
  std::size_t num_vertices() const { return m_base.num_vertices(); }
  /// returns the number of halfedges.
  std::size_t num_halfedges() const { return m_base.num_halfedges(); }
  /// returns the number of edges.
  std::size_t num_edges() const { return m_base.num_edges(); }
  /// returns the number of faces.
  std::size_t num_faces() const { return m_base.num_faces(); }
  /// @}

  /// \name Navigation
  /// in the time that `Layout` takes.
  /// @{

  /// returns the next halfedge counterclockwise around the face of `h`.
  Halfedge next(Halfedge h) const { return m_base.next(h); }
  /// returns the halfedge whose next one is `h`.
  Halfedge prev(Halfedge h) const { return m_base.prev(h); }
  /// returns the other halfedge of the edge of `h`.
  Halfedge opposite(Halfedge h) const { return m_base.opposite(h); }
  /// returns the vertex where `h` starts.
  Index source(Halfedge h) const { return m_vertices.input(m_base.source(h)); }
  /// returns the vertex where `h` ends.
  Index target(Halfedge h) const { return m_vertices.input(m_base.target(h)); }
  /// returns the face to the left of `h`, `null_index()` on a border.
  Index face(Halfedge h) const
  {
    const Index f = m_base.face(h);
    return has_order_of_faces && f == null_index() ? f : m_faces.input(f);
  }
  /// returns whether `h` is known to be a side of a triangle.
  bool is_in_triangle(Halfedge h) const { return m_base.is_in_triangle(h); }
  /// returns the vertices of the triangle of `h` counterclockwise, from its target on, if `is_in_triangle(h)`.
  std::array<Index, 3> vertices_of_triangle(Halfedge h) const { return input(m_base.vertices_of_triangle(h)); }
  /// returns the edge of `h`.
  Index edge(Halfedge h) const { return m_base.edge(h); }
  /// returns one of the halfedges of `e`, always the same.
  Halfedge halfedge_of_edge(Index e) const { return m_base.halfedge_of_edge(e); }
  /// returns a halfedge whose target is `v`, always the same: a border halfedge if `v` lies on a
  /// border, `null_index()` if `v` is isolated.
  Halfedge halfedge_of_vertex(Index v) const { return m_base.halfedge_of_vertex(m_vertices.image(v)); }
  /// returns a halfedge whose face is `f`, always the same.
  Halfedge halfedge_of_face(Index f) const { return m_base.halfedge_of_face(m_faces.image(f)); }
  /// returns the target of `halfedge_of_face(f)`.
  Index vertex_of_face(Index f) const { return m_vertices.input(m_base.vertex_of_face(m_faces.image(f))); }
  /// returns the halfedge from `u` to `v`, `null_index()` if they are not adjacent.
  Halfedge halfedge(Index u, Index v) const { return m_base.halfedge(m_vertices.image(u), m_vertices.image(v)); }
  /// @}

  /// \name Whole Stars
  /// @{

  /// calls `visit(u)` for each vertex `u` adjacent to `v`, once each, in no particular order.
  template <class Visitor>
  void for_each_adjacent_vertex(Index v, Visitor&& visit) const
  {
    m_base.for_each_adjacent_vertex(m_vertices.image(v), [&](Index u) { visit(m_vertices.input(u)); });
  }

  /// calls `visit(u, w)` for each face at `v`, once each, in no particular order, where `u` follows
  /// and `w` precedes `v` in the face counterclockwise: a triangle is (`v`,`u`,`w`).
  template <class Visitor>
  void for_each_incident_triangle(Index v, Visitor&& visit) const
  {
    m_base.for_each_incident_triangle(m_vertices.image(v), [&](Index u, Index w) {
      visit(m_vertices.input(u), m_vertices.input(w));
    });
  }

  /// returns the number of edges at `v`.
  Index degree(Index v) const { return m_base.degree(m_vertices.image(v)); }

  /// returns the vertices of `f` counterclockwise, from the target of `halfedge_of_face(f)` on;
  /// of a polygon, only the first three.
  std::array<Index, 3> vertices_of_face(Index f) const
  {
    return input(m_base.vertices_of_face(m_faces.image(f)));
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

  /// returns the arrays that `Layout` holds and the orders, with the bytes that they have allocated.
  std::vector<std::pair<std::string, std::size_t>> memory() const
  {
    auto arrays = m_base.memory();
    arrays.emplace_back("order of vertices", m_vertices.bytes());
    if (has_order_of_faces)
      arrays.emplace_back("order of faces", m_faces.bytes());
    return arrays;
  }

  /// @}

private:
  using Vertices = internal::Two_way_permutation<Index, true>;
  using Faces = internal::Two_way_permutation<Index, has_order_of_faces>;

  std::array<Index, 3> input(std::array<Index, 3> vertices) const
  {
    for (Index& v : vertices)
      v = m_vertices.input(v);
    return vertices;
  }

  // The faces of m_base in the order of the input, of whose faces `sides` has the halfedges one after the other.
  std::vector<Index> first_faces(const std::vector<Index>& sides) const
  {
    std::vector<Index> faces;
    faces.reserve(m_base.num_faces());
    for (std::size_t i = 0; i < sides.size();) {
      const Index f = m_base.face(sides[i]);
      faces.push_back(f);
      const Halfedge first = sides[i];
      Halfedge h = first;
      do {
        ++i;
        h = m_base.next(h);
      } while (h != first);
    }
    return faces;
  }

  Layout m_base;
  Vertices m_vertices;
  Faces m_faces;
};

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INPUT_ORDER_LAYOUT_H
