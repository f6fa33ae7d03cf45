// The same bytes whichever way a triangulation is built, on 1,500 degenerate sets: 45,000 runs of
// the command.
#include <doctest/doctest.h>

#include "command/same_bytes_test.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::cli {
namespace {

TEST_CASE("build: every way writes the same bytes, on 500 degenerate sets in each dimension") {
  for (const std::size_t d : {2u, 3u, 4u}) {
    CAPTURE(d);
    const auto sets = generators::unweighted(generators::degenerate_point_set(d, 9));
    CHECK(properties::holds("the same bytes", 500, same_bytes(d, sets)));
  }
}

}  // namespace
}  // namespace circumspect::cli
