#include "oracle/model/claim.hpp"

#include <algorithm>
#include <array>

namespace circumspect {
namespace {

constexpr auto kClaims = std::to_array<ClaimEntry>({
    {Claim::kTriangulation, "triangulation", false},
    {Claim::kDelaunay, "delaunay", false},
    {Claim::kWeightedDelaunay, "weighted-delaunay", false},
    {Claim::kComplex, "complex", false, true},
    {Claim::kConvexHull, "convex-hull", false, true},
    {Claim::kSurfaceDelaunay, "surface-delaunay", false, true},
    {Claim::kVoronoi, "voronoi", false, true},
    {Claim::kPlcTriangulation, "plc-triangulation", true},
    {Claim::kSteinerTriangulation, "steiner-triangulation", true},
    {Claim::kCdt, "cdt", true},
    {Claim::kSteinerCdt, "steiner-cdt", true},
    {Claim::kConformingDelaunay, "conforming-delaunay", true},
});

const ClaimEntry& entry(Claim claim) {
  return *std::find_if(kClaims.begin(), kClaims.end(),
                       [claim](const ClaimEntry& one) { return one.claim == claim; });
}

}  // namespace

std::span<const ClaimEntry> claims() { return kClaims; }
std::string_view name(Claim claim) { return entry(claim).name; }
bool is_about_a_domain(Claim claim) { return entry(claim).is_about_a_domain; }
bool is_about_a_list(Claim claim) { return entry(claim).is_about_a_list; }

}  // namespace circumspect
