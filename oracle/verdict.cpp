#include "oracle/verdict.hpp"

namespace circumspect {

std::string_view name(Claim claim) {
  switch (claim) {
    case Claim::kTriangulation:
      return "triangulation";
    case Claim::kDelaunay:
      return "delaunay";
    case Claim::kWeightedDelaunay:
      return "weighted-delaunay";
  }
  return "";
}

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
