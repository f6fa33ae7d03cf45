#include "oracle/formats/rings.hpp"

#include <algorithm>
#include <utility>

#include "oracle/formats/plane.hpp"

namespace circumspect::formats {
namespace {

// What a list of each depth is, for messages.
constexpr std::string_view kOfDepth[] = {
    "a number", "a position, which is a list of 2 or 3 numbers", "a list of positions",
    "a list of lines or rings, each a list of positions",
    "a list of polygons, each a list of rings"};

constexpr int depth_of_one(Geometry::Kind kind) {
  switch (kind) {
    case Geometry::Kind::kPoints:
      return 1;
    case Geometry::Kind::kLines:
      return 2;
    default:
      return 3;
  }
}

}  // namespace

tl::unexpected<FormatError> Rings::fail(std::size_t line, std::string expected,
                                        std::string found) const {
  return tl::unexpected(FormatError{file_.name, line, std::move(expected), std::move(found)});
}

Status Rings::add(const Geometry& geometry, const Coordinates& coordinates) {
  return add(geometry.kind, geometry.depth, coordinates);
}

// A ring alone is less deep than a polygon.
Status Rings::add(Geometry::Kind kind, int depth, const Coordinates& coordinates) {
  if (depth == 1) {
    const Result<Vertex> point = vertex(coordinates);
    return point ? Status{} : tl::unexpected(point.error());
  }
  if (!coordinates.position.empty()) {
    return fail(coordinates.line, std::string(kOfDepth[depth]), "a position");
  }
  if (depth > depth_of_one(kind)) {
    for (const Coordinates& part : coordinates.parts) {
      if (Status status = add(kind, depth - 1, part); !status) return status;
    }
    return {};
  }
  if (coordinates.parts.empty()) return {};
  if (depth == 2) {
    Result<Line> only = line(coordinates);
    if (!only) return tl::unexpected(only.error());
    if (kind == Geometry::Kind::kLines) {
      lines_.push_back(std::move(*only));
    } else {
      polygons_.push_back({std::move(*only)});
    }
    return {};
  }
  Polygon polygon;
  for (const Coordinates& part : coordinates.parts) {
    Result<Line> ring = line(part);
    if (!ring) return tl::unexpected(ring.error());
    polygon.push_back(std::move(*ring));
  }
  polygons_.push_back(std::move(polygon));
  return {};
}

Result<Vertex> Rings::vertex(const Coordinates& position) {
  const std::size_t size = position.position.size();
  if (size != 2 && size != 3) {
    return fail(position.line, std::string(kOfDepth[1]),
                position.parts.empty() ? std::to_string(size) + " numbers" : "a list of lists");
  }
  if (file_.dimension == 0) file_.dimension = size;
  if (size != file_.dimension) {
    return fail(position.line,
                std::to_string(file_.dimension) + " coordinates, as the first position has",
                std::to_string(size));
  }
  file_.input.points.push_back(position.position);
  return static_cast<Vertex>(file_.input.points.size() - 1);
}

Result<Rings::Line> Rings::line(const Coordinates& list) {
  if (!list.position.empty()) return fail(list.line, std::string(kOfDepth[2]), "a position");
  Line line{{}, list.line};
  for (const Coordinates& position : list.parts) {
    const Result<Vertex> corner = vertex(position);
    if (!corner) return tl::unexpected(corner.error());
    line.corners.push_back(*corner);
  }
  return line;
}

void Rings::merge_equal_positions() {
  std::vector<Point>& points = file_.input.points;
  std::vector<Vertex> place(points.size(), 0);
  for (const Duplicate& duplicate : duplicates(points)) {
    place[static_cast<std::size_t>(duplicate.again)] = -1 - duplicate.kept;
  }
  std::vector<Point> distinct;
  for (std::size_t v = 0; v < place.size(); ++v) {
    if (place[v] < 0) {
      place[v] = place[static_cast<std::size_t>(-1 - place[v])];
    } else {
      place[v] = static_cast<Vertex>(distinct.size());
      distinct.push_back(std::move(points[v]));
    }
  }
  points = std::move(distinct);
  const auto renumber = [&place](Line& line) {
    for (Vertex& corner : line.corners) corner = place[static_cast<std::size_t>(corner)];
  };
  for (Polygon& polygon : polygons_) std::for_each(polygon.begin(), polygon.end(), renumber);
  std::for_each(lines_.begin(), lines_.end(), renumber);
}

void Rings::leave_out_common_height() {
  const auto height = common_height(file_.input.points);
  if (!height) return;
  for (Point& point : file_.input.points) point.pop_back();
  file_.dimension = 2;
  file_.notes.push_back(note_of_height(file_.name, *height));
}

Status Rings::add_to_plane(const Polygon& polygon) {
  PolygonLines& face = file_.faces.emplace_back();
  for (const Line& ring : polygon) {
    std::vector<Vertex> corners = without_repetitions(ring.corners);
    if (corners.size() < 3) {
      return fail(
          ring.line, "a ring of at least 3 positions",
          std::to_string(corners.size()) + (corners.size() == 1 ? " position" : " positions"));
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      add_segment(file_, {corners[i], corners[(i + 1) % corners.size()]}, ring.line);
    }
    face.lines.push_back(std::move(corners));
  }
  return {};
}

Status Rings::add_to_space(const Polygon& polygon) {
  if (polygon.size() > 1) {
    return fail(polygon[1].line,
                "polygons of one ring where the third coordinate differs (a .poly file names holes "
                "of polygons in space)",
                std::to_string(polygon.size()) + " rings");
  }
  add_facet(file_, {{polygon.front().corners}, {}}, polygon.front().line);
  return {};
}

Result<DomainFile> Rings::finish() {
  if (file_.input.points.empty()) return fail(0, "polygons, lines or points", "none");
  merge_equal_positions();
  leave_out_common_height();
  file_.faces_are_rings = file_.dimension == 2;
  for (const Polygon& polygon : polygons_) {
    Status status = file_.dimension == 2 ? add_to_plane(polygon) : add_to_space(polygon);
    if (!status) return tl::unexpected(status.error());
  }
  for (const Line& line : lines_) {
    for (std::size_t i = 1; i < line.corners.size(); ++i) {
      if (line.corners[i - 1] == line.corners[i]) continue;
      add_segment(file_, {line.corners[i - 1], line.corners[i]}, line.line);
    }
  }
  return std::move(file_);
}

}  // namespace circumspect::formats
