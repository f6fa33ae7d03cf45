// Domains in space whose polygons are triangles of doubles, as most domains are. Doubles suffice to
// see that such a domain is valid, and that a mesh with all its triangles as facets is right. The
// exact checkers judge everything else.
#pragma once

#include <optional>
#include <vector>

#include <tl/expected.hpp>

#include "kernel/piecewise_linear/validity.hpp"
#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/judge/fast/simplex_facts.hpp"
#include "oracle/model/domain.hpp"
#include "oracle/model/options.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// What `validated` (validity.hpp) says of an input, which takes long only where this is not one of
// triangles that meet properly.
tl::expected<PiecewiseLinearComplex, std::vector<Breach>> validated_domain(
    const PiecewiseLinearInput& input, std::size_t limit = kBreachLimit,
    const ValidityWatch& watch = {});

// The verdict on a mesh that holds and has every wall triangle of the domain for a facet, if this
// is seen to be so; `faces` are listed beside it. Why it suffices: docs/theory/domains.md.
// Instances: std::int32_t and std::int64_t. Requires: `known` are the facts of the mesh; no two of
// its points are equal; no neighbours are listed.
template <typename Index>
std::optional<Verdict> held_by_facets(Claim claim, const fast::MeshView<3, Index>& mesh,
                                      const std::vector<Simplex>& faces, const Domain& domain,
                                      const fast::SimplexFacts& known, const Options& options);

}  // namespace circumspect::check
