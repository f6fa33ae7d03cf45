// The labels of an input that was made tidy.
#include "oracle/domain/resolved.hpp"

#include <algorithm>

#include <doctest/doctest.h>

namespace circumspect {

TEST_CASE("whatever the order of the labels, vertices where segments cross come after all others") {
  PiecewiseLinearInput crossing;
  crossing.points = {{0, 0}, {4, 4}, {0, 4}, {4, 0}, {4, 4}, {2, 0}, {2, 1}};
  crossing.segments = {{0, 4}, {2, 3}, {5, 6}, {0, 3}};
  std::vector<Vertex> labels = {0, 2, 3, 5, 6, 8, 9};
  int orders = 0;
  do {
    const ResolvedInput whole = resolved(crossing, labels);
    CHECK(whole.merged == 1);
    CHECK(whole.added == 1);
    REQUIRE(whole.input.points.size() == 7);
    REQUIRE(whole.labels.size() == 7);
    for (std::size_t v = 0; v < 7; ++v) {
      // Of equal points the first gives its label.
      const auto at =
          std::find(crossing.points.begin(), crossing.points.end(), whole.input.points[v]);
      CHECK(whole.labels[v] ==
            (at == crossing.points.end()
                 ? 10
                 : labels[static_cast<std::size_t>(at - crossing.points.begin())]));
    }
    ++orders;
    std::rotate(labels.begin(), labels.begin() + 1, labels.end());
  } while (orders < 7);
}

}  // namespace circumspect
