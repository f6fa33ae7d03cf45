// The fast predicates against those of the reference, stage by stage.
#include "oracle/judge/fast/predicates/predicates.hpp"

#include <random>
#include <utility>

#include <doctest/doctest.h>

#include "kernel/complex/circumball.hpp"
#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/perturbation.hpp"
#include "oracle/judge/fast/predicates/exact_ball.hpp"
#include "oracle/judge/fast/predicates/exact_sign.hpp"
#include "oracle/judge/fast/predicates/tuples_test.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::fast {

struct ReferenceSigns::Exact {
  Configuration points;
  std::vector<std::size_t> axes;
};

ReferenceSigns::ReferenceSigns(const std::vector<std::vector<double>>& points,
                               const std::vector<double>& weights) {
  std::vector<Point> exact;
  std::vector<Rational> exact_weights;
  for (const auto& point : points) {
    exact.emplace_back();
    for (const double x : point) exact.back().push_back(exact_value(x));
  }
  for (const double weight : weights) exact_weights.push_back(exact_value(weight));
  std::vector<std::size_t> axes;
  for (std::size_t axis = 0; axis < points.front().size(); ++axis) axes.push_back(axis);
  exact_ = std::make_unique<Exact>(Exact{Configuration(exact, exact_weights), axes});
}

ReferenceSigns::~ReferenceSigns() = default;

int ReferenceSigns::orientation(const Vertices& simplex) const {
  return circumspect::orientation(exact_->points, exact_->axes, simplex);
}

int ReferenceSigns::ball(const Vertices& vertices) const {
  for (std::size_t swapped = vertices.size(); swapped-- > 0;) {
    const bool last = swapped + 1 == vertices.size();
    Vertices simplex = vertices;
    std::swap(simplex[swapped], simplex.back());
    const Vertex query = simplex.back();
    simplex.pop_back();
    const int oriented = orientation(simplex);
    if (oriented == 0) continue;
    const int inside = in_ball(exact_->points, exact_->axes, simplex, query);
    return inside * oriented * (last ? 1 : -1);
  }
  return 0;
}

int ReferenceSigns::perturbed_ball(const Vertices& vertices) const {
  const Vertices simplex(vertices.begin(), vertices.end() - 1);
  return perturbed_in_ball(exact_->points, exact_->axes, simplex, vertices.back());
}

namespace {

TEST_CASE(
    "reference signs: swapping two of the vertices negates the ball's, "
    "degenerate or not") {
  const ReferenceSigns signs({{0, 0}, {1, 0}, {2, 0}, {0, 3}, {3, 0}}, {});
  CHECK(signs.orientation({0, 1, 3}) == 1);
  CHECK(signs.ball({0, 1, 3, 2}) == -1);
  CHECK(signs.ball({0, 1, 2, 3}) == 1);
  CHECK(signs.ball({0, 3, 2, 1}) == -signs.ball({0, 1, 2, 3}));
  CHECK(signs.ball({0, 1, 2, 4}) == 0);
}

// The laws of oracle/judge/fast/predicates/predicates.hpp, under their numbers.

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

// The stage that decides a test of the circumball of a unit square or cube whose corners are
// scaled, with one of them moved.
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

template <std::size_t kDimension>
using Tuple = std::array<Site<kDimension>, kDimension + 2>;

// Different points of a grid with `side` points along each axis.
template <std::size_t kDimension>
Tuple<kDimension> grid_tuple(std::mt19937_64& random, std::size_t side) {
  while (true) {
    Tuple<kDimension> sites{};
    bool are_different = true;
    for (std::size_t i = 0; i < sites.size(); ++i) {
      for (double& x : sites[i].at) x = static_cast<double>(random() % side);
      for (std::size_t k = 0; k < i; ++k) are_different &= sites[i].at != sites[k].at;
    }
    if (are_different) return sites;
  }
}

template <std::size_t kDimension>
void hold_zeros() {
  std::mt19937_64 random(kDimension);
  Vertices all;
  for (std::size_t i = 0; i < kDimension + 2; ++i) all.push_back(static_cast<std::ptrdiff_t>(i));
  int zeros = 0, crossings = 0;
  for (int i = 0; i < 20000 / properties::kOneInputIn; ++i) {
    CAPTURE(i);
    const Tuple<kDimension> sites = grid_tuple<kDimension>(random, 3);
    SiteRow<kDimension> row;
    for (std::size_t k = 0; k <= kDimension; ++k) row[k] = sites[k];
    const Site<kDimension>& query = sites.back();
    Stages stages;
    const int own = orientation<kDimension>(row, stages);
    if (own == 0 || ball_of<kDimension, false>(row).contains(query, stages) != 0) continue;
    ++zeros;
    const int expected = reference_signs(sites, false).perturbed_ball(all);
    REQUIRE(perturbed_sign_of_zero<kDimension>(row, own, query, stages) == expected);
    REQUIRE(perturbed_sign_of_zero<kDimension>(row, own, query, stages, {1}) == expected);
    for (std::size_t place = 0; place <= kDimension; ++place) {
      if (orientation_with<kDimension>(row, place, query, stages) * own >= 0) continue;
      ++crossings;
      REQUIRE(perturbed_sign_of_zero<kDimension>(row, own, query, stages, {1}, place) == expected);
    }
  }
  CHECK(zeros > 100 / properties::kOneInputIn);
  CHECK(crossings >= zeros);  // each query is outside
}

TEST_CASE(
    "zeros are perturbed as the reference perturbs them, beyond a known "
    "facet or not") {
  hold_zeros<2>();
  hold_zeros<3>();
}

// Several queries of one simplex get the same answers as single ones, by the same stages.

template <std::size_t kDimension>
void hold_queries(Tuples& tuples, Kind kind, Stages& all) {
  constexpr std::size_t kQueries = 4;
  const auto sites = tuples.draw<kDimension, kDimension + 1 + kQueries>(kind);
  SiteRow<kDimension> row;
  for (std::size_t i = 0; i <= kDimension; ++i) row[i] = sites[i];
  ExactBall<kDimension> ball(row);
  for (std::size_t i = 0; i < kQueries; ++i) {
    CAPTURE(i);
    const Site<kDimension>& query = sites[kDimension + 1 + i];
    Stages one_by_one, together;
    const int expected = exact_ball_sign(row, query, false, one_by_one);
    REQUIRE(ball.contains(query, together) == expected);
    REQUIRE(together == one_by_one);
    all += together;
  }
}

TEST_CASE("queries of one simplex have the signs of exact_sign, by the same stages") {
  Stages all;
  for (int kind = 0; kind <= static_cast<int>(Kind::kLast); ++kind) {
    CAPTURE(kind);
    Tuples tuples(static_cast<std::uint64_t>(kind) + 7);
    for (int i = 0; i < 1000 / properties::kOneInputIn; ++i) {
      CAPTURE(i);
      hold_queries<2>(tuples, static_cast<Kind>(kind), all);
      hold_queries<3>(tuples, static_cast<Kind>(kind), all);
    }
  }
  CHECK(all.narrow > 0);
  CHECK(all.fixed > 0);
  CHECK(all.wide > 0);
  CHECK(all.unbounded > 0);
}

TEST_CASE("a query that is finer than the simplex is not cut off") {
  const SiteRow<3> row = {{{{0, 0, 0}}, {{0, 8, 0}}, {{8, 0, 0}}, {{0, 0, 8}}}};
  ExactBall<3> ball(row);
  Stages stages;
  const int inside = ball.contains({{1, 1, 1}}, stages);
  for (const double off : {1.0, 0x1p-9, 0x1p-20, 0x1p-45}) {
    CHECK(ball.contains({{8, 8, 8 + off}}, stages) == -inside);
    CHECK(ball.contains({{8, 8, 8 - off}}, stages) == inside);
    CHECK(ball.contains({{8, 8, 8}}, stages) == 0);
  }
}

}  // namespace

}  // namespace circumspect::fast
