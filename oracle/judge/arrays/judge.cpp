#include "oracle/judge/judge.hpp"

#include <stdexcept>

#include <circumspect/judgement.hpp>

#include "oracle/judge/arrays/claim_named.hpp"
#include "oracle/judge/arrays/mesh_of.hpp"
#include "oracle/report/text.hpp"

namespace circumspect {

Claim arrays::claim_named(const std::string& claim) {
  for (const Claim known : {Claim::kTriangulation, Claim::kDelaunay, Claim::kWeightedDelaunay}) {
    if (claim == name(known)) return known;
  }
  throw std::invalid_argument("expected triangulation, delaunay or weighted-delaunay, found '" +
                              claim + "'");
}

Judgement judge(const std::string& claim, const PointArray& points, const SimplexArray& simplices) {
  const Claim known = arrays::claim_named(claim);
  Mesh mesh = arrays::mesh_of(points, simplices, known == Claim::kWeightedDelaunay);
  const Verdict verdict = check::judge_merged(known, mesh, nullptr, {.threads = 1});
  if (verdict.holds()) return {true, "", ""};
  const Rule rule = verdict.violations().front().rule;
  return {false, std::string(identifier(rule)), report::explanation(verdict, mesh)};
}

}  // namespace circumspect
