#include "oracle/judge/fault_of_claim.hpp"

#include "oracle/judge/complex/judge_complex.hpp"
#include "oracle/judge/convex_hull/judge_convex_hull.hpp"
#include "oracle/judge/surface/judge_surface.hpp"

namespace circumspect::check {

std::string fault_of_claim(Claim claim, const Mesh& mesh, const Options& options) {
  switch (claim) {
    case Claim::kComplex:
      return fault_of_demands(mesh, options.complex);
    case Claim::kConvexHull:
      return fault_of_hull(mesh);
    case Claim::kSurfaceDelaunay:
      return fault_of_surface(mesh);
    case Claim::kVoronoi:
      return "expected the cells of a Voronoi diagram for the claim voronoi, found a mesh";
    default:
      return "";
  }
}

}  // namespace circumspect::check
