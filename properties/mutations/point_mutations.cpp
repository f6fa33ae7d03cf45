#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "properties/mutations/catalogue.hpp"

namespace circumspect::properties {
namespace {

using enum Rule;

const std::set<Rule> kAnything = {
    kWrongDimension, kRepeatedVertex,  kDegenerateSimplex, kDuplicateSimplex, kUnusedPoint,
    kFacetOverused,  kOverlap,         kHullNotClosed,     kHullNotConvex,    kCoveredTwice,
    kFacetNotLocal,  kVertexSubmerged, kPointBelowPlane};

std::span<double> point(ArrayMesh& mesh, std::size_t v) {
  return std::span(mesh.coordinates).subspan(v * mesh.dimension, mesh.dimension);
}

std::size_t any_used_point(const ArrayMesh& mesh, Dice& dice) {
  return static_cast<std::size_t>(mesh.simplices[dice.below(mesh.simplices.size())]);
}

// A point that is a vertex of nothing.
void append(ArrayMesh& mesh, const std::vector<double>& x) {
  mesh.coordinates.insert(mesh.coordinates.end(), x.begin(), x.end());
}

std::vector<double> barycentre_of(ArrayMesh& mesh, std::size_t s) {
  std::vector<double> centre(mesh.dimension, 0);
  for (const std::int64_t v : mesh.row(s)) {
    const auto x = point(mesh, static_cast<std::size_t>(v));
    for (std::size_t axis = 0; axis < centre.size(); ++axis) {
      centre[axis] += x[axis] / static_cast<double>(mesh.width());
    }
  }
  return centre;
}

bool is_new(ArrayMesh& mesh, const std::vector<double>& x) {
  for (std::size_t v = 0; v < mesh.points(); ++v) {
    if (std::ranges::equal(point(mesh, v), x)) return false;
  }
  return true;
}

bool add_inside(ArrayMesh& mesh, Dice& dice) {
  const std::vector<double> centre = barycentre_of(mesh, dice.below(mesh.size()));
  if (!mesh.weights.empty() || !is_new(mesh, centre)) return false;
  append(mesh, centre);
  return true;
}

bool add_beyond(ArrayMesh& mesh, Dice& dice) {
  if (!mesh.weights.empty()) return false;
  double largest = 0;
  for (const double x : mesh.coordinates) largest = std::max(largest, std::fabs(x));
  std::vector<double> x(mesh.dimension, 0);
  x[dice.below(x.size())] = 2 * largest + 1;
  append(mesh, x);
  return std::isfinite(largest * 2);
}

// The same point; a zero is negative where the other is positive.
std::size_t append_equal(ArrayMesh& mesh, std::size_t v) {
  std::vector<double> x(point(mesh, v).begin(), point(mesh, v).end());
  for (double& number : x) number = number == 0 ? -number : number;
  append(mesh, x);
  // Of equal points the one with the largest weight counts.
  if (!mesh.weights.empty()) {
    const double weight = mesh.weights[v];
    mesh.weights.push_back(std::nextafter(weight, -std::numeric_limits<double>::max()));
  }
  return mesh.points() - 1;
}

bool add_equal(ArrayMesh& mesh, Dice& dice) {
  append_equal(mesh, any_used_point(mesh, dice));
  return true;
}

bool split_vertex(ArrayMesh& mesh, Dice& dice) {
  std::int64_t& v = mesh.simplices[dice.below(mesh.simplices.size())];
  v = static_cast<std::int64_t>(append_equal(mesh, static_cast<std::size_t>(v)));
  mesh.neighbors.clear();
  return true;
}

bool move_onto_another(ArrayMesh& mesh, Dice& dice) {
  const std::size_t a = any_used_point(mesh, dice), b = any_used_point(mesh, dice);
  std::ranges::copy(point(mesh, b), point(mesh, a).begin());
  mesh.neighbors.clear();
  return a != b;
}

bool move_far(ArrayMesh& mesh, Dice& dice) {
  const std::size_t v = any_used_point(mesh, dice);
  std::ranges::copy(barycentre_of(mesh, dice.below(mesh.size())), point(mesh, v).begin());
  return true;
}

bool move_by_one_ulp(ArrayMesh& mesh, Dice& dice) {
  double& x = point(mesh, any_used_point(mesh, dice))[dice.below(mesh.dimension)];
  const double largest = std::numeric_limits<double>::max();
  x = std::nextafter(x, dice.below(2) == 0 ? largest : -largest);
  return true;
}

// No link is named: equal points are not excluded.
bool flatten(ArrayMesh& mesh, Dice& dice) {
  const auto row = mesh.row(dice.below(mesh.size()));
  const std::size_t axis = dice.below(mesh.dimension);
  const double height = point(mesh, static_cast<std::size_t>(row[0]))[axis];
  for (const std::int64_t v : row) point(mesh, static_cast<std::size_t>(v))[axis] = height;
  mesh.neighbors.clear();
  return true;
}

// Moves the apex of a simplex through a facet towards the middle of the simplex across, until
// `arrived` just holds; `stop_before` leaves it at the last place where that does not. Of some
// facets the one with the shortest way.
template <typename Arrived>
bool move_until(ArrayMesh& mesh, Dice& dice, bool stop_before, const Arrived& arrived) {
  std::optional<std::pair<double, std::vector<double>>> best;
  std::size_t moved = 0;
  for (int i = 0; i < 8; ++i) {
    const std::size_t facet = dice.below(mesh.neighbors.size());
    if (mesh.neighbors[facet] < 0) continue;
    const auto v = static_cast<std::size_t>(mesh.simplices[facet]);
    const std::vector<double> from(point(mesh, v).begin(), point(mesh, v).end());
    const std::vector<double> to =
        barycentre_of(mesh, static_cast<std::size_t>(mesh.neighbors[facet]));
    const auto go = [&](double way) {
      for (std::size_t axis = 0; axis < from.size(); ++axis) {
        point(mesh, v)[axis] = from[axis] + way * (to[axis] - from[axis]);
      }
      return arrived(facet);
    };
    double before = 0, after = 1;
    for (int step = 0; step < 60 && go(after); ++step) {
      const double middle = before + (after - before) / 2;
      (go(middle) ? after : before) = middle;
    }
    if (go(after) && (!best || after < best->first)) {
      if (stop_before) go(before);
      best = {after, {point(mesh, v).begin(), point(mesh, v).end()}};
      moved = v;
    }
    std::ranges::copy(from, point(mesh, v).begin());
  }
  if (best) std::ranges::copy(best->second, point(mesh, moved).begin());
  return best.has_value();
}

bool move_into_ball(ArrayMesh& mesh, Dice& dice) {
  return move_until(mesh, dice, false, [&](std::size_t facet) {
    const auto across = static_cast<std::size_t>(mesh.neighbors[facet]);
    return in_ball_of(mesh, mesh.row(across), mesh.simplices[facet]) > 0;
  });
}

bool move_up_to_ball(ArrayMesh& mesh, Dice& dice) {
  return move_until(mesh, dice, true, [&](std::size_t facet) {
    const auto across = static_cast<std::size_t>(mesh.neighbors[facet]);
    return in_ball_of(mesh, mesh.row(across), mesh.simplices[facet]) > 0;
  });
}

bool move_through_facet(ArrayMesh& mesh, Dice& dice) {
  return move_until(mesh, dice, false, [&](std::size_t facet) {
    const std::size_t other = other_side(mesh, facet);
    std::vector<std::int64_t> row(mesh.row(other / mesh.width()).begin(),
                                  mesh.row(other / mesh.width()).end());
    const int own = orientation_of(mesh, row);
    row[other % mesh.width()] = mesh.simplices[facet];
    return orientation_of(mesh, row) * own >= 0;
  });
}

bool mirror(ArrayMesh& mesh, Dice& dice) {
  const std::size_t axis = dice.below(mesh.dimension);
  for (std::size_t v = 0; v < mesh.points(); ++v) {
    double& x = point(mesh, v)[axis];
    x = -x;
  }
  return true;
}

// By so much that no other weight counts beside it.
bool change_weight(ArrayMesh& mesh, std::size_t v, int sign) {
  if (mesh.weights.empty()) return false;
  double largest = 1;
  for (const double x : mesh.coordinates) largest = std::max(largest, std::fabs(x));
  double heaviest = 0;
  for (const double w : mesh.weights) heaviest = std::max(heaviest, std::fabs(w));
  mesh.weights[v] = sign * (64 * largest * largest + 4 * heaviest);
  return std::isfinite(mesh.weights[v]);
}

bool raise_weight(ArrayMesh& mesh, Dice& dice) {
  return change_weight(mesh, any_used_point(mesh, dice), 1);
}
bool lower_weight(ArrayMesh& mesh, Dice& dice) {
  return change_weight(mesh, any_used_point(mesh, dice), -1);
}

bool raise_weight_of_submerged(ArrayMesh& mesh, Dice&) {
  std::vector<bool> used(mesh.points(), false);
  for (const std::int64_t v : mesh.simplices) used[static_cast<std::size_t>(v)] = true;
  const auto submerged = std::find(used.begin(), used.end(), false);
  if (submerged == used.end()) return false;
  return change_weight(mesh, static_cast<std::size_t>(submerged - used.begin()), 1);
}

}  // namespace

std::vector<Mutation> point_mutations() {
  return {
      {"unused-inside",
       "A point inside is not a vertex.",
       Expected::kFails,
       {kUnusedPoint},
       add_inside},
      {"unused-beyond",
       "A point beyond the hull is not a vertex.",
       Expected::kFails,
       {kUnusedPoint},
       add_beyond},
      {"equal-point",
       "A point that is not a vertex is equal to a vertex, but for signs of zeros.",
       Expected::kEqualPoints,
       {},
       add_equal},
      {"vertex-split",
       "One simplex has a copy of a vertex in its place.",
       Expected::kEqualPoints,
       {},
       split_vertex},
      {"moved-onto-another", "A vertex has the coordinates of another.", Expected::kFails,
       kAnything, move_onto_another},
      {"moved-elsewhere",
       "A vertex has been moved into another simplex.",
       Expected::kEither,
       {},
       move_far},
      {"moved-by-one-ulp",
       "A coordinate is the next double.",
       Expected::kEither,
       {},
       move_by_one_ulp},
      {"flattened",
       "All vertices of a simplex have one coordinate in common.",
       Expected::kFails,
       {kWrongDimension, kRepeatedVertex, kDegenerateSimplex},
       flatten},
      {"moved-into-ball", "A vertex has been moved into the ball of the simplex across, just so.",
       Expected::kFails, kAnything, move_into_ball},
      {"moved-up-to-ball",
       "Likewise, but for one step of the doubles.",
       Expected::kEither,
       {},
       move_up_to_ball},
      {"moved-through-facet", "A vertex has been moved onto the facet opposite, or just beyond.",
       Expected::kFails, kAnything, move_through_facet},
      {"mirrored", "All points are mirrored.", Expected::kHolds, {}, mirror},
      {"weight-raised",
       "A vertex has a weight that leaves its neighbours submerged.",
       Expected::kEither,
       {},
       raise_weight,
       true},
      {"weight-lowered",
       "A vertex has a weight that submerges it, unless it is on the hull.",
       Expected::kEither,
       {},
       lower_weight,
       true},
      {"submerged-point-raised",
       "A submerged point has a weight that no point of the hull has.",
       Expected::kFails,
       {kPointBelowPlane},
       raise_weight_of_submerged,
       true},
  };
}

}  // namespace circumspect::properties
