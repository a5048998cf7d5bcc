// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The specialized iterators and circulators of CGAL around vertices and faces, against what the
// operators say, from every halfedge on.

#include <CGAL/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/layouts/Corner_table_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/Input_order_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/Schnyder_fronts_layout.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/iterator.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <vector>

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;

// A tetrahedron; a cube of squares without its top, with a square on its bottom's diagonal cut in
// two; two triangles that share a vertex only; an octagon; a vertex alone.
template <class Mesh>
Mesh mesh_of_everything()
{
  const std::vector<std::vector<std::size_t> > polygons = {
    { 0, 1, 2 }, { 0, 3, 1 }, { 1, 3, 2 }, { 2, 3, 0 },
    { 4, 7, 6 }, { 4, 6, 5 }, { 4, 5, 9, 8 }, { 5, 6, 10, 9 }, { 6, 7, 11, 10 }, { 7, 4, 8, 11 },
    { 12, 13, 14 }, { 12, 15, 16 },
    { 17, 18, 19, 20, 21, 22, 23, 24 } };
  return Mesh(std::vector<Point>(26), polygons);
}

// A triangulated sphere: a double wheel.
template <class Mesh>
Mesh sphere()
{
  std::vector<std::array<std::size_t, 3> > triangles;
  const std::size_t n = 20;
  for (std::size_t i = 0; i < n; ++i) {
    triangles.push_back({ i, (i + 1) % n, n });
    triangles.push_back({ (i + 1) % n, i, n + 1 });
  }
  return Mesh(std::vector<Point>(n + 2), triangles);
}

template <class Layout>
struct Around_iterators
  : public ::testing::Test
{};
using Layouts = ::testing::Types<CGAL::Schnyder_parents_layout<>, CGAL::Input_order_layout<>,
                                 CGAL::Schnyder_fronts_layout<4>, CGAL::Corner_table_layout<> >;
TYPED_TEST_SUITE(Around_iterators, Layouts);

// Goes from h around once and back.
template <class Iterator, class Mesh, class Halfedge, class Step, class Value>
void expect_iterator(const Mesh& mesh, Halfedge h, const Step& step, const Value& value)
{
  const Iterator begin(h, mesh), end(h, mesh, 1);
  EXPECT_EQ(begin, Iterator(h, mesh));
  EXPECT_NE(begin, end);
  Iterator it = begin;
  Halfedge g = h;
  std::size_t n = 0;
  do {
    ASSERT_NE(it, end);
    EXPECT_EQ(*it, value(g));
    EXPECT_EQ(it.operator->().operator->()->idx(), value(g).idx());
    EXPECT_EQ(it, Iterator(g, mesh)); // wherever it started
    EXPECT_EQ(*it, *Iterator(g, mesh));
    const Iterator old = it++;
    EXPECT_EQ(*old, value(g));
    EXPECT_NE(old, it);
    g = step(g);
    ++n;
  } while (g != h);
  EXPECT_EQ(it, end);
  EXPECT_EQ(static_cast<std::size_t>(std::distance(begin, end)), n);
  std::vector<Halfedge> halfedges;
  do {
    halfedges.push_back(g);
    g = step(g);
  } while (g != h);
  for (std::size_t i = n; i-- > 0;) {
    if (i % 2 == 0)
      --it;
    else
      it--;
    EXPECT_EQ(*it, value(halfedges[i]));
  }
  EXPECT_EQ(it, begin);
}

template <class Circulator, class Mesh, class Halfedge, class Step, class Value>
void expect_circulator(const Mesh& mesh, Halfedge h, const Step& step, const Value& value)
{
  const Circulator first(h, mesh);
  EXPECT_TRUE(static_cast<bool>(first));
  EXPECT_FALSE(first == nullptr);
  EXPECT_TRUE(Circulator() == nullptr);
  Circulator c = first;
  Halfedge g = h;
  do {
    EXPECT_EQ(*c, value(g));
    EXPECT_EQ(c, Circulator(g, mesh)); // wherever it started
    ++c;
    g = step(g);
    Circulator back = c;
    --back;
    EXPECT_NE(back, c);
    ++back;
    EXPECT_EQ(back, c);
  } while (g != h);
  EXPECT_EQ(c, first);
}

template <class Mesh>
void expect_all(const Mesh& mesh)
{
  using Halfedge = typename Mesh::Halfedge_index;
  const auto around_target = [&](Halfedge h) { return opposite(next(h, mesh), mesh); };
  const auto around_source = [&](Halfedge h) { return next(opposite(h, mesh), mesh); };
  const auto around_face = [&](Halfedge h) { return next(h, mesh); };
  const auto itself = [](Halfedge h) { return h; };
  const auto its_source = [&](Halfedge h) { return source(h, mesh); };
  const auto its_target = [&](Halfedge h) { return target(h, mesh); };
  const auto its_edge = [&](Halfedge h) { return edge(h, mesh); };
  for (const Halfedge h : halfedges(mesh)) {
    expect_iterator<CGAL::Halfedge_around_target_iterator<Mesh> >(mesh, h, around_target, itself);
    expect_iterator<CGAL::Halfedge_around_source_iterator<Mesh> >(mesh, h, around_source, itself);
    expect_iterator<CGAL::Halfedge_around_face_iterator<Mesh> >(mesh, h, around_face, itself);
    expect_iterator<CGAL::Vertex_around_target_iterator<Mesh> >(mesh, h, around_target, its_source);
    expect_iterator<CGAL::Vertex_around_face_iterator<Mesh> >(mesh, h, around_face, its_target);
    expect_iterator<CGAL::In_edge_iterator<Mesh> >(mesh, h, around_target, its_edge);
    expect_iterator<CGAL::Out_edge_iterator<Mesh> >(mesh, h, around_target, its_edge);
    expect_circulator<CGAL::Halfedge_around_target_circulator<Mesh> >(mesh, h, around_target, itself);
    expect_circulator<CGAL::Halfedge_around_source_circulator<Mesh> >(mesh, h, around_source, itself);
    expect_circulator<CGAL::Halfedge_around_face_circulator<Mesh> >(mesh, h, around_face, itself);
    expect_circulator<CGAL::Vertex_around_target_circulator<Mesh> >(mesh, h, around_target, its_source);
    expect_circulator<CGAL::Vertex_around_face_circulator<Mesh> >(mesh, h, around_face, its_target);
    const CGAL::In_edge_iterator<Mesh> in(h, mesh);
    EXPECT_EQ(target(*in, mesh), target(h, mesh));
    const CGAL::Out_edge_iterator<Mesh> out(h, mesh);
    EXPECT_EQ(source(*out, mesh), target(h, mesh));
  }
  for (const auto v : vertices(mesh)) {
    if (mesh.is_isolated(v)) {
      EXPECT_TRUE(CGAL::vertices_around_target(halfedge(v, mesh), mesh).empty());
      EXPECT_TRUE(CGAL::halfedges_around_target(halfedge(v, mesh), mesh).empty());
      continue;
    }
    EXPECT_EQ(*CGAL::Halfedge_around_target_circulator<Mesh>(v, mesh), halfedge(v, mesh));
    EXPECT_EQ(source(*CGAL::Halfedge_around_source_circulator<Mesh>(v, mesh), mesh), v);
  }
}

TYPED_TEST(Around_iterators, go_where_the_operators_go)
{
  using Mesh = CGAL::Compact_surface_mesh<Point, TypeParam>;
  expect_all(mesh_of_everything<Mesh>());
  expect_all(sphere<Mesh>());
}

TYPED_TEST(Around_iterators, find_nothing_around_no_halfedge)
{
  using Mesh = CGAL::Compact_surface_mesh<Point, TypeParam>;
  using Iterator = CGAL::Vertex_around_face_iterator<Mesh>;
  const Mesh mesh = sphere<Mesh>();
  const auto none = boost::graph_traits<Mesh>::null_halfedge();
  EXPECT_FALSE(mesh.layout().is_in_triangle(TypeParam::null_index()));
  EXPECT_TRUE(CGAL::vertices_around_face(none, mesh).empty());
  EXPECT_TRUE(CGAL::halfedges_around_face(none, mesh).empty());
  const Iterator some(*halfedges(mesh).begin(), mesh);
  EXPECT_NE(Iterator(none, mesh), some);
  EXPECT_NE(some, Iterator(none, mesh));
}

TYPED_TEST(Around_iterators, can_be_made_without_a_mesh)
{
  using Mesh = CGAL::Compact_surface_mesh<Point, TypeParam>;
  EXPECT_TRUE(CGAL::Vertex_around_target_iterator<Mesh>() == CGAL::Vertex_around_target_iterator<Mesh>());
  EXPECT_TRUE(CGAL::Vertex_around_face_circulator<Mesh>() == CGAL::Vertex_around_face_circulator<Mesh>());
  EXPECT_FALSE(static_cast<bool>(CGAL::Halfedge_around_face_iterator<Mesh>()));
}

} // namespace
