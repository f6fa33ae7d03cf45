// What may be claimed about a mesh.
#pragma once

#include <span>
#include <string_view>

namespace circumspect {

enum class Claim {
  kTriangulation,
  kDelaunay,
  kWeightedDelaunay,
  kComplex,  // nothing of a hull, of balls, of a domain
  kConvexHull,
  kSurfaceDelaunay,
  kVoronoi,           // of cells, which are not a mesh
  kPeriodicDelaunay,  // of a mesh that a lattice repeats
  // About a mesh and a domain.
  kPlcTriangulation,
  kSteinerTriangulation,
  kCdt,
  kSteinerCdt,
  kConformingDelaunay,
};

struct ClaimEntry {
  Claim claim;
  std::string_view name;   // "steiner-cdt"
  bool is_about_a_domain;  // does judging it need a domain?
  // Is it about what is listed, which need not fill the hull of the points or anything else? Then
  // nothing is proved of it, and cells may have a lower dimension.
  bool is_about_a_list = false;
};

// All claims that a user may choose.
std::span<const ClaimEntry> claims();

std::string_view name(Claim claim);
bool is_about_a_domain(Claim claim);
bool is_about_a_list(Claim claim);

}  // namespace circumspect
