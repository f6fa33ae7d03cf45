// Faults of programs that triangulate points without weights.
#pragma once

#include <string>
#include <utility>

#include "properties/faulty/fault.hpp"

namespace circumspect::faulty {

inline Fault implementation_fault(std::string name, std::string about, Triangulator triangulate) {
  return {std::move(name), std::move(about), Kind::kImplementation, Claim::kDelaunay,
          std::move(triangulate)};
}

}  // namespace circumspect::faulty
