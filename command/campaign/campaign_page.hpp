// What a campaign found, to look at: campaign --html FILE.
#pragma once

#include <string>

#include "fuzz/campaign/campaign.hpp"
#include "oracle/picture/page.hpp"

namespace circumspect::cli {

// A table of families and outcomes, and a card for each signature: the small input, the script that repeats
// it, and where a rule is broken, pictures of the witnesses in the mesh that the program made of that input.
picture::Page campaign_page(const campaign::Result& result, const campaign::Plan& plan,
                            const std::string& program);

}  // namespace circumspect::cli
