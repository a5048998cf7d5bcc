// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_MESH_DEFECT_EXCEPTION_H
#define CGAL_COMPACT_SURFACE_MESH_MESH_DEFECT_EXCEPTION_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL {

/*!
\ingroup PkgCompactSurfaceMeshRef

What can be wrong with the input of a construction. Behind each defect stands
the kind of element that `Mesh_defect_exception::element()` then numbers.
*/
enum class Mesh_defect
{
  wrong_vertex_index,       ///< a vertex index map gives a vertex a number that is too large, or another one's (vertex)
  index_out_of_range,       ///< a face names a vertex that does not exist (face)
  degenerate_face,          ///< a face has fewer than three sides (face)
  not_a_triangle,           ///< a face does not have three vertices, where all must have (face)
  repeated_vertex,          ///< a face names a vertex twice (face)
  nonmanifold_edge,         ///< an edge has more than two faces (one of the faces)
  duplicate_face,           ///< two faces have the same vertices in the same direction (one of the faces)
  inconsistent_orientation, ///< two faces run along their edge in the same direction (one of the faces)
  double_edge,              ///< two edges have the same ends, where none may have (a face at one of them)
  nonmanifold_vertex,       ///< a closed fan of faces meets another fan at a vertex (vertex)
  isolated_vertex,          ///< a vertex belongs to no face (vertex)
  border,                   ///< the mesh has a border (a face along the border)
  several_components,       ///< the mesh is not connected (a face of a further component)
  positive_genus,           ///< the mesh has handles (number of handles)
  too_many_elements         ///< the index type cannot number the mesh (number of vertices or faces)
};

/*!
\ingroup PkgCompactSurfaceMeshRef

The exception that every construction of this package throws on input that it
does not take. It names the defect and the element at which it was met; the
object under construction is then unchanged.
*/
class Mesh_defect_exception
  : public std::runtime_error
{
public:
  /// describes `defect`, met at the element with index `element` in the input.
  Mesh_defect_exception(Mesh_defect defect, std::size_t element)
    : std::runtime_error(message(defect, element)), m_defect(defect), m_element(element)
  {}

  /// returns what is wrong.
  Mesh_defect defect() const noexcept { return m_defect; }

  /// returns the index in the input of the element where the defect was met;
  /// of which kind of element is said at `Mesh_defect`.
  std::size_t element() const noexcept { return m_element; }

private:
  static std::string message(Mesh_defect defect, std::size_t element)
  {
    const std::string e = std::to_string(element);
    switch (defect) {
    case Mesh_defect::wrong_vertex_index:
      return "vertex " + e + " has an index that is too large, or that another vertex has";
    case Mesh_defect::index_out_of_range:
      return "face " + e + " names a vertex that does not exist";
    case Mesh_defect::degenerate_face:
      return "face " + e + " has fewer than three sides";
    case Mesh_defect::not_a_triangle:
      return "face " + e + " is not a triangle";
    case Mesh_defect::repeated_vertex:
      return "face " + e + " names a vertex twice";
    case Mesh_defect::nonmanifold_edge:
      return "face " + e + " has an edge with more than two faces"
             " (CGAL::Polygon_mesh_processing::repair_polygon_soup() and"
             " orient_polygon_soup() can repair polygon soups)";
    case Mesh_defect::duplicate_face:
      return "face " + e + " is there twice"
             " (CGAL::Polygon_mesh_processing::repair_polygon_soup() can remove duplicates)";
    case Mesh_defect::inconsistent_orientation:
      return "face " + e + " and a neighbor run along their edge in the same direction"
             " (CGAL::Polygon_mesh_processing::orient_polygon_soup() can orient polygon soups)";
    case Mesh_defect::double_edge:
      return "face " + e + " has an edge with the same ends as another edge";
    case Mesh_defect::nonmanifold_vertex:
      return "vertex " + e + " joins a closed fan of faces to another fan"
             " (CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices() can part them)";
    case Mesh_defect::isolated_vertex:
      return "vertex " + e + " belongs to no face";
    case Mesh_defect::border:
      return "face " + e + " lies on a border";
    case Mesh_defect::several_components:
      return "face " + e + " belongs to a further connected component";
    case Mesh_defect::positive_genus:
      return "the mesh has handles: its genus is " + e;
    case Mesh_defect::too_many_elements:
      return e + " elements are too many for the index type";
    }
    return "unknown defect";
  }

  Mesh_defect m_defect;
  std::size_t m_element;
};

} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_MESH_DEFECT_EXCEPTION_H
