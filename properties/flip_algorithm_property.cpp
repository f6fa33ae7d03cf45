// D7, D2: where the flip algorithm ends, and insertion by flips. Book: Section 4.4; Proposition
// 2.5.
#include <algorithm>
#include <array>
#include <string>

#include <doctest/doctest.h>

#include "oracle/formats/mesh_files.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/judge/points/delaunay.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/random_flips.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/flip.hpp"
#include "reference/delaunay/flip_algorithm.hpp"
#include "reference/delaunay/flip_insertion.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::properties {
namespace {

using delaunay::BlockedFacet;
using delaunay::FlippedTriangulation;
using delaunay::FlipTest;
using generators::PointsCase;

rc::Gen<PointsCase> point_sets(std::size_t d, std::size_t max_points) {
  const auto sets = rc::gen::oneOf(generators::degenerate_point_set(d, max_points),
                                   generators::any_point_set(d, max_points));
  return rc::gen::oneOf(generators::unweighted(sets), generators::weighted(sets));
}

// The first `count` points, with their weights. Weights drop out if the prefix has none to keep.
PointSet first_points(const PointsCase& set, std::size_t count) {
  const auto size = static_cast<Vertex>(count);
  return PointSet({set.points.begin(), set.points.begin() + size},
                  set.weights.empty()
                      ? std::vector<Rational>{}
                      : std::vector<Rational>{set.weights.begin(), set.weights.begin() + size});
}

TEST_CASE(
    "D7 flips insert each vertex into the canonical triangulation, wherever it is, never stuck") {
  for (const std::size_t d : {1u, 2u, 3u, 4u}) {
    CAPTURE(d);
    CHECK(holds("insertion by flips", d == 4 ? 40 : 150, [&] {
      const PointsCase set = *generators::simplex_first(point_sets(d, 9));
      const PointSet points(set.points, set.weights);
      const auto k = static_cast<std::size_t>(points.dimension());
      Simplex first;
      for (std::size_t v = 0; v <= k; ++v) first.push_back(static_cast<Vertex>(v));
      StarIndex triangulation({first});
      for (std::size_t u = k + 1; u < points.size(); ++u) {
        const delaunay::VertexInsertion insertion =
            delaunay::insert_vertex_by_flips(points, triangulation, static_cast<Vertex>(u));
        RC_ASSERT(!insertion.run.is_stuck());
        RC_ASSERT(Integer(insertion.run.flips) <= delaunay::most_flips(u + 1, k));
        RC_ASSERT(triangulation.triangulation(points.dimension()) ==
                  delaunay::by_definition(first_points(set, u + 1)));
        const auto place = insertion.dimension_of_face;
        // RC_ASSERT would evaluate both sides of an "or".
        const bool place_is_possible = !place || (*place >= 1 && *place <= k);
        RC_ASSERT(place_is_possible);
        if (insertion.is_submerged) RC_ASSERT(insertion.run.flips == 0u);
      }
    }));
  }
}

TEST_CASE("D7 flips insert the points of a grid, in simplices, in facets, on edges and outside") {
  // The grid {0, 1, 2}^3 in several orders, corners before the rest in some of them.
  std::array<std::size_t, 4> places{};  // edge, facet, simplex, outside
  for (const std::size_t stride : {1u, 2u, 4u, 7u, 10u, 13u, 20u, 26u}) {
    PointsCase set;
    for (std::size_t i = 0; i < 27; ++i) {
      const auto cell = static_cast<long>(i * stride % 27);
      set.points.push_back({cell / 9, cell / 3 % 3, cell % 3});
    }
    const auto is_corner = [](const Point& p) { return p[0] != 1 && p[1] != 1 && p[2] != 1; };
    if (stride % 4 != 0) {
      std::stable_partition(set.points.begin(), set.points.end(), is_corner);
    }
    // Four affinely independent points first.
    const std::vector<std::size_t> basis = affine_hull(set.points).basis;
    for (std::size_t i = 0; i < basis.size(); ++i) std::swap(set.points[i], set.points[basis[i]]);
    const PointSet points(set.points);
    StarIndex triangulation({{0, 1, 2, 3}});
    for (std::size_t u = 4; u < points.size(); ++u) {
      const delaunay::VertexInsertion insertion =
          delaunay::insert_vertex_by_flips(points, triangulation, static_cast<Vertex>(u));
      CHECK(!insertion.run.is_stuck());
      CHECK(triangulation.triangulation(3) == delaunay::bowyer_watson(first_points(set, u + 1)));
      ++places[insertion.dimension_of_face.value_or(4) - 1];
    }
  }
  for (const std::size_t often : places) CHECK(occurs(often));
}

TEST_CASE("D2 insertion by flips makes the canonical triangulation, with weights and without") {
  for (const std::size_t d : {1u, 2u, 3u, 4u, 5u}) {
    CAPTURE(d);
    CHECK(holds("flip insertion", d >= 4 ? 40 : 300, [d] {
      const PointsCase set = *point_sets(d, d >= 4 ? 8 : 10);
      const PointSet points(set.points, set.weights);
      RC_ASSERT(delaunay::flip_insertion(points) == delaunay::by_definition(points));
    }));
  }
}

// Does the run say what is so: every facet that is not locally Delaunay is blocked by simplices
// that the triangulation lacks, and no other facet is listed?
void assert_blocked_facets(const PointSet& points, const FlippedTriangulation& result,
                           FlipTest test) {
  const StarIndex triangulation(result.triangulation.simplices());
  std::vector<Simplex> not_delaunay;
  for (const Simplex& facet : facets_of(result.triangulation.simplices())) {
    if (!delaunay::is_locally_delaunay(points, triangulation, facet, test)) {
      not_delaunay.push_back(facet);
    }
  }
  std::vector<Simplex> listed;
  for (const BlockedFacet& blocked : result.run.blocked) {
    listed.push_back(blocked.facet);
    const auto flip = delaunay::extended_flip(
        triangulation, delaunay::flip_of_facet(points, triangulation, blocked.facet));
    RC_ASSERT(!flip.has_value());
    RC_ASSERT(flip.error().missing == blocked.missing);
  }
  RC_ASSERT(listed == not_delaunay);
}

void assert_is_delaunay(const PointSet& points, const Triangulation& triangulation) {
  for (const check::By by : {check::By::kLemma, check::By::kDefinition}) {
    RC_ASSERT(check::judge_exactly(Claim::kDelaunay, {points, triangulation.simplices()}, nullptr,
                                   {.by = by})
                  .holds());
  }
}

TEST_CASE("D7 in the plane the flip algorithm reaches a Delaunay triangulation from any other") {
  CHECK(holds("Proposition 2.5", 300, [] {
    const TriangulationCase start = *flipped_triangulations(
        generators::unweighted(rc::gen::oneOf(generators::degenerate_point_set(2, 12),
                                              generators::generic_point_set(2, 12))),
        20);
    const PointSet points = start.points();
    const FlippedTriangulation result = delaunay::flip_algorithm(points, start.triangulation);
    RC_ASSERT(!result.run.is_stuck());
    RC_ASSERT(result.triangulation == delaunay::by_definition(points));
    RC_ASSERT(Integer(result.run.flips) <= delaunay::most_flips(points.size(), 2));
    // Each flip removes an edge for good.
    RC_ASSERT(2 * result.run.flips <= points.size() * (points.size() - 1));

    const FlippedTriangulation unperturbed =
        delaunay::flip_algorithm(points, start.triangulation, FlipTest::kUnperturbed);
    RC_ASSERT(!unperturbed.run.is_stuck());
    assert_is_delaunay(points, unperturbed.triangulation);
  }));
}

TEST_CASE("D7 from any triangulation the flip algorithm ends at the canonical one or says stuck") {
  for (const std::size_t d : {2u, 3u, 4u}) {
    CAPTURE(d);
    CHECK(holds("the flip algorithm", d == 4 ? 50 : 500, [d] {
      const TriangulationCase start =
          *flipped_triangulations(point_sets(d, d == 4 ? 8 : 10), d == 4 ? 6 : 15);
      const PointSet points = start.points();
      const auto k = static_cast<std::size_t>(std::max(points.dimension(), 0));
      for (const FlipTest test : {FlipTest::kPerturbed, FlipTest::kUnperturbed}) {
        const FlippedTriangulation result =
            delaunay::flip_algorithm(points, start.triangulation, test);
        assert_blocked_facets(points, result, test);
        RC_ASSERT(Integer(result.run.flips) <= delaunay::most_flips(points.size(), k));
        if (!points.is_weighted()) {
          RC_ASSERT(
              check::judge_points(Claim::kTriangulation, {points, result.triangulation.simplices()})
                  .holds());
        }
        if (result.run.is_stuck()) continue;
        if (test == FlipTest::kPerturbed) {
          RC_ASSERT(result.triangulation == delaunay::by_definition(points));
        } else if (!points.is_weighted()) {
          assert_is_delaunay(points, result.triangulation);
        }
      }
    }));
  }
}

TEST_CASE("D7 the flip algorithm is stuck at once at the corpus's stuck triangulations") {
  for (const std::string name : {"stuck-3d", "stuck-weighted-2d"}) {
    CAPTURE(name);
    formats::MeshRequest request{CIRCUMSPECT_CORPUS_DIR "/regressions/" + name + ".ele"};
    if (name == "stuck-weighted-2d") request.weights = formats::Weights::kDemanded;
    const auto file = formats::read_mesh(request);
    REQUIRE(file.has_value());
    const ExactMesh mesh = exact(file->mesh);
    const PointSet& points = mesh.points;
    const Triangulation start(points.dimension(), mesh.simplices);
    CHECK(points.is_weighted() == (points.dimension() == 2));
    CHECK(check::judge_points(Claim::kTriangulation, {points, start.simplices()}).holds());
    for (const FlipTest test : {FlipTest::kPerturbed, FlipTest::kUnperturbed}) {
      const FlippedTriangulation result = delaunay::flip_algorithm(points, start, test);
      CHECK(result.run.flips == 0);
      CHECK(result.run.blocked.size() == 6);
      CHECK(result.triangulation == start);
      assert_blocked_facets(points, result, test);
    }
    CHECK(!(delaunay::by_definition(points) == start));
    CHECK(delaunay::flip_insertion(points) == delaunay::by_definition(points));
  }
}

}  // namespace
}  // namespace circumspect::properties
