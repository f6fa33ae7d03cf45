// The options of `check`, and what of them does not go together.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "command/check/complex_options.hpp"
#include "command/check/within_option.hpp"
#include "command/input/input.hpp"
#include "command/options/domain_options.hpp"
#include "command/output/output.hpp"
#include "command/output/picture_output.hpp"
#include "oracle/model/claim.hpp"
#include "oracle/model/options.hpp"
#include "oracle/model/voronoi_diagram.hpp"

namespace circumspect::cli {

struct CheckOptions {
  std::vector<std::string> meshes;
  std::optional<Claim> claim;
  std::optional<std::string> domain;
  DomainOptions said;  // of the domain
  std::optional<Distance> within;
  std::optional<std::string> certificate;
  PictureOptions picture;
  std::shared_ptr<Pictures> pictures;
  check::Options check;
  ComplexOptions complex;
  std::optional<JudgedBox> box;  // in which Voronoi cells are compared
  InputOptions input;
  OutputOptions output;
  std::uint64_t threads = 0;  // 0: as many as the machine has
  std::optional<std::uint64_t> memory;
};

// The options outlive the command.
void add_check_options(CLI::App& command, CheckOptions& options);

// What a claim needs and did not get, or got and does not need, and whatever else does not go
// together; empty if all is well. What is demanded of a complex is put into `options.check`.
std::string usage_fault(CheckOptions& options);

}  // namespace circumspect::cli
