// Lists all faults of a mesh that is spread over several ranks, by the stages of fast::faults.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "oracle/distributed/conditions.hpp"
#include "oracle/distributed/gathered.hpp"
#include "oracle/distributed/local_mesh.hpp"
#include "oracle/distributed/own_part.hpp"
#include "oracle/distributed/ranks.hpp"
#include "oracle/distributed/ridges.hpp"
#include "oracle/distributed/submerged.hpp"
#include "oracle/judge/conditions/conditions.hpp"
#include "oracle/judge/fast/faults.hpp"
#include "oracle/judge/fast_view.hpp"
#include "oracle/judge/ridges_retold.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::distributed {

// The contents of fast::Faults, by the names that ranks give to simplices and facets. The first
// rank has everything, the others nothing.
template <std::size_t kDimension>
struct NamedFaults {
  FacetNames unsound = {}, duplicates = {}, beyond = {}, covering = {};
  std::vector<FacetNames> overused = {}, same_side = {}, not_local = {};
  std::vector<FaultyRidgeName<kDimension>> ridges = {};
  check::FurtherRidges further_ridges = {};
  std::vector<NumberedPoint<kDimension>> unused = {};
  std::vector<FaultyPoint<kDimension>> submerged = {};
  FacetName first = {}, sound = {};  // the first simplex, and the first one that is sound
  // If there are no faults: as in fast::Facts.
  bool unique = true, canonical = true;

  bool hold() const {
    return unsound.empty() && duplicates.empty() && beyond.empty() && covering.empty() &&
           overused.empty() && same_side.empty() && not_local.empty() && ridges.empty() &&
           unused.empty() && submerged.empty();
  }

  // All simplices that are named, and points that no simplex names.
  std::pair<FacetNames, std::vector<NumberedPoint<kDimension>>> named() const {
    FacetNames simplices = {first, sound};
    for (const FacetNames* some : {&unsound, &duplicates, &beyond, &covering}) {
      append(simplices, *some);
    }
    for (const auto* groups : {&overused, &same_side, &not_local}) {
      for (const FacetNames& group : *groups) append(simplices, group);
    }
    for (const auto& ridge : ridges) append(simplices, ridge.facets);
    std::vector<NumberedPoint<kDimension>> points = unused;
    for (const auto& [point, simplex] : submerged) {
      points.push_back(point);
      if (simplex.rank >= 0) simplices.push_back(simplex);
    }
    return {std::move(simplices), std::move(points)};
  }

  // The same faults as named in a part that has all of these simplices and points.
  fast::Faults in_part(const Gathered<kDimension>& part) const {
    const auto simplices = [&](const FacetNames& names) {
      std::vector<std::size_t> list;
      for (const FacetName name : names) list.push_back(part.simplex(name));
      std::sort(list.begin(), list.end());
      return list;
    };
    const auto facets = [&](const FacetNames& names) {
      std::vector<fast::FacetId> list;
      for (const FacetName name : names) list.push_back(part.facet(name));
      std::sort(list.begin(), list.end());
      return list;
    };
    const auto pairs = [&](const std::vector<FacetNames>& groups) {
      std::vector<fast::FacetPair> list;
      for (const FacetNames& group : groups) {
        const auto two = facets(group);
        list.push_back({two[0], two[1]});
      }
      std::sort(list.begin(), list.end(),
                [](const auto& a, const auto& b) { return a.first < b.first; });
      return list;
    };
    fast::Faults faults;
    faults.sound_simplex = part.simplex(sound);
    faults.unsound = simplices(unsound);
    faults.duplicates = simplices(duplicates);
    faults.covering = simplices(covering);
    faults.beyond = facets(beyond);
    for (const auto& point : unused) faults.unused.push_back(part.point(point.index));
    std::sort(faults.unused.begin(), faults.unused.end());
    for (const auto& [point, simplex] : submerged) {
      std::optional<std::size_t> containing;
      if (simplex.rank >= 0) containing = part.simplex(simplex);
      faults.submerged.emplace_back(part.point(point.index), containing);
    }
    std::sort(faults.submerged.begin(), faults.submerged.end());
    for (const FacetNames& group : overused) faults.overused.push_back(facets(group));
    faults.same_side = pairs(same_side);
    faults.not_local = pairs(not_local);
    for (const auto& ridge : ridges) {
      fast::FaultyRidge& faulty = faults.ridges.emplace_back();
      for (const std::int64_t v : ridge.vertices) {
        faulty.vertices.push_back(
            static_cast<std::int64_t>(part.point(static_cast<std::uint64_t>(v))));
      }
      faulty.facets = facets(ridge.facets);
      faulty.kind = ridge.kind;
    }
    return faults;
  }
};

template <std::size_t kDimension>
class FaultSearch {
 public:
  // Of the faulty ridges, `most` will be shown, or all: 0.
  FaultSearch(Ranks& ranks, const LocalMesh<kDimension>& mesh, Claim claim, unsigned threads,
              std::size_t most)
      : ranks_(ranks),
        mesh_(mesh),
        claim_(claim),
        threads_(threads),
        most_(most),
        shared_(ranks, mesh) {}

  // Nothing if no simplex is sound. Called by all ranks. Requires: no two points are equal.
  std::optional<NamedFaults<kDimension>> run() {
    OwnFaults own = own_part().run(check::question_of(claim_), threads_);
    faults_.sound = first_of_all(own.sound);
    if (faults_.sound.rank < 0) return std::nullopt;
    faults_.first = first_of_all(own.first);
    bool goes_on = !take(std::move(own.unsound), faults_.unsound);
    for (const FacetNames& group : equal_simplices(ranks_, mesh_, own.simplices)) {
      append(own.duplicates, group);
    }
    goes_on &= !take(std::move(own.duplicates), faults_.duplicates);
    if (claim_ != Claim::kWeightedDelaunay) {
      std::vector<NumberedPoint<kDimension>> unused;
      for (const std::size_t i : mesh_.unused()) unused.push_back(mesh_.owned_point(i));
      take(std::move(unused), faults_.unused);
    }
    ranks_.end_phase("faults: simplices");
    if (!goes_on) return std::move(faults_);
    judge_facets(own);
    // The parts may have failed by accident, since hashes collided: then all facets meet, and say
    // what else is to be said of a mesh that holds.
    if (ranks_.of_rank(0, faults_.hold())) judge_facets(own_part().all());
    return std::move(faults_);
  }

 private:
  static constexpr std::size_t kVertices = kDimension + 1;

  OwnPart<kDimension> own_part() const { return {ranks_.rank(), mesh_, shared_}; }
  FacetName own_name(std::size_t s) const {
    return {static_cast<std::int32_t>(ranks_.rank()), static_cast<std::uint32_t>(s * kVertices)};
  }

  // Gathers at the first rank what all ranks found; true if there is anything.
  template <class Item>
  bool take(std::vector<Item> own, std::vector<Item>& all) {
    const bool any = ranks_.any(!own.empty());
    all = ranks_.at_first(std::move(own));
    return any;
  }
  bool take(const std::vector<FacetNames>& own, std::vector<FacetNames>& all) {
    const bool any = ranks_.any(!own.empty());
    all = groups_at_first(ranks_, own);
    return any;
  }

  // The first, in the whole list, of the simplices that ranks name; each names one or none.
  FacetName first_of_all(std::size_t own) {
    struct Candidate {
      std::uint64_t place;
      FacetName name;
    };
    Candidate first{std::numeric_limits<std::uint64_t>::max(), {}};
    if (own != OwnFaults::kNone) first = {mesh_.place(own), own_name(own)};
    for (const Candidate& other : ranks_.of_each(first)) {
      if (other.place < first.place) first = other;
    }
    return first.name;
  }

  // All facets meet that several ranks may have, so that one of three simplices is not mistaken for
  // one of two.
  void judge_facets(const OwnFaults& own) {
    const fast::Orientations& orientations = own.orientations;
    const BallQuestions balls{claim_ != Claim::kTriangulation};
    FacetFindings found =
        FacetMeeting<kDimension>(ranks_, mesh_, orientations, balls).run(own.facets);
    append(found.overused, own.overused);
    append(found.same_side, own.same_side);
    append(found.not_local, own.not_local);
    append(found.boundary, own.boundary);
    bool match = !take(found.overused, faults_.overused);
    match &= !take(found.same_side, faults_.same_side);
    ranks_.end_phase("faults: facets");
    if (!match) return;
    take(found.not_local, faults_.not_local);
    const bool is_triangulation = judge_boundary(found.boundary, orientations);
    ranks_.end_phase("faults: boundary");
    if (is_triangulation && claim_ == Claim::kWeightedDelaunay) {
      auto submerged = look_at_unused_points(ranks_, mesh_, orientations, stages_);
      take(std::move(submerged.faulty), faults_.submerged);
      found.unique &= submerged.unique;
      ranks_.end_phase("submerged points");
    }
    faults_.unique = !ranks_.any(!found.unique);
    faults_.canonical = !ranks_.any(!found.canonical);
  }

  bool judge_boundary(const std::vector<std::uint32_t>& boundary,
                      const fast::Orientations& orientations) {
    RidgeMeeting<kDimension> ridges(ranks_, mesh_, boundary, most_, stages_);
    if (take_ridges(ridges.run([this](std::int32_t v) { return shared_.contains(v); }))) {
      return false;
    }
    fast::SamplePoint<kDimension> sample;
    const std::size_t first = faults_.first.facet / kVertices;
    const bool is_own = faults_.first == own_name(first);
    if (is_own) sample = fast::barycentre_of<kDimension>(mesh_.sites(first), first);
    sample = ranks_.of_rank(static_cast<std::size_t>(faults_.first.rank), sample);
    if (take(beyond(ranks_, mesh_, boundary, sample, orientations, stages_), faults_.beyond)) {
      return false;
    }
    FacetNames covering;
    for (std::size_t s = 0; s < mesh_.size(); ++s) {
      if (is_own && s == first) continue;
      if (fast::covers<kDimension>(mesh_.sites(s), orientations.of(s), sample, stages_)) {
        covering.push_back(own_name(s));
      }
    }
    return !take(std::move(covering), faults_.covering);
  }

  bool take_ridges(const FaultyRidges<kDimension>& own) {
    struct Kind {
      std::array<std::int64_t, kDimension - 1> vertices;
      conditions::AtRidge kind;
    };
    std::vector<Kind> kinds;
    std::vector<FacetNames> facets;
    for (const auto& ridge : own.first()) {
      kinds.push_back({ridge.vertices, ridge.kind});
      facets.push_back(ridge.facets);
    }
    kinds = ranks_.at_first(std::move(kinds));
    facets = groups_at_first(ranks_, facets);
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      faults_.ridges.push_back({kinds[i].vertices, std::move(facets[i]), kinds[i].kind});
    }
    using conditions::AtRidge;
    for (const AtRidge kind :
         {AtRidge::kNotClosed, AtRidge::kSecondBeyond, AtRidge::kFirstBeyond, AtRidge::kFolded}) {
      const std::uint64_t further = ranks_.sum(own.further(kind));
      if (further > 0) faults_.further_ridges[kind] = further;
    }
    return ranks_.any(!own.empty());
  }

  Ranks& ranks_;
  const LocalMesh<kDimension>& mesh_;
  Claim claim_;
  unsigned threads_;
  std::size_t most_;
  SharedPoints<kDimension> shared_;
  NamedFaults<kDimension> faults_;
  fast::Stages stages_;
};

}  // namespace circumspect::distributed
