// A g-Schnyder wood of a torus, and the cut graph that comes with it.
//
//   g_schnyder_wood_example [columns rows [picture.svg]]
//
// The torus is a regular grid, of 6 times 5 vertices if not said otherwise. The picture shows
// it on a rectangle whose opposite sides are the same.

#include "torus_svg.h"

#include <CGAL/property_map.h>
#include <CGAL/Schnyder_woods.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

int main(int argc, char* argv[])
{
  example::Torus_grid grid = { 6, 5 };
  if (argc > 2)
    grid = { std::atoi(argv[1]), std::atoi(argv[2]) };
  if (argc == 2 || argc > 4 || grid.columns < 3 || grid.rows < 3) {
    std::cerr << "usage: " << argv[0] << " [columns rows [picture.svg]], at least 3 times 3\n";
    return EXIT_FAILURE;
  }
  Mesh mesh = grid.mesh<Mesh>();

  const auto color = mesh.add_property_map<Mesh::Halfedge_index, int>("h:color").first;
  const auto outgoing = mesh.add_property_map<Mesh::Halfedge_index, bool>("h:outgoing").first;
  const auto is_special = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_special").first;
  const Mesh::Halfedge_index root = mesh.halfedge(*mesh.faces_begin());
  CGAL::g_schnyder_wood(mesh, root, color, outgoing, is_special, CGAL::Shelling_order::FIRST_IN_FIRST_OUT);
  const bool is_wood = CGAL::is_g_schnyder_wood(mesh, root, color, outgoing, is_special);

  const auto is_cut = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_cut").first;
  CGAL::cut_graph_of_schnyder_wood(mesh, root, color, is_special, is_cut);
  std::vector<std::vector<Mesh::Halfedge_index>> loops;
  CGAL::cut_graph_loops(mesh, is_cut, std::back_inserter(loops), CGAL::parameters::edge_weight_map(
      CGAL::Constant_property_map<Mesh::Edge_index, int>(1)));

  std::array<int, 3> num_edges_of_color = {};
  for (const Mesh::Edge_index e : mesh.edges())
    if (!is_special[e] && color[mesh.halfedge(e)] >= 0)
      ++num_edges_of_color[static_cast<std::size_t>(color[mesh.halfedge(e)])];
  std::cout << mesh.number_of_vertices() << " vertices, a g-Schnyder wood: " << std::boolalpha << is_wood
            << "\nedges of color 0, 1, 2: " << num_edges_of_color[0] << ", " << num_edges_of_color[1] << ", "
            << num_edges_of_color[2] << "\nspecial edges: "
            << std::count_if(mesh.edges().begin(), mesh.edges().end(),
                             [&](Mesh::Edge_index e) { return is_special[e]; })
            << "\nedges of the cut graph: "
            << std::count_if(mesh.edges().begin(), mesh.edges().end(), [&](Mesh::Edge_index e) { return is_cut[e]; })
            << "; its loops have";
  for (const auto& loop : loops)
    std::cout << ' ' << loop.size();
  std::cout << " edges\n";

  if (argc > 3) {
    std::ofstream out(argv[3]);
    example::Torus_drawing(grid, mesh, root, color, outgoing, is_special, is_cut).write(out);
    if (!out.flush()) {
      std::cerr << "cannot write " << argv[3] << '\n';
      return EXIT_FAILURE;
    }
  }
  return is_wood ? EXIT_SUCCESS : EXIT_FAILURE;
}
