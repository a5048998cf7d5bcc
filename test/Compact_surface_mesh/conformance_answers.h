// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef TEST_COMPACT_SURFACE_MESH_CONFORMANCE_ANSWERS_H
#define TEST_COMPACT_SURFACE_MESH_CONFORMANCE_ANSWERS_H

// What an algorithm answers about a mesh, in terms that do not depend on the type of the mesh;
// and the expectation that it answers the same about both meshes of a pair.

#include "conformance_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace test {

/// A list of numbers: integers, which have to be equal, and real ones, which may have been
/// summed up in another order.
class Answer
{
public:
  template <class T, std::enable_if_t<std::is_integral<T>::value || std::is_enum<T>::value, int> = 0>
  Answer& operator<<(T value)
  {
    m_integers.push_back(static_cast<long long>(value));
    return *this;
  }

  Answer& operator<<(double value)
  {
    m_reals.push_back(value);
    return *this;
  }

  Answer& operator<<(const Kernel::Point_3& p) { return *this << p.x() << p.y() << p.z(); }
  Answer& operator<<(const Kernel::Vector_3& v) { return *this << v.x() << v.y() << v.z(); }
  Answer& operator<<(const Kernel::Point_2& p) { return *this << p.x() << p.y(); }
  Answer& operator<<(const CGAL::Bbox_3& b)
  {
    return *this << b.xmin() << b.ymin() << b.zmin() << b.xmax() << b.ymax() << b.zmax();
  }

  template <class T, class U>
  Answer& operator<<(const std::pair<T, U>& pair)
  {
    return *this << pair.first << pair.second;
  }

  /// A range, with its length.
  template <class Range, class = typename Range::const_iterator>
  Answer& operator<<(const Range& range)
  {
    *this << static_cast<std::size_t>(std::distance(range.begin(), range.end()));
    for (const auto& value : range)
      *this << value;
    return *this;
  }

  /// The values of a function on elements of a mesh.
  template <class Elements, class Function>
  Answer& on(const Elements& elements, const Function& value)
  {
    for (const auto& element : elements)
      *this << value(element);
    return *this;
  }

  /// The partition of elements into those with equal values, whatever these are.
  template <class Elements, class Function>
  Answer& partition(const Elements& elements, const Function& value)
  {
    typedef std::decay_t<decltype(value(*elements.begin()))> Value;
    std::map<Value, std::size_t> number;
    for (const auto& element : elements)
      *this << number.emplace(value(element), number.size()).first->second;
    return *this;
  }

  bool is_empty() const { return m_integers.empty() && m_reals.empty(); }

  /// What differs first, or nothing. Reals may differ by `tolerance` times the greater of 1, about
  /// the size of the meshes, and their absolute value.
  std::string difference(const Answer& expected, double tolerance) const
  {
    std::ostringstream out;
    if (m_integers.size() != expected.m_integers.size() || m_reals.size() != expected.m_reals.size())
      out << m_integers.size() << " integers and " << m_reals.size() << " reals, not " << expected.m_integers.size()
          << " and " << expected.m_reals.size();
    for (std::size_t i = 0; out.str().empty() && i < m_integers.size(); ++i)
      if (m_integers[i] != expected.m_integers[i])
        out << "integer " << i << " is " << m_integers[i] << ", not " << expected.m_integers[i];
    for (std::size_t i = 0; out.str().empty() && i < m_reals.size(); ++i)
      if (!(std::abs(m_reals[i] - expected.m_reals[i]) <= tolerance * (std::max)(1., std::abs(expected.m_reals[i])))
          && m_reals[i] != expected.m_reals[i]) // infinities
        out << "real " << i << " is " << m_reals[i] << ", off by " << m_reals[i] - expected.m_reals[i];
    return out.str();
  }

private:
  std::vector<long long> m_integers;
  std::vector<double> m_reals;
};

/// Sums in another order.
constexpr double rounding = 1e-12;
/// Solutions of linear systems whose rows are in another order.
constexpr double solving = 1e-9;

/// Expects that `algorithm(m)`, an `Answer`, is the same for the compact mesh and for the
/// Surface_mesh in which all elements have the same indices: exactly the same, even if it depends
/// on the order of elements or on random numbers.
template <class Algorithm>
void expect_same_answer_in_same_order(const Mesh_pair& pair, const Algorithm& algorithm, double tolerance = 0)
{
  const Answer expected = algorithm(pair.twin);
  EXPECT_FALSE(expected.is_empty());
  EXPECT_EQ(algorithm(pair.compact).difference(expected, tolerance), "") << "in the same order on " << pair.name;
}

/// Expects, beside that, the same answer for the mesh that the compact one was made of.
template <class Algorithm>
void expect_same_answer(const Mesh_pair& pair, const Algorithm& algorithm, double tolerance = rounding)
{
  const Answer answer = algorithm(pair.compact), expected = algorithm(pair.expected);
  EXPECT_FALSE(expected.is_empty());
  EXPECT_EQ(answer.difference(expected, tolerance), "") << "on " << pair.name;
  EXPECT_EQ(answer.difference(algorithm(pair.twin), 0), "") << "in the same order on " << pair.name;
}

template <class Algorithm>
void expect_same_answers_in_same_order(const Mesh_pairs& pairs, const Algorithm& algorithm, double tolerance = 0)
{
  for (const Mesh_pair* const pair : pairs)
    expect_same_answer_in_same_order(*pair, algorithm, tolerance);
}

template <class Algorithm>
void expect_same_answers(const Mesh_pairs& pairs, const Algorithm& algorithm, double tolerance = rounding)
{
  for (const Mesh_pair* const pair : pairs)
    expect_same_answer(*pair, algorithm, tolerance);
}

} // namespace test

#endif // TEST_COMPACT_SURFACE_MESH_CONFORMANCE_ANSWERS_H
