// The Schnyder wood and a canonical ordering of a mesh of any type of CGAL's.

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Schnyder_woods.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <iterator>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Polyhedron_3<Kernel> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
typedef boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;

int main()
{
  Mesh mesh;
  CGAL::make_icosahedron<Mesh, Kernel::Point_3>(mesh);

  const auto color = get(CGAL::dynamic_halfedge_property_t<int>(), mesh);
  const auto outgoing = get(CGAL::dynamic_halfedge_property_t<bool>(), mesh);
  const halfedge_descriptor root = CGAL::schnyder_wood(mesh, color, outgoing);
  std::cout << "a Schnyder wood: " << std::boolalpha << CGAL::is_schnyder_wood(mesh, root, color, outgoing) << '\n';

  std::array<int, 3> num_edges_of_color = {};
  for (const halfedge_descriptor h : halfedges(mesh))
    if (get(outgoing, h))
      ++num_edges_of_color[get(color, h)];
  std::cout << "edges of color 0, 1, 2: " << num_edges_of_color[0] << ", " << num_edges_of_color[1] << ", "
            << num_edges_of_color[2] << '\n';

  std::vector<vertex_descriptor> ordering;
  CGAL::canonical_ordering(mesh, root, std::back_inserter(ordering));
  std::cout << "a canonical ordering starts at " << ordering[0]->point() << " and ends at "
            << ordering.back()->point() << '\n';

  const auto position = get(CGAL::dynamic_vertex_property_t<std::array<std::size_t, 3>>(), mesh);
  CGAL::schnyder_drawing(mesh, root, color, outgoing, position);
  std::cout << "places on the grid for a drawing without crossings:";
  for (const vertex_descriptor v : ordering)
    std::cout << " (" << get(position, v)[0] << ',' << get(position, v)[1] << ')';
  std::cout << '\n';
}
