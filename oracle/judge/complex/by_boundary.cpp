#include "oracle/judge/complex/by_boundary.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "kernel/complex/by_facet.hpp"
#include "kernel/exact/each_once.hpp"
#include "kernel/piecewise_linear/cell_boxes.hpp"
#include "kernel/piecewise_linear/disjoint_sets.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"
#include "oracle/judge/complex/carriers.hpp"

namespace circumspect::check {
namespace {

using Places = std::vector<std::size_t>;

// Some simplices of full dimension, and the first of the conditions that is broken.
class Conditions {
 public:
  Conditions(const Configuration& points, const std::vector<Point>& positions,
             const std::vector<Simplex>& simplices)
      : points_(points), positions_(positions), simplices_(simplices) {}

  // The simplices with which it is broken, ascending; none if they form a complex.
  Places at_fault() {
    Places found = not_matched();
    if (found.empty()) found = with_improper_facets();
    if (found.empty()) found = beside_outside();
    keep_each_once(found);
    return found;
  }

 private:
  Places not_matched() {
    Places found;
    for (const auto group : ByFacet(facet_uses(simplices_))) {
      if (group.size() == 1) {
        facets_.push_back(group.front().facet);
        owners_.push_back(group.front());
      } else if (group.size() > 2 || !are_apart(group[0], group[1])) {
        for (const FacetUse& use : group) found.push_back(use.simplex);
      }
    }
    return found;
  }

  Places with_improper_facets() const {
    Places found = improper_facets(points_, positions_, facets_);
    for (std::size_t& place : found) place = owners_[place].simplex;
    return found;
  }

  Places beside_outside() const {
    Places found;
    const CellBoxes boxes(positions_);
    const BoxIndex tree = boxes.index_of(simplices_);
    const Places class_of = class_of_each(facets_);
    for (std::size_t one = 0; one < facets_.size(); ++one) {
      if (class_of[one] != one) continue;
      const std::vector<Point> facet = corners(facets_[one]);
      const Point& own = positions_[static_cast<std::size_t>(apex(owners_[one]))];
      for (const std::size_t s : tree.meeting(boxes.of(facets_[one]))) {
        if (!has_just_outside(corners(simplices_[s]), facet, own)) continue;
        found.push_back(s);
        found.push_back(owners_[one].simplex);
      }
    }
    return found;
  }

  Vertex apex(const FacetUse& use) const { return simplices_[use.simplex][use.opposite]; }

  bool are_apart(const FacetUse& a, const FacetUse& b) const {
    return side_of_facet(points_, a.facet, apex(a)) * side_of_facet(points_, b.facet, apex(b)) < 0;
  }

  std::vector<Point> corners(const Simplex& simplex) const {
    std::vector<Point> points;
    for (const Vertex v : simplex) points.push_back(positions_[static_cast<std::size_t>(v)]);
    return points;
  }

  const Configuration& points_;
  const std::vector<Point>& positions_;
  const std::vector<Simplex>& simplices_;
  std::vector<Simplex> facets_;   // of one simplex
  std::vector<FacetUse> owners_;  // which that is
};

}  // namespace

std::vector<std::size_t> improper_facets(const Configuration& points,
                                         const std::vector<Point>& positions,
                                         const std::vector<Simplex>& facets) {
  Places found;
  const std::vector<Box> boxes = CellBoxes(positions).of(facets);
  const BoxIndex tree(boxes);
  const OrientationSigns orientation(points);
  for (std::size_t i = 0; i < facets.size(); ++i) {
    for (const std::size_t j : tree.meeting(boxes[i])) {
      if (j <= i || carriers(orientation, facets[i], facets[j]).are_proper()) continue;
      found.push_back(i);
      found.push_back(j);
    }
  }
  keep_each_once(found);
  return found;
}

// Where a ridge is in two facets, nothing is between their outer sides.
std::vector<std::size_t> class_of_each(const std::vector<Simplex>& facets) {
  DisjointSets classes(facets.size());
  const bool has_ridges = !facets.empty() && facets.front().size() > 1;
  for (const auto group : ByFacet(has_ridges ? facet_uses(facets) : std::vector<FacetUse>())) {
    if (group.size() == 2) classes.unite(group[0].simplex, group[1].simplex);
  }
  std::vector<std::size_t> class_of;
  class_of.reserve(facets.size());
  for (std::size_t i = 0; i < facets.size(); ++i) class_of.push_back(classes.find(i));
  return class_of;
}

// On which side of a facet of the simplex the points are the centre says, or, if that is in its
// hyperplane, the apex: they are on the other side than it.
bool has_just_outside(const std::vector<Point>& simplex, const std::vector<Point>& facet,
                      const Point& apex) {
  std::vector<Point> few = simplex;
  few.push_back(barycentre(facet));
  few.push_back(apex);
  const Configuration points(few);
  const Simplex own = first_subset(simplex.size());
  const auto middle = static_cast<Vertex>(simplex.size());
  const std::vector<int> of_middle = barycentric_signs(points, own, middle);
  const std::vector<int> of_apex = barycentric_signs(points, own, middle + 1);
  for (std::size_t place = 0; place < own.size(); ++place) {
    if (of_middle[place] < 0 || (of_middle[place] == 0 && of_apex[place] > 0)) return false;
  }
  return true;
}

std::vector<std::size_t> left_out_of_complex(const Configuration& points,
                                             const std::vector<Point>& positions,
                                             const std::vector<Simplex>& simplices) {
  // Where so many rounds do not do, faults are everywhere.
  constexpr int kRounds = 12;
  Places rest(simplices.size()), left_out;
  std::iota(rest.begin(), rest.end(), std::size_t{0});
  const Places all = rest;
  std::vector<Simplex> asked = simplices;
  for (int round = 0; round < kRounds && 2 * left_out.size() <= all.size(); ++round) {
    const Places at_fault = Conditions(points, positions, asked).at_fault();
    if (at_fault.empty()) return left_out;
    for (const std::size_t place : at_fault) left_out.push_back(rest[place]);
    keep_each_once(left_out);
    rest.clear();
    std::set_difference(all.begin(), all.end(), left_out.begin(), left_out.end(),
                        std::back_inserter(rest));
    asked.clear();
    for (const std::size_t s : rest) asked.push_back(simplices[s]);
  }
  return all;
}

}  // namespace circumspect::check
