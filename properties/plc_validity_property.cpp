// Which inputs are piecewise linear complexes: `validated`, which has an index and signs of
// determinants, against Definition 4.3 (oracle/judge/definition/linear_cells.hpp).
#include <algorithm>
#include <map>
#include <utility>

#include <doctest/doctest.h>

#include "kernel/complex/point_set.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "kernel/predicates/intersection.hpp"
#include "kernel/predicates/orientation.hpp"
#include "oracle/judge/definition/linear_cells.hpp"
#include "properties/arguments/generated.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::properties {
namespace {

using generators::below;
using Corners = std::vector<Point>;

// The cells that an input describes, and the definition asked of them.
class ByDefinition {
 public:
  explicit ByDefinition(const PiecewiseLinearInput& input)
      : input_(input), points_(input.points), segments_(segments_of(input)) {}

  bool is_complex() {
    PiecewiseLinearComplex complex{points_, segments_, {}, {}};
    for (const PolygonLines& lines : input_.polygons) {
      const std::vector<Vertex> vertices = vertices_of(lines);
      if (flat_through(points_, vertices).dimension() != 2) return false;
      complex.polygons.push_back({{}, {}, {}, {}, inside(vertices, edges_of(lines))});
    }
    return definition::is_piecewise_linear_complex(complex) && seeds_are_off_walls(complex);
  }

 private:
  Corners at(const Simplex& simplex) const { return coordinates(points_, simplex); }
  bool is_end(const Simplex& segment, const Point& p) const {
    return p == points_[segment[0]] || p == points_[segment[1]];
  }

  // Every triple of a polygon's vertices that no other vertex and no edge cuts is a triangle of
  // some triangulation of its hull; the cells between its edges are what such triangles cover. A
  // small polygon is cut greedily: every edge that crosses none drawn before.
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

  bool seeds_are_off_walls(const PiecewiseLinearComplex& complex) const {
    for (const Point& seed : input_.hole_seeds) {
      for (const Simplex& wall : walls(complex)) {
        const bool is_wall = wall.size() == points_.ambient_dimension();
        if (is_wall && !intersection(at(wall), {seed}).empty()) return false;
      }
    }
    return true;
  }

  const PiecewiseLinearInput& input_;
  PointSet points_;
  std::vector<Simplex> segments_;
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

// The same cells with five vertices more in each edge, near one of its ends, where nothing of such
// a small grid meets it. So polygons are large, for which there are other searches, and nothing
// else changes.
PiecewiseLinearInput divided(const PiecewiseLinearInput& input) {
  PiecewiseLinearInput finer = input;
  finer.segments.clear();
  std::map<Simplex, std::vector<Vertex>> paths;  // without the last vertex
  const auto pieces_of = [&](Vertex from, Vertex to) {
    const auto [made, is_new] = paths.try_emplace({from, to});
    const auto back = paths.find({to, from});
    if (!is_new) return made->second;
    made->second = {from};
    for (long part = 1; part <= 5 && from != to; ++part) {
      if (back != paths.end()) {
        made->second.push_back(back->second[static_cast<std::size_t>(6 - part)]);
        continue;
      }
      const Point &p = input.points[static_cast<std::size_t>(from)],
                  &q = input.points[static_cast<std::size_t>(to)];
      made->second.push_back(static_cast<Vertex>(finer.points.size()));
      finer.points.push_back(p + Rational(part, 101) * (q - p));
    }
    return made->second;
  };
  const auto add_pieces = [&](const std::vector<Vertex>& ends, auto& to) {
    std::vector<Vertex> all = pieces_of(ends[0], ends[1]);
    all.push_back(ends[1]);
    for (std::size_t i = 0; i + 1 < all.size(); ++i) to.push_back({all[i], all[i + 1]});
  };
  for (const auto& segment : input.segments) add_pieces(segment, finer.segments);
  for (PolygonLines& polygon : finer.polygons) {
    const auto lines = std::exchange(polygon.lines, {});
    for (const auto& line : lines) {
      if (line.size() == 2) {
        add_pieces(line, polygon.lines);
        continue;
      }
      auto& finer_line = polygon.lines.emplace_back();
      for (std::size_t i = 0; i < line.size(); ++i) {
        const auto piece = pieces_of(line[i], line[(i + 1) % line.size()]);
        finer_line.insert(finer_line.end(), piece.begin(), piece.end());
      }
    }
  }
  return finer;
}

void agree(const PiecewiseLinearInput& input, int& valid) {
  show(input);
  const auto complex = validated(input);
  valid += complex.has_value() ? 1 : 0;
  if (!complex) RC_LOG(std::string(identifier(complex.error().front().kind)));
  RC_ASSERT(complex.has_value() == ByDefinition(input).is_complex());
  if (*below(4) > 0) return;
  RC_ASSERT(complex.has_value() == validated(divided(input), 1).has_value());
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

// A square at z = 1 and an upright one through it, from vertex to vertex, with more cells about
// them: tiles have edges that are not segments, and only the segment 4 5 may make such a pair
// legal.
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

TEST_CASE("PLC validity: segments cover what two polygons have in common, without a gap") {
  for (unsigned listed = 0; listed < 8; ++listed) {
    CAPTURE(listed);
    PiecewiseLinearInput input;
    input.points = {{0, 0, 1}, {5, 0, 1}, {5, 4, 1}, {0, 4, 1}, {1, 2, 1},
                    {2, 2, 1}, {3, 2, 1}, {4, 2, 1}, {2, 2, 0}, {2, 2, 2}};
    input.polygons = {{{{0, 1, 2, 3}}, {}}, {{{4, 8, 7, 9}}, {}}};
    for (Vertex i = 0; i < 3; ++i) {
      if ((listed >> i) % 2 == 1) input.segments.push_back({4 + i, 5 + i});
    }
    CHECK(validated(input).has_value() == (listed == 7));
    CHECK(ByDefinition(input).is_complex() == (listed == 7));
  }
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
