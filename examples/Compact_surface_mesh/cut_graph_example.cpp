// A cut graph of a mesh: along it, the mesh can be cut open to a disk.
//
//   cut_graph_example [mesh [picture.ply]]
//
// The picture is the mesh with the graph as red edges and vertices.

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Schnyder_woods.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Edge_index, bool> Edge_map;

void write_picture(const std::string& file, const Mesh& mesh, Edge_map is_cut)
{
  std::vector<bool> is_on_cut(mesh.number_of_vertices(), false);
  std::vector<Mesh::Edge_index> cut;
  for (const Mesh::Edge_index e : mesh.edges())
    if (is_cut[e]) {
      cut.push_back(e);
      is_on_cut[mesh.vertex(e, 0)] = is_on_cut[mesh.vertex(e, 1)] = true;
    }
  std::ofstream out(file);
  out << "ply\nformat ascii 1.0\nelement vertex " << mesh.number_of_vertices()
      << "\nproperty float x\nproperty float y\nproperty float z"
         "\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nelement face "
      << mesh.number_of_faces() << "\nproperty list int int vertex_indices\nelement edge " << cut.size()
      << "\nproperty int vertex1\nproperty int vertex2"
         "\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n";
  for (const Mesh::Vertex_index v : mesh.vertices())
    out << mesh.point(v) << (is_on_cut[v] ? " 220 20 20\n" : " 200 200 200\n");
  for (const Mesh::Face_index f : mesh.faces()) {
    out << mesh.degree(f);
    for (const Mesh::Vertex_index v : vertices_around_face(mesh.halfedge(f), mesh))
      out << ' ' << v.idx();
    out << '\n';
  }
  for (const Mesh::Edge_index e : cut)
    out << mesh.vertex(e, 0).idx() << ' ' << mesh.vertex(e, 1).idx() << " 220 20 20\n";
}

int main(int argc, char* argv[])
{
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::cerr << "cannot read a mesh from " << file << '\n';
    return EXIT_FAILURE;
  }

  const Edge_map is_cut = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_cut").first;
  const double length = CGAL::cut_graph(mesh, is_cut);
  std::vector<std::vector<Mesh::Halfedge_index>> loops;
  CGAL::cut_graph_loops(mesh, is_cut, std::back_inserter(loops));

  std::cout << "cut graph of length " << length << " with " << loops.size() << " loops, of";
  for (const auto& loop : loops)
    std::cout << ' ' << loop.size();
  std::cout << " edges\n";
  if (CGAL::is_closed(mesh))
    std::cout << "closed: genus " << loops.size() / 2 << " in all\n";
  if (argc > 2)
    write_picture(argv[2], mesh, is_cut);
}
