// What is found out of a mesh once, though it is asked about several domains or distances.
#pragma once

#include <optional>

#include "oracle/judge/fast/simplex_facts.hpp"
#include "oracle/judge/fast_view.hpp"
#include "oracle/model/domain.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/options.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// What the fast engine finds out of the simplices for a claim about a domain of this kind; or why
// it leaves the mesh undecided, or `options` ask for more.
OrReason<fast::SimplexFacts> facts_of_simplices(Claim claim, const Mesh& mesh, DomainKind kind,
                                                const Options& options);

// A mesh in exact numbers, and these facts: the same for every domain of one kind. judge_domain and
// judge_within take both.
struct KnownMesh {
  KnownMesh(Claim claim, const Mesh& mesh, DomainKind kind, const Options& options);

  ExactMesh exact;
  std::optional<fast::SimplexFacts> facts;

  const fast::SimplexFacts* known() const { return facts ? &*facts : nullptr; }
};

}  // namespace circumspect::check
