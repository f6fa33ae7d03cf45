// How far is a listed cell from the Voronoi cell of its site? The definition of the claim
// `voronoi`: within a box, every corner of one is near the other (the Hausdorff distance of convex
// sets is taken at a corner, since the distance from a convex set is a convex function).
#pragma once

#include <optional>
#include <vector>

#include "oracle/model/voronoi_diagram.hpp"

namespace circumspect::definition {

// The points x with normal · x <= offset.
struct Halfspace {
  Point normal;
  Rational offset;
};

std::vector<Halfspace> halfspaces_of(const JudgedBox& box);
// The points that are at least as near to site i as to site j.
Halfspace nearer_to(const PointSet& sites, Vertex i, Vertex j);

// The corners of the Voronoi cell of a site within the box: the points of d of the hyperplanes that
// are in all halfspaces.
std::vector<Point> exact_corners(const PointSet& sites, Vertex site, const JudgedBox& box);

// What spans the directions along which no product with a normal is positive.
// Requires: d is 2 or 3, the dimension of the normals.
std::vector<Point> spanning_directions(const std::vector<Point>& normals, std::size_t d);

// Directions that span those in which a listed cell is unbounded, which no list says exactly: those
// that do not come nearer to any other site. None if it is bounded. Requires: two or three
// coordinates.
std::vector<Point> directions_of(const VoronoiDiagram& diagram, Vertex site);

// The corners of the listed cell within the box: one halfspace after the other keeps what is in it,
// and the points where its boundary cuts a segment or a ray between two, less what others combine
// to.
// Requires: every corner names a vertex.
std::vector<Point> listed_corners(const VoronoiDiagram& diagram, Vertex site, const JudgedBox& box);

// The corner that is farthest from the other cell, the first in lexicographic order if there are
// several, of those of the listed cell first.
struct FarthestCorner {
  Rational squared_distance = 0;
  Point corner = {};
  bool is_listed = true;  // or is it one of the exact cell?
};
// Requires: neither is empty; `squared_distance` as above, from a point to some points.
template <class SquaredDistance>
FarthestCorner farthest_corner(const std::vector<Point>& listed, const std::vector<Point>& exact,
                               const SquaredDistance& squared_distance) {
  std::optional<FarthestCorner> farthest;
  for (const bool is_listed : {true, false}) {
    for (const Point& corner : is_listed ? listed : exact) {
      const Rational squared = squared_distance(corner, is_listed ? exact : listed);
      const bool is_farther = !farthest || squared > farthest->squared_distance ||
                              (squared == farthest->squared_distance &&
                               is_listed == farthest->is_listed && corner < farthest->corner);
      if (is_farther) farthest = FarthestCorner{squared, corner, is_listed};
    }
  }
  return *farthest;
}

}  // namespace circumspect::definition
