// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef BENCHMARK_COMPACT_SURFACE_MESH_PAPERS_FIGURES_H
#define BENCHMARK_COMPACT_SURFACE_MESH_PAPERS_FIGURES_H

// What the papers report, number by number:
//   CD18  L. Castelli Aleardi, O. Devillers, Array-based compact data structures for triangulations, 2018
//   LR    T. Gurung, M. Luffel, P. Lindstrom, J. Rossignac, LR: compact connectivity representation for
//         triangle meshes, 2011
// A test checks the transcription by the averages, medians and formulas that the papers give as well. The bars of
// CD18's figure 14 have no numbers, so there are none here but for the range that its text tells.

#include <array>
#include <cstddef>

namespace papers {

/// A row of CD18's table 1, or what its text and LR say of a structure; empty where they say nothing.
/// References are for `n` vertices, `d` is the degree of the vertex.
struct Stated_costs
{
  const char* structure; ///< our name of it
  const char* source;
  const char* references; ///< or bits per vertex, of `laced-ring-offsets`
  const char* navigation;
  const char* vertex_access;
  const char* adjacency;
};

inline constexpr std::array<Stated_costs, 11> stated_costs{ {
    { "half-edge", "CD18 table 1", "18n + n", "O(1)", "O(1)", "O(d)" },
    { "winged-edge", "CD18 table 1", "18n + n", "O(1)", "O(1)", "O(d)" },
    { "corner-table", "CD18 table 1", "12n + n", "O(1)", "O(1)", "O(d)" },
    { "sot", "CD18 table 1", "6n", "O(1)", "O(d)", "O(d)" },
    { "squad", "CD18 4.4", "4.05n to 4.3n", "", "", "" },
    { "laced-ring", "CD18 4.4, LR abstract", "2.04n to 3.16n", "O(1)", "O(1)", "" },
    { "laced-ring-offsets", "CD18 1.2, LR abstract", "37 to 90", "O(1)", "O(1)", "" },
    { "schnyder-fronts-6n", "CD18 theorem 2", "6n", "O(1)", "O(d)", "O(d)" },
    { "schnyder-fronts-5n", "CD18 theorem 4", "5n", "O(1)", "O(d)", "O(d)" },
    { "schnyder-fronts-4n", "CD18 theorem 5", "4n", "O(1)", "O(d)", "O(d)" },
    { "schnyder-fronts-5n-targets", "CD18 theorem 6", "5n", "O(1)", "O(1)", "O(1)" },
} };

/// A row of CD18's table 2, the columns of construction, in seconds. Sizes of a million vertices and more are
/// rounded there.
struct Construction_times
{
  std::size_t num_vertices;
  double half_edges; ///< "building data structure from OFF"
  double wood;       ///< "compute SW"
  double layout;     ///< "building CDS6n"
};

inline constexpr std::array<Construction_times, 15> construction_times{ {
    { 8268, 0.015, 0.005, 0.007 },     { 26002, 0.046, 0.010, 0.012 },   { 49922, 0.063, 0.019, 0.019 },
    { 195557, 0.154, 0.036, 0.080 },   { 476596, 0.30, 0.06, 0.14 },     { 655980, 0.53, 0.11, 0.17 },
    { 773465, 0.55, 0.12, 0.18 },      { 1100000, 0.69, 0.18, 0.28 },    { 1600000, 1.01, 0.24, 0.35 },
    { 2500000, 1.75, 0.30, 0.46 },     { 5000000, 3.97, 0.58, 0.93 },    { 7500000, 5.15, 0.86, 1.36 },
    { 10000000, 8.16, 1.16, 1.49 },    { 12500000, 30.39, 1.54, 2.36 },  { 15000000, 32.58, 1.83, 2.68 },
} };

/// A row of CD18's table 3: vertex degrees, in ns per vertex.
struct Degree_times
{
  const char* mesh;
  double half_edge, winged_edge, cds6n_slow, cds6n, cds5n, cds4n;
};

inline constexpr std::array<Degree_times, 12> degree_times{ {
    { "Egea", 25, 30, 52, 41, 81, 75 },
    { "Bunny", 29, 33, 45, 34, 74, 64 },
    { "Iphigenia", 27, 31, 50, 38, 77, 57 },
    { "Camille's hand", 87, 62, 47, 34, 57, 53 },
    { "Eros", 24, 20, 38, 28, 63, 45 },
    { "Chinese dragon", 24, 22, 41, 30, 56, 44 },
    { "Pierre's hand", 15, 14, 32, 22, 57, 43 },
    { "Isidore horse", 20, 19, 37, 27, 56, 57 },
    { "Hand (poisson)", 27, 27, 51, 39, 67, 61 },
    { "Random 100K vert.", 34, 29, 55, 46, 76, 71 },
    { "Random 2.5M vert.", 38, 33, 62, 49, 93, 91 },
    { "Random 5M vert.", 39, 33, 63, 51, 93, 91 },
} };

/// Which column of CD18's table 3 is about which structure of ours.
struct Degree_column
{
  const char* structure;
  double Degree_times::*ns;
};

inline constexpr std::array<Degree_column, 5> degree_columns{ {
    { "half-edge", &Degree_times::half_edge },
    { "winged-edge", &Degree_times::winged_edge },
    { "schnyder-fronts-6n", &Degree_times::cds6n },
    { "schnyder-fronts-5n", &Degree_times::cds5n },
    { "schnyder-fronts-4n", &Degree_times::cds4n },
} };

/// CD18 4.2: how much slower than winged-edge on average, for degrees; and the range for normals, which it gives
/// for its structures together.
struct Average_ratio
{
  const char* structure;
  double degree;
};

inline constexpr std::array<Average_ratio, 3> average_ratios{ {
    { "schnyder-fronts-6n", 1.33 },
    { "schnyder-fronts-5n", 2.65 },
    { "schnyder-fronts-4n", 2.31 },
} };

inline constexpr const char* average_ratio_of_normals = "1.5 to 2.5";

/// A row of LR's table 1: percentages of vertices of valence 6 and of kinds of triangles, references (rpt) and bits
/// (bpt) per triangle. An irregular triangle is adjacent to a T_0, a long one has an offset too large for 16 bits.
struct Ring_costs
{
  const char* mesh;
  std::size_t num_triangles;
  double valence_6;
  double t0, t_irregular, laced_ring_rpt; ///< the standard form
  double squad_rpt;
  double bits_t0, bits_t_long, bits_t_irregular, laced_ring_bpt; ///< the bit-efficient form
};

inline constexpr std::array<Ring_costs, 10> ring_costs{ {
    { "bunny", 69451, 75.1, 0.41, 1.14, 1.062, 2.054, 0.63, 3.94, 1.81, 20.27 },
    { "rocker arm", 80354, 65.2, 0.39, 1.06, 1.055, 2.054, 0.40, 1.71, 1.10, 18.37 },
    { "horse", 96966, 66.5, 0.39, 1.05, 1.055, 2.046, 0.61, 8.61, 1.72, 21.59 },
    { "dinosaur", 112384, 57.9, 0.75, 2.02, 1.106, 2.072, 1.35, 12.83, 3.66, 26.21 },
    { "armadillo", 345944, 52.6, 0.52, 1.41, 1.074, 2.069, 1.26, 13.72, 3.44, 26.12 },
    { "hand", 654666, 53.4, 1.17, 3.12, 1.164, 2.096, 1.92, 28.84, 5.15, 33.86 },
    { "buddha", 1087716, 32.1, 4.26, 10.95, 1.583, 2.150, 4.78, 26.12, 12.22, 45.26 },
    { "welsh dragon", 2210378, 86.7, 0.14, 0.38, 1.020, 2.027, 0.87, 18.84, 2.52, 26.12 },
    { "thai statue", 10000000, 44.4, 1.85, 4.96, 1.260, 2.111, 2.39, 23.73, 6.42, 34.35 },
    { "david", 55514795, 51.6, 0.63, 1.64, 1.089, 2.082, 1.21, 23.06, 3.28, 28.89 },
} };

} // namespace papers

#endif // BENCHMARK_COMPACT_SURFACE_MESH_PAPERS_FIGURES_H
