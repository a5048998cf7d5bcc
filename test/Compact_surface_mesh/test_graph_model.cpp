// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The class and the graph that it models: concepts, descriptors, property maps and
// algorithms, against Surface_mesh.

#include "bumpy_sphere.h"
#include "../../examples/Compact_surface_mesh/names_of_cgal_6.h"

#include <CGAL/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/layouts/Corner_table_layout.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/boost/graph/graph_concepts.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/property_maps.h>

#include <boost/functional/hash.hpp>
#include <boost/graph/boyer_myrvold_planar_test.hpp>
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/graph_concepts.hpp>
#include <boost/range/has_range_iterator.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <type_traits>
#include <unordered_set>
#include <utility>
#include <vector>

namespace {

using test::Kernel;
using test::Point;
using test::Surface_mesh;
namespace parameters = CGAL::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;

template <class Layout>
struct Graph_model
  : public ::testing::Test
{
  using Mesh = CGAL::Compact_surface_mesh<Point, Layout>;
  using V = typename Mesh::Vertex_index;
  using H = typename Mesh::Halfedge_index;
  using E = typename Mesh::Edge_index;
  using F = typename Mesh::Face_index;

  Surface_mesh source = test::bumpy_sphere();
};

using Layouts = ::testing::Types<CGAL::Schnyder_parents_layout<4>, CGAL::Schnyder_parents_layout<5>,
                                 CGAL::Schnyder_parents_layout<6>, CGAL::Schnyder_parents_layout<4, std::uint64_t>,
                                 CGAL::Corner_table_layout<> >;
TYPED_TEST_SUITE(Graph_model, Layouts);

template <class G>
void check_concepts()
{
  BOOST_CONCEPT_ASSERT((boost::concepts::Graph<G>));
  BOOST_CONCEPT_ASSERT((boost::concepts::IncidenceGraph<G>));
  BOOST_CONCEPT_ASSERT((boost::concepts::BidirectionalGraph<G>));
  BOOST_CONCEPT_ASSERT((boost::concepts::AdjacencyGraph<G>));
  BOOST_CONCEPT_ASSERT((boost::concepts::VertexListGraph<G>));
  BOOST_CONCEPT_ASSERT((boost::concepts::EdgeListGraph<G>));
  BOOST_CONCEPT_ASSERT((boost::concepts::VertexAndEdgeListGraph<G>));
  BOOST_CONCEPT_ASSERT((CGAL::HalfedgeGraphConcept<G>));
  BOOST_CONCEPT_ASSERT((CGAL::HalfedgeListGraphConcept<G>));
  BOOST_CONCEPT_ASSERT((CGAL::FaceGraphConcept<G>));
  BOOST_CONCEPT_ASSERT((CGAL::FaceListGraphConcept<G>));

  using Traits = boost::graph_traits<G>;
  using V = typename Traits::vertex_descriptor;
  using E = typename Traits::edge_descriptor;
  BOOST_CONCEPT_ASSERT((boost::concepts::ReadablePropertyGraph<G, V, boost::vertex_index_t>));
  BOOST_CONCEPT_ASSERT((boost::concepts::ReadablePropertyGraph<G, E, boost::edge_index_t>));
  BOOST_CONCEPT_ASSERT((boost::concepts::ReadablePropertyGraph<G, E, boost::edge_weight_t>));
  BOOST_CONCEPT_ASSERT((boost::concepts::PropertyGraph<G, V, CGAL::vertex_point_t>));
  BOOST_CONCEPT_ASSERT((boost::LvaluePropertyMapConcept<
    typename boost::property_map<G, CGAL::vertex_point_t>::type, V>));
  BOOST_CONCEPT_ASSERT((boost::LvaluePropertyMapConcept<
    typename boost::property_map<G, CGAL::dynamic_vertex_property_t<bool> >::type, V>));

  static_assert(!boost::has_range_iterator<G>::value, "a mesh is no range");
  static_assert(!boost::has_range_const_iterator<G>::value, "a mesh is no range");
  static_assert(CGAL::graph_has_property<G, boost::vertex_index_t>::value, "");
  static_assert(CGAL::graph_has_property<G, boost::halfedge_index_t>::value, "");
  static_assert(CGAL::graph_has_property<G, boost::edge_index_t>::value, "");
  static_assert(CGAL::graph_has_property<G, boost::face_index_t>::value, "");
  static_assert(CGAL::graph_has_property<G, CGAL::vertex_point_t>::value, "");
  static_assert(CGAL::graph_has_property<G, boost::edge_weight_t>::value, "");
  static_assert(!CGAL::graph_has_property<G, boost::vertex_color_t>::value, "");
}

TYPED_TEST(Graph_model, models_the_concepts_of_cgal_and_boost)
{
  check_concepts<typename TestFixture::Mesh>();
  check_concepts<const typename TestFixture::Mesh>();
}

template <class D>
void check_descriptor(const std::string& name_of_third)
{
  static_assert(std::is_trivially_copyable<D>::value, "");
  static_assert(std::is_convertible<D, typename D::size_type>::value, "");
  static_assert(!std::is_convertible<typename D::size_type, D>::value, "");
  D d;
  EXPECT_FALSE(d.is_valid());
  const D third(3);
  EXPECT_TRUE(third.is_valid());
  EXPECT_EQ(std::size_t(third), 3u);
  EXPECT_EQ(third.idx(), third.id());
  EXPECT_TRUE(third < d);
  EXPECT_FALSE(d < third);
  EXPECT_TRUE(d == D());
  EXPECT_TRUE(D(D().idx()) == D());
  EXPECT_FALSE(D(D().idx()).is_valid());
  d = third;
  EXPECT_EQ(++d, D(4));
  EXPECT_EQ(d--, D(4));
  EXPECT_EQ(d++, third);
  EXPECT_EQ(--d, third);
  EXPECT_EQ(d += 5, D(8));
  EXPECT_EQ(d += -5, third);
  EXPECT_EQ(std::hash<D>()(d), std::hash<D>()(third));
  EXPECT_EQ(boost::hash<D>()(d), boost::hash<D>()(third));
  CGAL::Unique_hash_map<D, int> by_handle(0);
  by_handle[d] = 7;
  EXPECT_EQ(by_handle[third], 7);
  std::ostringstream out;
  out << third;
  EXPECT_EQ(out.str(), name_of_third);
  d.reset();
  EXPECT_EQ(d, D());
}

TYPED_TEST(Graph_model, descriptors_are_those_of_surface_mesh)
{
  using Mesh = typename TestFixture::Mesh;
  using V = typename TestFixture::V;
  using H = typename TestFixture::H;
  using E = typename TestFixture::E;
  using F = typename TestFixture::F;
  check_descriptor<V>("v3");
  check_descriptor<H>("h3");
  check_descriptor<E>(Mesh::Layout::edge_is_half_of_halfedge ? "e3 on h6" : "e3");
  check_descriptor<F>("f3");
  static_assert(!std::is_constructible<V, H>::value && !std::is_constructible<F, V>::value, "");
  static_assert(std::is_constructible<E, H>::value == Mesh::Layout::edge_is_half_of_halfedge, "");
  static_assert(sizeof(V) == sizeof(typename Mesh::size_type), "");
  static_assert(!Mesh::Layout::edge_is_half_of_halfedge || sizeof(E) == sizeof(H), "");

  const Mesh mesh(this->source);
  const H h(9);
  std::ostringstream out;
  out << mesh.edge(h);
  EXPECT_EQ(out.str(), "e" + std::to_string(mesh.edge(h).idx()) + " on h9");
}

TYPED_TEST(Graph_model, an_edge_remembers_its_halfedge)
{
  using Mesh = typename TestFixture::Mesh;
  const Mesh mesh(this->source);
  for (const auto h : halfedges(mesh)) {
    const auto e = edge(h, mesh), o = edge(opposite(h, mesh), mesh);
    ASSERT_EQ(halfedge(e, mesh), h);
    ASSERT_EQ(source(e, mesh), source(h, mesh));
    ASSERT_EQ(target(e, mesh), target(h, mesh));
    ASSERT_EQ(e, o);
    ASSERT_EQ(std::hash<typename TestFixture::E>()(e), std::hash<typename TestFixture::E>()(o));
  }
  for (const auto e : edges(mesh)) {
    ASSERT_EQ(edge(halfedge(e, mesh), mesh), e);
    ASSERT_EQ(mesh.halfedge(e, 1), mesh.opposite(mesh.halfedge(e, 0)));
  }
}

TYPED_TEST(Graph_model, is_valid_by_all_accounts)
{
  using Mesh = typename TestFixture::Mesh;
  const Mesh mesh(this->source);
  EXPECT_TRUE(mesh.is_valid());
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_TRUE(CGAL::is_triangle_mesh(mesh));
  EXPECT_EQ(num_vertices(mesh), this->source.number_of_vertices());
  EXPECT_EQ(num_halfedges(mesh), this->source.number_of_halfedges());
  EXPECT_EQ(num_edges(mesh), this->source.number_of_edges());
  EXPECT_EQ(num_faces(mesh), this->source.number_of_faces());
  EXPECT_FALSE(mesh.is_valid(typename TestFixture::V(mesh.num_vertices()), false));
  EXPECT_FALSE(mesh.is_valid(typename TestFixture::F(), false));
  EXPECT_TRUE(CGAL::is_valid_vertex_descriptor(*vertices(mesh).begin(), mesh));
  EXPECT_TRUE(CGAL::is_valid_halfedge_descriptor(*halfedges(mesh).begin(), mesh));
  EXPECT_TRUE(CGAL::is_valid_edge_descriptor(*edges(mesh).begin(), mesh));
  EXPECT_TRUE(CGAL::is_valid_face_descriptor(*faces(mesh).begin(), mesh));
  EXPECT_FALSE(CGAL::is_valid_vertex_descriptor(typename TestFixture::V(mesh.num_vertices()), mesh));
  EXPECT_FALSE(CGAL::is_valid_halfedge_descriptor(typename TestFixture::H(), mesh));
  EXPECT_FALSE(CGAL::is_valid_edge_descriptor(typename TestFixture::E(), mesh));
  EXPECT_FALSE(CGAL::is_valid_face_descriptor(typename TestFixture::F(mesh.num_faces() + 7), mesh));
}

// A layout of which one operator lies.
enum class Lie { next, opposite, source, face, halfedge_of_vertex, halfedge_of_face, edge, null_target };

template <Lie lie>
struct Lying_layout
  : public CGAL::Corner_table_layout<>
{
  using Base = CGAL::Corner_table_layout<>;
  using Base::Base;

  Index next(Index h) const { return lie == Lie::next ? Base::prev(h) : Base::next(h); }
  Index opposite(Index h) const { return lie == Lie::opposite ? Base::next(h) : Base::opposite(h); }
  Index source(Index h) const { return lie == Lie::source ? Base::target(h) : Base::source(h); }
  Index target(Index h) const { return lie == Lie::null_target ? null_index() : Base::target(h); }
  Index face(Index h) const { return lie == Lie::face ? h % Index(num_faces()) : Base::face(h); }
  Index edge(Index h) const { return lie == Lie::edge ? h : Base::edge(h); }
  Index halfedge_of_vertex(Index v) const
  {
    return lie == Lie::halfedge_of_vertex ? Base::next(Base::halfedge_of_vertex(v)) : Base::halfedge_of_vertex(v);
  }
  Index halfedge_of_face(Index f) const { return Base::halfedge_of_face(lie == Lie::halfedge_of_face ? 0 : f); }
};

template <Lie lie>
bool is_caught()
{
  return !CGAL::Compact_surface_mesh<Point, Lying_layout<lie> >(test::bumpy_sphere(0)).is_valid(false);
}

TEST(Validity, finds_operators_that_contradict_each_other)
{
  EXPECT_TRUE(is_caught<Lie::next>());
  EXPECT_TRUE(is_caught<Lie::opposite>());
  EXPECT_TRUE(is_caught<Lie::source>());
  EXPECT_TRUE(is_caught<Lie::null_target>());
  EXPECT_TRUE(is_caught<Lie::face>());
  EXPECT_TRUE(is_caught<Lie::edge>());
  EXPECT_TRUE(is_caught<Lie::halfedge_of_vertex>());
  EXPECT_TRUE(is_caught<Lie::halfedge_of_face>());
}

// Ranges count from 0, and go both ways.
template <class Range>
void check_range(const Range& range, std::size_t n)
{
  using Iterator = typename Range::iterator;
  static_assert(std::is_same<typename std::iterator_traits<Iterator>::iterator_category,
                             std::random_access_iterator_tag>::value, "");
  ASSERT_EQ(range.size(), n);
  std::size_t i = 0;
  for (const auto d : range)
    ASSERT_EQ(d.idx(), i++);
  for (std::reverse_iterator<Iterator> it(range.end()), end(range.begin()); it != end; ++it)
    ASSERT_EQ((*it).idx(), --i);
  ASSERT_EQ(range.begin()[n - 1].idx(), n - 1);
  ASSERT_EQ(range.end() - range.begin(), std::ptrdiff_t(n));
}

TYPED_TEST(Graph_model, ranges_are_contiguous)
{
  const typename TestFixture::Mesh mesh(this->source);
  check_range(vertices(mesh), num_vertices(mesh));
  check_range(halfedges(mesh), num_halfedges(mesh));
  check_range(edges(mesh), num_edges(mesh));
  check_range(faces(mesh), num_faces(mesh));
  for (const auto f : faces(mesh))
    EXPECT_EQ(get(boost::face_index, mesh, f), f.idx());
}

TYPED_TEST(Graph_model, stars_agree_however_they_are_walked)
{
  using V = typename TestFixture::V;
  const typename TestFixture::Mesh mesh(this->source);
  for (const V v : vertices(mesh)) {
    std::multiset<V> adjacent, visited, out, in;
    for (const V u : adjacent_vertices(v, mesh))
      adjacent.insert(u);
    mesh.for_each_adjacent_vertex(v, [&](V u) { visited.insert(u); });
    for (const auto e : out_edges(v, mesh)) {
      ASSERT_EQ(source(e, mesh), v);
      out.insert(target(e, mesh));
    }
    for (const auto e : in_edges(v, mesh)) {
      ASSERT_EQ(target(e, mesh), v);
      in.insert(source(e, mesh));
    }
    ASSERT_EQ(adjacent.size(), degree(v, mesh));
    ASSERT_EQ(adjacent, visited);
    ASSERT_EQ(adjacent, out);
    ASSERT_EQ(adjacent, in);
    std::size_t num_triangles = 0;
    mesh.for_each_incident_triangle(v, [&](V u, V w) {
      ++num_triangles;
      EXPECT_EQ(mesh.next(mesh.halfedge(v, u)), mesh.halfedge(u, w));
    });
    ASSERT_EQ(num_triangles, degree(v, mesh));
    EXPECT_FALSE(mesh.is_border(v));
    EXPECT_FALSE(static_cast<bool>(is_border(v, mesh)));
  }
  for (const auto f : mesh.faces()) {
    const auto corners = mesh.vertices_of_face(f);
    const auto range = mesh.vertices_around_face(mesh.halfedge(f));
    ASSERT_TRUE(std::equal(range.begin(), range.end(), corners.begin()));
    ASSERT_EQ(degree(f, mesh), 3u);
  }
  auto face = mesh.faces().begin();
  mesh.for_each_face([&](typename TestFixture::F f, V u, V v, V w) {
    ASSERT_NE(face, mesh.faces().end());
    EXPECT_EQ(f, *face);
    EXPECT_EQ(mesh.vertices_of_face(f), (std::array<V, 3>{u, v, w}));
    ++face;
  });
  EXPECT_EQ(face, mesh.faces().end());
}

template <class GraphOfMap, class Mesh>
void check_maps_of_faces(const Mesh& mesh)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Pair = std::pair<typename Mesh::Face_index, const GraphOfMap*>;
  const CGAL::Triangle_from_face_descriptor_map<GraphOfMap> triangle(&mesh), made_with_points(&mesh, mesh.points());
  const CGAL::One_point_from_face_descriptor_map<GraphOfMap> point(&mesh);
  for (const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    const Kernel::Triangle_3 expected(mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h))),
                                      mesh.point(mesh.source(h)));
    for (int i = 0; i < 3; ++i) { // triangles are equal in any rotation
      ASSERT_EQ(get(triangle, f)[i], expected[i]);
      ASSERT_EQ(get(made_with_points, Pair(f, &mesh))[i], expected[i]);
    }
    ASSERT_EQ(get(point, f), expected[0]);
    ASSERT_EQ(get(point, Pair(f, &mesh)), expected[0]);
  }
}

TYPED_TEST(Graph_model, faces_have_the_triangles_and_points_that_trees_ask_for)
{
  using Mesh = typename TestFixture::Mesh;
  const Mesh mesh(this->source);
  check_maps_of_faces<Mesh>(mesh);
  check_maps_of_faces<const Mesh>(mesh);
}

TYPED_TEST(Graph_model, points_follow_their_vertices)
{
  using Mesh = typename TestFixture::Mesh;
  std::map<Surface_mesh::Vertex_index, typename TestFixture::V> image;
  Mesh mesh(this->source, parameters::vertex_to_vertex_map(boost::make_assoc_property_map(image)));
  ASSERT_EQ(image.size(), mesh.num_vertices());
  for (const auto& pair : image)
    EXPECT_EQ(mesh.point(pair.second), this->source.point(pair.first));
  mesh.point(typename TestFixture::V(0)) = Point(1, 2, 3);
  EXPECT_EQ(get(CGAL::vertex_point, mesh, *vertices(mesh).begin()), Point(1, 2, 3));
  put(CGAL::vertex_point, mesh, typename TestFixture::V(0), Point(3, 2, 1));
  EXPECT_EQ(*mesh.points().begin(), Point(3, 2, 1));
  EXPECT_EQ(mesh.template property_type<typename TestFixture::V>("v:point"), typeid(Point));
}

TYPED_TEST(Graph_model, algorithms_agree_with_surface_mesh)
{
  using Mesh = typename TestFixture::Mesh;
  std::vector<std::pair<Surface_mesh::Vertex_index, typename TestFixture::V> > vertex_pairs;
  const Mesh mesh(this->source, parameters::vertex_to_vertex_output_iterator(std::back_inserter(vertex_pairs)));
  EXPECT_NEAR(PMP::area(mesh), PMP::area(this->source), 1e-12 * PMP::area(this->source));
  EXPECT_NEAR(PMP::volume(mesh), PMP::volume(this->source), 1e-12 * PMP::volume(this->source));
  for (const auto& pair : vertex_pairs) {
    const auto difference = PMP::compute_vertex_normal(pair.second, mesh)
                          - PMP::compute_vertex_normal(pair.first, this->source);
    ASSERT_LT(difference.squared_length(), 1e-24);
  }

  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
  using Source_primitive = CGAL::AABB_face_graph_triangle_primitive<Surface_mesh>;
  CGAL::AABB_tree<example::AABB_traits_3<Kernel, Primitive> > tree(faces(mesh).first, faces(mesh).second, mesh);
  CGAL::AABB_tree<example::AABB_traits_3<Kernel, Source_primitive> > source_tree(
      faces(this->source).first, faces(this->source).second, this->source);
  for (int i = 0; i < 20; ++i) {
    const Point query(std::cos(i), std::sin(3 * i), std::sin(5 * i));
    const double expected = source_tree.squared_distance(query);
    EXPECT_NEAR(tree.squared_distance(query), expected, 1e-12 * expected); // faces start at other vertices
  }
}

// The distances from `start` in edges and along edges, by vertex index.
template <class Graph>
std::vector<int> breadth_first_distances(const Graph& g, typename boost::graph_traits<Graph>::vertex_descriptor start)
{
  std::vector<int> distance(num_vertices(g), 0);
  const auto map = boost::make_iterator_property_map(distance.begin(), get(boost::vertex_index, g));
  boost::breadth_first_search(
      g, start, boost::visitor(boost::make_bfs_visitor(boost::record_distances(map, boost::on_tree_edge()))));
  return distance;
}

template <class Graph>
std::vector<double> shortest_distances(const Graph& g, typename boost::graph_traits<Graph>::vertex_descriptor start)
{
  std::vector<double> distance(num_vertices(g));
  boost::dijkstra_shortest_paths(
      g, start,
      boost::distance_map(boost::make_iterator_property_map(distance.begin(), get(boost::vertex_index, g))));
  return distance;
}

TYPED_TEST(Graph_model, boost_searches_agree_up_to_the_permutation)
{
  using Mesh = typename TestFixture::Mesh;
  using V = typename TestFixture::V;
  std::vector<V> image(this->source.number_of_vertices());
  const Mesh mesh(this->source, parameters::vertex_to_vertex_map(
      boost::make_iterator_property_map(image.begin(), get(boost::vertex_index, this->source))));
  const Surface_mesh::Vertex_index start(5);
  const auto steps = breadth_first_distances(mesh, image[start]);
  const auto source_steps = breadth_first_distances(this->source, start);
  const auto lengths = shortest_distances(mesh, image[start]);
  const auto source_lengths = shortest_distances(this->source, start);
  for (const auto v : vertices(this->source)) {
    ASSERT_EQ(steps[image[v]], source_steps[v]);
    ASSERT_DOUBLE_EQ(lengths[image[v]], source_lengths[v]);
  }
}

TYPED_TEST(Graph_model, is_planar_by_boyer_and_myrvold)
{
  const typename TestFixture::Mesh mesh(this->source);
  EXPECT_TRUE(boost::boyer_myrvold_planarity_test(mesh));
}

TYPED_TEST(Graph_model, keeps_property_maps_like_surface_mesh)
{
  using Mesh = typename TestFixture::Mesh;
  using V = typename TestFixture::V;
  using F = typename TestFixture::F;
  Mesh mesh(this->source);
  const auto added = mesh.template add_property_map<V, std::string>("v:name", "none");
  EXPECT_TRUE(added.second);
  EXPECT_FALSE((mesh.template add_property_map<V, std::string>("v:name").second));
  auto names = added.first;
  names[V(2)] = "two";
  EXPECT_EQ((mesh.template find_property_map<V, std::string>("v:name")[V(2)]), "two");
  EXPECT_EQ(get(names, V(1)), "none");
  EXPECT_FALSE(bool(mesh.template find_property_map<V, int>("v:name")));
  auto anonymous = mesh.template add_property_map<F, int>().first;
  EXPECT_EQ(mesh.template properties<F>().size(), 1u);
  mesh.remove_property_map(anonymous);
  EXPECT_FALSE(bool(anonymous));
  EXPECT_EQ(mesh.template properties<F>().size(), 0u);
  std::ostringstream stats;
  mesh.property_stats(stats);
  EXPECT_EQ(stats.str(), "vertex properties:\n\tv:point\n\tv:name\nhalfedge properties:\n"
                         "edge properties:\nface properties:\n");
  mesh.remove_all_property_maps();
  EXPECT_EQ(mesh.template properties<V>(), std::vector<std::string>(1, "v:point"));
}

TYPED_TEST(Graph_model, dynamic_maps_leave_the_mesh_alone)
{
  using Mesh = typename TestFixture::Mesh;
  using E = typename TestFixture::E;
  Mesh mesh(this->source);
  auto map = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
  static_assert(std::is_same<decltype(map), decltype(get(CGAL::dynamic_edge_property_t<bool>(),
                                                         static_cast<const Mesh&>(mesh)))>::value, "");
  const auto copy = map;
  for (const auto h : halfedges(mesh))
    EXPECT_FALSE(get(map, edge(h, mesh)));
  put(map, E(1), true);
  EXPECT_TRUE(get(copy, edge(mesh.halfedge(E(1), 1), mesh)));
  get(copy, E(2)) = true;
  EXPECT_TRUE(map[E(2)]);
  EXPECT_EQ(get(get(CGAL::dynamic_vertex_property_t<int>(), mesh, 7), *vertices(mesh).begin()), 7);
  get(CGAL::dynamic_halfedge_property_t<int>(), mesh);
  get(CGAL::dynamic_face_property_t<std::string>(), mesh);
  EXPECT_TRUE(mesh.template properties<E>().empty());
}

TYPED_TEST(Graph_model, offers_the_named_maps_of_mesh_3)
{
  using Mesh = typename TestFixture::Mesh;
  using E = typename TestFixture::E;
  Mesh mesh(this->source);
  const Mesh& constant = mesh;
  EXPECT_FALSE(bool(get(CGAL::edge_is_feature, constant)));
  auto feature = get(CGAL::edge_is_feature, mesh);
  put(feature, E(1), true);
  EXPECT_TRUE(get(get(CGAL::edge_is_feature, constant), E(1)));
  EXPECT_EQ(mesh.template properties<E>(), std::vector<std::string>(1, "e:is_feature"));
  EXPECT_EQ(get(get(CGAL::face_patch_id_t<int>(), mesh), *faces(mesh).begin()), 1);
  EXPECT_EQ(get(get(CGAL::face_patch_id_t<void>(), constant), *faces(mesh).begin()).second, 1);
  get(CGAL::vertex_incident_patches_t<int>(), mesh);
  get(CGAL::vertex_time_stamp, mesh);
}

} // namespace
