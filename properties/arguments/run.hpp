// Running a RapidCheck property a stated number of times inside a doctest case.
#pragma once

#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>

#include <rapidcheck.h>

namespace circumspect::properties {

// The sanitizers look for faults of memory, and take ten times as long: an eighth of the inputs will do.
// GCC says so by a macro, Clang by a feature.
#if defined(__SANITIZE_ADDRESS__)
#define CIRCUMSPECT_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define CIRCUMSPECT_SANITIZED
#endif
#endif
#ifdef CIRCUMSPECT_SANITIZED
inline constexpr int kOneInputIn = 8;
#else
inline constexpr int kOneInputIn = 1;
#endif

// Does the property hold on `successes` random inputs? RapidCheck prints what fails, shrunk. Seed
// and sizes come from RC_PARAMS, as for every RapidCheck property.
template <typename Testable>
bool holds(const std::string& description, int successes, Testable&& testable) {
  rc::detail::TestMetadata metadata;
  metadata.id = description;
  metadata.description = description;
  rc::detail::TestParams params = rc::detail::configuration().testParams;
  params.maxSuccess = (successes + kOneInputIn - 1) / kOneInputIn;
  const auto result = rc::detail::checkTestable(std::forward<Testable>(testable), metadata, params);
  if (result.template is<rc::detail::SuccessResult>()) return true;
  std::cerr << description << "\n";
  rc::detail::printResultMessage(result, std::cerr);
  std::cerr << "\n";
  return false;
}

// Has a kind of input been drawn, often enough, that a property must not do without? The fixed inputs
// of `make test` have all of them. A soak, which says so in its environment, draws new ones each
// round, where a rare kind may well be missing once: it does not ask. Nor do the sanitizers, which see
// fewer.
inline bool occurs(std::size_t often, std::size_t at_least = 1) {
  return often >= at_least || kOneInputIn > 1 || std::getenv("CIRCUMSPECT_SOAK") != nullptr;
}

}  // namespace circumspect::properties
