// Polygons as rings of coordinates, without indices: what GeoJSON and WKT describe.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/exact/point.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/domain_file.hpp"

namespace circumspect::formats {

// Lists in lists of positions, to a depth that their type tells.
struct Coordinates {
  std::size_t line = 0;
  Point position = {};  // either this, or
  std::vector<Coordinates> parts = {};
};

// Deeper lists than those of several polygons, each of several rings, mean nothing.
inline constexpr int kDeepestCoordinates = 4;

// What coordinates describe. A position has depth 1, a line or ring 2, the rings of a polygon 3.
struct Geometry {
  enum class Kind { kPoints, kLines, kPolygons };
  std::string_view name;
  Kind kind;
  int depth;
};

inline constexpr Geometry kRingAlone{"ring", Geometry::Kind::kPolygons, 2};
inline constexpr Geometry kOnePolygon{"Polygon", Geometry::Kind::kPolygons, 3};
inline constexpr Geometry kManyPolygons{"MultiPolygon", Geometry::Kind::kPolygons, 4};
inline constexpr Geometry kGeometries[] = {{"Point", Geometry::Kind::kPoints, 1},
                                           {"MultiPoint", Geometry::Kind::kPoints, 2},
                                           {"LineString", Geometry::Kind::kLines, 2},
                                           {"MultiLineString", Geometry::Kind::kLines, 3},
                                           kOnePolygon,
                                           kManyPolygons};

// A domain of such geometries. Equal positions are one vertex; vertices are numbered from 0 in the
// order in which they occur. In the plane a polygon covers what an odd number of its rings enclose.
class Rings {
 public:
  explicit Rings(std::string name) { file_.name = std::move(name); }

  // A ring may repeat its first position at its end. Errors: lists of another depth, positions of
  // other than two or three coordinates, or of another number than the first has.
  Status add(const Geometry& geometry, const Coordinates& coordinates);

  // Errors: no positions at all; a ring of fewer than three; rings in rings that are not in a plane
  // z = constant.
  Result<DomainFile> finish();

 private:
  struct Line {
    std::vector<Vertex> corners;
    std::size_t line;
  };
  using Polygon = std::vector<Line>;  // its rings

  Status add(Geometry::Kind kind, int depth, const Coordinates& coordinates);
  Result<Vertex> vertex(const Coordinates& position);
  Result<Line> line(const Coordinates& list);
  tl::unexpected<FormatError> fail(std::size_t line, std::string expected, std::string found) const;

  void merge_equal_positions();
  void leave_out_common_height();
  Status add_to_plane(const Polygon& polygon);
  Status add_to_space(const Polygon& polygon);

  DomainFile file_ = {};
  std::vector<Polygon> polygons_ = {};
  std::vector<Line> lines_ = {};
};

}  // namespace circumspect::formats
