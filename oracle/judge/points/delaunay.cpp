#include "oracle/judge/points/delaunay.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

#include "kernel/boxes/point_search.hpp"
#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/circumball.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/perturbation.hpp"
#include "kernel/predicates/place.hpp"
#include "oracle/judge/points/simplices.hpp"
#include "oracle/judge/points/triangulation.hpp"
#include "oracle/model/witnesses.hpp"

namespace circumspect::check {

void Ambiguity::see(const PointSet& points, const Simplex& simplex, Vertex q, int side) {
  if (side != 0) return;
  unique = false;
  if (canonical) canonical = perturbed_in_ball(points.configuration(), simplex, q) < 0;
}

namespace {

// Let W be a simplex and q, strictly below its witness plane, and let only vertex v of the simplex
// have a positive barycentric coordinate of q. Then v lies in the simplex of all the others, and v⁺
// strictly above its witness plane: the flip that makes the facet locally Delaunay deletes v. For
// points on the paraboloid itself that is impossible. Book: Section 4.4 ("one of the two
// triangulations might omit a vertex of W").
std::optional<Vertex> submerged_vertex(const PointSet& points, const Simplex& simplex, Vertex q) {
  if (!points.is_weighted()) return std::nullopt;
  const std::vector<int> signs = barycentric_signs(points.configuration(), simplex, q);
  std::optional<Vertex> only;
  for (std::size_t place = 0; place < simplex.size(); ++place) {
    if (signs[place] <= 0) continue;
    if (only) return std::nullopt;
    only = simplex[place];
  }
  return only;
}

void add_facet(const ExactMesh& mesh, const SharedFacet& shared, Verdict& verdict) {
  const Simplex& simplex = mesh.simplices[shared.simplex];
  const Vertex apex = shared.apex;
  if (const auto submerged = submerged_vertex(mesh.points, simplex, apex)) {
    Simplex around = simplex;
    for (Vertex& v : around) v = v == *submerged ? apex : v;
    const Ball ball = circumball(mesh.points, around);
    verdict.add(Rule::kVertexSubmerged,
                {.simplices = {around},
                 .vertices = {*submerged},
                 .values = {{"height of the lifted vertex above the witness plane",
                             power(mesh.points, ball, *submerged)}},
                 .ball = ball});
    return;
  }
  add_vertex_in_ball(mesh.points, Rule::kFacetNotLocal, simplex, shared.facet, apex, verdict);
}

}  // namespace

int judge_facet_locally_delaunay(const ExactMesh& mesh, const SharedFacet& shared,
                                 Verdict& verdict) {
  const Simplex& simplex = mesh.simplices[shared.simplex];
  const int side = in_ball(mesh.points.configuration(), simplex, shared.apex);
  if (side > 0) add_facet(mesh, shared, verdict);
  return side;
}

void judge_facets_locally_delaunay(const ExactMesh& mesh, const std::vector<FacetUse>& uses,
                                   Verdict& verdict, Ambiguity& ambiguity) {
  for (const auto group : ByFacet(uses)) {
    if (group.size() != 2) continue;
    const Vertex apex = mesh.simplices[group[1].simplex][group[1].opposite];
    const SharedFacet shared{group[0].facet, group[0].simplex, apex};
    const int side = judge_facet_locally_delaunay(mesh, shared, verdict);
    ambiguity.see(mesh.points, mesh.simplices[shared.simplex], apex, side);
  }
}

namespace {

// Presents a mesh in the form that the point search needs.
class Located {
 public:
  Located(const ExactMesh& mesh, const std::vector<FacetUse>& uses)
      : mesh_(mesh),
        row_size_(mesh.simplices.front().size()),
        across_(mesh.simplices.size() * row_size_, kNoSimplex),
        own_(mesh.simplices.size(), 0) {
    for (const auto group : ByFacet(uses)) {
      if (group.size() != 2) continue;
      across_[group[0].simplex * row_size_ + group[0].opposite] = group[1].simplex;
      across_[group[1].simplex * row_size_ + group[1].opposite] = group[0].simplex;
    }
  }

  std::size_t size() const { return mesh_.simplices.size(); }
  std::size_t row_size() const { return row_size_; }
  std::size_t points() const { return mesh_.points.size(); }
  std::size_t vertex(std::size_t s, std::size_t place) const {
    return static_cast<std::size_t>(mesh_.simplices[s][place]);
  }
  int side(std::size_t s, std::size_t place, std::size_t point) const {
    const Configuration& points = mesh_.points.configuration();
    signed char& own = own_[s];
    if (own == 0) own = static_cast<signed char>(orientation(points, mesh_.simplices[s]));
    return barycentric_sign(points, mesh_.simplices[s], own, place, static_cast<Vertex>(point));
  }
  std::size_t across(std::size_t s, std::size_t place) const {
    return across_[s * row_size_ + place];
  }

 private:
  const ExactMesh& mesh_;
  std::size_t row_size_;
  std::vector<std::size_t> across_;       // the facet opposite each vertex of each simplex
  mutable std::vector<signed char> own_;  // the orientation of each simplex that was asked; 0: none
};

// The first in the list of all simplices that contain a point: a point on a face is in several, and
// the one that is shown must not depend on how it was found.
class FirstSimplices {
 public:
  explicit FirstSimplices(const Located& located) : located_(located) {}

  // `any` is one of them.
  std::size_t first_with(std::size_t any, std::size_t point) {
    std::set<std::size_t>
        carrier;  // the vertices of the face that has the point in its relative interior
    for (std::size_t place = 0; place < located_.row_size(); ++place) {
      if (located_.side(any, place, point) != 0) carrier.insert(located_.vertex(any, place));
    }
    if (carrier.size() == located_.row_size()) return any;
    const auto [known, is_new] = first_.emplace(carrier, any);
    if (is_new) known->second = first_around(carrier, any);
    return known->second;
  }

 private:
  // Goes around the face through the facets that have it.
  std::size_t first_around(const std::set<std::size_t>& face, std::size_t any) const {
    std::set<std::size_t> seen = {any};
    std::vector<std::size_t> pending = {any};
    while (!pending.empty()) {
      const std::size_t s = pending.back();
      pending.pop_back();
      for (std::size_t place = 0; place < located_.row_size(); ++place) {
        if (face.contains(located_.vertex(s, place))) continue;
        const std::size_t across = located_.across(s, place);
        if (across != kNoSimplex && seen.insert(across).second) pending.push_back(across);
      }
    }
    return *seen.begin();
  }

  const Located& located_;
  std::map<std::set<std::size_t>, std::size_t> first_;  // by the face: each is searched once
};

}  // namespace

void judge_submerged_point(const ExactMesh& mesh, Vertex q, std::optional<std::size_t> place,
                           Verdict& verdict, Ambiguity& ambiguity) {
  if (!place) {
    verdict.add(Rule::kUnusedPoint, {.vertices = {q}, .point = mesh.points[q]});
    return;
  }
  const Simplex& simplex = mesh.simplices[*place];
  const int side = in_ball(mesh.points.configuration(), simplex, q);
  ambiguity.see(mesh.points, simplex, q, side);
  if (side <= 0) return;
  add_vertex_in_ball(mesh.points, Rule::kPointBelowPlane, simplex, std::nullopt, q, verdict);
}

std::uint64_t judge_submerged_points(const ExactMesh& mesh, const std::vector<FacetUse>& uses,
                                     Verdict& verdict, Ambiguity& ambiguity) {
  const std::vector<Vertex> unused = unused_points(mesh);
  if (unused.empty() || mesh.simplices.empty()) return 0;
  const Located located(mesh, uses);
  PointSearch search(located);
  const std::vector<std::size_t> places(unused.begin(), unused.end());
  const std::vector<std::size_t> simplices = search.simplices_with(places);
  FirstSimplices first(located);
  for (std::size_t i = 0; i < unused.size(); ++i) {
    std::optional<std::size_t> simplex;
    if (simplices[i] != kNoSimplex) simplex = first.first_with(simplices[i], places[i]);
    judge_submerged_point(mesh, unused[i], simplex, verdict, ambiguity);
  }
  return search.work();
}

Verdict judge_points(Claim claim, const ExactMesh& mesh, const Options& options) {
  const bool is_weighted = claim == Claim::kWeightedDelaunay;
  assert(is_weighted || claim == Claim::kTriangulation ||
         (claim == Claim::kDelaunay && !mesh.points.is_weighted()));
  assert(options.by == By::kLemma);
  Verdict verdict(claim, mesh, options.max_violations);
  const bool simplices_are_sound = judge_simplices(mesh, options.oriented, verdict);
  // Weighted points need not be vertices. A mesh without simplices leaves every point uncovered.
  if (!is_weighted || mesh.simplices.empty()) judge_vertex_set(mesh, verdict);
  if (!simplices_are_sound) return verdict;
  const std::vector<FacetUse> uses = facet_uses(mesh.simplices);
  if (!judge_complex_by_lemma(mesh, uses, verdict)) return verdict;
  if (mesh.neighbors) judge_neighbors(mesh, uses, verdict);
  if (claim == Claim::kTriangulation) return verdict;
  const bool is_triangulation = verdict.holds();
  Ambiguity ambiguity;
  judge_facets_locally_delaunay(mesh, uses, verdict, ambiguity);
  if (is_weighted && is_triangulation) judge_submerged_points(mesh, uses, verdict, ambiguity);
  ambiguity.conclude(verdict);
  return verdict;
}

Verdict not_locally_delaunay(Claim claim, const ExactMesh& mesh, std::vector<SharedFacet> facets,
                             const Options& options) {
  assert(claim == Claim::kDelaunay || claim == Claim::kWeightedDelaunay);
  assert(!facets.empty());
  std::sort(facets.begin(), facets.end(),
            [](const SharedFacet& a, const SharedFacet& b) { return a.facet < b.facet; });
  Verdict verdict(claim, mesh, options.max_violations);
  for (const SharedFacet& shared : facets) {
    if (judge_facet_locally_delaunay(mesh, shared, verdict) > 0) continue;
    throw std::logic_error("a facet was taken for one that is not locally Delaunay, and is");
  }
  return verdict;
}

}  // namespace circumspect::check
