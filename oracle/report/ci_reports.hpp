// What CI servers read: JUnit's XML, and SARIF for code scanning.
#pragma once

#include <string>
#include <vector>

#include "oracle/report/json.hpp"

namespace circumspect::report {

// The text with what XML gives a meaning written as entities; what it cannot hold is escaped.
std::string for_xml(const std::string& text);

// One place that is at fault. `is_note`: it explains others.
struct SarifResult {
  std::string rule;
  std::string text;
  std::string path;
  bool is_note = false;
};
// A document of SARIF 2.1.0.
Json sarif_document(const std::vector<SarifResult>& results, const std::string& version);

// The same of the results of `check --format json`: in JUnit a test case for each mesh, in SARIF a
// result for each witness. A mesh that could not be read is an error.
std::string junit_of_check(const Json& results);
Json sarif_of_check(const Json& results, const std::string& version);

}  // namespace circumspect::report
