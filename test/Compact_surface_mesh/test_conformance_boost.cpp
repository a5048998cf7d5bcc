// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The algorithms of Boost.Graph, on both meshes of each pair.

#include "conformance_answers.h"

#include <CGAL/boost/graph/alpha_expansion_graphcut.h>
#include <CGAL/boost/graph/Dual.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/split_graph_into_polylines.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/astar_search.hpp>
#include <boost/graph/bellman_ford_shortest_paths.hpp>
#include <boost/graph/betweenness_centrality.hpp>
#include <boost/graph/biconnected_components.hpp>
#include <boost/graph/boyer_myrvold_planar_test.hpp>
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/copy.hpp>
#include <boost/graph/core_numbers.hpp>
#include <boost/graph/depth_first_search.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/edge_coloring.hpp>
#include <boost/graph/edmonds_karp_max_flow.hpp>
#include <boost/graph/filtered_graph.hpp>
#include <boost/graph/isomorphism.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>
#include <boost/graph/prim_minimum_spanning_tree.hpp>
#include <boost/graph/push_relabel_max_flow.hpp>
#include <boost/graph/sequential_vertex_coloring.hpp>
#include <boost/graph/undirected_dfs.hpp>
#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using test::all_pairs;
using test::Answer;
using test::expect_same_answer;
using test::expect_same_answers;
using test::Mesh_of;

constexpr std::size_t start_name = 7;

/// Values by vertices or edges of a mesh.
template <class T, class IndexMap>
class Indexed
{
public:
  Indexed(std::size_t n, IndexMap index, const T& value = T()) : m_values(n, value), m_index(index) {}

  auto map() { return boost::make_iterator_property_map(m_values.begin(), m_index); }
  template <class Element> const T& operator[](const Element& e) const { return m_values[get(m_index, e)]; }
  const std::vector<T>& values() const { return m_values; }

private:
  std::vector<T> m_values;
  IndexMap m_index;
};

template <class T, class Mesh>
auto by_vertex(const Mesh& mesh, const T& value = T())
{
  const auto index = get(boost::vertex_index, mesh);
  return Indexed<T, std::decay_t<decltype(index)>>(num_vertices(mesh), index, value);
}

template <class T, class Mesh>
auto by_edge(const Mesh& mesh, const T& value = T())
{
  const auto index = get(boost::edge_index, mesh);
  return Indexed<T, std::decay_t<decltype(index)>>(num_edges(mesh), index, value);
}

TEST(Conformance_boost, breadth_first_search)
{
  expect_same_answers(all_pairs(), [](const auto& m) {
    auto steps = by_vertex<int>(m.mesh);
    boost::breadth_first_search(m.mesh, m.vertex(start_name),
                                boost::visitor(boost::make_bfs_visitor(
                                  boost::record_distances(steps.map(), boost::on_tree_edge()))));
    return Answer().on(m.vertices(), [&](auto v) { return steps[v]; });
  });
}

/// Tells what a search finds, in its order.
template <class Named>
struct Telling_visitor
  : public boost::default_dfs_visitor
{
  Telling_visitor(const Named& named, Answer& a) : m(&named), answer(&a) {}

  template <class E, class G> void tree_edge(const E& e, const G& g) { *answer << 0 << m->name(target(e, g)); }
  template <class E, class G> void back_edge(const E& e, const G& g) { *answer << 1 << m->name(target(e, g)); }
  template <class V, class G> void start_vertex(const V& v, const G&) { *answer << 2 << m->name(v); }
  template <class V, class G> void discover_vertex(const V& v, const G&) { *answer << 3 << m->name(v); }
  template <class V, class G> void finish_vertex(const V& v, const G&) { *answer << 4 << m->name(v); }

  const Named* m;
  Answer* answer;
};

TEST(Conformance_boost, depth_first_searches)
{
  test::expect_same_answers_in_same_order(all_pairs(), [](const auto& m) {
    Answer answer;
    const Telling_visitor<std::decay_t<decltype(m)>> visitor(m, answer);
    auto vertex_color = by_vertex<boost::default_color_type>(m.mesh);
    boost::depth_first_search(m.mesh, visitor, vertex_color.map(), m.vertex(start_name));
    vertex_color = by_vertex<boost::default_color_type>(m.mesh);
    auto edge_color = by_edge<boost::default_color_type>(m.mesh);
    boost::undirected_dfs(m.mesh, visitor, vertex_color.map(), edge_color.map(), m.vertex(start_name));
    return answer;
  });
}

/// Distances and the predecessors on the shortest paths, which have all lengths different.
template <class Named, class Distance, class Predecessor>
Answer shortest_paths(const Named& m, const Distance& distance, const Predecessor& predecessor)
{
  Answer answer;
  answer.on(m.vertices(), [&](auto v) { return distance[v]; });
  answer.on(m.vertices(), [&](auto v) { return m.name(predecessor[v]); });
  return answer;
}

TEST(Conformance_boost, dijkstra)
{
  expect_same_answers(all_pairs(), [](const auto& m) {
    auto distance = by_vertex<double>(m.mesh);
    auto predecessor = by_vertex(m.mesh, m.vertex(start_name));
    boost::dijkstra_shortest_paths(m.mesh, m.vertex(start_name),
                                   boost::distance_map(distance.map()).predecessor_map(predecessor.map()));
    return shortest_paths(m, distance, predecessor);
  });
}

TEST(Conformance_boost, bellman_ford)
{
  expect_same_answers(all_pairs(), [](const auto& m) {
    auto distance = by_vertex<double>(m.mesh);
    auto predecessor = by_vertex(m.mesh, m.vertex(start_name));
    EXPECT_TRUE(boost::bellman_ford_shortest_paths(m.mesh, boost::root_vertex(m.vertex(start_name))
                                                             .distance_map(distance.map())
                                                             .predecessor_map(predecessor.map())));
    return shortest_paths(m, distance, predecessor);
  });
}

/// The distance to a goal as the crow flies.
template <class Named>
struct Flight_distance
  : public boost::astar_heuristic<Mesh_of<Named>, double>
{
  Flight_distance(const Named& named, typename Named::Vertex g) : m(&named), goal(g) {}

  double operator()(typename Named::Vertex v) const
  {
    return std::sqrt(CGAL::squared_distance(m->point(v), m->point(goal)));
  }

  const Named* m;
  typename Named::Vertex goal;
};

TEST(Conformance_boost, astar)
{
  expect_same_answers(test::connected_triangle_pairs(), [](const auto& m) {
    typedef std::decay_t<decltype(m)> Named;
    auto distance = by_vertex<double>(m.mesh);
    auto predecessor = by_vertex(m.mesh, m.vertex(start_name));
    boost::astar_search(m.mesh, m.vertex(start_name), Flight_distance<Named>(m, m.vertex(100)),
                        boost::visitor(boost::default_astar_visitor())
                          .distance_map(distance.map())
                          .predecessor_map(predecessor.map()));
    return shortest_paths(m, distance, predecessor);
  });
}

TEST(Conformance_boost, spanning_trees)
{
  expect_same_answers(all_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    std::vector<typename Mesh::Edge_index> tree;
    boost::kruskal_minimum_spanning_tree(m.mesh, std::back_inserter(tree));
    return Answer() << m.names(tree);
  });
  expect_same_answers(test::connected_triangle_pairs(), [](const auto& m) {
    auto predecessor = by_vertex(m.mesh, m.vertex(start_name));
    boost::prim_minimum_spanning_tree(m.mesh, predecessor.map(), boost::root_vertex(m.vertex(start_name)));
    return Answer().on(m.vertices(), [&](auto v) { return m.name(predecessor[v]); });
  });
}

TEST(Conformance_boost, components)
{
  expect_same_answers(all_pairs(), [](const auto& m) {
    Answer answer;
    auto component = by_vertex<int>(m.mesh);
    answer << boost::connected_components(m.mesh, component.map());
    answer.partition(m.vertices(), [&](auto v) { return component[v]; });

    typedef Mesh_of<decltype(m)> Mesh;
    auto block = by_edge<std::size_t>(m.mesh);
    std::vector<typename Mesh::Vertex_index> articulations;
    answer << boost::biconnected_components(m.mesh, block.map(), std::back_inserter(articulations)).first
           << m.names(articulations);
    answer.partition(m.edges(), [&](auto e) { return block[e]; });
    return answer;
  });
}

TEST(Conformance_boost, components_of_filtered_meshes)
{
  // what is left of the edges is a graph with bridges and articulations
  expect_same_answers(all_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    typedef typename Mesh::Edge_index Edge;
    typedef std::function<bool(Edge)> Edge_filter;
    const boost::filtered_graph<Mesh, Edge_filter> graph(
      m.mesh, Edge_filter([&m](Edge e) { return m.name(e) * 7919 % 100 < 60; }));
    const auto index = get(boost::vertex_index, m.mesh);
    auto component = by_vertex<int>(m.mesh);
    auto block = by_edge<std::size_t>(m.mesh, m.none);
    std::vector<typename Mesh::Vertex_index> articulations;
    Answer answer;
    answer << boost::connected_components(graph, component.map(), boost::vertex_index_map(index));
    answer.partition(m.vertices(), [&](auto v) { return component[v]; });
    answer << boost::biconnected_components(graph, block.map(), std::back_inserter(articulations),
                                            boost::vertex_index_map(index)).first
           << m.names(articulations);
    answer.partition(m.edges(), [&](auto e) { return block[e]; });
    return answer;
  });
}

TEST(Conformance_boost, core_numbers)
{
  expect_same_answers(all_pairs(), [](const auto& m) {
    auto core = by_vertex<int>(m.mesh);
    boost::core_numbers(m.mesh, core.map());
    return Answer().on(m.vertices(), [&](auto v) { return core[v]; });
  });
}

TEST(Conformance_boost, betweenness)
{
  expect_same_answers({&test::sphere_pair(), &test::borders_pair()}, [](const auto& m) { // slow
    auto vertex_centrality = by_vertex<double>(m.mesh);
    auto edge_centrality = by_edge<double>(m.mesh);
    boost::brandes_betweenness_centrality(
      m.mesh, boost::centrality_map(vertex_centrality.map())
                .edge_centrality_map(edge_centrality.map())
                .vertex_index_map(get(boost::vertex_index, m.mesh))
                .weight_map(get(boost::edge_weight, m.mesh)));
    Answer answer;
    answer.on(m.vertices(), [&](auto v) { return vertex_centrality[v]; });
    answer.on(m.edges(), [&](auto e) { return edge_centrality[e]; });
    return answer;
  });
}

TEST(Conformance_boost, colorings)
{
  // greedy colors in the order of names depend on adjacency alone
  expect_same_answers(all_pairs(), [](const auto& m) {
    auto color = by_vertex<std::size_t>(m.mesh);
    Answer answer;
    answer << boost::sequential_vertex_coloring(
      m.mesh, boost::make_iterator_property_map(m.vertices().begin(),
                                                boost::typed_identity_property_map<std::size_t>()),
      color.map());
    return answer.on(m.vertices(), [&](auto v) { return color[v]; });
  });
  test::expect_same_answers_in_same_order(all_pairs(), [](const auto& m) {
    auto color = by_edge<std::size_t>(m.mesh);
    Answer answer;
    answer << boost::edge_coloring(m.mesh, color.map());
    for (const auto v : vertices(m.mesh)) {
      std::set<std::size_t> colors;
      for (const auto e : out_edges(v, m.mesh))
        colors.insert(color[e]);
      EXPECT_EQ(colors.size(), degree(v, m.mesh));
    }
    return answer.on(m.edges(), [&](auto e) { return color[e]; });
  });
}

typedef boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS,
                              boost::property<boost::vertex_index_t, std::size_t>> Adjacency_list;

template <class Named>
Adjacency_list adjacency_list_of(const Named& m)
{
  Adjacency_list graph(num_vertices(m.mesh));
  for (const auto e : m.edges())
    add_edge(m.name(source(e, m.mesh)), m.name(target(e, m.mesh)), graph);
  return graph;
}

// Surface_mesh does not compile with this algorithm: its descriptors make make_tuple ambiguous.
TEST(Conformance_boost, planarity_by_boyer_and_myrvold)
{
  for (const auto* pair : all_pairs())
    EXPECT_EQ(boost::boyer_myrvold_planarity_test(pair->compact.mesh),
              boost::boyer_myrvold_planarity_test(adjacency_list_of(pair->expected))) << pair->name;
  EXPECT_FALSE(boost::boyer_myrvold_planarity_test(test::genus_3_pair().compact.mesh));
}

TEST(Conformance_boost, copies_and_isomorphism)
{
  expect_same_answers(all_pairs(), [](const auto& m) {
    Adjacency_list copy;
    boost::copy_graph(m.mesh, copy,
                      boost::vertex_copy([](const auto&, const auto&) {}).edge_copy([](const auto&, const auto&) {}));
    std::multiset<std::size_t> degrees;
    for (const auto v : boost::make_iterator_range(vertices(copy)))
      degrees.insert(out_degree(v, copy));
    return Answer() << num_vertices(copy) << num_edges(copy) << degrees;
  });
  const test::Mesh_pair small("a small sphere", test::bumpy_sphere(0));
  const auto& mesh = small.compact.mesh;
  const auto& other = small.expected.mesh;
  EXPECT_TRUE(boost::isomorphism(mesh, other, boost::vertex_index1_map(get(boost::vertex_index, mesh))
                                                .vertex_index2_map(get(boost::vertex_index, other))));
  test::Surface_mesh flipped = other;
  CGAL::Euler::flip_edge(*halfedges(flipped).begin(), flipped);
  EXPECT_FALSE(boost::isomorphism(mesh, flipped, boost::vertex_index1_map(get(boost::vertex_index, mesh))
                                                   .vertex_index2_map(get(boost::vertex_index, flipped))));
}

/// Values at halfedges, the arcs of a network, by the edges that remember them.
template <class Mesh, class T>
struct Arc_map
{
  typedef typename Mesh::Edge_index key_type;
  typedef T value_type;
  typedef T& reference;
  typedef boost::lvalue_property_map_tag category;

  Arc_map() = default;
  explicit Arc_map(const Mesh& g) : mesh(&g), values(get(CGAL::dynamic_halfedge_property_t<T>(), g)) {}

  friend reference get(const Arc_map& map, const key_type& e)
  {
    return const_cast<reference>(get(map.values, halfedge(e, *map.mesh)));
  }
  friend void put(const Arc_map& map, const key_type& e, const T& value)
  {
    put(map.values, halfedge(e, *map.mesh), value);
  }
  reference operator[](const key_type& e) const { return get(*this, e); }

  const Mesh* mesh = nullptr;
  typename boost::property_map<Mesh, CGAL::dynamic_halfedge_property_t<T>>::const_type values;
};

// Kolmogorov's algorithm is not among them: it looks at each edge in one direction only.
TEST(Conformance_boost, maximum_flow)
{
  expect_same_answers(test::connected_triangle_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    typedef typename Mesh::Edge_index Edge;
    const Mesh& mesh = m.mesh;
    Arc_map<Mesh, long> capacity(mesh), residual(mesh);
    Arc_map<Mesh, Edge> reverse(mesh);
    for (const auto h : halfedges(mesh)) {
      put(capacity, edge(h, mesh), long(1 + m.name(edge(h, mesh)) * 7919 % 50));
      put(reverse, edge(h, mesh), edge(opposite(h, mesh), mesh));
    }
    auto color = by_vertex<boost::default_color_type>(mesh);
    auto predecessor = by_vertex<Edge>(mesh);
    const auto s = m.vertex(0), t = m.vertex(130);
    const long flow = boost::edmonds_karp_max_flow(mesh, s, t, capacity, residual, reverse, color.map(),
                                                   predecessor.map());
    if (CGAL::is_closed(mesh)) { // on the disk, it fails an assertion of its own for Surface_mesh, too
      EXPECT_EQ(boost::push_relabel_max_flow(mesh, s, t, capacity, residual, reverse, get(boost::vertex_index, mesh)),
                flow);
    }
    return Answer() << flow;
  });
}

TEST(Conformance_boost, dual)
{
  expect_same_answers(all_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    const CGAL::Dual<Mesh> dual(m.mesh);
    const auto index = get(boost::face_index, m.mesh);
    std::vector<int> steps(num_faces(m.mesh), -1);
    Answer answer;
    answer << num_vertices(dual) << num_edges(dual) << num_faces(dual);
    if (CGAL::is_closed(m.mesh)) {
      steps[get(index, m.face_of(0))] = 0;
      boost::breadth_first_search(
        dual, m.face_of(0),
        boost::visitor(boost::make_bfs_visitor(boost::record_distances(
                         boost::make_iterator_property_map(steps.begin(), index), boost::on_tree_edge())))
          .vertex_index_map(index));
      answer.on(m.faces(), [&](auto f) { return steps[get(index, f)]; });
    }
    return answer;
  });
}

TEST(Conformance_boost, parts_of_meshes)
{
  expect_same_answers(all_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    const std::vector<typename Mesh::Face_index> part(m.faces().begin(), m.faces().begin() + 40);
    const CGAL::Face_filtered_graph<Mesh> graph(m.mesh, part);
    Answer answer;
    answer << graph.number_of_vertices() << graph.number_of_halfedges() << graph.number_of_faces()
           << CGAL::is_valid_polygon_mesh(graph) << graph.is_selection_valid();
    answer << m.names(vertices(graph)) << m.names(halfedges(graph)) << m.names(edges(graph)) << m.names(faces(graph));
    for (const auto h : m.halfedges())
      if (graph.is_in_cc(h))
        answer << m.name(next(h, graph)) << m.name(prev(h, graph)) << m.name(face(h, graph));
    return answer;
  });
}

/// Collects polylines of names.
template <class Named>
struct Polyline_visitor
{
  void start_new_polyline() { polylines.emplace_back(); }
  void add_node(typename Named::Vertex v) { polylines.back().push_back(m.name(v)); }
  void end_polyline()
  {
    if (polylines.back().front() > polylines.back().back())
      std::reverse(polylines.back().begin(), polylines.back().end());
  }

  const Named& m;
  std::vector<std::vector<std::size_t>>& polylines;
};

TEST(Conformance_boost, border_edges_as_polylines)
{
  expect_same_answers({&test::borders_pair(), &test::disk_pair(), &test::components_pair()}, [](const auto& m) {
    typedef std::decay_t<decltype(m)> Named;
    typedef Mesh_of<Named> Mesh;
    typedef std::function<bool(typename Mesh::Edge_index)> Edge_filter;
    typedef std::function<bool(typename Mesh::Vertex_index)> Vertex_filter;
    const boost::filtered_graph<Mesh, Edge_filter, Vertex_filter> border(
      m.mesh, [&m](auto e) { return CGAL::is_border(e, m.mesh); },
      [&m](auto v) { return bool(CGAL::is_border(v, m.mesh)); });
    std::vector<std::vector<std::size_t>> polylines;
    Polyline_visitor<Named> visitor{m, polylines};
    CGAL::split_graph_into_polylines(border, visitor,
                                     [&m](auto v, const auto&) { return m.name(v) % 4 == 0; });
    std::set<std::vector<std::size_t>> open; // where closed ones start depends on the order
    std::multiset<std::size_t> lengths;
    for (const auto& polyline : polylines) {
      lengths.insert(polyline.size());
      if (polyline.front() != polyline.back())
        open.insert(polyline);
    }
    return Answer() << lengths << open;
  });
}

TEST(Conformance_boost, alpha_expansion)
{
  expect_same_answers(all_pairs(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    const Mesh& mesh = m.mesh;
    // two labels by height, smooth along short edges: one cut, unique in generic position
    const auto cost = get(CGAL::dynamic_vertex_property_t<std::vector<double>>(), mesh);
    const auto label = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
    for (const auto v : vertices(mesh)) {
      put(cost, v, std::vector<double>{std::abs(m.point(v).z() - 0.1), std::abs(m.point(v).z() - 0.7)});
      put(label, v, m.point(v).z() < 0.4 ? 0 : 1);
    }
    const auto length = get(boost::edge_weight, mesh);
    Answer answer;
    answer << CGAL::alpha_expansion_graphcut(mesh, length, cost, label,
                                             CGAL::parameters::vertex_index_map(get(boost::vertex_index, mesh)));
    answer.on(m.vertices(), [&](auto v) { return get(label, v); });
    return answer;
  });
}

} // namespace
