// Laws of causes, on meshes with any faults: what a cause says is counted anew from the verdict, it
// does not depend on how the mesh is listed, and faults of other kinds change nothing.
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "inputs/dice.hpp"
#include "oracle/judge/cause/planted_faults_test.hpp"
#include "oracle/judge/periodic/judge_periodic.hpp"
#include "oracle/judge/periodic/unfolded.hpp"

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

// Of triangles at one vertex, all around it.
Lists fan(std::size_t count) {
  Lists lists{{{0, 0}}, {}};
  const std::vector<Point> quarter = {{8, 0}, {7, 3}, {6, 5}, {3, 7}};
  for (std::size_t i = 0; i < count; ++i) {
    Point corner = quarter[i % 4];
    for (std::size_t turns = i / 4; turns > 0; --turns) corner = {-corner[1], corner[0]};
    lists.points.push_back(corner);
    lists.simplices.push_back(
        {0, static_cast<Vertex>(i + 1), static_cast<Vertex>((i + 1) % count + 1)});
  }
  return lists;
}

// A mesh in the plane with up to three faults of any kind.
Lists with_any_faults(Dice& dice) {
  const bool is_fan = dice.below(5) == 0;
  Lists lists = is_fan ? fan(16) : grid<2>(4 + dice.below(3));
  for (std::size_t faults = dice.below(4); faults > 0; --faults) {
    const auto vertex = static_cast<Vertex>(dice.below(lists.points.size()));
    switch (dice.below(9)) {
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
      case 7:
        std::swap(lists.simplices.front()[0], lists.simplices.front()[1]);
        break;
      default:  // no simplex has the first point, and one the point behind the last
        if (is_fan) break;
        std::erase_if(lists.simplices, [](const Simplex& s) { return contains(s, 0); });
        any_simplex(dice, lists)[0] = static_cast<Vertex>(lists.points.size());
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

int turn_of(const Lists& lists, const Simplex& t) {
  const std::vector<Point> at = lists.corners(t);
  const Point a = at[1] - at[0], b = at[2] - at[0];
  return sign(Rational(a[0] * b[1] - a[1] * b[0]));
}

// Is it strictly beyond each edge opposite it, for the triangle across?
bool fits(const Lists& lists, Vertex v) {
  for (const Simplex& own : lists.simplices) {
    if (!contains(own, v)) continue;
    for (const Simplex& other : lists.simplices) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Simplex same = with_vertex_replaced(other, i, v);
        if (contains(other, v) || sorted(same) != sorted(own)) continue;
        if (turn_of(lists, same) * turn_of(lists, other) >= 0) return false;
      }
    }
  }
  return true;
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
  if (cause.name == "vertex-out-of-place") CHECK(!fits(lists, v));
}

TEST_CASE("causes: what is said of any faults is counted anew, however the mesh is listed") {
  std::map<std::string, int> seen;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
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
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    CAPTURE(seed);
    Dice dice(seed);
    Lists lists = grid<2>(6);
    const auto v = static_cast<Vertex>(6 * (1 + dice.below(4)) + 1 + dice.below(4));
    lists.at(v)[0] += dice.within(-9L, 9L) / Rational(7);
    lists.at(v)[1] += dice.within(-9L, 9L) / Rational(6);
    for (const Claim claim : {Claim::kTriangulation, Claim::kDelaunay, Claim::kComplex}) {
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

TEST_CASE("causes: points seem to be too few where most numbers behind the last are named") {
  for (const std::size_t named_beyond : {15, 16, 20}) {
    for (std::size_t step = 1; step <= 3; ++step) {
      Lists lists = grid<2>(9);
      for (std::size_t i = 0; i < named_beyond; ++i) {
        lists.simplices[i][0] = static_cast<Vertex>(81 + step * i);
      }
      const bool is_most = named_beyond >= 16 && 2 * named_beyond >= step * (named_beyond - 1);
      CHECK(named(lists, Claim::kComplex).starts_with("points-of-another-mesh") == is_most);
    }
  }
}

TEST_CASE("causes: a mesh that a lattice repeats has none") {
  Mesh square = in_arrays({{{0, 0}}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}});
  const Periodic how{.lattice = {{1, 0}, {0, 1}},
                     .offsets = {{0, 0, 1, 0, 1, 1}, {0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 1}}};
  const Mesh mesh = unfolded(square, how);
  const Verdict verdict = judge_periodic(mesh, {});
  CHECK(verdict.tallies().contains(Rule::kDuplicateSimplex));
  CHECK(causes(verdict, mesh, [](const Mesh&) { return std::nullopt; }).found.empty());
}

}  // namespace
}  // namespace circumspect::check
