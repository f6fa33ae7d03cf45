// Reports the findings of a campaign to people, programs and CI.
#pragma once

#include <string>

#include "fuzz/campaign/campaign.hpp"
#include "oracle/report/json.hpp"

namespace circumspect::cli {

// A table of families, then each finding in three lines.
std::string campaign_text(const campaign::Result& result);

// The last line: "fails: campaign tetgen 412 cases 2 signatures", "holds: campaign tetgen 1000
// cases, 0 to 20 points, exponents -100 to 100, 37 families"; "undecided: …" if nothing was found
// and no case was judged, or it was interrupted.
std::string campaign_verdict(const campaign::Result& result, const std::string& program,
                             const std::string& magnitudes);

report::Json campaign_json(const campaign::Result& result, const campaign::Plan& plan,
                           const std::string& program);

// JUnit: a suite of one test case a family, and one for each signature that was met there, which
// fails.
std::string campaign_junit(const campaign::Result& result, const std::string& program);

// SARIF 2.1.0, which code scanning takes: a result for each signature, at the README.txt of its
// finding.
report::Json campaign_sarif(const campaign::Result& result);

// A line for each signature that GitHub Actions shows as an error: "::error file=…,title=…::…".
std::string campaign_annotations(const campaign::Result& result, const std::string& program);

// How many cases were judged: neither skipped nor refused.
std::size_t judged_cases(const campaign::Result& result);

}  // namespace circumspect::cli
