// For properties: a mesh dealt to ranks in all ways, and what they say of it, and one process.
#pragma once

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "oracle/distributed/judge.hpp"
#include "oracle/distributed/turns.hpp"
#include "oracle/judge/judge.hpp"
#include "oracle/report/text.hpp"
#include "properties/mutations/catalogue.hpp"

namespace circumspect::properties {

enum class Way { kSlices, kRoundRobin, kAlongALine, kAllToOne, kSomeToNone, kEndsApart };

inline Way drawn_way(Dice& dice) { return static_cast<Way>(dice.below(6)); }

// Which rank has which simplices, in which order. The same at all ranks.
inline std::vector<std::vector<std::size_t>> dealt_places(const ArrayMesh& mesh, Way way,
                                                          std::size_t ranks, Dice& dice) {
  std::vector<std::vector<std::size_t>> places(ranks);
  std::vector<std::size_t> order(mesh.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto slices = [&] {
    for (std::size_t r = 0; r < ranks; ++r) {
      const auto [begin, end] = PartOf{r, ranks}.slice(mesh.size());
      places[r].assign(order.begin() + static_cast<std::ptrdiff_t>(begin),
                       order.begin() + static_cast<std::ptrdiff_t>(end));
    }
  };
  switch (way) {
    case Way::kSlices:
      slices();
      break;
    case Way::kRoundRobin:
      for (const std::size_t s : order) places[s % ranks].push_back(s);
      break;
    case Way::kAlongALine: {
      const auto x_of = [&](std::size_t s) {
        const std::int64_t v = mesh.row(s)[0];
        const bool is_point = v >= 0 && v < static_cast<std::int64_t>(mesh.points());
        return is_point ? mesh.coordinates[static_cast<std::size_t>(v) * mesh.dimension] : 0.0;
      };
      std::stable_sort(order.begin(), order.end(),
                       [&](std::size_t a, std::size_t b) { return x_of(a) < x_of(b); });
      slices();
      break;
    }
    case Way::kAllToOne:
      places[dice.below(ranks)] = order;
      break;
    case Way::kSomeToNone: {
      const std::size_t some = 1 + dice.below(ranks);
      for (const std::size_t s : order) places[dice.below(some)].push_back(s);
      for (auto& own : places) shuffle(own, dice);
      shuffle(places, dice);
      break;
    }
    case Way::
        kEndsApart:  // those with whom the first and the last meet are elsewhere, with the sample
      for (const std::size_t s : order) {
        places[s == 0 ? ranks - 1 : s + 1 == mesh.size() ? ranks / 2 : 0].push_back(s);
      }
      break;
  }
  return places;
}

inline distributed::Dealt dealt(const ArrayMesh& mesh, Way way, Dice& dice,
                                const distributed::Ranks& ranks) {
  const std::size_t rank = ranks.rank(), d = mesh.dimension;
  const auto places = dealt_places(mesh, way, ranks.size(), dice);
  distributed::Dealt own;
  own.points = mesh.points();
  own.simplices = mesh.size();
  own.dimension = d;
  const Slice slice = PartOf{rank, ranks.size()}.slice(mesh.points());
  const auto part_of = [&](const std::vector<double>& all, std::size_t columns) {
    const auto at = all.begin() + static_cast<std::ptrdiff_t>(slice.begin * columns);
    return std::pmr::vector<double>(at, at + static_cast<std::ptrdiff_t>(slice.size() * columns));
  };
  own.coordinates = part_of(mesh.coordinates, d);
  if (!mesh.weights.empty()) own.weights = part_of(mesh.weights, 1);
  Rows<std::int64_t> rows(places[rank].size(), mesh.width());
  for (std::size_t i = 0; i < places[rank].size(); ++i) {
    const auto row = mesh.row(places[rank][i]);
    std::copy(row.begin(), row.end(), rows.row(i).begin());
  }
  own.lists = std::move(rows);
  if (way == Way::kSlices) {
    own.first_simplex = PartOf{rank, ranks.size()}.slice(mesh.size()).begin;
  } else {
    own.places.assign(places[rank].begin(), places[rank].end());
  }
  return own;
}

inline std::string text_of(const Verdict& verdict, const Mesh& mesh) {
  return report::explanation(verdict, mesh) + report::verdict_line(verdict, mesh, "mesh");
}

inline std::string said_by_one(Claim claim, const ArrayMesh& arrays,
                               const check::Options& options) {
  Mesh mesh;
  mesh.coordinates = Rows<double>::of(arrays.coordinates, arrays.dimension);
  if (claim == Claim::kWeightedDelaunay && !arrays.weights.empty()) {
    mesh.weights = Rows<double>::of(arrays.weights, 1);
  }
  mesh.simplices = Rows<std::int64_t>::of(arrays.simplices, arrays.width());
  const auto verdict = check::judge(claim, mesh, nullptr, options);
  if (verdict) return text_of(*verdict, mesh);
  const auto& repeated = verdict.error().repeated;
  return "equal " + std::to_string(repeated[0].kept) + " " + std::to_string(repeated[0].again) +
         " of " + std::to_string(repeated.size());
}

// At the first rank; elsewhere whether it holds alone.
inline std::string said_by_all(distributed::Ranks& ranks, Claim claim, distributed::Dealt own,
                               const check::Options& options) {
  const auto judged = distributed::judge(ranks, claim, std::move(own), options);
  const auto& [count, kept, again] = judged.equal;
  if (count > 0) {
    return "equal " + std::to_string(kept) + " " + std::to_string(again) + " of " +
           std::to_string(count);
  }
  if (!ranks.is_first()) return judged.holds ? "holds" : "fails";
  if (judged.verdict->holds() != judged.holds) return "other ranks are told otherwise";
  return text_of(*judged.verdict, judged.named);
}

// What parts of one process say; some are in files while others have their turn.
inline std::string said_in_turns(Claim claim, const ArrayMesh& mesh, Way way, Dice& dice,
                                 const check::Options& options, std::size_t most_parts) {
  const distributed::Turns turns{.parts = 1 + dice.below(most_parts),
                                 .at_once = 1 + dice.below(3),
                                 .room = 1000 + dice.below(20000),
                                 .folder = "/tmp",
                                 .few = 5};
  const Dice before = dice;
  std::string said;
  distributed::in_turns(turns, [&](distributed::Ranks& ranks) {
    Dice same = before;
    std::string own = said_by_all(ranks, claim, dealt(mesh, way, same, ranks), options);
    if (ranks.is_first()) said = std::move(own);
  });
  return said;
}

}  // namespace circumspect::properties
