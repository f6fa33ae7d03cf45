// The laws of oracle/judge/fast/predicates.hpp, under their numbers.
#include "oracle/judge/fast/predicates.hpp"

#include <doctest/doctest.h>

#include "oracle/judge/fast/reference_signs_test.hpp"
#include "oracle/judge/fast/tuples_test.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::fast {
namespace {

template <bool kWeighted>
void hold_to_reference(const std::array<Site<2>, 4>& t, Stages& stages) {
  const ReferenceSigns reference = reference_signs(t, kWeighted);
  const Ball<2, kWeighted> ball(t[0], t[1], t[2]);
  const int oriented = reference.orientation({0, 1, 2});
  REQUIRE(orientation(t[0], t[1], t[2], stages) == oriented);
  REQUIRE(ball.orientation(stages) == oriented);
  const int inside = reference.ball({0, 1, 2, 3});
  REQUIRE(ball.contains(t[3], stages) == inside);
  REQUIRE(exact_sign<2, 3>({&t[0], &t[1], &t[2]}, kWeighted, stages) == oriented);
  REQUIRE(exact_sign<2, 4>({&t[0], &t[1], &t[2], &t[3]}, kWeighted, stages) == inside);
  const Lattice lattice = lattice_of<2>(t, kWeighted);
  REQUIRE(orientation(t[0], t[1], t[2], stages, lattice) == oriented);
  REQUIRE(Ball<2, kWeighted>(t[0], t[1], t[2], lattice).orientation(stages) == oriented);
  REQUIRE(Ball<2, kWeighted>(t[0], t[1], t[2], lattice).contains(t[3], stages) == inside);
}

template <bool kWeighted>
void hold_to_reference(const std::array<Site<3>, 5>& t, Stages& stages) {
  const ReferenceSigns reference = reference_signs(t, kWeighted);
  const Ball<3, kWeighted> ball(t[0], t[1], t[2], t[3]);
  const int oriented = reference.orientation({0, 1, 2, 3});
  REQUIRE(orientation(t[0], t[1], t[2], t[3], stages) == oriented);
  REQUIRE(ball.orientation(stages) == oriented);
  const int inside = reference.ball({0, 1, 2, 3, 4});
  REQUIRE(ball.contains(t[4], stages) == inside);
  REQUIRE(exact_sign<3, 4>({&t[0], &t[1], &t[2], &t[3]}, kWeighted, stages) == oriented);
  REQUIRE(exact_sign<3, 5>({&t[0], &t[1], &t[2], &t[3], &t[4]}, kWeighted, stages) == inside);
  const Lattice lattice = lattice_of<3>(t, kWeighted);
  REQUIRE(orientation(t[0], t[1], t[2], t[3], stages, lattice) == oriented);
  REQUIRE(Ball<3, kWeighted>(t[0], t[1], t[2], t[3], lattice).orientation(stages) == oriented);
  REQUIRE(Ball<3, kWeighted>(t[0], t[1], t[2], t[3], lattice).contains(t[4], stages) == inside);
}

TEST_CASE("F1: on tuples of every kind the signs are those of the reference") {
  Stages all;
  for (int kind = 0; kind <= static_cast<int>(Kind::kLast); ++kind) {
    CAPTURE(kind);
    Tuples tuples(static_cast<std::uint64_t>(kind));
    for (int i = 0; i < 1000 / properties::kOneInputIn; ++i) {
      CAPTURE(i);
      const auto plane = tuples.draw<2, 4>(static_cast<Kind>(kind));
      hold_to_reference<false>(plane, all);
      hold_to_reference<true>(plane, all);
      const auto space = tuples.draw<3, 5>(static_cast<Kind>(kind));
      hold_to_reference<false>(space, all);
      hold_to_reference<true>(space, all);
    }
  }
  CHECK(all.filtered > 0);
  CHECK(all.narrow > 0);
  CHECK(all.fixed > 0);
  CHECK(all.wide > 0);
  CHECK(all.unbounded > 0);
}

// The stage that decides a test of the unit square or cube's circumball, whose corners are scaled, and
// one of which is moved.
Stages stage_of(double scale, double moved) {
  Stages stages;
  const Site<3> a{{0, 0, 0}}, b{{0, scale, 0}}, c{{scale, 0, 0}}, d{{0, 0, scale}};
  const Site<3> query{{scale + moved, scale, scale}};
  CHECK(Ball<3>(a, b, c, d).orientation(stages) == Ball<3>(b, c, a, d).orientation(stages));
  stages = {};
  const int sign = Ball<3>(a, b, c, d).contains(query, stages);
  CHECK(sign == (moved > 0 ? -1 : moved < 0 ? 1 : 0) * orientation(a, b, c, d, stages));
  return stages;
}

TEST_CASE("F4: each call adds one to the cheapest stage that can decide") {
  CHECK(stage_of(1, 0.5) == Stages{.filtered = 2});
  CHECK(stage_of(1, 0) == Stages{.filtered = 1, .narrow = 1});
  CHECK(stage_of(0x1p185, 0) == Stages{.filtered = 1, .narrow = 1});
  CHECK(stage_of(0x1p195, 0) == Stages{.narrow = 2});          // above the filter's scale
  CHECK(stage_of(0x1p-195, 0x1p-195) == Stages{.narrow = 2});  // below it
  CHECK(stage_of(1, 0x1p-50) == Stages{.filtered = 1, .fixed = 1});
  CHECK(stage_of(1 - 0x1p-50, 0) == Stages{.filtered = 1, .fixed = 1});
  CHECK(stage_of(0x1p1000, 0) == Stages{.wide = 2});
  CHECK(stage_of(0x1p-1074, 0x1p-1074) == Stages{.wide = 2});
}

TEST_CASE("F6: on a lattice, up to 512 units apart, doubles decide zeros") {
  for (const double reach : {512.0, 513.0}) {
    for (const double unit : {1.0, 0x1p-199, 0x1p180}) {
      Stages stages;
      const double far = reach * unit;
      const std::array<Site<3>, 5> cube = {
          {{{far, 0, 0}}, {{0, far, 0}}, {{0, 0, far}}, {{unit, unit, unit}}, {{far, far, far}}}};
      const Lattice lattice = lattice_of<3>(cube, false);
      CHECK(lattice.unit == unit);
      const Site<3> origin{{0, 0, 0}};
      CHECK(Ball<3>(cube[0], cube[1], cube[2], cube[4], lattice).contains(origin, stages) == 0);
      CHECK(stages == (reach == 512 ? Stages{.filtered = 1} : Stages{.narrow = 1}));
    }
  }
  const std::array<Site<2>, 2> weighted = {{{{4, 8}, 0.125}, {{0, 4}, 8}}};
  CHECK(lattice_of<2>(weighted, false).unit == 4);
  CHECK(lattice_of<2>(weighted, true).unit == 0.25);  // its square divides both weights
  CHECK(lattice_of<2>(std::array<Site<2>, 1>{{{{1, 0x1p-201}}}}, false).unit == 0);
}

TEST_CASE("F1: a column of zeros is a certain zero") {
  Stages stages;
  const Site<3> a{{7, 0, 0}}, b{{7, 1e300, 0}}, c{{7, 0, 1}}, d{{7, 1e-300, 2}}, q{{7, 5, 5}};
  CHECK(orientation(a, b, c, d, stages) == 0);
  CHECK(Ball<3>(a, b, c, d).contains(q, stages) == 0);
  CHECK(stages == Stages{.filtered = 2});
  CHECK(Ball<3>(a, b, c, d).contains({{8, 5, 5}}, stages) != 0);
}

TEST_CASE("F1: a weight far from the others in size decides") {
  Stages stages;
  const Site<2> a{{0, 0}}, b{{2, 0}}, c{{0, 2}};
  const Ball<2, true> circle(a, b, c);
  CHECK(circle.contains({{2, 2}, 0}, stages) == 0);
  for (const double weight : {1.0, 1e-300, 1e300, 0x1p-1074}) {
    CHECK(circle.contains({{2, 2}, weight}, stages) == 1);
    CHECK(circle.contains({{2, 2}, -weight}, stages) == -1);
  }
}

}  // namespace
}  // namespace circumspect::fast
