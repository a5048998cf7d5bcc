// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef BENCHMARK_COMPACT_SURFACE_MESH_OTHER_STRUCTURES_H
#define BENCHMARK_COMPACT_SURFACE_MESH_OTHER_STRUCTURES_H

// The structures of others that are compared: Polyhedron_3 and, if there is one, OpenMesh.

#include "../../examples/Compact_surface_mesh/compared_meshes.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#ifdef BENCHMARK_WITH_OPENMESH
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>
#endif

#include <cstddef>
#include <stdexcept>
#include <string>
#include <tuple>

namespace example {

struct Polyhedron_structure
{
  using Mesh = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;

  static std::string name() { return "Polyhedron_3"; }

  static Mesh mesh_of(const Triangle_soup& soup)
  {
    Builder builder{ soup };
    Mesh mesh;
    mesh.delegate(builder);
    CGAL::set_halfedgeds_items_id(mesh);
    return mesh;
  }

  // What an element occupies in its list, links and number included, without the point; not
  // what the allocator adds: an edge is one allocation.
  static double connectivity_bytes(const Mesh& mesh)
  {
    return static_cast<double>(mesh.size_of_vertices() * (sizeof(Mesh::Vertex) - sizeof(Point)) +
                               mesh.size_of_halfedges() * sizeof(Mesh::Halfedge) +
                               mesh.size_of_facets() * sizeof(Mesh::Facet));
  }

private:
  struct Builder : CGAL::Modifier_base<Mesh::HalfedgeDS>
  {
    explicit Builder(const Triangle_soup& s) : soup(s) {}

    void operator()(Mesh::HalfedgeDS& hds) override
    {
      CGAL::Polyhedron_incremental_builder_3<Mesh::HalfedgeDS> builder(hds);
      builder.begin_surface(soup.points.size(), soup.triangles.size());
      for (const Point& p : soup.points)
        builder.add_vertex(p);
      for (const Triangle& t : soup.triangles)
        builder.add_facet(t.begin(), t.end());
      if (builder.error())
        throw std::runtime_error("Polyhedron_3 refuses a face");
      builder.end_surface();
    }

    const Triangle_soup& soup;
  };
};

#ifdef BENCHMARK_WITH_OPENMESH

struct Open_mesh_traits : OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  VertexAttributes(0);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
  EdgeAttributes(0);
  FaceAttributes(0);
};

struct Open_mesh_structure
{
  using Mesh = OpenMesh::TriMesh_ArrayKernelT<Open_mesh_traits>;

  static std::string name() { return "OpenMesh"; }

  static Mesh mesh_of(const Triangle_soup& soup)
  {
    Mesh mesh;
    mesh.reserve(soup.points.size(), soup.triangles.size() + soup.triangles.size() / 2, soup.triangles.size());
    for (const Point& p : soup.points)
      mesh.add_vertex(Mesh::Point(p.x(), p.y(), p.z()));
    const auto vertex = [](std::uint32_t v) { return Mesh::VertexHandle(static_cast<int>(v)); };
    for (const Triangle& t : soup.triangles)
      if (!mesh.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2])).is_valid())
        throw std::runtime_error("OpenMesh refuses a face");
    return mesh;
  }

  // Its arrays of elements hold connectivity only; points are a property. It has no status bits.
  static double connectivity_bytes(const Mesh& mesh)
  {
    return static_cast<double>(mesh.n_vertices() * sizeof(OpenMesh::ArrayItems::Vertex) +
                               mesh.n_edges() * sizeof(OpenMesh::ArrayItems::Edge) +
                               mesh.n_faces() * sizeof(OpenMesh::ArrayItems::Face));
  }
};

using Other_structures = std::tuple<Polyhedron_structure, Open_mesh_structure>;

#else

using Other_structures = std::tuple<Polyhedron_structure>;

#endif

} // namespace example

#endif // BENCHMARK_COMPACT_SURFACE_MESH_OTHER_STRUCTURES_H
