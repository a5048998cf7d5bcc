// A compact mesh from points and triples of indices, among CGAL's algorithms.

#include <CGAL/Compact_surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <iostream>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Compact_surface_mesh<Kernel::Point_3> Mesh;

int main()
{
  const std::vector<Kernel::Point_3> points = { { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 },
                                                { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
  std::vector<std::array<int, 3>> triangles = { { 4, 0, 1 }, { 4, 1, 2 }, { 4, 2, 3 }, { 4, 3, 0 },
                                                { 5, 1, 0 }, { 5, 2, 1 }, { 5, 3, 2 }, { 5, 0, 3 } };
  const Mesh mesh(points, triangles);

  std::cout << num_vertices(mesh) << " vertices, " << num_edges(mesh) << " edges, " << num_faces(mesh) << " faces\n"
            << mesh.connectivity_bytes() << " bytes of connectivity\n"
            << "area " << CGAL::Polygon_mesh_processing::area(mesh) << "\n"
            << "volume " << CGAL::Polygon_mesh_processing::volume(mesh) << "\n";

  // the vertices have other numbers than the points had
  for (const Mesh::Vertex_index v : vertices(mesh)) {
    std::cout << v << " at " << mesh.point(v) << " is adjacent to";
    for (const Mesh::Vertex_index u : vertices_around_target(halfedge(v, mesh), mesh))
      std::cout << ' ' << u;
    std::cout << '\n';
  }

  try {
    triangles.pop_back();
    const Mesh with_a_hole(points, triangles);
  } catch (const CGAL::Mesh_defect_exception& e) {
    std::cout << "without its last triangle the mesh is refused: " << e.what() << '\n';
  }
}
