// Which inputs are piecewise linear complexes (Definition 4.3): `validated`, which has an index and
// signs of determinants, against holding all cells against each other by exact intersections.
#include <algorithm>
#include <map>

#include <doctest/doctest.h>

#include "kernel/complex/point_set.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "kernel/predicates/intersection.hpp"
#include "kernel/predicates/orientation.hpp"
#include "properties/arguments/generated.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::properties {
namespace {

using generators::below;
using Corners = std::vector<Point>;

// A stretch of a segment, by the parameters of its ends.
using Stretch = std::pair<Rational, Rational>;

// The parameter of a point on the line from a to b.
Rational parameter(const Point& a, const Point& b, const Point& p) {
  return inner_product(p - a, b - a) / squared_length(b - a);
}

// Do the stretches cover [0, 1]?
bool cover(std::vector<Stretch> stretches) {
  std::sort(stretches.begin(), stretches.end());
  Rational reached = 0;
  for (const Stretch& stretch : stretches) {
    if (stretch.first > reached) return false;
    if (stretch.second > reached) reached = stretch.second;
  }
  return reached >= 1;
}

// The definition, cell by cell.
class ByDefinition {
 public:
  explicit ByDefinition(const PiecewiseLinearInput& input)
      : input_(input), points_(input.points), segments_(segments_of(input)) {}

  bool is_complex() {
    if (!vertices_and_segments_are() || !polygons_are()) return false;
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
      for (const Simplex& segment : segments_) {
        if (!lies_in_or_meets_in_ends(segment, tiles_[i])) return false;
      }
      for (std::size_t j = i + 1; j < tiles_.size(); ++j) {
        if (!meet_in_cells(tiles_[i], tiles_[j])) return false;
      }
    }
    return seeds_are_off_walls();
  }

 private:
  Corners at(const Simplex& simplex) const { return coordinates(points_, simplex); }
  bool is_vertex(const Point& p) const {
    return std::count(input_.points.begin(), input_.points.end(), p) > 0;
  }
  bool is_end(const Simplex& segment, const Point& p) const {
    return p == points_[segment[0]] || p == points_[segment[1]];
  }

  bool vertices_and_segments_are() const {
    for (const Simplex& a : segments_) {
      for (const Point& p : input_.points) {
        if (!is_end(a, p) && !intersection(at(a), {p}).empty()) return false;
      }
      for (const Simplex& b : segments_) {
        if (a == b) continue;
        for (const Point& p : intersection(at(a), at(b))) {
          if (!is_end(a, p) || !is_end(b, p)) return false;
        }
      }
    }
    return true;
  }

  // Every triple of a polygon's vertices that no other vertex and no edge cuts is a triangle of some
  // triangulation of its hull; the cells between its edges are what such triangles cover. A small
  // polygon is cut greedily: every edge that crosses none drawn before.
  bool polygons_are() {
    for (const PolygonLines& lines : input_.polygons) {
      const std::vector<Vertex> vertices = vertices_of(lines);
      if (flat_through(points_, vertices).dimension() != 2) return false;
      std::vector<Simplex> triangles = inside(vertices, edges_of(lines));
      if (triangles.empty()) return false;
      tiles_.push_back(std::move(triangles));
    }
    return true;
  }

  std::vector<Simplex> inside(const std::vector<Vertex>& vertices,
                              const std::set<Simplex>& walls) const {
    std::set<Simplex> drawn = walls;
    for (const Vertex v : vertices) {
      for (const Vertex w : vertices) {
        if (v < w && can_be_drawn({v, w}, vertices, drawn)) drawn.insert({v, w});
      }
    }
    std::map<Simplex, std::vector<Simplex>> at_edge;
    std::set<Simplex> triangles;
    for (const Simplex& edge : drawn) {
      for (const Vertex apex : vertices) {
        const Simplex triangle = {edge[0], edge[1], apex};
        if (apex <= edge[1] || !drawn.contains({edge[0], apex}) ||
            !drawn.contains({edge[1], apex}) || !is_empty_triangle(triangle, vertices)) {
          continue;
        }
        triangles.insert(triangle);
        for (std::size_t i = 0; i < 3; ++i)
          at_edge[facet_opposite(triangle, i)].push_back(triangle);
      }
    }
    // Take away what is open towards the outside until nothing more is.
    for (bool is_done = false; !is_done;) {
      is_done = true;
      for (auto& [edge, users] : at_edge) {
        std::erase_if(users, [&](const Simplex& t) { return !triangles.contains(t); });
        if (walls.contains(edge) || users.size() != 1) continue;
        triangles.erase(users.front());
        is_done = false;
      }
    }
    return {triangles.begin(), triangles.end()};
  }
  bool can_be_drawn(const Simplex& edge, const std::vector<Vertex>& vertices,
                    const std::set<Simplex>& drawn) const {
    for (const Vertex v : vertices) {
      if (!contains(edge, v) && !intersection(at(edge), {points_[v]}).empty()) return false;
    }
    return std::none_of(drawn.begin(), drawn.end(), [&](const Simplex& other) {
      const Corners common = intersection(at(edge), at(other));
      return std::any_of(common.begin(), common.end(),
                         [&](const Point& p) { return !is_end(edge, p) || !is_end(other, p); });
    });
  }
  bool is_empty_triangle(const Simplex& triangle, const std::vector<Vertex>& vertices) const {
    if (flat_through(points_, triangle).dimension() != 2) return false;
    return std::none_of(vertices.begin(), vertices.end(), [&](Vertex v) {
      return !contains(triangle, v) && !intersection(at(triangle), {points_[v]}).empty();
    });
  }

  // "If two distinct linear cells intersect, their intersection is a union of linear cells": the
  // segment itself or ends of it.
  bool lies_in_or_meets_in_ends(const Simplex& segment, const std::vector<Simplex>& tiles) const {
    const Point& a = points_[segment[0]];
    const Point& b = points_[segment[1]];
    std::vector<Stretch> stretches;
    bool has_inner_point = false;
    for (const Simplex& tile : tiles) {
      std::vector<Rational> parameters;
      for (const Point& p : intersection(at(segment), at(tile))) {
        parameters.push_back(parameter(a, b, p));
        has_inner_point = has_inner_point || !is_end(segment, p);
      }
      if (parameters.empty()) continue;
      const auto [low, high] = std::minmax_element(parameters.begin(), parameters.end());
      stretches.emplace_back(*low, *high);
      has_inner_point = has_inner_point || *low < *high;
    }
    return !has_inner_point || cover(stretches);
  }

  bool meet_in_cells(const std::vector<Simplex>& a, const std::vector<Simplex>& b) const {
    for (const Simplex& s : a) {
      for (const Simplex& t : b) {
        const Corners common = intersection(at(s), at(t));
        if (common.size() > 2) return false;
        if (common.size() == 1 && !is_vertex(common[0]) && !is_on_segment(common[0])) return false;
        if (common.size() == 2 && !is_covered(common[0], common[1])) return false;
      }
    }
    return true;
  }
  // A single common point of two tiles may be an end of a stretch that other tiles continue.
  bool is_on_segment(const Point& p) const {
    return std::any_of(segments_.begin(), segments_.end(),
                       [&](const Simplex& s) { return !intersection(at(s), {p}).empty(); });
  }
  bool is_covered(const Point& p, const Point& q) const {
    std::vector<Stretch> stretches;
    for (const Simplex& segment : segments_) {
      const Corners common = intersection({p, q}, at(segment));
      if (common.size() != 2) continue;
      const Rational s = parameter(p, q, common[0]), t = parameter(p, q, common[1]);
      stretches.push_back(std::minmax(s, t));
    }
    return cover(stretches);
  }

  bool seeds_are_off_walls() const {
    std::vector<Simplex> walls = input_.polygons.empty() ? segments_ : std::vector<Simplex>();
    for (const auto& tiles : tiles_) walls.insert(walls.end(), tiles.begin(), tiles.end());
    for (const Point& seed : input_.hole_seeds) {
      for (const Simplex& wall : walls) {
        const bool is_wall = wall.size() == points_.ambient_dimension();
        if (is_wall && !intersection(at(wall), {seed}).empty()) return false;
      }
    }
    return true;
  }

  const PiecewiseLinearInput& input_;
  PointSet points_;
  std::vector<Simplex> segments_;
  std::vector<std::vector<Simplex>> tiles_;  // the triangles of every polygon
};

// Different points of a small grid, in random order.
std::vector<Point> grid_points(std::size_t dimension, long side, std::size_t count) {
  std::vector<Point> points;
  for (std::size_t tries = 0; points.size() < count && tries < 4 * count; ++tries) {
    Point p;
    for (std::size_t i = 0; i < dimension; ++i) p.emplace_back(*below(i == 2 ? 2 : side));
    if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
  }
  return points;
}

std::vector<Vertex> some_vertices(std::size_t count, std::size_t of) {
  std::vector<Vertex> line;
  while (line.size() < count) {
    const Vertex v = *below(static_cast<long>(of));
    if (!contains(line, v)) line.push_back(v);
  }
  return line;
}

// Different vertices for a line of three or, in one of three cases, four; these often of one plane.
std::vector<Vertex> some_line(const std::vector<Point>& points) {
  const std::size_t count = *below(3) == 0 ? 4 : 3;
  std::vector<Vertex> line = some_vertices(count, points.size());
  for (int tries = 0; count == 4 && tries < 8; ++tries) {
    std::vector<Point> corners;
    for (const Vertex v : line) corners.push_back(points[static_cast<std::size_t>(v)]);
    if (affine_hull(corners).dimension == 2) break;
    line = some_vertices(count, points.size());
  }
  return line;
}

void show(const PiecewiseLinearInput& input) {
  std::ostringstream out;
  for (const Point& p : input.points) {
    out << "(";
    for (const Rational& x : p) out << x << " ";
    out << ") ";
  }
  for (const auto& s : input.segments) out << s[0] << "-" << s[1] << " ";
  for (const auto& polygon : input.polygons) {
    out << "[";
    for (const auto& line : polygon.lines) {
      for (const Vertex v : line) out << v << " ";
      out << ";";
    }
    out << "]";
  }
  RC_LOG(out.str());
}

void agree(const PiecewiseLinearInput& input, int& valid) {
  show(input);
  const auto complex = validated(input);
  valid += complex.has_value() ? 1 : 0;
  if (!complex) RC_LOG(std::string(identifier(complex.error().front().kind)));
  RC_ASSERT(complex.has_value() == ByDefinition(input).is_complex());
}

TEST_CASE("PLC validity in the plane agrees with pairwise intersections (Definition 4.3)") {
  int valid = 0;
  CHECK(holds("segments in the plane", 400, [&] {
    PiecewiseLinearInput input;
    input.points = grid_points(2, 4, static_cast<std::size_t>(*below(8)) + 2);
    if (input.points.size() < 2) return;
    for (long i = *below(6); i > 0; --i) {
      input.segments.push_back(some_vertices(2, input.points.size()));
    }
    if (*below(2) == 1) input.hole_seeds = grid_points(2, 4, 1);
    agree(input, valid);
  }));
  CHECK(occurs(valid, 51));
  CHECK(valid < 350);
}

TEST_CASE("PLC validity in space agrees with pairwise intersections (Definition 4.3)") {
  for (const long side : {2, 3}) {
    CAPTURE(side);
    int valid = 0;
    CHECK(holds("segments and polygons in space", 1000, [&] {
      PiecewiseLinearInput input;
      input.points = grid_points(3, side, static_cast<std::size_t>(*below(5)) + 5);
      if (input.points.size() < 5) return;
      for (long i = *below(3); i > 0; --i) {
        input.segments.push_back(some_vertices(2, input.points.size()));
      }
      for (long i = *below(3) + 1; i > 0; --i) {
        input.polygons.push_back({{some_line(input.points)}, {}});
        // Sometimes a second line, down to a single vertex.
        if (*below(6) > 0) continue;
        const auto more = static_cast<std::size_t>(*below(3)) + 1;
        input.polygons.back().lines.push_back(some_vertices(more, input.points.size()));
      }
      if (*below(4) == 0) input.hole_seeds = grid_points(3, side, 1);
      agree(input, valid);
    }));
    CHECK(occurs(valid, 101));
    CHECK(valid < 900);
  }
}

// A square at z = 1 and an upright one through it, from vertex to vertex, with more cells about them:
// tiles have edges that are no segments, and only the segment 4 5 may make such a pair legal.
TEST_CASE("PLC validity about two squares agrees with pairwise intersections") {
  int valid = 0, crossing = 0;
  CHECK(holds("two squares, and polygons in them, on them and through them", 1000, [&] {
    PiecewiseLinearInput input;
    input.points = {{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 4, 1},
                    {1, 2, 1}, {3, 2, 1}, {2, 2, 0}, {2, 2, 2}};
    for (const Point& p : grid_points(3, 3, static_cast<std::size_t>(*below(4)))) {
      const Point more = {p[0] + 1, p[1] + 1, p[2] + 1};
      if (std::find(input.points.begin(), input.points.end(), more) == input.points.end()) {
        input.points.push_back(more);
      }
    }
    input.polygons = {{{{0, 1, 2, 3}}, {}}, {{{4, 6, 5, 7}}, {}}};
    if (*below(2) == 0) input.polygons.push_back({{some_line(input.points)}, {}});
    if (*below(2) == 0) input.segments.push_back({5, 4});
    if (*below(3) == 0) input.segments.push_back(some_vertices(2, input.points.size()));
    if (*below(3) == 0) std::swap(input.polygons.front(), input.polygons.back());
    const auto complex = validated(input);
    if (!complex && complex.error().front().kind == BreachKind::kPolygonsCross) ++crossing;
    agree(input, valid);
  }));
  CHECK(occurs(valid, 51));
  CHECK(occurs(crossing, 51));
}

// Anything: indices that name nothing, lines that go to and fro, seeds anywhere.
TEST_CASE("PLC validity has an answer whatever is handed in") {
  CHECK(holds("garbage", 1000, [] {
    PiecewiseLinearInput input;
    const long size = *below(9);
    for (long i = 0; i < size; ++i) {
      input.points.push_back({*below(4), *below(4), *below(12) == 0 ? 1 : 0});
    }
    const auto vertex = [&] { return static_cast<Vertex>(*below(60) == 0 ? 9 : *below(size + 1)); };
    for (long i = *below(4); i > 0; --i) input.segments.push_back({vertex(), vertex()});
    for (long i = *below(4); i > 0; --i) {
      PolygonLines polygon;
      for (long j = *below(3); j >= 0; --j) {
        polygon.lines.emplace_back();
        for (long k = *below(7); k > 0; --k) polygon.lines.back().push_back(vertex());
      }
      for (long j = *below(3) - 1; j > 0; --j) {
        polygon.hole_seeds.push_back({Rational(*below(9), 2), Rational(*below(9), 2), 0});
        for (Rational& x : polygon.hole_seeds.back()) x.canonicalize();
      }
      input.polygons.push_back(polygon);
    }
    show(input);
    const auto complex = validated(input, 5);
    const bool is_answer = complex || (!complex.error().empty() && complex.error().size() <= 5);
    RC_ASSERT(is_answer);
  }));
}

}  // namespace
}  // namespace circumspect::properties
