// Judges a mesh that is spread over many ranks. Each rank has a part, and none has the whole mesh.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "oracle/distributed/conditions.hpp"
#include "oracle/distributed/local_mesh.hpp"
#include "oracle/distributed/ranks.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/options.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::distributed {

struct Judged {
  // At all ranks: does the claim hold? If there are equal points, there is no verdict.
  bool holds = false;
  EqualPoints equal = {};
  // At the first rank: the verdict that check::judge gives on the whole mesh, and a mesh by which
  // the report names what the witnesses name (report/text.hpp).
  std::optional<Verdict> verdict = {};
  Mesh named = {};
};

// report::fault_of_equal_points, for a mesh whose first point has this index.
std::string fault_of_equal_points(const EqualPoints& equal, Vertex first_index,
                                  std::string_view to_merge);

// Does the claim hold for the mesh that all ranks have together? The verdict is that of
// check::judge, word for word, however many ranks there are and however the simplices are
// distributed. Called by all ranks.
//
// Only max_violations and threads of `options` count; threads are those of each rank, and 0 stands
// for 1. Memory: see docs/distributed.md; the first rank also holds all faults. Requires: a claim
// about points; dimension 2 or 3, and simplices in rows of one vertex more, at all ranks; weights
// at all ranks, if the claim is about them; what LocalMesh requires.
Judged judge(Ranks& ranks, Claim claim, Dealt dealt, const check::Options& options);

}  // namespace circumspect::distributed
