// Where the inputs of a campaign come from: families and files.
#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "fuzz/campaign/campaign.hpp"

namespace circumspect::cli {

// The families of these names; without names, all that fit without modifiers; "all": with modifiers.
// Those fit that exist in the dimension and have weights or not as the claim does.
// Errors: a name that there is not, or that does not fit.
tl::expected<std::vector<campaign::Source>, std::string> campaign_sources(
    const campaign::Subject& subject, const std::vector<std::string>& names,
    std::size_t max_points);

// The points or the domain in a file, as the claim wants it, every number the nearest double.
// Errors: a malformed file, a domain that is not valid, another dimension.
tl::expected<campaign::Input, std::string> campaign_input(const campaign::Subject& subject,
                                                          const std::string& path);

// All inputs in the files of a folder and the folders in it, by their paths; what is no input, or one
// of another dimension, is left out. Errors: no such folder, or no input in it.
tl::expected<std::vector<campaign::Replayed>, std::string> campaign_corpus(
    const campaign::Subject& subject, const std::string& folder);

}  // namespace circumspect::cli
