// The content of a domain file in any format: a piecewise linear complex as it was given, and the
// line of each of its parts.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kernel/exact/number.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/point_file.hpp"
#include "oracle/model/domain.hpp"

namespace circumspect::formats {

struct DomainFile {
  std::size_t dimension = 0;   // 2 or 3, of every point
  PiecewiseLinearInput input;  // vertices from 0; there may be duplicates among the points
  Vertex first_index = 0;      // the user's index of the first point
  std::vector<Vertex> labels =
      {};  // the user's own index of each point, if they are not consecutive
  std::vector<std::size_t> segment_lines = {};  // the line of each segment, for messages
  std::vector<std::size_t> polygon_lines = {};  // the same for each polygon; 0: a binary file
  std::vector<Vertex> polygon_markers = {};     // the marker of each in the file; 0: none
  std::vector<RegionBound> region_bounds = {};
  std::string name = {};
  std::string points_name = {};  // the file of the points, if they are elsewhere
  std::vector<std::string> notes =
      {};  // what was read differently from what the file says, one line each
  // In the plane: the faces that the file lists. Only these are filled, unless the user says
  // otherwise; if there are none, everything that segments enclose is filled.
  std::vector<PolygonLines> faces = {};
  // Faces have no hole seeds, and cover what an odd number of their lines enclose.
  bool faces_are_rings = false;
  // The file has points in space, and was read as a planar one (plane.hpp): what was left out, and
  // the unchanged domain, with its faces among the polygons.
  struct Flat {
    Rational height;
    std::shared_ptr<const DomainFile> in_space;
  };
  std::optional<Flat> flat = {};

  Vertex label(Vertex v) const {
    return labels.empty() ? v + first_index : labels[static_cast<std::size_t>(v)];
  }
};

// Takes over points, which all must have the same dimension, 2 or 3.
Status take_points(DomainFile& file, PointFile points, std::size_t line);

// The place of a point that a file names by `index`. Errors: there is no such point.
Result<Vertex> place_of(const DomainFile& file, Vertex index, std::size_t line);

// The line without corners that repeat the previous one; the last corner counts as previous to the
// first.
std::vector<Vertex> without_repetitions(const std::vector<Vertex>& line);

// Adds a facet of TetGen's: closed lines of three corners or more, segments of two and isolated
// vertices of one. Consecutive equal corners become one, which is noted. Lines that enclose no area
// become segments. Corners are places from 0.
void add_facet(DomainFile& file, PolygonLines facet, std::size_t line, Vertex marker = 0);

void add_segment(DomainFile& file, const Simplex& segment, std::size_t line);

// The same with equal points merged into the first of them; parts that vanish are left out.
DomainFile with_duplicates_merged(DomainFile file);

// Adds the faces of a surface: in space they are polygons, in the plane their edges are segments,
// each once, and they are faces. Vertices are the indices of the file.
Status add_faces(DomainFile& file, const SimplexFile& faces);

}  // namespace circumspect::formats
