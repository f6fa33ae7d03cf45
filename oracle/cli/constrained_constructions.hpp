// The constructions of triangulations of a domain, by the names that users type.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "oracle/domain.hpp"
#include "reference/constrained/plc_triangulation.hpp"

namespace circumspect::cli {

// A mesh of a domain: its vertices first, in their order, then the Steiner points.
struct DomainMesh {
  PointSet points;
  constrained::PlcTriangulation triangulation;
  std::vector<std::string> steiner_points = {};  // where each is: "on segment 1 2"
};

// Why there is none. Not proved: this algorithm could not make one; another, or more points, may.
struct NoMesh {
  bool is_proved = false;
  std::string reason;  // one line, vertices by the user's indices
};

// What is to be made of a domain, and how.
struct DomainConstruction {
  std::string what;                          // planar-cdt, cdt, steiner-cdt or conforming-delaunay
  std::string algorithm;                     // one of `algorithms_for` it
  std::size_t most_steiner_points = 10'000;  // conforming-delaunay
};
tl::expected<DomainMesh, NoMesh> construct(const DomainConstruction& construction,
                                           const Domain& domain);

// The first is the default. For conforming-delaunay there is but one way, without a name.
std::vector<std::string> algorithms_for(const std::string& what, std::size_t dimension);

}  // namespace circumspect::cli
