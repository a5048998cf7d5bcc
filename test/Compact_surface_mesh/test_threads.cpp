// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Several threads read one mesh, all that can be asked of a constant one: the answers are those of a single thread. To
// be compiled with the thread sanitizer, which reports what one of them writes and another one sees.

#include "generated_surfaces.h"
#include "generated_triangulations.h"

#include <CGAL/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/layouts/Corner_table_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/Input_order_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/Laced_ring_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/SOT_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/SQuad_layout.h>
#include <CGAL/Compact_surface_mesh/layouts/Schnyder_fronts_layout.h>

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/breadth_first_search.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <future>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using test::Polygon_soup;
namespace PMP = CGAL::Polygon_mesh_processing;

// All answers in one number.
class Digest
{
public:
  Digest& operator<<(std::uint64_t value)
  {
    m_value = (m_value ^ value) * 0x100000001b3u;
    return *this;
  }
  Digest& operator<<(double value)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof(bits));
    return *this << bits;
  }
  template <class Tag, class Index>
  Digest& operator<<(CGAL::Compact_surface_mesh_descriptors::Descriptor<Tag, Index> d)
  {
    return *this << std::uint64_t(d.idx());
  }
  Digest& operator<<(const std::string& text)
  {
    for (const char c : text)
      *this << std::uint64_t(c);
    return *this;
  }
  template <class Range>
  Digest& add_all(const Range& range)
  {
    for (const auto& x : range)
      *this << x;
    return *this;
  }

  std::uint64_t value() const { return m_value; }

private:
  std::uint64_t m_value = 0xcbf29ce484222325u;
};

// Asks a mesh everything.
template <class Mesh>
class Reader
{
  using Vertex = typename Mesh::Vertex_index;
  using Halfedge = typename Mesh::Halfedge_index;
  using Edge = typename Mesh::Edge_index;
  using Face = typename Mesh::Face_index;

public:
  Reader(const Mesh& mesh, typename Mesh::template Property_map<Face, int> map) : m_mesh(mesh), m_map(map) {}

  std::uint64_t operator()()
  {
    ask_halfedges();
    ask_edges();
    ask_vertices();
    ask_faces();
    ask_mesh();
    ask_property_maps();
    ask_algorithms();
    return m_digest.value();
  }

private:
  void ask_halfedges()
  {
    for (const Halfedge h : m_mesh.halfedges()) {
      m_digest << m_mesh.source(h) << m_mesh.target(h) << m_mesh.next(h) << m_mesh.prev(h) << m_mesh.opposite(h)
               << m_mesh.face(h) << m_mesh.edge(h) << std::uint64_t(m_mesh.is_border(h))
               << m_mesh.next_around_target(h) << m_mesh.prev_around_target(h) << m_mesh.next_around_source(h)
               << m_mesh.prev_around_source(h) << m_mesh.halfedge(m_mesh.source(h), m_mesh.target(h))
               << m_mesh.halfedge(m_mesh.source(h), m_mesh.target(m_mesh.next(h)));
      m_digest << halfedge(source(h, m_mesh), target(h, m_mesh), m_mesh).first
               << edge(source(h, m_mesh), target(h, m_mesh), m_mesh).first;
      m_digest.add_all(m_mesh.vertices_around_target(h));
      m_digest.add_all(m_mesh.halfedges_around_target(h));
      m_digest.add_all(m_mesh.faces_around_target(h));
      m_digest.add_all(m_mesh.vertices_around_face(h));
      m_digest.add_all(m_mesh.halfedges_around_face(h));
      m_digest.add_all(m_mesh.faces_around_face(h));
      m_digest.add_all(CGAL::halfedges_around_source(h, m_mesh));
    }
  }

  void ask_edges()
  {
    for (const Edge e : m_mesh.edges())
      m_digest << m_mesh.halfedge(e) << m_mesh.halfedge(e, 1) << m_mesh.vertex(e, 0) << source(e, m_mesh)
               << target(e, m_mesh) << std::uint64_t(m_mesh.is_border(e));
  }

  void ask_vertices()
  {
    for (const Vertex v : m_mesh.vertices()) {
      m_digest << m_mesh.halfedge(v) << std::uint64_t(m_mesh.degree(v)) << std::uint64_t(m_mesh.is_border(v))
               << std::uint64_t(m_mesh.is_isolated(v)) << m_mesh.point(v).x();
      m_mesh.for_each_adjacent_vertex(v, [&](Vertex u) { m_digest << u; });
      m_mesh.for_each_incident_triangle(v, [&](Vertex u, Vertex w) { m_digest << u << w; });
      for (const Edge e : CGAL::make_range(out_edges(v, m_mesh)))
        m_digest << e;
      for (const Edge e : CGAL::make_range(in_edges(v, m_mesh)))
        m_digest << e;
      m_digest.add_all(CGAL::make_range(adjacent_vertices(v, m_mesh)));
    }
  }

  void ask_faces()
  {
    for (const Face f : m_mesh.faces()) {
      m_digest << m_mesh.halfedge(f) << std::uint64_t(m_mesh.degree(f)) << std::uint64_t(m_map[f]);
      m_digest.add_all(m_mesh.vertices_of_face(f));
    }
  }

  void ask_mesh()
  {
    EXPECT_TRUE(m_mesh.is_valid());
    EXPECT_TRUE(m_mesh.is_valid(*m_mesh.vertices().begin()) && m_mesh.is_valid(*m_mesh.faces().begin()));
    m_digest << std::uint64_t(m_mesh.connectivity_bytes()) << m_mesh.references_per_vertex();
    std::ostringstream out;
    m_mesh.property_stats(out);
    m_digest << out.str();
    const Mesh copy(m_mesh);
    m_digest << copy.next(*copy.halfedges().begin());
  }

  void ask_property_maps()
  {
    m_digest.add_all(m_mesh.template properties<Face>());
    m_digest << std::uint64_t(m_mesh.template find_property_map<Face, int>("f:map")[*m_mesh.faces().begin()]);
    const auto points = get(CGAL::vertex_point, m_mesh);
    const auto weights = get(boost::edge_weight, m_mesh);
    const auto index = get(boost::vertex_index, m_mesh);
    const auto own = get(CGAL::dynamic_vertex_property_t<int>(), m_mesh); // a map of this thread
    for (const Vertex v : vertices(m_mesh)) {
      put(own, v, static_cast<int>(get(index, v)));
      m_digest << std::uint64_t(get(own, v)) << get(points, v).y();
    }
    for (const Edge e : edges(m_mesh))
      m_digest << get(weights, e);
  }

  void ask_algorithms()
  {
    std::vector<int> distance(num_vertices(m_mesh), -1);
    const auto index = get(boost::vertex_index, m_mesh);
    boost::breadth_first_search(
      m_mesh, *vertices(m_mesh).begin(),
      boost::visitor(boost::make_bfs_visitor(boost::record_distances(
        boost::make_iterator_property_map(distance.begin(), index), boost::on_tree_edge()))));
    for (const int d : distance)
      m_digest << std::uint64_t(d);
    for (const Vertex v : vertices(m_mesh))
      if (!m_mesh.is_isolated(v))
        m_digest << PMP::compute_vertex_normal(v, m_mesh).z();
  }

  const Mesh& m_mesh;
  const typename Mesh::template Property_map<Face, int> m_map;
  Digest m_digest;
};

// A surface of polygons with borders, handles and isolated vertices, and a triangulation of the sphere.
std::vector<Polygon_soup> soups()
{
  Polygon_soup sphere;
  const test::Soup triangulation = test::random_triangulation(60, 1);
  sphere.num_vertices = triangulation.num_vertices;
  for (const auto& t : triangulation.triangles)
    sphere.faces.emplace_back(t.begin(), t.end());
  return { test::random_surface(3), sphere };
}

template <class Layout>
struct Threads
  : public ::testing::Test
{};

using Layouts = ::testing::Types<
  CGAL::Schnyder_parents_layout<4>,
  CGAL::Schnyder_parents_layout<5>,
  CGAL::Schnyder_parents_layout<6>,
  CGAL::Schnyder_fronts_layout<6>,
  CGAL::Schnyder_fronts_layout<5>,
  CGAL::Schnyder_fronts_layout<4>,
  CGAL::Schnyder_fronts_layout<5, true>,
  CGAL::Corner_table_layout<>,
  CGAL::SOT_layout<>,
  CGAL::SQuad_layout<>,
  CGAL::Laced_ring_layout<>,
  CGAL::Laced_ring_layout<std::uint32_t, std::uint16_t>,
  CGAL::Input_order_layout<>,
  CGAL::Input_order_layout<CGAL::Schnyder_parents_layout<>, CGAL::Input_order::VERTICES_AND_FACES>
>;
TYPED_TEST_SUITE(Threads, Layouts);

TYPED_TEST(Threads, read_one_mesh_as_a_single_one_does)
{
  using Mesh = CGAL::Compact_surface_mesh<Point, TypeParam>;
  for (const Polygon_soup& soup : soups()) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < soup.num_vertices; ++i)
      points.emplace_back(std::sin(i * 1.3), std::sin(i * 2.1 + 1), std::sin(i * 3.7 + 2));
    Mesh mesh(points, soup.faces);
    const auto map = mesh.template add_property_map<typename Mesh::Face_index, int>("f:map", 7).first;
    const auto read = [&mesh, map] { return Reader<Mesh>(mesh, map)(); };
    std::vector<std::future<std::uint64_t>> answers; // asked for before a single thread could prepare anything
    for (int i = 0; i < 4; ++i)
      answers.push_back(std::async(std::launch::async, read));
    std::set<std::uint64_t> values;
    for (auto& answer : answers)
      values.insert(answer.get());
    values.insert(read());
    EXPECT_EQ(values.size(), 1u);
  }
}

} // namespace
