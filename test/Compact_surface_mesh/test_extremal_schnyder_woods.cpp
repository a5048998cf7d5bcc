// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// Woods without clockwise or without counterclockwise faces.

#include "closed_surfaces.h"
#include "small_triangulations.h"
#include "test_scale.h"
#include "wooded_mesh.h"

#include <CGAL/Schnyder_woods.h>
#include <CGAL/Schnyder_woods/internal/Rooted_surface.h>
#include <CGAL/Schnyder_woods/internal/mapped_wood.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

using CGAL::Extremal_wood;
using test::Edge;
using test::Face;
using test::Halfedge;
using test::Mesh;
using test::Vertex;
using test::Wooded_mesh;

const Extremal_wood both_extremes[] = { Extremal_wood::WITHOUT_CLOCKWISE_FACES,
                                        Extremal_wood::WITHOUT_COUNTERCLOCKWISE_FACES };

// For each halfedge: color and direction.
typedef std::vector<std::pair<int, bool>> Copies;

Copies copies_of(const Wooded_mesh& w)
{
  Copies copies;
  for (const Halfedge h : w.mesh.halfedges())
    copies.emplace_back(w.color[h], w.outgoing[h]);
  return copies;
}

void make_extremal(Wooded_mesh& w, Extremal_wood which, bool keeps_cut_graph = false)
{
  CGAL::make_schnyder_wood_extremal(w.mesh, w.root, w.color, w.outgoing, w.is_special, which, keeps_cut_graph,
                                    w.further_roots);
}

// The extremal wood of a sphere by the conquests of appendix A of CD18: of the vertices that
// are free, the closest along the boundary to V_1 is conquered, or to V_0 for the mirror image.
// Quadratic time.
class Closest_first_shelling
{
public:
  Closest_first_shelling(const Mesh& mesh, Halfedge root, Extremal_wood which)
    : m_mesh(mesh), m_from_v1(which == Extremal_wood::WITHOUT_CLOCKWISE_FACES),
      m_copies(mesh.number_of_halfedges(), { -1, false }),
      m_boundary{ mesh.source(root), mesh.target(mesh.next(root)), mesh.target(root) },
      m_root_edges{ mesh.edge(root), mesh.edge(mesh.next(root)), mesh.edge(mesh.prev(root)) }
  {}

  Copies operator()()
  {
    while (m_boundary.size() > 2)
      conquer(next_free());
    for (const Edge e : m_root_edges)
      for (const Halfedge h : { m_mesh.halfedge(e), m_mesh.opposite(m_mesh.halfedge(e)) })
        m_copies[h] = { -1, false };
    return m_copies;
  }

private:
  std::size_t next_free() const
  {
    for (std::size_t k = 1; k + 1 < m_boundary.size(); ++k) {
      const std::size_t i = m_from_v1 ? k : m_boundary.size() - 1 - k;
      bool is_free = true;
      for (const Halfedge h : halfedges_around_target(m_mesh.halfedge(m_boundary[i]), m_mesh)) {
        const Vertex u = m_mesh.source(h);
        is_free = is_free && (m_copies[h].first != -1 || u == m_boundary[i - 1] || u == m_boundary[i + 1] ||
                              std::find(m_boundary.begin(), m_boundary.end(), u) == m_boundary.end());
      }
      if (is_free)
        return i;
    }
    throw std::logic_error("no vertex is free");
  }

  void conquer(std::size_t i)
  {
    const Vertex v = m_boundary[i];
    const Halfedge right = m_mesh.halfedge(v, m_boundary[i + 1]), left = m_mesh.halfedge(v, m_boundary[i - 1]);
    set(right, 0);
    set(left, 1);
    std::vector<Vertex> entered;
    for (Halfedge h = m_mesh.opposite(m_mesh.prev(right)); h != left; h = m_mesh.opposite(m_mesh.prev(h))) {
      set(m_mesh.opposite(h), 2);
      entered.push_back(m_mesh.target(h));
    }
    m_boundary.erase(m_boundary.begin() + i);
    m_boundary.insert(m_boundary.begin() + i, entered.rbegin(), entered.rend());
  }

  void set(Halfedge h, int color)
  {
    m_copies[h] = { color, true };
    m_copies[m_mesh.opposite(h)] = { color, false };
  }

  const Mesh& m_mesh;
  const bool m_from_v1;
  Copies m_copies;
  std::vector<Vertex> m_boundary; // from V_1 to V_0
  const std::vector<Edge> m_root_edges;
};

testing::AssertionResult has_extremal_woods_of_closest_first_shellings(const Mesh& mesh, Halfedge root)
{
  for (const Extremal_wood which : both_extremes) {
    const Copies expected = Closest_first_shelling(mesh, root, which)();
    for (const CGAL::Shelling_order order : test::all_orders) {
      Wooded_mesh wooded(mesh, root);
      wooded.shell(order);
      CGAL::make_schnyder_wood_extremal(wooded.mesh, root, wooded.color, wooded.outgoing, which);
      if (copies_of(wooded) != expected)
        return testing::AssertionFailure() << "extreme " << int(which) << ", order " << int(order);
    }
  }
  return testing::AssertionSuccess();
}

TEST(Extremal_woods_of_spheres, are_those_that_the_closest_first_shelling_finds)
{
  for (int n = 4; n <= 8; ++n)
    for (const auto& map : test::all_sphere_triangulations(n))
      for (const auto& rooted : test::Oriented_map(map).all_codes()) {
        const Mesh mesh = test::mesh_of(n, rooted);
        ASSERT_TRUE(has_extremal_woods_of_closest_first_shellings(mesh, mesh.halfedge(Vertex(0), Vertex(1))))
          << testing::PrintToString(rooted);
      }
  for (unsigned int seed = 0; seed < test::scaled(100); ++seed) {
    const std::uint32_t n = 20 + 3 * seed;
    for (const test::Soup& soup : { test::random_triangulation(n, seed), test::stacked_triangulation(n, seed) })
      ASSERT_TRUE(has_extremal_woods_of_closest_first_shellings(test::mesh_of(soup), Halfedge(seed)))
        << "seed " << seed;
  }
  for (const test::Soup& soup : { test::octasphere(3), test::double_wheel(100), test::globe(5, 20) })
    ASSERT_TRUE(has_extremal_woods_of_closest_first_shellings(test::mesh_of(soup), Halfedge(0)));
}

// Asks what there is to know of the woods of a mesh.
class Inspection
{
public:
  explicit Inspection(const Wooded_mesh& w)
    : m_wooded(w), m_surface(w.mesh, w.root, w.further_roots),
      m_wood(CGAL::internal::read_wood(w.mesh, m_surface, w.color, w.outgoing, w.is_special))
  {}

  // Faces off the root face that have their three edges directed around them, with the root
  // edges V_0 V_2, V_1 V_2 and V_1 V_0 in these directions.
  std::set<Face> faces(Extremal_wood without) const
  {
    const bool outgoing = without == Extremal_wood::WITHOUT_COUNTERCLOCKWISE_FACES;
    std::set<Face> result;
    for (std::size_t h = 0; h < m_surface.halfedges.size(); h += 3)
      if (m_wood.is_outgoing(h) == outgoing && m_wood.is_outgoing(h + 1) == outgoing &&
          m_wood.is_outgoing(h + 2) == outgoing)
        result.insert(m_wooded.mesh.face(m_surface.halfedges[h]));
    result.erase(m_wooded.mesh.face(m_wooded.root));
    return result;
  }

  std::set<Face> faces_at_root_edges() const
  {
    const Mesh& mesh = m_wooded.mesh;
    std::set<Face> result;
    for (const Halfedge h : { m_wooded.root, mesh.next(m_wooded.root), mesh.prev(m_wooded.root) })
      result.insert(mesh.face(mesh.opposite(h)));
    return result;
  }

  // Whether the edges of color 2, with the root edges at V_2, lead from every vertex to a root.
  bool leads_to_roots() const
  {
    const std::map<Vertex, Halfedge> parent = red_edges();
    std::set<Vertex> reaching;
    for (Vertex v : m_wooded.mesh.vertices()) {
      std::vector<Vertex> path;
      for (auto it = parent.find(v); reaching.count(v) == 0 && it != parent.end(); it = parent.find(v)) {
        path.push_back(v);
        if (path.size() > m_wooded.mesh.number_of_vertices())
          return false;
        v = m_wooded.mesh.target(it->second);
      }
      reaching.insert(path.begin(), path.end());
    }
    return true;
  }

  // Whether all faces can be reached without crossing an edge of color 2 or a special one.
  bool is_connected_off_cut_graph() const
  {
    std::vector<bool> is_met(m_surface.table.num_faces(), false);
    std::vector<std::uint32_t> stack{ 0 };
    std::size_t num_met = 1;
    is_met[0] = true;
    while (!stack.empty()) {
      const std::uint32_t f = stack.back();
      stack.pop_back();
      for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
        const std::uint32_t neighbor = m_surface.table.opposite(h) / 3;
        if (m_wood.is_special(h) || m_wood.color(h) == CGAL::internal::red || is_met[neighbor])
          continue;
        is_met[neighbor] = true;
        ++num_met;
        stack.push_back(neighbor);
      }
    }
    return num_met == is_met.size();
  }

  // The halfedges of color 2 on the paths from special edges to the roots.
  std::set<Halfedge> core() const
  {
    const std::map<Vertex, Halfedge> parent = red_edges();
    std::vector<Vertex> stack;
    for (std::size_t h = 0; h < m_surface.halfedges.size(); ++h)
      if (m_wood.is_special(h))
        stack.push_back(m_wooded.mesh.source(m_surface.halfedges[h]));
    std::set<Halfedge> result;
    while (!stack.empty()) {
      const auto found = parent.find(stack.back());
      stack.pop_back();
      if (found != parent.end() && result.insert(found->second).second)
        stack.push_back(m_wooded.mesh.target(found->second));
    }
    return result;
  }

private:
  std::map<Vertex, Halfedge> red_edges() const
  {
    std::map<Vertex, Halfedge> result;
    for (std::size_t h = 0; h < m_surface.halfedges.size(); ++h)
      if (m_wood.is_out(h, CGAL::internal::red))
        result[m_wooded.mesh.source(m_surface.halfedges[h])] = m_surface.halfedges[h];
    return result;
  }

  const Wooded_mesh& m_wooded;
  const CGAL::internal::Rooted_surface<Mesh> m_surface;
  const CGAL::internal::Schnyder_wood m_wood;
};

std::set<Face> faces_at(const std::set<Halfedge>& halfedges, const Mesh& mesh)
{
  std::set<Face> result;
  for (const Halfedge h : halfedges) {
    result.insert(mesh.face(h));
    result.insert(mesh.face(mesh.opposite(h)));
  }
  return result;
}

testing::AssertionResult is_subset(const std::set<Face>& faces, const std::set<Face>& of)
{
  if (std::includes(of.begin(), of.end(), faces.begin(), faces.end()))
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << faces.size() << " directed faces, the first one " << *faces.begin();
}

// Of how many woods that were made extremal the global rules do not hold any more.
struct Losses
{
  std::size_t woods = 0;
  std::size_t forests = 0;
  std::size_t disks = 0;                 // where the forest is none of the losses
  std::size_t kept_woods = 0, cells = 0; // where the cut graph was to be kept
};

void expect_extremal_woods_are_right(Wooded_mesh& w, CGAL::Shelling_order order, Losses& losses)
{
  w.shell(order);
  const Copies shelled = copies_of(w);
  const std::set<Halfedge> core = Inspection(w).core();
  const auto restore = [&] {
    for (const Halfedge h : w.mesh.halfedges()) {
      w.color[h] = shelled[h].first;
      w.outgoing[h] = shelled[h].second;
    }
  };
  for (const bool keeps_cut_graph : { false, true }) {
    std::vector<Copies> extremal;
    for (const Extremal_wood which : both_extremes) {
      restore();
      make_extremal(w, which, keeps_cut_graph);
      extremal.push_back(copies_of(w));
      const Inspection inspection(w);
      ASSERT_TRUE(w.is_right(CGAL::Schnyder_wood_rules::LOCAL));
      const bool is_forest = inspection.leads_to_roots(), is_disk = inspection.is_connected_off_cut_graph();
      ASSERT_EQ(w.is_right(CGAL::Schnyder_wood_rules::CUT_GRAPH), is_forest && is_disk);
      std::set<Face> exempt = inspection.faces_at_root_edges();
      if (keeps_cut_graph) {
        ASSERT_TRUE(is_forest && is_disk);
        ++losses.kept_woods;
        losses.cells += w.is_right() ? 0 : 1;
        ASSERT_EQ(inspection.core(), core);
        const std::set<Face> at_core = faces_at(core, w.mesh);
        exempt.insert(at_core.begin(), at_core.end());
      } else {
        ++losses.woods;
        losses.forests += is_forest ? 0 : 1;
        losses.disks += is_forest && !is_disk ? 1 : 0;
      }
      ASSERT_TRUE(is_subset(inspection.faces(which), exempt));
      make_extremal(w, which, keeps_cut_graph);
      ASSERT_EQ(copies_of(w), extremal.back()) << "not idempotent";
    }
    // either extreme can be reached from the other one
    make_extremal(w, both_extremes[0], keeps_cut_graph);
    ASSERT_EQ(copies_of(w), extremal[0]);
    make_extremal(w, both_extremes[1], keeps_cut_graph);
    ASSERT_EQ(copies_of(w), extremal[1]);
  }
}

TEST(Extremal_woods, are_right_on_all_rooted_tori_with_up_to_9_vertices)
{
  Losses losses;
  for (int n = 7; n <= test::largest_exhaustive(); ++n)
    for (const auto& map : test::all_torus_triangulations(n))
      for (const auto& rooted : test::Oriented_map(map).all_codes())
        for (const CGAL::Shelling_order order : test::all_orders) {
          if (n == 9 && order != CGAL::Shelling_order::LAST_IN_FIRST_OUT)
            continue;
          Mesh mesh = test::mesh_of(n, rooted);
          const Halfedge root = mesh.halfedge(Vertex(0), Vertex(1));
          Wooded_mesh wooded(std::move(mesh), root);
          expect_extremal_woods_are_right(wooded, order, losses);
          if (testing::Test::HasFatalFailure())
            FAIL() << testing::PrintToString(rooted) << ", order " << int(order);
        }
}

TEST(Extremal_woods, are_right_on_random_surfaces)
{
  Losses losses;
  for (unsigned int seed = 0; seed < (std::max<std::size_t>)(30, test::scaled(300)); ++seed) {
    const std::uint32_t genus = seed % 50 == 49 ? 30 : seed % 6;
    Mesh mesh = test::mesh_of(test::closed_surface(genus, 4 * genus + 4 + 2 * (seed % 60), seed));
    const Halfedge root = mesh.halfedge(Face(seed % mesh.number_of_faces()));
    std::vector<Vertex> further_roots = test::random_further_roots(mesh, root, seed % 4, seed);
    Wooded_mesh wooded(std::move(mesh), root, further_roots);
    for (const CGAL::Shelling_order order : test::all_orders) {
      expect_extremal_woods_are_right(wooded, order, losses);
      if (testing::Test::HasFatalFailure())
        FAIL() << "seed " << seed << ", order " << int(order);
    }
  }
  // else the checker has met nothing of that kind
  EXPECT_GT(losses.forests, 0u);
  EXPECT_GT(losses.disks, 0u);
  EXPECT_LT(losses.forests + losses.disks, losses.woods);
  EXPECT_GT(losses.cells, 0u);
  EXPECT_LT(losses.cells, losses.kept_woods);
}

TEST(Extremal_woods, are_right_on_regular_surfaces)
{
  Losses losses;
  const std::uint32_t n = static_cast<std::uint32_t>(test::scaled(10000));
  for (const test::Soup& soup : { test::torus_grid(10, n / 10), test::scaffold(3, 1), test::chain_of_tori(n / 8),
                                  test::sphere_with_far_handles(n, n / 1000), test::octasphere(5) })
    for (const CGAL::Shelling_order order : test::all_orders) {
      Wooded_mesh wooded(test::mesh_of(soup));
      expect_extremal_woods_are_right(wooded, order, losses);
      if (testing::Test::HasFatalFailure())
        FAIL() << soup.num_vertices << " vertices, order " << int(order);
    }
}

TEST(Extremal_woods, of_an_empty_mesh_are_empty)
{
  Wooded_mesh empty{ Mesh() };
  make_extremal(empty, Extremal_wood::WITHOUT_CLOCKWISE_FACES);
  EXPECT_TRUE(empty.is_right());
}

} // namespace
