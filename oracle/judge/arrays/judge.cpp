#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include <circumspect/judgement.hpp>

#include "oracle/judge/arrays/claim_named.hpp"
#include "oracle/judge/arrays/mesh_of.hpp"
#include "oracle/judge/points/check.hpp"
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
  const Mesh mesh = arrays::mesh_of(points, simplices, known == Claim::kWeightedDelaunay);
  const Verdict verdict = check::judge(known, mesh);
  if (verdict.holds()) return {true, "", ""};
  const Rule rule = verdict.violations().front().rule;
  return {false, std::string(identifier(rule)), report::explanation(verdict, mesh)};
}

}  // namespace circumspect
