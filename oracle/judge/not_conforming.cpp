#include "oracle/judge/not_conforming.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "kernel/boxes/interval.hpp"
#include "kernel/complex/circumball.hpp"
#include "kernel/exact/triple.hpp"
#include "oracle/judge/domain/conforming_delaunay.hpp"
#include "oracle/judge/domain/triangle_walls.hpp"
#include "oracle/judge/domain/vertex_index.hpp"
#include "oracle/judge/domain/vertex_places.hpp"
#include "oracle/judge/fast/box_tree.hpp"
#include "oracle/judge/part_of_mesh.hpp"
#include "oracle/judge/points/delaunay.hpp"
#include "oracle/judge/verdict_of_faults.hpp"

namespace circumspect::check {
namespace {

// All points in the balls of these simplices, and a few near them.
template <typename Index>
std::vector<std::size_t> points_near(const fast::MeshView<3, Index>& mesh,
                                     const std::vector<std::size_t>& simplices) {
  std::vector<std::size_t> found;
  if (simplices.empty()) return found;
  const ExactMesh part = Part<3, Index>(mesh, simplices, {}).mesh(false);
  std::vector<fast::AxisBox> points;
  points.reserve(mesh.points());
  for (std::size_t v = 0; v < mesh.points(); ++v) {
    points.push_back(fast::box_of_point(mesh.coordinates, v));
  }
  const fast::BoxTree tree(std::move(points));
  for (const Simplex& simplex : part.simplices) {
    const Ball ball = circumball(part.points, simplex);
    Triple<Interval> centre;
    for (std::size_t axis = 0; axis < 3; ++axis) centre[axis] = enclosing(ball.centre[axis]);
    const double far = upper_double(ball.squared_radius);
    std::size_t steps = std::numeric_limits<std::size_t>::max();
    tree.all_near(
        steps,
        [&](const fast::AxisBox& box) {
          return least_squared_distance(box.low, box.high, centre) > far;
        },
        [&](std::uint32_t v) {
          found.push_back(v);
          return true;
        });
  }
  return found;
}

// The facets at which a ball is in doubt, those of the boundary without an apex beyond.
template <typename Index>
std::vector<SharedFacet> doubtful_facets(const fast::MeshView<3, Index>& mesh,
                                         const fast::SimplexFacts& known) {
  std::vector<SharedFacet> facets = shared_facets(mesh, known.not_local);
  for (const fast::FacetId facet : known.boundary) {
    const std::size_t s = facet.simplex();
    if (!std::binary_search(known.doubtful_balls->begin(), known.doubtful_balls->end(), s))
      continue;
    const auto vertices = fast::facet_of(mesh.row(s), facet.place());
    facets.push_back({{vertices.begin(), vertices.end()}, s, kNoVertex});
  }
  std::sort(facets.begin(), facets.end(),
            [](const SharedFacet& a, const SharedFacet& b) { return a.facet < b.facet; });
  return facets;
}

template <typename Index>
void judge_balls(const fast::MeshView<3, Index>& mesh, const fast::SimplexFacts& known,
                 Verdict& verdict) {
  std::vector<std::size_t> points = points_near(mesh, *known.doubtful_balls);
  std::vector<std::size_t> simplices = *known.doubtful_balls;
  std::vector<SharedFacet> facets = doubtful_facets(mesh, known);
  for (const SharedFacet& facet : facets) {
    simplices.push_back(facet.simplex);
    if (facet.apex != kNoVertex) points.push_back(static_cast<std::size_t>(facet.apex));
  }
  const Part<3, Index> part(mesh, std::move(simplices), points);
  const ExactMesh exact = part.mesh(false);
  const VertexIndex index(exact.points);
  std::vector<bool> judged(exact.simplices.size(), false);
  for (SharedFacet& facet : facets) {
    for (Vertex& v : facet.facet) v = part.place_of(v);
    facet.simplex = part.place_of_simplex(facet.simplex);
    if (facet.apex != kNoVertex) {
      facet.apex = part.place_of(facet.apex);
      judge_facet_locally_delaunay(exact, facet, verdict);
    } else if (!judged[facet.simplex]) {  // at the first of its facets on the boundary
      judged[facet.simplex] = true;
      judge_ball_at_boundary(exact, index, facet.simplex, facet.facet, verdict);
    }
  }
  verdict.name_in_whole(part.vertices(), part.simplices());
}

}  // namespace

template <typename Index>
std::optional<Verdict> not_conforming(const fast::MeshView<3, Index>& mesh,
                                      const std::vector<Simplex>& faces, const Domain& domain,
                                      const fast::SimplexFacts& known, const Options& options) {
  if (!known.doubtful_balls) return std::nullopt;
  if (known.not_local.empty() && known.doubtful_balls->empty()) return std::nullopt;
  auto filled = held_by_facets(Claim::kSteinerTriangulation, mesh, faces, domain, known, options);
  if (!filled) return std::nullopt;
  Verdict verdict(Claim::kConformingDelaunay, options.max_violations);
  verdict.points = filled->points;
  verdict.simplices = filled->simplices;
  verdict.dimension = filled->dimension;
  verdict.steiner_points = filled->steiner_points;
  verdict.extra_vertices = std::move(filled->extra_vertices);
  judge_balls(mesh, known, verdict);
  return verdict;
}

template std::optional<Verdict> not_conforming(const fast::MeshView<3, std::int32_t>&,
                                               const std::vector<Simplex>&, const Domain&,
                                               const fast::SimplexFacts&, const Options&);
template std::optional<Verdict> not_conforming(const fast::MeshView<3, std::int64_t>&,
                                               const std::vector<Simplex>&, const Domain&,
                                               const fast::SimplexFacts&, const Options&);

}  // namespace circumspect::check
