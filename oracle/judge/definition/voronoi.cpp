#include "oracle/judge/definition/voronoi.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace circumspect::definition {
namespace {

using Points = std::vector<Point>;

Point unit(std::size_t d, std::size_t axis, int sign) {
  Point point(d, 0);
  point[axis] = sign;
  return point;
}

bool is_in(const Halfspace& half, const Point& point) {
  return inner_product(half.normal, point) <= half.offset;
}

struct Generators {
  std::set<Point> points, directions;
  bool operator==(const Generators&) const = default;
};

Generators cut(const Generators& all, const Halfspace& half) {
  Generators kept;
  const auto along = [&](const Point& direction) { return inner_product(half.normal, direction); };
  const auto depth = [&](const Point& p) { return Rational(half.offset - along(p)); };
  for (const Point& p : all.points) {
    if (sign(depth(p)) >= 0) kept.points.insert(p);
    for (const Point& q : all.points) {
      if (sign(depth(p)) <= 0 || sign(depth(q)) >= 0) continue;
      const Rational part = depth(p) / (depth(p) - depth(q));
      kept.points.insert(p + part * (q - p));
    }
    for (const Point& r : all.directions) {
      if (sign(depth(p)) * sign(along(r)) > 0) {
        kept.points.insert(p + Rational(depth(p) / along(r)) * r);
      }
    }
  }
  for (const Point& r : all.directions) {
    if (sign(along(r)) <= 0) kept.directions.insert(r);
    for (const Point& s : all.directions) {
      if (sign(along(r)) < 0 && sign(along(s)) > 0) {
        kept.directions.insert(along(s) * r - along(r) * s);
      }
    }
  }
  return kept;
}

// Is p, or a direction, a combination of the others, with coefficients that are not negative? Those
// of points have the sum 1 for a point, and 0 for a direction.
bool is_combined(const Point& p, bool is_point, const Generators& others) {
  RationalMatrix rows(p.size() + 1);
  const auto add = [&](const Point& one, bool counts) {
    for (std::size_t axis = 0; axis < p.size(); ++axis) rows[axis].push_back(one[axis]);
    rows.back().push_back(counts ? 1 : 0);
  };
  for (const Point& point : others.points) {
    if (is_point) add(point, true);
  }
  for (const Point& direction : others.directions) add(direction, false);
  if (rows.back().empty()) return false;
  std::vector<Rational> right = p;
  right.emplace_back(is_point ? 1 : 0);
  return is_solvable(std::move(rows), std::move(right), 0);
}

// Without what the others combine to, so that few are left to be cut again.
Generators without_others(Generators all) {
  for (const bool is_point : {false, true}) {
    std::set<Point>& own = is_point ? all.points : all.directions;
    for (const Point& one : std::vector<Point>(own.begin(), own.end())) {
      own.erase(one);
      if (!is_combined(one, is_point, all)) own.insert(one);
    }
  }
  return all;
}

}  // namespace

// Those on the boundaries of one or two. If there is a line among the directions, there are also
// those that lead along an axis, and straight away from a boundary.
std::vector<Point> spanning_directions(const std::vector<Point>& normals, std::size_t d) {
  Points from_origin = normals;
  from_origin.emplace_back(d, 0);
  const bool may_have_line = affine_hull(from_origin).dimension < static_cast<int>(d);
  Points candidates;
  for (std::size_t axis = 0; axis < d; ++axis) candidates.push_back(unit(d, axis, 1));
  for (const Point& a : normals) {
    candidates.push_back(a);
    for (std::size_t axis = 0; d == 3 && axis < d; ++axis) {
      candidates.push_back(cross_product(a, unit(d, axis, 1)));
    }
  }
  if (!may_have_line) candidates.clear();
  for (const Point& a : normals) {
    if (d == 2) candidates.push_back({a[1], -a[0]});
    for (const Point& b : normals) {
      if (d == 3) candidates.push_back(cross_product(a, b));
    }
  }
  std::set<Point> found;
  for (const Point& candidate : candidates) {
    for (const int side : {1, -1}) {
      const Point direction = Rational(side) * candidate;
      const auto leads_away = [&](const Point& normal) {
        return sign(inner_product(normal, direction)) <= 0;
      };
      if (sign(squared_length(direction)) == 0) continue;
      if (!std::all_of(normals.begin(), normals.end(), leads_away)) continue;
      Rational largest = 0;  // of its coordinates: directions are the same up to their length
      for (const Rational& x : direction) largest = std::max<Rational>(largest, abs(x));
      found.insert(Rational(1 / largest) * direction);
    }
  }
  return {found.begin(), found.end()};
}

std::vector<Halfspace> halfspaces_of(const JudgedBox& box) {
  std::vector<Halfspace> halves;
  const std::size_t d = box.low.size();
  for (std::size_t axis = 0; axis < d; ++axis) {
    halves.push_back({unit(d, axis, 1), box.high[axis]});
    halves.push_back({unit(d, axis, -1), Rational(-box.low[axis])});
  }
  return halves;
}

Halfspace nearer_to(const PointSet& sites, Vertex i, Vertex j) {
  return {sites[j] - sites[i], Rational((squared_length(sites[j]) - squared_length(sites[i])) / 2)};
}

std::vector<Point> exact_corners(const PointSet& sites, Vertex site, const JudgedBox& box) {
  std::vector<Halfspace> halves = halfspaces_of(box);
  for (Vertex j = 0; sites.names(j); ++j) {
    if (j != site) halves.push_back(nearer_to(sites, site, j));
  }
  std::set<Point> corners;
  Simplex some = first_subset(box.low.size());
  do {
    RationalMatrix normals;
    std::vector<Rational> offsets;
    for (const Vertex half : some) {
      normals.push_back(halves[static_cast<std::size_t>(half)].normal);
      offsets.push_back(halves[static_cast<std::size_t>(half)].offset);
    }
    const auto corner = solve(normals, offsets);
    const auto has = [&](const Halfspace& half) { return is_in(half, *corner); };
    if (corner && std::all_of(halves.begin(), halves.end(), has)) corners.insert(*corner);
  } while (next_subset(some, halves.size()));
  return {corners.begin(), corners.end()};
}

std::vector<Point> directions_of(const VoronoiDiagram& diagram, Vertex site) {
  if (!diagram.cells[static_cast<std::size_t>(site)].is_unbounded) return {};
  Points normals;
  for (Vertex other = 0; diagram.sites.names(other); ++other) {
    if (other != site) normals.push_back(diagram.sites[other] - diagram.sites[site]);
  }
  return spanning_directions(normals, diagram.sites.ambient_dimension());
}

std::vector<Point> listed_corners(const VoronoiDiagram& diagram, Vertex site,
                                  const JudgedBox& box) {
  Generators cell;
  for (const Vertex v : diagram.cells[static_cast<std::size_t>(site)].corners) {
    cell.points.insert(diagram.vertices[static_cast<std::size_t>(v)]);
  }
  for (const Point& direction : directions_of(diagram, site)) cell.directions.insert(direction);
  cell = without_others(cell);
  for (const Halfspace& half : halfspaces_of(box)) {
    Generators kept = cut(cell, half);
    if (kept != cell) cell = without_others(std::move(kept));
  }
  return {cell.points.begin(), cell.points.end()};
}

}  // namespace circumspect::definition
