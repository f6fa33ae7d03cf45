// For tests: what is said of a moved mesh, in few words.
#pragma once

#include <string>

#include <doctest/doctest.h>

#include "oracle/judge/within/judge_within.hpp"
#include "oracle/judge/within/moved_meshes_test.hpp"

namespace circumspect::check {

inline constexpr Claim kTriangulates = Claim::kSteinerTriangulation;

// "holds 4" (moved by 4 bits, its square root rounded down), "fails domain.outside", "not judged".
inline std::string answer(const MovedMesh& moved, Claim claim = kTriangulates,
                          const Rational& distance = 100 * kBit) {
  const auto verdict = judge_within(claim, moved.mesh, moved.domain, distance * distance);
  if (!verdict) return verdict.error().is_input_fault ? "not judged" : "not handled";
  if (!verdict->holds()) {
    std::string text = "fails";
    for (const auto& [rule, tally] : verdict->tallies()) {
      text += " " + std::string(identifier(rule));
    }
    return text;
  }
  int bits = 0;
  while (kBit * (bits + 1) * (kBit * (bits + 1)) <= verdict->within->squared_reach) ++bits;
  return "holds " + std::to_string(bits);
}

// By definition it is the same, and of the mirror image, and numbered from the other end.
inline std::string both_answers(const MovedMesh& moved, const Rational& distance = 100 * kBit) {
  const auto slow = judge_within(kTriangulates, moved.mesh, moved.domain, distance * distance,
                                 {.by = By::kDefinition});
  const std::string quick = answer(moved, kTriangulates, distance);
  if (slow) {
    CHECK(slow->holds() == quick.starts_with("holds"));
  } else {
    CHECK(slow.error().is_input_fault);
    CHECK(quick == "not judged");
  }
  CHECK(answer(mirrored(moved), kTriangulates, distance) == quick);
  CHECK(answer({renumbered(moved.mesh), moved.domain}, kTriangulates, distance) == quick);
  return quick;
}

inline ExactMesh moved_vertex(const ExactMesh& mesh, const Point& at, const Point& by) {
  std::vector<Point> points = mesh.points.points();
  const Vertex v = vertex_at(mesh.points, at);
  REQUIRE(v >= 0);
  points[static_cast<std::size_t>(v)] = at + by;
  return with_points(mesh, points);
}

}  // namespace circumspect::check
