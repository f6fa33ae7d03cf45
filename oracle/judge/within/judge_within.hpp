// Judges a mesh of a domain whose vertices were rounded: the claim is about the domain with its
// cells moved by no more than a given distance. docs/theory/within.md is the definition.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include <tl/expected.hpp>

#include "oracle/judge/domain/judge_domain.hpp"
#include "oracle/judge/within/cells.hpp"
#include "oracle/judge/within/work.hpp"

namespace circumspect::check {

// Why there is no verdict: the distance reaches beyond what tells the cells of the domain apart,
// the images of the cells are not forced, or the kind of the domain is not handled.
struct NotJudged {
  std::string reason;          // whole sentences
  bool is_input_fault = true;  // else: such domains are judged only where the claim holds exactly
};

// What is known of a mesh beside its numbers.
struct KnownBeside {
  using Held = std::function<std::optional<Verdict>(Claim, const Domain&)>;

  KnownBeside(const fast::SimplexFacts* simplex_facts = nullptr, Held held_at_once = {})
      : facts(simplex_facts), held(std::move(held_at_once)) {}

  const fast::SimplexFacts* facts;
  Held held;  // the verdict that a claim about a domain holds, if that is seen at once; or null
};

// The verdict on the claim for the domain moved by no more than the square root of
// `squared_distance`, exactly; Verdict::within says by how much it is moved. If there is no such
// move, the verdict says which cells have no image. A mesh for which the claim holds as it stands
// is moved by 0.
// `flat`: where polygons of the domain are joined that are not in one plane (nearly_coplanar.hpp),
// the domain they were joined from; the claim as it stands is about that one.
// `markers`: which triangles of the mesh are to be the image of a polygon, where there is a choice.
// `work`: how much may be done before the search for such a move is given up; none: whatever it
// takes. Requires: as judge_exactly; squared_distance >= 0.
tl::expected<Verdict, NotJudged> judge_within(
    Claim claim, const ExactMesh& mesh, const Domain& domain, const Rational& squared_distance,
    const Options& options = {}, const KnownBeside& known = {}, const Domain* flat = nullptr,
    const Markers& markers = {}, Work* work = nullptr);

}  // namespace circumspect::check
