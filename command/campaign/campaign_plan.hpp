// The options of `campaign`, and the plan that they make.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <tl/expected.hpp>

#include "command/campaign/campaign_inputs.hpp"
#include "command/campaign/campaign_options.hpp"
#include "command/output/output.hpp"
#include "fuzz/campaign/campaign.hpp"

namespace circumspect::cli {

struct CampaignOptions {
  SubjectOptions subject;
  std::uint64_t seed = 0;
  std::optional<double> seconds;
  std::optional<std::size_t> cases;
  std::vector<std::string> families;
  std::vector<std::string> excluded;
  Sizes sizes;
  std::string known;
  bool goes_on = false;
  std::size_t jobs = std::max(1U, std::thread::hardware_concurrency());
  std::string folder = "campaign";
  std::string corpus;
  std::string junit;
  std::string sarif;
  bool annotates = false;
  std::string html;
  OutputOptions output;
};

// The options outlive the command.
void add_campaign_options(CLI::App& command, CampaignOptions& options);

// What is to be done; errors are printed.
tl::expected<campaign::Plan, ExitCode> plan_of(const CampaignOptions& options);

}  // namespace circumspect::cli
