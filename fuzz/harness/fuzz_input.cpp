// The bytes of a fuzzer as a recipe for points. Five bytes a step, the rest is ignored:
//
//   kind a b c w      kind modulo 8 makes a point, perhaps from earlier ones (modulo their number)
//   0  small          the integer point (a, b, c), each from −8 to 7
//   1  integer        the same, each from −128 to 127
//   2  round          a point of the sphere of radius 9 (circle of radius 65) around the origin: a
//                     chooses one with integer coordinates, b the order and signs of them
//   3  neighbour      an earlier point a, coordinate b one unit in the last place up or down (c)
//   4  parallelogram  p_a + p_b − p_c: coplanar with them, and on their sphere if a rectangle
//   5  scaled         p_a times 2^e, e from b: near or far by many orders of magnitude
//   6  moved          p_a, coordinate b moved by 2^c: beside coordinates that keep few bits for it
//   7  mirrored       p_a with some of the signs (b) changed: on one sphere with it
//
// w is the weight, an eighth of a signed byte. A point that is there already, or not finite, is
// left out.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include <circumspect/fuzz.hpp>
#include <fmt/format.h>

#include "fuzz/harness/answer.hpp"
#include "fuzz/harness/cases.hpp"
#include "inputs/cases.hpp"
#include "inputs/dice.hpp"
#include "kernel/exact/point.hpp"
#include "oracle/report/text.hpp"

namespace circumspect {

namespace {

constexpr std::size_t kStep = 5;
constexpr std::size_t kMostPoints = 64;

using Place = std::array<double, 3>;

double signed_byte(std::uint8_t byte) { return static_cast<std::int8_t>(byte); }
double small_integer(std::uint8_t byte) { return (byte & 15) - 8; }

// Integer points at distance 9 from the origin of space, 65 from that of the plane, up to order and
// sign.
constexpr std::array<Place, 4> kOnSphere = {{{0, 0, 9}, {1, 4, 8}, {4, 4, 7}, {3, 6, 6}}};
constexpr std::array<Place, 5> kOnCircle = {
    {{0, 65, 0}, {16, 63, 0}, {25, 60, 0}, {33, 56, 0}, {39, 52, 0}}};

Place with_signs(Place place, std::uint8_t signs) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if ((signs >> axis) & 1) place[axis] = -place[axis];
  }
  return place;
}

Place round_point(std::uint8_t which, std::uint8_t how, std::size_t dimension) {
  Place place =
      dimension == 2 ? kOnCircle[which % kOnCircle.size()] : kOnSphere[which % kOnSphere.size()];
  std::rotate(place.begin(), place.begin() + (how >> 4) % static_cast<int>(dimension),
              place.begin() + static_cast<std::ptrdiff_t>(dimension));
  if ((how >> 3) & 1) std::swap(place[0], place[1]);
  return with_signs(place, how);
}

class Recipe {
 public:
  explicit Recipe(std::size_t dimension) : dimension_(dimension) {}

  void follow(const std::uint8_t* step) {
    Place place = made(step[0] % 8, step[1], step[2], step[3]);
    if (dimension_ == 2) place[2] = 0;
    for (double& x : place) {
      if (!std::isfinite(x)) return;
      x += 0.0;  // no −0, which would look like another point to some programs
    }
    if (std::find(places_.begin(), places_.end(), place) != places_.end()) return;
    places_.push_back(place);
    weights_.push_back(signed_byte(step[4]) / 8);
  }

  bool is_full() const { return places_.size() == kMostPoints; }

  PointArray points(bool weighted) const {
    PointArray points{dimension_, {}, {}};
    for (const Place& place : places_) {
      points.coordinates.insert(points.coordinates.end(), place.begin(),
                                place.begin() + static_cast<std::ptrdiff_t>(dimension_));
    }
    if (weighted) points.weights = weights_;
    return points;
  }

 private:
  Place earlier(std::uint8_t which) const {
    return places_.empty() ? Place{} : places_[which % places_.size()];
  }

  Place made(int kind, std::uint8_t a, std::uint8_t b, std::uint8_t c) const {
    Place place = earlier(a);
    const std::size_t axis = b % dimension_;
    switch (kind) {
      case 0:
        return {small_integer(a), small_integer(b), small_integer(c)};
      case 1:
        return {signed_byte(a), signed_byte(b), signed_byte(c)};
      case 2:
        return round_point(a, b, dimension_);
      case 3:
        place[axis] = std::nextafter(place[axis], c % 2 == 0 ? HUGE_VAL : -HUGE_VAL);
        return place;
      case 4:
        for (std::size_t i = 0; i < 3; ++i) place[i] += earlier(b)[i] - earlier(c)[i];
        return place;
      case 5:
        for (double& x : place) x = std::ldexp(x, static_cast<std::int8_t>(b));
        return place;
      case 6:
        place[axis] += std::ldexp(1.0, static_cast<std::int8_t>(c) / 2);
        return place;
      default:
        return with_signs(place, b);
    }
  }

  std::size_t dimension_;
  std::vector<Place> places_ = {};
  std::vector<double> weights_ = {};
};

using generators::Dice;

using RecipeStep = std::array<std::uint8_t, kStep>;

std::uint8_t random_byte(Dice& dice) { return static_cast<std::uint8_t>(dice.below(256)); }

RecipeStep random_step(Dice& dice) {
  RecipeStep step{};
  for (std::uint8_t& byte : step) byte = random_byte(dice);
  // Chosen so that degeneracies are more frequent than by chance.
  if (dice.below(2) == 0) step[0] = std::array<std::uint8_t, 4>{0, 2, 4, 7}[dice.below(4)];
  return step;
}

void mutate_once(std::vector<RecipeStep>& steps, std::size_t most, Dice& dice) {
  const std::size_t at = steps.empty() ? 0 : dice.below(steps.size());
  const auto place = steps.begin() + static_cast<std::ptrdiff_t>(at);
  const bool has_room = steps.size() < most;
  switch (steps.empty() ? 0 : dice.below(6)) {
    case 0:
      if (has_room) steps.insert(place, random_step(dice));
      return;
    case 1:
      if (has_room) steps.push_back(random_step(dice));
      return;
    case 2:
      steps.erase(place);
      return;
    case 3:
      std::swap(*place, steps[dice.below(steps.size())]);
      return;
    case 4:
      (*place)[dice.below(kStep)] = random_byte(dice);
      return;
    default:
      (*place)[dice.below(kStep)] ^= static_cast<std::uint8_t>(1u << dice.below(8));
  }
}

}  // namespace

PointArray points_from_bytes(const std::uint8_t* data, std::size_t size, std::size_t dimension,
                             bool weighted) {
  Recipe recipe(dimension);
  for (std::size_t at = 0; at + kStep <= size && !recipe.is_full(); at += kStep) {
    recipe.follow(data + at);
  }
  return recipe.points(weighted);
}

std::size_t mutate_bytes(std::uint8_t* data, std::size_t size, std::size_t max_size,
                         unsigned int seed) {
  Dice dice(seed);
  std::vector<RecipeStep> steps(std::min(size, max_size) / kStep);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    std::copy_n(data + i * kStep, kStep, steps[i].begin());
  }
  const std::size_t times = 1 + dice.below(2);
  for (std::size_t i = 0; i < times; ++i) mutate_once(steps, max_size / kStep, dice);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    std::copy(steps[i].begin(), steps[i].end(), data + i * kStep);
  }
  return steps.size() * kStep;
}

namespace {

bool is_wanted(const FuzzOptions& options, const PointArray& points) {
  if (points.size() < std::max<std::size_t>(options.min_points, 1)) return false;
  return options.flat_sets || affine_hull(generators::from(points).points).dimension ==
                                  static_cast<int>(options.dimension);
}

}  // namespace

int fuzz_once(const Triangulator& subject, const FuzzOptions& options, const std::uint8_t* data,
              std::size_t size) {
  const bool weighted = options.claim == "weighted-delaunay";
  const PointArray points = points_from_bytes(data, size, options.dimension, weighted);
  if (!is_wanted(options, points)) return 0;
  const harness::Answer given = harness::answer(subject, points);
  Judgement judgement{false, given.failure, "the program threw: " + given.text + "\n"};
  if (given.failure.empty()) {
    judgement = judge(options.claim, points, given.simplices, harness::kJudgeOfCases);
  }
  if (judgement.holds) return 0;
  fmt::print(stderr, "{}: {} on {}\n{}{}", options.claim, judgement.rule,
             report::counted(points.size(), "point"), harness::node_text(points), judgement.report);
  std::abort();
}

}  // namespace circumspect
