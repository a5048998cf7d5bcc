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
#include <CGAL/Compact_surface_mesh/internal/Large_array.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace internal {

// Finds a vertex that has neither one closed fan of faces nor open fans only. In linear time.
//
// `Faces` is as for Halfedge_matching.
template <class Index, class Faces>
class Vertex_fans
{
public:
  static constexpr Index null() { return (std::numeric_limits<Index>::max)(); }

  explicit Vertex_fans(const Faces& faces) : m_faces(faces) {}

  // Adds a vertex by all of its corners, at least one: a vector of what converts to Index. The halfedges that
  // start there are paired.
  template <class Corners>
  void add(Index v, const Corners& corners)
  {
    const Index first = corners.front();
    Index c = first;
    std::size_t size = 0;
    do {
      ++size;
      c = m_faces.opposite(c) == null() ? null() : m_faces.next(m_faces.opposite(c));
    } while (c != first && c != null() && size < corners.size());
    if (c == null())
      add_open(v, corners);
    else if (c != first || size != corners.size())
      m_nonmanifold = (std::min)(m_nonmanifold, v);
  }

  // Throws if there is such a vertex among those that were added. All halfedges are paired.
  void check() const
  {
    Index nonmanifold = m_nonmanifold;
    auto border = m_borders.begin();
    for (const Open_vertex& open : m_open) {
      std::size_t size = 0;
      for (const auto end = border + static_cast<std::ptrdiff_t>(open.num_fans); border != end; ++border)
        size += size_of_fan(*border);
      if (size != open.num_corners)
        nonmanifold = (std::min)(nonmanifold, open.vertex);
    }
    if (nonmanifold != null())
      throw Mesh_defect_exception(Mesh_defect::nonmanifold_vertex, nonmanifold);
  }

private:
  struct Open_vertex
  {
    Index vertex;
    std::size_t num_corners, num_fans; // open ones
  };

  template <class Corners>
  void add_open(Index v, const Corners& corners)
  {
    const std::size_t num_borders = m_borders.size();
    for (const Index c : corners)
      if (m_faces.opposite(c) == null())
        m_borders.push_back(c);
    m_open.push_back({ v, corners.size(), m_borders.size() - num_borders });
  }

  // The number of corners from c counterclockwise to a border.
  std::size_t size_of_fan(Index c) const
  {
    std::size_t size = 0;
    for (; c != null(); c = m_faces.opposite(m_faces.prev(c)))
      ++size;
    return size;
  }

  const Faces& m_faces;
  Index m_nonmanifold = null();     // the first one of those without an open fan at the first corner
  std::vector<Open_vertex> m_open;
  std::vector<Index> m_borders;     // of these, the corners from which fans are open clockwise
};

// Throws if a vertex has closed and other fans, whatever pairs the halfedges.
template <class Index, class Faces>
void check_vertices(const Faces& faces)
{
  const std::size_t num_corners = faces.num_halfedges();
  std::vector<std::size_t> end(faces.num_vertices() + 1, 0); // of the corners of each vertex, in `sorted`
  for (std::size_t c = 0; c < num_corners; ++c)
    ++end[faces.vertex(static_cast<Index>(c)) + 1];
  for (std::size_t v = 1; v < end.size(); ++v)
    end[v] += end[v - 1];
  Large_array<Index> sorted(num_corners);
  for (std::size_t c = 0; c < num_corners; ++c)
    sorted[end[faces.vertex(static_cast<Index>(c))]++] = static_cast<Index>(c);
  Vertex_fans<Index, Faces> fans(faces);
  std::vector<Index> corners;
  auto first = sorted.begin();
  for (std::size_t v = 0; v < faces.num_vertices(); ++v) {
    const auto last = sorted.begin() + static_cast<std::ptrdiff_t>(end[v]);
    corners.assign(first, last);
    first = last;
    if (!corners.empty())
      fans.add(static_cast<Index>(v), corners);
  }
  fans.check();
}

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_INTERNAL_VERTEX_FANS_H
