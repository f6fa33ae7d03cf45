#include <doctest/doctest.h>

#include "oracle/judge/within/held_to_definition_test.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::check {

TEST_CASE("the least reach and the images are those of the definition") {
  const bool in_part = properties::one_input_in() > 1;
  hold_equal_to_definition(2, 1, in_part ? 50 : 100);
  hold_equal_to_definition(3, 1, in_part ? 8 : 15);
}

}  // namespace circumspect::check
