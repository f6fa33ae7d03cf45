// For tests: `circumspect build delaunay` writes the same bytes for every algorithm and every
// order. The code that same_bytes_test and same_bytes_soak_test share.
#pragma once

#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <rapidcheck.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {

// What the command's own help offers for an option: "--order a|b|c" gives a, b and c. So a new
// algorithm is held to the others without a line here.
inline std::vector<std::string> choices(const std::string& option) {
  const std::string help = run({"build", "delaunay", "--help"}).out;
  const std::size_t found = help.find("  " + option + ' ');
  if (found == std::string::npos) throw std::runtime_error("no " + option + " in the help");
  std::istringstream words(help.substr(found));
  std::string name, alternatives;
  words >> name >> alternatives;
  std::vector<std::string> all;
  std::istringstream each(alternatives);
  for (std::string choice; std::getline(each, choice, '|');) all.push_back(choice);
  if (all.size() < 2) throw std::runtime_error("no choices for " + option + " in the help");
  return all;
}

using Arguments = std::vector<std::string>;

// Every combination of the options. Orders, locations and seeds are Bowyer-Watson's; the other
// algorithms take none of them, and one run of each is enough.
inline std::vector<Arguments> every_way(const std::vector<std::string>& seeds) {
  static const std::vector<std::string> algorithms = choices("--algorithm");
  static const std::vector<std::string> orders = choices("--order");
  static const std::vector<std::string> locations = choices("--location");
  std::vector<Arguments> ways;
  for (const std::string& algorithm : algorithms) {
    if (algorithm != "bowyer-watson") {
      ways.push_back({"--algorithm", algorithm});
      continue;
    }
    for (const std::string& order : orders) {
      for (const std::string& location : locations) {
        for (const std::string& seed : seeds) {
          ways.push_back(
              {"--algorithm", algorithm, "--order", order, "--location", location, "--seed", seed});
        }
      }
    }
  }
  return ways;
}

// The .ele file, the .neigh file and whatever else the command says, end to end.
inline std::string everything_written(const std::string& points, const std::string& neighbors,
                                      const Arguments& way) {
  Arguments arguments = {"build", "delaunay", points,        "--coordinates", "decimal",
                         "-o",    "-",        "--neighbors", neighbors};
  arguments.insert(arguments.end(), way.begin(), way.end());
  const Run built = run(arguments);
  if (!built.err.empty()) RC_LOG() << built.err;
  RC_ASSERT(built.exit_code == 0);
  RC_ASSERT(built.err.empty());
  return built.out + "neighbours\n" + contents(neighbors);
}

// The property that the command writes the same bytes for a random set of dimension d, whichever
// way it goes. `sets` makes generators::PointsCase, which prints itself as a .node file.
template <typename Set>
auto same_bytes(std::size_t d, const rc::Gen<Set>& sets) {
  return [d, sets] {
    const Set set = *sets;
    const auto seeds =
        *rc::gen::pair(rc::gen::arbitrary<std::uint64_t>(), rc::gen::arbitrary<std::uint64_t>());
    std::ostringstream node;
    if (set.points.empty())
      node << "0 " << d << " 0 0\n";
    else
      node << set;
    const ScratchFolder folder;
    const std::string points = folder.write("points.node", node.str());
    const std::string neighbors = folder.path("points.neigh");
    std::string expected;
    for (const Arguments& way :
         every_way({std::to_string(seeds.first), std::to_string(seeds.second)})) {
      std::string options;
      for (const std::string& word : way) options += ' ' + word;
      const std::string written = everything_written(points, neighbors, way);
      if (expected.empty()) expected = written;
      if (written != expected) {
        RC_LOG() << "with" << options << ":\n" << written << "but the first way:\n" << expected;
      }
      RC_ASSERT(written == expected);
    }
  };
}

}  // namespace circumspect::cli
