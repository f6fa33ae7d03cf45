// What is found out of a mesh once, though it is asked about several domains or distances.
#pragma once

#include <optional>

#include "oracle/judge/fast/simplex_facts.hpp"
#include "oracle/judge/fast_view.hpp"
#include "oracle/judge/within/judge_within.hpp"
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

// A mesh with these facts and, where somebody asks for them, its exact numbers: the same for every
// domain of one kind. judge_domain and judge_within take both.
class KnownMesh {
 public:
  // The mesh must outlive this. Requires: no equal points.
  KnownMesh(Claim claim, const Mesh& mesh, DomainKind kind, const Options& options)
      : mesh_(mesh), facts_(facts_of_simplices(claim, mesh, kind, options)) {}

  const Mesh& mesh() const { return mesh_; }
  // Not for several threads at once.
  const ExactMesh& exact() const;
  const OrReason<fast::SimplexFacts>& facts() const { return facts_; }
  const fast::SimplexFacts* known() const { return facts_ ? &*facts_ : nullptr; }

  // The verdict that a claim about a domain holds, if that is seen at once.
  std::optional<Verdict> held(Claim claim, const Domain& domain, const Options& options) const;
  // What is wrong with a mesh that fills a domain but is not Delaunay, if that is seen at once:
  // not_conforming.hpp.
  std::optional<Verdict> not_conforming(const Domain& domain, const Options& options) const;
  // For judge_within. This and the options must outlive it.
  KnownBeside beside(const Options& options) const;

 private:
  // What `ask` says of the view of the simplices, if these are tetrahedra with known facts.
  template <class Ask>
  std::optional<Verdict> asked_of_space(const Ask& ask) const;

  const Mesh& mesh_;
  OrReason<fast::SimplexFacts> facts_;
  mutable std::optional<ExactMesh> exact_ = {};
};

}  // namespace circumspect::check
