#include "oracle/judge/definition/voronoi_structure.hpp"

#include <algorithm>

#include "kernel/complex/circumball.hpp"
#include "kernel/exact/linear_algebra.hpp"
#include "oracle/judge/definition/voronoi.hpp"

namespace circumspect::definition {
namespace {

bool is_in(const JudgedBox& box, const Point& point) {
  const std::vector<Halfspace> halves = halfspaces_of(box);
  return std::all_of(halves.begin(), halves.end(), [&](const Halfspace& half) {
    return inner_product(half.normal, point) <= half.offset;
  });
}

Simplex nearest_sites(const PointSet& sites, const Point& point) {
  Simplex nearest;
  Rational least = squared_distance(point, sites[0]);
  for (Vertex s = 0; sites.names(s); ++s)
    least = std::min(least, squared_distance(point, sites[s]));
  for (Vertex s = 0; sites.names(s); ++s) {
    if (squared_distance(point, sites[s]) == least) nearest.push_back(s);
  }
  return nearest;
}

// Equations for a point x, the difference of two that are not negative, and for unknowns that are
// not negative, one for each halfspace: how far x is inside of it.
class Inside {
 public:
  Inside(std::size_t dimension, std::size_t halves) : d_(dimension), halves_(halves) {}

  // The first unknowns are those of halfspaces.
  void be_in(const Halfspace& half, const Rational& sign_of_depth = 1) {
    std::vector<Rational> row(halves_, 0);
    row[rows_.size() - on_boundaries_] = sign_of_depth;
    add(std::move(row), half);
  }
  void be_on_boundary(const Halfspace& half) {
    ++on_boundaries_;
    add(std::vector<Rational>(halves_, 0), half);
  }
  bool is_solvable(std::size_t positive) const {
    return circumspect::is_solvable(rows_, right_sides_, positive);
  }

 private:
  void add(std::vector<Rational> row, const Halfspace& half) {
    for (std::size_t axis = 0; axis < d_; ++axis) {
      row.push_back(half.normal[axis]);
      row.push_back(-half.normal[axis]);
    }
    rows_.push_back(std::move(row));
    right_sides_.push_back(half.offset);
  }

  std::size_t d_, halves_, on_boundaries_ = 0;
  RationalMatrix rows_ = {};
  std::vector<Rational> right_sides_ = {};
};

// Are there points that are as near to j as to i, and nearer than all other sites?
bool have_ridge(const PointSet& sites, Vertex i, Vertex j) {
  Inside point(sites.ambient_dimension(), sites.size() - 2);
  point.be_on_boundary(nearer_to(sites, i, j));
  for (Vertex other = 0; sites.names(other); ++other) {
    if (other != i && other != j) point.be_in(nearer_to(sites, i, other));
  }
  return point.is_solvable(sites.size() - 2);
}

// Is a point of both cells outside of the box?
bool leaves_box(const PointSet& sites, Vertex i, Vertex j, const JudgedBox& box) {
  for (const Halfspace& side : halfspaces_of(box)) {
    Inside point(sites.ambient_dimension(), sites.size() - 1);
    point.be_in(side, -1);
    point.be_on_boundary(nearer_to(sites, i, j));
    for (Vertex other = 0; sites.names(other); ++other) {
      if (other != i && other != j) point.be_in(nearer_to(sites, i, other));
    }
    if (point.is_solvable(1)) return true;
  }
  return false;
}

}  // namespace

VoronoiStructure exact_structure(const PointSet& sites, const JudgedBox& box) {
  VoronoiStructure structure;
  const std::size_t d = sites.ambient_dimension();
  Simplex some = first_subset(d + 1);
  if (sites.size() <= d) return structure;
  do {
    std::vector<Point> corners;
    for (const Vertex v : some) corners.push_back(sites[v]);
    if (affine_hull(corners).dimension < static_cast<int>(d)) continue;
    const Point centre = circumball(sites, some).centre;
    const Simplex nearest = nearest_sites(sites, centre);
    if (contains(nearest, some.front()) && is_in(box, centre)) {
      structure.vertices.emplace(centre, nearest);
    }
  } while (next_subset(some, sites.size()));
  for (Vertex i = 0; sites.names(i); ++i) {
    for (Vertex j = i + 1; sites.names(j); ++j) {
      VoronoiRidge ridge;
      for (const auto& [centre, nearest] : structure.vertices) {
        if (contains(nearest, i) && contains(nearest, j)) ridge.ends.push_back(centre);
      }
      if (ridge.ends.empty() || !have_ridge(sites, i, j)) continue;
      ridge.leaves_box = leaves_box(sites, i, j, box);
      structure.ridges.emplace(std::array{i, j}, std::move(ridge));
    }
  }
  return structure;
}

}  // namespace circumspect::definition
