#include <doctest/doctest.h>

#include "oracle/judge/within/held_to_definition_test.hpp"

namespace circumspect::check {

TEST_CASE("the least reach and the images are those of the definition, 10,000 times") {
  hold_equal_to_definition(2, 1000, 10'000);
  hold_equal_to_definition(3, 1000, 10'000);
}

}  // namespace circumspect::check
