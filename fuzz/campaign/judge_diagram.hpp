// Judges the file of a Voronoi diagram that a program wrote.
#pragma once

#include <string>

#include "fuzz/campaign/input.hpp"
#include "fuzz/campaign/outcome.hpp"
#include "fuzz/campaign/subject.hpp"

namespace circumspect::campaign {

// As judge_mesh.hpp does meshes, in the default box of the sites, within the distance of the
// subject. Requires: the file is a regular one; no two sites are equal.
Outcome judged_diagram(const Subject& subject, const PointsCase& sites, const std::string& path);

}  // namespace circumspect::campaign
