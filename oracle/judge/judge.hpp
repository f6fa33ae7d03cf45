// The judge of meshes, for files, arrays, campaigns and harnesses.
#pragma once

#include <optional>
#include <vector>

#include <tl/expected.hpp>

#include "oracle/judge/domain/judge_domain.hpp"
#include "oracle/judge/fast/simplex_facts.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::check {

// Why a mesh could not be judged: it has points that are equal (see mesh.hpp).
struct EqualPoints {
  std::vector<Duplicate> repeated;
};

// Does the claim hold of the mesh? By lemma, where coordinates (and weights, if they count) are
// doubles, simplices are in rows, and d is 2 or 3, the fast engine (oracle/judge/fast) is asked
// first. It decides where the claim holds, and elsewhere lists what is at fault; that is looked at
// again, exactly. Of a mesh of a domain it finds out what is linear in the simplices. The exact
// checkers judge everything else. The verdict is the same whoever finds it: Verdict::course tells
// who.
//
// Equal points are an error, unless the claim is found to hold, or to fail by facets that are not
// locally Delaunay alone: then there are none. So nobody has to sort the points of a large mesh
// that holds.
// Of the claim `complex` they break a rule, and count as one for the rest.
// Requires: `domain` if and only if the claim is about one; then what judge_domain requires. No
// weights for `delaunay` and for claims about a domain.
tl::expected<Verdict, EqualPoints> judge(Claim claim, const Mesh& mesh,
                                         const Domain* domain = nullptr,
                                         const Options& options = {});

// The same where equal points count as one: they are merged if there are any.
Verdict judge_merged(Claim claim, Mesh& mesh, const Domain* domain = nullptr,
                     const Options& options = {});

// Why what is demanded beside the claim `complex` makes no sense of the mesh, one line; empty if it
// does.
std::string fault_of_demands(const Mesh& mesh, const ComplexDemands& demands);

// What the fast engine finds out of the simplices for a claim about a domain of this kind; nothing
// if it leaves the mesh undecided, or if `options` ask for more.
std::optional<fast::SimplexFacts> facts_of_simplices(Claim claim, const Mesh& mesh, DomainKind kind,
                                                     const Options& options);

}  // namespace circumspect::check
