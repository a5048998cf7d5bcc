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
#include <CGAL/Compact_surface_mesh/internal/Large_array.h>
#include <CGAL/Compact_surface_mesh/internal/Vertex_fans.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace internal {

// Pairs the halfedges of faces that are listed one after the other, and finds what keeps
// them from being an oriented manifold.
//
// `Faces` numbers the corners of faces, each of which is also the halfedge that starts
// there, answers num_vertices(), num_halfedges(), and vertex(), next(), prev(), face() and opposite() of a corner,
// and has set_opposite(), which receives the pairs.
template <class Index, class Faces>
class Halfedge_matching
{
  static constexpr std::size_t batch_size = 16;

public:
  static constexpr Index null() { return (std::numeric_limits<Index>::max)(); }

  explicit Halfedge_matching(Faces& faces)
    : m_faces(faces), m_corner(faces.num_vertices(), null()), m_incoming(faces.num_vertices(), null()), m_fans(faces)
  {
    for (std::size_t i = m_faces.num_halfedges(); i-- > 0;) {
      const Index c = static_cast<Index>(i);
      Index& first = m_corner[m_faces.vertex(c)];
      m_faces.set_opposite(c, first);
      first = c;
    }
  }

  // Pairs halfedges that have the same ends in opposite directions. Stops and returns false
  // if two of them have the same direction.
  //
  // Goes from vertex to vertex: those that end at v are noted at their sources, where those
  // that start at v find them. Until the turn of its vertex comes, the opposite of a corner is
  // the next corner of that vertex. Its fans are looked at while all that is in the cache.
  bool pair_by_ends()
  {
    std::array<std::vector<Wedge>, batch_size> batch;
    for (std::size_t first = 0; first < m_corner.size(); first += batch_size) {
      const std::size_t end = (std::min)(m_corner.size(), first + batch_size);
      gather(first, end, batch);
      for (std::size_t v = first; v < end; ++v) {
        const std::vector<Wedge>& wedges = batch[v - first];
        if (!pair_at(static_cast<Index>(v), wedges))
          return false;
        if (!wedges.empty())
          m_fans.add(static_cast<Index>(v), wedges);
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
    for (Index c = m_corner[target(m_conflict)]; c != null(); c = m_faces.opposite(c))
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

  // Throws if pair_by_ends(), which did not stop, met a vertex that has closed and other fans.
  void check_vertices() const { m_fans.check(); }

private:
  // A corner, and the vertices before and after it in its face.
  struct Wedge
  {
    Index corner, source, target;
    operator Index() const { return corner; }
  };

  // Finds the wedges of the vertices from first to before end. Each list is a chain of cache misses, if the
  // order of faces is a bad one; those of several vertices are waited for together.
  void gather(std::size_t first, std::size_t end, std::array<std::vector<Wedge>, batch_size>& batch) const
  {
    std::array<Index, batch_size> corner;
    for (std::size_t i = 0; first + i < end; ++i) {
      corner[i] = m_corner[first + i];
      batch[i].clear();
    }
    for (bool found = true; found;) {
      found = false;
      for (std::size_t i = 0; first + i < end; ++i) {
        const Index c = corner[i];
        if (c == null())
          continue;
        found = true;
        batch[i].push_back({ c, m_faces.vertex(m_faces.prev(c)), target(c) });
        corner[i] = m_faces.opposite(c);
      }
    }
  }

  bool pair_at(Index v, const std::vector<Wedge>& wedges)
  {
    for (const Wedge& w : wedges)
      m_incoming[w.source] = m_faces.prev(w.corner);
    for (const Wedge& w : wedges)
      if (m_incoming[w.source] != m_faces.prev(w.corner)) {
        m_conflict = m_incoming[w.source];
        return false;
      }
    for (const Wedge& w : wedges) {
      const Index p = m_incoming[w.target];
      m_faces.set_opposite(w.corner, p != null() && target(p) == v ? p : null());
    }
    return true;
  }

  Index target(Index h) const { return m_faces.vertex(m_faces.next(h)); }

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

  Faces& m_faces;
  Large_array<Index> m_corner;   // of each vertex: the first one
  Large_array<Index> m_incoming; // halfedge that was noted last at each source
  Index m_conflict = null();
  Vertex_fans<Index, Faces> m_fans;
};

// Pairs halfedges by their ends, and checks that the faces are an oriented manifold.
template <class Index, class Faces>
void match_halfedges(Faces& faces)
{
  Halfedge_matching<Index, Faces> matching(faces);
  if (!matching.pair_by_ends())
    throw Mesh_defect_exception(matching.conflict(), matching.face_of_conflict());
  matching.check_vertices();
}

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_INTERNAL_HALFEDGE_MATCHING_H
