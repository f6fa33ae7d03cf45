#include "reference/exact/box_index.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <boost/geometry/algorithms/distance.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>

namespace circumspect {
namespace {

namespace bg = boost::geometry;
using Corner = bg::model::point<double, 3, bg::cs::cartesian>;
using TreeBox = bg::model::box<Corner>;
using Entry = std::pair<TreeBox, std::size_t>;

// The tree takes sums and differences of coordinates, and of infinite ones a difference may be no
// number. Cutting all boxes off at ±2^1000 is monotone: boxes that meet still do.
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
  const auto all = bg::index::intersects(tree_box(box));
  for (auto it = tree_->places.qbegin(all); it != tree_->places.qend(); ++it) {
    if (may_meet(tree_->boxes[it->second], box)) places.push_back(it->second);
  }
  std::sort(places.begin(), places.end());
  return places;
}

std::size_t BoxIndex::near(const Box& box) const {
  const auto nearest = tree_->places.qbegin(bg::index::nearest(tree_box(box).min_corner(), 1));
  return nearest->second;
}

}  // namespace circumspect
