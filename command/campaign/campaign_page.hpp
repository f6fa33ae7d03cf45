// The findings of a campaign as a page: --html FILE of campaign and minimize.
#pragma once

#include <string>

#include "fuzz/campaign/campaign.hpp"
#include "fuzz/campaign/runner.hpp"
#include "oracle/picture/page.hpp"

namespace circumspect::cli {

// A table of families and outcomes, and a card for each signature: the small input, the script that
// repeats it, and where a rule is broken, pictures of the witnesses in the mesh that the program
// made of that input.
picture::Page campaign_page(const campaign::Result& result, const campaign::Plan& plan,
                            const std::string& program);

// What is left of one input: a card of the last run of the program, which was on this input.
// `finding` as Page::add_finding takes it.
picture::Page minimal_page(report::Json finding, const campaign::Input& input,
                           const campaign::Subject& subject, const campaign::Runner& runner);

}  // namespace circumspect::cli
