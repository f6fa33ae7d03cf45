// What there is to say of the simplices of a mesh whatever they cover: for meshes of domains, whose
// walls decide the rest (docs/theory/domains.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <tl/expected.hpp>

#include "oracle/judge/fast/facet_matching.hpp"
#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/judge/fast/site.hpp"
#include "oracle/judge/fast/undecided.hpp"

namespace circumspect::fast {

// Facets are named by simplex · (d + 1) + place of the vertex opposite, those of two simplices as the one
// that comes first has them. All lists are ascending.
struct Volume {
  std::vector<std::uint64_t> boundary;       // facets of one simplex
  std::vector<std::uint64_t> not_local;      // of two, that are not locally Delaunay
  std::vector<std::uint64_t> ties;           // of two, whose apexes are on a common sphere
  std::vector<std::uint64_t> not_canonical;  // those of them that are not under the perturbation
  std::vector<std::size_t> unused;           // points that are no vertices
  bool oriented = true;                      // all simplices alike
  OwnedLinks links;                          // what is across each facet, −1: nothing
  Stages stages = {};
};

// If it is returned: every simplex has d + 1 different vertices, all of them points, and is not flat;
// no two have the same vertices; no facet is in three of them, and two at a facet are on opposite sides of
// it; and the lists are right. Undecided otherwise, and then nothing is known. Given neighbours and
// weights are not looked at; the balls only if asked for, else nothing is not local, nor a tie.
// Instances: dimensions 2 and 3, std::int32_t and std::int64_t. Requires: threads ≥ 1.
template <std::size_t kDimension, typename Index>
tl::expected<Volume, Undecided> volume(const MeshView<kDimension, Index>& mesh, bool balls,
                                       unsigned threads);

}  // namespace circumspect::fast
