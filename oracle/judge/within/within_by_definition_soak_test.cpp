#include <doctest/doctest.h>

#include "oracle/judge/within/held_to_definition_test.hpp"

namespace circumspect::check {

TEST_CASE("in the plane the least reach and the images are those of the definition") {
  hold_equal_to_definition(2, 1000, 10'000);
}

TEST_CASE("in space the least reach and the images are those of the definition") {
  hold_equal_to_definition(3, 1000, 10'000);
}

}  // namespace circumspect::check
