// Points as the text of a .node file that any reader turns back into the same doubles.
#pragma once

#include <string>

#include <circumspect/subject.hpp>

#include "inputs/points_case.hpp"

namespace circumspect::harness {

std::string node_text(const PointArray& points);

// Is every number a double?
bool are_doubles(const generators::PointsCase& set);

}  // namespace circumspect::harness
