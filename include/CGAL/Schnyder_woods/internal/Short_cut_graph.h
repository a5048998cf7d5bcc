// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_SCHNYDER_WOODS_INTERNAL_SHORT_CUT_GRAPH_H
#define CGAL_SCHNYDER_WOODS_INTERNAL_SHORT_CUT_GRAPH_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <CGAL/Schnyder_woods/internal/Shortest_path_forest.h>
#include <CGAL/Schnyder_woods/internal/Surface_to_cut.h>
#include <CGAL/Schnyder_woods/internal/prune_graph.h>

#include <CGAL/Random.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace internal {

// Cuts a surface along short graphs, and keeps the shortest one of each component.
//
// A graph comes from some sources: base points and punctures. Of the edges that are on no
// shortest path to a source, a spanning tree of the dual graph takes those that would
// close the longest arcs between sources first. Across its edges the faces are glued together,
// to an open disk; all other edges are the cut graph, after what dangles is pruned.
//
// The arcs that are left are a shortest set of generators of the homology relative to the
// sources. So a graph is straightened if its branchings are the sources: it consists of such
// generators, hence is not shorter than the new ones, which may overlap on top of that.
template <class FaceGraph>
class Short_cut_graph
{
public:
  typedef std::uint32_t Index;

  Short_cut_graph(const Surface_to_cut<FaceGraph>& surface)
    : m_surface(surface), m_edges(surface.edges()), m_is_puncture(surface.punctures()),
      m_paths(surface.num_nodes(), m_edges, std::vector<char>(m_edges.size(), true)),
      m_trial(m_edges.size()), m_best(m_edges.size()), m_is_improved(surface.num_components()),
      m_best_weight(surface.num_components(), (std::numeric_limits<double>::infinity)())
  {}

  // Tries `num_trials` base points in each component, and then as often to improve the shortest
  // graph: by straightening, or if that has just failed by a base point on it.
  void operator()(std::size_t num_trials, CGAL::Random& random)
  {
    for (std::size_t i = 0; i < num_trials; ++i)
      try_sources([&](std::size_t c, std::vector<Index>& sources) {
        sources.push_back(i == 0 ? first_base(c) : any_base(c, random));
      });
    m_is_improved.assign(m_is_improved.size(), true);
    for (std::size_t i = 0; i < num_trials; ++i)
      try_sources([&](std::size_t c, std::vector<Index>& sources) {
        if (m_is_improved[c])
          add_branchings(c, sources);
        else
          sources.push_back(base_on_best(c, random));
      });
  }

  bool is_cut(Index e) const { return m_best[e]; }

  double weight() const { return std::accumulate(m_best_weight.begin(), m_best_weight.end(), 0.); }

private:
  // A puncture is a source anyway: there is then no other one.
  Index first_base(std::size_t c) const
  {
    const Component_to_cut& component = m_surface.component(c);
    return component.first_node + (component.is_punctured ? 0 : 1);
  }

  Index any_base(std::size_t c, CGAL::Random& random) const
  {
    const Index first = m_surface.component(c).first_node, last = m_surface.component(c + 1).first_node - 1;
    return first == last ? first : random.uniform_int<Index>(first + 1, last);
  }

  Index base_on_best(std::size_t c, CGAL::Random& random) const
  {
    std::vector<Index> cut;
    for (Index e = m_surface.component(c).first_edge; e < m_surface.component(c + 1).first_edge; ++e)
      if (m_best[e])
        cut.push_back(e);
    return m_edges[cut[random.uniform_int<std::size_t>(0, cut.size() - 1)]].nodes[random.get_bool()];
  }

  // The nodes where three edges of the graph meet, or more.
  void add_branchings(std::size_t c, std::vector<Index>& sources) const
  {
    const Index first = m_surface.component(c).first_node;
    std::vector<std::size_t> degree(m_surface.component(c + 1).first_node - first, 0);
    for (Index e = m_surface.component(c).first_edge; e < m_surface.component(c + 1).first_edge; ++e)
      if (m_best[e])
        for (const Index v : m_edges[e].nodes)
          ++degree[v - first];
    for (Index i = 0; i < degree.size(); ++i)
      if (degree[i] >= 3)
        sources.push_back(first + i);
  }

  template <class AddSources>
  void try_sources(const AddSources& add_sources)
  {
    std::vector<Index> sources;
    for (std::size_t c = 0; c < m_surface.num_components(); ++c) {
      if (m_surface.component(c).is_punctured)
        sources.push_back(m_surface.component(c).first_node);
      add_sources(c, sources);
    }
    std::sort(sources.begin(), sources.end());
    sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
    m_paths.grow(sources);
    m_trial.assign(m_edges.size(), true);
    join_faces();
    prune_graph(m_surface.num_nodes(), [&](std::size_t e) { return m_edges[e].nodes; },
                [&](std::size_t v) { return m_is_puncture[v]; }, m_trial);
    keep_what_is_better();
  }

  // Kruskal's algorithm for the dual graph.
  void join_faces()
  {
    struct Candidate
    {
      double length;
      Index edge;
      bool operator<(const Candidate& other) const
      {
        return length != other.length ? length > other.length : edge < other.edge;
      }
    };
    std::vector<char> is_on_path(m_edges.size(), false);
    for (Index v = 0; v < m_surface.num_nodes(); ++v)
      if (m_paths.parent_edge(v) != Shortest_path_forest::none)
        is_on_path[m_paths.parent_edge(v)] = true;
    std::vector<Candidate> candidates;
    for (Index e = 0; e < m_edges.size(); ++e)
      if (!is_on_path[e])
        candidates.push_back({ m_paths.distance(m_edges[e].nodes[0]) + m_paths.distance(m_edges[e].nodes[1])
                                   + m_edges[e].weight,
                               e });
    std::sort(candidates.begin(), candidates.end());

    std::vector<Index> parent(m_surface.num_faces());
    std::iota(parent.begin(), parent.end(), Index(0));
    std::vector<unsigned char> rank(parent.size(), 0);
    const boost::typed_identity_property_map<Index> identity;
    boost::disjoint_sets joined(boost::make_iterator_property_map(rank.begin(), identity),
                                boost::make_iterator_property_map(parent.begin(), identity));
    for (const Candidate& candidate : candidates) {
      const auto& [f, g] = m_edges[candidate.edge].faces;
      if (joined.find_set(f) != joined.find_set(g)) {
        joined.union_set(f, g);
        m_trial[candidate.edge] = false;
      }
    }
  }

  void keep_what_is_better()
  {
    for (std::size_t c = 0; c < m_surface.num_components(); ++c) {
      const Index first = m_surface.component(c).first_edge, last = m_surface.component(c + 1).first_edge;
      double weight = 0;
      for (Index e = first; e < last; ++e)
        if (m_trial[e])
          weight += m_edges[e].weight;
      m_is_improved[c] = weight < m_best_weight[c];
      if (m_is_improved[c]) {
        m_best_weight[c] = weight;
        std::copy(m_trial.begin() + first, m_trial.begin() + last, m_best.begin() + first);
      }
    }
  }

  const Surface_to_cut<FaceGraph>& m_surface;
  const std::vector<Edge_to_cut>& m_edges;
  const std::vector<char> m_is_puncture;
  Shortest_path_forest m_paths;
  std::vector<char> m_trial, m_best, m_is_improved;
  std::vector<double> m_best_weight;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_SCHNYDER_WOODS_INTERNAL_SHORT_CUT_GRAPH_H
