// The main function of every test executable, and how it runs properties.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <string_view>

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "properties/arguments/run.hpp"

namespace circumspect::properties {

int one_input_in() {
  const char* const asked = std::getenv("CIRCUMSPECT_ONE_INPUT_IN");
  return std::max(1, asked != nullptr ? std::atoi(asked) : 1) * kOneInputIn;
}

namespace {
using Clock = std::chrono::steady_clock;
const Clock::time_point kBegin = Clock::now();

bool holds(const std::string& description, const rc::detail::TestParams& params,
           const std::function<void()>& of_any_input) {
  rc::detail::TestMetadata metadata;
  metadata.id = description;
  metadata.description = description;
  int tried = 0;
  const std::function<void()> property = [&] {
    if (!has_time()) return;
    ++tried;
    of_any_input();
  };
  const auto result = rc::detail::checkTestable(property, metadata, params);
  say_inputs(std::min(tried, params.maxSuccess), params.maxSuccess);
  if (result.template is<rc::detail::SuccessResult>()) return true;
  std::cerr << description << "\n";
  rc::detail::printResultMessage(result, std::cerr);
  std::cerr << "\n";
  return false;
}
}  // namespace

bool holds(const std::string& description, int successes, const std::function<void()>& property) {
  rc::detail::TestParams params = rc::detail::configuration().testParams;
  const char* const asked = std::getenv("RC_PARAMS");
  if (asked == nullptr || std::string_view(asked).find("max_success=") == std::string_view::npos) {
    const int one_in = one_input_in();
    params.maxSuccess = (successes + one_in - 1) / one_in;
  }
  return holds(description, params, property);
}

bool holds(const std::string& description, const std::function<void()>& property) {
  return holds(description, rc::detail::configuration().testParams, property);
}

bool holds(const std::function<void()>& property) { return holds("", property); }

bool has_time() {
  const char* const seconds = std::getenv("CIRCUMSPECT_SECONDS");
  return seconds == nullptr || Clock::now() - kBegin < std::chrono::seconds(std::atoi(seconds));
}

void say_inputs(int tried, int asked) {
  if (std::getenv("CIRCUMSPECT_SECONDS") == nullptr) return;
  std::cout << "inputs: " << tried << " of " << asked << std::endl;
}

int try_seeds(std::uint64_t first, int count, const std::function<void(std::uint64_t)>& test) {
  const bool is_soak = std::getenv("CIRCUMSPECT_SOAK") != nullptr;
  if (is_soak) first += rc::detail::configuration().testParams.seed >> 1;
  int tried = 0;
  for (; tried < count && has_time(); ++tried) test(first + static_cast<std::uint64_t>(tried));
  say_inputs(tried, count);
  return tried;
}

bool occurs(std::size_t often, std::size_t at_least) {
  const auto one_in = static_cast<std::size_t>(one_input_in());
  return often >= (at_least + one_in - 1) / one_in || kOneInputIn > 1 ||
         std::getenv("CIRCUMSPECT_SOAK") != nullptr;
}

}  // namespace circumspect::properties
