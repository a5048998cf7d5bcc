// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_CLOSED_TRIANGULATION_H
#define CGAL_COMPACT_SURFACE_MESH_CLOSED_TRIANGULATION_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Corner_table.h>
#include <CGAL/Compact_surface_mesh/internal/Emptied_on_move.h>

#include <boost/pending/disjoint_sets.hpp>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgCompactSurfaceMeshRef

The class `Closed_triangulation` is a mesh made ready for a layout: a simple closed
triangulation, with a mask that says what of it is not the user's.

Layouts know one kind of root only, a hidden vertex called <em>apex</em>. A closed
component gets one inside a face of the user's, its <em>cap</em>: the three triangles
around the apex stand for that face. So the user's vertices come first, in the
order of the input, and the apices after them.

Today, meshes are taken that are empty, or a connected closed surface of genus 0.

\tparam Index an unsigned integer type, as for `Corner_table`
*/
template <class Index = std::uint32_t>
class Closed_triangulation
{
public:
  /*!
  A hidden apex and where the wood of its component starts. The halfedge `base` runs
  from \f$V_1\f$ to \f$V_0\f$ and has the apex, \f$V_2\f$, to its left.
  */
  struct Root
  {
    /// the hidden vertex.
    Index apex;
    /// the halfedge opposite to it in the face that keeps the index of the cap.
    Index base;
  };

  /// creates the empty triangulation.
  Closed_triangulation() = default;

  /*!
  closes `table`, in nearly linear time.

  \throws Mesh_defect_exception if the mesh has isolated vertices, borders, several
  components or handles; `table` is then unchanged.
  */
  explicit Closed_triangulation(Corner_table<Index>&& table)
  {
    check(table);
    m_num_user_vertices = table.num_vertices();
    if (table.num_faces() != 0) {
      const Index apex = table.split_face(0);
      m_roots.push_back(Root{ apex, 0 });
    }
    m_table = std::move(table);
  }

  /*!
  does nothing if `table` is empty or a connected closed surface of genus 0.
  \throws Mesh_defect_exception otherwise
  */
  static void check(const Corner_table<Index>& table)
  {
    for (std::size_t h = 0; h < table.num_halfedges(); ++h)
      if (table.opposite(static_cast<Index>(h)) == table.null())
        throw Mesh_defect_exception(Mesh_defect::border, h / 3);
    check_connected(table);
    // V - E + F = 2 - 2g with E = 3F/2
    const std::size_t excess = table.num_faces() + 4 - 2 * table.num_vertices();
    if (table.num_faces() != 0 && excess != 0)
      throw Mesh_defect_exception(Mesh_defect::positive_genus, excess / 4);
  }

  /// returns the triangulation, hidden vertices and faces included.
  const Corner_table<Index>& table() const { return m_table; }

  /// returns the roots, one per component.
  const std::vector<Root>& roots() const { return m_roots; }

  /// returns the number of vertices that are the user's; these are the first ones.
  std::size_t num_user_vertices() const { return m_num_user_vertices; }

  /// returns the user's mesh without the mask, and leaves this object empty.
  Corner_table<Index> release()
  {
    for (std::size_t i = m_roots.size(); i-- > 0;)
      m_table.unsplit_face(m_table.face(m_roots[i].base));
    m_roots.clear();
    m_num_user_vertices = 0;
    return std::move(m_table);
  }

private:
  static void check_connected(const Corner_table<Index>& table)
  {
    std::vector<unsigned char> rank(table.num_vertices(), 0);
    std::vector<Index> parent(table.num_vertices());
    std::iota(parent.begin(), parent.end(), Index(0));
    std::vector<bool> used(table.num_vertices(), false);
    boost::disjoint_sets<unsigned char*, Index*> components(rank.data(), parent.data());
    for (std::size_t h = 0; h < table.num_halfedges(); ++h) {
      const Index s = table.source(static_cast<Index>(h)), t = table.target(static_cast<Index>(h));
      used[s] = true;
      if (s < t)
        components.union_set(s, t);
    }
    for (std::size_t v = 0; v < table.num_vertices(); ++v)
      if (!used[v])
        throw Mesh_defect_exception(Mesh_defect::isolated_vertex, v);
    for (std::size_t f = 0; f < table.num_faces(); ++f)
      if (components.find_set(table.source(static_cast<Index>(3 * f))) != components.find_set(table.source(0)))
        throw Mesh_defect_exception(Mesh_defect::several_components, f);
  }

  Corner_table<Index> m_table;
  std::vector<Root> m_roots;
  internal::Emptied_on_move<std::size_t> m_num_user_vertices;
};

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_CLOSED_TRIANGULATION_H
