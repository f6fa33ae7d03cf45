// check --claim complex --faces: what files list beside their simplices, in every format that does.
#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

// One tetrahedron and two triangles listed beside it: the second names the vertex `last` of five,
// where 3 makes it a face.
struct ListedTriangles {
  ScratchFolder folder;

  std::string ele(int last) const {
    folder.write("t.node", "5 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n4 9 9 9\n");
    folder.write("t.face", "2 0\n0 0 1 2\n1 0 1 " + std::to_string(last) + "\n");
    return folder.write("t.ele", "1 4 0\n0 0 1 2 3\n");
  }
  std::string medit(int last) const {
    return folder.write("t.mesh",
                        "MeshVersionFormatted 2\nDimension 3\nVertices 5\n0 0 0 0\n1 0 0 0\n"
                        "0 1 0 0\n0 0 1 0\n9 9 9 0\nTriangles 2\n1 2 3 0\n1 2 " +
                            std::to_string(last + 1) + " 0\nTetrahedra 1\n1 2 3 4 0\nEnd\n");
  }
  std::string gmsh(int last) const {
    return folder.write("t.msh",
                        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n"
                        "3 0 1 0\n4 0 0 1\n5 9 9 9\n$EndNodes\n$Elements\n3\n1 2 2 0 1 1 2 3\n"
                        "2 2 2 0 1 1 2 " +
                            std::to_string(last + 1) + "\n3 4 2 0 1 1 2 3 4\n$EndElements\n");
  }
  std::string abaqus(int last) const {
    return folder.write("t.inp",
                        "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n5, 9, 9, 9\n"
                        "*ELEMENT, TYPE=S3\n1, 1, 2, 3\n2, 1, 2, " +
                            std::to_string(last + 1) + "\n*ELEMENT, TYPE=C3D4\n3, 1, 2, 3, 4\n");
  }
  std::string su2(int last) const {
    return folder.write("t.su2",
                        "NDIME= 3\nNELEM= 1\n10 0 1 2 3 0\nNPOIN= 5\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                        "9 9 9\nNMARK= 1\nMARKER_TAG= wall\nMARKER_ELEMS= 2\n5 0 1 2\n5 0 1 " +
                            std::to_string(last) + "\n");
  }
  std::string vtk(int last) const {
    return folder.write("t.vtk",
                        "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                        "POINTS 5 double\n0 0 0 1 0 0 0 1 0 0 0 1 9 9 9\nCELLS 3 13\n3 0 1 2\n"
                        "3 0 1 " +
                            std::to_string(last) + "\n4 0 1 2 3\nCELL_TYPES 3\n5 5 10\n");
  }
  std::string vtu(int last) const {
    return folder.write(
        "t.vtu",
        "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"5\" "
        "NumberOfCells=\"3\"><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" "
        "format=\"ascii\">0 0 0 1 0 0 0 1 0 0 0 1 9 9 9</DataArray></Points><Cells><DataArray "
        "type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 0 1 " +
            std::to_string(last) +
            " 0 1 2 3</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">3 6 "
            "10</DataArray><DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">5 5 10"
            "</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>\n");
  }
};

Run judged_with_unused(const std::string& mesh, std::vector<std::string> more = {}) {
  more.insert(more.begin(), {"check", mesh, "--claim", "complex", "--allow-unused"});
  return run(more);
}

}  // namespace

TEST_CASE("check --faces: listed triangles of all formats are to be facets of the tetrahedra") {
  const ListedTriangles files;
  using Write = std::string (ListedTriangles::*)(int) const;
  for (const auto& [write, first] :
       std::initializer_list<std::pair<Write, int>>{{&ListedTriangles::ele, 0},
                                                    {&ListedTriangles::medit, 1},
                                                    {&ListedTriangles::gmsh, 1},
                                                    {&ListedTriangles::abaqus, 1},
                                                    {&ListedTriangles::su2, 0},
                                                    {&ListedTriangles::vtk, 0},
                                                    {&ListedTriangles::vtu, 0}}) {
    const std::string right = (files.*write)(3);
    CAPTURE(right);
    const Run held = judged_with_unused(right, {"--faces"});
    CHECK(held.exit_code == 0);
    CHECK(has(held.out, " 2 listed-faces\n"));
    const std::string wrong = (files.*write)(4);
    CHECK(judged_with_unused(wrong).exit_code == 0);
    for (const char* by : {"lemma", "definition"}) {
      const Run failed = judged_with_unused(wrong, {"--faces", "--by", by});
      CHECK(failed.exit_code == 1);
      const auto own = [first = first](int v) { return std::to_string(v + first); };
      const std::string face = own(0) + " " + own(1) + " " + own(4) + "\n";
      CHECK(
          has(failed.out, "  face     " + face + "  index among the listed triangles: " + own(1)));
      CHECK(has(failed.out, "complex.stray-face 1 face " + face));
    }
  }
}

TEST_CASE("check --faces: segments in the plane; indices that begin elsewhere; nothing listed") {
  const ScratchFolder folder;
  folder.write("s.node", "4 2 0 0\n0 0 0\n1 4 0\n2 4 4\n3 0 4\n");
  const std::string mesh = folder.write("s.ele", "2 3 0\n0 0 1 2\n1 0 2 3\n");
  folder.write("s.edge", "4 0\n0 1 2\n1 2 3\n2 3 4\n3 1 4\n");
  const Run shifted = judged_with_unused(mesh, {"--faces"});
  CHECK(shifted.exit_code == 1);
  CHECK(has(shifted.out,
            "cause: the indices of the listed faces seem to begin at 1, not at 0: so read, all 4 "
            "are faces of simplices"));
  folder.write("s.edge", "4 0\n0 0 1\n1 1 2\n2 2 3\n3 1 3\n");
  const Run crossing = judged_with_unused(mesh, {"--faces"});
  CHECK(has(crossing.out, "complex.stray-face 1 face 1 3"));
  CHECK(!has(crossing.out, "cause:"));
  CHECK(judged_with_unused(mesh, {"--faces", "--keep-label", "1"}).exit_code == 2);
  const std::string none = folder.write("n.ele", "1 3 0\n0 0 1 2\n");
  folder.write("n.node", "3 2 0 0\n0 0 0\n1 4 0\n2 4 4\n");
  const Run nothing = judged_with_unused(none, {"--faces"});
  CHECK(nothing.exit_code == 3);
  CHECK(has(nothing.err, "listed beside the simplices for --faces"));
  CHECK(has(nothing.err, "found none"));
}

}  // namespace circumspect::cli
