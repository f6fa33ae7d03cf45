// Large meshes of doubles, judged where they lie (oracle/judge/fast), in the words of all other verdicts.
#pragma once

#include <optional>

#include "oracle/formats/flat_mesh.hpp"
#include "oracle/judge/points/check.hpp"
#include "oracle/judge/verdict_of_facts.hpp"

namespace circumspect::check {

// What judge() says of the same mesh, if it holds, or if it is a triangulation and only some facets are
// not locally Delaunay; then no two of its points are equal. None if that is not how it is, or cannot be
// decided so: then judge() says what is wrong. Of a claim with weights, these are the first attributes.
// `threads`: 0: as many as the machine has; the answer is the same for any number.
std::optional<FlatVerdict> judge_flat(Claim claim, const formats::FlatMesh& mesh,
                                      const Options& options = {}, unsigned threads = 0);

// The same for a mesh of exact numbers, if they are all doubles. The verdict's witnesses name `mesh`.
std::optional<Verdict> judge_as_doubles(Claim claim, const Mesh& mesh, const Options& options = {},
                                        unsigned threads = 0);

}  // namespace circumspect::check
