// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Windows with meshes in them. Each closes by itself; what is in it is the same as for Surface_mesh.

#include "conformance_answers.h"

#include <CGAL/draw_compact_surface_mesh.h>

#include <CGAL/Path_on_surface.h>
#include <CGAL/Qt/Basic_viewer_qt.h>
#include <CGAL/Random.h>
#include <CGAL/draw_face_graph.h>
#include <CGAL/draw_face_graph_with_paths.h>

#include <QApplication>
#include <QTimer>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace {

using test::all_pairs;
using test::Answer;
using test::expect_same_answers_in_same_order;
using test::Mesh_of;

int num_windows_closed = 0;

// Closes the windows of each application, once they have been shown.
void close_windows()
{
  QTimer::singleShot(200, qApp, [] {
    for (const QWidget* const window : QApplication::topLevelWidgets())
      num_windows_closed += window->isVisible();
    qApp->quit();
  });
}
Q_COREAPP_STARTUP_FUNCTION(close_windows)

struct Application
{
  int num_arguments = 1;
  char name[5] = "test";
  char* arguments[2] = {name, nullptr};
  QApplication application{num_arguments, arguments};
};

// A viewer that tells what it draws.
template <class Base>
struct Open_viewer
  : Base
{
  using Base::Base;
  using Base::compute_elements;

  Answer drawn() const
  {
    Answer answer;
    for (const auto& array : this->arrays)
      answer << array;
    return answer;
  }
};

TEST(Drawing, shows_what_it_shows_of_surface_mesh)
{
  const Application application;
  expect_same_answers_in_same_order(all_pairs(), [](const auto& m) {
    CGAL::get_default_random() = CGAL::Random(1); // colors are random
    Open_viewer<CGAL::SimpleFaceGraphViewerQt> viewer(nullptr, m.mesh);
    viewer.compute_elements();
    EXPECT_FALSE(viewer.is_empty());
    return viewer.drawn();
  });
}

TEST(Drawing, shows_paths_as_on_surface_mesh)
{
  const Application application;
  expect_same_answers_in_same_order({&test::genus_3_pair()}, [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    CGAL::Surface_mesh_topology::Path_on_surface<Mesh> path(m.mesh);
    path.push_back(m.halfedge_of(0));
    path.extend_positive_turn(1);
    path.extend_positive_turn(2);
    const std::vector<CGAL::Surface_mesh_topology::Path_on_surface<Mesh>> paths = {path};
    typedef CGAL::Face_graph_with_path_viewer<Mesh, CGAL::DefaultDrawingFunctorLCC> Viewer;
    const Open_viewer<Viewer> viewer(nullptr, m.mesh, &paths);
    return viewer.drawn();
  });
}

TEST(Drawing, opens_a_window)
{
  num_windows_closed = 0;
  CGAL::draw(test::borders_pair().compact.mesh);
  EXPECT_EQ(num_windows_closed, 1);
  CGAL::draw(test::polygons_pair().compact.mesh, "polygons", true);
  EXPECT_EQ(num_windows_closed, 2);
}

// Where CGAL's viewer would leave the arrays of a Surface_mesh.
TEST(Drawing, shows_isolated_vertices)
{
  const std::vector<test::Point> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 2, 2}};
  const test::Compact_mesh mesh(points, std::vector<std::vector<int>>{{0, 1, 2}});
  num_windows_closed = 0;
  CGAL::draw(mesh);
  EXPECT_EQ(num_windows_closed, 1);
}

TEST(Drawing, opens_a_window_with_paths)
{
  const auto& m = test::genus_3_pair().compact;
  CGAL::Surface_mesh_topology::Path_on_surface<test::Compact_mesh> path(m.mesh);
  path.push_back(m.halfedge_of(0));
  num_windows_closed = 0;
  CGAL::draw(m.mesh, {path});
  EXPECT_EQ(num_windows_closed, 1);
}

} // namespace
