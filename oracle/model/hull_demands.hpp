// What more than the claim `convex-hull` says can be demanded of a hull.
#pragma once

namespace circumspect {

struct HullDemands {
  bool all_boundary_points = false;  // every point of the boundary is a vertex
  bool only_extreme = false;         // every vertex is an extreme point
};

}  // namespace circumspect
