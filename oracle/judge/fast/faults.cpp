#include "oracle/judge/fast/faults.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

#include "kernel/exact/each_once.hpp"
#include "oracle/judge/conditions/conditions.hpp"
#include "oracle/judge/fast/boundary_faults.hpp"
#include "oracle/judge/fast/facet_records.hpp"
#include "oracle/judge/fast/list_in_chunks.hpp"
#include "oracle/judge/fast/predicates/predicates.hpp"
#include "oracle/judge/fast/sweep.hpp"

namespace circumspect::fast {
namespace {

template <std::size_t kDimension, typename Index>
class FaultFinder {
 public:
  FaultFinder(const MeshView<kDimension, Index>& mesh, Question question, unsigned threads,
              bool is_whole)
      : mesh_(mesh),
        question_(question),
        threads_(threads),
        is_whole_(is_whole),
        orientations_(mesh.size(), 0) {}

  tl::expected<Faults, Undecided> run(std::optional<SweptMesh> known) {
    if (known && go_on_from(std::move(*known))) return std::move(faults_);
    known.reset();
    faults_ = {};
    orientations_.assign(mesh_.size(), 0);
    if (facets_are_sound()) {
      list_turned();
      if (is_whole_) judge_boundary();
      return std::move(faults_);
    }
    faults_.unused = points_that_are_no_vertices();
    std::vector<std::size_t> all(mesh_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    if (const auto reason = judge_simplices(all)) return tl::unexpected(*reason);
    return std::move(faults_);
  }

 private:
  static constexpr std::size_t kVertices = kDimension + 1;
  using Row = std::span<const Index, kVertices>;
  using Set = std::array<Index, kVertices>;

  template <class Item, class Look>
  std::vector<Item> list_of(std::size_t count, const Look& look) {
    return list_in_chunks<Item>(count, threads_, faults_.stages, look);
  }

  static Set sorted_set(Row row) {
    Set set;
    std::copy(row.begin(), row.end(), set.begin());
    std::sort(set.begin(), set.end());
    return set;
  }

  // Continues from the judge's results, and looks again only at what it doubted; false if that does
  // not explain everything. The proof is in docs/theory/fast.md, "Every place at fault".
  bool go_on_from(SweptMesh known) {
    if (known.swept.undecided) return false;
    faults_.links = std::move(known.links);
    std::vector<std::size_t> doubtful;
    for (const std::size_t first : known.swept.doubtful) {
      for (std::size_t s = first; s < std::min(first + kBlock, mesh_.size()); ++s) {
        doubtful.push_back(s);
      }
    }
    if (known.swept.doubt && !are_linked_back(doubtful, known.swept)) return false;
    if (!known.is_triangulation) {
      for (const std::uint64_t facet : complete(mesh_, faults_.links, threads_)) {
        doubtful.push_back(facet / kVertices);
      }
    }
    take_orientations(known.orientations);
    faults_.unused = std::move(known.unused);
    faults_.stages = known.swept.stages;
    if (known.swept.doubt || !doubtful.empty()) {
      return judge_doubtful(distinct(std::move(doubtful)), known.orientations);
    }
    list_not_local(known.swept);
    list_turned();
    if (!known.is_triangulation) judge_boundary();
    return true;
  }

  // If the links to later simplices lead back and are as many as those to earlier ones, every facet
  // with a link has one partner. The sweep has verified links of simplices that are not doubtful.
  bool are_linked_back(const std::vector<std::size_t>& doubtful, const Swept& swept) const {
    std::uint64_t to_themselves = 0;
    std::vector<std::size_t> partners;
    for (const std::size_t s : doubtful) {
      for (std::size_t place = 0; place < kVertices; ++place) {
        const auto other = beyond(s, place);
        to_themselves += static_cast<std::uint64_t>(other == s);
        if (!other || *other <= s) continue;
        std::size_t back = 0;
        while (back < kVertices &&
               (beyond(*other, back) != s ||
                facet_of(mesh_.row(*other), back) != facet_of(mesh_.row(s), place))) {
          ++back;
        }
        if (back == kVertices) return false;
        partners.push_back(*other * kVertices + back);
      }
    }
    std::sort(partners.begin(), partners.end());
    return std::adjacent_find(partners.begin(), partners.end()) == partners.end() &&
           swept.up + to_themselves == swept.down;
  }

  // False if nothing is wrong with these simplices and their facets, or if the judge assumed a
  // wrong orientation for one of them.
  bool judge_doubtful(const std::vector<std::size_t>& doubtful, const Orientations& swept) {
    if (judge_simplices(doubtful) || faults_.facets_match()) return false;
    return std::all_of(doubtful.begin(), doubtful.end(), [&](std::size_t s) {
      return orientations_[s] == 0 || orientations_[s] == swept.of(s);
    });
  }

  // Matches facets and sweeps as the judge does; true if no simplex and no facet is faulty.
  bool facets_are_sound() {
    // The proposal is complete, because facets with the same vertices have the same hash.
    auto matched = matched_facets(mesh_, threads_);
    if (!matched) return false;
    faults_.links = std::move(*matched);
    if (!faults_.links.overused.empty()) return false;
    WholeSweep<kDimension, Index, std::int32_t> sweep(mesh_, faults_.links.view(), threads_);
    const bool weighted = question_ == Question::kWeightedDelaunay && !mesh_.weights.empty();
    const Swept swept =
        sweep.run({.balls = question_ != Question::kTriangulation, .weighted = weighted});
    if (swept.undecided) return false;
    take_orientations(sweep.orientations());
    faults_.unused = sweep.unused();
    faults_.stages = swept.stages;
    list_not_local(swept);
    return true;
  }

  void take_orientations(const Orientations& orientations) {
    std::size_t s = 0;
    for (std::int8_t& own : orientations_) own = static_cast<std::int8_t>(orientations.of(s++));
  }

  void list_not_local(const Swept& swept) {
    for (const FacetId facet : swept.not_local) {
      const std::size_t other = *beyond(facet.simplex(), facet.place());
      const std::size_t place = across(facet.simplex(), facet.place(), other)->place;
      faults_.not_local.push_back({facet, {other, place}});
    }
  }

  std::vector<std::size_t> points_that_are_no_vertices() {
    UsedPoints used(mesh_.points());
    for (const Index v : mesh_.simplices) {
      if (mesh_.names_point(v)) used.mark(static_cast<std::size_t>(v));
    }
    return used.missing();
  }

  // The degenerate ones among these simplices; afterwards the orientation of each is known.
  std::vector<std::size_t> unsound_among(const std::vector<std::size_t>& simplices) {
    return list_of<std::size_t>(
        simplices.size(), [&](std::size_t i, std::vector<std::size_t>& unsound, Stages& stages) {
          const std::size_t s = simplices[i];
          // A simplex with a vertex twice is flat.
          int sign = 0;
          const auto row = mesh_.row(s);
          if (std::all_of(row.begin(), row.end(), [&](Index v) { return mesh_.names_point(v); })) {
            sign = orientation<kDimension>(mesh_.template sites<false>(s), stages);
          }
          orientations_[s] = static_cast<std::int8_t>(sign);
          if (sign == 0) unsound.push_back(s);
        });
  }

  // Judges these simplices, and their facets if all are sound; all others are in order.
  std::optional<Undecided> judge_simplices(const std::vector<std::size_t>& simplices) {
    faults_.unsound = unsound_among(simplices);
    const auto sound = std::find_if(orientations_.begin(), orientations_.end(),
                                    [](std::int8_t own) { return own != 0; });
    if (sound == orientations_.end()) return Undecided::kFlatSimplex;
    faults_.sound_simplex = static_cast<std::size_t>(sound - orientations_.begin());
    if (!faults_.unsound.empty()) {
      faults_.duplicates = duplicates_among(simplices);
      return std::nullopt;
    }
    if (const auto reason = match_facets(simplices)) return reason;
    if (faults_.duplicates.empty()) list_turned();
    return std::nullopt;
  }

  // The simplices that have the same vertices as another of them, ascending.
  std::vector<std::size_t> duplicates_among(const std::vector<std::size_t>& simplices) const {
    std::vector<std::pair<std::uint64_t, std::size_t>> hashes;
    hashes.reserve(simplices.size());
    for (const std::size_t s : simplices) {
      std::uint64_t hash = 0;
      for (const Index v : mesh_.row(s)) hash += mixed_vertex(static_cast<std::uint64_t>(v));
      hashes.emplace_back(hash, s);
    }
    std::sort(hashes.begin(), hashes.end());
    std::vector<std::size_t> duplicates;
    for (std::size_t i = 0; i < hashes.size(); ++i) {
      // Others with the same hash, most of which have the same vertices.
      for (std::size_t k = i + 1; k < hashes.size() && hashes[k].first == hashes[i].first; ++k) {
        if (sorted_set(mesh_.row(hashes[i].second)) != sorted_set(mesh_.row(hashes[k].second))) {
          continue;
        }
        duplicates.push_back(hashes[i].second);
        duplicates.push_back(hashes[k].second);
        break;
      }
    }
    return distinct(std::move(duplicates));
  }

  static std::vector<std::size_t> distinct(std::vector<std::size_t> list) {
    keep_each_once(list);
    return list;
  }

  void list_turned() {
    const auto positive = std::count(orientations_.begin(), orientations_.end(), 1);
    const int of_most = 2 * positive >= std::ssize(orientations_) ? 1 : -1;
    const auto first = std::find(orientations_.begin(), orientations_.end(), of_most);
    faults_.orientation_of_most = of_most;
    faults_.first_of_most = static_cast<std::size_t>(first - orientations_.begin());
    for (std::size_t s = 0; s < mesh_.size(); ++s) {
      if (orientations_[s] != of_most) faults_.turned.push_back(s);
    }
  }

  // The simplex across a facet: the place of its vertex off the facet, and whether it is on the
  // opposite side; nothing if it lacks the facet, or has the same vertices.
  struct Across {
    std::size_t place;
    bool opposite;
  };
  std::optional<Across> across(std::size_t s, std::size_t place, std::size_t beyond) const {
    std::array<Index, kVertices> own, other;
    own[0] = mesh_.row(s)[place];
    for (std::size_t k = 0; k < kDimension; ++k) {
      own[k + 1] = mesh_.row(s)[kFacetPlaces<kVertices>[place][k]];
    }
    std::copy_n(mesh_.row(beyond).begin(), kVertices, other.begin());
    const Fit<Index> fit = fit_of<kVertices, Index>(own, other);
    if (fit.matches == 0) return std::nullopt;
    const bool alike = orientations_[s] == orientations_[beyond];
    return Across{static_cast<std::size_t>(fit.place), alike == (fit.odd != 0)};
  }

  std::optional<std::size_t> beyond(std::size_t s, std::size_t place) const {
    const std::int32_t link = faults_.links.links[s * kVertices + place];
    if (link < 0) return std::nullopt;
    return static_cast<std::size_t>(link);
  }

  // `simplices`: all simplices whose links to later ones may be wrong, ascending.
  std::optional<Undecided> match_facets(const std::vector<std::size_t>& simplices) {
    if (faults_.links.count == 0) return Undecided::kTooLarge;
    std::vector<std::size_t> doubtful;  // simplices that may be listed twice
    for (const std::vector<std::uint64_t>& facets : faults_.links.overused) {
      std::vector<FacetId>& group = faults_.overused.emplace_back();
      for (const std::uint64_t facet : facets) {
        group.emplace_back(facet / kVertices, facet % kVertices);
        doubtful.push_back(facet / kVertices);
      }
    }
    struct Suspect {
      FacetPair pair;
      bool matches;
    };
    const auto suspects = list_of<Suspect>(
        simplices.size(), [&](std::size_t i, std::vector<Suspect>& found, Stages&) {
          const std::size_t s = simplices[i];
          for (std::size_t place = 0; place < kVertices; ++place) {
            const auto other = beyond(s, place);
            if (!other || *other <= s) continue;
            const auto next = across(s, place, *other);
            const auto are_on_same_side = [&] { return !next->opposite; };
            if (next && conditions::at_facet(2, are_on_same_side) == conditions::AtFacet::kGood) {
              continue;
            }
            found.push_back({{{s, place}, {*other, next ? next->place : 0}}, next.has_value()});
          }
        });
    for (const Suspect& suspect : suspects) {
      const std::size_t s = suspect.pair.first.simplex(), t = suspect.pair.second.simplex();
      doubtful.insert(doubtful.end(), {s, t});
      if (suspect.matches) {
        faults_.same_side.push_back(suspect.pair);
      } else if (sorted_set(mesh_.row(s)) != sorted_set(mesh_.row(t))) {
        return Undecided::kUnmatchedNeighbor;  // their hashes are equal by accident
      }
    }
    // Two simplices with the same vertices share all their facets.
    faults_.duplicates = duplicates_among(distinct(std::move(doubtful)));
    return std::nullopt;
  }

  void judge_boundary() {
    std::vector<FacetId> boundary;
    for (std::size_t s = 0; s < mesh_.size(); ++s) {
      for (std::size_t place = 0; place < kVertices; ++place) {
        if (!beyond(s, place)) boundary.emplace_back(s, place);
      }
    }
    BoundaryFaults<kDimension, Index>(mesh_, orientations_, threads_, faults_).judge(boundary);
  }

  const MeshView<kDimension, Index>& mesh_;
  Question question_;
  unsigned threads_;
  bool is_whole_;
  std::vector<std::int8_t> orientations_;  // 0: the simplex is not sound
  Faults faults_;
};

}  // namespace

template <std::size_t kDimension, typename Index>
tl::expected<Faults, Undecided> faults(const MeshView<kDimension, Index>& mesh, Question question,
                                       unsigned threads, std::optional<SweptMesh> swept) {
  return FaultFinder<kDimension, Index>(mesh, question, threads, true).run(std::move(swept));
}

template <std::size_t kDimension, typename Index>
tl::expected<Faults, Undecided> faults_of_part(const MeshView<kDimension, Index>& part,
                                               Question question, unsigned threads) {
  return FaultFinder<kDimension, Index>(part, question, threads, false).run({});
}

template tl::expected<Faults, Undecided> faults(const MeshView<2, std::int32_t>&, Question,
                                                unsigned, std::optional<SweptMesh>);
template tl::expected<Faults, Undecided> faults(const MeshView<2, std::int64_t>&, Question,
                                                unsigned, std::optional<SweptMesh>);
template tl::expected<Faults, Undecided> faults(const MeshView<3, std::int32_t>&, Question,
                                                unsigned, std::optional<SweptMesh>);
template tl::expected<Faults, Undecided> faults(const MeshView<3, std::int64_t>&, Question,
                                                unsigned, std::optional<SweptMesh>);
template tl::expected<Faults, Undecided> faults_of_part(const MeshView<2, std::int32_t>&, Question,
                                                        unsigned);
template tl::expected<Faults, Undecided> faults_of_part(const MeshView<3, std::int32_t>&, Question,
                                                        unsigned);

}  // namespace circumspect::fast
