// Meshes in TetGen's files, and other programs that read them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace circumspect::bench {

// A mesh as circumspect::MeshArrays wants it. Indices from 0, −1 where there is no neighbour.
struct Arrays {
  std::vector<double> coordinates;
  std::vector<std::int32_t> simplices;
  std::vector<std::int32_t> neighbors;
};

struct RunTime {
  double processor = 0;  // seconds, of the program and the system for it
  double wall = 0;
  bool succeeded = false;  // exit code 0
};

// Runs the program, found in PATH, and drops what it prints.
RunTime run(const std::vector<std::string>& command);

// Writes `stem`.node and `stem`.ele.
void write_mesh(const std::string& stem, const Arrays& mesh);

// What `tetgen -pYq1.4a0.000005` makes of a cube with a folded surface of 2·side² triangles in its middle:
// the triangles stay, so it is not Delaunay. Empty if TetGen is not there. Leaves files in the folder.
Arrays constrained_mesh(const std::string& folder, int side);

}  // namespace circumspect::bench
