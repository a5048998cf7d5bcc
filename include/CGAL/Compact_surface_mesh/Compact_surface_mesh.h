// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The class: navigation over a layout, joined to properties and ranges, which have headers
// of their own. Programs include <CGAL/Compact_surface_mesh.h>, which makes it a graph as well.

#ifndef CGAL_COMPACT_SURFACE_MESH_COMPACT_SURFACE_MESH_H
#define CGAL_COMPACT_SURFACE_MESH_COMPACT_SURFACE_MESH_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Compact_surface_mesh_fwd.h>

#include <CGAL/Compact_surface_mesh/Element_properties.h>
#include <CGAL/Compact_surface_mesh/Element_ranges.h>
#include <CGAL/Compact_surface_mesh/descriptors.h>
#include <CGAL/Compact_surface_mesh/internal/Fixed_connectivity.h>
#include <CGAL/Compact_surface_mesh/internal/Mesh_construction.h>
#include <CGAL/Compact_surface_mesh/internal/Validity_check.h>
#include <CGAL/Compact_surface_mesh/internal/versions_of_cgal.h>
#include <CGAL/Compact_surface_mesh/layouts/Schnyder_parents_layout.h>
#include <CGAL/Compact_surface_mesh/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>

#include <boost/config.hpp>
#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <iostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

namespace internal {

template <class Layout>
using Descriptors_of_layout =
  Compact_surface_mesh_descriptors::Descriptors<typename Layout::Index, typename Layout::Halfedge,
                                                Layout::edge_is_half_of_halfedge>;

template <class Point, class Descriptors>
using Element_properties_of =
  Element_properties<Point, typename Descriptors::Vertex_index, typename Descriptors::Halfedge_index,
                     typename Descriptors::Edge_index, typename Descriptors::Face_index>;

template <class Mesh, class Descriptors>
using Element_ranges_of =
  Element_ranges<Mesh, typename Descriptors::Vertex_index, typename Descriptors::Halfedge_index,
                 typename Descriptors::Edge_index, typename Descriptors::Face_index>;

template <class Descriptors>
using Fixed_connectivity_of =
  Fixed_connectivity<typename Descriptors::Vertex_index, typename Descriptors::Halfedge_index,
                     typename Descriptors::Face_index>;

} // namespace internal

/*!
\ingroup PkgCompactSurfaceMeshRef

The class `Compact_surface_mesh` is a surface mesh whose connectivity is made once and
never edited, in a fraction of the memory of `Surface_mesh`. Points and properties are
read and written freely. It has the names, the descriptors, the ranges, the property maps
and the free functions of `Surface_mesh`, so that algorithms which do not edit
connectivity run on it unchanged.

<b>Elements are renumbered.</b> The layout chooses the order of vertices, halfedges, edges
and faces. The constructors tell it on request: which element of the mesh an element of
the input became by the named parameters `vertex_to_vertex_map` and its kin, and from
which one it came by the property maps of `parameters::input_index_maps()`.

<b>All oriented manifolds are taken</b>, with any number of components, borders, handles and isolated
vertices, and with faces of any number of sides. A vertex may have several fans of faces if
these are all open: then the halfedges around it run through all of them, and a border goes
from each fan to another one. Faces must not visit a vertex twice. What is refused, and how
this is told, is said at `Mesh_defect`.

\tparam Point_ the type of the points of the vertices: any type that can be default
constructed and copied. Algorithms want a point of a \cgal kernel.
\tparam Layout_ the way in which the connectivity is stored: a model of
`CompactSurfaceMeshLayout`

\cgalModels{FaceListGraph, HalfedgeListGraph}

It is also a model of the concepts of \boost.Graph
<a href="https://www.boost.org/libs/graph/doc/BidirectionalGraph.html">BidirectionalGraph</a>,
<a href="https://www.boost.org/libs/graph/doc/AdjacencyGraph.html">AdjacencyGraph</a>,
<a href="https://www.boost.org/libs/graph/doc/VertexListGraph.html">VertexListGraph</a>,
<a href="https://www.boost.org/libs/graph/doc/EdgeListGraph.html">EdgeListGraph</a> and
<a href="https://www.boost.org/libs/graph/doc/PropertyGraph.html">PropertyGraph</a>, as an
undirected graph without parallel edges. It is no model of `MutableHalfedgeGraph` or
`MutableFaceGraph`, and has none of their functions.

<b>Property maps by tag.</b> `get(tag, mesh)` returns

| tag | property map |
| :-- | :----------- |
| `boost::vertex_index_t` and its three kin | the indices; readable |
| `CGAL::vertex_point_t` | the points, `points()` |
| `boost::edge_weight_t` | the lengths of the edges; readable |
| `CGAL::dynamic_vertex_property_t<T>` and its three kin | a new map, which lives as long as a copy of it |
| `CGAL::edge_is_feature_t` | `"e:is_feature"` with values of type `bool` |
| `CGAL::vertex_feature_degree_t` | `"v:nfe"` with values of type `int` |
| `CGAL::vertex_incident_patches_t<T>` | `"v:ip"` with values of type `std::set<T>` |
| `CGAL::face_patch_id_t<T>` | `"f:patch_id"` with values of type `T` |
| `CGAL::vertex_time_stamp_t` and its two kin | `"v:time_stamp"` with values of type `std::size_t` |

The named maps are found, and added to a mesh that may be changed if it has no map of that name.
As the property graph that it is, the mesh also has `get(tag, mesh, element)`, which returns
a value of the maps in the first three rows, and `put(CGAL::vertex_point, mesh, v, point)`.

\sa `Element_properties`
\sa `Element_ranges`
\sa \ref Compact_surface_mesh_descriptors::Descriptor "Descriptor"
\sa `CompactSurfaceMeshLayout`
\sa `Surface_mesh`
*/
template <class Point_, class Layout_>
class Compact_surface_mesh
  : public internal::Element_properties_of<Point_, internal::Descriptors_of_layout<Layout_> >
  , public internal::Element_ranges_of<Compact_surface_mesh<Point_, Layout_>, internal::Descriptors_of_layout<Layout_> >
#ifndef DOXYGEN_RUNNING
  , public internal::Fixed_connectivity_of<internal::Descriptors_of_layout<Layout_> >
#endif
{
  using Self = Compact_surface_mesh;
  using Descriptors = internal::Descriptors_of_layout<Layout_>;
  using Properties_base = internal::Element_properties_of<Point_, Descriptors>;
  template <class Tag> using Descriptor = Compact_surface_mesh_descriptors::Descriptor<Tag, typename Layout_::Index>;
  using Vertex_tag = Compact_surface_mesh_descriptors::Vertex_tag;
  using Halfedge_tag = Compact_surface_mesh_descriptors::Halfedge_tag;
  using Edge_tag = Compact_surface_mesh_descriptors::Edge_tag;
  using Face_tag = Compact_surface_mesh_descriptors::Face_tag;

public:
  /// \name Types
  /// @{

  /// the type of the points of the vertices.
  using Point = Point_;
  /// the type that stores the connectivity.
  using Layout = Layout_;
  /// the type of indices and counts.
  using size_type = typename Layout::Index;

  /// the \ref Compact_surface_mesh_descriptors::Descriptor "Descriptor" of a vertex.
  using Vertex_index = typename Descriptors::Vertex_index;
  /// the \ref Compact_surface_mesh_descriptors::Descriptor "Descriptor" of a halfedge.
  using Halfedge_index = typename Descriptors::Halfedge_index;
  /// the \ref Compact_surface_mesh_descriptors::Descriptor "Descriptor" of an edge.
  using Edge_index = typename Descriptors::Edge_index;
  /// the \ref Compact_surface_mesh_descriptors::Descriptor "Descriptor" of a face.
  using Face_index = typename Descriptors::Face_index;
  /// @}

#ifndef DOXYGEN_RUNNING
  // the second names that Surface_mesh has for them
  using vertex_index = Vertex_index;
  using halfedge_index = Halfedge_index;
  using edge_index = Edge_index;
  using face_index = Face_index;
  using vertex_property_type = Point;
  using out_edge_iterator = CGAL::Out_edge_iterator<Self>;
  using directed_category = boost::undirected_tag;
  using edge_parallel_category = boost::disallow_parallel_edge_tag;
  struct traversal_category
    : public virtual boost::bidirectional_graph_tag
    , public virtual boost::vertex_list_graph_tag
    , public virtual boost::edge_list_graph_tag
    , public virtual boost::adjacency_graph_tag
  {};
  using vertices_size_type = size_type;
  using halfedges_size_type = size_type;
  using edges_size_type = size_type;
  using faces_size_type = size_type;
  using degree_size_type = size_type;
  template <class I, class T> using Property_map = typename Properties_base::template Property_map<I, T>;
#endif

  /// \name Construction
  /// All constructions take linear time beside what the layout takes.
  /// @{

  /// creates the empty mesh.
  Compact_surface_mesh() = default;

  /// copies `other` with all its property maps.
  Compact_surface_mesh(const Compact_surface_mesh& other) = default;

  /// copies `other` with all its property maps.
  Compact_surface_mesh& operator=(const Compact_surface_mesh& other)
  {
    Compact_surface_mesh copy(other);
    swap(copy);
    return *this;
  }

  /// takes the contents of `other`, which becomes the empty mesh; in constant time.
  Compact_surface_mesh(Compact_surface_mesh&& other) noexcept { swap(other); }

  /// takes the contents of `other`, which becomes the empty mesh; in constant time.
  Compact_surface_mesh& operator=(Compact_surface_mesh&& other) noexcept
  {
    Compact_surface_mesh moved(std::move(other));
    swap(moved);
    return *this;
  }

  /*!
  copies the mesh `g`.

  From a `Surface_mesh` or a `Compact_surface_mesh` it also copies all property maps whose values are numbers,
  strings, pairs of `int`, colors, or points, vectors and numbers of the kernel of the points of `g`.

  \tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
  \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

  \cgalNamedParamsBegin
    \cgalParamNBegin{vertex_point_map}
      \cgalParamDescription{a property map associating points to the vertices of `g`}
      \cgalParamType{a readable property map whose values are `Point`s, or points of another kernel}
      \cgalParamDefault{`boost::get(CGAL::vertex_point, g)`}
    \cgalParamNEnd
    \cgalParamNBegin{vertex_index_map}
      \cgalParamDescription{numbers the vertices of `g` from 0 without holes}
      \cgalParamType{a readable property map from vertices of `g` to integers}
      \cgalParamDefault{an automatically indexed map; elements of `g` that are only marked as removed are left out}
    \cgalParamNEnd
    \cgalParamNBegin{vertex_to_vertex_output_iterator}
      \cgalParamDescription{receives the pairs (vertex of `g`, vertex of the mesh), as from `copy_face_graph()`;
                            `halfedge_to_halfedge_output_iterator` and `face_to_face_output_iterator` likewise}
      \cgalParamType{an `OutputIterator`}
    \cgalParamNEnd
    \cgalParamNBegin{vertex_to_vertex_map}
      \cgalParamDescription{receives for each vertex of `g` the vertex of the mesh;
                            `halfedge_to_halfedge_map` and `face_to_face_map` likewise}
      \cgalParamType{a writable property map}
    \cgalParamNEnd
    \cgalParamNBegin{input_index_maps}
      \cgalParamDescription{whether to add the property maps `"v:input_index"` and `"f:input_index"` with
                            values of type `size_type`: the index of a vertex by the vertex index map, and
                            the place of a face in `faces(g)`}
      \cgalParamType{Boolean}
      \cgalParamDefault{`false`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  Maps and iterators are written to when all is done; what is not asked for costs nothing.

  \throws Mesh_defect_exception if `g` is no mesh that this class takes
  */
  template <class FaceGraph, class CGAL_NP_TEMPLATE_PARAMETERS
#ifndef DOXYGEN_RUNNING
            , class = std::enable_if_t<!std::is_base_of<Self, FaceGraph>::value>
            , class = typename internal::Possible_graph_traits<FaceGraph>::face_descriptor
#endif
            >
  explicit Compact_surface_mesh(const FaceGraph& g, const CGAL_NP_CLASS& np = parameters::default_values())
  {
    internal::Mesh_construction<Self>(*this, *this).copy_graph(g, np);
  }

  /*!
  builds the mesh of a polygon soup.

  \tparam PointRange a range of `Point`s, or of points of another kernel
  \tparam PolygonRange a range of ranges of at least three integers each
  \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

  \param points the points of the vertices
  \param polygons the indices in `points` of the vertices of each face, counterclockwise
  \param np as for the construction from a `FaceListGraph`, with integers in place of the
    descriptors of `g`: `vertex_to_vertex_output_iterator`, `vertex_to_vertex_map`,
    `face_to_face_output_iterator`, `face_to_face_map`, `input_index_maps`

  \throws Mesh_defect_exception if the soup is no mesh that this class takes
  */
  template <class PointRange, class PolygonRange, class CGAL_NP_TEMPLATE_PARAMETERS>
  Compact_surface_mesh(const PointRange& points, const PolygonRange& polygons,
                       const CGAL_NP_CLASS& np = parameters::default_values())
  {
    internal::Mesh_construction<Self>(*this, *this).take_soup(points, polygons, np);
  }

  /// copies connectivity and points of `other`, but no other property maps.
  Compact_surface_mesh& assign(const Compact_surface_mesh& other)
  {
    Compact_surface_mesh copy;
    copy.set_layout(Layout(other.m_layout));
    for (const Vertex_index v : copy.vertices())
      copy.point(v) = other.point(v);
    swap(copy);
    return *this;
  }

  /// exchanges this mesh and `other`, in constant time; property maps move with their mesh.
  void swap(Compact_surface_mesh& other) noexcept
  {
    this->swap_properties(other);
    std::swap(m_layout, other.m_layout);
  }

  /// exchanges `a` and `b`, in constant time.
  friend void swap(Compact_surface_mesh& a, Compact_surface_mesh& b) noexcept { a.swap(b); }

  /// makes the mesh empty and removes all property maps but the points.
  void clear()
  {
    clear_without_removing_property_maps();
    this->remove_all_property_maps();
  }

  /// makes the mesh empty and keeps its property maps, now empty as well.
  void clear_without_removing_property_maps()
  {
    set_layout(Layout());
    this->shrink_to_fit();
  }

  /// does nothing: connectivity is fixed. It is there for programs written for `Surface_mesh`.
  void reserve(size_type, size_type, size_type) {}

  /// @}

  /// \name Counts
  /// in constant time.
  /// @{

  /// returns the number of vertices.
  size_type number_of_vertices() const { return number_of(Vertex_tag()); }
  /// returns the number of halfedges: twice that of edges.
  size_type number_of_halfedges() const { return number_of(Halfedge_tag()); }
  /// returns the number of edges.
  size_type number_of_edges() const { return number_of(Edge_tag()); }
  /// returns the number of faces.
  size_type number_of_faces() const { return number_of(Face_tag()); }
  /// returns `number_of_vertices()`.
  size_type num_vertices() const { return number_of_vertices(); }
  /// returns `number_of_halfedges()`.
  size_type num_halfedges() const { return number_of_halfedges(); }
  /// returns `number_of_edges()`.
  size_type num_edges() const { return number_of_edges(); }
  /// returns `number_of_faces()`.
  size_type num_faces() const { return number_of_faces(); }
  /// returns whether there are no vertices.
  bool is_empty() const { return number_of_vertices() == 0; }
  /// @}

  /// \name Removed Elements
  /// There are none. The members are there for programs written for `Surface_mesh`.
  /// @{

  /// returns 0.
  size_type number_of_removed_vertices() const { return 0; }
  /// returns 0.
  size_type number_of_removed_halfedges() const { return 0; }
  /// returns 0.
  size_type number_of_removed_edges() const { return 0; }
  /// returns 0.
  size_type number_of_removed_faces() const { return 0; }
  /// returns `false`.
  template <class Tag> bool is_removed(Descriptor<Tag>) const { return false; }
  /// returns `false`.
  bool has_garbage() const { return false; }
  /// does nothing; a visitor would not be called.
  template <class... Visitor> void collect_garbage(Visitor&&...) {}
  /// does nothing: no element is ever removed.
  void set_recycle_garbage(bool) {}
  /// returns `true`, the default of `Surface_mesh`.
  bool does_recycle_garbage() const { return true; }
  /// @}

  /// \name Navigation
  /// in constant time, unless said otherwise. Arguments must be valid.
  /// @{

  /// returns the vertex where `h` ends.
  BOOST_FORCEINLINE Vertex_index target(Halfedge_index h) const { return Vertex_index(m_layout.target(h.name())); }
  /// returns the vertex where `h` starts.
  BOOST_FORCEINLINE Vertex_index source(Halfedge_index h) const { return Vertex_index(m_layout.source(h.name())); }
  /// returns the face to the left of `h`, null on a border.
  BOOST_FORCEINLINE Face_index face(Halfedge_index h) const { return Face_index(m_layout.face(h.name())); }
  /// returns the next halfedge counterclockwise around the face of `h`, or along its border.
  BOOST_FORCEINLINE Halfedge_index next(Halfedge_index h) const { return Halfedge_index(m_layout.next(h.name())); }
  /// returns the halfedge whose next one is `h`.
  BOOST_FORCEINLINE Halfedge_index prev(Halfedge_index h) const { return Halfedge_index(m_layout.prev(h.name())); }
  /// returns the other halfedge of the edge of `h`.
  BOOST_FORCEINLINE Halfedge_index opposite(Halfedge_index h) const
  {
    return Halfedge_index(m_layout.opposite(h.name()));
  }
  /// returns the edge of `h`, which remembers `h`.
  BOOST_FORCEINLINE Edge_index edge(Halfedge_index h) const
  {
    if constexpr (Layout::edge_is_half_of_halfedge)
      return Edge_index(h);
    else
      return Edge_index(m_layout.edge(h.name()), h);
  }

  /// returns a halfedge whose target is `v`: a border halfedge if `v` lies on a border, null if `v` is isolated.
  BOOST_FORCEINLINE Halfedge_index halfedge(Vertex_index v) const
  {
    return Halfedge_index(m_layout.halfedge_of_vertex(v));
  }
  /// returns a halfedge of `f`.
  BOOST_FORCEINLINE Halfedge_index halfedge(Face_index f) const { return Halfedge_index(m_layout.halfedge_of_face(f)); }
  /// returns the halfedge that `e` remembers.
  BOOST_FORCEINLINE Halfedge_index halfedge(Edge_index e) const
  {
    if constexpr (Layout::edge_is_half_of_halfedge)
      return e.halfedge();
    else
      return e.remembered_halfedge().is_valid() ? e.remembered_halfedge() : halfedge(e, 0);
  }
  /// returns the `i`-th halfedge of `e`, for `i` = 0 or 1, whatever `e` remembers.
  Halfedge_index halfedge(Edge_index e, unsigned int i) const
  {
    CGAL_assertion(i <= 1);
    const Halfedge_index h(m_layout.halfedge_of_edge(e));
    return i == 0 ? h : opposite(h);
  }
  /// returns the halfedge from `u` to `v`, null if there is none.
  Halfedge_index halfedge(Vertex_index u, Vertex_index v) const { return Halfedge_index(m_layout.halfedge(u, v)); }
  /// returns the target of the `i`-th halfedge of `e`, for `i` = 0 or 1.
  Vertex_index vertex(Edge_index e, unsigned int i) const { return target(halfedge(e, i)); }

  /// returns the next halfedge clockwise with the target of `h`.
  BOOST_FORCEINLINE Halfedge_index next_around_target(Halfedge_index h) const { return opposite(next(h)); }
  /// returns the next halfedge counterclockwise with the target of `h`.
  BOOST_FORCEINLINE Halfedge_index prev_around_target(Halfedge_index h) const { return prev(opposite(h)); }
  /// returns the next halfedge clockwise with the source of `h`.
  BOOST_FORCEINLINE Halfedge_index next_around_source(Halfedge_index h) const { return next(opposite(h)); }
  /// returns the next halfedge counterclockwise with the source of `h`.
  BOOST_FORCEINLINE Halfedge_index prev_around_source(Halfedge_index h) const { return opposite(prev(h)); }

  /// returns the number of edges at `v`, in time proportional to it.
  size_type degree(Vertex_index v) const { return m_layout.degree(v); }
  /// returns the number of edges of `f`, in time proportional to it.
  size_type degree(Face_index f) const
  {
    const Halfedge_index first = halfedge(f);
    size_type d = 0;
    Halfedge_index h = first;
    do {
      ++d;
      h = next(h);
    } while (h != first);
    return d;
  }
  /// @}

  /// \name Whole Stars
  /// The fastest ways around a vertex and a face.
  /// @{

  /// calls `visit(u)` for each neighbor `u` of `v`, once each, in no particular order.
  template <class Visitor>
  void for_each_adjacent_vertex(Vertex_index v, Visitor&& visit) const
  {
    m_layout.for_each_adjacent_vertex(v, [&](size_type u) { visit(Vertex_index(u)); });
  }

  /// calls `visit(u, w)` for each face at `v`, once each, in no particular order, where `u` follows
  /// and `w` precedes `v` in the face counterclockwise: a triangle is (`v`,`u`,`w`).
  template <class Visitor>
  void for_each_incident_triangle(Vertex_index v, Visitor&& visit) const
  {
    m_layout.for_each_incident_triangle(v, [&](size_type u, size_type w) { visit(Vertex_index(u), Vertex_index(w)); });
  }

  /// returns the vertices of `f` counterclockwise, from `target(halfedge(f))` on; of a polygon,
  /// only the first three.
  std::array<Vertex_index, 3> vertices_of_face(Face_index f) const
  {
    const std::array<size_type, 3> v = m_layout.vertices_of_face(f);
    return {{ Vertex_index(v[0]), Vertex_index(v[1]), Vertex_index(v[2]) }};
  }

  /// calls `visit(f, u, v, w)` for each face `f` in the order of `faces()`, where `u`, `v`, `w` are `vertices_of_face(f)`.
  template <class Visitor>
  void for_each_face(Visitor&& visit) const
  {
    m_layout.for_each_face([&](size_type f, size_type u, size_type v, size_type w) {
      visit(Face_index(f), Vertex_index(u), Vertex_index(v), Vertex_index(w));
    });
  }
  /// @}

  /// \name Borders
  /// in constant time.
  /// @{

  /// returns whether `h` has no face.
  bool is_border(Halfedge_index h) const { return !face(h).is_valid(); }
  /// returns whether `e` has less than two faces.
  bool is_border(Edge_index e) const { return is_border(halfedge(e)) || is_border(opposite(halfedge(e))); }
  /// returns whether `v` lies on a border or is isolated. As `halfedge(v)` is a border
  /// halfedge for every border vertex, the second parameter of `Surface_mesh` is of no effect.
  bool is_border(Vertex_index v, bool = true) const { return is_isolated(v) || is_border(halfedge(v)); }
  /// returns whether no edge meets `v`.
  bool is_isolated(Vertex_index v) const { return !halfedge(v).is_valid(); }
  /// @}

  /// \name Validity
  /// @{

  /// returns whether `d` is the descriptor of an element of this mesh.
  template <class Tag>
  bool has_valid_index(Descriptor<Tag> d) const { return d.idx() < number_of(Tag()); }

  /// checks all of the connectivity, in linear time.
  /// \param verbose whether to print the first error to `std::cerr`; as for `Surface_mesh`, the default is `false`
  ///   from \cgal 6 on, and `true` before
  bool is_valid(bool verbose = !internal::is_with_cgal_6) const
  {
    return internal::Validity_check<Self>(*this, verbose)();
  }

  /// checks what the neighbors of `d` say of `d`, which may be any descriptor.
  /// \param d the descriptor
  /// \param verbose whether to print the first error to `std::cerr`; the default is that of the function above
  template <class Tag>
  bool is_valid(Descriptor<Tag> d, bool verbose = !internal::is_with_cgal_6) const
  {
    return internal::Validity_check<Self>(*this, verbose)(d);
  }
  /// @}

  /// \name Null Elements
  /// @{

  /// returns the vertex that is none.
  static Vertex_index null_vertex() { return Vertex_index(); }
  /// returns the halfedge that is none.
  static Halfedge_index null_halfedge() { return Halfedge_index(); }
  /// returns the edge that is none.
  static Edge_index null_edge() { return Edge_index(); }
  /// returns the face that is none.
  static Face_index null_face() { return Face_index(); }
  /// @}

  /// \name Memory
  /// @{

  /// returns the connectivity, which can be navigated without the mesh.
  const Layout& layout() const { return m_layout; }

  /// returns the bytes that the connectivity has allocated: all that the mesh holds but points and properties.
  std::size_t connectivity_bytes() const
  {
    std::size_t bytes = 0;
    for (const auto& array : connectivity_memory())
      bytes += array.second;
    return bytes;
  }

  /// returns the names of the arrays of the connectivity and the bytes that each has allocated.
  std::vector<std::pair<std::string, std::size_t> > connectivity_memory() const { return m_layout.memory(); }

  /// returns the number of integers of type `size_type` that fit into the memory of the
  /// connectivity, per vertex; 0 for the empty mesh.
  double references_per_vertex() const
  {
    return is_empty() ? 0. : static_cast<double>(connectivity_bytes()) / sizeof(size_type) / number_of_vertices();
  }
  /// @}

private:
  template <class Mesh, class Owner> friend class internal::Mesh_construction;

  size_type number_of(Vertex_tag) const { return static_cast<size_type>(m_layout.num_vertices()); }
  size_type number_of(Halfedge_tag) const { return static_cast<size_type>(m_layout.num_halfedges()); }
  size_type number_of(Edge_tag) const { return static_cast<size_type>(m_layout.num_edges()); }
  size_type number_of(Face_tag) const { return static_cast<size_type>(m_layout.num_faces()); }

  // Every property map, the points' too, then has a value per element.
  void set_layout(Layout&& layout)
  {
    this->resize_properties(layout.num_vertices(), layout.num_halfedges(), layout.num_edges(), layout.num_faces());
    m_layout = std::move(layout);
  }

  Layout m_layout;
};

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_COMPACT_SURFACE_MESH_H
