// A program outside of the package: it knows the installed package only.

#include <CGAL/Compact_surface_mesh.h>

#include <array>
#include <cstdlib>
#include <iostream>
#include <vector>

int main()
{
  using Point = std::array<double, 3>;
  const std::vector<Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  const std::vector<std::array<int, 3>> triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };

  const CGAL::Compact_surface_mesh<Point> mesh(points, triangles);
  std::cout << num_vertices(mesh) << " vertices, " << num_edges(mesh) << " edges, "
            << num_faces(mesh) << " faces" << std::endl;
  return num_vertices(mesh) == 4 && num_edges(mesh) == 6 && num_faces(mesh) == 4
    ? EXIT_SUCCESS : EXIT_FAILURE;
}
