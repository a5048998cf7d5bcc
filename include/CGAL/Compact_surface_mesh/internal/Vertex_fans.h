// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_INTERNAL_VERTEX_FANS_H
#define CGAL_COMPACT_SURFACE_MESH_INTERNAL_VERTEX_FANS_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Mesh_defect_exception.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace internal {

// Asks whether a vertex has one closed fan of faces, or open fans only.
//
// `Faces` is as for Halfedge_matching; only the halfedges that start at the vertex need to be paired.
template <class Index, class Faces>
class Vertex_fans
{
public:
  static constexpr Index null() { return (std::numeric_limits<Index>::max)(); }

  Vertex_fans(const Faces& faces, const std::vector<Index>& opposite) : m_faces(faces), m_opposite(opposite) {}

  // `corners` are all corners of the vertex, at least one: a vector of what converts to Index.
  template <class Corners>
  bool is_manifold(const Corners& corners)
  {
    const Index first = corners.front();
    Index c = first;
    std::size_t size = 0;
    do {
      ++size;
      c = clockwise(c);
    } while (c != first && c != null() && size < corners.size());
    return c == null() ? are_open(corners) : c == first && size == corners.size();
  }

private:
  // Whether each corner is met on the way clockwise from a corner that follows no other one.
  template <class Corners>
  bool are_open(const Corners& corners)
  {
    m_followers.clear();
    for (const Index c : corners)
      m_followers.push_back(clockwise(c));
    std::sort(m_followers.begin(), m_followers.end());
    std::size_t num_met = 0;
    for (const Index first : corners)
      if (!std::binary_search(m_followers.begin(), m_followers.end(), first))
        for (Index c = first; c != null() && num_met <= corners.size(); c = clockwise(c))
          ++num_met;
    return num_met == corners.size();
  }

  Index clockwise(Index c) const { return m_opposite[c] == null() ? null() : m_faces.next(m_opposite[c]); }

  const Faces& m_faces;
  const std::vector<Index>& m_opposite;
  std::vector<Index> m_followers;
};

// Throws if a vertex has closed and other fans, whatever pairs the halfedges.
template <class Index, class Faces>
void check_vertices(const Faces& faces, const std::vector<Index>& opposite)
{
  std::vector<std::size_t> end(faces.num_vertices() + 1, 0); // of the corners of each vertex, in `sorted`
  for (std::size_t c = 0; c < opposite.size(); ++c)
    ++end[faces.vertex(static_cast<Index>(c)) + 1];
  for (std::size_t v = 1; v < end.size(); ++v)
    end[v] += end[v - 1];
  std::vector<Index> sorted(opposite.size());
  for (std::size_t c = 0; c < opposite.size(); ++c)
    sorted[end[faces.vertex(static_cast<Index>(c))]++] = static_cast<Index>(c);
  Vertex_fans<Index, Faces> fans(faces, opposite);
  std::vector<Index> corners;
  auto first = sorted.begin();
  for (std::size_t v = 0; v < faces.num_vertices(); ++v) {
    const auto last = sorted.begin() + static_cast<std::ptrdiff_t>(end[v]);
    corners.assign(first, last);
    first = last;
    if (!corners.empty() && !fans.is_manifold(corners))
      throw Mesh_defect_exception(Mesh_defect::nonmanifold_vertex, v);
  }
}

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_INTERNAL_VERTEX_FANS_H
