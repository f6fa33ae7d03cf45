// Parts that were meshed apart: equal points, hanging vertices, diagonals that cross, parts that
// lie in each other.
#include <algorithm>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "kernel/exact/number_text.hpp"
#include "oracle/judge/cause/rows.hpp"
#include "oracle/judge/cause/uncut.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::check {
namespace {

bool has_all(const std::set<Vertex>& vertices, const Simplex& face) {
  return std::all_of(face.begin(), face.end(), [&](Vertex v) { return vertices.contains(v); });
}

// Where a rule of the claim `complex` is broken.
class BrokenAt {
 public:
  BrokenAt(const Verdict& alone, Rule rule) {
    for (const Violation& violation : alone.violations()) {
      if (violation.rule != rule) continue;
      const Witness& witness = violation.witness;
      Simplex cells = witness.vertices;
      if (witness.face) cells.insert(cells.end(), witness.face->begin(), witness.face->end());
      vertices_.insert(cells.begin(), cells.end());
      for (const Simplex& simplex : witness.simplices) {
        vertices_.insert(simplex.begin(), simplex.end());
      }
      cells_.push_back(std::move(cells));
    }
  }

  explicit BrokenAt(const std::vector<Uncut>& uncut) {
    for (const Uncut& one : uncut) {
      cells_.push_back(one.face);
      cells_.back().push_back(one.vertex);
      vertices_.insert(cells_.back().begin(), cells_.back().end());
    }
  }

  // A face of the boundary all of whose vertices are there, or two simplices that have the vertex
  // and the face in which it hangs, or both diagonals.
  bool explains(const Witness& witness) const {
    if (witness.face) return !witness.face->empty() && has_all(vertices_, *witness.face);
    std::set<Vertex> named;
    for (const Simplex& simplex : witness.simplices) named.insert(simplex.begin(), simplex.end());
    return std::any_of(cells_.begin(), cells_.end(),
                       [&](const Simplex& cells) { return has_all(named, cells); });
  }

 private:
  std::set<Vertex> vertices_ = {};
  std::vector<Simplex> cells_ = {};
};

// What it explains of a claim that says what is covered, of the violations whose witnesses are
// kept.
Cause of_listed(Case& of, std::string name, std::string words, const BrokenAt& broken) {
  Cause cause{std::move(name), std::move(words), 0, of.verdict().violations().size(), true};
  for (const Violation& violation : of.verdict().violations()) {
    cause.explains += broken.explains(violation.witness) ? 1 : 0;
  }
  if (cause.of == of.violations()) cause.of_listed = false;
  return cause;
}

bool may_be_apart(const Case& of) {
  // Where hundreds overlap, vertices that hang are not the reason.
  constexpr std::size_t kMostOverlaps = 200;
  const std::size_t overlaps = of.count(Rule::kOverlap);
  return (overlaps > 0 && overlaps <= kMostOverlaps) || of.breaks(Rule::kHullNotClosed) ||
         of.breaks(Rule::kHullNotConvex) || of.breaks(Rule::kUncovered) ||
         of.breaks(Rule::kPolygonNotTiled) || of.breaks(Rule::kHangingVertex) ||
         of.breaks(Rule::kFacesCross);
}

}  // namespace

std::optional<Cause> equal_points_of_parts(Case& of) {
  const std::size_t count = of.count(Rule::kPointsEqual);
  if (count == 0) return std::nullopt;
  const bool is_all = count == of.violations();
  return of.cause(
      "equal-points",
      fmt::format("{} {} another one, exactly: with --duplicates merge {}",
                  report::counted(count, "point"), count == 1 ? "equals" : "equal",
                  is_all ? "the claim holds" : "they count as one, and the rest remains"),
      count);
}

std::optional<Cause> hanging_vertices(Case& of) {
  if (!may_be_apart(of)) return std::nullopt;
  const Verdict* const alone = of.as_complex();
  if (alone == nullptr || !alone->tallies().contains(Rule::kHangingVertex)) return std::nullopt;
  const std::size_t count = alone->tallies().at(Rule::kHangingVertex).count;
  const std::string vertices = count == 1 ? "1 vertex lies" : fmt::format("{} vertices lie", count);
  const std::string words =
      alone->complex->only_parts_hang
          ? fmt::format("parts that were meshed apart meet: {} inside faces of another part",
                        vertices)
          : fmt::format("{} inside faces of simplices that are not cut there", vertices);
  const bool is_own = of.verdict().claim() == Claim::kComplex;
  if (!is_own) {
    return of_listed(of, "hanging-vertices", words, BrokenAt(*alone, Rule::kHangingVertex));
  }
  const bool is_all = count == of.violations();
  return of.cause("hanging-vertices",
                  words + (is_all ? " (--allow hanging-vertex lets them pass)" : ""), count);
}

std::optional<Cause> vertices_beside_faces(Case& of) {
  // Where facets are shared by more than two, those of only one tell nothing.
  const bool is_tangled = of.breaks(Rule::kFacetOverused) || of.breaks(Rule::kDuplicateSimplex);
  if (is_tangled || !may_be_apart(of)) return std::nullopt;
  const std::vector<Uncut> uncut = uncut_faces(of.mesh(), of.bare());
  std::set<Vertex> vertices;
  Rational farthest = 0;
  for (const Uncut& one : uncut) {
    vertices.insert(one.vertex);
    farthest = std::max(farthest, one.squared_distance);
  }
  if (farthest == 0) return std::nullopt;  // they are in faces: another row
  const std::string words = fmt::format(
      "{} beside faces of simplices that are not cut there, at most ~ {} from them, as if rounded: "
      "once cut, both sides have the same facets",
      vertices.size() == 1 ? "1 vertex lies" : fmt::format("{} vertices lie", vertices.size()),
      square_root_to_decimal(farthest));
  return of_listed(of, "hanging-vertices-rounded", words, BrokenAt(uncut));
}

std::optional<Cause> crossed_diagonals(Case& of) {
  if (!may_be_apart(of)) return std::nullopt;
  const Verdict* const alone = of.as_complex();
  if (alone == nullptr || alone->complex->crossed_quadrilaterals == 0) return std::nullopt;
  const std::size_t count = alone->complex->crossed_quadrilaterals;
  const std::string words =
      fmt::format("parts that were meshed apart meet in {} with different diagonals",
                  report::counted(count, "quadrilateral"));
  if (of.verdict().claim() != Claim::kComplex) {
    return of_listed(of, "crossed-diagonals", words, BrokenAt(*alone, Rule::kFacesCross));
  }
  return of.cause("crossed-diagonals", words, count);
}

std::optional<Cause> parts_in_each_other(Case& of) {
  if (of.verdict().claim() != Claim::kComplex) return std::nullopt;
  const ComplexFacts& facts = *of.verdict().complex;
  const std::size_t overlaps = of.count(Rule::kOverlap);
  const bool are_all_counted = !facts.are_counts_cut && facts.overlaps_of_parts == overlaps;
  if (!are_all_counted || facts.overlapping_parts == 0) return std::nullopt;
  return of.cause("parts-in-each-other",
                  fmt::format("{} that no facet connects {} each other, and no part overlaps "
                              "itself",
                              facts.overlapping_parts == 1
                                  ? "2 parts"
                                  : report::counted(facts.overlapping_parts, "pair") + " of parts",
                              facts.dimension == 2 ? "pass through" : "overlap"),
                  overlaps);
}

}  // namespace circumspect::check
