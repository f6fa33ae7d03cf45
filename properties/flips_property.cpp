// D7: what a bistellar flip is. Book: Section 4.4, Figures 4.6 to 4.8.
#include <algorithm>
#include <set>

#include <doctest/doctest.h>

#include "kernel/complex/simplex.hpp"
#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/perturbation.hpp"
#include "kernel/predicates/place.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/judge/points/delaunay.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/random_flips.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/flip.hpp"
#include "reference/delaunay/flip_algorithm.hpp"

namespace circumspect::properties {
namespace {

using delaunay::BasicFlip;
using generators::PointsCase;
using Simplices = std::vector<Simplex>;

// Do the simplices triangulate some of the points, and is every other point inside them?
bool is_triangulation_of_some(const PointSet& points, const Simplices& simplices) {
  std::vector<Point> used;
  std::vector<Vertex> new_index;
  for (Vertex v = 0; points.names(v); ++v) {
    const auto has_v = [v](const Simplex& s) { return contains(s, v); };
    new_index.push_back(static_cast<Vertex>(used.size()));
    if (std::any_of(simplices.begin(), simplices.end(), has_v)) {
      used.push_back(points[v]);
    } else if (std::none_of(simplices.begin(), simplices.end(), [&](const Simplex& s) {
                 return lies_in(points.configuration(), s, v);
               })) {
      return false;
    }
  }
  ExactMesh mesh{PointSet(used), simplices};
  for (Simplex& simplex : mesh.simplices) {
    for (Vertex& v : simplex) v = new_index[static_cast<std::size_t>(v)];
  }
  return check::judge_points(Claim::kTriangulation, mesh).holds() &&
         check::judge_exactly(Claim::kTriangulation, mesh, nullptr, {.by = check::By::kDefinition})
             .holds();
}

// All triangulations of k+2 points that span k dimensions, by looking at all sets of simplices.
std::set<Simplices> triangulations_by_definition(const PointSet& points) {
  Simplices candidates;
  const auto size = static_cast<std::size_t>(points.dimension() + 1);
  Simplex subset = first_subset(size);
  do {
    if (orientation(points.configuration(), subset) != 0) candidates.push_back(subset);
  } while (next_subset(subset, points.size()));
  std::set<Simplices> found;
  for (unsigned chosen = 1; chosen < (1u << candidates.size()); ++chosen) {
    Simplices simplices;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (chosen >> i & 1u) simplices.push_back(candidates[i]);
    }
    if (is_triangulation_of_some(points, simplices)) found.insert(simplices);
  }
  return found;
}

// The basic flip, joined with the points that take no part in it.
Simplices spanning(const PointSet& points, const Simplices& simplices, const BasicFlip& flip) {
  Simplex rest;
  for (Vertex v = 0; points.names(v); ++v) {
    const auto has_v = [v](const Simplex& s) { return contains(s, v); };
    if (std::none_of(flip.deleted.begin(), flip.deleted.end(), has_v) &&
        std::none_of(flip.created.begin(), flip.created.end(), has_v)) {
      rest.push_back(v);
    }
  }
  Simplices all;
  for (const Simplex& simplex : simplices) all.push_back(join(simplex, rest));
  std::sort(all.begin(), all.end());
  return all;
}

// Does every point lie strictly outside the circumball of every simplex that it is not a vertex of?
template <typename InBall>
bool is_strictly_delaunay(const PointSet& points, const Simplices& simplices, InBall in_ball_test) {
  for (const Simplex& simplex : simplices) {
    for (Vertex v = 0; points.names(v); ++v) {
      if (!contains(simplex, v) && in_ball_test(points, simplex, v) >= 0) return false;
    }
  }
  return true;
}

int unperturbed(const PointSet& points, const Simplex& simplex, Vertex v) {
  return in_ball(points.configuration(), simplex, v);
}
int perturbed(const PointSet& points, const Simplex& simplex, Vertex v) {
  return perturbed_in_ball(points.configuration(), simplex, v);
}

TEST_CASE(
    "D7 d+2 points have two triangulations, a basic flip swaps them, one is strictly Delaunay") {
  for (const std::size_t d : {1u, 2u, 3u, 4u}) {
    CAPTURE(d);
    CHECK(holds("the two triangulations of d+2 points", d == 4 ? 25 : 100, [d] {
      const auto sets = rc::gen::oneOf(generators::degenerate_point_set(d, d + 4),
                                       generators::sets_of(generators::integer_points, d, d + 4));
      const PointsCase set = *generators::simplex_first(
          rc::gen::oneOf(generators::unweighted(sets), generators::weighted(sets)));
      const PointSet all(set.points);
      const auto k = static_cast<std::size_t>(all.dimension());
      std::vector<Rational> weights = set.weights;
      if (!weights.empty()) weights.resize(k + 2);
      const PointSet points({set.points.begin(), set.points.begin() + static_cast<Vertex>(k) + 2},
                            weights);
      const Simplex simplex = first_subset(k + 1);
      const auto apex = static_cast<Vertex>(k) + 1;
      const BasicFlip flip = delaunay::basic_flip(points, simplex, apex);
      const Simplices deleted = spanning(points, flip.deleted, flip);
      const Simplices created = spanning(points, flip.created, flip);
      RC_ASSERT(std::find(deleted.begin(), deleted.end(), simplex) != deleted.end());
      RC_ASSERT((triangulations_by_definition(points) == std::set<Simplices>{deleted, created}));

      const bool cospherical = unperturbed(points, simplex, apex) == 0;
      const bool deleted_is = is_strictly_delaunay(points, deleted, unperturbed);
      const bool created_is = is_strictly_delaunay(points, created, unperturbed);
      RC_ASSERT((cospherical ? !deleted_is && !created_is : deleted_is != created_is));
      // To perturbed tests no points are cospherical.
      RC_ASSERT(is_strictly_delaunay(points, deleted, perturbed) !=
                is_strictly_delaunay(points, created, perturbed));
    }));
  }
}

rc::Gen<TriangulationCase> random_triangulations(std::size_t d) {
  return flipped_triangulations(
      generators::unweighted(rc::gen::oneOf(generators::degenerate_point_set(d, 9),
                                            generators::generic_point_set(d, 9))),
      8);
}

void assert_triangulation(const PointSet& points, const StarIndex& triangulation) {
  const ExactMesh mesh{points,
                       {triangulation.simplices().begin(), triangulation.simplices().end()}};
  RC_ASSERT(check::judge_points(Claim::kTriangulation, mesh).holds());
  RC_ASSERT(
      check::judge_exactly(Claim::kTriangulation, mesh, nullptr, {.by = check::By::kDefinition})
          .holds());
}

TEST_CASE("D7 after any random flips the mesh is still a triangulation") {
  for (const std::size_t d : {1u, 2u, 3u, 4u}) {
    CAPTURE(d);
    CHECK(holds("random flips keep a triangulation", d == 4 ? 30 : 120, [d] {
      const TriangulationCase start = *random_triangulations(d);
      assert_triangulation(start.points(), StarIndex(start.triangulation.simplices()));
    }));
  }
}

// Of all facets' flips, also those that delete a vertex.
template <typename Visit>
void for_each_interior_facet(const StarIndex& triangulation, Visit visit) {
  for (const Simplex& facet :
       facets_of({triangulation.simplices().begin(), triangulation.simplices().end()})) {
    if (triangulation.star(facet).size() == 2) visit(facet);
  }
}

// Every simplex of the triangulation with a face among `faces`, looked for one by one.
Simplices all_with_a_face_among(const StarIndex& triangulation, const Simplices& faces) {
  Simplices found;
  for (const Simplex& simplex : triangulation.simplices()) {
    if (std::any_of(faces.begin(), faces.end(), [&](const Simplex& face) {
          return std::includes(simplex.begin(), simplex.end(), face.begin(), face.end());
        })) {
      found.push_back(simplex);
    }
  }
  return found;
}

TEST_CASE("D7 a flip deletes all simplices with a face in T_D, or is blocked by missing ones") {
  for (const std::size_t d : {1u, 2u, 3u, 4u}) {
    CAPTURE(d);
    CHECK(holds("extended flips", d == 4 ? 40 : 150, [d] {
      const TriangulationCase start = *random_triangulations(d);
      const PointSet points = start.points();
      const StarIndex triangulation(start.triangulation.simplices());
      for_each_interior_facet(triangulation, [&](const Simplex& facet) {
        const BasicFlip basic = delaunay::flip_of_facet(points, triangulation, facet);
        const auto flip = delaunay::extended_flip(triangulation, basic);
        const Simplices star = all_with_a_face_among(triangulation, basic.deleted);
        if (flip) {
          RC_ASSERT(flip->deleted == star);
          for (const Simplex& simplex : triangulation.star(facet)) {
            RC_ASSERT(std::count(star.begin(), star.end(), simplex) == 1);
          }
          return;
        }
        for (const Simplex& simplex : flip.error().missing) {
          RC_ASSERT(!triangulation.has(simplex));
          RC_ASSERT(orientation(points.configuration(), simplex) != 0);
        }
      });
    }));
  }
}

TEST_CASE("D7 a flip and its reverse restore the triangulation") {
  for (const std::size_t d : {1u, 2u, 3u, 4u}) {
    CAPTURE(d);
    CHECK(holds("a flip and its reverse", d == 4 ? 40 : 150, [d] {
      const TriangulationCase start = *random_triangulations(d);
      const PointSet points = start.points();
      StarIndex triangulation(start.triangulation.simplices());
      for_each_interior_facet(StarIndex(triangulation), [&](const Simplex& facet) {
        const BasicFlip basic = delaunay::flip_of_facet(points, triangulation, facet);
        const auto flip = delaunay::extended_flip(triangulation, basic);
        if (!flip) return;
        triangulation.replace(flip->deleted, flip->created);
        RC_ASSERT(triangulation.star(facet).empty());
        const auto back = delaunay::extended_flip(triangulation, basic.reverse());
        RC_ASSERT(back.has_value());
        RC_ASSERT(back->deleted == flip->created);
        RC_ASSERT(back->created == flip->deleted);
        triangulation.replace(back->deleted, back->created);
      });
      RC_ASSERT(triangulation.triangulation(points.dimension()) == start.triangulation);
    }));
  }
}

TEST_CASE("D7 the procedure of Figure 4.8 is the general flip in three dimensions") {
  CHECK(holds("Figure 4.8", 250, [] {
    const TriangulationCase start = *random_triangulations(3);
    const PointSet points = start.points();
    if (points.dimension() != 3) return;
    const StarIndex triangulation(start.triangulation.simplices());
    for_each_interior_facet(triangulation, [&](const Simplex& facet) {
      const auto general = delaunay::extended_flip(
          triangulation, delaunay::flip_of_facet(points, triangulation, facet));
      StarIndex of_the_book = triangulation;
      const auto performed = delaunay::flip(points, of_the_book, facet[2], facet[0], facet[1]);
      RC_ASSERT(performed.has_value() == general.has_value());
      if (general) {
        RC_ASSERT(performed->deleted == general->deleted);
        RC_ASSERT(performed->created == general->created);
        RC_ASSERT(of_the_book.size() + general->deleted.size() ==
                  triangulation.size() + general->created.size());
      } else {
        // The book looks at the link of one simplex in T_D, the general form at all.
        RC_ASSERT(of_the_book.simplices() == triangulation.simplices());
        const Simplices& all = general.error().missing;
        for (const Simplex& simplex : performed.error().missing) {
          RC_ASSERT(std::find(all.begin(), all.end(), simplex) != all.end());
        }
      }
    });
  }));
}

}  // namespace
}  // namespace circumspect::properties
