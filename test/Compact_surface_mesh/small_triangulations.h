// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_SMALL_TRIANGULATIONS_H
#define TEST_COMPACT_SURFACE_MESH_SMALL_TRIANGULATIONS_H

// All simple triangulations of the sphere with few vertices, and the canonical
// code by which oriented triangulated surfaces, of any topology, are told apart.
//
// The enumeration walks the graph of edge flips, which is connected (Wagner,
// Bemerkungen zum Vierfarbenproblem, 1936), and keeps one triangulation of each
// class of isomorphisms that preserve the orientation.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace test {

using Triangle = std::array<std::uint32_t, 3>;
using Triangles = std::vector<Triangle>;

/// A triangulated surface, given as a soup of consistently oriented triangles.
/// Halfedge c runs from corner c, the vertex c % 3 of triangle c / 3, to the next
/// corner of that triangle. There must be at most one halfedge from one vertex to
/// another; double edges have no place here.
class Oriented_map
{
public:
  /// The opposite of a halfedge on the border.
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  explicit Oriented_map(Triangles triangles)
    : m_triangles(std::move(triangles)), m_opposite(num_halfedges(), none)
  {
    using Ends_and_halfedge = std::pair<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>;
    std::vector<Ends_and_halfedge> halfedges;
    for (std::uint32_t h = 0; h < num_halfedges(); ++h)
      halfedges.push_back({{source(h), target(h)}, h});
    std::sort(halfedges.begin(), halfedges.end());
    for (std::uint32_t h = 0; h < num_halfedges(); ++h) {
      const std::pair<std::uint32_t, std::uint32_t> reversed(target(h), source(h));
      const auto it = std::lower_bound(halfedges.begin(), halfedges.end(),
                                       Ends_and_halfedge(reversed, 0));
      if (it != halfedges.end() && it->first == reversed)
        m_opposite[h] = it->second;
      m_num_vertices = (std::max)(m_num_vertices, source(h) + 1);
    }
  }

  const Triangles& triangles() const { return m_triangles; }
  std::uint32_t num_halfedges() const { return static_cast<std::uint32_t>(3 * m_triangles.size()); }
  std::uint32_t source(std::uint32_t h) const { return m_triangles[h / 3][h % 3]; }
  std::uint32_t target(std::uint32_t h) const { return source(next(h)); }
  std::uint32_t opposite(std::uint32_t h) const { return m_opposite[h]; }
  static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }

  /// The triangles that are connected to `root` by edges, listed and turned in the
  /// order in which a breadth-first search from halfedge `root` enters them, with
  /// vertices numbered in the order in which they appear: a code that two rooted
  /// maps share if and only if an isomorphism that preserves the orientation takes
  /// root to root. Linear time.
  Triangles code(std::uint32_t root) const
  {
    std::vector<std::uint32_t> number(m_num_vertices, none);
    std::vector<bool> is_entered(m_triangles.size(), false);
    std::vector<std::uint32_t> entries(1, root);
    std::uint32_t num_numbers = 0;
    Triangles result;
    is_entered[root / 3] = true;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      std::uint32_t h = entries[i];
      result.emplace_back();
      for (std::uint32_t& v : result.back()) {
        if (number[source(h)] == none)
          number[source(h)] = num_numbers++;
        v = number[source(h)];
        const std::uint32_t o = opposite(h);
        if (o != none && !is_entered[o / 3]) {
          is_entered[o / 3] = true;
          entries.push_back(o);
        }
        h = next(h);
      }
    }
    return result;
  }

  /// The codes from all halfedges, without repetition, in ascending order. The
  /// first one is the canonical code of the map without root; their number is that
  /// of the different ways to root it, that is, the number of halfedges divided by
  /// the number of automorphisms that preserve the orientation.
  std::vector<Triangles> all_codes() const
  {
    std::vector<Triangles> codes;
    for (std::uint32_t h = 0; h < num_halfedges(); ++h)
      codes.push_back(code(h));
    std::sort(codes.begin(), codes.end());
    codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
    return codes;
  }

private:
  Triangles m_triangles;
  std::vector<std::uint32_t> m_opposite;
  std::uint32_t m_num_vertices = 0;
};

/// The least code over all halfedges, itself a soup of the same surface: two
/// connected surfaces share it if and only if they are isomorphic as oriented maps.
/// Quadratic time.
inline Triangles canonical_code(const Triangles& triangles)
{
  const Oriented_map map(triangles);
  Triangles least = map.code(0);
  for (std::uint32_t h = 1; h < map.num_halfedges(); ++h)
    least = (std::min)(least, map.code(h));
  return least;
}

/// The mirror image: each triangle turned over.
inline Triangles mirrored(Triangles triangles)
{
  for (Triangle& t : triangles)
    std::swap(t[1], t[2]);
  return triangles;
}

/// The triangulation in which vertices 0 and 1 are neighbors of each other and of
/// all vertices of the path 2, ..., n - 1.
inline Triangles double_fan(std::uint32_t n)
{
  Triangles triangles{{0, 1, 2}, {1, 0, n - 1}};
  for (std::uint32_t v = 2; v + 1 < n; ++v) {
    triangles.push_back({0, v, v + 1});
    triangles.push_back({1, v + 1, v});
  }
  return triangles;
}

/// Where the edge of halfedge `h` can be replaced by the other diagonal of its two
/// triangles without a double edge, does that to `triangles` and returns true.
inline bool flip(const Oriented_map& map, std::uint32_t h, Triangles& triangles)
{
  const std::uint32_t o = map.opposite(h);
  const std::uint32_t a = map.source(h), b = map.target(h);
  const std::uint32_t left = map.target(map.next(h)), right = map.target(map.next(o));
  for (std::uint32_t i = 0; i < map.num_halfedges(); ++i)
    if (map.source(i) == left && map.target(i) == right)
      return false;
  triangles[h / 3] = {a, right, left};
  triangles[o / 3] = {b, left, right};
  return true;
}

/// All simple triangulations that flips lead to from a closed connected one, one of each
/// class of oriented maps, by their canonical codes in ascending order.
inline std::vector<Triangles> reachable_by_flips(const Triangles& start)
{
  std::set<Triangles> found{canonical_code(start)};
  std::vector<Triangles> to_flip(found.begin(), found.end());
  while (!to_flip.empty()) {
    const Oriented_map map(std::move(to_flip.back()));
    to_flip.pop_back();
    for (std::uint32_t h = 0; h < map.num_halfedges(); ++h) {
      Triangles flipped = map.triangles();
      if (h > map.opposite(h) || !flip(map, h, flipped))
        continue;
      const auto insertion = found.insert(canonical_code(flipped));
      if (insertion.second)
        to_flip.push_back(*insertion.first);
    }
  }
  return std::vector<Triangles>(found.begin(), found.end());
}

/// All simple triangulations of the sphere with n >= 4 vertices, one of each class
/// of oriented maps, by their canonical codes in ascending order.
inline std::vector<Triangles> all_sphere_triangulations(int n)
{
  if (n < 4)
    throw std::invalid_argument("a simple triangulation of the sphere has 4 vertices or more");
  return reachable_by_flips(double_fan(static_cast<std::uint32_t>(n)));
}

/// The number of different rooted triangulations of these classes.
inline std::size_t rooted_count(const std::vector<Triangles>& classes)
{
  std::size_t count = 0;
  for (const Triangles& triangles : classes)
    count += Oriented_map(triangles).all_codes().size();
  return count;
}

/// The number of these classes when mirror images count as one.
inline std::size_t unoriented_count(const std::vector<Triangles>& classes)
{
  std::set<Triangles> unoriented;
  for (const Triangles& triangles : classes)
    unoriented.insert((std::min)(canonical_code(triangles), canonical_code(mirrored(triangles))));
  return unoriented.size();
}

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_SMALL_TRIANGULATIONS_H
