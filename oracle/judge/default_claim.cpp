#include "oracle/judge/default_claim.hpp"

#include <algorithm>
#include <vector>

namespace circumspect::check {
namespace {

bool are_the_same(std::vector<Point> some, std::vector<Point> others) {
  std::sort(some.begin(), some.end());
  std::sort(others.begin(), others.end());
  return some == others;
}

}  // namespace

Claim default_claim(const Mesh& mesh, const Domain* domain, bool are_moved) {
  if (domain == nullptr) return Claim::kDelaunay;
  const PointSet& given = domain->complex.points;
  const bool has_them = mesh.points() == given.size() &&
                        (are_moved || are_the_same(mesh.exact_points(), given.points()));
  return has_them ? Claim::kCdt : Claim::kSteinerCdt;
}

}  // namespace circumspect::check
