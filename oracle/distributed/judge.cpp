#include "oracle/distributed/judge.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "oracle/distributed/gathered.hpp"
#include "oracle/distributed/submerged.hpp"
#include "oracle/judge/fast/facet_matching.hpp"
#include "oracle/judge/fast/faults.hpp"
#include "oracle/judge/fast/judge.hpp"
#include "oracle/judge/judge.hpp"
#include "oracle/judge/verdict_of_faults.hpp"

namespace circumspect::distributed {
namespace {

template <class Item>
void append(std::vector<Item>& list, const std::vector<Item>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

// Lists of names, each as long as its first entry says, one after the other; and back.
std::vector<FacetName> in_one_list(const std::vector<FacetNames>& groups) {
  std::vector<FacetName> list;
  for (const FacetNames& group : groups) {
    list.push_back({-1, static_cast<std::uint32_t>(group.size())});
    append(list, group);
  }
  return list;
}
std::vector<FacetNames> in_groups(const std::vector<FacetName>& list) {
  std::vector<FacetNames> groups;
  for (std::size_t i = 0; i < list.size();) {
    const std::size_t end = i + 1 + list[i].facet;
    groups.emplace_back(list.begin() + static_cast<std::ptrdiff_t>(i + 1),
                        list.begin() + static_cast<std::ptrdiff_t>(end));
    i = end;
  }
  return groups;
}

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

  // ── A mesh that holds, or fails by facets that are not locally Delaunay alone ──────────────────

  // What the parts have in common with the sweep of a whole mesh: false if a condition is not met.
  struct Swept {
    fast::Orientations orientations{1};
    std::vector<std::uint32_t> open = {};  // facets with nothing across them at this rank
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
    const std::vector<std::uint32_t> open = std::move(swept.open);
    FacetFindings found = FacetMeeting<kDimension>(ranks_, mesh_, swept.orientations, balls)
                              .run(open.size(), [&open](std::size_t i) { return open[i]; });
    ranks_.end_phase("facets between ranks");
    if (ranks_.any(!found.match())) return false;
    if (ranks_.any(!beyond(found.boundary, sample, swept.orientations).empty())) return false;
    if (ranks_.any(!faulty_ridges(ranks_, mesh_, found.boundary, stages_).empty())) return false;
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
      found.canonical &= submerged.canonical;
    }
    const bool unique = !ranks_.any(!swept.unique || !found.unique);
    const bool canonical = !ranks_.any(!swept.canonical || !found.canonical);
    conclude(unique, canonical, found.not_local, judged);
    return true;
  }

  // Of a mesh that is a triangulation.
  void conclude(bool unique, bool canonical, const std::vector<FacetNames>& own_not_local,
                Judged& judged) {
    const std::vector<FacetNames> not_local =
        in_groups(ranks_.at_first(in_one_list(own_not_local)));
    judged.holds = !ranks_.any(!not_local.empty());
    fast::Facts facts{.unique = unique, .canonical = canonical};
    if (judged.holds) {
      if (!ranks_.is_first()) return;
      const fast::MeshView<kDimension, std::int64_t> nothing;
      settle(verdict_of_facts(claim_, nothing, facts, options_), {}, judged);
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
    std::sort(facts.not_local.begin(), facts.not_local.end());
    settle(verdict_of_facts(claim_, part.view(), facts, options_), part.named(), judged);
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
    if (!links) return false;
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

  // Own boundary facets that do not have the sample point strictly on their inner sides.
  Names beyond(const std::vector<std::uint32_t>& boundary, const Sample& sample,
               const fast::Orientations& orientations) {
    Names names;
    for (const std::uint32_t facet : boundary) {
      const std::size_t s = facet / kVertices;
      const int side = fast::orientation_with(mesh_.sites(s), facet % kVertices, sample, stages_) *
                       orientations.of(s);
      if (side <= 0) names.push_back({own_rank(), facet});
    }
    return names;
  }

  // ── Every place at fault, stage by stage, as fast::faults goes through them ────────────────────

  // What the ranks found, at the first one.
  struct NamedFaults {
    Names unsound = {}, duplicates = {}, beyond = {}, covering = {};
    std::vector<FacetNames> overused = {}, same_side = {}, not_local = {};
    std::vector<FaultyRidgeName<kDimension>> ridges = {};
    std::vector<NumberedPoint<kDimension>> unused = {};
    std::vector<FaultyPoint<kDimension>> submerged = {};
    FacetName first = {}, sound = {};  // the first simplex, and the first one that is sound
  };

  // Who has the simplex with the least place of these own ones (kElsewhere: there is none), and its name.
  FacetName first_of(std::size_t own) {
    struct Candidate {
      std::uint64_t place;
      FacetName name;
    };
    Candidate first{std::numeric_limits<std::uint64_t>::max(), {}};
    if (own != kElsewhere) first = {mesh_.place(own), own_name(own)};
    for (const Candidate& other : ranks_.of_each(first)) {
      if (other.place < first.place) first = other;
    }
    return first.name;
  }
  template <class Has>
  FacetName first_with(const Has& has) {
    std::size_t first = kElsewhere;
    for (std::size_t s = 0; s < mesh_.size(); ++s) {
      if (has(s) && (first == kElsewhere || mesh_.place(s) < mesh_.place(first))) first = s;
    }
    return first_of(first);
  }

  // False if no simplex is sound.
  bool judge_by_faults(Judged& judged) {
    NamedFaults named;
    std::vector<std::int8_t> signs(mesh_.size(), 0);
    std::vector<std::uint64_t> negative((mesh_.size() + 63) / 64, 0);
    Names unsound;
    for (std::size_t s = 0; s < mesh_.size(); ++s) {
      const auto row = mesh_.view().row(s);
      if (std::all_of(row.begin(), row.end(), [](std::int32_t v) { return v >= 0; })) {
        signs[s] = static_cast<std::int8_t>(fast::orientation<kDimension>(mesh_.sites(s), stages_));
      }
      if (signs[s] == 0) unsound.push_back(own_name(s));
      if (signs[s] < 0) negative[s / 64] |= std::uint64_t{1} << (s % 64);
    }
    named.sound = first_with([&](std::size_t s) { return signs[s] != 0; });
    if (named.sound.rank < 0) return false;
    named.first = first_with([](std::size_t) { return true; });
    const bool all_sound = !ranks_.any(!unsound.empty());
    named.unsound = ranks_.at_first(std::move(unsound));
    Names duplicates;
    for (const FacetNames& group : equal_simplices(ranks_, mesh_)) append(duplicates, group);
    const bool all_differ = !ranks_.any(!duplicates.empty());
    named.duplicates = ranks_.at_first(std::move(duplicates));
    if (all_are_vertices()) {
      std::vector<NumberedPoint<kDimension>> unused;
      for (const std::size_t i : mesh_.unused()) unused.push_back(mesh_.owned_point(i));
      named.unused = ranks_.at_first(std::move(unused));
    }
    ranks_.end_phase("faults: simplices");
    bool holds = all_sound && all_differ && !ranks_.any(!named.unused.empty());
    if (all_sound && all_differ) {
      holds &= judge_facets(fast::Orientations(std::move(negative)), named);
    }
    judged.holds = holds;
    tell(named, judged);
    return true;
  }

  bool judge_facets(const fast::Orientations& orientations, NamedFaults& named) {
    const BallQuestions balls{asks_balls()};
    FacetFindings found = FacetMeeting<kDimension>(ranks_, mesh_, orientations, balls)
                              .run(mesh_.size() * kVertices,
                                   [](std::size_t i) { return static_cast<std::uint32_t>(i); });
    named.overused = in_groups(ranks_.at_first(in_one_list(found.overused)));
    named.same_side = in_groups(ranks_.at_first(in_one_list(found.same_side)));
    ranks_.end_phase("faults: facets");
    if (ranks_.any(!found.match())) return false;
    named.not_local = in_groups(ranks_.at_first(in_one_list(found.not_local)));
    unique_ = !ranks_.any(!found.unique);
    canonical_ = !ranks_.any(!found.canonical);
    bool holds = judge_boundary(found.boundary, orientations, named);
    ranks_.end_phase("faults: boundary");
    if (holds && !all_are_vertices()) holds = judge_submerged(orientations, named);
    return holds && !ranks_.any(!found.not_local.empty());
  }

  bool judge_submerged(const fast::Orientations& orientations, NamedFaults& named) {
    auto found = look_at_unused_points(ranks_, mesh_, orientations, stages_);
    const bool holds = !ranks_.any(!found.faulty.empty());
    named.submerged = ranks_.at_first(std::move(found.faulty));
    unique_ &= !ranks_.any(!found.unique);
    canonical_ &= !ranks_.any(!found.canonical);
    ranks_.end_phase("submerged points");
    return holds;
  }

  bool judge_boundary(const std::vector<std::uint32_t>& boundary,
                      const fast::Orientations& orientations, NamedFaults& named) {
    auto ridges = faulty_ridges(ranks_, mesh_, boundary, stages_);
    const bool is_closed = !ranks_.any(!ridges.empty());
    named.ridges = ridges_at_first(ridges);
    if (!is_closed) return false;
    Sample sample;
    const bool is_own = named.first.rank == own_rank();
    const std::size_t first = named.first.facet / kVertices;
    if (is_own) sample = fast::barycentre_of<kDimension>(mesh_.sites(first), first);
    sample = ranks_.of_rank(static_cast<std::size_t>(named.first.rank), sample);
    Names beyond_own = beyond(boundary, sample, orientations);
    const bool is_inside = !ranks_.any(!beyond_own.empty());
    named.beyond = ranks_.at_first(std::move(beyond_own));
    if (!is_inside) return false;
    Names covering;
    for (std::size_t s = 0; s < mesh_.size(); ++s) {
      if (is_own && s == first) continue;
      if (fast::covers<kDimension>(mesh_.sites(s), orientations.of(s), sample, stages_)) {
        covering.push_back(own_name(s));
      }
    }
    const bool is_covered_once = !ranks_.any(!covering.empty());
    named.covering = ranks_.at_first(std::move(covering));
    return is_covered_once;
  }

  std::vector<FaultyRidgeName<kDimension>> ridges_at_first(
      const std::vector<FaultyRidgeName<kDimension>>& own) {
    using Vertices = std::array<std::int64_t, kDimension - 1>;
    std::vector<Vertices> vertices;
    std::vector<FacetNames> facets;
    for (const auto& ridge : own) {
      vertices.push_back(ridge.vertices);
      facets.push_back(ridge.facets);
    }
    vertices = ranks_.at_first(std::move(vertices));
    facets = in_groups(ranks_.at_first(in_one_list(facets)));
    std::vector<FaultyRidgeName<kDimension>> all;
    for (std::size_t i = 0; i < vertices.size(); ++i) all.push_back({vertices[i], facets[i]});
    return all;
  }

  // The exact checkers look at the places at the first rank.
  void tell(const NamedFaults& named, Judged& judged) {
    Names wanted = {named.first, named.sound};
    for (const Names* some : {&named.unsound, &named.duplicates, &named.beyond, &named.covering}) {
      append(wanted, *some);
    }
    for (const auto* groups : {&named.overused, &named.same_side, &named.not_local}) {
      for (const FacetNames& group : *groups) append(wanted, group);
    }
    for (const auto& ridge : named.ridges) append(wanted, ridge.facets);
    std::vector<NumberedPoint<kDimension>> further = named.unused;
    for (const auto& [point, simplex] : named.submerged) {
      further.push_back(point);
      if (simplex.rank >= 0) wanted.push_back(simplex);
    }
    const Gathered<kDimension> part(ranks_, mesh_, std::move(wanted), further);
    ranks_.end_phase("gathering faults");
    if (!ranks_.is_first()) return;
    if (judged.holds) {
      fast::MeshView<kDimension, std::int64_t> nothing;
      const fast::Facts facts{.unique = unique_, .canonical = canonical_};
      settle(verdict_of_facts(claim_, nothing, facts, options_), {}, judged);
      return;
    }
    const auto verdict =
        verdict_of_faults(claim_, part.view(), nullptr, in_part(named, part), options_);
    if (!verdict) throw std::logic_error("the ranks found faults, and the checkers none");
    settle(*verdict, part.named(), judged);
  }

  static fast::Faults in_part(const NamedFaults& named, const Gathered<kDimension>& part) {
    fast::Faults faults;
    faults.sound_simplex = part.simplex(named.sound);
    const auto simplices = [&](const Names& names) {
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
    faults.unsound = simplices(named.unsound);
    faults.duplicates = simplices(named.duplicates);
    faults.covering = simplices(named.covering);
    faults.beyond = facets(named.beyond);
    for (const auto& point : named.unused) faults.unused.push_back(part.point(point.index));
    std::sort(faults.unused.begin(), faults.unused.end());
    for (const auto& [point, simplex] : named.submerged) {
      std::optional<std::size_t> containing;
      if (simplex.rank >= 0) containing = part.simplex(simplex);
      faults.submerged.emplace_back(part.point(point.index), containing);
    }
    std::sort(faults.submerged.begin(), faults.submerged.end());
    for (const FacetNames& group : named.overused) faults.overused.push_back(facets(group));
    faults.same_side = pairs(named.same_side);
    faults.not_local = pairs(named.not_local);
    for (const auto& ridge : named.ridges) {
      fast::FaultyRidge& faulty = faults.ridges.emplace_back();
      for (const std::int64_t v : ridge.vertices) {
        faulty.vertices.push_back(
            static_cast<std::int64_t>(part.point(static_cast<std::uint64_t>(v))));
      }
      faulty.facets = facets(ridge.facets);
    }
    return faults;
  }

  // ── Where nothing is sound: every simplex is at fault ──────────────────────────────────────────

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
  bool unique_ = true, canonical_ = true;  // what the complete search found
};

}  // namespace

Judged judge(Ranks& ranks, Claim claim, Dealt dealt, const check::Options& options) {
  assert(claim == Claim::kTriangulation || claim == Claim::kDelaunay ||
         claim == Claim::kWeightedDelaunay);
  const bool weighted = claim == Claim::kWeightedDelaunay && ranks.any(dealt.weights.rows() > 0);
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
