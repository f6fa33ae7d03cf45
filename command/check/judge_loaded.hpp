// Judges a mesh that was read from files.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "command/input/input.hpp"
#include "oracle/judge/judge.hpp"

namespace circumspect::cli {

// What check::judge says of the mesh, in which equal points are merged on the way if they have not
// been, or one line that says what is wrong with them if they are refused.
inline tl::expected<Verdict, std::string> judge_loaded(Claim claim, LoadedMesh& loaded,
                                                       Duplicates duplicates,
                                                       const check::Options& options,
                                                       const Domain* domain = nullptr) {
  if (duplicates == Duplicates::kMerge) {
    return check::judge(claim, check::Merging{loaded.mesh, &loaded.merged}, domain, options);
  }
  auto verdict = check::judge(claim, loaded.mesh, domain, options);
  if (verdict) return std::move(*verdict);
  return tl::unexpected(equal_points_fault(loaded, verdict.error().repeated));
}

// What is claimed of a mesh and a domain where nobody says it: a CDT, which is a Steiner CDT if the
// mesh has other vertices than the domain; more of them, if they may have been moved.
inline Claim default_claim(const Mesh& mesh, const Domain& domain, bool may_be_moved = false) {
  const PointSet& vertices = domain.complex.points;
  bool same = mesh.points() == vertices.size();
  if (same && !may_be_moved) {
    std::vector<Point> of_mesh = mesh.exact_points();
    std::vector<Point> of_domain = vertices.points();
    std::sort(of_mesh.begin(), of_mesh.end());
    std::sort(of_domain.begin(), of_domain.end());
    same = of_mesh == of_domain;
  }
  return same ? Claim::kCdt : Claim::kSteinerCdt;
}

}  // namespace circumspect::cli
