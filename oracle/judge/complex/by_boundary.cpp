#include "oracle/judge/complex/by_boundary.hpp"

#include "kernel/piecewise_linear/disjoint_sets.hpp"
#include "kernel/predicates/orientation.hpp"
#include "oracle/judge/complex/carriers.hpp"
#include "oracle/judge/complex/simplex_boxes.hpp"

namespace circumspect::check {
namespace {

class Boundary {
 public:
  Boundary(const Configuration& points, const std::vector<Point>& positions,
           const std::vector<Simplex>& simplices, const std::vector<FacetUse>& uses)
      : points_(points), positions_(positions), simplices_(simplices) {
    for_each_facet(uses, [&](std::span<const FacetUse> group) {
      is_matched_ &= group.size() == 1 || (group.size() == 2 && are_apart(group[0], group[1]));
      if (group.size() != 1) return;
      facets_.push_back(group.front().facet);
      apexes_.push_back(apex(group.front()));
    });
  }

  bool is_matched() const { return is_matched_; }

  bool is_complex() const { return form_a_complex(points_, positions_, facets_); }

  bool has_nothing_outside() const {
    const std::vector<Box> boxes = boxes_around(positions_, simplices_);
    const BoxIndex tree(boxes);
    for (const std::size_t one : one_of_each_class(facets_)) {
      const std::vector<Point> facet = corners(facets_[one]);
      const Point& apex = positions_[static_cast<std::size_t>(apexes_[one])];
      for (const std::size_t s : tree.meeting(boxes_around(positions_, {facets_[one]}).front())) {
        if (has_just_outside(corners(simplices_[s]), facet, apex)) return false;
      }
    }
    return true;
  }

 private:
  Vertex apex(const FacetUse& use) const { return simplices_[use.simplex][use.opposite]; }

  bool are_apart(const FacetUse& a, const FacetUse& b) const {
    const auto side_of = [&](const FacetUse& use) {
      Simplex joined = use.facet;
      joined.push_back(apex(use));
      return orientation(points_, joined);
    };
    return side_of(a) * side_of(b) < 0;
  }

  std::vector<Point> corners(const Simplex& simplex) const {
    std::vector<Point> points;
    for (const Vertex v : simplex) points.push_back(positions_[static_cast<std::size_t>(v)]);
    return points;
  }

  const Configuration& points_;
  const std::vector<Point>& positions_;
  const std::vector<Simplex>& simplices_;
  std::vector<Simplex> facets_;  // of one simplex
  std::vector<Vertex> apexes_;   // the vertex of that simplex off the facet
  bool is_matched_ = true;
};

}  // namespace

bool form_a_complex(const Configuration& points, const std::vector<Point>& positions,
                    const std::vector<Simplex>& facets) {
  const std::vector<Box> boxes = boxes_around(positions, facets);
  const BoxIndex tree(boxes);
  for (std::size_t i = 0; i < facets.size(); ++i) {
    for (const std::size_t j : tree.meeting(boxes[i])) {
      if (j > i && !carriers(points, facets[i], facets[j]).are_proper()) return false;
    }
  }
  return true;
}

// Where a ridge is in two facets, nothing is between their outer sides.
std::vector<std::size_t> one_of_each_class(const std::vector<Simplex>& facets) {
  DisjointSets classes(facets.size());
  const bool has_ridges = !facets.empty() && facets.front().size() > 1;
  for_each_facet(has_ridges ? facet_uses(facets) : std::vector<FacetUse>(),
                 [&](std::span<const FacetUse> group) {
                   if (group.size() == 2) classes.unite(group[0].simplex, group[1].simplex);
                 });
  std::vector<std::size_t> ones;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (classes.find(i) == i) ones.push_back(i);
  }
  return ones;
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
  const int inner = orientation(points, own);
  for (std::size_t place = 0; place < own.size(); ++place) {
    int side = orientation(points, with_vertex_replaced(own, place, middle));
    if (side == 0) side = -orientation(points, with_vertex_replaced(own, place, middle + 1));
    if (side * inner < 0) return false;
  }
  return true;
}

bool is_complex_by_boundary(const Configuration& points, const std::vector<Point>& positions,
                            const std::vector<Simplex>& simplices,
                            const std::vector<FacetUse>& uses) {
  const Boundary boundary(points, positions, simplices, uses);
  return boundary.is_matched() && boundary.is_complex() && boundary.has_nothing_outside();
}

}  // namespace circumspect::check
