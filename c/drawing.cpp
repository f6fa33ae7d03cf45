// Inputs that are drawn by the name of a family and a seed, as arrays.
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <circumspect/circumspect.h>
#include <fmt/format.h>

#include "c/guard.hpp"
#include "inputs/cases.hpp"
#include "inputs/families.hpp"
#include "inputs/family_faults.hpp"
#include "inputs/in_doubles.hpp"
#include "inputs/triangulated/domain_families.hpp"
#include "oracle/model/printable.hpp"

namespace circumspect::c {
namespace {

constexpr std::int64_t kMostDrawn = 1'000'000;

std::size_t how_many(std::int64_t points) {
  if (points < 1 || points > kMostDrawn) {
    refuse_call(fmt::format("expected from 1 to {} points, found {}", kMostDrawn, points));
  }
  return static_cast<std::size_t>(points);
}

PiecewiseLinearInput drawn_domain(const char* family_name, std::int64_t points,
                                  std::uint64_t seed) {
  const std::string name = required(family_name, "the name of a family");
  const generators::ComplexFamily* const family = properties::find_domain_family(name);
  if (family == nullptr) {
    refuse_call(generators::unknown_family_text("domains", on_one_line(name)));
  }
  return generators::in_doubles(generators::drawn(*family, how_many(points), seed)).input;
}

PointArray drawn(const char* family_name, std::int64_t dimension, std::int64_t points,
                 std::uint64_t seed) {
  const std::string name = required(family_name, "the name of a family");
  const generators::Family* const family = generators::find_family(name);
  if (family == nullptr) {
    refuse_call(generators::unknown_family_text("points", on_one_line(name)));
  }
  if (dimension < 1 || !family->exists_in(static_cast<std::size_t>(dimension))) {
    refuse_call(generators::no_sets_text(name, generators::dimensions_text(*family), dimension));
  }
  const auto columns = static_cast<std::size_t>(dimension);
  const generators::PointsCase set =
      generators::drawn(*family, columns, {how_many(points), true}, seed);
  return generators::array(generators::in_doubles(set, family->repeats_points), columns);
}

}  // namespace
}  // namespace circumspect::c

using namespace circumspect;

struct circumspect_drawing {
  explicit circumspect_drawing(PointArray drawn) : points(std::move(drawn)) {
    mesh.dimension = static_cast<std::int64_t>(points.dimension);
    mesh.point_count = static_cast<std::int64_t>(points.size());
    mesh.coordinates = points.coordinates.data();
    mesh.weights = points.weights.empty() ? nullptr : points.weights.data();
  }

  explicit circumspect_drawing(const PiecewiseLinearInput& input)
      : circumspect_drawing(generators::array({input.points, {}})) {
    std::vector<Point> all_polygon_holes;
    for (const auto& ends : input.segments)
      segments.insert(segments.end(), ends.begin(), ends.end());
    for (const PolygonLines& polygon : input.polygons) {
      for (const auto& line : polygon.lines) {
        corners.insert(corners.end(), line.begin(), line.end());
        line_starts.push_back(static_cast<std::int64_t>(corners.size()));
      }
      for (const Point& hole : polygon.hole_seeds) {
        polygons_of_holes.push_back(domain.polygon_count);
        all_polygon_holes.push_back(hole);
      }
      polygon_starts.push_back(static_cast<std::int64_t>(line_starts.size()) - 1);
      ++domain.polygon_count;
    }
    holes = generators::array({input.hole_seeds, {}});
    polygon_holes = generators::array({all_polygon_holes, {}});
    domain.dimension = mesh.dimension;
    domain.point_count = mesh.point_count;
    domain.coordinates = mesh.coordinates;
    domain.segment_count = static_cast<std::int64_t>(input.segments.size());
    domain.segments = segments.data();
    domain.polygon_starts = polygon_starts.data();
    domain.line_starts = line_starts.data();
    domain.corners = corners.data();
    domain.hole_count = static_cast<std::int64_t>(input.hole_seeds.size());
    domain.hole_seeds = holes.coordinates.data();
    domain.kind = input.kind == DomainKind::kHull ? CIRCUMSPECT_HULL : CIRCUMSPECT_ENCLOSED;
    domain.polygon_hole_count = static_cast<std::int64_t>(all_polygon_holes.size());
    domain.polygons_of_holes = polygons_of_holes.data();
    domain.polygon_hole_seeds = polygon_holes.coordinates.data();
  }

  PointArray points;
  circumspect_mesh mesh = CIRCUMSPECT_MESH;
  // For a domain, whose dimension is 0 otherwise.
  std::vector<std::int64_t> segments = {};
  std::vector<std::int64_t> polygon_starts = {0};
  std::vector<std::int64_t> line_starts = {0};
  std::vector<std::int64_t> corners = {};
  std::vector<std::int64_t> polygons_of_holes = {};
  PointArray holes = {};
  PointArray polygon_holes = {};
  circumspect_domain domain = CIRCUMSPECT_DOMAIN;
};

circumspect_status circumspect_generate(const char* family, int64_t dimension, int64_t points,
                                        uint64_t seed, circumspect_drawing** drawing) {
  if (drawing != nullptr) *drawing = nullptr;
  return c::guarded([&] {
    c::required(drawing, "a place for the drawing");
    *drawing = new circumspect_drawing(c::drawn(family, dimension, points, seed));
  });
}

circumspect_status circumspect_generate_domain(const char* family, int64_t points, uint64_t seed,
                                               circumspect_drawing** drawing) {
  if (drawing != nullptr) *drawing = nullptr;
  return c::guarded([&] {
    c::required(drawing, "a place for the drawing");
    *drawing = new circumspect_drawing(c::drawn_domain(family, points, seed));
  });
}

const circumspect_domain* circumspect_drawing_domain(const circumspect_drawing* drawing) {
  return drawing == nullptr || drawing->domain.dimension == 0 ? nullptr : &drawing->domain;
}

const circumspect_mesh* circumspect_drawing_mesh(const circumspect_drawing* drawing) {
  return drawing == nullptr ? nullptr : &drawing->mesh;
}

void circumspect_drawing_free(circumspect_drawing* drawing) { delete drawing; }
