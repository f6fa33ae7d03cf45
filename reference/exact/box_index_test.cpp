// The R-tree against looking at every box.
#include "reference/exact/box_index.hpp"

#include <doctest/doctest.h>

namespace circumspect {
namespace {

// Boxes on a small grid, so that many touch in a face, an edge or a corner; every tenth is unbounded.
std::vector<Box> some_boxes(std::size_t count) {
  std::vector<Box> boxes;
  Rational far = 1;
  for (int i = 0; i < 5000; ++i) far *= 2;
  unsigned state = 7;
  const auto next = [&] { return (state = state * 1103515245u + 12345u) >> 16 & 15u; };
  for (std::size_t i = 0; i < count; ++i) {
    const Point low = {next(), next(), i % 10 == 0 ? -far : Rational(next())};
    const Point high = {low[0] + next() % 4, i % 20 == 0 ? far : low[1] + next() % 4, low[2] + 1};
    boxes.push_back(box_around(box_around(low), box_around(high)));
  }
  return boxes;
}

TEST_CASE("BoxIndex: finds exactly the boxes that meet") {
  const std::vector<Box> boxes = some_boxes(400);
  const BoxIndex index(boxes);
  for (const Box& box : boxes) {
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (may_meet(boxes[i], box)) expected.push_back(i);
    }
    CHECK(index.meeting(box) == expected);
  }
}

TEST_CASE("BoxIndex: of nothing") { CHECK(BoxIndex({}).meeting(box_around(Point{0, 0})).empty()); }

}  // namespace
}  // namespace circumspect
