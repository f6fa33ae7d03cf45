// What is wrong with a mesh that fills a domain of triangles, but is not Delaunay.
#pragma once

#include <optional>
#include <vector>

#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/judge/fast/simplex_facts.hpp"
#include "oracle/judge/points/delaunay.hpp"
#include "oracle/model/domain.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// What judge_domain() says of the mesh under the claim `conforming-delaunay`, word for word, if
// held_by_facets() (triangle_walls.hpp) sees that it triangulates the domain, and only balls are
// left to be judged: the exact checkers look again at the facets and balls that are in doubt, on no
// more of the mesh than they need. Instances: std::int32_t and std::int64_t. Requires: as
// held_by_facets(); `known` was asked for balls and boundary balls.
template <typename Index>
std::optional<Verdict> not_conforming(const fast::MeshView<3, Index>& mesh,
                                      const std::vector<Simplex>& faces, const Domain& domain,
                                      const fast::SimplexFacts& known, const Options& options);

}  // namespace circumspect::check
