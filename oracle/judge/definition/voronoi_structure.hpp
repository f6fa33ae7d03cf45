// The vertices and ridges of the Voronoi diagram within a box, from their definitions.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "oracle/model/voronoi_diagram.hpp"

namespace circumspect::definition {

// A vertex is a point whose nearest sites span the plane, or space; it is the centre of their cell
// in the Delaunay subdivision. A ridge is the common part of the cells of two sites, if no common
// part of three is as large; its ends are the vertices in it. The diagram is the dual of the
// Delaunay subdivision. Book: Section 4.2.
struct VoronoiRidge {
  std::vector<Point> ends = {};  // in the closed box, ascending
  bool leaves_box = false;       // has it points outside?
};
struct VoronoiStructure {
  std::map<Point, Simplex> vertices = {};  // in the closed box, each with its nearest sites
  // Those with an end in the closed box, by their sites, ascending.
  std::map<std::array<Vertex, 2>, VoronoiRidge> ridges = {};
};

// Every d + 1 sites are asked for their vertex, and every two for their ridge: some point has just
// these two for its nearest sites. That, and whether some point of the ridge is outside of the box,
// are linear programs.
VoronoiStructure exact_structure(const PointSet& sites, const JudgedBox& box);

}  // namespace circumspect::definition
