#include "command/options/nearest_word.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "properties/arguments/run.hpp"

namespace circumspect::cli {
namespace {

TEST_CASE("edit distance: letters put in, left out, replaced, and neighbours exchanged") {
  CHECK(edit_distance("", "") == 0);
  CHECK(edit_distance("check", "") == 5);
  CHECK(edit_distance("chek", "check") == 1);
  CHECK(edit_distance("checkk", "check") == 1);
  CHECK(edit_distance("chack", "check") == 1);
  CHECK(edit_distance("chekc", "check") == 1);
  CHECK(edit_distance("kitten", "sitting") == 3);
  CHECK(edit_distance("ca", "abc") == 3);  // no part is edited twice
}

// Words of few letters, so that they have letters in common.
std::string word(const std::vector<int>& numbers) {
  std::string letters;
  for (const int number : numbers) letters += static_cast<char>('a' + (number % 3 + 3) % 3);
  return letters;
}

TEST_CASE("edit distance: symmetric, nought for equal words alone, between bounds of lengths") {
  CHECK(properties::holds([] {
    const auto first = *rc::gen::arbitrary<std::vector<int>>();
    const auto second = *rc::gen::arbitrary<std::vector<int>>();
    const std::string a = word(first);
    const std::string b = word(second);
    const std::size_t distance = edit_distance(a, b);
    RC_ASSERT(distance == edit_distance(b, a));
    RC_ASSERT((distance == 0) == (a == b));
    RC_ASSERT(distance <= std::max(a.size(), b.size()));
    RC_ASSERT(distance >= std::max(a.size(), b.size()) - std::min(a.size(), b.size()));
  }));
}

TEST_CASE("edit distance: one exchange of neighbours is one step") {
  CHECK(properties::holds([] {
    const auto numbers = *rc::gen::arbitrary<std::vector<int>>();
    auto place = *rc::gen::arbitrary<std::size_t>();
    std::string a = word(numbers);
    RC_PRE(a.size() >= 2);
    std::string b = a;
    place %= a.size() - 1;
    std::swap(b[place], b[place + 1]);
    RC_ASSERT(edit_distance(a, b) == (a == b ? 0U : 1U));
  }));
}

TEST_CASE("the nearest word, or none where none is near") {
  const std::vector<std::string> words = {"check", "certify", "campaign", "compare", "--version"};
  CHECK(nearest_word("chek", words) == "check");
  CHECK(nearest_word("CHECK", words) == "check");
  CHECK(nearest_word("--verison", words) == "--version");
  CHECK(nearest_word("camp", words) == "campaign");
  CHECK(nearest_word("frobnicate", words).empty());
  CHECK(nearest_word("-c", words).empty());
  CHECK(nearest_word("", words).empty());
  CHECK(nearest_text("chek", words) == "; the nearest is check");
  CHECK(nearest_text("frobnicate", words).empty());
}

}  // namespace

}  // namespace circumspect::cli
