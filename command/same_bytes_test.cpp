// The same bytes whichever way a triangulation is built, in short; same_bytes_soak_test at length.
#include "command/same_bytes_test.hpp"

#include <doctest/doctest.h>

#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::cli {
namespace {

TEST_CASE("build: every algorithm, order, location and seed writes the same bytes") {
  for (const std::size_t d : {2u, 3u, 4u}) {
    CAPTURE(d);
    const auto sets = generators::unweighted(generators::degenerate_point_set(d, 9));
    CHECK(properties::holds("the same bytes", 5, same_bytes(d, sets)));
  }
}

// If the help were worded differently, fewer ways might be tested than there are.
TEST_CASE("build: the ways that are compared") {
  CHECK(choices("--location") ==
        std::vector<std::string>{"linear-scan", "conflict-graph", "walking"});
  CHECK(every_way({"0", "1"}).size() ==
        choices("--algorithm").size() - 1 +
            choices("--order").size() * choices("--location").size() * 2);
  CHECK_THROWS(choices("--format-of-nothing"));
}

}  // namespace
}  // namespace circumspect::cli
