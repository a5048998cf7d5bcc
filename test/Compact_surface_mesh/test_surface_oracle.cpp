// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The oracle that other tests ask about layouts of surfaces of all kinds: does it agree with
// Surface_mesh, and does it see each wrong answer?

#include "damaged_soups.h"
#include "generated_surfaces.h"
#include "surface_oracle.h"
#include "test_scale.h"

#include <CGAL/Compact_surface_mesh/layouts/internal/for_each_face_from.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using test::Polygon_soup;

// The layout concept over Surface_mesh, as far as the oracle goes.
class Surface_mesh_layout
{
  typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
  typedef Mesh::Vertex_index V;
  typedef Mesh::Halfedge_index H;
  typedef Mesh::Edge_index E;
  typedef Mesh::Face_index F;

public:
  typedef std::uint32_t Index;
  static constexpr bool edge_is_half_of_halfedge = true;
  static constexpr Index null_index() { return static_cast<Index>(-1); }

  explicit Surface_mesh_layout(const Polygon_soup& soup)
  {
    for (std::size_t v = 0; v < soup.num_vertices; ++v)
      m_mesh.add_vertex();
    for (const auto& face : soup.faces) {
      std::vector<V> vertices;
      for (const long long v : face)
        vertices.push_back(V(static_cast<Index>(v)));
      m_is_complete = m_is_complete && m_mesh.add_face(vertices) != Mesh::null_face();
    }
  }

  // whether it has taken all faces: it may refuse some where several fans meet
  bool is_complete() const { return m_is_complete; }

  std::size_t num_vertices() const { return m_mesh.number_of_vertices(); }
  std::size_t num_halfedges() const { return m_mesh.number_of_halfedges(); }
  std::size_t num_edges() const { return m_mesh.number_of_edges(); }
  std::size_t num_faces() const { return m_mesh.number_of_faces(); }

  Index next(Index h) const { return m_mesh.next(H(h)); }
  Index prev(Index h) const { return m_mesh.prev(H(h)); }
  Index opposite(Index h) const { return m_mesh.opposite(H(h)); }
  Index source(Index h) const { return m_mesh.source(H(h)); }
  Index target(Index h) const { return m_mesh.target(H(h)); }
  Index face(Index h) const { return m_mesh.face(H(h)); }
  Index edge(Index h) const { return m_mesh.edge(H(h)); }
  Index halfedge_of_edge(Index e) const { return m_mesh.halfedge(E(e)); }
  Index halfedge_of_vertex(Index v) const { return m_mesh.halfedge(V(v)); }
  Index halfedge_of_face(Index f) const { return m_mesh.halfedge(F(f)); }
  Index halfedge(Index u, Index v) const
  {
    return m_mesh.halfedge(V(u)) == Mesh::null_halfedge() ? null_index() : Index(m_mesh.halfedge(V(u), V(v)));
  }
  Index degree(Index v) const
  {
    return m_mesh.halfedge(V(v)) == Mesh::null_halfedge() ? 0 : static_cast<Index>(m_mesh.degree(V(v)));
  }

  template <class Visitor>
  void for_each_adjacent_vertex(Index v, Visitor&& visit) const
  {
    for_each_halfedge(v, [&](H h) { visit(Index(m_mesh.source(h))); });
  }

  template <class Visitor>
  void for_each_incident_triangle(Index v, Visitor&& visit) const
  {
    for_each_halfedge(v, [&](H h) {
      if (!m_mesh.is_border(h))
        visit(Index(m_mesh.target(m_mesh.next(h))), Index(m_mesh.source(h)));
    });
  }

  Index vertex_of_face(Index f) const { return target(halfedge_of_face(f)); }

  std::array<Index, 3> vertices_of_face(Index f) const
  {
    const H h = m_mesh.halfedge(F(f));
    return vertices_of_triangle(h);
  }

  template <class Visitor>
  void for_each_face(Visitor&& visit) const
  {
    CGAL::internal::for_each_face_from(0, *this, visit);
  }

  bool is_in_triangle(Index h) const { return !m_mesh.is_border(H(h)) && next(next(next(h))) == h; }
  std::array<Index, 3> vertices_of_triangle(Index h) const { return {{target(h), target(next(h)), source(h)}}; }

private:
  // the halfedges to v
  template <class Visitor>
  void for_each_halfedge(Index v, const Visitor& visit) const
  {
    if (m_mesh.halfedge(V(v)) != Mesh::null_halfedge())
      for (const H h : m_mesh.halfedges_around_target(m_mesh.halfedge(V(v))))
        visit(h);
  }

  Mesh m_mesh;
  bool m_is_complete = true;
};

// What the concept has, in its order.
enum Operator
{
  NUM_VERTICES, NUM_HALFEDGES, NUM_EDGES, NUM_FACES,
  NEXT, PREV, OPPOSITE, SOURCE, TARGET, FACE, EDGE,
  HALFEDGE_OF_EDGE, HALFEDGE_OF_VERTEX, HALFEDGE_OF_FACE, VERTEX_OF_FACE, HALFEDGE,
  ADJACENT_VERTICES, INCIDENT_TRIANGLES, DEGREE, VERTICES_OF_FACE, EACH_FACE,
  IS_IN_TRIANGLE, VERTICES_OF_TRIANGLE, NUM_OPERATORS
};

// A layout with some answers replaced by others. In whole stars and faces, the answer takes
// the place of the first vertex; null_index() makes that visit fall out.
template <bool EdgeIsHalfOfHalfedge>
class Damaged_layout_with
{
public:
  typedef Surface_mesh_layout::Index Index;
  typedef std::map<std::pair<Operator, std::size_t>, Index> Answers; // to operators at elements
  static constexpr bool edge_is_half_of_halfedge = EdgeIsHalfOfHalfedge;
  static constexpr Index null_index() { return Surface_mesh_layout::null_index(); }

  Damaged_layout_with(const Surface_mesh_layout& sound, const Answers& answers) : m_sound(sound), m_answers(answers) {}

  std::size_t num_vertices() const { return answer(NUM_VERTICES, 0, m_sound.num_vertices()); }
  std::size_t num_halfedges() const { return answer(NUM_HALFEDGES, 0, m_sound.num_halfedges()); }
  std::size_t num_edges() const { return answer(NUM_EDGES, 0, m_sound.num_edges()); }
  std::size_t num_faces() const { return answer(NUM_FACES, 0, m_sound.num_faces()); }

  Index next(Index h) const { return answer(NEXT, h, m_sound.next(h)); }
  Index prev(Index h) const { return answer(PREV, h, m_sound.prev(h)); }
  Index opposite(Index h) const { return answer(OPPOSITE, h, m_sound.opposite(h)); }
  Index source(Index h) const { return answer(SOURCE, h, m_sound.source(h)); }
  Index target(Index h) const { return answer(TARGET, h, m_sound.target(h)); }
  Index face(Index h) const { return answer(FACE, h, m_sound.face(h)); }
  Index edge(Index h) const { return answer(EDGE, h, m_sound.edge(h)); }
  Index halfedge_of_edge(Index e) const { return answer(HALFEDGE_OF_EDGE, e, m_sound.halfedge_of_edge(e)); }
  Index halfedge_of_vertex(Index v) const { return answer(HALFEDGE_OF_VERTEX, v, m_sound.halfedge_of_vertex(v)); }
  Index halfedge_of_face(Index f) const { return answer(HALFEDGE_OF_FACE, f, m_sound.halfedge_of_face(f)); }
  Index vertex_of_face(Index f) const { return answer(VERTEX_OF_FACE, f, m_sound.vertex_of_face(f)); }
  Index halfedge(Index u, Index v) const
  {
    return answer(HALFEDGE, u * m_sound.num_vertices() + v, m_sound.halfedge(u, v));
  }
  Index degree(Index v) const { return answer(DEGREE, v, m_sound.degree(v)); }

  template <class Visitor>
  void for_each_adjacent_vertex(Index v, Visitor&& visit) const
  {
    bool is_first = true;
    m_sound.for_each_adjacent_vertex(v, [&](Index u) {
      const Index w = is_first ? answer(ADJACENT_VERTICES, v, u) : u;
      is_first = false;
      if (w != null_index())
        visit(w);
    });
  }

  template <class Visitor>
  void for_each_incident_triangle(Index v, Visitor&& visit) const
  {
    bool is_first = true;
    m_sound.for_each_incident_triangle(v, [&](Index u, Index w) {
      const Index x = is_first ? answer(INCIDENT_TRIANGLES, v, u) : u;
      is_first = false;
      if (x != null_index())
        visit(x, w);
    });
  }

  std::array<Index, 3> vertices_of_face(Index f) const
  {
    std::array<Index, 3> vertices = m_sound.vertices_of_face(f);
    vertices[0] = answer(VERTICES_OF_FACE, f, vertices[0]);
    return vertices;
  }

  template <class Visitor>
  void for_each_face(Visitor&& visit) const
  {
    m_sound.for_each_face([&](Index f, Index u, Index v, Index w) {
      const Index x = answer(EACH_FACE, f, u);
      if (x != null_index())
        visit(f, x, v, w);
    });
  }

  bool is_in_triangle(Index h) const { return answer(IS_IN_TRIANGLE, h, Index(m_sound.is_in_triangle(h))) != 0; }
  std::array<Index, 3> vertices_of_triangle(Index h) const
  {
    std::array<Index, 3> vertices = m_sound.vertices_of_triangle(h);
    vertices[1] = answer(VERTICES_OF_TRIANGLE, h, vertices[1]);
    return vertices;
  }

private:
  template <class Value>
  Value answer(Operator op, std::size_t element, Value otherwise) const
  {
    const auto it = m_answers.find({op, element});
    return it == m_answers.end() ? otherwise : it->second;
  }

  const Surface_mesh_layout& m_sound;
  const Answers m_answers;
};

typedef Damaged_layout_with<false> Damaged_layout;

std::vector<std::uint32_t> all_vertices(const Polygon_soup& soup)
{
  std::vector<std::uint32_t> vertices(soup.num_vertices);
  std::iota(vertices.begin(), vertices.end(), 0u);
  return vertices;
}

// The halfedges of the sides of all faces, in their order.
std::vector<std::uint32_t> all_sides(const Polygon_soup& soup, const Surface_mesh_layout& layout)
{
  std::vector<std::uint32_t> sides;
  for (const auto& face : soup.faces)
    for (std::size_t i = 0; i < face.size(); ++i)
      sides.push_back(layout.halfedge(static_cast<std::uint32_t>(face[i]),
                                      static_cast<std::uint32_t>(face[(i + 1) % face.size()])));
  return sides;
}

template <class Layout>
std::string difference(const Layout& layout, const Polygon_soup& soup)
{
  return test::Surface_oracle<Layout>(layout, soup, all_vertices(soup)).difference();
}

std::string difference(const Surface_mesh_layout& sound, const Damaged_layout::Answers& answers,
                       const Polygon_soup& soup)
{
  return difference(Damaged_layout(sound, answers), soup);
}

bool has_several_fans_at_a_vertex(const Polygon_soup& soup)
{
  const test::Soup_halfedges halfedges(soup);
  std::vector<bool> has_fan(soup.num_vertices, false);
  for (std::size_t h = halfedges.num_sides(); h < halfedges.num_halfedges(); ++h) {
    if (has_fan[halfedges.source(h)])
      return true;
    has_fan[halfedges.source(h)] = true;
  }
  return false;
}

// Surfaces that are small enough for the oracle to look at all pairs of vertices.
Polygon_soup small_surface(unsigned int seed)
{
  test::Surface_options options;
  options.max_vertices = 15;
  options.max_genus = 1;
  return test::random_surface(seed, options);
}

TEST(Surface_oracle, agrees_with_surface_mesh_on_random_surfaces)
{
  std::size_t num_complete = 0, num_with_fans = 0;
  for (unsigned int seed = 0; seed < test::scaled(2000); ++seed) {
    const Polygon_soup soup = test::random_surface(seed);
    const Surface_mesh_layout layout(soup);
    if (!layout.is_complete())
      continue;
    ++num_complete;
    num_with_fans += has_several_fans_at_a_vertex(soup) ? 1 : 0;
    test::Surface_oracle<Surface_mesh_layout> oracle(layout, soup, all_vertices(soup), all_sides(soup, layout));
    ASSERT_EQ(oracle.difference(), "") << "seed " << seed << ", " << soup;
  }
  EXPECT_GT(num_complete, test::scaled(2000) / 2);
  EXPECT_GT(num_with_fans, test::scaled(2000) / 10);
}

TEST(Surface_oracle, agrees_with_surface_mesh_on_large_and_on_empty_surfaces)
{
  for (const Polygon_soup& soup :
       {Polygon_soup{0, {}}, Polygon_soup{5, {}}, test::polygon(test::scaled(100000)), test::pillow(1000),
        test::quad_grid(200, 100), test::soup_of(test::sphere_with_far_handles(20000, 200)),
        test::soup_of(test::mesh_with_borders(20000, 100, 1)), test::soup_of(test::many_components(20000, 100, 1))})
    EXPECT_EQ(difference(Surface_mesh_layout(soup), soup), "") << soup.num_vertices;
}

// Whether another answer than that of `sound` is one that the concept allows.
bool is_allowed(const Surface_mesh_layout& sound, Operator op, std::uint32_t element, std::uint32_t answer)
{
  if (answer >= sound.num_halfedges())
    return false;
  switch (op) {
  case HALFEDGE_OF_EDGE: return sound.edge(answer) == element;
  case HALFEDGE_OF_FACE: return sound.face(answer) == element && sound.next(sound.next(sound.next(answer))) != answer;
  case HALFEDGE_OF_VERTEX:
    return sound.target(answer) == element
           && (sound.face(answer) == sound.null_index())
                == (sound.face(sound.halfedge_of_vertex(element)) == sound.null_index());
  default: return false;
  }
}

// How many questions `op` can be asked.
std::size_t num_elements(const Surface_mesh_layout& sound, Operator op)
{
  switch (op) {
  case NUM_VERTICES: case NUM_HALFEDGES: case NUM_EDGES: case NUM_FACES: return 1;
  case HALFEDGE_OF_EDGE: return sound.num_edges();
  case HALFEDGE_OF_FACE: case VERTEX_OF_FACE: case VERTICES_OF_FACE: case EACH_FACE: return sound.num_faces();
  case HALFEDGE_OF_VERTEX: case ADJACENT_VERTICES: case INCIDENT_TRIANGLES: case DEGREE: return sound.num_vertices();
  case HALFEDGE: return sound.num_vertices() * sound.num_vertices();
  default: return sound.num_halfedges();
  }
}

// The answer of `sound` that a damaged one takes the place of.
std::uint32_t sound_answer(const Surface_mesh_layout& sound, Operator op, std::uint32_t i)
{
  const std::uint32_t n = static_cast<std::uint32_t>(sound.num_vertices());
  std::uint32_t first = sound.null_index();
  const auto keep_first = [&](std::uint32_t u) { first = first == sound.null_index() ? u : first; };
  switch (op) {
  case NUM_VERTICES: return n;
  case NUM_HALFEDGES: return static_cast<std::uint32_t>(sound.num_halfedges());
  case NUM_EDGES: return static_cast<std::uint32_t>(sound.num_edges());
  case NUM_FACES: return static_cast<std::uint32_t>(sound.num_faces());
  case NEXT: return sound.next(i);
  case PREV: return sound.prev(i);
  case OPPOSITE: return sound.opposite(i);
  case SOURCE: return sound.source(i);
  case TARGET: return sound.target(i);
  case FACE: return sound.face(i);
  case EDGE: return sound.edge(i);
  case HALFEDGE_OF_EDGE: return sound.halfedge_of_edge(i);
  case HALFEDGE_OF_VERTEX: return sound.halfedge_of_vertex(i);
  case HALFEDGE_OF_FACE: return sound.halfedge_of_face(i);
  case VERTEX_OF_FACE: return sound.vertex_of_face(i);
  case HALFEDGE: return sound.halfedge(i / n, i % n);
  case ADJACENT_VERTICES: sound.for_each_adjacent_vertex(i, keep_first); return first;
  case INCIDENT_TRIANGLES:
    sound.for_each_incident_triangle(i, [&](std::uint32_t u, std::uint32_t) { keep_first(u); });
    return first;
  case DEGREE: return sound.degree(i);
  case IS_IN_TRIANGLE: return sound.is_in_triangle(i);
  case VERTICES_OF_TRIANGLE: return sound.vertices_of_triangle(i)[1];
  default: return sound.vertices_of_face(i)[0];
  }
}

// Whether the oracle asks that question and the answer makes a difference.
bool is_asked(const Surface_mesh_layout& sound, Operator op, std::uint32_t element)
{
  if (op == ADJACENT_VERTICES || op == INCIDENT_TRIANGLES)
    return sound.degree(element) != 0;
  if (op == VERTICES_OF_TRIANGLE || op == IS_IN_TRIANGLE)
    return sound.is_in_triangle(element) == (op == VERTICES_OF_TRIANGLE); // it may not be known
  if (op != VERTICES_OF_FACE)
    return true;
  const std::uint32_t h = sound.halfedge_of_face(element);
  return sound.next(sound.next(sound.next(h))) == h;
}

TEST(Surface_oracle, sees_each_wrong_answer_of_each_operator)
{
  std::array<std::size_t, NUM_OPERATORS> num_wrong{};
  std::mt19937 rng(1);
  for (unsigned int seed = 0; seed < test::scaled(200); ++seed) {
    const Polygon_soup soup = small_surface(seed);
    const Surface_mesh_layout sound(soup);
    if (!sound.is_complete())
      continue;
    ASSERT_EQ(difference(sound, {}, soup), "");
    for (int i = 0; i < NUM_OPERATORS; ++i) {
      const Operator op = static_cast<Operator>(i);
      const std::size_t n = num_elements(sound, op);
      for (std::size_t tries = n == 0 ? 0 : 20; tries > 0; --tries) {
        const std::uint32_t element = static_cast<std::uint32_t>(rng() % n);
        const std::uint32_t answer =
            rng() % 8 == 0 ? sound.null_index() : static_cast<std::uint32_t>(rng() % (sound.num_halfedges() + 2));
        if (!is_asked(sound, op, element) || answer == sound_answer(sound, op, element)
            || is_allowed(sound, op, element, answer))
          continue;
        ++num_wrong[static_cast<std::size_t>(op)];
        ASSERT_NE(difference(sound, {{{op, element}, answer}}, soup), "")
            << "operator " << op << " at " << element << ": " << answer << ", seed " << seed << ", " << soup;
      }
    }
  }
  for (int i = 0; i < NUM_OPERATORS; ++i)
    EXPECT_GE(num_wrong[static_cast<std::size_t>(i)], test::scaled(200)) << i;
}

TEST(Surface_oracle, sees_hidden_diagonals_and_edges_on_large_meshes)
{
  for (const Polygon_soup& soup : {test::quad_grid(10, 10), test::soup_of(test::octasphere(2))}) {
    const Surface_mesh_layout sound(soup);
    const std::uint32_t n = static_cast<std::uint32_t>(sound.num_vertices());
    for (std::uint32_t h = 0; h < sound.num_halfedges(); ++h) {
      if (sound.face(h) == sound.null_index() || sound.face(sound.opposite(h)) == sound.null_index())
        continue;
      // across the face of h or, where that is a triangle, across h
      std::uint32_t u = sound.source(h);
      const std::uint32_t v = sound.target(sound.next(h));
      if (sound.halfedge(u, v) != sound.null_index())
        u = sound.target(sound.next(sound.opposite(h)));
      EXPECT_NE(difference(sound, {{{HALFEDGE, u * n + v}, h}}, soup), "") << u << " " << v;
    }
  }
}

TEST(Surface_oracle, sees_wrong_reports)
{
  const Polygon_soup soup = test::torus();
  const Surface_mesh_layout layout(soup);
  std::vector<std::uint32_t> vertices = all_vertices(soup), sides = all_sides(soup, layout);
  const auto difference = [&] {
    return test::Surface_oracle<Surface_mesh_layout>(layout, soup, vertices, sides).difference();
  };
  EXPECT_EQ(difference(), "");
  std::swap(sides[3], sides[4]);
  EXPECT_EQ(difference(), "reported halfedge at halfedge 0, 3");
  std::swap(sides[3], sides[4]);
  sides.pop_back();
  EXPECT_EQ(difference(), "number of reported halfedges");
  sides.clear();
  std::swap(vertices[0], vertices[1]);
  EXPECT_NE(difference(), "");
  vertices[1] = vertices[0];
  EXPECT_EQ(difference(), "reported vertex at vertex 1");
  vertices.pop_back();
  EXPECT_EQ(difference(), "number of reported vertices");
}

TEST(Surface_oracle, sees_a_mirror_image_and_a_soup_of_other_faces)
{
  // all counts and all edges are the same
  Polygon_soup other = test::torus();
  for (auto& face : other.faces)
    std::reverse(face.begin(), face.end());
  EXPECT_NE(difference(Surface_mesh_layout(test::torus()), other), "");
}

TEST(Surface_oracle, lets_edges_have_any_names_unless_they_are_halves_of_halfedges)
{
  const Polygon_soup soup = test::tetrahedron();
  const Surface_mesh_layout sound(soup);
  const Damaged_layout::Answers swapped = {{{EDGE, 0}, 1},           {{EDGE, 1}, 1},
                                           {{EDGE, 2}, 0},           {{EDGE, 3}, 0},
                                           {{HALFEDGE_OF_EDGE, 0}, 2}, {{HALFEDGE_OF_EDGE, 1}, 0}};
  EXPECT_EQ(difference(Damaged_layout_with<false>(sound, swapped), soup), "");
  EXPECT_EQ(difference(Damaged_layout_with<true>(sound, {}), soup), "");
  EXPECT_NE(difference(Damaged_layout_with<true>(sound, swapped), soup), "");
}

// `num_fans` triangles around vertex 0.
Polygon_soup fans(long long num_fans)
{
  Polygon_soup soup{static_cast<std::size_t>(2 * num_fans + 1), {}};
  for (long long i = 0; i < num_fans; ++i)
    soup.faces.push_back({0, 2 * i + 1, 2 * i + 2});
  return soup;
}

// Lets each border halfedge to vertex 0 go on where that of the fan `shift` places further goes.
Damaged_layout::Answers turned_fans(const Surface_mesh_layout& sound, std::size_t shift)
{
  std::vector<std::uint32_t> borders;
  for (std::uint32_t h = 0; h < sound.num_halfedges(); ++h)
    if (sound.face(h) == sound.null_index() && sound.target(h) == 0)
      borders.push_back(h);
  Damaged_layout::Answers answers;
  for (std::size_t i = 0; i < borders.size(); ++i) {
    const std::uint32_t next = sound.next(borders[(i + shift) % borders.size()]);
    answers[{NEXT, borders[i]}] = next;
    answers[{PREV, next}] = borders[i];
  }
  return answers;
}

TEST(Surface_oracle, sees_that_next_and_prev_go_by_different_orders_of_fans)
{
  const Polygon_soup soup = fans(3);
  const Surface_mesh_layout sound(soup);
  std::map<std::string, int> answers;
  for (std::size_t shift = 0; shift < 3; ++shift) {
    Damaged_layout::Answers only_next;
    for (const auto& answer : turned_fans(sound, shift))
      if (answer.first.first == NEXT)
        only_next.insert(answer);
    ++answers[difference(sound, only_next, soup)];
  }
  EXPECT_EQ(answers[""], 1); // the order of the sound layout
  EXPECT_EQ(answers.size(), 2u);
}

TEST(Surface_oracle, lets_several_fans_follow_each_other_in_any_order_but_in_one_cycle)
{
  std::map<std::string, int> answers;
  for (const long long num_fans : {2, 3, 4, 5}) {
    const Polygon_soup soup = fans(num_fans);
    const Surface_mesh_layout sound(soup);
    ASSERT_TRUE(sound.is_complete());
    for (std::size_t shift = 0; shift < static_cast<std::size_t>(num_fans); ++shift)
      ++answers[difference(sound, turned_fans(sound, shift), soup)];
  }
  // From fan to fan, one may go by each number of places that has no divisor in common with
  // theirs: 1 + 2 + 2 + 4 ways; by others there are several cycles.
  EXPECT_EQ(answers, (std::map<std::string, int>{{"", 9}, {"cycle around vertex at vertex 0", 5}}));
}

} // namespace
