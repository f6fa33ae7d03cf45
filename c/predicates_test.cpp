// The predicates of the C interface.
#include <array>

#include <circumspect/circumspect.h>
#include <doctest/doctest.h>

#include "c/calls_test.hpp"

namespace circumspect::c {
namespace {

TEST_CASE("exact predicates") {
  int sign = 7;
  const std::array<double, 6> turn = {0, 0, 1, 0, 0, 1};
  CHECK(circumspect_orientation(2, turn.data(), &sign) == CIRCUMSPECT_OK);
  CHECK(sign == 1);
  // On a line, where doubles round to either side of it.
  const std::array<double, 6> line = {0.1, 0.1, 0.2, 0.2, 0.3, 0.3};
  CHECK(circumspect_orientation(2, line.data(), &sign) == CIRCUMSPECT_OK);
  CHECK(sign == 0);
  const std::array<double, 8> inside = {0, 0, 1, 0, 0, 1, 0.9, 0.9};
  CHECK(circumspect_in_ball(2, inside.data(), &sign) == CIRCUMSPECT_OK);
  CHECK(sign == 1);
  const std::array<const char*, 8> on = {"0", "0", "1/3", "0", "0", "1/3", "1/3", "1/3"};
  CHECK(circumspect_in_ball_exact(2, on.data(), &sign) == CIRCUMSPECT_OK);
  CHECK(sign == 0);
  CHECK(circumspect_orientation_exact(2, on.data(), &sign) == CIRCUMSPECT_OK);
  CHECK(sign == 1);
  const std::array<double, 8> flat = {0, 0, 1, 0, 2, 0, 0.9, 0.9};
  CHECK(circumspect_in_ball(2, flat.data(), &sign) == CIRCUMSPECT_INPUT_FAULT);
  CHECK(circumspect_in_ball(0, flat.data(), &sign) == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(circumspect_in_ball(-3, flat.data(), &sign) == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(circumspect_in_ball(2, nullptr, &sign) == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(circumspect_in_ball(2, flat.data(), nullptr) == CIRCUMSPECT_INVALID_ARGUMENT);
  const std::array<const char*, 6> malformed = {"0", "0", "1", "one", "0", "1"};
  CHECK(circumspect_orientation_exact(2, malformed.data(), &sign) == CIRCUMSPECT_INPUT_FAULT);
  CHECK(has(circumspect_last_error(), "found one in the coordinates at place 3"));
  const std::array<const char*, 6> null = {"0", "0", "1", nullptr, "0", "1"};
  CHECK(circumspect_orientation_exact(2, null.data(), &sign) == CIRCUMSPECT_INVALID_ARGUMENT);
}

}  // namespace
}  // namespace circumspect::c
