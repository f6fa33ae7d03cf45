// Running a RapidCheck property a stated number of times inside a doctest case.
#pragma once

#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>

#include <rapidcheck.h>

namespace circumspect::properties {

// Does the property hold on `successes` random inputs? RapidCheck prints what fails, shrunk. Seed
// and sizes come from RC_PARAMS, as for every RapidCheck property.
template <typename Testable>
bool holds(const std::string& description, int successes, Testable&& testable) {
  rc::detail::TestMetadata metadata;
  metadata.id = description;
  metadata.description = description;
  rc::detail::TestParams params = rc::detail::configuration().testParams;
  params.maxSuccess = successes;
  const auto result = rc::detail::checkTestable(std::forward<Testable>(testable), metadata, params);
  if (result.template is<rc::detail::SuccessResult>()) return true;
  std::cerr << description << "\n";
  rc::detail::printResultMessage(result, std::cerr);
  std::cerr << "\n";
  return false;
}

// Has a kind of input been drawn that a property must not do without? The fixed inputs of `make test`
// have all of them. A soak, which says so in its environment, draws new ones each round, where a rare
// kind may well be missing once: it does not ask.
inline bool occurs(std::size_t often) {
  return often > 0 || std::getenv("CIRCUMSPECT_SOAK") != nullptr;
}

}  // namespace circumspect::properties
