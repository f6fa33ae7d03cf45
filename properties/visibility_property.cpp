// Respecting a complex and visibility in it, against the definitions applied to single points; and
// the visibility that constructions use against the one that judges by definition. Book:
// Definitions 2.11 and 2.13, quoted in Section 4.5.2.
#include <algorithm>

#include <doctest/doctest.h>

#include "kernel/exact/linear_algebra.hpp"
#include "kernel/exact/point.hpp"
#include "kernel/piecewise_linear/visibility.hpp"
#include "kernel/predicates/intersection.hpp"
#include "oracle/judge/definition/visibility.hpp"
#include "properties/arguments/complexes.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::properties {
namespace {

using Points = std::vector<Point>;

// Does a polygon, or a segment, contain the segment xy, given its parts' intersections with that?
bool contains_all(std::vector<Points> parts, const Point& x, const Point& y) {
  std::erase_if(parts, [](const Points& part) { return part.size() < 2; });
  for (Points& part : parts) {
    if ((part[0] < part[1]) != (x < y)) std::swap(part[0], part[1]);
  }
  const auto before = [&](const Point& p, const Point& q) { return x < y ? p < q : q < p; };
  Point reached = x;
  for (bool grows = true; grows;) {
    grows = false;
    for (const Points& part : parts) {
      if (before(reached, part[0]) || !before(reached, part[1])) continue;
      reached = part[1];
      grows = true;
    }
  }
  return reached == y;
}

// Does a cell, given as vertices, segments or triangles, meet xy in a union of faces of xy?
bool meets_in_faces(const std::vector<Points>& cell, const Point& x, const Point& y) {
  std::vector<Points> parts;
  for (const Points& simplex : cell) {
    Points common = intersection({x, y}, simplex);
    if (!common.empty()) parts.push_back(common);
  }
  if (contains_all(parts, x, y)) return true;
  return std::all_of(parts.begin(), parts.end(), [&](const Points& part) {
    return part.size() == 1 && (part[0] == x || part[0] == y);
  });
}

// Definition 2.13 for two points x and y whose segment xy does not cross σ's own cells.
bool see_each_other(const PiecewiseLinearComplex& complex, const Regions& regions, const Point& x,
                    const Point& y) {
  bool in_domain = false;
  for (const Point& vertex : complex.points.points()) {
    if (!meets_in_faces({{vertex}}, x, y)) return false;
  }
  for (const Simplex& segment : complex.segments) {
    const Points ends = coordinates(complex.points, segment);
    if (!meets_in_faces({ends}, x, y)) return false;
    in_domain = in_domain || intersection({x, y}, ends).size() == 2;
  }
  for (const Polygon& polygon : complex.polygons) {
    std::vector<Points> triangles;
    for (const Simplex& t : polygon.triangles) triangles.push_back(coordinates(complex.points, t));
    if (!meets_in_faces(triangles, x, y)) return false;
  }
  const Where where = regions.locate(Rational(1, 2) * (x + y));
  return in_domain || where == Where::kInside || where == Where::kOnWall;
}

// Barycentric coordinates; none if the point is not in the affine hull.
std::vector<Rational> barycentric(const Points& simplex, const Point& point) {
  const AffineHull hull = affine_hull(simplex);
  Points all = simplex;
  all.push_back(point);
  if (affine_hull(all).dimension > hull.dimension) return {};
  RationalMatrix rows;
  std::vector<Rational> right;
  for (const std::size_t axis : hull.axes) {
    rows.emplace_back();
    for (const Point& p : simplex) rows.back().push_back(p[axis]);
    right.push_back(point[axis]);
  }
  rows.emplace_back(simplex.size(), 1);
  right.emplace_back(1);
  return *solve(rows, right);
}
bool lies_inside(const Points& simplex, const Point& point) {
  const std::vector<Rational> weights = barycentric(simplex, point);
  return !weights.empty() &&
         std::all_of(weights.begin(), weights.end(), [](const auto& w) { return w > 0; });
}

using Cell = std::vector<Points>;  // vertices, segments or triangles

std::vector<Cell> cells_of(const PiecewiseLinearComplex& complex) {
  std::vector<Cell> cells;
  for (const Point& vertex : complex.points.points()) cells.push_back({{vertex}});
  for (const Simplex& s : complex.segments) cells.push_back({coordinates(complex.points, s)});
  for (const Polygon& polygon : complex.polygons) {
    cells.emplace_back();
    for (const Simplex& t : polygon.triangles) {
      cells.back().push_back(coordinates(complex.points, t));
    }
  }
  return cells;
}

// Have the relative interior of a simplex and another simplex a point in common? Among the points
// of both, one whose least barycentric coordinate in the first is as large as it can be.
bool meets_interior(const Points& simplex, const Points& part) {
  const std::size_t n = simplex.size(), m = part.size(), d = simplex[0].size();
  LinearProgram program;
  program.equations.assign(d + 2, std::vector<Rational>(1 + n + m));
  program.right_sides.assign(d + 2, 0);
  program.right_sides[d] = program.right_sides[d + 1] = 1;
  program.objective.assign(1 + n + m, 0);
  program.objective[0] = 1;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t axis = 0; axis < d; ++axis) {
      program.equations[axis][0] += simplex[i][axis];
      program.equations[axis][1 + i] = simplex[i][axis];
    }
    program.equations[d][0] += 1;
    program.equations[d][1 + i] = 1;
  }
  for (std::size_t j = 0; j < m; ++j) {
    for (std::size_t axis = 0; axis < d; ++axis) {
      program.equations[axis][1 + n + j] = -part[j][axis];
    }
    program.equations[d + 1][1 + n + j] = 1;
  }
  const LinearProgramAnswer answer = maximize(program);
  return answer.status == LinearProgramStatus::kOptimal && answer.value > 0;
}

// Twice the area of a convex polygon's projection.
Rational area(const Points& polygon, const std::vector<std::size_t>& axes) {
  Rational sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    sum += cross_product(polygon[i], polygon[(i + 1) % polygon.size()], axes[0], axes[1]);
  }
  return abs(sum);
}

bool is_contained(const Points& simplex, const Cell& cell) {
  if (simplex.size() > cell[0].size()) return false;
  std::vector<Points> parts;
  for (const Points& part : cell) parts.push_back(intersection(simplex, part));
  if (simplex.size() == 2) return contains_all(parts, simplex[0], simplex[1]);
  if (simplex.size() == 1) {
    return std::any_of(parts.begin(), parts.end(), [](const Points& p) { return !p.empty(); });
  }
  const auto axes = affine_hull(simplex).axes;
  Rational covered = 0;
  for (const Points& part : parts) covered += area(part, axes);
  return covered == area(simplex, axes);
}

// Definition 2.11: every face of the simplex is within a cell or disjoint from it, relative
// interiors of faces meant.
bool respects_by_definition(const PiecewiseLinearComplex& complex, const Regions& regions,
                            const Simplex& simplex) {
  const std::vector<Cell> cells = cells_of(complex);
  bool in_domain = regions.locate(barycentre(complex.points, simplex)) == Where::kInside;
  for (unsigned chosen = 1; chosen < 1u << simplex.size(); ++chosen) {
    Simplex face;
    for (std::size_t i = 0; i < simplex.size(); ++i) {
      if (chosen >> i & 1u) face.push_back(simplex[i]);
    }
    const Points corners = coordinates(complex.points, face);
    for (const Cell& cell : cells) {
      const bool meets = std::any_of(cell.begin(), cell.end(), [&](const Points& part) {
        return meets_interior(corners, part);
      });
      const bool contained = meets && is_contained(corners, cell);
      if (meets && !contained) return false;
      in_domain = in_domain || (contained && face.size() == simplex.size());
    }
  }
  return in_domain;
}

Point random_point_in(const Points& simplex) {
  Point sum(simplex[0].size());
  Rational total = 0;
  for (const Point& p : simplex) {
    const Rational weight = *rc::gen::inRange(1, 12);
    sum = sum + weight * p;
    total += weight;
  }
  return (1 / total) * sum;
}

// A simplex of the complex's vertices, with 1 to d + 1 of them, independent.
Simplex random_simplex(const PiecewiseLinearComplex& complex) {
  const auto n = static_cast<Vertex>(complex.points.size());
  const auto most = static_cast<int>(complex.ambient_dimension()) + 2;
  Simplex simplex;
  const int size = *rc::gen::inRange(1, most);
  for (int tries = 0; static_cast<int>(simplex.size()) < size && tries < 20; ++tries) {
    const Vertex v = *rc::gen::inRange<Vertex>(0, n);
    if (contains(simplex, v)) continue;
    simplex.push_back(v);
    if (affine_hull(coordinates(complex.points, simplex)).dimension + 1 !=
        static_cast<int>(simplex.size())) {
      simplex.pop_back();
    }
  }
  return simplex;
}

void assert_visible_iff_seen(const PiecewiseLinearComplex& complex, const Regions& regions,
                             Vertex v, const Simplex& simplex) {
  const Points corners = coordinates(complex.points, simplex);
  const bool visible = is_visible(complex, regions, v, simplex);
  const auto from = visible_point(complex, regions, v, simplex);
  RC_ASSERT(from.has_value() == visible);
  if (from) {
    RC_ASSERT(lies_inside(corners, *from));
    RC_ASSERT(see_each_other(complex, regions, *from, complex.points[v]));
    return;
  }
  for (int i = 0; i < 8; ++i) {
    const Point x = random_point_in(corners);
    RC_ASSERT(!see_each_other(complex, regions, x, complex.points[v]));
  }
}

void assert_laws(const PiecewiseLinearComplex& complex, int simplices) {
  if (complex.points.empty()) return;
  const Regions regions(complex);
  for (int i = 0; i < simplices; ++i) {
    const Simplex simplex = random_simplex(complex);
    const bool does = respects(complex, regions, simplex);
    RC_ASSERT(does == respects_by_definition(complex, regions, simplex));
    if (!does) continue;
    for (Vertex v = 0; complex.points.names(v); ++v) {
      if (contains(simplex, v)) continue;
      assert_visible_iff_seen(complex, regions, v, simplex);
    }
  }
}

TEST_CASE("visible iff a point is seen (Definitions 2.11, 2.13)") {
  CHECK(holds("visibility in the plane", 60,
              [] { assert_laws((*generators::planar_complexes(9)).complex(), 12); }));
  CHECK(holds("visibility in space", 60,
              [] { assert_laws((*generators::any_complex(9)).complex(), 12); }));
}

// Of every simplex that respects a complex, and every vertex in its affine hull: what gift-wrapping
// calls visible is what the definition does.
void assert_same(const PiecewiseLinearComplex& complex, int& seen, int& unseen) {
  if (complex.points.size() < 4) return;
  const Regions regions(complex);
  for (const std::size_t size : {3, 4}) {
    Simplex simplex = first_subset(size);
    do {
      const Points corners = coordinates(complex.points, simplex);
      const int dimension = affine_hull(corners).dimension;
      if (dimension + 1 < static_cast<int>(size) || !respects(complex, regions, simplex)) continue;
      for (Vertex v = 0; complex.points.names(v); ++v) {
        Points all = corners;
        all.push_back(complex.points[v]);
        if (contains(simplex, v) || affine_hull(all).dimension > dimension) continue;
        const bool visible = is_visible(complex, regions, v, simplex);
        RC_ASSERT(definition::is_visible(complex, v, simplex) == visible);
        (visible ? seen : unseen) += 1;
      }
    } while (next_subset(simplex, complex.points.size()));
  }
}

TEST_CASE("the visibility that constructions use is the one that judges (Definition 2.13)") {
  int seen = 0, unseen = 0;
  CHECK(holds("the same in the plane", 10,
              [&] { assert_same((*generators::planar_complexes(9)).complex(), seen, unseen); }));
  CHECK(holds("the same in space", 10,
              [&] { assert_same((*generators::any_complex(7)).complex(), seen, unseen); }));
  CHECK(occurs(seen, 50));
  CHECK(occurs(unseen, 50));
}

}  // namespace
}  // namespace circumspect::properties
