// Simplices that are turned over: some of them, all of them, or, where points are those of another
// mesh, about every second one against its neighbours.
#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "oracle/judge/cause/bare_facets.hpp"
#include "oracle/judge/cause/rows.hpp"
#include "oracle/judge/fast/facet_matching.hpp"
#include "oracle/judge/fast_view.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::check {
namespace {

// How a row turns around the facet opposite one of its vertices: +1 if the facet's vertices, in the
// order of the row, ascend after an even permutation, times the sign of the place.
template <std::size_t kVertices, class Index>
int sense_at(std::span<const Index, kVertices> row, std::size_t place) {
  int sense = place % 2 == 0 ? 1 : -1;
  for (std::size_t i = 0; i < kVertices; ++i) {
    for (std::size_t j = i + 1; j < kVertices; ++j) {
      if (i != place && j != place && row[i] > row[j]) sense = -sense;
    }
  }
  return sense;
}

struct Turned {
  std::size_t fewer = 0;   // are turned over against the others of their part
  std::size_t of = 0;      // simplices that are not flat
  std::size_t facets = 0;  // at which one of two is
};

// Goes through each part from simplex to simplex, and compares how they turn with how they would if
// all lay in one sense. Nothing is found where a part has no two sides, like a Möbius strip.
template <std::size_t kDimension, class Index>
class Parts {
 public:
  Parts(const Mesh& mesh, const fast::MeshView<kDimension, Index>& view,
        const fast::OwnedLinks& links)
      : mesh_(mesh), view_(view), links_(links.view()), sense_(view.size(), 0), turn_(sense_) {}

  Turned turned() {
    Turned all;
    for (std::size_t first = 0; first < view_.size(); ++first) {
      if (sense_[first] != 0) continue;
      const auto [fewer, of, facets] = turned_from(first);
      all.fewer += fewer;
      all.of += of;
      all.facets += facets;
    }
    return all;
  }

 private:
  static constexpr std::size_t kVertices = kDimension + 1;

  Turned turned_from(std::size_t first) {
    std::size_t positive = 0, negative = 0, facets = 0;
    bool has_sides = true;
    std::vector<std::size_t> pending = {first};
    sense_[first] = 1;
    while (!pending.empty()) {
      const std::size_t s = pending.back();
      pending.pop_back();
      const auto row = view_.row(s);
      const int turn = orientation_in(mesh_, Simplex(row.begin(), row.end())) * sense_[s];
      positive += turn > 0 ? 1 : 0;
      negative += turn < 0 ? 1 : 0;
      turn_[s] = static_cast<std::int8_t>(turn);
      for (std::size_t place = 0; place < kVertices; ++place) {
        const std::int32_t across = links_[s * kVertices + place];
        if (across < 0) continue;
        const auto other = static_cast<std::size_t>(across);
        const std::size_t back = place_of_apex(row, view_.row(other));
        const bool are_alike = sense_at<kVertices, Index>(row, place) !=
                               sense_at<kVertices, Index>(view_.row(other), back);
        const int sense = are_alike ? sense_[s] : -sense_[s];
        if (sense_[other] == 0) {
          sense_[other] = static_cast<std::int8_t>(sense);
          pending.push_back(other);
        }
        has_sides &= sense_[other] == sense;
        facets += turn * turn_[other] < 0 ? 1 : 0;
      }
    }
    return has_sides ? Turned{std::min(positive, negative), positive + negative, facets} : Turned{};
  }

  // The place of the vertex that the neighbour does not share.
  static std::size_t place_of_apex(std::span<const Index, kVertices> row,
                                   std::span<const Index, kVertices> other) {
    std::size_t place = 0;
    while (place + 1 < kVertices && std::find(row.begin(), row.end(), other[place]) != row.end()) {
      ++place;
    }
    return place;
  }

  const Mesh& mesh_;
  const fast::MeshView<kDimension, Index>& view_;
  std::span<const std::int32_t> links_;
  std::vector<std::int8_t> sense_;  // of the list order, if all lay in one sense; 0: not yet known
  std::vector<std::int8_t> turn_;   // the sign of each that was visited, against its sense
};

Turned turned_against_neighbours(const Mesh& mesh) {
  Turned found;
  look_at_simplices(mesh, [&]<std::size_t kDimension, class Index>(
                              const fast::MeshView<kDimension, Index>& view) {
    const auto links = fast::matched_facets(view, 1);
    if (links && links->overused.empty()) found = Parts(mesh, view, *links).turned();
  });
  return found;
}

}  // namespace

std::optional<Cause> other_points(Case& of) {
  constexpr std::size_t kFewestTurned = 16;
  const std::size_t places =
      of.count(Rule::kOverlap) + of.count(Rule::kDegenerateSimplex) + of.count(Rule::kFacesCross);
  // If simplices are turned over here and there, many facets have both of theirs on one side. Where
  // few places are at fault, no walk through all of the mesh is needed to see that.
  const auto& complex = of.verdict().complex;
  const bool are_counted = of.breaks(Rule::kOverlap) && (!complex || !complex->are_counts_cut);
  if (are_counted && 4 * places < of.mesh().simplices.size()) return std::nullopt;
  const Turned turned = turned_against_neighbours(of.mesh());
  const bool is_folded = 4 * turned.facets < turned.of;
  if (4 * turned.fewer < turned.of || is_folded || turned.of < kFewestTurned) return std::nullopt;
  return of.cause(
      "points-of-another-mesh",
      fmt::format("the points seem to be those of another mesh, or in another order: {} of {} are "
                  "turned over against their neighbours",
                  turned.fewer,
                  report::counted_simplices(turned.of, static_cast<int>(of.mesh().dimension()))),
      places);
}

std::optional<Cause> turned_simplices(Case& of) {
  const std::size_t turned = of.count(Rule::kOrientation) + of.count(Rule::kInverted);
  if (turned == 0) return std::nullopt;
  const Verdict& verdict = of.verdict();
  const std::size_t all = verdict.simplices;
  const int k = verdict.complex ? verdict.complex->dimension : verdict.dimension;
  const std::string simplices = report::counted_simplices(all, k);
  if (of.count(Rule::kInverted) == all && verdict.complex) {
    const bool are_negative = verdict.complex->positive == 0;
    return of.cause(
        "all-inverted",
        fmt::format("{}{} vertices in the other order: --oriented={} holds of {}",
                    all == 1 ? "" : "all ", simplices + (all == 1 ? " lists its" : " list their"),
                    are_negative ? "negative" : "positive", all == 1 ? "it" : "them"),
        turned);
  }
  return of.cause(
      "inverted",
      fmt::format("{} of {} list{} {} vertices in the other order: swap two of them", turned,
                  simplices, turned == 1 ? "s" : "", turned == 1 ? "its" : "their"),
      turned);
}

}  // namespace circumspect::check
