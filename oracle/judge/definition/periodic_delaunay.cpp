#include "oracle/judge/definition/periodic_delaunay.hpp"

#include <algorithm>
#include <optional>

#include "kernel/complex/circumball.hpp"
#include "kernel/complex/improper_intersection.hpp"
#include "kernel/complex/measure.hpp"
#include "kernel/exact/int64.hpp"
#include "kernel/exact/interruption.hpp"
#include "kernel/exact/linear_algebra.hpp"
#include "kernel/predicates/orientation.hpp"
#include "oracle/judge/definition/simplicial_complex.hpp"

namespace circumspect::definition {
namespace {

Point in_multiples(const std::vector<Point>& lattice, const Point& point) {
  RationalMatrix rows(lattice.size(), std::vector<Rational>(lattice.size()));
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    for (std::size_t axis = 0; axis < lattice.size(); ++axis) rows[axis][i] = lattice[i][axis];
  }
  return *solve(rows, point);
}

bool is_in(const Bounds& box, const Point& point) {
  for (std::size_t axis = 0; axis < point.size(); ++axis) {
    if (point[axis] < box.low[axis] || point[axis] > box.high[axis]) return false;
  }
  return true;
}

class PeriodicDefinition {
 public:
  PeriodicDefinition(const ExactMesh& mesh, const Copies& copies, Verdict& verdict)
      : mesh_(mesh), copies_(copies), verdict_(verdict) {}

  void judge() {
    const std::size_t d = mesh_.points.ambient_dimension();
    if (!judge_each_simplex(mesh_, d + 1, verdict_) || !judge_every_two_moved()) return;
    if (times_covered(mesh_, copies_) < 1) return add_bare_facet();
    if (judge_vertices()) judge_balls();
  }

 private:
  std::vector<Point> corners(std::size_t cell, const Point& shift) const {
    std::vector<Point> all = coordinates(mesh_.points, mesh_.simplices[cell]);
    for (Point& corner : all) corner = corner + shift;
    return all;
  }

  // Do a cell and another, moved, meet in the hull of their common corners, and are not the same?
  bool meet_properly(std::size_t a, std::vector<Point> of_b) const {
    std::vector<Point> of_a = corners(a, Point(of_b.front().size(), 0));
    if (improper_intersection(of_a, of_b)) return false;
    std::sort(of_a.begin(), of_a.end());
    std::sort(of_b.begin(), of_b.end());
    return of_a != of_b;
  }

  bool judge_every_two_moved() {
    bool all = true;
    const Point nowhere(copies_.lattice.size(), 0);
    for (std::size_t a = 0; a < mesh_.simplices.size(); ++a) {
      const Bounds box = bounds_of(corners(a, nowhere));
      for (std::size_t b = a; b < mesh_.simplices.size(); ++b) {
        const Bounds other = bounds_of(corners(b, nowhere));
        const Bounds ways{box.low - other.high, box.high - other.low};
        for_each_shift(copies_.lattice, ways, [&](const Simplex& way) {
          // Of a cell and itself, one of two opposite ways is enough, and no way is none.
          if (a == b && way <= Simplex(way.size(), 0)) return true;
          if (meet_properly(a, corners(b, copies_.shift(way)))) return true;
          all = false;
          verdict_.add(Rule::kOverlap, {.simplices = {mesh_.simplices[a], mesh_.simplices[b]},
                                        .places = {a, b},
                                        .values = shift_in_words(way)});
          return true;
        });
      }
    }
    return all;
  }

  // The cells form a complex that does not cover everything, so one of its facets is in its
  // boundary.
  void add_bare_facet() {
    for (const Simplex& cell : mesh_.simplices) {
      for (std::size_t place = 0; place < cell.size(); ++place) {
        const Simplex facet = facet_opposite(cell, place);
        if (cells_with(facet) > 1) continue;
        verdict_.add(Rule::kNotClosed, {.simplices = {cell}, .face = facet});
      }
    }
  }

  std::size_t cells_with(const Simplex& facet) const {
    std::vector<Point> own = coordinates(mesh_.points, facet);
    std::sort(own.begin(), own.end());
    std::size_t count = 0;
    for (const Simplex& cell : mesh_.simplices) {
      for (std::size_t place = 0; place < cell.size(); ++place) {
        std::vector<Point> other = coordinates(mesh_.points, facet_opposite(cell, place));
        std::sort(other.begin(), other.end());
        const Point way = own.front() - other.front();
        for (Point& corner : other) corner = corner + way;
        if (own != other) continue;
        for_each_shift(copies_.lattice, {way, way}, [&](const Simplex&) {
          ++count;
          return true;
        });
      }
    }
    return count;
  }

  bool judge_vertices() {
    std::vector<bool> is_used(copies_.listed);
    for (const Simplex& cell : mesh_.simplices) {
      for (const Vertex v : cell) {
        is_used[static_cast<std::size_t>(copies_.of[static_cast<std::size_t>(v)])] = true;
      }
    }
    for (std::size_t v = 0; v < is_used.size(); ++v) {
      if (!is_used[v]) verdict_.add(Rule::kUnusedPoint, {.vertices = {static_cast<Vertex>(v)}});
    }
    return std::count(is_used.begin(), is_used.end(), false) == 0;
  }

  void judge_balls() {
    for (const Simplex& cell : mesh_.simplices) {
      const Ball ball = circumball(mesh_.points, cell);
      // The sum of the coordinates of a radius is no shorter than it.
      Rational reach = 0;
      for (const Rational& x : mesh_.points[cell.front()] - ball.centre) reach += abs(x);
      const Point far(ball.centre.size(), reach);
      for (Vertex v = 0; v < static_cast<Vertex>(copies_.listed); ++v) {
        const Point way = ball.centre - mesh_.points[v];
        for_each_shift(copies_.lattice, {way - far, way + far}, [&](const Simplex& shift) {
          const Point point = mesh_.points[v] + copies_.shift(shift);
          if (squared_distance(point, ball.centre) < ball.squared_radius) {
            verdict_.add(Rule::kVertexInBall,
                         {.simplices = {cell}, .vertices = {v}, .ball = ball, .point = point});
          }
          return true;
        });
      }
    }
  }

  const ExactMesh& mesh_;
  const Copies& copies_;
  Verdict& verdict_;
};

}  // namespace

Bounds bounds_of(const std::vector<Point>& points) {
  Bounds box{points.front(), points.front()};
  for (const Point& point : points) {
    for (std::size_t axis = 0; axis < point.size(); ++axis) {
      box.low[axis] = std::min(box.low[axis], point[axis]);
      box.high[axis] = std::max(box.high[axis], point[axis]);
    }
  }
  return box;
}

// Multiples are linear in the sum, so within the box they lie between those of its corners. Nobody
// counts to 2^62, so what lies beyond is not looked at.
void for_each_shift(const std::vector<Point>& lattice, const Bounds& box,
                    const std::function<bool(const Simplex&)>& visit) {
  const std::size_t d = lattice.size();
  std::vector<Point> of_corners;
  for (std::size_t some = 0; some < std::size_t{1} << d; ++some) {
    Point corner = box.low;
    for (std::size_t axis = 0; axis < d; ++axis) {
      if ((some >> axis) % 2 == 1) corner[axis] = box.high[axis];
    }
    of_corners.push_back(in_multiples(lattice, corner));
  }
  const Bounds range = bounds_of(of_corners);
  const Integer most = to_integer(Vertex{1} << 62U);
  Simplex first, last;
  for (std::size_t i = 0; i < d; ++i) {
    const Integer low = -rounded_down(Rational(-range.low[i]));
    const Integer high = rounded_down(range.high[i]);
    if (low > high) return;
    first.push_back(*to_int64(std::clamp(low, Integer(-most), most)));
    last.push_back(*to_int64(std::clamp(high, Integer(-most), most)));
  }
  const Copies moves{.lattice = lattice};
  for (Simplex way = first;;) {
    end_if_interrupted();
    if (is_in(box, moves.shift(way)) && !visit(way)) return;
    std::size_t place = d;
    while (place > 0 && way[place - 1] == last[place - 1]) {
      --place;
      way[place] = first[place];
    }
    if (place == 0) return;
    ++way[place - 1];
  }
}

Rational times_covered(const ExactMesh& mesh, const Copies& copies) {
  const std::size_t d = copies.lattice.size();
  const auto axes = std::span(kSpace).first(d);
  std::vector<Point> frame = copies.lattice;
  frame.emplace_back(d, 0);
  Rational whole = measure(PointSet(frame), axes, first_subset(d + 1));
  for (std::size_t i = 2; i <= d; ++i) whole *= static_cast<long>(i);
  return measure(mesh.points, axes, mesh.simplices) / whole;
}

std::vector<NamedValue> shift_in_words(const Simplex& multiples) {
  std::vector<NamedValue> values;
  for (std::size_t i = 0; i < multiples.size(); ++i) {
    values.push_back(
        {"the second is moved along lattice vector " + std::to_string(i + 1) + " this many times",
         multiples[i]});
  }
  return values;
}

void judge_periodic_delaunay(const ExactMesh& mesh, const Copies& copies, Verdict& verdict) {
  PeriodicDefinition(mesh, copies, verdict).judge();
}

}  // namespace circumspect::definition
