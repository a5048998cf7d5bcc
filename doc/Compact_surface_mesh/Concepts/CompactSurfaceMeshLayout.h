/*!
\ingroup PkgCompactSurfaceMeshConcepts
\cgalConcept

The concept `CompactSurfaceMeshLayout` describes how the connectivity of a
`CGAL::Compact_surface_mesh` is stored. A layout owns nothing but connectivity:
it knows neither points nor properties, and it never changes after construction.

A layout numbers its own vertices, halfedges, edges and faces from 0 without
holes; nothing outside the layout depends on how it does so. All queries are
`const`, free of hidden caches, and may be made from several threads at once.
Queries have the precondition that their argument is smaller than the number
of elements of that kind; this is not checked.

Orientation is as in `FaceGraph`: a face lies to the left of its halfedges,
`next()` goes counterclockwise around the face.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Schnyder_parents_layout<References, Index_>}
\cgalHasModels{CGAL::Schnyder_fronts_layout<References, has_targets, Index_>}
\cgalHasModels{CGAL::Corner_table_layout<Index_>}
\cgalHasModels{CGAL::SOT_layout<Index_>}
\cgalHasModels{CGAL::SQuad_layout<Index_>}
\cgalHasModels{CGAL::Laced_ring_layout<Index_, Entry>}
\cgalHasModels{CGAL::Input_order_layout<Layout\,order>}
\cgalHasModelsEnd

\sa `CGAL::Compact_surface_mesh`
*/
class CompactSurfaceMeshLayout {
public:

/// \name Types
/// @{

/// An unsigned integer type, wide enough for all indices of the mesh.
typedef unspecified_type Index;

/// What names a halfedge in navigation: `Index` itself, or a type that converts from and to it and is
/// faster to work with.
typedef unspecified_type Halfedge;

/// @}

/// \name Constants
/// @{

/// whether `edge(h) == h / 2` and `opposite(h) == (h ^ 1)` for all halfedges, so that
/// an edge is named by any of its halfedges alone.
static constexpr bool edge_is_half_of_halfedge;

/// The index of no element: the largest value of `Index`.
static constexpr Index null_index();

/// The name under which programs list the layout, for example `"corner-table"`.
static std::string name();

/// The largest number of vertices that the layout can hold with its `Index`.
static std::size_t max_vertices();

/// @}

/// \name Construction
/// A layout is default constructible (the empty mesh), copyable and movable.
/// @{

/*!
builds the layout of the mesh that `t` is made of, consuming `t`. All that is hidden in `t`
remains so: the elements of the layout are those of the user's mesh.

Writes to `images` the index in this layout of each vertex of the input, in its order; and
of each halfedge that has a face, if `images.wants_halfedges` is set.

\throws CGAL::Mesh_defect_exception if the mesh has too many elements for
`Index`; `images` is then unchanged.
*/
CompactSurfaceMeshLayout(CGAL::Closed_triangulation<Index>&& t,
                         CGAL::Input_images<Index>& images);

/// @}

/// \name Counts
/// in constant time.
/// @{

/// the number of vertices.
std::size_t num_vertices() const;
/// the number of halfedges, those along borders included: twice that of edges.
std::size_t num_halfedges() const;
/// the number of edges.
std::size_t num_edges() const;
/// the number of faces.
std::size_t num_faces() const;
/// @}

/// \name Navigation
/// @{

/// the next halfedge counterclockwise around the face of `h`, or along its border.
Halfedge next(Halfedge h) const;
/// the halfedge whose next one is `h`.
Halfedge prev(Halfedge h) const;
/// the other halfedge of the edge of `h`.
Halfedge opposite(Halfedge h) const;
/// the vertex where `h` starts.
Index source(Halfedge h) const;
/// the vertex where `h` ends.
Index target(Halfedge h) const;
/// the face to the left of `h`, `null_index()` on a border.
Index face(Halfedge h) const;
/// whether `h` is known to be a side of a triangle. Never `true` if it is not, but `false` also where it takes
/// time to find out, and of `null_index()`.
bool is_in_triangle(Halfedge h) const;
/// the vertices of the triangle of `h` counterclockwise, from its target on, with the precondition `is_in_triangle(h)`.
std::array<Index, 3> vertices_of_triangle(Halfedge h) const;
/// the edge of `h`.
Index edge(Halfedge h) const;
/// one of the halfedges of edge `e`, always the same.
Halfedge halfedge_of_edge(Index e) const;
/// a halfedge whose target is `v`, always the same: a border halfedge if `v` lies on a
/// border; `null_index()` if `v` is isolated.
Halfedge halfedge_of_vertex(Index v) const;
/// a halfedge whose face is `f`, always the same.
Halfedge halfedge_of_face(Index f) const;
/// the target of `halfedge_of_face(f)`.
Index vertex_of_face(Index f) const;
/// the halfedge from `u` to `v`, `null_index()` if they are not adjacent.
Halfedge halfedge(Index u, Index v) const;

/// @}

/// \name Whole Stars
/// These answer by hand what otherwise takes one operator after the other.
/// @{

/// calls `visit(u)` for each edge of `v`, with its other end `u`, once each, in no particular order.
template <class Visitor>
void for_each_adjacent_vertex(Index v, Visitor&& visit) const;

/// calls `visit(u, w)` for each face at `v`, once each, in no particular order, where `u` follows
/// and `w` precedes `v` in the face counterclockwise: a triangle is (`v`,`u`,`w`).
template <class Visitor>
void for_each_incident_triangle(Index v, Visitor&& visit) const;

/// the number of edges at `v`.
Index degree(Index v) const;

/// the vertices of face `f` counterclockwise, from the target of `halfedge_of_face(f)` on; of a
/// polygon, only the first three.
std::array<Index, 3> vertices_of_face(Index f) const;

/// calls `visit(f, u, v, w)` for each face `f` in their order, where `u`, `v`, `w` are `vertices_of_face(f)`.
template <class Visitor>
void for_each_face(Visitor&& visit) const;

/// @}

/// \name Memory
/// @{

/// the arrays that the layout holds, each with its name and the bytes it has
/// allocated, directories and side tables included. The names of arrays that hold no integers, but
/// single bits and their directories, end with `"bits"`.
std::vector<std::pair<std::string, std::size_t>> memory() const;

/// @}
};
