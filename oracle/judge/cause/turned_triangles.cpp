// Triangles in space that are turned over against their neighbours, and surfaces of one side.
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "oracle/judge/cause/rows.hpp"
#include "oracle/judge/cause/surface_edges.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::check {
namespace {

struct Neighbour {
  std::size_t triangle;
  bool is_turned;  // do both go along the common edge in one sense?
};
using Neighbours = std::vector<std::vector<Neighbour>>;  // of each triangle

struct Sides {
  std::size_t turned = 0;  // against the others of their part
  bool are_two = true;
};

// Goes through each part from triangle to triangle.
Sides sides_of(const Neighbours& neighbours) {
  Sides sides;
  std::vector<std::int8_t> sense(neighbours.size(), 0);
  for (std::size_t first = 0; first < neighbours.size(); ++first) {
    if (sense[first] != 0) continue;
    std::size_t alike = 0, turned = 0;
    std::vector<std::size_t> pending = {first};
    sense[first] = 1;
    while (!pending.empty()) {
      const std::size_t t = pending.back();
      pending.pop_back();
      ++(sense[t] > 0 ? alike : turned);
      for (const auto& [other, is_turned] : neighbours[t]) {
        const auto expected = static_cast<std::int8_t>(is_turned ? -sense[t] : sense[t]);
        if (sense[other] == 0) {
          sense[other] = expected;
          pending.push_back(other);
        }
        sides.are_two &= sense[other] == expected;
      }
    }
    sides.turned += std::min(alike, turned);
  }
  return sides;
}

}  // namespace

std::optional<Cause> turned_triangles(Case& of) {
  Neighbours neighbours(of.mesh().simplices.size());
  std::size_t places = 0;
  for_each_edge(edge_uses(of.mesh()), [&](std::span<const EdgeUse> uses) {
    if (uses.size() != 2) return;
    const bool is_turned = uses[0].goes_up == uses[1].goes_up;
    neighbours[uses[0].triangle].push_back({uses[1].triangle, is_turned});
    neighbours[uses[1].triangle].push_back({uses[0].triangle, is_turned});
    places += is_turned ? 1 : 0;
  });
  // The claim does not compare triangles that were set apart, and only it compares simplices of
  // other dimensions. Then the counts differ, and the walk would explain something else.
  if (places != of.count(Rule::kNotOriented)) return std::nullopt;
  const Sides sides = sides_of(neighbours);
  if (!sides.are_two) {
    return of.cause("one-sided",
                    "the surface has one side only, like a Möbius strip: whichever triangles are "
                    "turned over, some do not agree",
                    places);
  }
  const bool is_one = sides.turned == 1;
  return of.cause(
      "turned-over",
      fmt::format("{} of {} {} turned over against {} neighbours: swap two of {} "
                  "vertices",
                  sides.turned, report::counted(neighbours.size(), "triangle"),
                  is_one ? "is" : "are", is_one ? "its" : "their", is_one ? "its" : "their"),
      places);
}

}  // namespace circumspect::check
