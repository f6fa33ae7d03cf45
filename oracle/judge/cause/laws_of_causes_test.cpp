// Laws of causes, on meshes with any faults: what a cause says is counted anew from the verdict, it
// does not depend on how the mesh is listed, and faults of other kinds change nothing.
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "inputs/dice.hpp"
#include "oracle/judge/cause/planted_faults_test.hpp"

namespace circumspect::check {
namespace {

using generators::Dice;

Simplex& any_simplex(Dice& dice, Lists& lists) {
  return lists.simplices[dice.below(lists.simplices.size())];
}

bool is_inner_edge(const Lists& lists, Vertex a, Vertex b) {
  const auto has_both = [&](const Simplex& s) { return contains(s, a) && contains(s, b); };
  return std::count_if(lists.simplices.begin(), lists.simplices.end(), has_both) == 2;
}

// Faults that do not touch each other, so many of each kind, and what is said of them.
struct Planted {
  Lists lists = grid<2>(9);
  std::size_t doubled = 0, equal = 0, unused = 0, hanging = 0;

  explicit Planted(Dice& dice) {
    const std::vector<Simplex> good = lists.simplices;
    std::vector<bool> is_taken(lists.points.size(), false);
    std::size_t kinds[] = {dice.below(3), dice.below(3), dice.below(3), dice.below(3)};
    for (std::size_t s = 0; s < good.size(); ++s) {
      const Simplex& simplex = good[s];
      const auto is_free = [&](Vertex v) { return !is_taken[static_cast<std::size_t>(v)]; };
      if (!std::all_of(simplex.begin(), simplex.end(), is_free) || dice.below(2) == 0) continue;
      if (!is_inner_edge(lists, simplex[0], simplex[1])) continue;
      const std::size_t kind = dice.below(3);
      if (kinds[kind] == 0) continue;
      --kinds[kind];
      if (kind == 0) lists.simplices.push_back(simplex);
      if (kind == 1) {
        lists.simplices[s][2] = static_cast<Vertex>(lists.points.size());
        lists.points.push_back(Point(lists.at(simplex[2])));
      }
      if (kind == 2) hang_vertex(lists, s);
      ++(kind == 0 ? doubled : kind == 1 ? equal : hanging);
      for (const Vertex v : simplex) is_taken[static_cast<std::size_t>(v)] = true;
    }
    for (; unused < kinds[3]; ++unused) lists.points.push_back({-1 - Rational(unused), 2});
  }

  std::string expected() const {
    const std::size_t all = doubled + equal + unused + hanging;
    std::vector<Cause> causes;
    const auto add = [&](const char* name, std::size_t count) {
      if (count > 0) causes.push_back({name, "", count, all});
    };
    add("listed-twice", doubled);
    add("equal-points", equal);
    add("unused-points", unused);
    add("hanging-vertices", hanging);
    std::stable_sort(causes.begin(), causes.end(),
                     [](const Cause& a, const Cause& b) { return a.explains > b.explains; });
    if (causes.size() > 3) causes.resize(3);
    return text_of(causes);
  }
};

TEST_CASE("causes: each explains the faults of its kind, whatever others there are") {
  std::map<std::string, int> seen;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    Dice dice(seed);
    const Planted planted(dice);
    const std::string said = text_of(causes_of(planted.lists, Claim::kComplex));
    CHECK(said == planted.expected());
    ++seen[said];
  }
  CHECK(seen.size() > 20);
}

// A mesh in the plane with up to three faults of any kind.
Lists with_any_faults(Dice& dice) {
  Lists lists = grid<2>(4 + dice.below(3));
  for (std::size_t faults = dice.below(4); faults > 0; --faults) {
    const auto vertex = static_cast<Vertex>(dice.below(lists.points.size()));
    switch (dice.below(8)) {
      case 0:
        std::swap(any_simplex(dice, lists), lists.simplices.back());
        lists.simplices.pop_back();
        break;
      case 1:
        lists.simplices.push_back(any_simplex(dice, lists));
        break;
      case 2:
        lists.at(vertex)[0] += dice.within(-5L, 5L) / Rational(3);
        lists.at(vertex)[1] += dice.within(-5L, 5L) / Rational(3) + Rational(1, 97);
        break;
      case 3:
        std::swap(lists.at(vertex), lists.points.front());
        break;
      case 4:
        any_simplex(dice, lists)[dice.below(3)] = vertex;
        break;
      case 5:
        lists.points.push_back({dice.within(-3L, 9L) + Rational(1, 7), Rational(1, 5)});
        break;
      case 6:
        hang_vertex(lists, dice.below(lists.simplices.size()));
        break;
      default:
        std::swap(lists.simplices.front()[0], lists.simplices.front()[1]);
    }
  }
  // Indices from 1: the last one may be far too large.
  if (dice.below(3) == 0) {
    for (Simplex& simplex : lists.simplices) {
      for (Vertex& v : simplex) ++v;
    }
  }
  return lists;
}

bool names(const Witness& witness, Vertex v) {
  const auto has = [v](const Simplex& simplex) { return contains(simplex, v); };
  return has(witness.vertices) || (witness.face && has(*witness.face)) ||
         std::any_of(witness.simplices.begin(), witness.simplices.end(), has);
}

// "all … name vertex 17": they do, and it is not a vertex that most simplices have.
void check_name_of_vertex(const Cause& cause, const Verdict& verdict, const Lists& lists) {
  const std::string words = "name vertex ";
  const auto at = cause.words.find(words);
  if (at == std::string::npos) return;
  const Vertex v = std::stol(cause.words.substr(at + words.size()));
  std::size_t naming = 0;
  for (const auto& [rule, tally] : verdict.tallies()) {
    const auto is_other = [&rule = rule, v](const Violation& violation) {
      return violation.rule == rule && !names(violation.witness, v);
    };
    const auto& all = verdict.violations();
    if (tally.count >= 3 && std::none_of(all.begin(), all.end(), is_other)) naming += tally.count;
  }
  CHECK(cause.explains == naming);
  const auto in_star = std::count_if(lists.simplices.begin(), lists.simplices.end(),
                                     [v](const Simplex& s) { return contains(s, v); });
  CHECK(2 * in_star < std::ssize(lists.simplices));
}

TEST_CASE("causes: what is said of any faults is counted anew, however the mesh is listed") {
  std::map<std::string, int> seen;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    CAPTURE(seed);
    Dice dice(seed);
    const Lists lists = with_any_faults(dice);
    for (const Claim claim : {Claim::kTriangulation, Claim::kDelaunay, Claim::kComplex}) {
      CAPTURE(name(claim));
      const auto verdict = judge(claim, in_arrays(lists), nullptr, {.max_violations = 0});
      if (!verdict) continue;  // equal points
      const std::vector<Cause> found = causes_of(lists, claim, {.max_violations = 0});
      for (const Cause& cause : found) {
        ++seen[cause.name];
        check_name_of_vertex(cause, *verdict, lists);
      }
      CHECK(text_of(found) ==
            text_of(causes_of(seen_otherwise(lists), claim, {.max_violations = 0})));
    }
  }
  for (const char* name : {"listed-twice", "vertex-out-of-place", "hanging-vertices",
                           "missing-simplex", "unused-points", "indices-begin-elsewhere"}) {
    CAPTURE(name);
    CHECK(seen[name] > 0);
  }
}

TEST_CASE("causes: the vertex that was moved is named, and no other one") {
  std::size_t named_it = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    Dice dice(seed);
    Lists lists = grid<2>(6);
    const auto v = static_cast<Vertex>(6 * (1 + dice.below(4)) + 1 + dice.below(4));
    lists.at(v)[0] += dice.within(-9L, 9L) / Rational(4);
    lists.at(v)[1] += dice.within(-9L, 9L) / Rational(5);
    for (const Claim claim : {Claim::kTriangulation, Claim::kComplex}) {
      if (!judge(claim, in_arrays(lists), nullptr, {})) continue;
      for (const Cause& cause : causes_of(lists, claim)) {
        if (cause.name != "vertex-out-of-place") continue;
        ++named_it;
        CHECK(cause.words.find("name vertex " + std::to_string(v) + ",") != std::string::npos);
      }
    }
  }
  CHECK(named_it > 40);
}

}  // namespace
}  // namespace circumspect::check
