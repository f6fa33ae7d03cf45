// In which simplex of a triangulation does each of many points lie? Book: Section 5.5 (walking).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <span>
#include <utility>
#include <vector>

namespace circumspect {

inline constexpr std::size_t kNoSimplex = static_cast<std::size_t>(-1);

// Walks from one point to the next, as long as that takes few steps a point. Where it takes many,
// as in a fan with points on all sides, the hyperplanes of facets halve points and simplices again
// and again, until few simplices are left for each point. This is near-linear if such hyperplanes
// cut few simplices. The answer is exact for every triangulation; only the time depends on it.
//
// The interface of a Triangulation; its numbers may be of any kind:
//   size(), row_size(), points()   how many simplices, vertices of each of them, and points
//   vertex(s, place)               the vertex of simplex s at that place
//   side(s, place, point)          on which side of the facet opposite that vertex the point lies:
//                                  positive on the side of the simplex, negative on the other, 0 in
//                                  its hyperplane
//   across(s, place)               the simplex beyond that facet, or kNoSimplex
// Requires: sound simplices that are a triangulation of a convex set.
template <class Triangulation>
class PointSearch {
 public:
  explicit PointSearch(const Triangulation& triangulation) : triangulation_(triangulation) {}

  // For each of the points, a simplex that contains it; kNoSimplex if none does. If several do,
  // which one is returned depends on the triangulation and the points alone.
  std::vector<std::size_t> simplices_with(std::span<const std::size_t> points) {
    points_ = points;
    found_.assign(points.size(), kNoSimplex);
    if (triangulation_.size() == 0) return found_;
    std::size_t steps = kSteps + kStepsEach * (points.size() + triangulation_.size());
    std::size_t near = 0;
    std::size_t i = 0;
    while (i < points.size() && walk(i, near, steps)) ++i;
    if (i < points.size()) {
      std::vector<std::size_t> rest(points.size() - i);
      std::iota(rest.begin(), rest.end(), i);
      std::vector<std::size_t> all(triangulation_.size());
      std::iota(all.begin(), all.end(), std::size_t{0});
      sides_.assign(triangulation_.points(), {});
      halve(std::move(rest), std::move(all));
    }
    return std::move(found_);
  }

  // How often side() has been called so far: it takes most of the time.
  std::uint64_t work() const { return work_; }

 private:
  // The limit on the steps of a walk from point to point.
  static constexpr std::size_t kSteps = 4096;
  static constexpr std::size_t kStepsEach = 8;
  // Lists with at most so many simplices, or points, are not worth halving.
  static constexpr std::size_t kFewSimplices = 32;
  static constexpr std::size_t kFewPoints = 2;
  // A hyperplane is chosen among so many, by its effect on a sample of so many simplices and
  // points.
  static constexpr std::size_t kCandidates = 6;
  static constexpr std::size_t kSample = 8;
  static constexpr int kTries = 4;

  // Items of a list, by number: points in points_, or simplices.
  using Items = std::vector<std::size_t>;

  struct Plane {
    std::size_t simplex;
    std::size_t place;
  };
  struct Parts {
    Items points[2];
    Items simplices[2];
  };
  struct Side {
    std::uint64_t asked = 0;
    int sign = 0;
  };

  int side(Plane plane, std::size_t point) {
    ++work_;
    return triangulation_.side(plane.simplex, plane.place, point);
  }

  // A vertex of the simplex whose opposite facet has the point strictly beyond it; row_size() if
  // the closed simplex contains the point.
  std::size_t place_that_hides(std::size_t s, std::size_t point) {
    std::size_t place = 0;
    while (place < triangulation_.row_size() && side({s, place}, point) >= 0) ++place;
    return place;
  }

  // Walks to point number i from simplex `near`, which becomes where the point is; beyond a facet
  // of the convex hull there is nothing. False if that takes more steps than are left: such a walk
  // can go round in circles where facets are not locally Delaunay.
  bool walk(std::size_t i, std::size_t& near, std::size_t& steps) {
    std::size_t current = near;
    for (; steps > 0; --steps) {
      const std::size_t place = place_that_hides(current, points_[i]);
      if (place == triangulation_.row_size()) {
        found_[i] = near = current;
        return true;
      }
      current = triangulation_.across(current, place);
      if (current == kNoSimplex) return true;
    }
    return false;
  }

  // These include every simplex that contains one of the points, except for a point in a hyperplane
  // that halved an earlier list.
  void halve(Items points, Items simplices) {
    while (points.size() > kFewPoints && simplices.size() > kFewSimplices) {
      Parts parts;
      if (!part(points, simplices, parts)) break;
      halve(std::move(parts.points[0]), std::move(parts.simplices[0]));
      points = std::move(parts.points[1]);
      simplices = std::move(parts.simplices[1]);
    }
    find_one_by_one(points, simplices);
  }

  // True if a hyperplane clearly reduces the work.
  bool part(const Items& points, const Items& simplices, Parts& parts) {
    for (int tries = 0; tries < kTries; ++tries) {
      parts = parted(points, simplices, best_plane(points, simplices));
      const double left = work_of(parts.points[0].size(), parts.simplices[0].size()) +
                          work_of(parts.points[1].size(), parts.simplices[1].size());
      if (left < 0.8 * work_of(points.size(), simplices.size())) return true;
    }
    return false;
  }

  static double work_of(std::size_t points, std::size_t simplices) {
    return static_cast<double>(points) * static_cast<double>(simplices);
  }

  std::size_t any(std::size_t size) { return static_cast<std::size_t>(random_() % size); }

  Plane best_plane(const Items& points, const Items& simplices) {
    Plane best{};
    double least = 0;
    for (std::size_t candidate = 0; candidate < kCandidates; ++candidate) {
      const Plane plane{simplices[any(simplices.size())], any(triangulation_.row_size())};
      std::size_t points_in[2] = {};
      std::size_t simplices_in[2] = {};
      for (std::size_t i = 0; i < kSample; ++i) {
        ++points_in[side(plane, points_[points[any(points.size())]]) > 0 ? 1 : 0];
        const auto [low, high] = extent(plane, simplices[any(simplices.size())]);
        simplices_in[0] += low < 0 ? 1 : 0;
        simplices_in[1] += high > 0 ? 1 : 0;
      }
      const double left =
          work_of(points_in[0], simplices_in[0]) + work_of(points_in[1], simplices_in[1]);
      if (candidate > 0 && left >= least) continue;
      best = plane;
      least = left;
    }
    return best;
  }

  // The least and the largest sign of the sides of the simplex's vertices.
  std::pair<int, int> extent(Plane plane, std::size_t s) {
    int low = 1;
    int high = -1;
    for (std::size_t place = 0; place < triangulation_.row_size(); ++place) {
      const int sign = side(plane, triangulation_.vertex(s, place));
      low = std::min(low, sign);
      high = std::max(high, sign);
    }
    return {low, high};
  }

  // A simplex is on each side where it has interior points. A point in the hyperplane is put on the
  // first side.
  Parts parted(const Items& points, const Items& simplices, Plane plane) {
    Parts parts;
    for (const std::size_t i : points) {
      parts.points[side(plane, points_[i]) > 0 ? 1 : 0].push_back(i);
    }
    ++asked_;
    for (const std::size_t s : simplices) {
      bool is_on[2] = {};
      for (std::size_t place = 0; place < triangulation_.row_size(); ++place) {
        const std::size_t v = triangulation_.vertex(s, place);
        if (sides_[v].asked != asked_) sides_[v] = {asked_, side(plane, v)};
        is_on[0] |= sides_[v].sign < 0;
        is_on[1] |= sides_[v].sign > 0;
      }
      for (const int half : {0, 1}) {
        if (is_on[half]) parts.simplices[half].push_back(s);
      }
    }
    return parts;
  }

  // Walks among the simplices; where a walk gives up, looks at each of them, and then at all
  // simplices.
  void find_one_by_one(const Items& points, const Items& simplices) {
    std::size_t near = simplices.empty() ? 0 : simplices[simplices.size() / 2];
    for (const std::size_t i : points) {
      std::size_t steps = simplices.size() + kFewSimplices;
      if (walk(i, near, steps) || look_at(i, simplices)) continue;
      std::vector<std::size_t> all(triangulation_.size());
      std::iota(all.begin(), all.end(), std::size_t{0});
      look_at(i, all);
    }
  }

  bool look_at(std::size_t i, const Items& simplices) {
    for (const std::size_t s : simplices) {
      if (place_that_hides(s, points_[i]) < triangulation_.row_size()) continue;
      found_[i] = s;
      return true;
    }
    return false;
  }

  const Triangulation& triangulation_;
  std::span<const std::size_t> points_;
  std::vector<std::size_t> found_;
  std::vector<Side> sides_;  // of vertices, from the hyperplane number asked_
  std::uint64_t asked_ = 0;
  std::uint64_t work_ = 0;
  std::mt19937_64 random_{5};  // the same numbers on every machine
};

}  // namespace circumspect
