#include "oracle/judge/cause/causes.hpp"

#include <algorithm>

#include "oracle/judge/cause/rows.hpp"

namespace circumspect::check {
namespace {

constexpr std::size_t kMostCauses = 3;

// At least one of these rules is broken if the cause can be one.
struct Row {
  std::vector<Rule> explains;
  std::optional<Cause> (*find)(Case&);
};

const std::vector<Row>& rows() {
  static const std::vector<Row> kRows = {
      {{Rule::kUnknownVertex}, indices_begin_elsewhere},
      {{Rule::kWrongDimension, Rule::kUnknownVertex}, last_column_is_a_label},
      {{Rule::kUnknownVertex}, too_few_points},
      {{Rule::kWrongDimension}, last_coordinate_is_none},
      {{Rule::kDuplicateSimplex}, listed_twice},
      {{Rule::kPointsEqual}, equal_points_of_parts},
      {{Rule::kOrientation, Rule::kInverted}, turned_simplices},
      {{Rule::kOverlap, Rule::kDegenerateSimplex}, other_points},
      {{Rule::kUnusedPoint}, near_points},
      {{Rule::kNotClosed}, cracks},
      {{Rule::kHullNotClosed, Rule::kHullNotConvex, Rule::kUncovered, Rule::kPolygonNotTiled,
        Rule::kUnusedPoint, Rule::kDomainVertexMissing, Rule::kSegmentMissing, Rule::kNotClosed},
       missing_simplices},
      {{Rule::kNotClosed}, holes_of_surface},
      {{Rule::kNotOriented}, turned_triangles},
      {{Rule::kUnusedPoint}, left_over_points},
      {{Rule::kHullNotClosed, Rule::kHullNotConvex, Rule::kUncovered, Rule::kPolygonNotTiled,
        Rule::kFacesCross, Rule::kOverlap},
       crossed_diagonals},
      {{Rule::kHullNotClosed, Rule::kHullNotConvex, Rule::kUncovered, Rule::kPolygonNotTiled,
        Rule::kHangingVertex, Rule::kOverlap},
       hanging_vertices},
      {{Rule::kHullNotClosed, Rule::kHullNotConvex, Rule::kUncovered, Rule::kPolygonNotTiled,
        Rule::kOverlap},
       vertices_beside_faces},
      {{Rule::kOverlap, Rule::kDegenerateSimplex, Rule::kHullNotConvex, Rule::kHullNotClosed,
        Rule::kCoveredTwice, Rule::kFacetNotLocal, Rule::kVertexInBall},
       one_vertex},
      {{Rule::kOverlap}, parts_in_each_other},
      {{Rule::kStrayFace}, faces_begin_elsewhere},
  };
  return kRows;
}

}  // namespace

Causes causes(const Verdict& verdict, const Mesh& mesh, const JudgeAgain& judge,
              const fast::SimplexFacts* known) {
  Causes all;
  // What is mended is not unfolded.
  if (verdict.holds() || mesh.copies) return all;
  Case of(verdict, mesh, judge, known);
  for (const Row& row : rows()) {
    const bool is_broken = std::any_of(row.explains.begin(), row.explains.end(),
                                       [&](Rule rule) { return of.breaks(rule); });
    const bool are_explained =
        !all.found.empty() && all.found.back().explains == all.found.back().of;
    // Of points that belong to another mesh, all else is a consequence.
    const bool are_others = !all.found.empty() && all.found.back().name == "points-of-another-mesh";
    if (are_explained || are_others) break;
    if (!is_broken) continue;
    if (auto cause = row.find(of); cause && cause->explains > 0) {
      all.found.push_back(std::move(*cause));
    }
  }
  std::stable_sort(all.found.begin(), all.found.end(),
                   [](const Cause& a, const Cause& b) { return a.explains > b.explains; });
  // Flat simplices keep the others from being judged, but not by the claim `complex`.
  const bool is_of_these_points =
      std::none_of(all.found.begin(), all.found.end(),
                   [](const Cause& cause) { return cause.name == "points-of-another-mesh"; });
  if (of.breaks(Rule::kDegenerateSimplex) && is_of_these_points) of.as_complex();
  if (all.found.size() > kMostCauses) all.found.resize(kMostCauses);
  all.as_complex = of.take_as_complex();
  return all;
}

}  // namespace circumspect::check
