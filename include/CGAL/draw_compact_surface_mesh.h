// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_DRAW_COMPACT_SURFACE_MESH_H
#define CGAL_DRAW_COMPACT_SURFACE_MESH_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh.h>
#include <CGAL/Compact_surface_mesh/internal/versions_of_cgal.h>

#ifdef DOXYGEN_RUNNING

namespace CGAL {

/*!
\ingroup PkgDrawCompactSurfaceMesh

opens a window and draws the mesh in it. The function returns when the window is closed.

It is there if the macro `CGAL_USE_BASIC_VIEWER` is defined, and needs the Qt of the version of \cgal in use:
link with the target `CGAL::CGAL_Basic_viewer`. From \cgal 6 on, `"v:color"`, `"e:color"` and `"f:color"` give
the colors, and the parameters of `draw()` and `add_to_graphics_scene()` for `Surface_mesh` are taken.

\param mesh the mesh
\param title the title of the window
*/
template <class P, class L>
void draw(const Compact_surface_mesh<P, L>& mesh, const char* title = "Compact_surface_mesh Basic Viewer");

} // namespace CGAL

#elif CGAL_COMPACT_SURFACE_MESH_WITH_CGAL_6

#include <CGAL/Graphics_scene.h>
#include <CGAL/Graphics_scene_options.h>
#include <CGAL/IO/Color.h>
#include <CGAL/draw_face_graph.h>

#ifdef CGAL_USE_BASIC_VIEWER
#include <CGAL/Qt/Basic_viewer.h>
#endif

namespace CGAL {

namespace internal {

// Takes the colors of the elements of one kind from the property map `name`, if there is one.
template <class Element, class Mesh, class Is_colored, class Color_of>
void set_color_source(const Mesh& mesh, const char* name, Is_colored& is_colored, Color_of& color_of)
{
  const auto map = mesh.template find_property_map<Element, IO::Color>(name);
  const bool is_there = static_cast<bool>(map);
  is_colored = [is_there](const Mesh&, const Element&) { return is_there; };
  if (is_there)
    color_of = [map](const Mesh&, const Element& e) { return get(map, e); };
}

} // namespace internal

template <class P, class L, class GSOptions>
void add_to_graphics_scene(const Compact_surface_mesh<P, L>& mesh, Graphics_scene& scene, const GSOptions& options)
{
  add_to_graphics_scene_for_fg(mesh, scene, options);
}

template <class P, class L>
void add_to_graphics_scene(const Compact_surface_mesh<P, L>& mesh, Graphics_scene& scene)
{
  using Mesh = Compact_surface_mesh<P, L>;
  using Vertex_index = typename Mesh::Vertex_index;
  using Edge_index = typename Mesh::Edge_index;
  using Face_index = typename Mesh::Face_index;
  Graphics_scene_options<Mesh, Vertex_index, Edge_index, Face_index> options;
  internal::set_color_source<Vertex_index>(mesh, "v:color", options.colored_vertex, options.vertex_color);
  internal::set_color_source<Edge_index>(mesh, "e:color", options.colored_edge, options.edge_color);
  internal::set_color_source<Face_index>(mesh, "f:color", options.colored_face, options.face_color);
  add_to_graphics_scene(mesh, scene, options);
}

#ifdef CGAL_USE_BASIC_VIEWER

template <class P, class L>
void draw(const Compact_surface_mesh<P, L>& mesh, const char* title = "Compact_surface_mesh Basic Viewer")
{
  Graphics_scene scene;
  add_to_graphics_scene(mesh, scene);
  draw_graphics_scene(scene, title);
}

template <class P, class L, class GSOptions>
void draw(const Compact_surface_mesh<P, L>& mesh, const GSOptions& options,
          const char* title = "Compact_surface_mesh Basic Viewer")
{
  Graphics_scene scene;
  add_to_graphics_scene(mesh, scene, options);
  draw_graphics_scene(scene, title);
}

#endif // CGAL_USE_BASIC_VIEWER

} // namespace CGAL

#else // CGAL 5

#include <CGAL/Qt/Basic_viewer_qt.h>

#ifdef CGAL_USE_BASIC_VIEWER

#include <CGAL/Qt/init_ogl_context.h>
#include <CGAL/draw_face_graph.h>

namespace CGAL {

template <class P, class L>
void draw(const Compact_surface_mesh<P, L>& mesh, const char* title = "Compact_surface_mesh Basic Viewer",
          bool nofill = false)
{
#ifdef CGAL_TEST_SUITE
  const bool is_test = true;
#else
  const bool is_test = qEnvironmentVariableIsSet("CGAL_TEST_SUITE");
#endif
  if (is_test)
    return;
  Qt::init_ogl_context(4, 3);
  char name[] = "compact_surface_mesh_viewer";
  char* arguments[] = { name, nullptr };
  int num_arguments = 1;
  QApplication application(num_arguments, arguments);
  SimpleFaceGraphViewerQt window(application.activeWindow(), mesh, title, nofill);
  window.show();
  application.exec();
}

} // namespace CGAL

#endif // CGAL_USE_BASIC_VIEWER

#endif

#endif // CGAL_DRAW_COMPACT_SURFACE_MESH_H
