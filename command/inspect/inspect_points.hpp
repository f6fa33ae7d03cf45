// `inspect` of a point set: dimension, duplicates, genericity with a witness, counts. Book: Section
// 4.1.
#pragma once

#include <string>
#include <vector>

#include "command/input/input.hpp"
#include "command/output/output.hpp"
#include "oracle/picture/page.hpp"

namespace circumspect::cli {

struct PointsInspection {
  std::size_t subsets = 200'000;            // so many are looked at for genericity; 0: all
  std::vector<std::string> simplices = {};  // "1 2 3", by the user's indices
};

// The facts that --only may name.
std::vector<std::string> point_facts();

// `only`: some of the facts; none means all. Requires: point_facts() has them. What is found is
// added to `page`, if there is one.
void inspect_points(const std::string& path, const InputOptions& input,
                    const PointsInspection& options, const std::vector<std::string>& only,
                    Output& output, picture::Page* page);

}  // namespace circumspect::cli
