// What is required of the shape of simplices: by polynomials in squared lengths, with doubles that
// know their errors, and by the words of the definitions the same simplices break the same rules,
// and what was measured of them is the same number. Proof: docs/theory/quality.md, "Why it is
// exact".
#include <algorithm>
#include <map>
#include <set>

#include <doctest/doctest.h>

#include "inputs/dice.hpp"
#include "kernel/exact/angle.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/judge/definition/complex.hpp"
#include "oracle/judge/definition/quality.hpp"
#include "oracle/judge/quality/exact_measure.hpp"
#include "oracle/judge/quality/filtered.hpp"
#include "oracle/judge/quality/judge_quality.hpp"
#include "oracle/report/text.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::properties::quality {
namespace {

using circumspect::quality::measured;
using circumspect::quality::violators;
using generators::Dice;

// On a small grid, where much is equal and much is flat; on one that was moved off the numbers of a
// few bits; far from the origin; or with a corner near the flat of the others.
Point drawn_point(Dice& dice, std::size_t space, std::size_t kind) {
  Point point;
  for (std::size_t axis = 0; axis < space; ++axis) {
    const Rational on_grid(dice.within(-3L, 3L));
    switch (kind) {
      case 0:
        point.push_back(on_grid);
        break;
      case 1:
        point.push_back(exact_value(on_grid.get_d() * 0.1 + 0.7));
        break;
      case 2:
        point.push_back(on_grid + 1'000'000'007L);
        break;
      default:
        point.push_back(on_grid + Rational(dice.within(-1L, 1L)) / (1L << 40));
    }
  }
  return point;
}

struct Drawn {
  Mesh mesh;
  std::vector<Point> points;
  std::vector<Simplex> simplices;
  int dimension;
};

Drawn drawn(Dice& dice) {
  const std::size_t space = dice.below(2) + 2;
  const std::size_t dimension = space == 2 ? 2 : std::min<std::size_t>(dice.below(4) + 1, 3);
  const std::size_t kind = dice.below(4);
  Drawn drawn{{}, {}, {}, static_cast<int>(dimension)};
  for (std::size_t i = 0; i < 6; ++i) drawn.points.push_back(drawn_point(dice, space, kind));
  for (std::size_t i = 0; i < 4; ++i) {
    Simplex& simplex = drawn.simplices.emplace_back();
    for (std::size_t j = 0; j <= dimension; ++j) {
      simplex.push_back(static_cast<Vertex>(dice.below(dice.below(20) == 0 ? 8 : 6)));
    }
  }
  drawn.mesh.coordinates = numbers_of(drawn.points, space);
  drawn.mesh.simplices = IndexLists(drawn.simplices);
  return drawn;
}

// A bound that a simplex of the mesh measures exactly, if it is not an angle, or nearly; or any.
Requirement drawn_requirement(Dice& dice, const Drawn& from) {
  const MeasureEntry* of = nullptr;
  do {
    of = &measures()[dice.below(measures().size())];
  } while (!exists_for(of->measure, from.dimension));
  Requirement requirement{of->measure, 0,
                          std::string(of->name) + (of->is_at_least ? " >= " : " <= ") + "drawn"};
  const auto found = measured(of->measure, from.mesh,
                              from.simplices[dice.below(from.simplices.size())], from.dimension);
  const bool is_near = found && dice.below(4) != 0;
  if (of->is_angle) {
    requirement.bound = Rational(dice.within(0L, 1800L)) / 10;
    if (dice.below(2) == 0) requirement.bound = 15 * dice.within(0L, 12L);
    if (is_near) {
      requirement.bound =
          read_number(degrees_to_decimal(found->value), NumberReading::kDecimal).value();
    }
    return requirement;
  }
  requirement.bound = is_near ? found->value : Rational(dice.within(0L, 400L)) / 10;
  if (is_near && dice.below(2) == 0) {
    requirement.bound *= 1 + Rational(dice.within(-1L, 1L)) / (1L << (50 + dice.below(6)));
  }
  return requirement;
}

// The corners of a simplex that is measured; none of one that is set apart.
std::vector<Point> corners_of(const Drawn& from, const Simplex& simplex) {
  std::vector<Point> corners;
  for (const Vertex v : simplex) {
    if (from.mesh.names(v)) corners.push_back(from.mesh.point(v));
  }
  if (corners.size() < simplex.size()) return {};
  return affine_hull(corners).basis.size() < corners.size() ? std::vector<Point>() : corners;
}

TEST_CASE("what is measured by polynomials is what the definition measures") {
  std::size_t compared = 0;
  CHECK(holds("the same number", 10'000, [&] {
    Dice dice(*rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>()));
    const Drawn from = drawn(dice);
    const Simplex& simplex = from.simplices.front();
    const std::vector<Point> corners = corners_of(from, simplex);
    for (const MeasureEntry& one : measures()) {
      if (!exists_for(one.measure, from.dimension)) continue;
      const auto found = measured(one.measure, from.mesh, simplex, from.dimension);
      RC_ASSERT(found.has_value() == !corners.empty());
      if (!found) continue;
      RC_ASSERT(found->value == *definition::measured(one.measure, corners));
      ++compared;
    }
  }));
  CHECK(occurs(compared, 10'000));
}

using Facets = std::vector<Simplex>;

bool have_common(const Simplex& a, const Simplex& b) {
  return std::any_of(a.begin(), a.end(), [&](Vertex v) { return contains(b, v); });
}

// Do two facets meet in a ridge at an angle of less than so many degrees?
bool meet_sharply(const Drawn& from, const Simplex& a, const Simplex& b, const Rational& degrees) {
  std::vector<Point> ridge, apices;
  for (const Vertex v : a) (contains(b, v) ? ridge : apices).push_back(from.mesh.point(v));
  for (const Vertex v : b) {
    if (!contains(a, v)) apices.push_back(from.mesh.point(v));
  }
  if (ridge.empty() || apices.size() != 2) return false;
  return compare_angle(definition::signed_square_at(ridge, apices[0], apices[1]), degrees) < 0;
}

// How many simplices have a vertex of each of two facets that only one simplex has, and that meet
// at less than so many degrees.
std::size_t touch_both_sides(const Drawn& from, const Rational& degrees) {
  std::vector<Simplex> sound;
  for (const Simplex& simplex : from.simplices) {
    if (!corners_of(from, simplex).empty()) sound.push_back(simplex);
  }
  const Facets boundary = definition::open_facets(sound);
  const auto touches = [&](const Simplex& simplex) {
    for (const Simplex& a : boundary) {
      for (const Simplex& b : boundary) {
        if (have_common(simplex, a) && have_common(simplex, b) &&
            meet_sharply(from, a, b, degrees)) {
          return true;
        }
      }
    }
    return false;
  };
  return static_cast<std::size_t>(
      std::count_if(from.simplices.begin(), from.simplices.end(), touches));
}

QualityDemands drawn_demands(Dice& dice, const Drawn& from) {
  QualityDemands demands;
  for (std::size_t count = 1 + dice.below(3); count > 0; --count) {
    demands.requirements.push_back(drawn_requirement(dice, from));
  }
  if (dice.below(2) == 0) demands.except_sharp = Rational(dice.within(1L, 180L));
  return demands;
}

TEST_CASE("quality: by lemma and by definition the same is said of every mesh") {
  std::map<Rule, std::size_t> broken;
  std::size_t held = 0, set_aside = 0;
  CHECK(holds("by lemma as by definition", 10'000, [&] {
    Dice dice(*rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>()));
    const Drawn from = drawn(dice);
    const QualityDemands demands = drawn_demands(dice, from);
    const auto judged = [&](check::By by) {
      Verdict verdict(Claim::kComplex, 0);
      check::judge_quality(from.mesh, nullptr, 0, {.by = by, .quality = demands, .threads = 1},
                           verdict);
      return verdict;
    };
    const Verdict by_lemma = judged(check::By::kLemma);
    const auto text = [&](const Verdict& verdict) {
      return report::explanation(verdict, from.mesh) +
             report::verdict_line(verdict, from.mesh, "m");
    };
    RC_ASSERT(text(by_lemma) == text(judged(check::By::kDefinition)));
    if (demands.except_sharp) {
      RC_ASSERT(by_lemma.quality->set_aside == touch_both_sides(from, *demands.except_sharp));
    }
    held += by_lemma.holds() ? 1 : 0;
    set_aside += by_lemma.quality->set_aside;
    for (const auto& [rule, tally] : by_lemma.tallies()) ++broken[rule];
  }));
  CHECK(occurs(held, 1000));
  CHECK(occurs(set_aside, 1000));
  for (const MeasureEntry& one : measures()) {
    CAPTURE(one.name);
    CHECK(occurs(broken[one.rule], 20));
  }
}

// Simplices are looked at in chunks of some thousands, by threads.
TEST_CASE("of simplices that are listed a thousand times over the same is said a thousand times") {
  constexpr std::size_t kTimes = 3000;
  try_seeds(0, 8, [&](std::uint64_t seed) {
    CAPTURE(seed);
    Dice dice(seed);
    const Drawn once = drawn(dice);
    const Requirement requirement = drawn_requirement(dice, once);
    const std::vector<std::size_t> expected =
        definition::not_keeping(requirement, once.points, once.simplices);
    std::vector<Simplex> often;
    for (std::size_t i = 0; i < kTimes; ++i) {
      often.insert(often.end(), once.simplices.begin(), once.simplices.end());
    }
    Mesh mesh;
    mesh.coordinates = numbers_of(once.points, once.points.front().size());
    mesh.simplices = IndexLists(often);
    const std::vector<std::size_t> found = violators(mesh, {requirement}, 2).front();
    REQUIRE(found.size() == kTimes * expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      REQUIRE(found[i] ==
              once.simplices.size() * (i / expected.size()) + expected[i % expected.size()]);
    }
  });
}

}  // namespace
}  // namespace circumspect::properties::quality
