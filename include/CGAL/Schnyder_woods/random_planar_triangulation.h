// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_RANDOM_PLANAR_TRIANGULATION_H
#define CGAL_SCHNYDER_WOODS_RANDOM_PLANAR_TRIANGULATION_H

// Simple triangulations of the sphere with n vertices and a root halfedge, drawn
// uniformly, by the bijection of Poulalhon and Schaeffer (Optimal coding and
// sampling of triangulations, Algorithmica 46, 2006): a plane tree of n - 2 nodes,
// each with two stems, closes in exactly one way to a triangulation with a marked
// edge, whose ends are the two vertices that are not nodes. The data flow:
//   random word -> (cycle lemma) -> plane tree with stems -> (closure) -> triangles.

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Compact_surface_mesh/Mesh_defect_exception.h>
#include <CGAL/Random.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {

// A word of `size` letters of which `num_ones` are ones, each with the same
// probability: Floyd's method for a random subset, one number for each one.
inline std::vector<bool> random_binary_word(std::size_t size, std::size_t num_ones, CGAL::Random& rng)
{
  std::vector<bool> word(size, false);
  for (std::uint64_t last = size - num_ones; last < size; ++last) {
    const std::uint64_t any = rng.uniform_int<std::uint64_t>(0, last);
    word[static_cast<std::size_t>(word[static_cast<std::size_t>(any)] ? last : any)] = true;
  }
  return word;
}

// Where a word must be cut for the letters, +3 for a one and -1 for a zero, to
// reach their sum, -2, at the last letter and no earlier: behind the first minimum
// of the partial sums (cycle lemma).
inline std::size_t start_of_tree(const std::vector<bool>& word)
{
  std::ptrdiff_t sum = 0, least = 0;
  std::size_t start = 0;
  for (std::size_t i = 0; i < word.size(); ++i) {
    sum += word[i] ? 3 : -1;
    if (sum < least) {
      least = sum;
      start = i + 1;
    }
  }
  return start % word.size();
}

// The closure of a plane tree with two stems at each node. It is told the contour
// of the tree, which it follows with the tree on its left, as a sequence of stems
// and sides (a tree edge has two sides); it knows nothing of the tree otherwise.
//
// A stem that is followed by two sides bends to the end of the second one: this
// makes a triangle, and the stem is a side henceforth. Stems outnumber sides by
// two, always; so in the end, when each stem is followed by at most one side, two
// stems are followed by none: two nodes hold two neighboring stems each. These two
// nodes part the contour into two arcs, of which each gets one of the vertices 0
// and 1 to bend its stems to. The edge between 0 and 1 completes the triangulation.
template <class Index>
class Stem_tree_closure
{
public:
  using Triangle = std::array<Index, 3>;

  Stem_tree_closure(std::size_t num_nodes, Index root)
    : m_node(root)
  {
    m_triangles.reserve(2 * num_nodes);
    m_triangles.push_back(Triangle()); // the root triangle: the last one to be known
  }

  // The contour meets a stem of the node where it is.
  void add_stem() { m_stems.push_back(m_node); }

  // The contour follows a side from the node where it is to `target`.
  void walk_to(Index target)
  {
    while (!m_stems.empty() && m_stems.back() != m_node) {
      m_triangles.push_back(Triangle{{m_stems.back(), m_node, target}});
      m_node = m_stems.back();
      m_stems.pop_back();
    }
    if (m_stems.empty())
      m_first_sides.push_back(target);
    m_node = target;
  }

  // The contour is complete. The root triangle is that of vertices 0, 1 and the
  // first or the second node that holds two neighboring stems.
  std::vector<Triangle> close(bool root_at_second)
  {
    // The stems at the end of the contour are followed by the sides at its start.
    const std::vector<Index> first_sides = std::move(m_first_sides);
    m_first_sides.clear();
    for (const Index target : first_sides)
      walk_to(target);

    bend_stems_to_apices(root_at_second);
    return std::move(m_triangles);
  }

private:
  bool is_followed_by_stem(std::size_t i) const
  {
    return m_stems[i] == m_stems[i + 1 == m_stems.size() ? 0 : i + 1];
  }

  void bend_stems_to_apices(bool root_at_second)
  {
    std::size_t last = 0; // the first of the two stems of the root triangle's node
    while (!is_followed_by_stem(last))
      ++last;
    if (root_at_second)
      do { ++last; } while (!is_followed_by_stem(last));
    std::rotate(m_stems.begin(), m_stems.begin() + (last + 1), m_stems.end());

    Index apex = 0, other_apex = 1;
    for (std::size_t i = 0; i + 1 < m_stems.size(); ++i) {
      if (is_followed_by_stem(i)) {
        m_triangles.push_back(Triangle{{m_stems[i], other_apex, apex}});
        std::swap(apex, other_apex);
      } else {
        m_triangles.push_back(Triangle{{m_stems[i], m_stems[i + 1], apex}});
      }
    }
    m_triangles.front() = Triangle{{0, 1, m_stems.back()}};
  }

  std::vector<Triangle> m_triangles;
  // The nodes of the stems that are still open. Each is followed by at most one
  // side, which leads to the node of the next stem, or to `m_node` behind the last
  // stem; so there is a side where the two nodes differ.
  std::vector<Index> m_stems;
  std::vector<Index> m_first_sides; // ends of the sides before the first open stem
  Index m_node;                     // where the contour is
};

// The rooted triangulation of a word of 4 N - 2 letters, N - 1 of them ones, with
// N + 2 vertices. When `root_at_second` is drawn, too, each triangulation has the
// same number 2 N (2 N - 1) of preimages: the rotations of the word times the N
// nodes that the tree can be written from.
//
// From its start, the word tells the contour of the tree, from which the nodes are
// numbered in depth-first order: a one leads to a new child; the first two zeros at
// a node are its stems, the third one leads back to the parent.
template <class Index>
std::vector<std::array<Index, 3> >
triangulation_of_word(const std::vector<bool>& word, bool root_at_second)
{
  const std::size_t num_nodes = (word.size() + 2) / 4;
  Index node = 2;
  Stem_tree_closure<Index> closure(num_nodes, node);
  std::vector<Index> path(3, node); // a node stands there once for each zero that it awaits
  const std::size_t start = start_of_tree(word);
  for (std::size_t i = 0, letter = start; i < word.size(); ++i) {
    if (word[letter]) {
      path.insert(path.end(), 3, ++node);
      closure.walk_to(node);
    } else {
      const Index last = path.back();
      path.pop_back();
      if (path.back() == last)
        closure.add_stem();
      else
        closure.walk_to(path.back());
    }
    if (++letter == word.size())
      letter = 0;
  }
  return closure.close(root_at_second);
}

} // namespace internal

/*!
\ingroup PkgSchnyderWoodsRef

returns a random simple triangulation of the sphere, uniformly distributed among
the rooted ones with `num_vertices` vertices.

The result is a range of `2 * num_vertices - 4` triangles, oriented
counterclockwise, whose vertices are all of 0, ..., `num_vertices - 1`; it is
closed, connected, of genus 0, and has no loops and no double edges (with three
vertices, it is the two sides of a triangle).

The root is the halfedge from vertex 0 to vertex 1; its face is the first
triangle, `{0, 1, x}`. Two triangulations are the same rooted triangulation if an
isomorphism that preserves the orientation takes root to root; there are
\f$ 2 (4n - 11)! / ((n - 2)!\, (3n - 7)!) \f$ of them with \f$ n \f$ vertices
(Tutte): 1, 1, 3, 13, 68, ... for \f$ n = 3, 4, 5, 6, 7, \dots \f$. Each has the same
probability, up to the quality of `rng`. The other vertices are numbered in
depth-first order of the spanning tree that the triangulation is made from: the
numbering is a function of the random numbers, not of the triangulation, and as
vertex orders go it is a local one.

In a large random triangulation, a vertex has degree \f$ i \geq 3 \f$ with
probability \f$ \frac{16 (i - 2)}{i} \binom{2i - 2}{i - 1}
\left(\frac{3}{16}\right)^i \f$.

The construction is the bijection of Poulalhon and Schaeffer, <em>Optimal coding
and sampling of triangulations</em>, Algorithmica 46 (2006), with plane trees that
have two stems at each node. It takes linear time and no recursion. Beside the
result, it needs half a byte a vertex and three stacks, whose size is linear at worst
and about \f$ \sqrt{n} \f$ in practice.

All randomness comes from `rng`: `num_vertices - 3` integers, uniform in ranges of
at most `4 * num_vertices - 10` values, and one integer of two values.

\tparam Index an unsigned integer type.

\param num_vertices the number of vertices
\param rng the source of randomness; the same state gives the same triangulation

\pre `num_vertices >= 3`

\throws Mesh_defect_exception with `Mesh_defect::too_many_elements` and
`num_vertices` if the number of halfedges, `6 * num_vertices - 12`, exceeds the
largest value of `Index`.
*/
template <class Index = std::uint32_t>
std::vector<std::array<Index, 3> >
random_planar_triangulation(std::size_t num_vertices, CGAL::Random& rng)
{
  static_assert(std::is_integral<Index>::value && std::is_unsigned<Index>::value,
                "Index must be an unsigned integer type");
  CGAL_precondition(num_vertices >= 3);
  const std::size_t num_nodes = num_vertices - 2;
  if (num_nodes > (std::numeric_limits<Index>::max)() / 6)
    throw Mesh_defect_exception(Mesh_defect::too_many_elements, num_vertices);

  const std::vector<bool> word = internal::random_binary_word(4 * num_nodes - 2, num_nodes - 1, rng);
  // Not get_bool(), which gives a low bit of a linear congruential generator.
  const bool root_at_second = rng.uniform_int<int>(0, 1) == 1;
  return internal::triangulation_of_word<Index>(word, root_at_second);
}

} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_RANDOM_PLANAR_TRIANGULATION_H
