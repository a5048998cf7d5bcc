// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// What programs written for Surface_mesh use of its class: the same code on both. Property maps that follow, points
// of any type, and classes that derive from the mesh.

#include "read_mesh_oracle.h"

#include <CGAL/Compact_surface_mesh.h>
#include <CGAL/Compact_surface_mesh/internal/versions_of_cgal.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Surface_mesh = CGAL::Surface_mesh<Point>;
using Mesh = CGAL::Compact_surface_mesh<Point>;
namespace parameters = CGAL::parameters;

// A sheet of w times h squares, every third one cut in two, with a hole.
Surface_mesh sheet(int w, int h)
{
  Surface_mesh mesh;
  std::vector<Surface_mesh::Vertex_index> v;
  for (int j = 0; j <= h; ++j)
    for (int i = 0; i <= w; ++i)
      v.push_back(mesh.add_vertex(Point(i, j, (i * i + 3 * j) % 7)));
  for (int j = 0; j < h; ++j)
    for (int i = 0; i < w; ++i) {
      const int k = j * (w + 1) + i;
      if (i == 1 && j == 1)
        continue;
      if ((i + j) % 3 == 0) {
        mesh.add_face(v[k], v[k + 1], v[k + w + 2]);
        mesh.add_face(v[k], v[k + w + 2], v[k + w + 1]);
      } else
        mesh.add_face(v[k], v[k + 1], v[k + w + 2], v[k + w + 1]);
    }
  return mesh;
}

// Numbers that tell elements apart: of a vertex its point, of a halfedge those of its ends.
template <class M>
double number_of(const M& m, typename M::Vertex_index v)
{
  return m.point(v).x() + 100 * m.point(v).y();
}

template <class M>
double number_of(const M& m, typename M::Halfedge_index h)
{
  return number_of(m, m.source(h)) + 1e5 * number_of(m, m.target(h));
}

using Answers = std::map<std::string, std::vector<double> >;

// Everything that can be asked of a mesh, sorted where the order is the mesh's own.
template <class M>
class Questions
{
  using V = typename M::Vertex_index;
  using H = typename M::Halfedge_index;
  using E = typename M::Edge_index;
  using F = typename M::Face_index;

public:
  explicit Questions(const M& m) : m(m) {}

  Answers operator()()
  {
    ask_counts();
    for (const V v : m.vertices())
      ask(v);
    for (const H h : m.halfedges())
      ask(h);
    for (const E e : m.edges())
      ask(e);
    for (const F f : m.faces())
      ask(f);
    ask_null();
    for (auto& answer : answers)
      std::sort(answer.second.begin(), answer.second.end());
    return answers;
  }

private:
  template <class... T>
  void tell(const std::string& question, T... answer) { (answers[question].push_back(double(answer)), ...); }

  void ask_counts()
  {
    tell("counts", m.number_of_vertices(), m.number_of_halfedges(), m.number_of_edges(), m.number_of_faces(),
         m.num_vertices(), m.num_halfedges(), m.num_edges(), m.num_faces());
    tell("removed", m.number_of_removed_vertices(), m.number_of_removed_halfedges(), m.number_of_removed_edges(),
         m.number_of_removed_faces(), m.has_garbage(), m.does_recycle_garbage());
    tell("ranges", m.vertices().size(), m.halfedges().size(), m.edges().size(), m.faces().size(),
         m.vertices_end() - m.vertices_begin(), m.halfedges_end() - m.halfedges_begin(),
         m.edges_end() - m.edges_begin(), m.faces_end() - m.faces_begin());
    tell("is", m.is_empty(), m.is_valid(), m.is_valid(false));
  }

  void ask(V v)
  {
    const double n = number_of(m, v);
    tell("valid vertex", m.is_valid(v), m.has_valid_index(v), m.is_removed(v));
    tell("degree", n + 1e6 * m.degree(v));
    tell("vertex on a border", n + 1e6 * m.is_border(v) + 2e6 * m.is_border(v, true) + 4e6 * m.is_border(v, false));
    tell("isolated", n + 1e6 * m.is_isolated(v));
    if (!m.is_isolated(v) && m.target(m.halfedge(v)) != v)
      tell("wrong halfedge", n);
  }

  void ask(H h)
  {
    const double n = number_of(m, h);
    tell("valid halfedge", m.is_valid(h), m.has_valid_index(h), m.is_removed(h));
    const std::array<H, 7> neighbors = { m.next(h), m.prev(h), m.opposite(h), m.next_around_target(h),
                                         m.prev_around_target(h), m.next_around_source(h), m.prev_around_source(h) };
    for (std::size_t i = 0; i < neighbors.size(); ++i)
      tell("operator " + std::to_string(i), n + 1e-5 * number_of(m, neighbors[i]));
    tell("halfedge on a border", n + 1e-1 * m.is_border(h));
    if (m.face(h) == m.null_face() ? !m.is_border(h) : m.is_border(h))
      tell("wrong face", n);
    if (m.halfedge(m.source(h), m.target(h)) != h || m.halfedge(m.edge(h)) != h)
      tell("wrong halfedge", n);

    around("vertices around target", n, m.vertices_around_target(h));
    around("halfedges around target", n, m.halfedges_around_target(h));
    around("faces around target", n, m.faces_around_target(h));
    around("vertices around face", n, m.vertices_around_face(h));
    around("halfedges around face", n, m.halfedges_around_face(h));
    around("faces around face", n, m.faces_around_face(h));
    circulate<typename M::Vertex_around_target_circulator>("circulated vertices around target", h);
    circulate<typename M::Halfedge_around_target_circulator>("circulated halfedges around target", h);
    circulate<typename M::Halfedge_around_source_circulator>("circulated halfedges around source", h);
    circulate<typename M::Face_around_target_circulator>("circulated faces around target", h);
    circulate<typename M::Vertex_around_face_circulator>("circulated vertices around face", h);
    circulate<typename M::Halfedge_around_face_circulator>("circulated halfedges around face", h);
  }

  void ask(E e)
  {
    const double n = number_of(m, m.vertex(e, 0)) * number_of(m, m.vertex(e, 1));
    tell("valid edge", m.is_valid(e), m.has_valid_index(e), m.is_removed(e));
    tell("edge", n, m.is_border(e));
    if (m.opposite(m.halfedge(e, 0)) != m.halfedge(e, 1) || m.edge(m.halfedge(e)) != e
        || m.target(m.halfedge(e, 1)) != m.vertex(e, 1))
      tell("wrong edge", n);
  }

  void ask(F f)
  {
    tell("valid face", m.is_valid(f), m.has_valid_index(f), m.is_removed(f));
    tell("face", number_of_face(f) + 1e9 * m.degree(f));
    if (m.face(m.halfedge(f)) != f)
      tell("wrong face", number_of_face(f));
  }

  void ask_null()
  {
    tell("null", M::null_vertex() == V(), M::null_halfedge() == H(), M::null_edge() == E(), M::null_face() == F(),
         m.has_valid_index(V()), m.has_valid_index(F()), m.has_valid_index(V(m.num_vertices())));
    const V u = *m.vertices().begin();
    tell("not adjacent", m.halfedge(u, u) == m.null_halfedge());
  }

  // The same for each halfedge of the face.
  double number_of_face(F f) const
  {
    if (f == m.null_face())
      return -1;
    double sum = 0;
    for (const V v : m.vertices_around_face(m.halfedge(f)))
      sum += number_of(m, v);
    return sum;
  }
  double number(V v) const { return number_of(m, v); }
  double number(H h) const { return number_of(m, h); }
  double number(F f) const { return number_of_face(f); }

  template <class Range>
  void around(const std::string& question, double n, const Range& range)
  {
    double i = 0;
    for (const auto element : range)
      tell(question, n + 1e-4 * number(element) * ++i);
  }

  template <class Circulator>
  void circulate(const std::string& question, H h)
  {
    double i = 0;
    Circulator c(h, m), end(c);
    do
      tell(question, number_of(m, h) + 1e-4 * number(*c) * ++i);
    while (++c != end);
  }

  const M& m;
  Answers answers;
};

TEST(Interface, answers_are_those_of_surface_mesh)
{
  const Surface_mesh source = sheet(5, 4);
  const Mesh mesh(source);
  const Answers expected = Questions<Surface_mesh>(source)(), answers = Questions<Mesh>(mesh)();
  ASSERT_EQ(answers.size(), expected.size());
  for (const auto& [question, answer] : expected)
    EXPECT_EQ(answers.at(question), answer) << question;
}

// The types that a program may name.
template <class M>
using Types = std::tuple<
  typename M::size_type, typename M::Point, typename M::vertex_index, typename M::halfedge_index,
  typename M::edge_index, typename M::face_index, typename M::vertex_iterator, typename M::halfedge_iterator,
  typename M::edge_iterator, typename M::face_iterator, typename M::out_edge_iterator, typename M::Vertex_iterator,
  typename M::Halfedge_iterator, typename M::Edge_iterator, typename M::Face_iterator, typename M::Vertex_range,
  typename M::Halfedge_range, typename M::Edge_range, typename M::Face_range, typename M::Vertex_around_target_range,
  typename M::Halfedge_around_target_range, typename M::Face_around_target_range,
  typename M::Vertex_around_face_range, typename M::Halfedge_around_face_range, typename M::Face_around_face_range,
  typename M::directed_category, typename M::edge_parallel_category, typename M::traversal_category,
  typename M::vertices_size_type, typename M::halfedges_size_type, typename M::edges_size_type,
  typename M::faces_size_type, typename M::degree_size_type, typename M::vertex_property_type,
  typename M::template Property_map<typename M::Edge_index, float> >;

TEST(Interface, types_are_those_of_surface_mesh)
{
  using Expected = Types<Surface_mesh>;
  using Found = Types<Mesh>;
  static_assert(std::tuple_size<Expected>::value == std::tuple_size<Found>::value, "");
  static_assert(std::is_same<std::tuple_element_t<0, Expected>, std::tuple_element_t<0, Found> >::value, "");
  static_assert(std::is_same<std::tuple_element_t<1, Expected>, std::tuple_element_t<1, Found> >::value, "");
  static_assert(std::is_same<boost::graph_traits<Mesh>::traversal_category, Mesh::traversal_category>::value, "");
}

// What a program does to property maps, as text.
template <class M>
std::string log_of_property_maps(M& m)
{
  using V = typename M::Vertex_index;
  using F = typename M::Face_index;
  std::ostringstream log;
  auto added = m.template add_property_map<V, double>("v:weight", 2.5);
  log << added.second << added.first[V(0)];
  added.first[V(0)] = 3;
  const auto again = m.template add_property_map<V, double>("v:weight", 7);
  log << again.second << again.first[V(0)];
  log << m.template add_property_map<V, int>("v:weight").second; // another type
  auto anonymous = m.template add_property_map<F, std::string>();
  anonymous.first[F(0)] = "x";
  log << anonymous.second << anonymous.first[F(0)] << anonymous.first[F(1)].size();
  log << (m.template property_type<V>("v:weight") == typeid(double))
      << (m.template property_type<V>("v:none") == typeid(void));
  const M copy(m);
  added.first[V(0)] = 4;
  using CGAL::internal::optional_map;
  log << (*optional_map(copy.template property_map<V, double>("v:weight")))[V(0)]
      << (*optional_map(m.template property_map<V, double>("v:weight")))[V(0)]
      << optional_map(m.template property_map<V, double>("v:none")).has_value();
  const auto names = m.template properties<V>();
  log << std::count(names.begin(), names.end(), "v:weight") << std::count(names.begin(), names.end(), "v:point");
  std::ostringstream stats;
  m.property_stats(stats);
  log << (stats.str().find("vertex properties:\n") == 0) << (stats.str().find("\tv:weight\n") != std::string::npos);
  m.remove_property_map(anonymous.first);
  log << bool(anonymous.first);
  m.template add_property_map<F, int>("f:number");
  m.template remove_property_maps<V>();
  log << (m.template property_type<V>("v:weight") == typeid(void))
      << (m.template property_type<F>("f:number") == typeid(int));
  m.remove_all_property_maps();
  log << (m.template property_type<F>("f:number") == typeid(void))
      << (m.template property_type<V>("v:point") == typeid(typename M::Point));
  std::size_t n = 0;
  for (auto& p : m.points())
    n += p == p;
  log << n << std::distance(m.points().begin(), m.points().end());
  return log.str();
}

// Whether property_map() answers with an optional.
template <class M, class Map = typename M::template Property_map<typename M::Vertex_index, double> >
inline constexpr bool finds_optionally =
  std::is_same<decltype(std::declval<const M&>().template property_map<typename M::Vertex_index, double>("")),
               std::optional<Map> >::value;

TEST(Interface, property_maps_are_those_of_surface_mesh)
{
  static_assert(finds_optionally<Mesh> == finds_optionally<Surface_mesh>, "");
  Surface_mesh source = sheet(3, 3);
  Mesh mesh(source);
  EXPECT_EQ(log_of_property_maps(mesh), log_of_property_maps(source));
}

TEST(Interface, all_elements_are_removed_at_once)
{
  Mesh mesh(sheet(3, 3));
  mesh.add_property_map<Mesh::Vertex_index, int>("v:n", 4);
  CGAL::remove_all_elements(mesh);
  EXPECT_TRUE(mesh.is_empty());
  EXPECT_TRUE(mesh.property_type<Mesh::Vertex_index>("v:n") == typeid(int));
}

// What becomes of a mesh that is copied, moved, swapped and emptied, as text.
template <class M>
std::string log_of_life(M m)
{
  using V = typename M::Vertex_index;
  std::ostringstream log;
  const std::size_t internal = m.template properties<V>().size();
  m.template add_property_map<V, int>("v:n", 4);
  M copy(m), assigned, bare(m);
  assigned = m;
  bare.template remove_property_maps<V>();
  log << copy.template properties<V>().size() - internal << assigned.template properties<V>().size() - internal
      << bare.template properties<V>().size() - internal;
  M moved(std::move(copy));
  log << moved.number_of_faces() << copy.number_of_faces();
  copy = std::move(moved);
  log << moved.number_of_faces() << copy.number_of_faces();
  using std::swap;
  swap(bare, copy);
  log << bare.template properties<V>().size() - internal << copy.template properties<V>().size() - internal;
  m.reserve(100, 300, 200);
  m.shrink_to_fit();
  m.collect_garbage();
  m.set_recycle_garbage(true);
  m.clear_without_removing_property_maps();
  log << m.number_of_vertices() << m.template properties<V>().size() - internal << m.is_empty() << m.is_valid();
  assigned.clear();
  log << assigned.number_of_faces() << assigned.template properties<V>().size() - internal;
  M cleared(bare);
  CGAL::clear(cleared);
  log << cleared.number_of_vertices() << cleared.is_empty();
  return log.str();
}

TEST(Interface, meshes_live_as_surface_meshes_do)
{
  const Surface_mesh source = sheet(3, 3);
  EXPECT_EQ(log_of_life(Mesh(source)), log_of_life(source));
}

TEST(Interface, descriptors_compare_and_print_as_those_of_surface_mesh)
{
  const auto log = [](auto vertex, auto halfedge, auto edge, auto face) {
    using V = decltype(vertex);
    std::ostringstream out;
    out << V(3) << V(4).idx() << (V(3) < V(4)) << (V(3) > V(4)) << (V(3) <= V()) << (V(3) == V(3)) << (V(3) != V(3));
    out << decltype(halfedge)(5) << decltype(edge)(6) << decltype(face)(7);
    out << V(3) + 1 << std::size_t(V(3)) << V().is_valid() << V().idx() << decltype(edge)().is_valid();
    V v(3);
    for (const std::size_t i : { std::size_t(++v), std::size_t(v++), std::size_t(--v), std::size_t(v--),
                                 std::size_t(v += 2) })
      out << i << v;
    v.reset();
    out << (v == V());
    return out.str();
  };
  EXPECT_EQ(log(Mesh::Vertex_index(), Mesh::Halfedge_index(), Mesh::Edge_index(), Mesh::Face_index()),
            log(Surface_mesh::Vertex_index(), Surface_mesh::Halfedge_index(), Surface_mesh::Edge_index(),
                Surface_mesh::Face_index()));
}

// Property maps of many types for all kinds of elements, with values that differ from element to element.
template <class M>
void add_maps(M& m)
{
  auto v_int = m.template add_property_map<typename M::Vertex_index, int>("v:int").first;
  auto v_normal = m.template add_property_map<typename M::Vertex_index, Kernel::Vector_3>("v:normal").first;
  auto v_color = m.template add_property_map<typename M::Vertex_index, CGAL::IO::Color>("v:color").first;
  auto v_texture = m.template add_property_map<typename M::Vertex_index, Kernel::Point_2>("v:texcoord").first;
  auto v_other = m.template add_property_map<typename M::Vertex_index, Point>("v:other").first;
  int i = 0;
  for (const auto v : m.vertices()) {
    v_int[v] = ++i;
    v_normal[v] = Kernel::Vector_3(i, 2, 3);
    v_color[v] = CGAL::IO::Color(static_cast<unsigned char>(i), 1, 2);
    v_texture[v] = Kernel::Point_2(1, i);
    v_other[v] = Point(i, i, 1);
  }
  auto h_float = m.template add_property_map<typename M::Halfedge_index, float>("h:float").first;
  for (const auto h : m.halfedges())
    h_float[h] = static_cast<float>(++i);
  auto e_byte = m.template add_property_map<typename M::Edge_index, std::int8_t>("e:byte").first;
  for (const auto e : m.edges())
    e_byte[e] = static_cast<std::int8_t>(++i);
  auto f_double = m.template add_property_map<typename M::Face_index, double>("f:double").first;
  for (const auto f : m.faces())
    f_double[f] = ++i;
}

TEST(Property_maps, follow_from_a_surface_mesh)
{
  Surface_mesh source = sheet(6, 5);
  add_maps(source);
  EXPECT_EQ(test::difference(source, Mesh(source)), "");

  // where elements are only marked as removed, an isolated vertex among them
  Surface_mesh garbage = sheet(6, 5);
  const auto isolated = garbage.add_vertex(Point(-1, -1, -1));
  const auto removed = garbage.add_vertex(Point(-2, -1, -1));
  add_maps(garbage);
  CGAL::Euler::remove_face(garbage.halfedge(Surface_mesh::Face_index(3)), garbage);
  garbage.remove_vertex(removed);
  EXPECT_EQ(test::difference(garbage, Mesh(garbage)), "");
  EXPECT_TRUE(garbage.is_isolated(isolated));
}

TEST(Property_maps, of_bits_texts_and_patches_follow)
{
  Surface_mesh source = sheet(6, 5);
  auto is_feature = source.add_property_map<Surface_mesh::Edge_index, bool>("e:is_feature").first;
  for (const auto e : source.edges())
    is_feature[e] = source.is_border(e);
  auto text = source.add_property_map<Surface_mesh::Face_index, std::string>("f:text").first;
  auto patch = source.add_property_map<Surface_mesh::Face_index, std::pair<int, int> >("f:patch_id").first;
  for (const auto f : source.faces()) {
    text[f] = std::string(source.degree(f), 'x');
    patch[f] = { int(source.degree(f)), 7 };
  }
  struct Odd {};
  source.add_property_map<Surface_mesh::Face_index, Odd>("f:odd");

  const Mesh mesh(source);
  const auto bits = mesh.find_property_map<Mesh::Edge_index, bool>("e:is_feature");
  ASSERT_TRUE(bits);
  for (const auto e : mesh.edges())
    EXPECT_EQ(bits[e], mesh.is_border(e));
  const auto texts = mesh.find_property_map<Mesh::Face_index, std::string>("f:text");
  const auto patches = mesh.find_property_map<Mesh::Face_index, std::pair<int, int> >("f:patch_id");
  ASSERT_TRUE(texts && patches);
  for (const auto f : mesh.faces()) {
    EXPECT_EQ(texts[f].size(), mesh.degree(f));
    EXPECT_EQ(patches[f], std::make_pair(int(mesh.degree(f)), 7));
  }
  EXPECT_EQ(mesh.properties<Mesh::Face_index>().size(), 2u);   // not "f:odd", nor what Surface_mesh keeps for itself
  EXPECT_EQ(mesh.properties<Mesh::Vertex_index>().size(), 1u); // "v:point"
}

template <class Tag, class Range>
void check_dynamic_map(Mesh& mesh, const Range& elements)
{
  auto map = get(Tag(), mesh);
  auto copy = map, other = get(Tag(), mesh);
  for (const auto element : elements) {
    put(map, element, 1);
    put(other, element, 0);
  }
  for (const auto element : elements)
    ASSERT_TRUE(get(copy, element) == 1 && get(other, element) == 0);
}

TEST(Property_maps, that_are_dynamic_leave_the_mesh_alone)
{
  Mesh mesh(sheet(3, 3));
  check_dynamic_map<CGAL::dynamic_vertex_property_t<bool> >(mesh, mesh.vertices());
  check_dynamic_map<CGAL::dynamic_halfedge_property_t<int> >(mesh, mesh.halfedges());
  check_dynamic_map<CGAL::dynamic_edge_property_t<double> >(mesh, mesh.edges());
  check_dynamic_map<CGAL::dynamic_face_property_t<bool> >(mesh, mesh.faces());
  EXPECT_EQ(mesh.properties<Mesh::Vertex_index>().size(), 1u); // "v:point"
  EXPECT_EQ(mesh.properties<Mesh::Halfedge_index>().size() + mesh.properties<Mesh::Edge_index>().size()
              + mesh.properties<Mesh::Face_index>().size(), 0u);
}

// Whether there are the functions of MutableHalfedgeGraph and MutableFaceGraph.
template <class M, class = void>
struct Is_mutable : std::false_type {};

template <class M>
struct Is_mutable<M, std::void_t<decltype(add_vertex(std::declval<M&>())), decltype(add_edge(std::declval<M&>())),
                                 decltype(add_face(std::declval<M&>()))> > : std::true_type {};

template <class M, class = void>
struct Can_remove : std::false_type {};

template <class M>
struct Can_remove<M, std::void_t<decltype(remove_vertex(typename M::Vertex_index(), std::declval<M&>()))> >
  : std::true_type {};

TEST(Interface, has_no_function_that_a_mutable_graph_must_have)
{
  static_assert(Is_mutable<Surface_mesh>::value && !Is_mutable<Mesh>::value, "");
  static_assert(Can_remove<Surface_mesh>::value && !Can_remove<Mesh>::value, "");
}

// A point without a kernel.
struct Plain
{
  int a = 0;
  float b = 0;
};

template <class P, class MakePoint>
void check_points(const MakePoint& make_point)
{
  using M = CGAL::Compact_surface_mesh<P>;
  std::vector<P> points;
  for (int i = 0; i < 6; ++i)
    points.push_back(make_point(i));
  const std::vector<std::vector<int> > faces = { { 0, 1, 2 }, { 2, 1, 4, 3 } };
  std::vector<typename M::Vertex_index> vertices(6);
  M mesh(points, faces, parameters::vertex_to_vertex_map(CGAL::make_property_map(vertices)));
  auto moved = std::move(mesh);
  mesh = moved;
  EXPECT_TRUE(mesh.is_valid());
  const M& constant = mesh;
  for (std::size_t i = 0; i < 6; ++i) {
    static_assert(std::is_same<decltype(mesh.point(vertices[i])), P&>::value, "");
    static_assert(std::is_same<decltype(constant.point(vertices[i])), const P&>::value, "");
    const auto map = get(CGAL::vertex_point, constant);
    EXPECT_EQ(&get(map, vertices[i]), &constant.point(vertices[i]));
    EXPECT_EQ(&constant.points()[vertices[i]], &constant.point(vertices[i]));
    put(CGAL::vertex_point, mesh, vertices[i], make_point(7));
  }
  std::size_t n = 0;
  for (const auto v : CGAL::vertices(mesh))
    n += mesh.degree(v);
  EXPECT_EQ(n, 12u);
  EXPECT_TRUE(mesh.is_isolated(vertices[5]));
}

TEST(Points, may_be_of_any_type)
{
  using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Float_kernel = CGAL::Simple_cartesian<float>;
  check_points<Point>([](int i) { return Point(i, 1, 2); });
  check_points<Exact_kernel::Point_3>([](int i) { return Exact_kernel::Point_3(i, 1, 2); });
  check_points<Float_kernel::Point_3>([](int i) { return Float_kernel::Point_3(float(i), 1, 2); });
  check_points<Kernel::Point_2>([](int i) { return Kernel::Point_2(i, 1); });
  check_points<Plain>([](int i) { return Plain{ i, 1.f }; });

  const CGAL::Compact_surface_mesh<Plain> plain;
  const CGAL::Compact_surface_mesh<Plain, CGAL::Schnyder_parents_layout<5> > copy(plain);
  EXPECT_TRUE(copy.is_empty());
}

// What users derive, as from Surface_mesh.
struct Derived_mesh
  : public CGAL::Compact_surface_mesh<Point>
{
  using Base = CGAL::Compact_surface_mesh<Point>;
  using Base::Base;

  std::string name;
};

template <class P, class Layout>
struct Derived_template
  : public CGAL::Compact_surface_mesh<P, Layout>
{
  using Base = CGAL::Compact_surface_mesh<P, Layout>;
  using Base::Base;
};

} // namespace

#define CGAL_GRAPH_TRAITS_INHERITANCE_CLASS_NAME Derived_mesh
#define CGAL_GRAPH_TRAITS_INHERITANCE_BASE_CLASS_NAME CGAL::Compact_surface_mesh<Point>
#include <CGAL/boost/graph/graph_traits_inheritance_macros.h>

#define CGAL_GRAPH_TRAITS_INHERITANCE_TEMPLATE_PARAMS class P, class Layout
#define CGAL_GRAPH_TRAITS_INHERITANCE_CLASS_NAME Derived_template<P, Layout>
#define CGAL_GRAPH_TRAITS_INHERITANCE_BASE_CLASS_NAME CGAL::Compact_surface_mesh<P, Layout>
#include <CGAL/boost/graph/graph_traits_inheritance_macros.h>

namespace {

template <class M>
void check_derived(const Surface_mesh& source)
{
  M mesh(source);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  auto numbers = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
  for (const auto v : vertices(mesh))
    put(numbers, v, int(degree(v, mesh)));
  const auto indices = get(boost::vertex_index, mesh);
  std::size_t sum = 0;
  for (const auto v : vertices(mesh)) {
    EXPECT_EQ(get(indices, v), v.idx());
    for (const auto u : CGAL::vertices_around_target(halfedge(v, mesh), mesh)) {
      EXPECT_NE(u, v);
      ++sum;
    }
  }
  EXPECT_EQ(sum, num_halfedges(mesh));

  // sliced, a copy: not made anew from a graph, which would number elements anew
  const CGAL::Compact_surface_mesh<Point> sliced(mesh);
  for (const auto h : sliced.halfedges())
    ASSERT_EQ(sliced.next(h), mesh.next(h));
  const M copy(mesh);
  for (const auto h : copy.halfedges())
    ASSERT_EQ(copy.next(h), mesh.next(h));
}

TEST(Derivation, gives_graphs)
{
  const Surface_mesh source = sheet(5, 4);
  check_derived<Derived_mesh>(source);
  check_derived<Derived_template<Point, CGAL::Schnyder_parents_layout<> > >(source);
  // with the property maps of a derived class
  Derived_mesh mesh(source);
  mesh.add_property_map<Mesh::Face_index, int>("f:n", 3);
  const CGAL::Compact_surface_mesh<Point, CGAL::Schnyder_parents_layout<6> > other(mesh);
  EXPECT_EQ(other.properties<Mesh::Face_index>().size(), 1u);
}

TEST(Derivation, is_known_to_generators_with_points)
{
  const Point p(0, 0, 0), q(1, 0, 0), r(0, 1, 0), s(0, 0, 1);
  const auto check = [](auto&& make) {
    Derived_mesh mesh;
    Mesh expected;
    EXPECT_EQ(make(mesh), make(expected));
    EXPECT_EQ(num_halfedges(mesh), num_halfedges(expected));
    EXPECT_GT(num_faces(mesh), 0u);
  };
  check([&](auto& g) { return CGAL::make_triangle(p, q, r, g); });
  check([&](auto& g) { return CGAL::make_quad(p, q, r, s, g); });
  check([&](auto& g) { return CGAL::make_tetrahedron(p, q, r, s, g); });
  check([&](auto& g) { return CGAL::make_hexahedron(p, q, r, s, p, q, r, s, g); });
}

} // namespace
