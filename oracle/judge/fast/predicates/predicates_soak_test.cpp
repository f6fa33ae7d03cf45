// Law F1 of oracle/judge/fast/predicates/predicates.hpp on a million tuples of every family of
// inputs and every kind of hard tuple, in the plane and in space.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>

#include <doctest/doctest.h>

#include "inputs/families.hpp"
#include "inputs/in_doubles.hpp"
#include "kernel/complex/circumball.hpp"
#include "oracle/judge/fast/predicates/predicates.hpp"
#include "oracle/judge/fast/predicates/tuples_test.hpp"

namespace circumspect::fast {
namespace {

// CIRCUMSPECT_TUPLES=10000, a hundredth of the tuples, takes seconds.
int tuples_each() {
  const char* const given = std::getenv("CIRCUMSPECT_TUPLES");
  return given == nullptr ? 1000000 : std::atoi(given);
}

int test_orientation(const std::vector<Site<2>>& sites, const Vertices& t,
                     const Ball<2, true>& ball, Stages& stages) {
  const int sign = orientation(sites[t[0]], sites[t[1]], sites[t[2]], stages);
  REQUIRE(ball.orientation(stages) == sign);
  return sign;
}
int test_orientation(const std::vector<Site<3>>& sites, const Vertices& t,
                     const Ball<3, true>& ball, Stages& stages) {
  const int sign = orientation(sites[t[0]], sites[t[1]], sites[t[2]], sites[t[3]], stages);
  REQUIRE(ball.orientation(stages) == sign);
  return sign;
}

template <bool kWeighted>
Ball<2, kWeighted> ball_of(const std::vector<Site<2>>& sites, const Vertices& t, Lattice lattice) {
  return {sites[t[0]], sites[t[1]], sites[t[2]], lattice};
}
template <bool kWeighted>
Ball<3, kWeighted> ball_of(const std::vector<Site<3>>& sites, const Vertices& t, Lattice lattice) {
  return {sites[t[0]], sites[t[1]], sites[t[2]], sites[t[3]], lattice};
}

// `count` tuples of the sites, which the reference scales to integers once.
template <std::size_t kDimension>
void hold_to_reference(const std::vector<Site<kDimension>>& sites, int count, std::uint64_t seed,
                       Stages& stages) {
  const ReferenceSigns plain = reference_signs(sites, false);
  const ReferenceSigns weighted = reference_signs(sites, true);
  const std::span<const Site<kDimension>> all(sites);
  const Lattice lattice = lattice_of(all, false), weighted_lattice = lattice_of(all, true);
  std::mt19937_64 random(seed);
  for (int i = 0; i < count; ++i) {
    Vertices t;
    while (t.size() < kDimension + 2) {
      t.push_back(static_cast<std::ptrdiff_t>(random() % sites.size()));
    }
    CAPTURE(i);
    const auto heavy = ball_of<true>(sites, t, weighted_lattice);
    const auto light = ball_of<false>(sites, t, random() % 2 == 0 ? Lattice{} : lattice);
    const Vertices simplex(t.begin(), t.end() - 1);
    REQUIRE(test_orientation(sites, t, heavy, stages) == plain.orientation(simplex));
    REQUIRE(light.contains(sites[t.back()], stages) == plain.ball(t));
    REQUIRE(heavy.contains(sites[t.back()], stages) == weighted.ball(t));
  }
}

void print(const std::string& what, std::size_t dimension, const Stages& stages) {
  std::cout << what << " in dimension " << dimension << ": filtered " << stages.filtered
            << ", narrow " << stages.narrow << ", fixed " << stages.fixed << ", wide "
            << stages.wide << ", unbounded " << stages.unbounded << std::endl;
}

template <std::size_t kDimension>
void hold_family(const generators::Family& family, std::mt19937_64& weights) {
  if (!family.exists_in(kDimension)) return;
  CAPTURE(family.name);
  constexpr int kTuplesOfSet = 1000;
  Stages stages;
  for (int done = 0, seed = 1; done < tuples_each() && seed < 2 * tuples_each(); ++seed) {
    CAPTURE(seed);
    const generators::PointsCase set = generators::in_doubles(
        generators::drawn(family, kDimension, {40, true}, static_cast<std::uint64_t>(seed)));
    if (set.points.size() < kDimension + 2) continue;
    std::vector<Site<kDimension>> sites(set.points.size());
    for (std::size_t v = 0; v < sites.size(); ++v) {
      double squares = 0;
      for (std::size_t axis = 0; axis < kDimension; ++axis) {
        sites[v].at[axis] = set.points[v][axis].get_d();  // exact: it is a double
        squares += sites[v].at[axis] * sites[v].at[axis];
      }
      if (!set.weights.empty()) {
        sites[v].weight = set.weights[v].get_d();
      } else if (std::isfinite(squares) && weights() % 2 == 0) {
        sites[v].weight = squares;
      }
    }
    hold_to_reference(sites, kTuplesOfSet, static_cast<std::uint64_t>(seed), stages);
    done += kTuplesOfSet;
  }
  print(family.name, kDimension, stages);
}

TEST_CASE("F1: on a million tuples of every family the signs are those of the reference") {
  std::mt19937_64 weights(1);
  for (const generators::Family& family : generators::families()) {
    hold_family<2>(family, weights);
    hold_family<3>(family, weights);
  }
  for (const generators::FamilyModifier& modifier : generators::family_modifiers()) {
    hold_family<3>(*generators::find_family("sphere+" + modifier.name), weights);
  }
}

template <std::size_t kDimension>
void hold_kind(int kind) {
  CAPTURE(kind);
  constexpr int kSites = 20, kTuplesOfSet = 500;
  Tuples tuples(static_cast<std::uint64_t>(kind) + 100);
  Stages stages;
  for (int done = 0; done < tuples_each(); done += kTuplesOfSet) {
    CAPTURE(done);
    const auto drawn = tuples.draw<kDimension, kSites>(static_cast<Kind>(kind));
    hold_to_reference(std::vector<Site<kDimension>>(drawn.begin(), drawn.end()), kTuplesOfSet,
                      static_cast<std::uint64_t>(done), stages);
  }
  print("kind " + std::to_string(kind), kDimension, stages);
}

TEST_CASE("F1: on a million tuples of every hard kind the signs are those of the reference") {
  for (int kind = 0; kind <= static_cast<int>(Kind::kLast); ++kind) {
    hold_kind<2>(kind);
    hold_kind<3>(kind);
  }
}

}  // namespace
}  // namespace circumspect::fast
