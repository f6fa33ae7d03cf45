// The constructions of triangulations of a domain, by the names that users type.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "command/build/cdt_decision.hpp"
#include "command/output/output.hpp"
#include "oracle/model/domain.hpp"
#include "reference/constrained/plc_triangulation.hpp"

namespace circumspect::cli {

// A mesh of a domain: its vertices first, in their order, then the Steiner points.
struct DomainMesh {
  PointSet points;
  constrained::PlcTriangulation triangulation;
  std::vector<std::string> steiner_points = {};  // where each is: "on segment 1 2"
  // Set if this is a CDT, but not the canonical one: why there is no canonical one.
  std::optional<std::string> not_canonical = {};
  // The third coordinate of all points of the domain, if it was left out. It is written again.
  std::optional<Rational> height = {};

  Point as_given(Vertex v) const {
    Point point = points[v];
    if (height) point.push_back(*height);
    return point;
  }
};

// Why there is none. Not proved: another algorithm, a higher limit or more points may make one.
struct NoMesh {
  bool is_proved = false;
  std::string reason;  // one line, vertices by the user's indices
};

// What is to be made of a domain, and how.
struct DomainConstruction {
  std::string what;  // planar-cdt, cdt, steiner-cdt or conforming-delaunay
  // One of `algorithms_for` it. If none is asked for: gift-wrapping; but for a steiner-cdt in
  // space, which is that of an edge-protected domain, and for a cdt of one with more than
  // reference::kFewVertices vertices, polygon-flips, if it succeeds. For a cdt in space, where
  // there is no canonical one, then a search for another. An algorithm that is asked for is not
  // replaced by that search, but whether there is none at all is decided in either case.
  std::optional<std::string> algorithm = {};
  SearchLimits search = {};                  // cdt
  std::size_t most_steiner_points = 10'000;  // steiner-cdt, conforming-delaunay
};
// `name` is that of the domain, for whoever waits.
tl::expected<DomainMesh, NoMesh> construct(const DomainConstruction& construction,
                                           const Domain& domain, const std::string& name,
                                           Output& output);

// For conforming-delaunay there is but one way, without a name.
std::vector<std::string> algorithms_for(const std::string& what, std::size_t dimension);

}  // namespace circumspect::cli
