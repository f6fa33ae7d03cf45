// For tests: a square of two triangles, in a plane in space, in every format.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace circumspect::formats {

// By extension, as a domain and, except for .poly, .smesh and .stl, as a mesh. All points have the
// third coordinate z.
inline std::map<std::string, std::string> flat_square(const std::string& z) {
  const std::string a = "0 0 " + z, b = "1 0 " + z, c = "1 1 " + z, d = "0 1 " + z;
  const std::string lines = a + "\n" + b + "\n" + c + "\n" + d + "\n";
  const std::string nodes = "4 3\n0 " + a + "\n1 " + b + "\n2 " + c + "\n3 " + d + "\n";
  const auto facet = [](const std::string& p, const std::string& q, const std::string& r) {
    return "facet normal 0 0 1\nouter loop\nvertex " + p + "\nvertex " + q + "\nvertex " + r +
           "\nendloop\nendfacet\n";
  };
  return {
      {".poly", nodes + "2\n1\n3 0 1 2\n1\n3 0 2 3\n0\n"},
      {".smesh", nodes + "2\n3 0 1 2\n3 0 2 3\n0\n"},
      {".stl", "solid s\n" + facet(a, b, c) + facet(a, c, d) + "endsolid s\n"},
      {".off", "OFF\n4 2 0\n" + lines + "3 0 1 2\n3 0 2 3\n"},
      {".ply",
       "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty "
       "double z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n" +
           lines + "3 0 1 2\n3 0 2 3\n"},
      {".obj", "v " + a + "\nv " + b + "\nv " + c + "\nv " + d + "\nf 1 2 3\nf 1 3 4\n"},
      {".mesh", "MeshVersionFormatted 2\nDimension 3\nVertices 4\n" + a + " 0\n" + b + " 0\n" + c +
                    " 0\n" + d + " 0\nTriangles 2\n1 2 3 0\n1 3 4 0\nEnd\n"},
      {".msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 " + a + "\n2 " + b + "\n3 " + c +
                   "\n4 " + d +
                   "\n$EndNodes\n$Elements\n2\n1 2 0 1 2 3\n2 2 0 1 3 4\n$EndElements\n"},
      {".vtk", "# vtk DataFile Version 3.0\ns\nASCII\nDATASET POLYDATA\nPOINTS 4 double\n" + lines +
                   "POLYGONS 2 8\n3 0 1 2\n3 0 2 3\n"},
      {".vtu",
       "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"4\" "
       "NumberOfCells=\"2\"><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" "
       "format=\"ascii\">" +
           lines +
           "</DataArray></Points><Cells><DataArray type=\"Int32\" Name=\"connectivity\" "
           "format=\"ascii\">0 1 2 0 2 3</DataArray><DataArray type=\"Int32\" Name=\"offsets\" "
           "format=\"ascii\">3 6</DataArray><DataArray type=\"UInt8\" Name=\"types\" "
           "format=\"ascii\">5 5</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>\n"}};
}

// Writes the meshes among them to a folder, and also an .ele with its .node, and JSON. Their names
// begin with `stem`.
template <class Folder>  // inputs/scratch_folder_test.hpp
std::vector<std::string> flat_square_meshes(const Folder& folder, const std::string& stem,
                                            const std::string& z) {
  std::vector<std::string> paths;
  for (const auto& [end, text] : flat_square(z)) {
    if (end == ".poly" || end == ".smesh" || end == ".stl") continue;
    paths.push_back(folder.write(stem + end, text));
  }
  folder.write(stem + ".node",
               "4 3\n0 0 0 " + z + "\n1 1 0 " + z + "\n2 1 1 " + z + "\n3 0 1 " + z + "\n");
  paths.push_back(folder.write(stem + ".ele", "2 3\n0 0 1 2\n1 0 2 3\n"));
  paths.push_back(folder.write(
      stem + ".json", "{\"circumspect\":1,\"dimension\":3,\"points\":[[0,0," + z + "],[1,0," + z +
                          "],[1,1," + z + "],[0,1," + z + "]],\"simplices\":[[0,1,2],[0,2,3]]}"));
  return paths;
}

}  // namespace circumspect::formats
