// Meshes with planted faults, and what is said of their causes.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "oracle/judge/cause/causes.hpp"
#include "oracle/judge/fast/grid_mesh_test.hpp"
#include "oracle/judge/judge.hpp"
#include "oracle/model/listed_mesh_test.hpp"

namespace circumspect::check {

// A mesh that may be changed.
struct Lists {
  std::vector<Point> points;
  std::vector<Simplex> simplices;

  std::size_t dimension() const { return points.front().size(); }
  Point& at(Vertex v) { return points[static_cast<std::size_t>(v)]; }
  std::vector<Point> corners(const Simplex& simplex) const {
    std::vector<Point> corners;
    for (const Vertex v : simplex) corners.push_back(points[static_cast<std::size_t>(v)]);
    return corners;
  }
};

// A Delaunay mesh of `side` points along each axis, with a simplex in the middle last.
template <std::size_t kDimension>
Lists grid(std::size_t side) {
  const auto arrays = fast::grid_mesh<kDimension>(side);
  Lists lists;
  for (std::size_t i = 0; i < arrays.coordinates.size(); ++i) {
    if (i % kDimension == 0) lists.points.emplace_back();
    lists.points.back().push_back(static_cast<long>(arrays.coordinates[i]));
  }
  for (std::size_t i = 0; i < arrays.simplices.size(); ++i) {
    if (i % (kDimension + 1) == 0) lists.simplices.emplace_back();
    lists.simplices.back().push_back(arrays.simplices[i]);
  }
  const auto half = lists.simplices.begin() + std::ssize(lists.simplices) / 2;
  std::rotate(half, half + 1, lists.simplices.end());
  return lists;
}

inline Mesh in_arrays(const Lists& lists) { return listed_mesh(lists.points, lists.simplices); }

// Whether the claim holds if one does as a cause says; nothing if it says nothing about that.
inline std::optional<bool> holds_as_advised(const Cause& cause, Claim claim, Lists lists,
                                            Options options) {
  const bool is_of_copies = cause.name == "listed-twice";
  if (!is_of_copies && claim != Claim::kComplex) return std::nullopt;
  std::set<Simplex> listed;
  if (is_of_copies) {
    std::erase_if(lists.simplices,
                  [&](const Simplex& s) { return !listed.insert(sorted(s)).second; });
  }
  Mesh mesh = in_arrays(lists);
  if (cause.name == "equal-points") {
    merge_equal_points(mesh);
  } else if (cause.name == "hanging-vertices") {
    options.complex.allow_hanging = true;
  } else if (cause.name == "unused-points") {
    options.complex.allow_unused = true;
  } else if (!is_of_copies) {
    return std::nullopt;
  }
  const auto verdict = judge(claim, mesh, nullptr, options);
  return verdict && verdict->holds();
}

// "indices seem to begin at 1, not at 0": so read, as many violations are left as it says.
inline void check_indices_elsewhere(const Cause& cause, Claim claim, Lists lists,
                                    const Options& options) {
  const auto number_after = [&](const std::string& words) {
    const std::size_t at = cause.words.find(words);
    return at == std::string::npos ? 0 : std::stol(cause.words.substr(at + words.size()));
  };
  for (Simplex& simplex : lists.simplices) {
    for (Vertex& v : simplex) v += number_after("not at ") - number_after("begin at ");
  }
  const auto verdict = judge(claim, in_arrays(lists), nullptr, options);
  REQUIRE(verdict.has_value());
  std::size_t left = 0;
  for (const auto& [rule, tally] : verdict->tallies()) left += tally.count;
  CHECK(static_cast<std::size_t>(number_after("all name points, and ")) == left);
  CHECK(left < cause.of);
}

inline std::vector<Cause> causes_of(const Lists& lists, Claim claim, const Options& options = {}) {
  const Mesh mesh = in_arrays(lists);
  int times = 0;
  const auto judged = [&](const Mesh& one) -> std::optional<Verdict> {
    ++times;
    auto verdict = judge(claim, one, nullptr, options);
    if (!verdict) return std::nullopt;
    return std::move(*verdict);
  };
  const auto verdict = judged(mesh);
  REQUIRE(verdict.has_value());
  Causes said = causes(*verdict, mesh, judged);
  std::vector<Cause> found = std::move(said.found);
  CHECK(times <= 2);  // at most one mended mesh is judged
  const auto is_of_others = [](const Cause& cause) {
    return cause.name == "points-of-another-mesh";
  };
  const bool are_others = std::any_of(found.begin(), found.end(), is_of_others);
  if (claim != Claim::kComplex && verdict->tallies().contains(Rule::kDegenerateSimplex)) {
    CHECK(said.as_complex.has_value() != are_others);
  }
  std::size_t all = 0, of_all = 0;
  for (const auto& [rule, tally] : verdict->tallies()) all += tally.count;
  for (const Cause& cause : found) {
    CHECK(cause.name.find(' ') == std::string::npos);
    CHECK(cause.words.find(' ') != std::string::npos);
    CHECK(0 < cause.explains);
    CHECK(cause.explains <= cause.of);
    CHECK(cause.of_listed == (cause.of < all));
    of_all += cause.explains == all ? 1 : 0;
    const bool says_all = cause.words.find("the claim holds") != std::string::npos;
    if (says_all) CHECK(cause.explains == all);
    if (const auto holds = holds_as_advised(cause, claim, lists, options)) {
      CAPTURE(cause.words);
      const bool lets_pass = cause.words.find("lets them pass)") != std::string::npos;
      CHECK((says_all || lets_pass) == *holds);
    }
    const bool is_about_places = cause.name.find("vert") != std::string::npos ||
                                 cause.name.find("unused") != std::string::npos;
    if (are_others) CHECK(!is_about_places);               // they are a consequence
    CHECK(cause.words.find("~ 0 ") == std::string::npos);  // no place is beside itself
    if (cause.name == "indices-begin-elsewhere")
      check_indices_elsewhere(cause, claim, lists, options);
  }
  CHECK(of_all <= 1);  // what all is wrong has no second cause
  return found;
}

// The same mesh in a mirror, and one and a half times as large; its simplices in the reverse order,
// each with two vertices exchanged, so that it keeps its sign.
inline Lists seen_otherwise(Lists lists) {
  for (Point& point : lists.points) {
    for (Rational& x : point) x *= Rational(3, 2);
    std::swap(point[0], point[1]);
  }
  for (Simplex& simplex : lists.simplices) std::swap(simplex[0], simplex[1]);
  std::reverse(lists.simplices.begin(), lists.simplices.end());
  return lists;
}

// Of all causes, in their order, what they explain of how much.
inline std::string text_of(const std::vector<Cause>& causes) {
  std::string text;
  for (const Cause& cause : causes) {
    text += cause.name + " " + std::to_string(cause.explains) + " of " + std::to_string(cause.of) +
            "\n";
  }
  return text;
}

// Of the cause that explains most. Nothing depends on how the mesh is placed and listed, which is
// seen in the plane, where it takes less time.
inline std::string named(const Lists& lists, Claim claim, const Options& options = {}) {
  const std::vector<Cause> found = causes_of(lists, claim, options);
  if (lists.dimension() == 2) {
    CHECK(text_of(causes_of(seen_otherwise(lists), claim, options)) == text_of(found));
  }
  CHECK(found.size() <= 3);
  CHECK(std::is_sorted(found.begin(), found.end(),
                       [](const Cause& a, const Cause& b) { return a.explains > b.explains; }));
  if (found.empty()) return "none";
  const Cause& first = found.front();
  return first.name + ": " + first.words + (first.explains == first.of ? "" : " in part");
}

// The half beyond the middle has points of its own there, which are moved along the last axis; if
// they are, the first and the last are left.
inline void part(Lists& lists, const Rational& moved) {
  const Rational middle(static_cast<long>(lists.points.back()[0].get_d()) / 2);
  const std::size_t most = lists.points.size() - 1;
  std::map<Vertex, Vertex> own;
  for (Simplex& simplex : lists.simplices) {
    if (barycentre(lists.corners(simplex))[0] < middle) continue;
    for (Vertex& v : simplex) {
      const Rational last = lists.at(v).back();
      const bool is_end = last == 0 || last == lists.points[most].back();
      if (lists.at(v)[0] != middle || (moved != 0 && is_end)) continue;
      const auto [twin, is_new] = own.emplace(v, static_cast<Vertex>(lists.points.size()));
      if (is_new) {
        const Point point = lists.at(v);
        lists.points.push_back(point);
        lists.points.back().back() += moved;
      }
      v = twin->second;
    }
  }
}

// A simplex is cut at the middle of an edge, and those beside it are not.
inline void hang_vertex(Lists& lists, std::size_t place) {
  Simplex& cut = lists.simplices[place];
  lists.points.push_back(barycentre({lists.at(cut[0]), lists.at(cut[1])}));
  Simplex half = cut;
  half[0] = cut[1] = static_cast<Vertex>(lists.points.size()) - 1;
  lists.simplices.push_back(half);
}

}  // namespace circumspect::check
