#include "oracle/model/verdict.hpp"

namespace circumspect {

std::string_view name(Claim claim) {
  switch (claim) {
    case Claim::kTriangulation:
      return "triangulation";
    case Claim::kDelaunay:
      return "delaunay";
    case Claim::kWeightedDelaunay:
      return "weighted-delaunay";
    case Claim::kPlcTriangulation:
      return "plc-triangulation";
    case Claim::kSteinerTriangulation:
      return "steiner-triangulation";
    case Claim::kCdt:
      return "cdt";
    case Claim::kSteinerCdt:
      return "steiner-cdt";
    case Claim::kConformingDelaunay:
      return "conforming-delaunay";
  }
  return "";
}

bool is_about_a_domain(Claim claim) { return claim >= Claim::kPlcTriangulation; }

Verdict::Verdict(Claim claim, const Mesh& mesh, std::size_t max_violations)
    : points(mesh.points.size()),
      simplices(mesh.simplices.size()),
      dimension(mesh.points.dimension()),
      claim_(claim),
      max_violations_(max_violations) {}

void Verdict::add(Rule rule, const Witness& witness, const std::optional<Rational>& margin) {
  if (keeps_more()) violations_.push_back({rule, witness});
  count(rule, margin);
}

void Verdict::count(Rule rule, const std::optional<Rational>& margin) {
  Tally& tally = tallies_[rule];
  ++tally.count;
  if (!margin) return;
  if (!tally.worst_margin || *tally.worst_margin < *margin) tally.worst_margin = margin;
}

}  // namespace circumspect
