// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// How a Compact_surface_mesh is made, copied, moved and emptied, what the constructors tell
// of it, and what they do with input that they do not take.

#include "bumpy_sphere.h"
#include "glued_polygons.h"
#include "test_scale.h"

#include <CGAL/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/layouts/Corner_table_layout.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <list>
#include <map>
#include <random>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using test::Point;
using test::Surface_mesh;
namespace parameters = CGAL::parameters;

using Triangle = std::array<int, 3>;
const std::vector<Triangle> tetrahedron = { { 0, 1, 2 }, { 0, 3, 1 }, { 1, 3, 2 }, { 2, 3, 0 } };
const std::vector<Point> corners = { Point(0, 0, 0), Point(0, 1, 0), Point(1, 0, 0), Point(0, 0, 1) };

template <class Layout>
struct Mesh_construction
  : public ::testing::Test
{
  using Mesh = CGAL::Compact_surface_mesh<Point, Layout>;
  using V = typename Mesh::Vertex_index;
  using H = typename Mesh::Halfedge_index;
  using F = typename Mesh::Face_index;
  using Size = typename Mesh::size_type;

  Surface_mesh source = test::bumpy_sphere();
};

using Layouts = ::testing::Types<CGAL::Schnyder_parents_layout<>, CGAL::Corner_table_layout<> >;
TYPED_TEST_SUITE(Mesh_construction, Layouts);

TYPED_TEST(Mesh_construction, of_a_graph_tells_every_element)
{
  using Mesh = typename TestFixture::Mesh;
  std::map<Surface_mesh::Vertex_index, typename TestFixture::V> v2v;
  std::vector<std::pair<Surface_mesh::Halfedge_index, typename TestFixture::H> > h2h;
  std::map<Surface_mesh::Face_index, typename TestFixture::F> f2f;
  const Mesh mesh(this->source, parameters::vertex_to_vertex_map(boost::make_assoc_property_map(v2v))
                                  .halfedge_to_halfedge_output_iterator(std::back_inserter(h2h))
                                  .face_to_face_map(boost::make_assoc_property_map(f2f)));
  ASSERT_EQ(h2h.size(), this->source.number_of_halfedges());
  ASSERT_EQ(f2f.size(), this->source.number_of_faces());
  std::map<Surface_mesh::Halfedge_index, typename TestFixture::H> image(h2h.begin(), h2h.end());
  ASSERT_EQ(image.size(), h2h.size());
  for (const auto& pair : h2h) {
    const auto h = pair.first;
    EXPECT_EQ(mesh.target(pair.second), v2v[this->source.target(h)]);
    EXPECT_EQ(mesh.source(pair.second), v2v[this->source.source(h)]);
    EXPECT_EQ(mesh.next(pair.second), image[this->source.next(h)]);
    EXPECT_EQ(mesh.opposite(pair.second), image[this->source.opposite(h)]);
    EXPECT_EQ(mesh.face(pair.second), f2f[this->source.face(h)]);
  }
}

TYPED_TEST(Mesh_construction, tells_the_permutation_both_ways)
{
  using Mesh = typename TestFixture::Mesh;
  using V = typename TestFixture::V;
  using F = typename TestFixture::F;
  using Size = typename TestFixture::Size;
  std::vector<V> v2v;
  std::vector<F> f2f(tetrahedron.size());
  const Mesh mesh(corners, tetrahedron,
                  parameters::input_index_maps(true)
                    .vertex_to_vertex_output_iterator(boost::make_function_output_iterator(
                        [&](const std::pair<std::size_t, V>& pair) {
                          EXPECT_EQ(pair.first, v2v.size());
                          v2v.push_back(pair.second);
                        }))
                    .face_to_face_map(CGAL::make_property_map(f2f)));
  const auto vertex_number = mesh.template find_property_map<V, Size>("v:input_index");
  const auto face_number = mesh.template find_property_map<F, Size>("f:input_index");
  ASSERT_TRUE(bool(vertex_number) && bool(face_number));
  ASSERT_EQ(v2v.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(vertex_number[v2v[i]], i);
    EXPECT_EQ(mesh.point(v2v[i]), corners[i]);
    EXPECT_EQ(face_number[f2f[i]], i);
    for (const V v : mesh.vertices_of_face(f2f[i]))
      EXPECT_EQ(std::count(tetrahedron[i].begin(), tetrahedron[i].end(), int(vertex_number[v])), 1);
    const auto c = mesh.vertices_of_face(f2f[i]);
    EXPECT_TRUE(mesh.halfedge(v2v[tetrahedron[i][0]], v2v[tetrahedron[i][1]]).is_valid());
    EXPECT_EQ(mesh.face(mesh.halfedge(v2v[tetrahedron[i][0]], v2v[tetrahedron[i][1]])), f2f[i]);
    EXPECT_EQ(mesh.face(mesh.halfedge(c[0], c[1])), f2f[i]);
  }
}

TYPED_TEST(Mesh_construction, adds_no_property_map_unasked)
{
  using V = typename TestFixture::V;
  const typename TestFixture::Mesh mesh(this->source);
  const typename TestFixture::Mesh asked_not_to(this->source, parameters::input_index_maps(false));
  EXPECT_EQ(mesh.template properties<V>().size(), 1u);
  EXPECT_EQ(asked_not_to.template properties<V>().size(), 1u);
}

TYPED_TEST(Mesh_construction, takes_the_callers_points_and_numbers)
{
  using Mesh = typename TestFixture::Mesh;
  using V = typename TestFixture::V;
  using Size = typename TestFixture::Size;
  const std::size_t n = this->source.number_of_vertices();
  std::map<Surface_mesh::Vertex_index, std::size_t> reversed;
  std::map<Surface_mesh::Vertex_index, Point> flat;
  for (const auto v : this->source.vertices()) {
    reversed[v] = n - 1 - v;
    flat[v] = Point(v, 0, 0);
  }
  const Mesh mesh(this->source, parameters::input_index_maps(true)
                                  .vertex_index_map(boost::make_assoc_property_map(reversed))
                                  .vertex_point_map(boost::make_assoc_property_map(flat)));
  const auto number = mesh.template find_property_map<V, Size>("v:input_index");
  for (const V v : mesh.vertices())
    EXPECT_EQ(mesh.point(v), Point(n - 1 - number[v], 0, 0));
}

TYPED_TEST(Mesh_construction, of_other_graphs)
{
  using Mesh = typename TestFixture::Mesh;
  using Polyhedron = CGAL::Polyhedron_3<test::Kernel>;
  const double area = CGAL::Polygon_mesh_processing::area(this->source);
  Polyhedron polyhedron;
  CGAL::copy_face_graph(this->source, polyhedron);
  EXPECT_NEAR(CGAL::Polygon_mesh_processing::area(Mesh(polyhedron)), area, 1e-12 * area);

  const CGAL::Compact_surface_mesh<Point> other_layout(this->source);
  EXPECT_NEAR(CGAL::Polygon_mesh_processing::area(Mesh(other_layout)), area, 1e-12 * area);

  const CGAL::Face_filtered_graph<Surface_mesh> all_faces(this->source, std::vector<Surface_mesh::Face_index>(
      this->source.faces_begin(), this->source.faces_end()));
  EXPECT_NEAR(CGAL::Polygon_mesh_processing::area(Mesh(all_faces)), area, 1e-12 * area);
}

TYPED_TEST(Mesh_construction, can_be_undone)
{
  const double area = CGAL::Polygon_mesh_processing::area(this->source);
  const typename TestFixture::Mesh mesh(this->source);
  Surface_mesh back;
  CGAL::copy_face_graph(mesh, back);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(back));
  EXPECT_EQ(back.number_of_faces(), this->source.number_of_faces());
  EXPECT_NEAR(CGAL::Polygon_mesh_processing::area(back), area, 1e-12 * area);
}

TYPED_TEST(Mesh_construction, leaves_removed_elements_out)
{
  using Mesh = typename TestFixture::Mesh;
  using V = typename TestFixture::V;
  const double area = CGAL::Polygon_mesh_processing::area(this->source);
  Surface_mesh with_garbage;
  with_garbage.remove_vertex(with_garbage.add_vertex(Point(9, 9, 9)));
  with_garbage.set_recycle_garbage(false);
  with_garbage += this->source;
  with_garbage.remove_vertex(with_garbage.add_vertex(Point(8, 8, 8)));
  ASSERT_TRUE(with_garbage.has_garbage());
  std::map<Surface_mesh::Vertex_index, V> v2v;
  const Mesh mesh(with_garbage, parameters::vertex_to_vertex_map(boost::make_assoc_property_map(v2v)));
  EXPECT_EQ(mesh.number_of_vertices(), this->source.number_of_vertices());
  EXPECT_NEAR(CGAL::Polygon_mesh_processing::area(mesh), area, 1e-12 * area);
  for (const auto v : with_garbage.vertices())
    EXPECT_EQ(mesh.point(v2v[v]), with_garbage.point(v));
}

struct Plain_point
{
  double x = 0;
  std::string name;
};

TEST(Mesh_points, can_be_of_any_type)
{
  const std::vector<Plain_point> named = { { 0, "a" }, { 1, "b" }, { 2, "c" }, { 3, "d" } };
  std::map<std::size_t, CGAL::Compact_surface_mesh<Plain_point>::Vertex_index> v2v;
  const CGAL::Compact_surface_mesh<Plain_point> plain(
      named, tetrahedron, parameters::vertex_to_vertex_map(boost::make_assoc_property_map(v2v)));
  EXPECT_EQ(plain.point(v2v[2]).name, "c");
  EXPECT_EQ(get(CGAL::vertex_point, plain, v2v[3]).x, 3);
  const CGAL::Compact_surface_mesh<Plain_point> copied(plain);
  EXPECT_EQ(copied.point(v2v[1]).name, "b");

  using Float_point = CGAL::Simple_cartesian<float>::Point_3;
  const CGAL::Compact_surface_mesh<Float_point> floats(corners, tetrahedron); // converts
  EXPECT_NEAR(CGAL::Polygon_mesh_processing::volume(floats), 1.f / 6, 1e-6);

  using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  const CGAL::Compact_surface_mesh<Exact_kernel::Point_3> exact(corners, tetrahedron);
  EXPECT_EQ(CGAL::Polygon_mesh_processing::volume(exact), Exact_kernel::FT(1) / 6);

  using Point_2 = test::Kernel::Point_2;
  const std::list<Point_2> plane = { Point_2(0, 0), Point_2(3, 0), Point_2(0, 4), Point_2(1, 1) };
  const CGAL::Compact_surface_mesh<Point_2> planar(plane, tetrahedron);
  std::vector<double> lengths;
  for (const auto e : edges(planar))
    lengths.push_back(get(boost::edge_weight, planar, e));
  EXPECT_DOUBLE_EQ(*std::max_element(lengths.begin(), lengths.end()), 5);
}

TYPED_TEST(Mesh_construction, copies_are_deep)
{
  using Mesh = typename TestFixture::Mesh;
  using V = typename TestFixture::V;
  Mesh mesh(this->source);
  auto weight = mesh.template add_property_map<V, int>("v:weight", 3).first;
  Mesh copy(mesh);
  weight[V(0)] = 4;
  const Point first = copy.point(V(0));
  mesh.point(V(0)) = CGAL::ORIGIN;
  EXPECT_EQ(copy.point(V(0)), first);
  EXPECT_EQ((copy.template find_property_map<V, int>("v:weight")[V(0)]), 3);
  EXPECT_TRUE(copy.is_valid());

  Mesh bare;
  bare.assign(mesh);
  EXPECT_EQ(bare.point(V(0)), CGAL::ORIGIN);
  EXPECT_EQ(bare.template properties<V>().size(), 1u);
  EXPECT_TRUE(bare.is_valid());

  copy = mesh;
  EXPECT_EQ(copy.point(V(0)), CGAL::ORIGIN);
  const Mesh& itself = copy;
  copy = itself;
  EXPECT_EQ(copy.number_of_vertices(), mesh.number_of_vertices());
}

template <class Mesh>
void expect_usable_and_empty(Mesh& mesh)
{
  using V = typename Mesh::Vertex_index;
  EXPECT_TRUE(mesh.is_empty());
  EXPECT_EQ(num_vertices(mesh) + num_halfedges(mesh) + num_edges(mesh) + num_faces(mesh), 0u);
  EXPECT_TRUE(vertices(mesh).empty() && faces(mesh).empty());
  EXPECT_TRUE(mesh.is_valid());
  EXPECT_EQ(mesh.references_per_vertex(), 0);
  EXPECT_EQ(std::distance(mesh.points().begin(), mesh.points().end()), 0);
  EXPECT_EQ(mesh.template properties<V>(), std::vector<std::string>(1, "v:point"));
}

TYPED_TEST(Mesh_construction, moves_leave_an_empty_mesh)
{
  using Mesh = typename TestFixture::Mesh;
  using V = typename TestFixture::V;
  static_assert(std::is_nothrow_move_constructible<Mesh>::value && std::is_nothrow_move_assignable<Mesh>::value, "");
  Mesh mesh(this->source);
  mesh.template add_property_map<V, int>("v:weight", 3);
  const Point* const first = &mesh.point(V(0));
  Mesh moved(std::move(mesh));
  EXPECT_EQ(&moved.point(V(0)), first); // nothing was copied
  EXPECT_TRUE(moved.is_valid());
  EXPECT_TRUE(bool(moved.template find_property_map<V, int>("v:weight")));
  expect_usable_and_empty(mesh);
  EXPECT_EQ(mesh.connectivity_bytes(), 0u);

  mesh = std::move(moved);
  EXPECT_EQ(&mesh.point(V(0)), first);
  expect_usable_and_empty(moved);

  swap(mesh, moved);
  EXPECT_EQ(&moved.point(V(0)), first);
  expect_usable_and_empty(mesh);

  moved.clear();
  expect_usable_and_empty(moved);
  EXPECT_EQ(moved.connectivity_bytes(), 0u);
  Mesh nothing;
  expect_usable_and_empty(nothing);
}

TYPED_TEST(Mesh_construction, of_nothing_is_empty)
{
  using Mesh = typename TestFixture::Mesh;
  Mesh of_soup(std::vector<Point>{}, std::vector<Triangle>{});
  expect_usable_and_empty(of_soup);
  Mesh of_graph(Surface_mesh{});
  expect_usable_and_empty(of_graph);
}

// What the construction of a soup throws, and of which element it says so; nothing may be reported then.
template <class Mesh>
std::pair<CGAL::Mesh_defect, std::size_t> defect_of(std::size_t num_points, const std::vector<std::vector<int> >& faces)
{
  std::map<std::size_t, typename Mesh::Vertex_index> v2v;
  try {
    const Mesh mesh(std::vector<Point>(num_points), faces,
                    parameters::vertex_to_vertex_map(boost::make_assoc_property_map(v2v)));
    ADD_FAILURE() << "nothing was thrown";
  } catch (const CGAL::Mesh_defect_exception& e) {
    EXPECT_TRUE(v2v.empty());
    return { e.defect(), e.element() };
  }
  return { CGAL::Mesh_defect::too_many_elements, 0 };
}

TYPED_TEST(Mesh_construction, refuses_what_is_no_oriented_manifold)
{
  using Mesh = typename TestFixture::Mesh;
  using D = CGAL::Mesh_defect;
  using Found = std::pair<D, std::size_t>;
  EXPECT_EQ(defect_of<Mesh>(4, { { 0, 1, 2 }, { 0, 1, 4 } }), Found(D::index_out_of_range, 1));
  EXPECT_EQ(defect_of<Mesh>(4, { { 0, 1, -1 } }), Found(D::index_out_of_range, 0));
  EXPECT_EQ(defect_of<Mesh>(4, { { 0, 1, 2 }, { 0, 1 } }), Found(D::degenerate_face, 1));
  EXPECT_EQ(defect_of<Mesh>(4, { { 0, 1, 1 } }), Found(D::repeated_vertex, 0));
  EXPECT_EQ(defect_of<Mesh>(5, { { 0, 1, 2 }, { 0, 2, 3, 4, 2 } }), Found(D::repeated_vertex, 1));
  EXPECT_EQ(defect_of<Mesh>(5, { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } }).first, D::nonmanifold_edge);
  EXPECT_EQ(defect_of<Mesh>(4, { { 0, 1, 2, 3 }, { 1, 2, 3, 0 } }).first, D::duplicate_face);
  EXPECT_EQ(defect_of<Mesh>(5, { { 0, 1, 2 }, { 0, 1, 3, 4 } }).first, D::inconsistent_orientation);
  // a Moebius strip
  EXPECT_EQ(defect_of<Mesh>(5, { { 0, 1, 2 }, { 2, 1, 3 }, { 2, 3, 4 }, { 4, 3, 0 }, { 4, 0, 1 } }).first,
            D::inconsistent_orientation);
  // a tetrahedron and a triangle that share vertex 3, and two tetrahedra
  const std::vector<std::vector<int> > tetrahedron = { { 0, 1, 2 }, { 0, 3, 1 }, { 1, 3, 2 }, { 2, 3, 0 } };
  auto faces = tetrahedron;
  faces.push_back({ 3, 4, 5 });
  EXPECT_EQ(defect_of<Mesh>(6, faces), Found(D::nonmanifold_vertex, 3));
  faces.pop_back();
  faces.insert(faces.end(), { { 3, 4, 5 }, { 3, 6, 4 }, { 4, 6, 5 }, { 5, 6, 3 } });
  EXPECT_EQ(defect_of<Mesh>(7, faces), Found(D::nonmanifold_vertex, 3));
}

TYPED_TEST(Mesh_construction, refuses_vertex_index_maps_that_are_no_numbering)
{
  using Mesh = typename TestFixture::Mesh;
  Surface_mesh graph = this->source;
  const Surface_mesh::Vertex_index isolated = graph.add_vertex(Point(0, 0, 0));
  auto index = graph.add_property_map<Surface_mesh::Vertex_index, std::size_t>("v:index").first;
  for (const auto v : graph.vertices())
    index[v] = v;
  EXPECT_EQ(Mesh(graph, parameters::vertex_index_map(index)).number_of_vertices(), graph.number_of_vertices());
  for (const std::size_t wrong : { std::size_t(0), std::size_t(graph.number_of_vertices()), std::size_t(-1) }) {
    index[isolated] = wrong;
    try {
      const Mesh mesh(graph, parameters::vertex_index_map(index));
      ADD_FAILURE() << "nothing was thrown";
    } catch (const CGAL::Mesh_defect_exception& e) {
      EXPECT_EQ(e.defect(), CGAL::Mesh_defect::wrong_vertex_index);
      EXPECT_EQ(e.element(), std::size_t(isolated));
    }
  }
}

TYPED_TEST(Mesh_construction, that_fails_leaves_the_target_as_it_was)
{
  using Mesh = typename TestFixture::Mesh;
  using V = typename TestFixture::V;
  Mesh mesh(this->source);
  const Point first = mesh.point(V(0));
  const std::vector<std::vector<int> > doubled = { { 0, 1, 2 }, { 0, 1, 2 } };
  EXPECT_THROW(mesh = Mesh(corners, doubled), CGAL::Mesh_defect_exception);
  EXPECT_EQ(mesh.number_of_faces(), this->source.number_of_faces());
  EXPECT_EQ(mesh.point(V(0)), first);
  EXPECT_TRUE(mesh.is_valid());
}

// Open, with two fans at a vertex, polygons of all sizes, and a vertex without faces.
TYPED_TEST(Mesh_construction, takes_borders_polygons_and_isolated_vertices)
{
  using Mesh = typename TestFixture::Mesh;
  using V = typename TestFixture::V;
  std::vector<std::vector<int> > faces = { { 0, 1, 2 }, { 0, 2, 3, 4 }, { 0, 5, 6, 7, 8 }, {} };
  for (int i = 0; i < 20; ++i)
    faces.back().push_back(6 + (20 - i) % 20 + (i == 0 ? 0 : 3)); // 6, 28, 27, ..., 10
  std::vector<Point> points;
  for (int i = 0; i < 30; ++i)
    points.push_back(Point(i, 0, 0));
  std::map<std::size_t, V> v2v;
  std::map<std::size_t, typename Mesh::Face_index> f2f;
  const Mesh mesh(points, faces, CGAL::parameters::input_index_maps(true)
                                     .vertex_to_vertex_map(boost::make_assoc_property_map(v2v))
                                     .face_to_face_map(boost::make_assoc_property_map(f2f)));
  EXPECT_EQ(mesh.number_of_vertices(), 30u);
  EXPECT_EQ(mesh.number_of_faces(), 4u);
  EXPECT_EQ(mesh.number_of_edges(), 31u);
  EXPECT_TRUE(mesh.is_valid());
  EXPECT_TRUE(mesh.is_isolated(v2v[29]) && mesh.is_isolated(v2v[9]));
  EXPECT_TRUE(mesh.is_border(v2v[29]));
  EXPECT_EQ(mesh.degree(v2v[29]), 0u);
  EXPECT_EQ(mesh.degree(v2v[0]), 5u);
  EXPECT_TRUE(mesh.is_border(mesh.halfedge(v2v[0])));
  for (std::size_t f = 0; f < faces.size(); ++f) {
    EXPECT_EQ(mesh.degree(f2f[f]), faces[f].size());
    std::set<V> expected, found;
    for (const int i : faces[f])
      expected.insert(v2v[i]);
    for (const V v : CGAL::vertices_around_face(mesh.halfedge(f2f[f]), mesh))
      found.insert(v);
    EXPECT_EQ(expected, found) << f;
  }
  for (int i = 0; i < 30; ++i)
    EXPECT_EQ(mesh.point(v2v[i]), points[i]);
  std::size_t num_border_halfedges = 0;
  for (const auto h : mesh.halfedges())
    num_border_halfedges += mesh.is_border(h) ? 1 : 0;
  EXPECT_EQ(num_border_halfedges, 2 * mesh.number_of_edges() - (3 + 4 + 5 + 20));
}

// The maps of the constructor from a graph, on borders too.
TYPED_TEST(Mesh_construction, tells_what_became_of_border_halfedges)
{
  using Mesh = typename TestFixture::Mesh;
  Surface_mesh with_border = this->source;
  CGAL::Euler::remove_face(with_border.halfedge(Surface_mesh::Face_index(0)), with_border);
  with_border.collect_garbage();
  std::map<Surface_mesh::Vertex_index, typename Mesh::Vertex_index> v2v;
  std::map<Surface_mesh::Halfedge_index, typename Mesh::Halfedge_index> h2h;
  std::map<Surface_mesh::Face_index, typename Mesh::Face_index> f2f;
  const Mesh mesh(with_border, parameters::vertex_to_vertex_map(boost::make_assoc_property_map(v2v))
                                   .halfedge_to_halfedge_map(boost::make_assoc_property_map(h2h))
                                   .face_to_face_map(boost::make_assoc_property_map(f2f)));
  EXPECT_EQ(h2h.size(), with_border.number_of_halfedges());
  for (const auto h : with_border.halfedges()) {
    EXPECT_EQ(v2v[with_border.target(h)], mesh.target(h2h[h]));
    EXPECT_EQ(h2h[with_border.next(h)], mesh.next(h2h[h]));
    EXPECT_EQ(h2h[with_border.opposite(h)], mesh.opposite(h2h[h]));
    EXPECT_EQ(with_border.is_border(h), mesh.is_border(h2h[h]));
    if (!with_border.is_border(h)) {
      EXPECT_EQ(f2f[with_border.face(h)], mesh.face(h2h[h]));
    }
  }
}

// Two edges of a graph may have the same ends, unlike those of a soup.
TYPED_TEST(Mesh_construction, takes_graphs_with_double_edges)
{
  using Mesh = typename TestFixture::Mesh;
  using H = typename TestFixture::H;
  std::size_t num_doubled = 0;
  for (unsigned int seed = 0; seed < (std::max<std::size_t>)(300, test::scaled(3000)); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng(seed);
    const Surface_mesh graph = test::graph_of<Surface_mesh>(test::random_glued_polygons(rng));
    std::map<Surface_mesh::Vertex_index, typename TestFixture::V> v2v;
    std::map<Surface_mesh::Halfedge_index, H> h2h;
    std::map<Surface_mesh::Face_index, typename TestFixture::F> f2f;
    const Mesh mesh(graph, parameters::vertex_to_vertex_map(boost::make_assoc_property_map(v2v))
                               .halfedge_to_halfedge_map(boost::make_assoc_property_map(h2h))
                               .face_to_face_map(boost::make_assoc_property_map(f2f)));
    ASSERT_EQ(mesh.number_of_vertices(), graph.number_of_vertices());
    ASSERT_EQ(mesh.number_of_halfedges(), graph.number_of_halfedges());
    ASSERT_EQ(mesh.number_of_faces(), graph.number_of_faces());
    ASSERT_TRUE(mesh.is_valid());
    std::set<H> images;
    std::set<std::pair<typename TestFixture::V, typename TestFixture::V>> ends;
    for (const auto h : graph.halfedges()) {
      ASSERT_TRUE(images.insert(h2h[h]).second);
      num_doubled += ends.insert({ mesh.source(h2h[h]), mesh.target(h2h[h]) }).second ? 0 : 1;
      ASSERT_EQ(mesh.target(h2h[h]), v2v[graph.target(h)]);
      ASSERT_EQ(mesh.opposite(h2h[h]), h2h[graph.opposite(h)]);
      ASSERT_EQ(mesh.is_border(h2h[h]), graph.is_border(h));
      if (graph.is_border(h)) {
        ASSERT_TRUE(mesh.is_border(mesh.next(h2h[h]))); // fans may follow in another order
        continue;
      }
      ASSERT_EQ(mesh.next(h2h[h]), h2h[graph.next(h)]);
      ASSERT_EQ(mesh.prev(h2h[h]), h2h[graph.prev(h)]);
      ASSERT_EQ(mesh.face(h2h[h]), f2f[graph.face(h)]);
      ASSERT_EQ(mesh.target(mesh.halfedge(mesh.source(h2h[h]), mesh.target(h2h[h]))), mesh.target(h2h[h]));
    }
    for (const auto v : mesh.vertices()) { // one cycle through all of its halfedges, from a border one on
      std::size_t degree = 0;
      bool is_on_border = false;
      for (const auto h : mesh.halfedges())
        if (mesh.target(h) == v) {
          ++degree;
          is_on_border = is_on_border || mesh.is_border(h);
        }
      ASSERT_EQ(mesh.degree(v), degree);
      ASSERT_EQ(mesh.is_border(v), is_on_border || degree == 0);
    }
  }
  EXPECT_GT(num_doubled, 300u);
}

TYPED_TEST(Mesh_construction, reports_its_memory)
{
  using Mesh = typename TestFixture::Mesh;
  const Mesh mesh(this->source);
  std::size_t bytes = 0;
  for (const auto& array : mesh.connectivity_memory())
    bytes += array.second;
  EXPECT_EQ(mesh.connectivity_bytes(), bytes);
  EXPECT_DOUBLE_EQ(mesh.references_per_vertex() * sizeof(typename Mesh::size_type) * mesh.num_vertices(), bytes);
  EXPECT_GE(mesh.references_per_vertex(), 4);
}

// Not even by accident.
TEST(Mesh_interface, does_not_pretend_to_edit)
{
  using Mesh = CGAL::Compact_surface_mesh<Point>;
  static_assert(!std::is_constructible<Mesh, int>::value, "");
  static_assert(!std::is_convertible<Surface_mesh, Mesh>::value, "");
  static_assert(std::is_constructible<Mesh, Surface_mesh>::value, "");
  static_assert(std::is_same<CGAL::Compact_surface_mesh<Point, CGAL::Schnyder_parents_layout<> >, Mesh>::value, "");
  Mesh mesh;
  mesh.collect_garbage();
  mesh.reserve(1, 2, 3);
  EXPECT_FALSE(mesh.has_garbage());
  EXPECT_EQ(mesh.number_of_removed_vertices(), 0u);
}

} // namespace
