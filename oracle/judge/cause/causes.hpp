// Why a claim may not hold of a mesh: the cause, and not its consequences.
#pragma once

#include <optional>
#include <vector>

#include "oracle/judge/cause/case.hpp"

namespace circumspect::check {

struct Causes {
  std::vector<Cause> found = {};  // at most three, that which explains most first
  // What the claim `complex` says of the mesh, if it was asked on the way.
  std::optional<Verdict> as_complex = {};
};

// None if the claim holds. Each is checked: the mended mesh is judged, or the violations that it
// explains are counted. Beside passes over the simplices, at most one mended mesh is judged, and at
// most once, of limited size, the claim `complex`.
// `known`: what is known of the simplices, if anything.
Causes causes(const Verdict& verdict, const Mesh& mesh, const JudgeAgain& judge,
              const fast::SimplexFacts* known = nullptr);

}  // namespace circumspect::check
