// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_INTERNAL_HALFEDGE_MATCHING_H
#define CGAL_COMPACT_SURFACE_MESH_INTERNAL_HALFEDGE_MATCHING_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Mesh_defect_exception.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace internal {

// Pairs the halfedges of faces that are listed one after the other, and finds what keeps
// them from being an oriented manifold.
//
// `Faces` numbers the corners of faces, each of which is also the halfedge that starts
// there, and answers num_vertices(), vertex(), next(), prev() and face() of a corner.
template <class Index, class Faces>
class Halfedge_matching
{
public:
  static constexpr Index null() { return (std::numeric_limits<Index>::max)(); }

  // `opposite` receives the pairs; it has an element, of any value, per corner.
  Halfedge_matching(const Faces& faces, std::vector<Index>& opposite)
    : m_faces(faces), m_opposite(opposite), m_corner(faces.num_vertices(), null()),
      m_incoming(faces.num_vertices(), null())
  {
    for (std::size_t i = m_opposite.size(); i-- > 0;) {
      Index& first = m_corner[m_faces.vertex(static_cast<Index>(i))];
      m_opposite[i] = first;
      first = static_cast<Index>(i);
    }
  }

  // Pairs halfedges that have the same ends in opposite directions. Stops and returns false
  // if two of them have the same direction.
  //
  // Goes from vertex to vertex: those that end at v are noted at their sources, where those
  // that start at v find them. Until the turn of its vertex comes, the entry of a corner in
  // m_opposite links the corners of that vertex.
  bool pair_by_ends()
  {
    for (std::size_t i = 0; i < m_corner.size(); ++i) {
      const Index v = static_cast<Index>(i);
      for (Index c = m_corner[v]; c != null(); c = m_opposite[c]) {
        const Index p = m_faces.prev(c);
        const Index u = m_faces.vertex(p);
        if (is_noted(v, u)) {
          m_conflict = p;
          return false;
        }
        m_incoming[u] = p;
      }
      for (Index c = m_corner[v], following; c != null(); c = following) {
        following = m_opposite[c];
        const Index w = target(c);
        m_opposite[c] = is_noted(v, w) ? m_incoming[w] : null();
      }
    }
    return true;
  }

  // Whether pair_by_ends() stopped, and at which face.
  bool has_conflict() const { return m_conflict != null(); }
  std::size_t face_of_conflict() const { return m_faces.face(m_conflict); }

  // Why it stopped, if the faces are to be paired by their ends.
  Mesh_defect conflict() const
  {
    const Index u = m_faces.vertex(m_conflict);
    std::size_t num_faces_at_edge = 0;
    Index corners[2] = { null(), null() };
    for (Index c = m_corner[target(m_conflict)]; c != null(); c = m_opposite[c])
      if (m_faces.vertex(m_faces.next(c)) == u || m_faces.vertex(m_faces.prev(c)) == u) {
        if (num_faces_at_edge < 2)
          corners[num_faces_at_edge] = c;
        ++num_faces_at_edge;
      }
    if (num_faces_at_edge > 2)
      return Mesh_defect::nonmanifold_edge;
    return have_same_vertices(corners[0], corners[1]) ? Mesh_defect::duplicate_face
                                                      : Mesh_defect::inconsistent_orientation;
  }

  // Every vertex must have one closed fan, or open fans only.
  void check_vertices()
  {
    std::vector<Index>& unseen = m_incoming;
    unseen.assign(unseen.size(), 0);
    for (std::size_t c = 0; c < m_opposite.size(); ++c)
      ++unseen[m_faces.vertex(static_cast<Index>(c))];
    for (std::size_t v = 0; v < unseen.size(); ++v) {
      if (unseen[v] == 0)
        continue;
      const Fan fan = fan_from(m_corner[v]);
      if (fan.closed && fan.size != unseen[v])
        throw Mesh_defect_exception(Mesh_defect::nonmanifold_vertex, v);
      if (fan.closed)
        unseen[v] = 0;
    }
    for (std::size_t h = 0; h < m_opposite.size(); ++h)
      if (m_opposite[h] == null())
        unseen[m_faces.vertex(static_cast<Index>(h))] -= fan_from(static_cast<Index>(h)).size;
    for (std::size_t v = 0; v < unseen.size(); ++v)
      if (unseen[v] != 0)
        throw Mesh_defect_exception(Mesh_defect::nonmanifold_vertex, v);
  }

private:
  struct Fan
  {
    Index size;
    bool closed;
  };

  // The corners from c on counterclockwise, to a border or around.
  Fan fan_from(Index c) const
  {
    Fan fan = { 0, false };
    Index d = c;
    do {
      ++fan.size;
      d = m_opposite[m_faces.prev(d)];
    } while (d != c && d != null());
    fan.closed = d == c;
    return fan;
  }

  Index target(Index h) const { return m_faces.vertex(m_faces.next(h)); }

  // Whether a halfedge from u to v is noted.
  bool is_noted(Index v, Index u) const { return m_incoming[u] != null() && target(m_incoming[u]) == v; }

  // Whether two faces have the same vertices from these corners on. As the same vertex comes
  // last in both, and no vertex twice, neither can end while they agree and the other goes on.
  bool have_same_vertices(Index c, Index d) const
  {
    const Index first = c;
    do {
      if (m_faces.vertex(c) != m_faces.vertex(d))
        return false;
      c = m_faces.next(c);
      d = m_faces.next(d);
    } while (c != first);
    return true;
  }

  const Faces& m_faces;
  std::vector<Index>& m_opposite;
  std::vector<Index> m_corner;   // of each vertex: the first one
  std::vector<Index> m_incoming; // halfedge that was noted last at each source
  Index m_conflict = null();
};

// Pairs halfedges by their ends, and checks that the faces are an oriented manifold.
template <class Index, class Faces>
void match_halfedges(const Faces& faces, std::vector<Index>& opposite)
{
  Halfedge_matching<Index, Faces> matching(faces, opposite);
  if (!matching.pair_by_ends())
    throw Mesh_defect_exception(matching.conflict(), matching.face_of_conflict());
  matching.check_vertices();
}

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_INTERNAL_HALFEDGE_MATCHING_H
