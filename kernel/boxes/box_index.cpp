#include "kernel/boxes/box_index.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include <boost/geometry/algorithms/distance.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <boost/iterator/function_output_iterator.hpp>

namespace circumspect {

namespace {

// The greatest double that is at most the sum, or one below it. In round-to-nearest, the computed
// sum s of two finite doubles is a double next to their exact sum, and differs from that by exactly
// `error`, unless it overflows. (D. Knuth, "The Art of Computer Programming" 2, Section 4.2.2,
// Theorem B.)
double lower_sum(double a, double b) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kLargest = std::numeric_limits<double>::max();
  const double sum = a + b;
  if (!std::isfinite(sum))
    return sum > 0 && std::isfinite(a) && std::isfinite(b) ? kLargest : -kInfinity;
  const double of_b = sum - a;
  const double error = (a - (sum - of_b)) + (b - of_b);
  const bool is_above = !(error >= 0) || std::abs(sum) > 0x1p1000;  // such sums prove nothing
  return is_above ? std::nextafter(sum, -kInfinity) : sum;
}

// Bounds of the sums and differences of two coordinates, from those of the coordinates.
void add_sums(Box& box) {
  constexpr std::array<std::array<std::size_t, 2>, 3> kPairs = {{{0, 1}, {0, 2}, {1, 2}}};
  for (std::size_t i = 0; i < kPairs.size(); ++i) {
    const auto [a, b] = kPairs[i];
    box.low[3 + 2 * i] = lower_sum(box.low[a], box.low[b]);
    box.high[3 + 2 * i] = -lower_sum(-box.high[a], -box.high[b]);
    box.low[4 + 2 * i] = lower_sum(box.low[a], -box.high[b]);
    box.high[4 + 2 * i] = -lower_sum(-box.high[a], box.low[b]);
  }
}

}  // namespace

Box box_around(const Point& point) {
  assert(point.size() == 2 || point.size() == 3);
  Box box = {};
  for (std::size_t i = 0; i < point.size(); ++i) {
    const auto [low, high] = enclosing(point[i]);
    box.low[i] = low;
    box.high[i] = high;
  }
  add_sums(box);
  return box;
}

Box box_around(const Box& a, const Box& b) {
  Box box = a;
  for (std::size_t i = 0; i < box.low.size(); ++i) {
    box.low[i] = std::min(a.low[i], b.low[i]);
    box.high[i] = std::max(a.high[i], b.high[i]);
  }
  return box;
}

Box box_around_all(const std::vector<Point>& points) {
  Box box = box_around(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) box = box_around(box, box_around(points[i]));
  return box;
}

Box cube(const Point& centre, const Rational& reach) {
  Box box = {};
  for (std::size_t i = 0; i < centre.size(); ++i) {
    box.low[i] = lower_double(centre[i] - reach);
    box.high[i] = upper_double(centre[i] + reach);
  }
  add_sums(box);
  return box;
}

bool may_meet(const Box& a, const Box& b) {
  for (std::size_t i = 0; i < a.low.size(); ++i) {
    if (a.high[i] < b.low[i] || b.high[i] < a.low[i]) return false;
  }
  return true;
}

bool may_meet_inside(const Box& around, const Box& other) {
  if (!may_meet(around, other)) return false;
  for (std::size_t i = 0; i < around.low.size(); ++i) {
    if (around.low[i] == around.high[i]) continue;  // all its points have this value
    if (around.high[i] == other.low[i] || other.high[i] == around.low[i]) return false;
  }
  return true;
}

namespace {

namespace bg = boost::geometry;
using Corner = bg::model::point<double, 3, bg::cs::cartesian>;
using TreeBox = bg::model::box<Corner>;
using Entry = std::pair<TreeBox, std::size_t>;

// The tree takes sums and differences of coordinates, and inf − inf would be NaN. Cutting all boxes
// off at ±2^1000 is monotone: boxes that meet still do.
double finite(double coordinate) {
  constexpr double kFar = 0x1p1000;
  return std::clamp(coordinate, -kFar, kFar);
}

TreeBox tree_box(const Box& box) {
  const auto corner = [](const std::array<double, 9>& at) {
    return Corner(finite(at[0]), finite(at[1]), finite(at[2]));
  };
  return {corner(box.low), corner(box.high)};
}

std::vector<Entry> entries(const std::vector<Box>& boxes) {
  std::vector<Entry> result;
  result.reserve(boxes.size());
  for (const Box& box : boxes) result.emplace_back(tree_box(box), result.size());
  return result;
}

}  // namespace

struct BoxIndex::Tree {
  explicit Tree(const std::vector<Box>& list) : places(entries(list)), boxes(list) {}
  bg::index::rtree<Entry, bg::index::quadratic<16>> places;
  std::vector<Box> boxes;
};

BoxIndex::BoxIndex(const std::vector<Box>& boxes) : tree_(std::make_unique<Tree>(boxes)) {}
BoxIndex::~BoxIndex() = default;
BoxIndex::BoxIndex(BoxIndex&&) noexcept = default;
BoxIndex& BoxIndex::operator=(BoxIndex&&) noexcept = default;

std::vector<std::size_t> BoxIndex::meeting(const Box& box) const {
  std::vector<std::size_t> places;
  const auto take = [&](const Entry& entry) {
    if (may_meet(tree_->boxes[entry.second], box)) places.push_back(entry.second);
  };
  tree_->places.query(bg::index::intersects(tree_box(box)),
                      boost::make_function_output_iterator(take));
  std::sort(places.begin(), places.end());
  return places;
}

std::size_t BoxIndex::near(const Box& box) const {
  const auto nearest = tree_->places.qbegin(bg::index::nearest(tree_box(box).min_corner(), 1));
  return nearest->second;
}

}  // namespace circumspect
