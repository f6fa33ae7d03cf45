#include "construct/edge_protection.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <variant>

#include "kernel/exact/each_once.hpp"
#include "kernel/predicates/in_ball.hpp"
#include "oracle/judge/fast/predicates/arithmetic.hpp"
#include "oracle/judge/fast/predicates/predicates.hpp"

namespace circumspect::construct {
namespace {

using delaunay::Delaunayhood;

std::uint64_t edge_number(Vertex a, Vertex b) {
  const auto [low, high] = std::minmax(a, b);
  return static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint64_t>(high);
}

template <std::size_t kDimension>
bool is_on_sphere_of_doubles(const Rows<double>& points, const Simplex& simplex, Vertex v) {
  const auto site = [&](Vertex of) {
    fast::Site<kDimension> made;
    const auto row = points.row(static_cast<std::size_t>(of));
    std::copy(row.begin(), row.end(), made.at.begin());
    return made;
  };
  const auto ball = [&] {
    if constexpr (kDimension == 2) {
      return fast::Ball<2>(site(simplex[0]), site(simplex[1]), site(simplex[2]));
    } else {
      return fast::Ball<3>(site(simplex[0]), site(simplex[1]), site(simplex[2]), site(simplex[3]));
    }
  }();
  fast::Stages stages;
  return ball.contains(site(v), stages) == 0;
}

}  // namespace

bool EdgeProtection::is_on_sphere(const Simplex& simplex, Vertex v) const {
  if (const auto* const doubles = std::get_if<Rows<double>>(&coordinates_)) {
    if (simplex.size() == 4) return is_on_sphere_of_doubles<3>(*doubles, simplex, v);
    if (simplex.size() == 3) return is_on_sphere_of_doubles<2>(*doubles, simplex, v);
  }
  return in_ball(complex_.points.configuration(), simplex, v) == 0;
}

// Has no facet at an edge a tie, that is, the apex of one of its simplices on the circumsphere of
// the other? Then the circumcentres of the edge's star are different wherever simplices share a
// facet. They are the corners of the edge's face in the Voronoi diagram, whose sides are at right
// angles to these facets, no two of which are parallel. So the face has as many dimensions as the
// bisector of the ends, and a point inside of it is the centre of a ball that no other vertex
// touches: the edge is strongly Delaunay.
bool EdgeProtection::has_no_ties(const std::vector<Simplex>& star) const {
  for (std::size_t i = 0; i < star.size(); ++i) {
    for (std::size_t j = i + 1; j < star.size(); ++j) {
      const Simplex others = without(star[j], star[i]);
      if (others.size() > 1) continue;  // no facet in common
      if (is_on_sphere(star[i], others.front())) return false;
    }
  }
  return true;
}

EdgeProtection::EdgeProtection(const PiecewiseLinearComplex& complex, const Progress& progress)
    : complex_(complex) {
  const std::size_t d = complex.ambient_dimension();
  const bool spans = complex.points.dimension() == static_cast<int>(d);
  if (spans && !complex.points.is_weighted() && fast::arithmetic_is_as_proved()) {
    coordinates_ = numbers_of(complex.points.points(), d);
  }
  const CanonicalDelaunay canonical = any_canonical_delaunay(complex.points, progress);
  is_unique_ = canonical.is_known_unique;
  simplices_ = canonical.triangulation.simplices();
  for (const Simplex& simplex : simplices_) {
    for (std::size_t i = 0; i < simplex.size(); ++i) {
      for (std::size_t j = i + 1; j < simplex.size(); ++j) {
        edges_.push_back(edge_number(simplex[i], simplex[j]));
      }
    }
  }
  keep_each_once(edges_);
}

bool EdgeProtection::has_edge(const Simplex& segment) const {
  return std::binary_search(edges_.begin(), edges_.end(), edge_number(segment[0], segment[1]));
}

bool EdgeProtection::holds_under_perturbation() const {
  return std::all_of(complex_.segments.begin(), complex_.segments.end(),
                     [&](const Simplex& segment) { return has_edge(segment); });
}

// The simplices at these vertices: the whole star of each of them, and of each edge that has one.
StarIndex EdgeProtection::stars_at(const std::vector<bool>& at) const {
  std::vector<Simplex> some;
  std::copy_if(simplices_.begin(), simplices_.end(), std::back_inserter(some),
               [&](const Simplex& simplex) {
                 return std::any_of(simplex.begin(), simplex.end(),
                                    [&](Vertex v) { return at[static_cast<std::size_t>(v)]; });
               });
  return StarIndex(some);
}

SegmentFacts EdgeProtection::facts_of(const StarIndex& stars, const Simplex& segment) const {
  const PointSet& points = complex_.points;
  const std::vector<Simplex> star = stars.star(segment);
  if (!star.empty() && has_no_ties(star)) {
    return {segment, true, Delaunayhood::kStronglyDelaunay};
  }
  const auto found = constrained::edge_protection(points, stars, {segment}).front();
  return {segment, found.is_present, found.status.delaunayhood,
          constrained::encroaching_vertex(points, found)};
}

std::vector<SegmentFacts> EdgeProtection::segments(const Progress& progress) const {
  const auto is_known = [&](const Simplex& segment) { return is_unique_ && has_edge(segment); };
  std::vector<bool> at(complex_.points.size());
  for (const Simplex& segment : complex_.segments) {
    if (!is_known(segment)) at[static_cast<std::size_t>(segment.front())] = true;
  }
  const StarIndex stars = stars_at(at);
  std::vector<SegmentFacts> facts;
  facts.reserve(complex_.segments.size());
  for (const Simplex& segment : complex_.segments) {
    tell(progress, "segments", facts.size(), complex_.segments.size());
    facts.push_back(is_known(segment) ? SegmentFacts{segment, true, Delaunayhood::kStronglyDelaunay}
                                      : facts_of(stars, segment));
  }
  return facts;
}

}  // namespace circumspect::construct
