#include "oracle/check/submerged_points.hpp"

#include <optional>

#include "oracle/check/ball_witness.hpp"
#include "oracle/check/simplices.hpp"
#include "reference/predicates/in_ball.hpp"
#include "reference/predicates/orientation.hpp"

namespace circumspect::check {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

// For each vertex of each simplex the simplex across the opposite facet.
std::vector<std::vector<std::size_t>> neighbors_of(const std::vector<Simplex>& simplices,
                                                   const std::vector<FacetUse>& uses) {
  std::vector<std::vector<std::size_t>> across;
  across.reserve(simplices.size());
  for (const Simplex& simplex : simplices) across.emplace_back(simplex.size(), kNone);
  for_each_facet(uses, [&](std::span<const FacetUse> group) {
    if (group.size() != 2) return;
    across[group[0].simplex][group[0].opposite] = group[1].simplex;
    across[group[1].simplex][group[1].opposite] = group[0].simplex;
  });
  return across;
}

// A vertex of the simplex whose opposite facet has q strictly on its other side; none if the closed
// simplex contains q.
std::optional<std::size_t> facet_that_hides(const Configuration& points, const Simplex& simplex,
                                            Vertex q) {
  const int own = orientation(points, simplex);
  for (std::size_t place = 0; place < simplex.size(); ++place) {
    if (orientation(points, with_vertex_replaced(simplex, place, q)) * own < 0) return place;
  }
  return std::nullopt;
}

// The simplex that contains q, found by walking from `start` (Book: Section 5.5), or kNone. Such a
// walk can go round in circles where facets are not locally Delaunay: one that has visited more
// simplices than there are gives way to a look at every simplex.
std::size_t locate(const Mesh& mesh, const std::vector<std::vector<std::size_t>>& across,
                   std::size_t start, Vertex q) {
  const Configuration& points = mesh.points.configuration();
  std::size_t current = start;
  for (std::size_t steps = 0; steps <= mesh.simplices.size(); ++steps) {
    const auto place = facet_that_hides(points, mesh.simplices[current], q);
    if (!place) return current;
    current = across[current][*place];
    if (current == kNone) return kNone;  // Beyond a facet of the convex hull.
  }
  for (std::size_t s = 0; s < mesh.simplices.size(); ++s) {
    if (!facet_that_hides(points, mesh.simplices[s], q)) return s;
  }
  return kNone;
}

}  // namespace

void judge_submerged_points(const Mesh& mesh, const std::vector<FacetUse>& uses, Verdict& verdict,
                            Ambiguity& ambiguity) {
  const std::vector<Vertex> unused = unused_points(mesh);
  if (unused.empty() || mesh.simplices.empty()) return;
  const auto across = neighbors_of(mesh.simplices, uses);
  std::size_t place = 0;
  for (const Vertex q : unused) {
    const std::size_t found = locate(mesh, across, place, q);
    if (found == kNone) {
      verdict.add(Rule::kUnusedPoint, {.vertices = {q}, .point = mesh.points[q]});
      continue;
    }
    place = found;
    const Simplex& simplex = mesh.simplices[found];
    const int side = in_ball(mesh.points.configuration(), simplex, q);
    ambiguity.see(mesh.points, simplex, q, side);
    if (side > 0) add_in_ball(mesh, Rule::kPointBelowPlane, simplex, std::nullopt, q, verdict);
  }
}

}  // namespace circumspect::check
