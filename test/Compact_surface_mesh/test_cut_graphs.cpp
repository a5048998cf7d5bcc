// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Cut graphs: a mesh cut along one is a disk, it is short, and its loops are what they should be.

#include "closed_surfaces.h"
#include "cut_graph_oracle.h"
#include "generated_surfaces.h"
#include "shelling_orders.h"
#include "test_scale.h"

#include <CGAL/Compact_surface_mesh.h>
#include <CGAL/Schnyder_woods/cut_graph.h>
#include <CGAL/Schnyder_woods/cut_graph_loops.h>
#include <CGAL/Schnyder_woods/g_schnyder_wood.h>

#include <CGAL/Curves_on_surface_topology.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/Path_on_surface.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>> Polyhedron;
typedef test::Surface_mesh Surface_mesh;
typedef test::Vertex Vertex;
typedef test::Halfedge Halfedge;
typedef test::Edge Edge;
typedef test::Face Face;
typedef test::Cut Cut;
using test::mesh_of;

namespace parameters = CGAL::parameters;

template <class NamedParameters>
void expect_cut_graph(Cut& cut, const NamedParameters& np)
{
  const double weight = cut.compute(np);
  EXPECT_NEAR(weight, cut.length(), 1e-9 * (1 + weight));
  EXPECT_EQ(cut.defect(), "");
  EXPECT_EQ(cut.defect_of_loops(), "");
}

void expect_cut_graph(Surface_mesh mesh, unsigned int num_bases = 2)
{
  Cut cut(mesh);
  expect_cut_graph(cut, parameters::number_of_iterations(num_bases).vertex_is_constrained_map(cut.is_constrained));
}

TEST(Cut_graphs, cut_surfaces_of_all_kinds)
{
  for (unsigned int seed = 0; seed < test::scaled(3000); ++seed) {
    SCOPED_TRACE("random_surface " + std::to_string(seed));
    Surface_mesh mesh = mesh_of(test::random_surface(seed), seed);
    Cut cut(mesh);
    std::mt19937 rng(seed);
    const unsigned int percentage = std::array<unsigned int, 4>{ 0, 0, 5, 100 }[seed % 4];
    for (const Vertex v : mesh.vertices())
      cut.is_constrained[v] = rng() % 100 < percentage;
    expect_cut_graph(cut, parameters::number_of_iterations(1 + seed % 3)
                              .random_seed(seed)
                              .vertex_is_constrained_map(cut.is_constrained));
    if (HasFailure())
      break;
  }
}

TEST(Cut_graphs, cut_closed_surfaces_of_any_genus)
{
  for (const std::uint32_t genus : { 0, 1, 2, 3, 10, 50, 200 })
    for (unsigned int seed = 0; seed < test::scaled(20); ++seed) {
      SCOPED_TRACE("genus " + std::to_string(genus) + ", seed " + std::to_string(seed));
      expect_cut_graph(mesh_of(test::closed_surface(genus, 4 * genus + 4 + 20 * seed, seed), seed));
    }
  expect_cut_graph(mesh_of(test::torus_grid(3, 5)));
  expect_cut_graph(mesh_of(test::torus_grid(30, 50)));
  expect_cut_graph(mesh_of(test::chain_of_tori(100)));
  expect_cut_graph(mesh_of(test::sphere_with_far_handles(2000, 20)));
  expect_cut_graph(mesh_of(test::scaffold(3, 1)));
}

// Whether `num_edges` edges of a torus can be a cut graph, by trying all sets.
bool has_cut_graph_of_size(Surface_mesh mesh, std::size_t num_edges)
{
  const Cut cut(mesh);
  std::vector<bool> is_chosen(mesh.number_of_edges(), false);
  std::fill(is_chosen.begin(), is_chosen.begin() + num_edges, true);
  do {
    // a cut graph has one edge more than it has vertices
    std::set<Vertex> ends;
    for (const Edge e : mesh.edges()) {
      cut.is_cut[e] = is_chosen[e];
      if (is_chosen[e])
        ends.insert({ mesh.vertex(e, 0), mesh.vertex(e, 1) });
    }
    if (ends.size() + 1 == num_edges && cut.defect() == "")
      return true;
  } while (std::prev_permutation(is_chosen.begin(), is_chosen.end()));
  return false;
}

TEST(Cut_graphs, of_small_tori_have_the_fewest_edges_or_one_more)
{
  const auto weight = boost::make_function_property_map<Edge>([](Edge) { return 1; });
  std::size_t num_tori = 0, num_fewest = 0;
  for (int n = 7; n <= test::largest_exhaustive(); ++n)
    for (const auto& triangles : test::all_torus_triangulations(n)) {
      Surface_mesh mesh = mesh_of(test::soup_of(n, triangles));
      Cut cut(mesh);
      const double sum = cut.compute(parameters::edge_weight_map(weight));
      EXPECT_EQ(sum, double(cut.size()));
      EXPECT_EQ(cut.defect(), "");
      // two cycles without double edges need four vertices
      std::size_t fewest = 5;
      while (fewest < cut.size() && !has_cut_graph_of_size(mesh, fewest))
        ++fewest;
      EXPECT_LE(cut.size(), fewest + 1);
      num_fewest += cut.size() == fewest;
      ++num_tori;
    }
  std::cout << num_fewest << " of " << num_tori << " small tori got the fewest edges\n";
}

TEST(Cut_graphs, of_disks_and_spheres_are_empty)
{
  for (const auto& soup : { test::polygon(7), test::pillow(5), test::quad_grid(4, 6), test::tetrahedron() }) {
    Surface_mesh mesh = mesh_of(soup);
    Cut cut(mesh);
    EXPECT_EQ(cut.compute(), 0);
    EXPECT_EQ(cut.size(), 0u);
    EXPECT_TRUE(cut.loops.empty());
  }
  Surface_mesh mesh;
  EXPECT_EQ(Cut(mesh).compute(), 0);
  mesh.add_vertex();
  EXPECT_EQ(Cut(mesh).compute(), 0);
}

TEST(Cut_graphs, of_constrained_vertices_of_a_sphere_are_trees)
{
  Surface_mesh mesh = mesh_of(test::octasphere(3));
  Cut cut(mesh);
  for (std::uint32_t num_constrained = 1; num_constrained <= 6; ++num_constrained) {
    cut.is_constrained[Vertex(num_constrained - 1)] = true;
    expect_cut_graph(cut, parameters::vertex_is_constrained_map(cut.is_constrained));
    EXPECT_EQ(cut.loops.size(), num_constrained - 1);
    std::set<Vertex> vertices;
    for (const Edge e : mesh.edges())
      if (cut.is_cut[e])
        vertices.insert({ mesh.vertex(e, 0), mesh.vertex(e, 1) });
    EXPECT_EQ(cut.size(), num_constrained == 1 ? 0 : vertices.size() - 1);
    EXPECT_TRUE(num_constrained == 1 || vertices.count(Vertex(num_constrained - 1)) == 1);
  }
}

TEST(Cut_graphs, are_the_same_each_time_and_for_each_kind_of_mesh)
{
  Surface_mesh mesh = mesh_of(test::closed_surface(5, 300, 1));
  Cut first(mesh);
  const double weight = first.compute(parameters::random_seed(3));
  std::vector<bool> is_cut(first.is_cut.begin(), first.is_cut.end());
  first.compute(parameters::random_seed(4));
  EXPECT_EQ(weight, first.compute(parameters::random_seed(3)));
  EXPECT_EQ(is_cut, std::vector<bool>(first.is_cut.begin(), first.is_cut.end()));

  Polyhedron polyhedron;
  CGAL::copy_face_graph(mesh, polyhedron);
  const auto is_cut_of_polyhedron = get(CGAL::dynamic_edge_property_t<bool>(), polyhedron);
  const double weight_of_polyhedron = CGAL::cut_graph(polyhedron, is_cut_of_polyhedron);
  double sum = 0;
  for (const auto e : edges(polyhedron))
    if (get(is_cut_of_polyhedron, e))
      sum += test::length_of(e, polyhedron);
  EXPECT_NEAR(sum, weight_of_polyhedron, 1e-9);
  std::vector<std::vector<boost::graph_traits<Polyhedron>::halfedge_descriptor>> loops;
  CGAL::cut_graph_loops(polyhedron, is_cut_of_polyhedron, std::back_inserter(loops));
  EXPECT_EQ(loops.size(), 10u);
}

TEST(Cut_graphs, with_bad_weights_are_refused)
{
  Surface_mesh mesh = mesh_of(test::torus());
  Cut cut(mesh);
  auto weight = mesh.add_property_map<Edge, double>("e:weight", 1).first;
  for (const double bad : { -1., std::numeric_limits<double>::infinity(), std::nan("") }) {
    weight[Edge(5)] = bad;
    cut.is_cut[Edge(3)] = true;
    EXPECT_THROW(cut.compute(parameters::edge_weight_map(weight)), std::invalid_argument);
    EXPECT_EQ(cut.size(), 1u);
  }
  weight[Edge(5)] = 0;
  EXPECT_GT(cut.compute(parameters::edge_weight_map(weight)), 0);
  EXPECT_EQ(cut.defect(), "");
}

// The part of a test that any type of mesh can take: cut along a cut graph, as CGAL's Seam_mesh
// cuts, a connected mesh with handles is a disk.
template <class Mesh>
void expect_disk_along_seams(const Mesh& mesh)
{
  const auto is_seam = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
  const auto is_on_seam = get(CGAL::dynamic_vertex_property_t<bool>(), mesh);
  CGAL::cut_graph(mesh, is_seam);
  for (const auto v : vertices(mesh))
    put(is_on_seam, v, false);
  std::size_t num_seams = 0;
  for (const auto e : edges(mesh))
    if (get(is_seam, e)) {
      ++num_seams;
      put(is_on_seam, source(e, mesh), true);
      put(is_on_seam, target(e, mesh), true);
    }
  typedef CGAL::Seam_mesh<Mesh, decltype(is_seam), decltype(is_on_seam)> Seam_mesh;
  typedef typename boost::graph_traits<Seam_mesh>::halfedge_descriptor halfedge_descriptor;
  Seam_mesh disk(mesh, is_seam, is_on_seam);
  disk.set_seam_edges_number(num_seams);

  std::set<halfedge_descriptor> border;
  for (const halfedge_descriptor h : halfedges(disk))
    if (is_border(h, disk))
      border.insert(h);
  ASSERT_FALSE(border.empty());
  const halfedge_descriptor first = *border.begin();
  std::size_t length_of_border = 0;
  halfedge_descriptor h = first;
  do {
    h = next(h, disk);
    ++length_of_border;
  } while (h != first && length_of_border <= border.size());
  EXPECT_EQ(length_of_border, border.size());

  const auto all_vertices = vertices(disk);
  const auto all_edges = edges(disk);
  EXPECT_EQ(std::distance(all_edges.begin(), all_edges.end()), std::ptrdiff_t(num_edges(mesh) + num_seams));
  EXPECT_EQ(std::distance(all_vertices.begin(), all_vertices.end())
                - std::ptrdiff_t(num_edges(mesh) + num_seams) + std::ptrdiff_t(num_faces(mesh)),
            1);
}

// The breadth-first tree of the vertices from V_2 on, the breadth-first tree of the faces from the
// root face on that crosses no edge of the first one, and what is left over: as a Schnyder
// wood has its edges of color 2, 0 and 1, and its special edges.
class Tree_and_cotree
{
public:
  Tree_and_cotree(const Surface_mesh& mesh, Halfedge root)
    : color(mesh.number_of_halfedges(), 2), is_special(mesh.number_of_edges(), true), mesh(mesh), m_root(root)
  {
    find_tree();
    find_cotree();
    for (const Halfedge h : halfedges_around_face(root, mesh))
      color[h] = color[mesh.opposite(h)] = -1;
  }

  std::vector<int> color;
  std::vector<char> is_special;

private:
  void find_tree()
  {
    std::vector<bool> is_found(mesh.number_of_vertices(), false);
    std::vector<Vertex> found(1, mesh.target(mesh.next(m_root)));
    is_found[found[0]] = true;
    for (std::size_t i = 0; i < found.size(); ++i)
      for (const Halfedge h : halfedges_around_source(found[i], mesh))
        if (!is_found[mesh.target(h)]) {
          is_found[mesh.target(h)] = true;
          found.push_back(mesh.target(h));
          is_special[mesh.edge(h)] = false;
        }
  }

  void find_cotree()
  {
    std::vector<bool> is_found(mesh.number_of_faces(), false);
    std::vector<Halfedge> entries(1, m_root);
    is_found[mesh.face(m_root)] = true;
    for (std::size_t i = 0; i < entries.size(); ++i)
      for (const Halfedge h : halfedges_around_face(entries[i], mesh)) {
        const Halfedge o = mesh.opposite(h);
        if (!is_special[mesh.edge(h)] || is_found[mesh.face(o)])
          continue;
        is_found[mesh.face(o)] = true;
        entries.push_back(o);
        is_special[mesh.edge(h)] = false;
        color[h] = color[o] = 0;
      }
  }

  const Surface_mesh& mesh;
  const Halfedge m_root;
};

void cut_along_tree_and_cotree(Cut& cut, Halfedge root)
{
  const Tree_and_cotree wood(cut.mesh, root);
  const auto color = boost::make_function_property_map<Halfedge>([&](Halfedge h) { return wood.color[h]; });
  const auto is_special = boost::make_function_property_map<Edge>([&](Edge e) { return wood.is_special[e] != 0; });
  CGAL::cut_graph_of_schnyder_wood(cut.mesh, root, color, is_special, cut.is_cut);
}

// Expects cut_along(c, root, i) to make c a cut graph with right loops, on `num` random surfaces of each genus.
template <class Cut_along>
void expect_random_surfaces_are_cut(std::size_t num, const Cut_along& cut_along)
{
  for (const std::uint32_t genus : { 0, 1, 2, 5, 20 })
    for (unsigned int seed = 0; seed < num; ++seed) {
      SCOPED_TRACE("genus " + std::to_string(genus) + ", seed " + std::to_string(seed));
      Surface_mesh mesh = mesh_of(test::closed_surface(genus, 4 * genus + 4 + seed, seed));
      Cut cut(mesh);
      cut_along(cut, Halfedge(7 * seed % mesh.number_of_halfedges()), seed);
      EXPECT_EQ(cut.defect(), "");
      CGAL::cut_graph_loops(mesh, cut.is_cut, std::back_inserter(cut.loops));
      EXPECT_EQ(cut.defect_of_loops(), "");
    }
}

TEST(Cut_graphs, of_trees_like_those_of_a_schnyder_wood_are_pruned)
{
  expect_random_surfaces_are_cut(test::scaled(100), [](Cut& cut, Halfedge root, unsigned int) {
    cut_along_tree_and_cotree(cut, root);
  });
}

// The shortest arcs between given points, here those at which a graph branches, are no longer than
// the arcs of any cut graph between these points.
TEST(Cut_graphs, become_shorter_when_straightened)
{
  std::size_t num_shorter = 0, num_graphs = 0;
  for (const std::uint32_t genus : { 1, 2, 5, 20 })
    for (unsigned int seed = 0; seed < test::scaled(100); ++seed) {
      SCOPED_TRACE("genus " + std::to_string(genus) + ", seed " + std::to_string(seed));
      Surface_mesh mesh = mesh_of(test::closed_surface(genus, 4 * genus + 4 + 3 * seed, seed));
      Cut cut(mesh);
      cut_along_tree_and_cotree(cut, Halfedge(7 * seed % mesh.number_of_halfedges()));
      const double length = cut.length();
      std::vector<int> degree(mesh.number_of_vertices(), 0);
      for (const Edge e : mesh.edges())
        if (cut.is_cut[e])
          for (const int end : { 0, 1 })
            ++degree[mesh.vertex(e, end)];
      for (const Vertex v : mesh.vertices())
        cut.is_constrained[v] = degree[v] >= 3;
      cut.compute(parameters::vertex_is_constrained_map(cut.is_constrained).number_of_iterations(1));
      EXPECT_EQ(cut.defect(), "");
      EXPECT_LE(cut.length(), length * (1 + 1e-9));
      num_shorter += cut.length() < length * (1 - 1e-9);
      ++num_graphs;
    }
  std::cout << num_shorter << " of " << num_graphs << " graphs became shorter\n";
}

void cut_along_schnyder_wood(Cut& cut, Halfedge root, CGAL::Shelling_order order,
                             const std::vector<Vertex>& further_roots = {})
{
  const auto color = get(CGAL::dynamic_halfedge_property_t<int>(), cut.mesh);
  const auto outgoing = get(CGAL::dynamic_halfedge_property_t<bool>(), cut.mesh);
  const auto is_special = get(CGAL::dynamic_edge_property_t<bool>(), cut.mesh);
  CGAL::g_schnyder_wood(cut.mesh, root, color, outgoing, is_special, order, 1, further_roots);
  CGAL::cut_graph_of_schnyder_wood(cut.mesh, root, color, is_special, cut.is_cut);
}

TEST(Cut_graphs, of_schnyder_woods_cut)
{
  expect_random_surfaces_are_cut(test::scaled(50), [](Cut& cut, Halfedge root, unsigned int seed) {
    cut_along_schnyder_wood(cut, root, test::all_orders[seed % 3]);
  });
}

TEST(Cut_graphs, of_schnyder_woods_with_several_roots_cut)
{
  Surface_mesh mesh = mesh_of(test::sphere_with_far_handles(2000, 10));
  Cut cut(mesh);
  std::mt19937 rng(1);
  std::size_t num_woods = 0;
  for (std::size_t i = 0; i < test::scaled(100); ++i) {
    std::vector<Vertex> further_roots;
    for (std::size_t j = 1 + i % 3; j > 0; --j)
      further_roots.push_back(Vertex(rng() % mesh.number_of_vertices()));
    try {
      cut_along_schnyder_wood(cut, Halfedge(rng() % mesh.number_of_halfedges()), test::all_orders[i % 3], further_roots);
    } catch (const std::invalid_argument&) { // roots are too close
      continue;
    }
    EXPECT_EQ(cut.defect(), "");
    ++num_woods;
  }
  EXPECT_GT(num_woods, test::scaled(100) / 2);
}

// The named mesh of CGAL's data, if it is there.
bool read(const std::string& name, Surface_mesh& mesh)
{
  const std::string file = CGAL::data_file_path("meshes/" + name);
  return std::ifstream(file) && CGAL::IO::read_OFF(file, mesh);
}

// Tests on a smaller scale leave large meshes out.
bool is_too_large(const Surface_mesh& mesh) { return mesh.number_of_vertices() > test::scaled(50000); }

bool meshes_are_missing() { return !std::filesystem::is_directory(CGAL::data_file_path("meshes")); }

TEST(Cut_graphs, cut_real_meshes_of_all_kinds)
{
  if (meshes_are_missing())
    GTEST_SKIP() << "CGAL's meshes are not there: run scripts/fetch_meshes";
  const std::size_t largest_file = test::scaled(1000) >= 1000 ? std::size_t(-1) : 200000;
  std::size_t num_cut = 0, num_read = 0;
  for (const auto& file : std::filesystem::directory_iterator(CGAL::data_file_path("meshes"))) {
    Surface_mesh mesh;
    if (file.path().extension() != ".off" || file.file_size() > largest_file
        || !read(file.path().filename().string(), mesh))
      continue;
    SCOPED_TRACE(file.path().filename().string());
    Cut cut(mesh);
    expect_cut_graph(cut, parameters::number_of_iterations(1));
    ++num_read;
    num_cut += cut.size() > 0;
  }
  std::cout << num_read << " meshes, of which " << num_cut << " had to be cut\n";
  EXPECT_GT(num_cut, 20u);
}

void print_entry(std::size_t num_edges, double length)
{
  std::cout << std::setw(7) << num_edges << " /" << std::setw(5) << length;
}

// Prints the shortest graph that `cut_along` finds from 8 roots, relative to `unit`, and returns its length.
template <class CutAlong>
double shortest_of_8_roots(Cut& cut, double unit, const CutAlong& cut_along)
{
  std::pair<double, std::size_t> best((std::numeric_limits<double>::infinity)(), 0);
  for (int i = 0; i < 8; ++i) {
    cut_along(cut, Halfedge(cut.mesh.number_of_halfedges() / 8 * i));
    EXPECT_EQ(cut.defect(), "");
    best = (std::min)(best, std::make_pair(cut.length(), cut.size()));
  }
  print_entry(best.second, best.first / unit);
  return best.first;
}

TEST(Cut_graphs, of_real_meshes_are_short)
{
  if (meshes_are_missing())
    GTEST_SKIP() << "CGAL's meshes are not there: run scripts/fetch_meshes";
  std::cout << std::setprecision(3) << "edges / length, relative to cut_graph(); of others, the best of 8 roots\n"
            << "                mesh      n   g    cut_graph   tree-cotree     wood LIFO     wood FIFO   wood RANDOM\n";
  double sum_of_logarithms = 0;
  int num_meshes = 0;
  const std::vector<std::string> names = { "anchor_dense", "cheese", "couplingdown", "double-torus-example",
                                           "elephant", "femur", "helmet", "knot1", "turbine", "rotor", "elk" };
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    Surface_mesh mesh;
    ASSERT_TRUE(read(name + ".off", mesh));
    if (is_too_large(mesh))
      continue;
    CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
    Cut cut(mesh);
    expect_cut_graph(cut, parameters::default_values());
    expect_disk_along_seams(mesh);
    expect_disk_along_seams(CGAL::Compact_surface_mesh<Surface_mesh::Point>(mesh));
    const double length = cut.length();
    std::cout << std::setw(20) << name << std::setw(7) << mesh.number_of_vertices() << std::setw(4)
              << cut.loops.size() / 2;
    print_entry(cut.size(), 1);
    const double plain = shortest_of_8_roots(cut, length, cut_along_tree_and_cotree);
    for (const auto order : test::all_orders)
      shortest_of_8_roots(cut, length, [&](Cut& c, Halfedge root) { cut_along_schnyder_wood(c, root, order); });
    std::cout << '\n';
    sum_of_logarithms += std::log(plain / length);
    ++num_meshes;
  }
  const double mean = std::exp(sum_of_logarithms / num_meshes);
  std::cout << "geometric mean " << mean << '\n';
  EXPECT_GT(mean, 1.6);
}

TEST(Cut_graphs, have_loops_that_cannot_be_contracted)
{
  if (meshes_are_missing())
    GTEST_SKIP() << "CGAL's meshes are not there: run scripts/fetch_meshes";
  for (const std::string name :
       { "cheese.off", "double-torus-example.off", "elephant.off", "knot1.off", "3torus.off" }) {
    SCOPED_TRACE(name);
    Surface_mesh mesh;
    ASSERT_TRUE(read(name, mesh));
    if (is_too_large(mesh))
      continue;
    Cut cut(mesh);
    cut.compute();
    const CGAL::Surface_mesh_topology::Curves_on_surface_topology<Surface_mesh> curves(mesh);
    curves.compute_minimal_quadrangulation(false);
    for (const auto& loop : cut.loops) {
      CGAL::Surface_mesh_topology::Path_on_surface<Surface_mesh> path(mesh);
      for (const Halfedge h : loop)
        path.push_back(h);
      EXPECT_TRUE(path.is_closed());
      EXPECT_FALSE(curves.is_contractible(path));
    }
  }
}

TEST(Cut_graphs, of_tori_are_hardly_longer_than_they_must_be)
{
  if (meshes_are_missing())
    GTEST_SKIP() << "CGAL's meshes are not there: run scripts/fetch_meshes";
  for (const std::string name : { "rotor.off", "elk.off", "torus_quad.off" }) {
    SCOPED_TRACE(name);
    Surface_mesh mesh;
    ASSERT_TRUE(read(name, mesh));
    if (is_too_large(mesh))
      continue;
    Cut cut(mesh);
    cut.compute();
    ASSERT_EQ(cut.loops.size(), 2u);
    const CGAL::Surface_mesh_topology::Euclidean_length_weight_functor<Surface_mesh> weight(mesh);
    const CGAL::Surface_mesh_topology::Curves_on_surface_topology<Surface_mesh> curves(mesh);
    const auto shortest = curves.compute_shortest_non_contractible_cycle(weight);
    double length = 0;
    for (std::size_t i = 0; i < shortest.length(); ++i)
      length += weight(shortest[i]);
    double shorter_loop = std::numeric_limits<double>::infinity();
    for (const auto& loop : cut.loops) {
      double length_of_loop = 0;
      for (const Halfedge h : loop)
        length_of_loop += weight(h);
      shorter_loop = (std::min)(shorter_loop, length_of_loop);
    }
    std::cout << std::setw(15) << name << ": cut graph " << cut.length() / length << ", its shorter loop "
              << shorter_loop / length << " times the shortest cycle that cannot be contracted\n";
    EXPECT_GE(cut.length(), length * (1 - 1e-9));
    EXPECT_GE(shorter_loop, length * (1 - 1e-9));
    EXPECT_LE(shorter_loop, 1.5 * length);
  }
}

} // namespace
