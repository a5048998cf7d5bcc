// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_INTERNAL_ROOTED_SURFACE_H
#define CGAL_SCHNYDER_WOODS_INTERNAL_ROOTED_SURFACE_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Corner_table.h>
#include <CGAL/Compact_surface_mesh/Mesh_defect_exception.h>
#include <CGAL/Compact_surface_mesh/internal/for_each_side.h>
#include <CGAL/Compact_surface_mesh/internal/numbered_vertices.h>
#include <CGAL/Schnyder_woods/Shelling_order.h>
#include <CGAL/Schnyder_woods/internal/Schnyder_wood.h>
#include <CGAL/Schnyder_woods/internal/Schnyder_wood_checker.h>
#include <CGAL/Schnyder_woods/internal/Shelling.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/use.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace internal {

// A mesh that is a triangulated closed connected surface, with its root face and further
// roots, as a corner table, and the way between the table's halfedges and those of the mesh.
template <class FaceGraph>
class Rooted_surface
{
  typedef boost::graph_traits<FaceGraph> Traits;

public:
  typedef typename Traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Traits::vertex_descriptor vertex_descriptor;
  typedef std::uint32_t Index;

  // `root` runs from V_1 to V_0 along the root face. Throws Mesh_defect_exception if g is
  // no such surface, and std::invalid_argument if stars of roots share a vertex.
  Rooted_surface(const FaceGraph& g, halfedge_descriptor root, const std::vector<vertex_descriptor>& further = {})
    : table(g, numbered_vertices(g)), m_index(get(dynamic_halfedge_property_t<Index>(), g))
  {
    check_closed();
    check_connected();
    halfedges.reserve(table.num_halfedges());
    for_each_side(g, [this](std::size_t i, halfedge_descriptor h) {
      put(m_index, h, static_cast<Index>(i));
      halfedges.push_back(h);
    });
    if (is_empty())
      return;
    base = index(root);
    for (const vertex_descriptor v : further)
      further_roots.push_back(index(opposite(halfedge(v, g), g)));
    if (!further.empty())
      check_stars();
  }

  bool is_empty() const { return halfedges.empty(); }

  // V - E + F = 2 - 2g with E = 3F/2
  std::size_t genus() const { return is_empty() ? 0 : (table.num_faces() + 4 - 2 * table.num_vertices()) / 4; }

  Index index(halfedge_descriptor h) const { return get(m_index, h); }

  // Calls conquered(v) for the vertex of each corner that the shelling conquers.
  template <class Visitor>
  Schnyder_wood shelled_wood(Shelling_order order, unsigned int seed, Visitor&& conquered) const
  {
    Schnyder_wood wood(table.num_halfedges());
    Shelling<Index> shelling(table, wood, order, seed);
    const bool is_complete = shelling(base, further_roots, table.num_faces(), conquered);
    CGAL_postcondition(is_complete);
    CGAL_USE(is_complete);
    return wood;
  }

  Schnyder_wood_checker<Index> checker(const Schnyder_wood& wood) const
  {
    return Schnyder_wood_checker<Index>(table, wood, base, further_roots);
  }

  Corner_table<Index> table;
  std::vector<halfedge_descriptor> halfedges; // of g, in the order of the table
  Index base = 0;
  std::vector<Index> further_roots; // halfedges that start there

private:
  void check_closed() const
  {
    for (std::size_t h = 0; h < table.num_halfedges(); ++h)
      if (table.opposite(static_cast<Index>(h)) == table.null())
        throw Mesh_defect_exception(Mesh_defect::border, h / 3);
  }

  // A flood from face 0 meets all faces, and they have all vertices.
  void check_connected() const
  {
    std::vector<bool> is_met(table.num_faces(), false), is_used(table.num_vertices(), false);
    for (std::size_t h = 0; h < table.num_halfedges(); ++h)
      is_used[table.source(static_cast<Index>(h))] = true;
    for (std::size_t v = 0; v < table.num_vertices(); ++v)
      if (!is_used[v])
        throw Mesh_defect_exception(Mesh_defect::isolated_vertex, v);

    std::vector<Index> stack;
    if (table.num_faces() != 0) {
      is_met[0] = true;
      stack.push_back(0);
    }
    while (!stack.empty()) {
      const Index first = 3 * stack.back();
      stack.pop_back();
      for (Index h = first; h != first + 3; ++h) {
        const Index f = table.face(table.opposite(h));
        if (!is_met[f]) {
          is_met[f] = true;
          stack.push_back(f);
        }
      }
    }
    for (std::size_t f = 0; f < table.num_faces(); ++f)
      if (!is_met[f])
        throw Mesh_defect_exception(Mesh_defect::several_components, f);
  }

  void check_stars() const
  {
    std::vector<bool> is_in_star(table.num_vertices(), false);
    const auto add = [&](Index v) {
      if (is_in_star[v])
        throw std::invalid_argument("the stars of two roots of a Schnyder wood share a vertex");
      is_in_star[v] = true;
    };
    std::vector<Index> roots = further_roots;
    roots.push_back(table.prev(base));
    for (const Index root : roots) {
      add(table.source(root));
      Index h = root;
      do {
        add(table.target(h));
        h = table.next_around_source(h);
      } while (h != root);
    }
  }

  typename boost::property_map<FaceGraph, dynamic_halfedge_property_t<Index>>::const_type m_index;
};

// As above, for a sphere only.
template <class FaceGraph>
Rooted_surface<FaceGraph> rooted_sphere(const FaceGraph& g,
                                        typename boost::graph_traits<FaceGraph>::halfedge_descriptor root)
{
  Rooted_surface<FaceGraph> surface(g, root);
  if (surface.genus() != 0)
    throw Mesh_defect_exception(Mesh_defect::positive_genus, surface.genus());
  return surface;
}

// The halfedge in which functions root a wood if they are not told.
template <class FaceGraph>
typename boost::graph_traits<FaceGraph>::halfedge_descriptor default_root(const FaceGraph& g)
{
  return faces(g).begin() == faces(g).end() ? boost::graph_traits<FaceGraph>::null_halfedge()
                                            : halfedge(*faces(g).begin(), g);
}

} // namespace internal
} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_INTERNAL_ROOTED_SURFACE_H
