// For tests: meshes of slanted domains, whose vertices are then moved.
#pragma once

#include <algorithm>
#include <optional>
#include <random>

#include "oracle/judge/domain/domain_cases_test.hpp"
#include "oracle/judge/within/judge_within.hpp"

namespace circumspect::check {

struct MovedMesh {
  ExactMesh mesh;
  Domain domain;
};

// Vertices are moved by a few billionths.
inline const Rational kBit = Rational(1, 1'000'000'000);
inline Rational bits(long number) { return number * kBit; }
inline const Rational kSquaredLimit = Rational(1, 100'000'000'000'000);  // of 1e-7

inline Point slanted(const Point& p) {
  if (p.size() == 2) return {3 * p[0] + p[1], 2 * p[1] - p[0]};
  return {3 * p[0] + p[1], 4 * p[1] - p[0] + 2 * p[2], p[0] + 5 * p[2]};
}

inline ExactMesh with_points(const ExactMesh& mesh, std::vector<Point> points) {
  return {PointSet(std::move(points)), mesh.simplices, {}, 0, {}, mesh.faces};
}
inline ExactMesh slanted(const ExactMesh& mesh) {
  std::vector<Point> points;
  for (const Point& p : mesh.points.points()) points.push_back(slanted(p));
  return with_points(mesh, points);
}
inline PiecewiseLinearInput slanted(PiecewiseLinearInput input) {
  for (Point& p : input.points) p = slanted(p);
  for (Point& p : input.hole_seeds) p = slanted(p);
  for (PolygonLines& polygon : input.polygons) {
    for (Point& p : polygon.hole_seeds) p = slanted(p);
  }
  return input;
}

inline Point mirrored(Point p) {
  for (Rational& x : p) x = -x;
  return p;
}
// All of it on the other side of the origin: above and below, left and right are exchanged.
inline MovedMesh mirrored(const MovedMesh& moved) {
  const auto each = [](std::vector<Point> points) {
    for (Point& p : points) p = mirrored(std::move(p));
    return points;
  };
  PiecewiseLinearComplex complex = moved.domain.complex;
  complex.points = PointSet(each(complex.points.points()));
  complex.hole_seeds = each(complex.hole_seeds);
  for (Polygon& polygon : complex.polygons) polygon.hole_seeds = each(polygon.hole_seeds);
  return {with_points(moved.mesh, each(moved.mesh.points.points())), {std::move(complex)}};
}

// Vertices numbered from the other end.
inline Simplex renumbered(Simplex simplex, std::size_t points) {
  for (Vertex& v : simplex) v = static_cast<Vertex>(points) - 1 - v;
  return sorted(simplex);
}
inline ExactMesh renumbered(const ExactMesh& mesh) {
  std::vector<Point> points = mesh.points.points();
  std::reverse(points.begin(), points.end());
  ExactMesh result{PointSet(points), {}};
  for (const Simplex& simplex : mesh.simplices) {
    result.simplices.push_back(renumbered(simplex, points.size()));
  }
  for (const Simplex& face : mesh.faces) result.faces.push_back(renumbered(face, points.size()));
  return result;
}

// Every vertex moved by a few billionths along each axis.
template <class Random>
ExactMesh shaken(const ExactMesh& mesh, Random& random, long most = 4) {
  std::vector<Point> points = mesh.points.points();
  for (Point& p : points) {
    for (Rational& x : p) {
      x += kBit *
           Rational(static_cast<long>(random() % static_cast<unsigned long>(2 * most + 1)) - most);
    }
  }
  return with_points(mesh, points);
}

inline Vertex vertex_at(const PointSet& points, const Point& at) {
  for (Vertex v = 0; points.names(v); ++v) {
    if (points[v] == at) return v;
  }
  return -1;
}

// The domain that some cells of a coarse grid fill: the faces of these that no two of them share,
// and those of the others that `keep_wall` picks, each a polygon (in the plane a segment) of its
// own.
using KeepWall = std::function<bool(std::size_t number)>;
inline PiecewiseLinearInput cells_domain(
    const std::vector<int>& xs, const std::vector<int>& ys, const std::vector<int>& zs,
    const KeepCell& keep, const KeepWall& keep_wall = [](std::size_t) { return false; }) {
  const bool flat = zs.size() == 1;
  std::map<std::vector<Point>, int> walls;
  const auto point = [&](std::size_t i, std::size_t j, std::size_t k) {
    Point p = {xs[i], ys[j]};
    if (!flat) p.push_back(zs[k]);
    return p;
  };
  for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
    for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
      for (std::size_t k = 0; flat ? k < 1 : k + 1 < zs.size(); ++k) {
        if (!keep(i, j, k)) continue;
        for (std::size_t side = 0; side < 2; ++side) {
          if (flat) {
            ++walls[{point(i + side, j, 0), point(i + side, j + 1, 0)}];
            ++walls[{point(i, j + side, 0), point(i + 1, j + side, 0)}];
            continue;
          }
          const std::size_t a = i + side, b = j + side, c = k + side;
          ++walls[{point(a, j, k), point(a, j + 1, k), point(a, j + 1, k + 1), point(a, j, k + 1)}];
          ++walls[{point(i, b, k), point(i + 1, b, k), point(i + 1, b, k + 1), point(i, b, k + 1)}];
          ++walls[{point(i, j, c), point(i + 1, j, c), point(i + 1, j + 1, c), point(i, j + 1, c)}];
        }
      }
    }
  }
  PiecewiseLinearInput input;
  std::map<Point, Vertex> number;
  std::size_t wall_number = 0;
  for (const auto& [corners, times] : walls) {
    if (times == 2 && !keep_wall(wall_number++)) continue;
    std::vector<Vertex> line;
    for (const Point& corner : corners) {
      const auto [at, is_new] = number.insert({corner, static_cast<Vertex>(input.points.size())});
      if (is_new) input.points.push_back(corner);
      line.push_back(at->second);
    }
    if (flat) {
      input.segments.push_back(line);
    } else {
      input.polygons.push_back({{line}, {}});
    }
  }
  return input;
}

// With a value between every two.
inline std::vector<int> refined(const std::vector<int>& values, bool refine) {
  if (!refine) return values;
  std::vector<int> result;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) result.push_back((values[i - 1] + values[i]) / 2);
    result.push_back(values[i]);
  }
  return result;
}

// Cells of a grid at random, all of its refinements, inner walls at random, slanted; in the plane
// also a ring around a hole; or all cells, of whose walls some are handed in, as a convex hull.
template <class Random>
MovedMesh random_mesh(Random& random, std::size_t dimension) {
  const auto chance = [&] { return random() % 2 == 0; };
  std::vector<int> xs = {0, 4}, ys = {0, 4}, zs = {0, 4};
  if (chance()) xs.push_back(8);
  if (dimension == 2 && chance()) ys.push_back(8);
  if (dimension == 2 && chance()) ys.push_back(12);
  const unsigned long without = random() % 6;
  const bool ring = dimension == 2 && random() % 4 == 0;
  if (ring) xs = ys = {0, 4, 8, 12};
  const bool hull = !ring && random() % 4 == 0;
  const auto keep = [&](std::size_t i, std::size_t j, std::size_t) {
    if (ring) return i != 1 || j != 1;
    return hull || xs.size() == 2 || ys.size() == 2 || i + 2 * j != without;
  };
  const bool fine_x = chance(), fine_y = chance(), fine_z = chance();
  const unsigned long walls = random();
  if (dimension == 2) zs = {0};
  auto input =
      cells_domain(xs, ys, zs, keep, [&](std::size_t n) { return (walls >> (n % 32)) % 2 == 1; });
  if (ring) input.hole_seeds = {{6, 6}};
  if (hull) {  // some of its walls, others are to be found
    input.kind = DomainKind::kHull;
    const auto drop = [&](auto& list) {
      std::erase_if(list, [&](const auto&) { return random() % 3 > 0; });
    };
    drop(input.segments);
    drop(input.polygons);
  }
  const auto keep_fine = [&](std::size_t i, std::size_t j, std::size_t k) {
    return keep(fine_x ? i / 2 : i, fine_y ? j / 2 : j, k);
  };
  ExactMesh mesh = grid(refined(xs, fine_x), refined(ys, fine_y),
                        dimension == 2 ? zs : refined(zs, fine_z), keep_fine);
  return {slanted(mesh), domain_of(slanted(input))};
}

// One polygon in space with listed triangles for its mesh: a triangle around a triangular hole,
// whose triangle is `stray`; or a square of five triangles, with or without a vertex or a slit in
// it.
struct Sheet {
  MovedMesh moved;
  std::optional<Simplex> stray = {};
};
template <class Random>
Sheet random_sheet(Random& random) {
  PiecewiseLinearInput input;
  std::vector<Point> points;
  std::vector<Simplex> triangles;
  std::optional<Simplex> stray;
  if (random() % 2 == 0) {
    points = {{0, 0, 0}, {12, 0, 0}, {0, 12, 0}, {2, 2, 0}, {6, 2, 0}, {2, 6, 0}};
    triangles = {{0, 1, 3}, {1, 3, 4}, {1, 2, 4}, {2, 4, 5}, {0, 2, 5}, {0, 3, 5}};
    input.points = points;
    input.polygons = {{{{0, 1, 2}, {3, 4, 5}}, {{3, 3, 0}}}};
    stray = Simplex{3, 4, 5};
  } else {
    // The middle, the corners, and the middle of a side.
    points = {{4, 4, 0}, {0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}, {4, 0, 0}};
    triangles = {{0, 1, 5}, {0, 5, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
    input.points = {points[1], points[2], points[3], points[4]};
    std::vector<Vertex> line = {0, 1, 2, 3};
    const auto add = [&](const Point& point) {
      input.points.push_back(point);
      return static_cast<Vertex>(input.points.size()) - 1;
    };
    if (random() % 2 == 0) line.insert(line.begin() + 1, add(points[5]));
    input.polygons = {{{line}, {}}};
    if (random() % 2 == 0) {
      const Vertex middle = add(points[0]);
      if (random() % 2 == 0) input.segments = {{2, middle}};
    }
  }
  ExactMesh mesh{PointSet(points), {}};
  mesh.faces = triangles;
  return {{slanted(mesh), domain_of(slanted(input))}, stray};
}

// The sides and the top of a box, by its lower and its upper corners. The diagonals of the sides
// end in every second corner below.
inline void add_sides_and_top(const Vertex (&low)[4], const Vertex (&high)[4],
                              std::vector<Simplex>& triangles) {
  triangles.push_back({high[0], high[1], high[2]});
  triangles.push_back({high[0], high[2], high[3]});
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    const std::size_t end = i % 2 == 0 ? j : i, other = i % 2 == 0 ? i : j;
    triangles.push_back({low[end], high[end], high[other]});
    triangles.push_back({low[end], low[other], high[other]});
  }
}

}  // namespace circumspect::check
