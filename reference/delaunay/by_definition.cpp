#include "reference/delaunay/by_definition.hpp"

#include "reference/kernel/complex/simplex.hpp"
#include "reference/kernel/predicates/orientation.hpp"
#include "reference/kernel/predicates/perturbation.hpp"

namespace circumspect::delaunay {
namespace {

// Is there an open circumball of the simplex that contains no point of S? Book: Section 4.2.
bool is_delaunay(const PointSet& points, const Simplex& simplex) {
  for (Vertex q = 0; points.names(q); ++q) {
    if (contains(simplex, q)) continue;
    if (perturbed_in_ball(points.configuration(), simplex, q) > 0) return false;
  }
  return true;
}

}  // namespace

Triangulation by_definition(const PointSet& points) {
  const int k = points.dimension();
  std::vector<Simplex> simplices;
  if (points.empty()) return Triangulation(k, simplices);
  Simplex subset = first_subset(static_cast<std::size_t>(k) + 1);
  do {
    if (orientation(points.configuration(), subset) == 0) continue;
    if (is_delaunay(points, subset)) simplices.push_back(subset);
  } while (next_subset(subset, points.size()));
  return Triangulation(k, std::move(simplices));
}

}  // namespace circumspect::delaunay
