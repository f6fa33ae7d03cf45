#include "oracle/judge/surface/judge_surface.hpp"

#include "kernel/complex/by_facet.hpp"
#include "kernel/exact/angle.hpp"
#include "oracle/judge/complex/judge_complex.hpp"
#include "oracle/judge/definition/quality.hpp"
#include "oracle/judge/definition/surface_delaunay.hpp"

namespace circumspect::check {
namespace {

using definition::InteriorEdge;
using definition::SurfaceEdges;

constexpr std::size_t kTriangle = 3;

// What definition::surface_edges says.
SurfaceEdges matched_edges(const std::vector<Simplex>& triangles) {
  SurfaceEdges edges;
  for (const auto group : ByFacet(facet_uses(triangles))) {
    edges.boundary += group.size() == 1 ? 1 : 0;
    edges.set_apart += group.size() > 2 ? 1 : 0;
    if (group.size() != 2) continue;
    const auto opposite = [&](const FacetUse& use) { return triangles[use.simplex][use.opposite]; };
    edges.interior.push_back({group[0].facet, group[0].simplex, group[1].simplex,
                              opposite(group[0]), opposite(group[1])});
  }
  return edges;
}

// x / √a, for a > 0.
struct Cotangent {
  Rational x, a;
};

Cotangent cotangent(const Point& apex, const Point& p, const Point& q) {
  const Point to_p = p - apex, to_q = q - apex;
  const Rational product = inner_product(to_p, to_q);
  return {product, squared_length(to_p) * squared_length(to_q) - product * product};
}

// The sign of cot α + cot β, which is that of sin(α + β): x/√a + y/√b. Only if x and y have
// opposite signs do their squares decide.
bool have_sum_of_at_most_pi(const Cotangent& alpha, const Cotangent& beta) {
  const int first = sign(alpha.x), second = sign(beta.x);
  if (first >= 0 && second >= 0) return true;
  if (first <= 0 && second <= 0) return false;
  const Rational left = alpha.x * alpha.x * beta.a, right = beta.x * beta.x * alpha.a;
  return first > 0 ? left >= right : right >= left;
}

class SurfaceJudge {
 public:
  SurfaceJudge(const ExactMesh& mesh, bool by_definition, Verdict& verdict)
      : points_(mesh.points.points()),
        listed_{points_, mesh.simplices},
        by_definition_(by_definition),
        verdict_(verdict) {
    Findings found;
    found.apart = by_definition ? definition::set_apart(listed_, kTriangle)
                                : sorted_apart(listed_, mesh.points.configuration(), kTriangle);
    add_findings(listed_, found, {}, kTriangle, verdict);
    for (const std::size_t s : found.apart.compared) triangles_.push_back(listed_.simplices[s]);
  }

  void judge() {
    const SurfaceEdges edges =
        by_definition_ ? definition::surface_edges(triangles_) : matched_edges(triangles_);
    verdict_.surface = {edges.interior.size(), edges.boundary, edges.set_apart};
    for (const InteriorEdge& edge : edges.interior) {
      if (!is_delaunay(edge)) add(edge);
    }
  }

 private:
  const Point& at(Vertex v) const { return points_[static_cast<std::size_t>(v)]; }

  bool is_delaunay(const InteriorEdge& edge) const {
    if (by_definition_) return definition::is_delaunay(points_, edge);
    const Point &p = at(edge.edge[0]), &q = at(edge.edge[1]);
    return have_sum_of_at_most_pi(cotangent(at(edge.of_first), p, q),
                                  cotangent(at(edge.of_second), p, q));
  }

  void add(const InteriorEdge& edge) {
    if (!verdict_.keeps_more()) {
      verdict_.count(Rule::kEdgeNotDelaunay);
      return;
    }
    const Point &p = at(edge.edge[0]), &q = at(edge.edge[1]);
    const Rational alpha = definition::signed_square_at({at(edge.of_first)}, p, q);
    const Rational beta = definition::signed_square_at({at(edge.of_second)}, p, q);
    verdict_.add(Rule::kEdgeNotDelaunay,
                 {.simplices = {triangles_[edge.first], triangles_[edge.second]},
                  .face = edge.edge,
                  .vertices = {edge.of_first, edge.of_second},
                  .values = {{"squared cosine of the first angle, with the sign", alpha},
                             {"squared cosine of the second angle, with the sign", beta}},
                  .rounded = {{"excess in degrees", excess_in_degrees(alpha, beta)}}});
  }

  const std::vector<Point>& points_;
  definition::ListedComplex listed_;
  bool by_definition_;
  Verdict& verdict_;
  std::vector<Simplex> triangles_;  // that are compared
};

}  // namespace

std::string fault_of_surface(const Mesh& mesh) {
  const std::size_t size = mesh.simplices.columns();
  if (mesh.simplices.empty()) {
    return "expected triangles for the claim surface-delaunay, found no simplices";
  }
  if (size == 0 || size == kTriangle) return "";
  return "expected triangles for the claim surface-delaunay, found simplices of " +
         std::to_string(size) +
         " vertices: it is about surfaces; --claim delaunay is about what fills space";
}

Verdict judge_surface(const ExactMesh& mesh, bool by_definition, std::size_t max_violations) {
  Verdict verdict(Claim::kSurfaceDelaunay, mesh, max_violations);
  SurfaceJudge(mesh, by_definition, verdict).judge();
  return verdict;
}

}  // namespace circumspect::check
