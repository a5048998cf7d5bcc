// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_MASK_H
#define CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_MASK_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Closed_triangulation.h>
#include <CGAL/Compact_surface_mesh/Input_images.h>
#include <CGAL/Compact_surface_mesh/internal/Ranked_bits.h>

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

/*
What of a triangle mesh is hidden from the user, who sees polygons and double edges: see
Simple_triangulation. A layout that stores the triangles has numbers for them ("raw" here), and
the mask turns these into numbers without holes, by ranks of bits, and walks over what is hidden.

A visible edge that was split by a hidden vertex x is (u,x), and x stands for the other end v; the
rest (x,v) is hidden. Walks around a face go straight on there, and turn at all other hidden edges.
As a fan has few diagonals and the edges to the center of a polygon are not neighbors around any
other vertex, a walk hops over at most Simple_triangulation::max_fan_size - 3 of these, and over
twice as many parts of split edges, whatever the number of sides.

The functions take the operators of the layout on raw numbers, as `raw`.
If the halfedges are `paired`, opposite ones differ in the last bit.
*/
template <class Index_, bool paired>
class Mask
{
  typedef Index_ Index;

  static constexpr Index null() { return (std::numeric_limits<Index>::max)(); }

public:
  Mask() = default;

  // `vertices` and `halfedges` are the raw numbers of the vertices and of the halfedges of the
  // table of `t`, but for those at apices.
  template <class Raw>
  Mask(const Raw& raw, const Closed_triangulation<Index>& t, const std::vector<Index>& vertices,
       const std::vector<Index>& halfedges)
  {
    const std::size_t num_halfedges = raw.num_halfedges(), num_users = t.simple().num_user_vertices();
    std::vector<bool> is_hidden(num_halfedges, false);
    for (std::size_t h = 0; h < 3 * t.num_open_faces(); ++h) {
      const Index c = t.current_halfedge(static_cast<Index>(h)), g = halfedges[c];
      if (t.is_hidden(c))
        is_hidden[g] = is_hidden[raw.opposite(g)] = true;
    }
    const std::size_t step = paired ? 2 : 1;
    m_halfedges = Ranked_bits(num_halfedges / step, [&](std::size_t i) { return !is_hidden[step * i]; });

    const std::vector<Index>& stands_for = t.simple().stands_for();
    std::vector<Index> represented(raw.num_vertices(), 0); // only hidden ones are looked up
    std::vector<bool> is_user(raw.num_vertices(), true);
    for (std::size_t i = 0; i < stands_for.size(); ++i) {
      is_user[vertices[num_users + i]] = false;
      represented[vertices[num_users + i]] = stands_for[i] == null() ? null() : vertices[stands_for[i]];
    }
    m_vertices = Ranked_bits(is_user.size(), [&](std::size_t v) { return is_user[v]; });
    m_stands_for.reserve(stands_for.size());
    for (std::size_t v = 0; v < is_user.size(); ++v)
      if (!is_user[v])
        m_stands_for.push_back(represented[v]);
    choose_faces(raw, t, halfedges);
  }

  bool empty() const { return m_halfedges.empty(); }

  std::size_t num_vertices() const { return m_vertices.count(); }
  std::size_t num_halfedges() const { return (paired ? 2 : 1) * m_halfedges.count(); }
  std::size_t num_faces() const { return m_faces.count(); }

  // Between raw numbers of visible elements and the user's.
  Index vertex(Index raw_vertex) const { return static_cast<Index>(m_vertices.rank(raw_vertex)); }
  Index raw_vertex(Index v) const { return static_cast<Index>(m_vertices.select(v)); }
  Index raw_halfedge(Index h) const
  {
    return static_cast<Index>(paired ? 2 * m_halfedges.select(h / 2) + (h & 1) : m_halfedges.select(h));
  }
  Index halfedge(Index g) const
  {
    return static_cast<Index>(paired ? 2 * m_halfedges.rank(g / 2) + (g & 1) : m_halfedges.rank(g));
  }

  // Whether an element with this raw number is visible and has the same number for the user.
  bool keeps_vertex(Index v) const { return m_vertices[v] && m_vertices.rank(v) == v; }
  bool keeps_halfedge(Index g) const { return !is_hidden(g) && halfedge(g) == g; }
  bool keeps_face(Index f) const { return m_faces[f] && m_faces.rank(f) == f; }

  template <class Raw>
  Index next(const Raw& raw, Index h) const { return halfedge(visible_after(raw, raw.next(raw_halfedge(h)))); }

  template <class Raw>
  Index prev(const Raw& raw, Index h) const { return halfedge(visible_before(raw, raw.prev(raw_halfedge(h)))); }

  template <class Raw>
  Index opposite(const Raw& raw, Index h) const
  {
    return paired ? h ^ 1 : halfedge(raw.opposite(raw_halfedge(h)));
  }

  template <class Raw>
  Index source(const Raw& raw, Index h) const { return vertex(end(raw.source(raw_halfedge(h)))); }

  template <class Raw>
  Index target(const Raw& raw, Index h) const { return vertex(end(raw.target(raw_halfedge(h)))); }

  template <class Raw>
  Index face(const Raw& raw, Index h) const
  {
    const Index first = raw_halfedge(h);
    Index f = raw.face(first);
    if (f == null())
      return f;
    const Index third = raw.target(raw.next(first));
    if (is_center(third))
      f = raw.face(raw.halfedge_of_vertex(third));
    for (Index g = first; !m_faces[f]; f = raw.face(g))
      g = visible_after(raw, raw.next(g));
    return static_cast<Index>(m_faces.rank(f));
  }

  template <class Raw>
  Index halfedge_of_face(const Raw& raw, Index f) const
  {
    // the triangle has a side of the face, from which the walk does not turn around a center
    Index g = raw.halfedge_of_face(static_cast<Index>(m_faces.select(f)));
    while (is_hidden(g) && !is_part(raw, g))
      g = raw.next(g);
    return halfedge(visible_after(raw, g));
  }

  // null for an isolated vertex. A border halfedge into v is visible: of a split edge of the border, it is
  // the part out of v that is hidden.
  template <class Raw>
  Index halfedge_of_vertex(const Raw& raw, Index v) const
  {
    const Index g = raw_halfedge_of_vertex(raw, v);
    return g == null() ? g : halfedge(g);
  }

  // The halfedge from u to v, null if there is none: of the edges with the same ends, one is not split.
  template <class Raw>
  Index halfedge(const Raw& raw, Index u, Index v) const
  {
    const Index g = raw.halfedge(raw_vertex(u), raw_vertex(v));
    return g == null() || is_hidden(g) ? null() : halfedge(g);
  }

  // The halfedges that are visible, by their raw numbers, and the user's vertices: so a walk takes no ranks but of
  // the vertices that it asks for.
  template <class Raw>
  class Visible_halfedges
  {
  public:
    typedef Index_ Index;
    typedef Index_ Halfedge;

    Visible_halfedges(const Mask& mask, const Raw& raw) : m_mask(mask), m_raw(raw) {}

    static constexpr Index null_index() { return null(); }
    Halfedge halfedge_of_vertex(Index v) const { return m_mask.raw_halfedge_of_vertex(m_raw, v); }
    Halfedge next(Halfedge g) const { return m_mask.visible_after(m_raw, m_raw.next(g)); }
    Halfedge opposite(Halfedge g) const { return m_raw.opposite(g); }
    Index source(Halfedge g) const { return m_mask.vertex(m_mask.end(m_raw.source(g))); }
    Index face(Halfedge g) const { return m_raw.face(g); } // null on a border, else any

  private:
    const Mask& m_mask;
    const Raw& m_raw;
  };

  template <class Raw>
  Visible_halfedges<Raw> visible_halfedges(const Raw& raw) const { return { *this, raw }; }

  // Tells what became of the input. The vertices and halfedges are as for the constructor; an empty
  // mask leaves them as they are.
  void write_images(const Closed_triangulation<Index>& t, std::vector<Index>&& vertices,
                    const std::vector<Index>& halfedges, Input_images<Index>& images) const
  {
    images.vertices = std::move(vertices);
    images.vertices.resize(t.simple().num_user_vertices());
    if (t.is_renumbered()) {
      std::vector<Index> renumbered(images.vertices.size());
      for (std::size_t v = 0; v < renumbered.size(); ++v)
        renumbered[v] = images.vertices[t.current_vertex(static_cast<Index>(v))];
      images.vertices.swap(renumbered);
    }
    if (!empty())
      for (Index& v : images.vertices)
        v = vertex(v);
    images.halfedges.clear();
    if (!images.wants_halfedges)
      return;
    const std::size_t num_sides = t.simple().num_user_halfedges();
    images.halfedges.reserve(num_sides);
    for (std::size_t i = 0; i < num_sides; ++i) {
      const Index g = halfedges[t.current_halfedge(t.simple().halfedge_of_side(i))];
      images.halfedges.push_back(empty() ? g : halfedge(g));
    }
  }

  std::size_t bytes() const
  {
    return m_vertices.bytes() + m_halfedges.bytes() + m_faces.bytes() + m_stands_for.capacity() * sizeof(Index);
  }

private:
  template <class Raw>
  Index raw_halfedge_of_vertex(const Raw& raw, Index v) const
  {
    Index g = raw.halfedge_of_vertex(raw_vertex(v));
    while (g != null() && is_hidden(g))
      g = raw.opposite(raw.next(g));
    return g;
  }

  bool is_hidden(Index g) const { return !m_halfedges[paired ? g / 2 : g]; }
  bool is_hidden_vertex(Index v) const { return !m_vertices[v]; }
  Index stands_for(Index hidden) const { return m_stands_for[hidden - m_vertices.rank(hidden)]; }
  bool is_center(Index v) const { return is_hidden_vertex(v) && stands_for(v) == null(); }
  Index end(Index v) const { return is_hidden_vertex(v) ? stands_for(v) : v; }

  // Whether the hidden g is part of a split edge.
  template <class Raw>
  bool is_part(const Raw& raw, Index g) const
  {
    if (m_stands_for.empty())
      return false;
    const Index s = raw.source(g), t = raw.target(g);
    return (is_hidden_vertex(s) && stands_for(s) == t) || (is_hidden_vertex(t) && stands_for(t) == s);
  }

  template <class Raw>
  Index visible_after(const Raw& raw, Index g) const
  {
    while (is_hidden(g))
      g = is_part(raw, g) ? raw.next(g) : raw.next(raw.opposite(g));
    return g;
  }

  template <class Raw>
  Index visible_before(const Raw& raw, Index g) const
  {
    while (is_hidden(g))
      g = is_part(raw, g) ? raw.prev(g) : raw.prev(raw.opposite(g));
    return g;
  }

  // A polygon is represented by the triangle that the halfedge of its center names, a face
  // without center by its first triangle that has a visible halfedge.
  template <class Raw>
  void choose_faces(const Raw& raw, const Closed_triangulation<Index>& t, const std::vector<Index>& halfedges)
  {
    std::vector<bool> is_chosen(raw.num_faces(), false), is_seen(t.simple().num_user_faces(), false);
    for (std::size_t h = 0; h < 3 * t.num_open_faces(); ++h) {
      const Index c = t.current_halfedge(static_cast<Index>(h));
      const Index f = t.simple().face_of_triangle(static_cast<Index>(h / 3));
      if (is_seen[f] || t.is_hidden(c))
        continue;
      is_seen[f] = true;
      const Index g = halfedges[c], third = raw.target(raw.next(g));
      is_chosen[raw.face(is_center(third) ? raw.halfedge_of_vertex(third) : g)] = true;
    }
    m_faces = Ranked_bits(is_chosen.size(), [&](std::size_t f) { return is_chosen[f]; });
  }

  Ranked_bits m_vertices, m_halfedges, m_faces; // the visible ones; edges if halfedges are paired
  std::vector<Index> m_stands_for;              // of each hidden vertex; null for a center
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_LAYOUTS_INTERNAL_MASK_H
