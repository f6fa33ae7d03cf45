// A facet that only one simplex has should have nothing beyond it. Let x be its barycentre, v a point
// of the set strictly beyond it. If x is in no other simplex, the points of the segment xv near x are
// in none: not in its own, which is on the inner side, and not in others, which are closed. They are
// in the hull, in the simplex that joins the facet and v. If x is in another simplex, its carrier
// there is not the facet, so that these two overlap.
#include <algorithm>
#include <map>

#include "oracle/certificate/evidence.hpp"
#include "oracle/certificate/face_uses.hpp"
#include "oracle/judge/points/boundary_facet.hpp"
#include "reference/kernel/complex/facets.hpp"
#include "reference/kernel/complex/proper_intersection.hpp"
#include "reference/kernel/exact/box_index.hpp"

namespace circumspect::certificate {
namespace {

using check::BoundaryFacet;

// A boundary facet and a point of the set strictly beyond it.
struct Gap {
  BoundaryFacet facet;
  Vertex beyond;
};

// Which facet of each simplex, or which simplex in place of it.
struct Covering {
  std::vector<std::size_t> separating;  // a place for each simplex that does not contain the point
  std::optional<std::size_t> covered_by = {};
};

// Looks at simplices until one other than `skipped` contains q; first at number `likely`.
class CoverSearch {
 public:
  CoverSearch(const ExactMesh& mesh, const ScaledPoints& points) : mesh_(mesh), sidedness_(points) {
    for (const Simplex& simplex : mesh.simplices) {
      orientations_.push_back(sidedness_.orientation(simplex));
    }
  }

  Covering operator()(const HomogeneousPoint& q, std::optional<std::size_t> skipped) {
    Covering covering{std::vector<std::size_t>(orientations_.size(), 0)};
    if (likely_ && likely_ != skipped && !place(*likely_, q)) return {{}, likely_};
    for (std::size_t s = 0; s < orientations_.size(); ++s) {
      if (s == skipped) continue;
      const auto separating = place(s, q);
      if (!separating) {
        likely_ = s;
        return {{}, s};
      }
      covering.separating[s] = *separating;
    }
    return covering;
  }

 private:
  std::optional<std::size_t> place(std::size_t s, const HomogeneousPoint& q) {
    return sidedness_.separating_place(mesh_.simplices[s], orientations_[s], q);
  }

  const ExactMesh& mesh_;
  Sidedness sidedness_;
  std::vector<int> orientations_;
  std::optional<std::size_t> likely_;
};

void append(std::vector<Integer>& because, const HomogeneousPoint& point) {
  because.insert(because.end(), point.numerators.begin(), point.numerators.end());
  because.push_back(point.denominator);
}

std::vector<Integer> uncovered_tokens(const HomogeneousPoint& q, const Simplex& around,
                                      const Covering& covering) {
  std::vector<Integer> because;
  append(because, q);
  for (const Vertex v : around) because.emplace_back(Integer(v) + 1);
  for (const std::size_t place : covering.separating) {
    because.emplace_back(static_cast<unsigned long>(place));
  }
  return because;
}

// The point x + 2^−k (v − x), x the barycentre of the facet.
HomogeneousPoint point_beyond(const ScaledPoints& points, const Gap& gap, unsigned k) {
  HomogeneousPoint q = barycentre(points, gap.facet.facet);
  const Integer power = Integer(1) << k;
  for (std::size_t axis = 0; axis < points.dimension; ++axis) {
    Integer& x = q.numerators[axis];
    x *= power - 1;
    x += q.denominator * points.coordinate(gap.beyond, axis);
  }
  q.denominator *= power;
  return in_lowest_terms(std::move(q));
}

// Requires: no simplex but its own contains the barycentre of the facet.
Evidence uncovered(const ScaledPoints& points, const Gap& gap, Rule rule, CoverSearch& search) {
  Simplex around = gap.facet.facet;
  around.push_back(gap.beyond);
  for (unsigned k = 1;; ++k) {
    const HomogeneousPoint q = point_beyond(points, gap, k);
    const Covering covering = search(q, std::nullopt);
    if (!covering.covered_by) return {rule, uncovered_tokens(q, around, covering)};
  }
}

Evidence overlap(const HomogeneousPoint& common, std::size_t a, std::size_t b) {
  Evidence evidence{Rule::kOverlap,
                    {static_cast<unsigned long>(a + 1), static_cast<unsigned long>(b + 1)}};
  append(evidence.because, common);
  return evidence;
}

class HullEvidence {
 public:
  HullEvidence(const ExactMesh& mesh, const ScaledPoints& points, Rule rule)
      : mesh_(mesh), points_(points), rule_(rule), search_(mesh, points) {
    std::vector<FaceUse> uses = facets(mesh);
    for_each_face(uses, [&](std::span<const FaceUse> group) {
      if (group.size() != 1) return;
      const Simplex& simplex = mesh.simplices[group.front().cell];
      const std::size_t place = group.front().place;
      boundary_.push_back(
          {sorted(facet_opposite(simplex, place)), simplex[place], group.front().cell});
    });
    std::sort(boundary_.begin(), boundary_.end(), precedes);
  }

  // Evidence of the rule itself. What overlaps is kept for later.
  std::optional<Evidence> at_gap(const Gap& gap) {
    const HomogeneousPoint x = barycentre(points_, gap.facet.facet);
    const Covering covering = search_(x, gap.facet.simplex);
    if (!covering.covered_by) return uncovered(points_, gap, rule_, search_);
    if (!overlap_) overlap_ = overlap(x, gap.facet.simplex, *covering.covered_by);
    return std::nullopt;
  }

  // One of `candidates` is strictly beyond one of the facets, which are boundary facets.
  std::optional<Evidence> near(const std::vector<Simplex>& facets,
                               const std::vector<Vertex>& candidates) {
    for (const Simplex& vertices : facets) {
      const BoundaryFacet* facet = boundary_facet(vertices);
      if (facet == nullptr) continue;
      for (const Vertex v : candidates) {
        if (check::side_of(mesh_.points.configuration(), *facet, v) >= 0) continue;
        if (auto evidence = at_gap({*facet, v})) return evidence;
        break;
      }
    }
    return std::nullopt;
  }

  // What the witness of a fault of the hull shows.
  std::optional<Evidence> from(const Witness& witness) {
    if (rule_ == Rule::kHullNotConvex) return near({*witness.face}, witness.vertices);
    std::vector<Vertex> candidates;  // all vertices around the ridge
    for (const Simplex& facet : witness.simplices) {
      const BoundaryFacet* found = boundary_facet(facet);
      if (found == nullptr) continue;
      const Simplex& simplex = mesh_.simplices[found->simplex];
      candidates.insert(candidates.end(), simplex.begin(), simplex.end());
    }
    return near(witness.simplices, candidates);
  }

  // Looks everywhere, where no witness has said where to look.
  std::optional<Evidence> anywhere() {
    for (const BoundaryFacet& facet : boundary_) {
      for (Vertex v = 0; mesh_.points.names(v); ++v) {
        if (check::side_of(mesh_.points.configuration(), facet, v) >= 0) continue;
        auto evidence = at_gap({facet, v});
        return evidence ? evidence : overlap_;
      }
    }
    return any_overlap();
  }

  const std::optional<Evidence>& overlap_found() const { return overlap_; }

 private:
  static bool precedes(const BoundaryFacet& a, const BoundaryFacet& b) { return a.facet < b.facet; }

  const BoundaryFacet* boundary_facet(const Simplex& vertices) const {
    const BoundaryFacet wanted{sorted(vertices), 0, 0};
    const auto found = std::lower_bound(boundary_.begin(), boundary_.end(), wanted, precedes);
    return found != boundary_.end() && found->facet == wanted.facet ? &*found : nullptr;
  }

  // Where all boundary facets are on the hull and the mesh is no triangulation, simplices overlap.
  std::optional<Evidence> any_overlap() const {
    std::vector<Box> boxes;
    for (const Simplex& simplex : mesh_.simplices) {
      Box box = box_around(mesh_.points[simplex.front()]);
      for (const Vertex v : simplex) box = box_around(box, box_around(mesh_.points[v]));
      boxes.push_back(box);
    }
    const BoxIndex index(boxes);
    for (std::size_t a = 0; a < boxes.size(); ++a) {
      for (const std::size_t b : index.meeting(boxes[a])) {
        if (b <= a) continue;
        const auto common =
            improper_intersection(mesh_.points, mesh_.simplices[a], mesh_.simplices[b]);
        if (common) return overlap(scaled(points_, *common), a, b);
      }
    }
    return std::nullopt;
  }

  const ExactMesh& mesh_;
  const ScaledPoints& points_;
  Rule rule_;
  CoverSearch search_;
  std::vector<BoundaryFacet> boundary_;
  std::optional<Evidence> overlap_;
};

}  // namespace

std::optional<Evidence> hull_evidence(const ExactMesh& mesh, const ScaledPoints& points, Rule rule,
                                      const Verdict& verdict) {
  HullEvidence hull(mesh, points, rule);
  for (const Violation& violation : verdict.violations()) {
    if (violation.rule != rule) continue;
    if (auto evidence = hull.from(violation.witness)) return evidence;
  }
  if (hull.overlap_found()) return hull.overlap_found();
  return hull.anywhere();
}

std::optional<Evidence> uncovered_point_evidence(const ExactMesh& mesh, const ScaledPoints& points,
                                                 Vertex point) {
  // The point with others that make a simplex of it.
  std::vector<Vertex> order = {point};
  std::vector<Point> with_point_first = {mesh.points[point]};
  for (Vertex v = 0; mesh.points.names(v); ++v) {
    if (v == point) continue;
    order.push_back(v);
    with_point_first.push_back(mesh.points[v]);
  }
  Simplex around;
  for (const std::size_t i : affine_hull(with_point_first).basis) around.push_back(order[i]);
  const HomogeneousPoint q = barycentre(points, {point});
  const Covering covering = CoverSearch(mesh, points)(q, std::nullopt);
  if (covering.covered_by) return std::nullopt;
  return Evidence{Rule::kHullNotConvex, uncovered_tokens(q, around, covering)};
}

}  // namespace circumspect::certificate
