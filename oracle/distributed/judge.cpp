#include "oracle/distributed/judge.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>
#include <memory_resource>
#include <stdexcept>
#include <utility>
#include <vector>

#include "oracle/distributed/faults.hpp"
#include "oracle/distributed/gathered.hpp"
#include "oracle/distributed/ridges.hpp"
#include "oracle/distributed/submerged.hpp"
#include "oracle/judge/fast/facet_matching.hpp"
#include "oracle/judge/fast/judge.hpp"
#include "oracle/judge/judge.hpp"
#include "oracle/judge/verdict_of_faults.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::distributed {
namespace {

template <std::size_t kDimension>
class DistributedJudge {
 public:
  DistributedJudge(Ranks& ranks, Claim claim, LocalMesh<kDimension> mesh,
                   const check::Options& options)
      : ranks_(ranks),
        claim_(claim),
        mesh_(std::move(mesh)),
        options_(options),
        threads_(std::max(1U, options.threads)) {}

  Judged run() {
    Judged judged;
    if (mesh_.dealt().simplices > 0 && judge_by_parts(judged)) return judged;
    judged.equal = equal_points(ranks_, mesh_);
    ranks_.end_phase("equal points");
    if (judged.equal.count > 0) return judged;
    if (mesh_.dealt().simplices > 0 && judge_by_faults(judged)) return judged;
    judge_gathered(judged);
    return judged;
  }

 private:
  static constexpr std::size_t kVertices = kDimension + 1;
  static constexpr std::size_t kElsewhere = std::numeric_limits<std::size_t>::max();
  using Names = std::vector<FacetName>;
  using Sample = fast::SamplePoint<kDimension>;

  bool asks_balls() const { return claim_ != Claim::kTriangulation; }
  bool all_are_vertices() const { return claim_ != Claim::kWeightedDelaunay; }
  std::int32_t own_rank() const { return static_cast<std::int32_t>(ranks_.rank()); }
  FacetName own_name(std::size_t s, std::size_t place = 0) const {
    return {own_rank(), static_cast<std::uint32_t>(s * kVertices + place)};
  }

  // Does what the sweep of a whole mesh does, on the parts; false if a condition is not met.
  struct Swept {
    fast::Orientations orientations{1};
    std::pmr::vector<std::uint32_t> open = {};  // facets with nothing across them at this rank
    std::vector<FacetNames> not_local = {};
    bool unique = true, canonical = true;
    double unit = std::numeric_limits<double>::max();  // of the lattice
  };

  bool judge_by_parts(Judged& judged) {
    Sample sample;
    Swept swept;
    const bool fails = !sweep_part(sample, swept);
    ranks_.end_phase("own simplices");
    if (ranks_.any(fails)) return false;
    // Positive doubles are in the order of their bits.
    const auto unit = std::bit_cast<double>(ranks_.least(std::bit_cast<std::uint64_t>(swept.unit)));
    const BallQuestions balls{asks_balls(), {unit}};
    const std::pmr::vector<std::uint32_t> open = std::move(swept.open);
    FacetFindings found =
        FacetMeeting<kDimension>(ranks_, mesh_, swept.orientations, balls).run(open);
    ranks_.end_phase("facets between ranks");
    if (ranks_.any(!found.match())) return false;
    if (ranks_.any(
            !beyond(ranks_, mesh_, found.boundary, sample, swept.orientations, stages_).empty()))
      return false;
    RidgeMeeting<kDimension> ridges(ranks_, mesh_, found.boundary, 1, stages_);
    if (ranks_.any(!ridges.run([](std::int32_t) { return true; }).empty())) return false;
    ranks_.end_phase("boundary");
    append(found.not_local, swept.not_local);
    if (ranks_.any(!mesh_.unused().empty())) {
      if (all_are_vertices() || ranks_.any(!found.not_local.empty())) return false;
      judged.equal = equal_points(ranks_, mesh_);
      if (judged.equal.count > 0) return true;
      const auto submerged = look_at_unused_points(ranks_, mesh_, swept.orientations, stages_);
      ranks_.end_phase("submerged points");
      if (ranks_.any(!submerged.faulty.empty())) return false;
      found.unique &= submerged.unique;
    }
    const bool unique = !ranks_.any(!swept.unique || !found.unique);
    const bool canonical = !ranks_.any(!swept.canonical || !found.canonical);
    conclude(unique, canonical, found.not_local, judged);
    return true;
  }

  // For a mesh that is a triangulation.
  void conclude(bool unique, bool canonical, const std::vector<FacetNames>& own_not_local,
                Judged& judged) {
    const std::vector<FacetNames> not_local = groups_at_first(ranks_, own_not_local);
    judged.holds = !ranks_.any(!not_local.empty());
    fast::Facts facts{.unique = unique, .canonical = canonical};
    if (judged.holds) {
      if (!ranks_.is_first()) return;
      settle(verdict_that_holds(unique, canonical), {}, judged);
      return;
    }
    Names wanted;
    for (const FacetNames& pair : not_local) append(wanted, pair);
    const Gathered<kDimension> part(ranks_, mesh_, std::move(wanted), {});
    ranks_.end_phase("gathering faults");
    if (!ranks_.is_first()) return;
    for (const FacetNames& pair : not_local) {
      facts.not_local.push_back(std::min(part.facet(pair[0]), part.facet(pair[1])));
    }
    settle(verdict_of_facts(claim_, part.view(), facts, options_), part.named(), judged);
  }

  Verdict verdict_that_holds(bool unique, bool canonical) const {
    const fast::MeshView<kDimension, std::int64_t> nothing;
    const fast::Facts facts{.unique = unique, .canonical = canonical};
    return verdict_of_facts(claim_, nothing, facts, options_);
  }

  void settle(Verdict verdict, Mesh named, Judged& judged) const {
    verdict.points = mesh_.dealt().points;
    verdict.simplices = mesh_.dealt().simplices;
    judged.verdict = std::move(verdict);
    judged.named = std::move(named);
  }

  bool sweep_part(Sample& sample, Swept& result) {
    const auto view = mesh_.view();
    bool is_sound = mesh_.names_points_alone();
    const std::size_t with_sample = ranks_.first_with(is_sound && view.size() > 0);
    if (with_sample == ranks_.size()) return false;
    if (with_sample == ranks_.rank()) {
      const auto found = fast::sample_point(view, stages_);
      is_sound = found.has_value();
      if (is_sound) sample = *found;
    }
    sample = ranks_.of_rank(with_sample, sample);
    if (with_sample != ranks_.rank()) sample.simplex = kElsewhere;
    if (!is_sound) return false;
    return view.size() == 0 || sweep_simplices(view, sample, result);
  }

  bool sweep_simplices(const fast::MeshView<kDimension, std::int32_t>& view, const Sample& sample,
                       Swept& result) {
    const auto links = fast::matched_facets(view, threads_, fast::Proposal::kLikely);
    if (!links || !links->overused.empty()) return false;
    fast::WholeSweep<kDimension, std::int32_t, std::int32_t> sweep(view, links->view(), threads_);
    const fast::Swept swept =
        sweep.run({.sample = &sample, .balls = asks_balls(), .weighted = mesh_.is_weighted()});
    if (swept.undecided) return false;
    result.orientations = sweep.orientations();
    result.unique = swept.unique;
    result.canonical = swept.canonical;
    result.unit = sweep.lattice().unit;
    constexpr std::size_t kSome = std::size_t{1} << 12;
    for (std::size_t first = 0; first < view.size(); first += kSome) {
      for (const fast::FacetId facet : sweep.boundary().template facets<kVertices>(
               links->view(), first, std::min(first + kSome, view.size()))) {
        result.open.push_back(own_name(facet.simplex(), facet.place()).facet);
      }
    }
    for (const fast::FacetId facet : swept.not_local) {
      const auto across =
          static_cast<std::size_t>(links->links[facet.simplex() * kVertices + facet.place()]);
      const auto row = view.row(facet.simplex()), other = view.row(across);
      const auto apex = std::find_if(other.begin(), other.end(), [&](std::int32_t v) {
        return std::find(row.begin(), row.end(), v) == row.end();
      });
      result.not_local.push_back(
          {own_name(facet.simplex(), facet.place()),
           own_name(across, static_cast<std::size_t>(apex - other.begin()))});
    }
    return true;
  }

  // At the first rank, the exact checkers look at the faults. False if no simplex is sound.
  bool judge_by_faults(Judged& judged) {
    FaultSearch<kDimension> search(ranks_, mesh_, claim_, threads_, options_.max_violations);
    const auto found = search.run();
    if (!found) return false;
    judged.holds = found->hold();
    const auto [wanted, further] = found->named();
    const Gathered<kDimension> part(ranks_, mesh_, wanted, further);
    ranks_.end_phase("gathering faults");
    judged.holds = ranks_.of_rank(0, judged.holds);
    if (!ranks_.is_first()) return true;
    if (judged.holds) {
      settle(verdict_that_holds(found->unique, found->canonical), {}, judged);
      return true;
    }
    const auto verdict = verdict_of_faults(claim_, part.view(), nullptr, found->in_part(part),
                                           options_, found->further_ridges);
    if (!verdict) throw std::logic_error("the ranks found faults, and the checkers none");
    settle(*verdict, part.named(), judged);
    return true;
  }

  void judge_gathered(Judged& judged) {
    Names own;
    for (std::size_t s = 0; s < mesh_.size(); ++s) own.push_back(own_name(s));
    std::vector<NumberedPoint<kDimension>> points;
    for (std::size_t i = 0; i < mesh_.owned(); ++i) points.push_back(mesh_.owned_point(i));
    Names all = ranks_.at_first(std::move(own));
    points = ranks_.at_first(std::move(points));
    const Gathered<kDimension> whole(ranks_, mesh_, std::move(all), points);
    ranks_.end_phase("gathering all");
    if (ranks_.is_first()) {
      Mesh mesh = whole.named();
      Verdict verdict = check::judge(claim_, mesh, nullptr, options_).value();
      judged.holds = verdict.holds();
      judged.verdict = std::move(verdict);
      judged.named = std::move(mesh);
    }
    judged.holds = ranks_.of_rank(0, judged.holds);
  }

  Ranks& ranks_;
  Claim claim_;
  LocalMesh<kDimension> mesh_;
  const check::Options& options_;
  unsigned threads_;
  fast::Stages stages_;
};

}  // namespace

std::string fault_of_equal_points(const EqualPoints& equal, Vertex first_index,
                                  std::string_view to_merge) {
  const auto own = [&](std::uint64_t v) {
    return index_of_place(static_cast<Vertex>(v), first_index);
  };
  return report::fault_of_equal_points(own(equal.kept), own(equal.again), equal.count, to_merge);
}

Judged judge(Ranks& ranks, Claim claim, Dealt dealt, const check::Options& options) {
  assert(claim == Claim::kTriangulation || claim == Claim::kDelaunay ||
         claim == Claim::kWeightedDelaunay);
  const bool weighted = claim == Claim::kWeightedDelaunay && ranks.any(!dealt.weights.empty());
  const std::size_t dimension = dealt.dimension;
  assert(dimension == 2 || dimension == 3);
  if (dimension == 2) {
    LocalMesh<2> mesh(ranks, std::move(dealt), weighted);
    return DistributedJudge<2>(ranks, claim, std::move(mesh), options).run();
  }
  LocalMesh<3> mesh(ranks, std::move(dealt), weighted);
  return DistributedJudge<3>(ranks, claim, std::move(mesh), options).run();
}

}  // namespace circumspect::distributed
