// Lists every place where a mesh of doubles breaks a rule, by the stages of the exact checkers
// (ARCHITECTURE.md: "Stages"). The exact checkers look at these places again and name what is
// wrong.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "oracle/judge/conditions/conditions.hpp"
#include "oracle/judge/fast/facet_matching.hpp"
#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/judge/fast/predicates/site.hpp"
#include "oracle/judge/fast/sweep.hpp"
#include "oracle/judge/fast/undecided.hpp"

namespace circumspect::fast {

// A facet of two simplices, as named by each; `first` is the one that comes first in the list.
struct FacetPair {
  FacetId first, second;
};

// A ridge between boundary facets that a convex set cannot have.
struct FaultyRidge {
  std::vector<std::int64_t> vertices = {};  // ascending
  std::vector<FacetId> facets = {};         // all boundary facets that have it
  // What is wrong; which of two facets is beyond the other depends on the order in which they were
  // asked.
  conditions::AtRidge kind = conditions::AtRidge::kNotClosed;
};

// Anything that is not listed is in order. If a stage finds faults, later stages are skipped, and
// their lists are empty; oracle/judge/points/delaunay.cpp has the order of the stages. Lists of
// simplices and points ascend.
struct Faults {
  std::size_t sound_simplex = 0;  // one that is not flat

  // Simplices with an index that names no point, with a repeated vertex, or flat; simplices with
  // the same vertices as another; simplices oriented unlike most, if all are sound; points that are
  // not vertices.
  std::vector<std::size_t> unsound = {};
  std::vector<std::size_t> duplicates = {};
  std::vector<std::size_t> turned = {};
  std::vector<std::size_t> unused = {};
  // If all are sound: the orientation of most (of both alike: 1), and the first simplex that has
  // it.
  int orientation_of_most = 1;
  std::size_t first_of_most = 0;

  // Facets of three and more simplices, and facets of two that are on the same side.
  std::vector<std::vector<FacetId>> overused = {};
  std::vector<FacetPair> same_side = {};

  // Ridges that are not in exactly two boundary facets, or whose two facets make a reflex angle or
  // are folded. If there are none: boundary facets that do not have the barycentre of the first
  // simplex strictly on their inner sides. If there are none of these: other simplices that contain
  // it.
  std::vector<FaultyRidge> ridges = {};
  std::vector<FacetId> beyond = {};
  std::vector<std::size_t> covering = {};

  // Facets that are not locally Delaunay.
  std::vector<FacetPair> not_local = {};

  // Faulty weighted points that are not vertices, ascending, each with the first simplex that
  // contains it, if any. faults() does not look for them.
  std::vector<std::pair<std::size_t, std::optional<std::size_t>>> submerged = {};

  // If facets match: what is across each of them.
  OwnedLinks links = {};
  Stages stages = {};  // what decided the signs

  bool simplices_are_sound() const { return unsound.empty() && duplicates.empty(); }
  bool facets_match() const {
    return simplices_are_sound() && overused.empty() && same_side.empty();
  }
  bool is_triangulation() const {
    return facets_match() && ridges.empty() && beyond.empty() && covering.empty();
  }
};

// The partial results of the judge (judge.hpp) about a mesh for which it gives no answer.
struct SweptMesh {
  OwnedLinks links;  // likely ones
  Swept swept;       // continuing past doubts, with a sample point
  Orientations orientations;
  std::vector<std::size_t> unused;
  bool is_triangulation;  // a triangulation of its vertices: only unused points are wrong
};

// All faults that the question asks for. It does not check whether weighted points that are not
// vertices lie above the lower hull, and ignores given neighbours. Undecided: no simplex is sound;
// more simplices than can be matched; hashes that collide by accident. The same answer for any
// number of threads. Instances: dimensions 2 and 3; std::int32_t and std::int64_t. Requires:
// numbers are finite; no two points are equal; threads ≥ 1; weights, if the question is about them
// and there are any; `swept`, if it is there, is what the judge found for the same question.
template <std::size_t kDimension, typename Index>
tl::expected<Faults, Undecided> faults(const MeshView<kDimension, Index>& mesh, Question question,
                                       unsigned threads, std::optional<SweptMesh> swept = {});

// The same for some simplices of a mesh, whose boundary is none of the mesh: the lists of ridges
// and of what concerns the sample point stay empty.
template <std::size_t kDimension, typename Index>
tl::expected<Faults, Undecided> faults_of_part(const MeshView<kDimension, Index>& part,
                                               Question question, unsigned threads);

}  // namespace circumspect::fast
