#include "oracle/formats/plane.hpp"

#include <algorithm>
#include <memory>
#include <set>
#include <utility>
#include <variant>

#include "kernel/complex/simplex.hpp"
#include "kernel/exact/number_text.hpp"

namespace circumspect::formats {
namespace {

template <class Value>
bool has_common_height(const Rows<Value>& points) {
  for (std::size_t i = 1; i < points.rows(); ++i) {
    if (points.row(i)[2] != points.row(0)[2]) return false;
  }
  return true;
}

// Points with more or fewer coordinates than before; a further one is `height`.
template <class Value>
Rows<Value> with_columns(const Rows<Value>& points, std::size_t columns, const Value& height) {
  Rows<Value> others(points.rows(), columns);
  for (std::size_t i = 0; i < points.rows(); ++i) {
    const auto row = others.row(i);
    std::fill(row.begin(), row.end(), height);
    std::copy_n(points.row(i).begin(), std::min(columns, points.columns()), row.begin());
  }
  return others;
}

}  // namespace

std::optional<Rational> common_height(const std::vector<Point>& points) {
  if (points.empty() || points.front().size() != 3) return std::nullopt;
  const Rational& height = points.front()[2];
  const bool is_common = std::all_of(points.begin(), points.end(),
                                     [&](const Point& point) { return point[2] == height; });
  return is_common ? std::optional(height) : std::nullopt;
}

void leave_out_height(MeshFile& file, const std::optional<Rational>& height) {
  Mesh& mesh = file.mesh;
  if (mesh.dimension() != 3 || mesh.points() == 0) return;
  const Rational found = mesh.point(0)[2];
  if (height && *height != found) return;
  const bool is_common =
      std::visit([](const auto& points) { return has_common_height(points); }, mesh.coordinates);
  if (!is_common) return;
  mesh.coordinates = std::visit(
      [](const auto& points) -> Numbers { return with_columns(points, 2, points.row(0)[2]); },
      mesh.coordinates);
  file.height = found;
  file.notes.push_back(note_of_height(file.points_name, found));
}

void put_back_height(Mesh& mesh, const Rational& height) {
  std::vector<Point> points = mesh.exact_points();
  for (Point& point : points) point.push_back(height);
  mesh.coordinates = numbers_of(points, 3);
}

std::string note_of_height(const std::string& points_name, const Rational& height) {
  return points_name + ": the third coordinate, " + to_text_of_double_or_fraction(height) +
         " for all points, was left out";
}

bool needs_space(const SimplexFile& file, const std::vector<Simplex>& faces) {
  if (file.vertices_per_simplex > 3) return true;
  const SimplexRows& simplices = file.simplices;
  if (simplices.empty()) {
    return std::any_of(faces.begin(), faces.end(),
                       [](const Simplex& face) { return face.size() >= 3; });
  }
  for (std::size_t i = 0; simplices.columns() == 0 && i < simplices.size(); ++i) {
    if (simplices.size_of(i) >= 4) return true;
  }
  return simplices.columns() >= 4;
}

std::optional<DomainFile> in_plane(const DomainFile& file) {
  const auto height = common_height(file.input.points);
  if (!height || !file.input.hole_seeds.empty()) return std::nullopt;
  DomainFile plane = file;
  plane.dimension = 2;
  for (Point& point : plane.input.points) point.pop_back();
  std::set<Simplex> edges;
  for (const auto& segment : file.input.segments) edges.insert(sorted(segment));
  for (std::size_t i = 0; i < file.input.polygons.size(); ++i) {
    for (const auto& line : file.input.polygons[i].lines) {
      for (std::size_t j = 0; line.size() > 1 && j < line.size(); ++j) {
        const Simplex edge = sorted({line[j], line[(j + 1) % line.size()]});
        if (edges.insert(edge).second) add_segment(plane, edge, file.polygon_lines[i]);
      }
    }
  }
  plane.faces = std::exchange(plane.input.polygons, {});
  plane.polygon_lines.clear();
  plane.region_bounds.clear();  // they bound volumes
  plane.polygon_markers.clear();
  for (PolygonLines& face : plane.faces) {
    for (Point& seed : face.hole_seeds) {
      if (seed[2] != *height) return std::nullopt;  // this is a fault of the domain in space
      seed.pop_back();
    }
  }
  return plane;
}

DomainFile taken_for_plane(DomainFile file) {
  auto plane = in_plane(file);
  if (!plane) return file;
  const Rational height = file.input.points.front()[2];
  plane->notes.push_back(
      note_of_height(plane->points_name.empty() ? plane->name : plane->points_name, height));
  plane->flat = DomainFile::Flat{height, std::make_shared<const DomainFile>(std::move(file))};
  return std::move(*plane);
}

DomainFile as_it_stands(DomainFile file) {
  if (file.flat) return *file.flat->in_space;
  return file;
}

DomainFile of_dimension(DomainFile file, std::size_t dimension) {
  return dimension == 3 ? as_it_stands(std::move(file)) : std::move(file);
}

}  // namespace circumspect::formats
