// Voronoi diagrams as qvoronoi writes them.
#pragma once

#include <vector>

#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/model/voronoi_diagram.hpp"

namespace circumspect::formats {

// `qvoronoi o Fv`, or its part `o` alone. Sites are elsewhere, in this order.
//
//     2                        the dimension
//     4 3 1                    vertices, the one at infinity included; cells; anything
//     -10.101 -10.101          the vertex at infinity, which is 0
//     0.5 0.5                  vertex 1
//     …
//     3 1 0 2                  for each site the vertices of its cell, in any order, after their
//     …                        number; with vertex 0 it is unbounded
//     3                        `Fv`: ridges
//     4 0 1 0 2                numbers, two sites, vertices
//     …
struct VoronoiFile {
  std::size_t dimension = 0;
  std::vector<Point> vertices = {};    // without the one at infinity
  std::vector<ListedCell> cells = {};  // indices that name no vertex stay, for the judge to report
  std::vector<std::array<Vertex, 2>> neighbors = {};
  std::vector<ListedCell> ridges = {};  // of each of these by its ends
};

Result<VoronoiFile> read_voronoi(const Source& source, NumberReading reading);

}  // namespace circumspect::formats
