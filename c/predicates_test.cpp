// The predicates of the C interface.
#include <array>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <circumspect/circumspect.h>
#include <doctest/doctest.h>

#include "c/calls_test.hpp"
#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"

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

// The texts of doubles are judged by exact numbers, and doubles by filters.
TEST_CASE("predicates of doubles are those of the same numbers as texts") {
  std::mt19937_64 random(7);
  for (int tries = 0; tries < 300; ++tries) {
    const std::int64_t dimension = 2 + tries % 2;
    const bool is_far = tries % 3 == 0;  // near a line far from the origin, where doubles round
    std::vector<double> doubles;
    std::vector<std::string> texts;
    for (std::int64_t i = 0; i < dimension * (dimension + 2); ++i) {
      const auto place = static_cast<int>(random() % 5);
      doubles.push_back(is_far ? std::nextafter(12.0 + place, random() % 2 == 0 ? 0 : 99) : place);
      texts.push_back(to_string(exact_value(doubles.back())));
    }
    std::vector<const char*> pointers;
    for (const std::string& text : texts) pointers.push_back(text.c_str());
    int sign = 7;
    int exact = 8;
    REQUIRE(circumspect_orientation(dimension, doubles.data(), &sign) == CIRCUMSPECT_OK);
    REQUIRE(circumspect_orientation_exact(dimension, pointers.data(), &exact) == CIRCUMSPECT_OK);
    CHECK(sign == exact);
    const circumspect_status status = circumspect_in_ball(dimension, doubles.data(), &sign);
    REQUIRE(circumspect_in_ball_exact(dimension, pointers.data(), &exact) == status);
    if (status == CIRCUMSPECT_OK) CHECK(sign == exact);
  }
}

TEST_CASE("predicates do not depend on how the processor rounds") {
  const std::array<double, 6> line = {0.1, 0.1, 0.2, 0.2, 0.3, 0.3};
  const std::array<double, 6> turn = {0, 0, 1, 0, 0, 0x1p-1074};
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO, FE_TONEAREST}) {
    std::fesetround(mode);
    int sign = 7;
    int least = 7;
    circumspect_orientation(2, line.data(), &sign);
    circumspect_orientation(2, turn.data(), &least);
    std::fesetround(FE_TONEAREST);
    CHECK(sign == 0);
    CHECK(least == 1);
  }
}

}  // namespace
}  // namespace circumspect::c
