// Law F1 of oracle/judge/fast/predicates/predicates.hpp on a million tuples of every family of
// inputs and every kind of hard tuple, in the plane and in space.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <map>
#include <random>
#include <string>

#include <doctest/doctest.h>

#include "inputs/families.hpp"
#include "inputs/in_doubles.hpp"
#include "kernel/complex/circumball.hpp"
#include "oracle/judge/fast/predicates/predicates.hpp"
#include "oracle/judge/fast/predicates/tuples_test.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::fast {
namespace {

constexpr int kTuplesOfSet = 1000;

// So many sets of every family and kind. CIRCUMSPECT_TUPLES=10000, a hundredth of the tuples,
// takes seconds.
int sets_each() {
  const char* const given = std::getenv("CIRCUMSPECT_TUPLES");
  return (given == nullptr ? 1'000'000 : std::atoi(given)) / kTuplesOfSet;
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

// One set of a family; nothing if it has too few points.
template <std::size_t kDimension>
void hold_family(const generators::Family& family, std::uint64_t seed, Stages& stages) {
  if (!family.exists_in(kDimension)) return;
  CAPTURE(family.name);
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const generators::PointsCase set =
      generators::in_doubles(generators::drawn(family, kDimension, {40, true}, seed));
  if (set.points.size() < kDimension + 2) return;
  std::vector<Site<kDimension>> sites(set.points.size());
  for (std::size_t v = 0; v < sites.size(); ++v) {
    double squares = 0;
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      sites[v].at[axis] = set.points[v][axis].get_d();  // exact: it is a double
      squares += sites[v].at[axis] * sites[v].at[axis];
    }
    if (!set.weights.empty()) {
      sites[v].weight = set.weights[v].get_d();
    } else if (std::isfinite(squares) && random() % 2 == 0) {
      sites[v].weight = squares;
    }
  }
  hold_to_reference(sites, kTuplesOfSet, seed, stages);
}

TEST_CASE("F1: on a million tuples of every family the signs are those of the reference") {
  std::map<std::string, Stages> plane, space;
  properties::try_seeds(1, sets_each(), [&](std::uint64_t seed) {
    for (const generators::Family& family : generators::families()) {
      hold_family<2>(family, seed, plane[family.name]);
      hold_family<3>(family, seed, space[family.name]);
    }
    for (const generators::FamilyModifier& modifier : generators::family_modifiers()) {
      const std::string name = "sphere+" + modifier.name;
      hold_family<3>(*generators::find_family(name), seed, space[name]);
    }
  });
  for (const auto& [name, stages] : plane) print(name, 2, stages);
  for (const auto& [name, stages] : space) print(name, 3, stages);
}

template <std::size_t kDimension>
void hold_kind(int kind, std::uint64_t seed, Stages& stages) {
  CAPTURE(kind);
  CAPTURE(seed);
  constexpr int kSites = 20;
  const auto drawn = Tuples(seed + static_cast<std::uint64_t>(kind) * 1'000'000)
                         .draw<kDimension, kSites>(static_cast<Kind>(kind));
  hold_to_reference(std::vector<Site<kDimension>>(drawn.begin(), drawn.end()), kTuplesOfSet, seed,
                    stages);
}

TEST_CASE("F1: on a million tuples of every hard kind the signs are those of the reference") {
  constexpr int kKinds = static_cast<int>(Kind::kLast) + 1;
  std::array<Stages, kKinds> plane, space;
  properties::try_seeds(100, sets_each(), [&](std::uint64_t seed) {
    for (int kind = 0; kind < kKinds; ++kind) {
      hold_kind<2>(kind, seed, plane[static_cast<std::size_t>(kind)]);
      hold_kind<3>(kind, seed, space[static_cast<std::size_t>(kind)]);
    }
  });
  for (int kind = 0; kind < kKinds; ++kind) {
    print("kind " + std::to_string(kind), 2, plane[static_cast<std::size_t>(kind)]);
    print("kind " + std::to_string(kind), 3, space[static_cast<std::size_t>(kind)]);
  }
}

}  // namespace
}  // namespace circumspect::fast
