// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_INTERNAL_DOUBLE_EDGE_SPLIT_H
#define CGAL_COMPACT_SURFACE_MESH_INTERNAL_DOUBLE_EDGE_SPLIT_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/internal/Polygon_list.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

// Puts a new vertex on all but one of the edges that have the same two ends, so that no edges
// have the same ends: edge (u,v) becomes (u,x) and (x,v), of which (u,x) stands for it, and a
// face at the edge gets one more side. In linear time.
template <class Index>
class Double_edge_split
{
public:
  static constexpr Index null() { return (std::numeric_limits<Index>::max)(); }

  // The corners of `polygons` are indexed, and its halfedges paired.
  explicit Double_edge_split(const Polygon_list<Index>& polygons)
    : m_polygons(polygons), m_new_vertex(polygons.num_halfedges(), null())
  {
    find_double_edges();
  }

  // The vertex v of each new vertex x.
  std::vector<Index> ends() const
  {
    std::vector<Index> ends;
    for (const Index h : m_split)
      ends.push_back(target(h));
    return ends;
  }

  // The faces with the new vertices, which come after all others, and paired halfedges.
  Polygon_list<Index> polygons()
  {
    Polygon_list<Index> split(m_polygons.num_vertices() + m_split.size(), m_polygons.num_faces());
    std::vector<Index> face;
    m_image.reserve(m_polygons.num_halfedges());
    for (std::size_t f = 0; f < m_polygons.num_faces(); ++f) {
      face.clear();
      for (Index h = m_polygons.first(static_cast<Index>(f)); h != m_polygons.end(static_cast<Index>(f)); ++h) {
        m_image.push_back(static_cast<Index>(split.num_halfedges() + face.size()));
        face.push_back(m_polygons.vertex(h));
        if (m_new_vertex[h] != null())
          face.push_back(m_new_vertex[h]);
      }
      split.append(face);
    }
    split.index_corners();
    pair(split);
    return split;
  }

  // Which halfedge of polygons() stands for each halfedge.
  std::vector<Index> images() const
  {
    std::vector<Index> images = m_image;
    for (std::size_t h = 0; h < images.size(); ++h)
      if (m_new_vertex[h] != null() && opposite(h) < h) // runs from v by x to u
        ++images[h];
    return images;
  }

private:
  Index target(Index h) const { return m_polygons.vertex(m_polygons.next(h)); }
  Index opposite(std::size_t h) const { return m_polygons.opposite(static_cast<Index>(h)); }

  void pair(Polygon_list<Index>& split) const
  {
    for (std::size_t h = 0; h < split.num_halfedges(); ++h)
      split.set_opposite(static_cast<Index>(h), null());
    for (std::size_t h = 0; h < m_image.size(); ++h) {
      if (opposite(h) == null())
        continue;
      const Index image = m_image[h], other = m_image[opposite(h)];
      if (m_new_vertex[h] == null())
        split.set_opposite(image, other);
      else {
        split.set_opposite(image, static_cast<Index>(other + 1));
        split.set_opposite(static_cast<Index>(image + 1), other);
      }
    }
  }

  // Goes from vertex to vertex and stamps the ends of edges that are met.
  void find_double_edges()
  {
    const std::size_t n = m_polygons.num_vertices();
    std::vector<Index> first_edge(n, null()), next_edge(m_polygons.num_halfedges()), stamp(n, null());
    for (std::size_t i = m_polygons.num_halfedges(); i-- > 0;) { // each edge at the smaller one of its ends
      const Index h = static_cast<Index>(i);
      if (opposite(h) < h)
        continue;
      const Index v = (std::min)(m_polygons.vertex(h), target(h));
      next_edge[h] = first_edge[v];
      first_edge[v] = h;
    }
    for (std::size_t v = 0; v < n; ++v)
      for (Index h = first_edge[v]; h != null(); h = next_edge[h]) {
        const Index w = (std::max)(m_polygons.vertex(h), target(h));
        if (std::exchange(stamp[w], static_cast<Index>(v)) == v)
          split(h);
      }
  }

  // h is smaller than its opposite. Whether Index can number x, polygons() sees.
  void split(Index h)
  {
    const std::size_t x = m_polygons.num_vertices() + m_split.size();
    m_new_vertex[h] = static_cast<Index>(x);
    if (opposite(h) != null())
      m_new_vertex[opposite(h)] = static_cast<Index>(x);
    m_split.push_back(h);
  }

  const Polygon_list<Index>& m_polygons;
  std::vector<Index> m_new_vertex; // on the edge of each halfedge
  std::vector<Index> m_split;      // the halfedge from u to v of each new vertex
  std::vector<Index> m_image;      // the first half of each halfedge
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_INTERNAL_DOUBLE_EDGE_SPLIT_H
