// The inputs of a campaign, from families and from files.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "fuzz/campaign/campaign.hpp"
#include "inputs/modifiers.hpp"
#include "inputs/untidy.hpp"

namespace circumspect::cli {

// How many points the inputs have, how large and how long their numbers are, and how untidy they
// are.
struct Sizes {
  std::optional<std::size_t> max_points;  // without it generators::count_of_a_campaign
  generators::Exponents exponents = {-100, 100};
  bool extreme = false;  // as the families have them
  std::optional<int> integers;
  std::set<generators::Untidiness> untidiness = {};  // of domains of the plane; none: they are tidy
};

// "exponents -100 to 100", and "integers of 20 bits" where they are.
std::string magnitudes(const Sizes& sizes);

// The families of these names; without names, all that fit without modifiers; "all": with
// modifiers. Those fit that exist in the dimension and have weights or not as the claim does.
// Without those that are excluded. Errors: a name that there is not, or that does not fit; none is
// left.
tl::expected<std::vector<campaign::Source>, std::string> campaign_sources(
    const campaign::Subject& subject, const std::vector<std::string>& names,
    const std::vector<std::string>& excluded, const Sizes& sizes);

// The points or the domain in a file, as the claim wants it, every number the nearest double.
// Errors: a malformed file, a domain that is not valid, another dimension.
tl::expected<campaign::Input, std::string> campaign_input(const campaign::Subject& subject,
                                                          const std::string& path);

// All inputs in the files of a folder and the folders in it, by their paths; what is not an input,
// or one of another dimension, is left out. Errors: no such folder, or no input in it.
tl::expected<std::vector<campaign::Replayed>, std::string> campaign_corpus(
    const campaign::Subject& subject, const std::string& folder);

}  // namespace circumspect::cli
