// Running a RapidCheck property a stated number of times inside a doctest case.
#pragma once

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

}  // namespace circumspect::properties
