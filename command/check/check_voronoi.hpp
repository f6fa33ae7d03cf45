// circumspect check --claim voronoi: cells of a Voronoi diagram, which are not a mesh.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "command/check/within_option.hpp"
#include "command/input/input.hpp"
#include "command/output/output.hpp"
#include "command/output/picture_output.hpp"
#include "oracle/model/options.hpp"
#include "oracle/model/voronoi_diagram.hpp"

namespace circumspect::cli {

void add_box_option(CLI::App& command, std::optional<JudgedBox>& box);

// What is asked of each file of cells.
struct VoronoiQuestion {
  const InputOptions& input;  // with the file of the sites
  const std::optional<Distance>& within;
  const std::optional<JudgedBox>& box;
  const check::Options& check;
};
void check_voronoi(const std::string& path, const VoronoiQuestion& question, Pictures& pictures,
                   Output& output);

}  // namespace circumspect::cli
