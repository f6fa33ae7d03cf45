#include "oracle/judge/periodic/judge_periodic.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "kernel/complex/by_facet.hpp"
#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/place.hpp"
#include "oracle/judge/definition/periodic_delaunay.hpp"
#include "oracle/judge/points/delaunay.hpp"
#include "oracle/judge/points/simplices.hpp"
#include "oracle/judge/points/triangulation.hpp"
#include "oracle/model/periodic_facets.hpp"
#include "oracle/model/witnesses.hpp"

namespace circumspect::check {
namespace {

class PeriodicJudge {
 public:
  PeriodicJudge(const ExactMesh& mesh, const Copies& copies, Verdict& verdict)
      : mesh_(mesh), copies_(copies), verdict_(verdict) {
    for (std::size_t v = 0; v < copies.of.size(); ++v) {
      places_.emplace(moved(static_cast<Vertex>(v)), static_cast<Vertex>(v));
    }
  }

  // docs/theory/questions.md has the conditions by these names.
  void judge(bool oriented) {
    if (!judge_simplices(mesh_, oriented, verdict_)) return;
    for (const Simplex& simplex : mesh_.simplices) {
      cells_.emplace_back();
      for (const Vertex v : simplex) cells_.back().push_back(moved(v));
    }
    const std::vector<FacetPlace> places = facet_places(cells_);
    for (const auto group : ByFacet(places)) match(group);
    if (has_unmatched_) return;
    judge_vertices();
    if (!is_covered_once()) return;
    for (const auto group : ByFacet(places)) compare_ball(group);
  }

 private:
  MovedPoint moved(Vertex v) const {
    const auto place = static_cast<std::size_t>(v);
    return {copies_.of[place], copies_.offsets[place]};
  }

  Simplex facet_of(const FacetPlace& place) const {
    return sorted(facet_opposite(mesh_.simplices[place.cell], place.opposite));
  }

  // The copy of the apex of `other` where its facet is that of `own`.
  Vertex apex_across(const FacetPlace& own, const FacetPlace& other) const {
    const MovedPoint& apex = cells_[other.cell][other.opposite];
    const Simplex offset = sum(apex.offset, difference(own.moved, other.moved));
    return places_.at({apex.point, offset});
  }

  void match(std::span<const FacetPlace> group) {
    Witness witness{.face = facet_of(group[0])};
    for (const FacetPlace& place : group) {
      witness.simplices.push_back(mesh_.simplices[place.cell]);
      witness.places.push_back(place.cell);
    }
    if (group.size() != 2) {
      has_unmatched_ = true;
      verdict_.add(group.size() == 1 ? Rule::kNotClosed : Rule::kFacetOverused, witness);
      return;
    }
    const Simplex& own = mesh_.simplices[group[0].cell];
    const Vertex apex = apex_across(group[0], group[1]);
    const Configuration& points = mesh_.points.configuration();
    if (barycentric_sign(points, own, group[0].opposite, apex) < 0) return;
    has_unmatched_ = true;
    witness.values = definition::shift_in_words(difference(group[0].moved, group[1].moved));
    verdict_.add(Rule::kOverlap, witness);
  }

  void judge_vertices() {
    std::vector<bool> is_used(copies_.listed);
    for (const PeriodicCell& cell : cells_) {
      for (const MovedPoint& corner : cell) is_used[static_cast<std::size_t>(corner.point)] = true;
    }
    for (std::size_t v = 0; v < is_used.size(); ++v) {
      if (!is_used[v]) verdict_.add(Rule::kUnusedPoint, {.vertices = {static_cast<Vertex>(v)}});
    }
  }

  bool is_covered_once() {
    const Rational times = definition::times_covered(mesh_, copies_);
    if (times == 1) return true;
    Witness witness = cells_with_one_point();
    witness.values.push_back({"so many cells are at each point", times});
    verdict_.add(Rule::kCoveredTwice, witness);
    return false;
  }

  // The first cell, and another that has its centre. There is one: near the centre, generic points
  // are in more than one cell, and there are finitely many cells near.
  Witness cells_with_one_point() const {
    const std::vector<Point> first = coordinates(mesh_.points, mesh_.simplices[0]);
    const Point centre = barycentre(first);
    for (std::size_t other = 0; other < mesh_.simplices.size(); ++other) {
      std::vector<Point> corners = coordinates(mesh_.points, mesh_.simplices[other]);
      const definition::Bounds box = definition::bounds_of(corners);
      corners.push_back(centre);
      std::optional<Witness> found;
      const definition::Bounds ways{centre - box.high, centre - box.low};
      definition::for_each_shift(copies_.lattice, ways, [&](const Simplex& way) {
        const bool is_itself = other == 0 && way == Simplex(way.size(), 0);
        corners.back() = centre - copies_.shift(way);
        if (is_itself || !has_last(corners)) return true;
        found = Witness{.simplices = {mesh_.simplices[0], mesh_.simplices[other]},
                        .places = {0, other},
                        .values = definition::shift_in_words(way),
                        .point = centre};
        return false;
      });
      if (found) return std::move(*found);
    }
    return {};
  }

  // Is the last point in the simplex of the others?
  static bool has_last(const std::vector<Point>& points) {
    const auto last = static_cast<Vertex>(points.size() - 1);
    const auto same = std::find(points.begin(), points.end(), points.back());
    return same != points.end() - 1 ||
           lies_in(Configuration(points), first_subset(points.size() - 1), last);
  }

  void compare_ball(std::span<const FacetPlace> group) {
    const Simplex& own = mesh_.simplices[group[0].cell];
    const Vertex apex = apex_across(group[0], group[1]);
    if (in_ball(mesh_.points.configuration(), own, apex) <= 0) return;
    add_vertex_in_ball(mesh_.points, Rule::kFacetNotLocal, own, facet_of(group[0]), apex, verdict_);
  }

  const ExactMesh& mesh_;
  const Copies& copies_;
  Verdict& verdict_;
  std::map<MovedPoint, Vertex> places_;
  std::vector<PeriodicCell> cells_;
  bool has_unmatched_ = false;
};

}  // namespace

Verdict judge_periodic(const Mesh& mesh, const Options& options) {
  const ExactMesh unfolded = exact(mesh);
  Verdict verdict(Claim::kPeriodicDelaunay, unfolded, options.max_violations);
  verdict.points = mesh.copies->listed;
  if (options.by == By::kDefinition) {
    definition::judge_periodic_delaunay(unfolded, *mesh.copies, verdict);
    judge_beside_definition(unfolded, options, verdict);
  } else {
    PeriodicJudge(unfolded, *mesh.copies, verdict).judge(options.oriented);
  }
  return verdict;
}

}  // namespace circumspect::check
