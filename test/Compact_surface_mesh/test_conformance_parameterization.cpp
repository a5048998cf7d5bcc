// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// All parameterizations, of disks and along seams, on both meshes of each pair.

#include "conformance_answers.h"

#include "temporary_file.h"

#include <CGAL/Compact_surface_mesh/internal/versions_of_cgal.h>
#include <CGAL/Schnyder_woods/cut_graph.h>

#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/IO/File_off.h>
#include <CGAL/Surface_mesh_parameterization/Iterative_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Orbifold_Tutte_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/measure_distortion.h>
#include <CGAL/Surface_mesh_parameterization/orbifold_shortest_path.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/Seam_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <list>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace {

using test::Answer;
using test::expect_same_answer;
using test::expect_same_answer_in_same_order;
using test::Kernel;
using test::Mesh_of;
namespace SMP = CGAL::Surface_mesh_parameterization;

/// The border halfedge with the least name.
template <class Named>
typename Named::Halfedge first_border_halfedge(const Named& m)
{
  return *std::find_if(m.halfedges().begin(), m.halfedges().end(),
                       [&m](auto h) { return CGAL::is_border(h, m.mesh); });
}

/// The places of all vertices of the disk, by the parameterizer that `make(mesh)` returns.
template <class Make>
auto places_of_vertices(const Make& make)
{
  return [&make](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    Mesh mesh = m.mesh; // the function takes a reference to a mesh that is not const
    std::map<typename Mesh::Vertex_index, Kernel::Point_2> places;
    const boost::associative_property_map<decltype(places)> uv(places);
    const auto error = SMP::parameterize(mesh, make(mesh), first_border_halfedge(m), uv);
    EXPECT_EQ(error, SMP::OK) << SMP::get_error_message(error);
    return Answer().on(m.vertices(), [&](auto v) { return places.at(v); });
  };
}

template <class Make>
void expect_same_parameterization(const Make& make)
{
  expect_same_answer(test::disk_pair(), places_of_vertices(make), test::solving);
}

/// Makes a parameterizer of any mesh.
template <template <class...> class Parameterizer, template <class...> class... Border>
struct Make
{
  template <class Mesh>
  auto operator()(Mesh&) const { return Parameterizer<Mesh, Border<Mesh>...>(); }
};

TEST(Conformance_parameterization, with_fixed_borders)
{
  using SMP::Circular_border_arc_length_parameterizer_3;
  using SMP::Circular_border_uniform_parameterizer_3;
  using SMP::Square_border_arc_length_parameterizer_3;
  expect_same_parameterization(Make<SMP::Barycentric_mapping_parameterizer_3,
                                    Circular_border_arc_length_parameterizer_3>());
  expect_same_parameterization(Make<SMP::Barycentric_mapping_parameterizer_3,
                                    Circular_border_uniform_parameterizer_3>());
  expect_same_parameterization(Make<SMP::Discrete_authalic_parameterizer_3,
                                    Circular_border_arc_length_parameterizer_3>());
  expect_same_parameterization(Make<SMP::Discrete_conformal_map_parameterizer_3,
                                    Square_border_arc_length_parameterizer_3>());
  expect_same_parameterization(Make<SMP::Mean_value_coordinates_parameterizer_3>());
  expect_same_parameterization(Make<SMP::Iterative_authalic_parameterizer_3>());
}

TEST(Conformance_parameterization, with_free_borders)
{
  expect_same_parameterization(Make<SMP::LSCM_parameterizer_3>());
}

// With lambda > 0, it holds the first vertex of an unordered set.
TEST(Conformance_parameterization, as_rigid_as_possible)
{
  for (const double lambda : {0., 1000.}) {
    const auto make = [lambda](auto& mesh) { return SMP::ARAP_parameterizer_3<std::decay_t<decltype(mesh)>>(lambda); };
    expect_same_answer_in_same_order(test::disk_pair(), places_of_vertices(make));
  }
}

TEST(Conformance_parameterization, distortion)
{
  expect_same_answer(test::disk_pair(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    Mesh mesh = m.mesh;
    std::map<typename Mesh::Vertex_index, Kernel::Point_2> places;
    const boost::associative_property_map<decltype(places)> uv(places);
    const auto border = first_border_halfedge(m);
    EXPECT_EQ(SMP::parameterize(mesh, border, uv), SMP::OK); // mean value coordinates
    return Answer() << SMP::compute_L2_stretch(mesh, uv)
                    << SMP::LSCM_parameterizer_3<Mesh>().is_one_to_one_mapping(mesh, border, uv);
  }, test::solving);
}

/// A mesh with seams, which are known by names.
template <class Named>
class Mesh_with_seams
{
public:
  typedef Mesh_of<Named> Mesh;
  typedef typename boost::property_map<Mesh, CGAL::dynamic_edge_property_t<bool>>::const_type Edge_map;
  typedef typename boost::property_map<Mesh, CGAL::dynamic_vertex_property_t<bool>>::const_type Vertex_map;
  typedef CGAL::Seam_mesh<Mesh, Edge_map, Vertex_map> Seam_mesh;
  typedef typename boost::graph_traits<Seam_mesh>::halfedge_descriptor Seam_halfedge;

  Mesh_with_seams(const Named& named, const std::set<std::size_t>& names_of_seams)
    : m(named), m_is_seam(get(CGAL::dynamic_edge_property_t<bool>(), m.mesh)),
      m_is_on_seam(get(CGAL::dynamic_vertex_property_t<bool>(), m.mesh)),
      seam_mesh(m.mesh, m_is_seam, m_is_on_seam)
  {
    for (const auto e : edges(m.mesh))
      put(m_is_seam, e, false);
    for (const auto v : vertices(m.mesh))
      put(m_is_on_seam, v, false);
    for (const std::size_t name : names_of_seams) {
      const auto h = m.halfedge_of(2 * name);
      seam_mesh.add_seam(source(h, m.mesh), target(h, m.mesh));
    }
    border = opposite(Seam_halfedge(m.halfedge_of(2 * *names_of_seams.begin())), seam_mesh);
    EXPECT_TRUE(CGAL::is_border(border, seam_mesh));
  }

  /// The place of the target of each halfedge, which has several where seams meet.
  template <class HalfedgePlaceMap>
  Answer places(const HalfedgePlaceMap& uv) const
  {
    Answer answer;
    for (const auto h : m.halfedges())
      if (!CGAL::is_border(h, m.mesh))
        answer << get(uv, target(Seam_halfedge(h), seam_mesh));
    return answer;
  }

private:
  const Named& m;
  Edge_map m_is_seam;
  Vertex_map m_is_on_seam;

public:
  Seam_mesh seam_mesh;
  Seam_halfedge border;
};

/// The names of the edges of a cut graph of the surface of genus 3.
const std::set<std::size_t>& cut_of_genus_3()
{
  static const std::set<std::size_t> cut = [] {
    const auto& m = test::genus_3_pair().expected;
    const auto is_cut = get(CGAL::dynamic_edge_property_t<bool>(), m.mesh);
    CGAL::cut_graph(m.mesh, is_cut);
    std::set<std::size_t> names;
    for (const auto e : m.edges())
      if (get(is_cut, e))
        names.insert(m.name(e));
    return names;
  }();
  return cut;
}

template <class Make>
void expect_same_parameterization_along_cut(const Make& make)
{
  expect_same_answer(test::genus_3_pair(), [&make](const auto& m) {
    typedef std::decay_t<decltype(m)> Named;
    typedef typename Named::Halfedge Halfedge;
    Mesh_with_seams<Named> cut(m, cut_of_genus_3());
    std::map<Halfedge, Kernel::Point_2> places;
    const boost::associative_property_map<decltype(places)> uv(places);
    const auto error = SMP::parameterize(cut.seam_mesh, make(cut.seam_mesh), cut.border, uv);
    EXPECT_EQ(error, SMP::OK) << SMP::get_error_message(error);
    return cut.places(uv);
  }, test::solving);
}

TEST(Conformance_parameterization, along_a_cut_graph)
{
  expect_same_parameterization_along_cut(Make<SMP::Mean_value_coordinates_parameterizer_3>());
  expect_same_parameterization_along_cut(Make<SMP::LSCM_parameterizer_3>());
}

// CGAL 6.0 asks for the weight of one halfedge of each edge, which the indices of its ends choose, and border halfedges
// have none: operator() of Cotangent_weight in Weights/cotangent_weights.h. So the order of vertices matters.
TEST(Conformance_parameterization, orbifolds)
{
  const auto places_of_orbifolds = [](const auto& m) {
    typedef std::decay_t<decltype(m)> Named;
    typedef Mesh_of<Named> Mesh;
    Answer answer;
    for (const auto type : {SMP::Square, SMP::Diamond, SMP::Triangle, SMP::Parallelogram}) {
      std::vector<typename Mesh::Vertex_index> cones = {m.vertex(0), m.vertex(60), m.vertex(130)};
      if (type == SMP::Parallelogram)
        cones.push_back(m.vertex(150));
      std::list<typename Mesh::Edge_index> seams;
      SMP::compute_shortest_paths_between_cones(m.mesh, cones.begin(), cones.end(), seams);
      const auto names = m.names(seams);
      answer << names;
      Mesh_with_seams<Named> cut(m, std::set<std::size_t>(names.begin(), names.end()));
      typedef typename Mesh_with_seams<Named>::Seam_mesh Seam_mesh;
      typedef typename boost::graph_traits<Seam_mesh>::vertex_descriptor Seam_vertex;
      std::unordered_map<Seam_vertex, int> index;
      for (const Seam_vertex v : vertices(cut.seam_mesh))
        index.emplace(v, static_cast<int>(index.size()));
      std::unordered_map<Seam_vertex, SMP::Cone_type> cone_types;
      SMP::locate_cones(cut.seam_mesh, cones.begin(), cones.end(), cone_types);
      std::map<typename Mesh::Halfedge_index, Kernel::Point_2> places;
      const boost::associative_property_map<decltype(places)> uv(places);
      SMP::Orbifold_Tutte_parameterizer_3<Seam_mesh> parameterizer(type, SMP::Cotangent);
      const auto error = parameterizer.parameterize(cut.seam_mesh, cut.border, cone_types, uv,
                                                    boost::make_assoc_property_map(index));
      EXPECT_EQ(error, SMP::OK) << SMP::get_error_message(error);
      for (const auto h : m.halfedges())
        answer << get(uv, target(typename Mesh_with_seams<Named>::Seam_halfedge(h), cut.seam_mesh));
    }
    return answer;
  };
  if (CGAL::internal::is_with_cgal_6)
    expect_same_answer_in_same_order(test::sphere_pair(), places_of_orbifolds);
  else
    expect_same_answer(test::sphere_pair(), places_of_orbifolds, test::solving);
}

// By their indices in a file, in the order of the mesh or in that of a map.
TEST(Conformance_parameterization, cones_are_read)
{
  const test::Temporary_file file(".txt");
  file.set_bytes("0 60 130 150");
  const std::string name = file.name();
  expect_same_answer(test::sphere_pair(), [&](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    std::map<typename Mesh::Vertex_index, int> names;
    for (const auto v : m.vertices())
      names[v] = static_cast<int>(m.name(v));
    std::vector<typename Mesh::Vertex_index> cones;
    EXPECT_EQ(SMP::read_cones(m.mesh, name.c_str(), boost::make_assoc_property_map(names), std::back_inserter(cones)),
              SMP::OK);
    return Answer().on(cones, [&](auto v) { return m.name(v); });
  });
  expect_same_answer_in_same_order(test::sphere_pair(), [&](const auto& m) {
    std::vector<typename Mesh_of<decltype(m)>::Vertex_index> cones;
    EXPECT_EQ(SMP::read_cones(m.mesh, name.c_str(), std::back_inserter(cones)), SMP::OK);
    EXPECT_EQ(cones.size(), 4u);
    return Answer().on(cones, [&](auto v) { return m.name(v); });
  });
}

// Which of two cones is the first depends on where the walk along the seam starts.
TEST(Conformance_parameterization, cones_are_located_in_any_order)
{
  expect_same_answer_in_same_order(test::sphere_pair(), [](const auto& m) {
    typedef std::decay_t<decltype(m)> Named;
    typedef Mesh_of<Named> Mesh;
    typedef typename boost::graph_traits<typename Mesh_with_seams<Named>::Seam_mesh>::vertex_descriptor Seam_vertex;
    const std::vector<typename Mesh::Vertex_index> cones = {m.vertex(0), m.vertex(60), m.vertex(130)};
    std::list<typename Mesh::Edge_index> seams;
    SMP::compute_shortest_paths_between_cones(m.mesh, cones.begin(), cones.end(), seams);
    const auto names = m.names(seams);
    const Mesh_with_seams<Named> cut(m, std::set<std::size_t>(names.begin(), names.end()));
    std::unordered_map<Seam_vertex, SMP::Cone_type> types;
    EXPECT_TRUE(SMP::locate_unordered_cones(cut.seam_mesh, cones.begin(), cones.end(), types));
    std::multiset<std::pair<std::size_t, int>> found;
    for (const auto& cone : types)
      found.insert({m.name(typename Mesh::Halfedge_index(cone.first.hd.tmhd)), static_cast<int>(cone.second)});
    EXPECT_EQ(found.size(), 4u);
    return Answer() << found;
  });
}

/// The triangles in a file in the format OFF, in ascending order: the corners of each, from the least one on.
std::multiset<std::vector<double>> triangles_of_off(const std::string& text)
{
  std::istringstream in(text);
  std::string format;
  std::size_t num_vertices = 0, num_faces = 0, num_edges = 0;
  in >> format >> num_vertices >> num_faces >> num_edges;
  std::vector<std::vector<double>> places(num_vertices, std::vector<double>(3));
  for (auto& place : places)
    in >> place[0] >> place[1] >> place[2];
  std::multiset<std::vector<double>> triangles;
  for (std::size_t f = 0; f < num_faces; ++f) {
    std::size_t size = 0, corner = 0;
    in >> size;
    std::vector<std::vector<double>> corners;
    for (std::size_t i = 0; i < size && in >> corner; ++i)
      corners.push_back(places.at(corner));
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    std::vector<double> triangle;
    for (const auto& place : corners)
      triangle.insert(triangle.end(), place.begin(), place.end());
    triangles.insert(triangle);
  }
  EXPECT_TRUE(in);
  return triangles;
}

TEST(Conformance_parameterization, places_are_written)
{
  expect_same_answer(test::disk_pair(), [](const auto& m) {
    typedef Mesh_of<decltype(m)> Mesh;
    const Mesh& mesh = m.mesh;
    std::map<typename Mesh::Vertex_index, Kernel::Point_2> places;
    for (const auto v : m.vertices())
      places[v] = Kernel::Point_2(m.point(v).x(), m.point(v).y());
    const boost::associative_property_map<decltype(places)> uv(places);
    std::ostringstream of_component, of_all;
    SMP::IO::output_uvmap_to_off(mesh, first_border_halfedge(m), uv, of_component);
    SMP::IO::output_uvmap_to_off(mesh, m.vertices(), m.faces(), uv, get(boost::vertex_index, mesh), of_all);
    const auto triangles = triangles_of_off(of_all.str());
    EXPECT_EQ(triangles.size(), num_faces(mesh));
    EXPECT_TRUE(triangles == triangles_of_off(of_component.str()));
    return Answer() << triangles;
  }, 0);
}

} // namespace
