#include "reference/delaunay/flip_algorithm.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/star_index.hpp"
#include "kernel/complex/triangulation.hpp"
#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/perturbation.hpp"
#include "reference/delaunay/flip.hpp"

namespace circumspect::delaunay {

bool is_locally_delaunay(const PointSet& points, const StarIndex& triangulation,
                         const Simplex& facet, FlipTest test) {
  const std::vector<Simplex> sides = triangulation.star(facet);
  if (sides.size() < 2) return true;
  const Vertex apex = without(sides[1], facet).front();
  const Configuration& configuration = points.configuration();
  return test == FlipTest::kPerturbed ? perturbed_in_ball(configuration, sides[0], apex) < 0
                                      : in_ball(configuration, sides[0], apex) <= 0;
}

FlipRun flip_until_done(const PointSet& points, StarIndex& triangulation,
                        std::vector<Simplex> facets, FlipTest test, const FlipWatch& watch) {
  FlipRun run;
  while (!facets.empty()) {
    const Simplex facet = facets.back();
    facets.pop_back();
    // A facet that a flip has removed meanwhile has no star.
    if (is_locally_delaunay(points, triangulation, facet, test)) continue;
    auto flip = extended_flip(triangulation, flip_of_facet(points, triangulation, facet));
    if (!flip) {
      run.blocked.push_back({facet, std::move(flip.error().missing)});
      continue;
    }
    triangulation.replace(flip->deleted, flip->created);
    if (watch) watch({*flip, {}, facet});
    ++run.flips;
    // The flip may have created simplices whose lack blocked others: look at those again, after the
    // facets of the new simplices.
    for (BlockedFacet& blocked : run.blocked) facets.push_back(std::move(blocked.facet));
    run.blocked.clear();
    for (Simplex& changed : facets_of(flip->created)) facets.push_back(std::move(changed));
  }
  std::sort(run.blocked.begin(), run.blocked.end(),
            [](const BlockedFacet& a, const BlockedFacet& b) { return a.facet < b.facet; });
  // A facet may have been pushed by the simplices on both of its sides.
  run.blocked.erase(
      std::unique(run.blocked.begin(), run.blocked.end(),
                  [](const BlockedFacet& a, const BlockedFacet& b) { return a.facet == b.facet; }),
      run.blocked.end());
  return run;
}

FlippedTriangulation flip_algorithm(const PointSet& points, const Triangulation& start,
                                    FlipTest test) {
  StarIndex triangulation(start.simplices());
  FlipRun run = flip_until_done(points, triangulation, facets_of(start.simplices()), test);
  return {triangulation.triangulation(start.dimension()), std::move(run)};
}

Integer most_flips(std::size_t n, std::size_t d) {
  Integer binomial = 1;
  Integer sum = 0;
  for (std::size_t i = 1; i <= 1 + d / 2 && i <= n; ++i) {
    binomial = binomial * to_integer(n - i + 1) / to_integer(i);
    sum += binomial;
  }
  return 2 * sum;
}

}  // namespace circumspect::delaunay
