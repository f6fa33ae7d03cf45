// What may be claimed of a mesh.
#pragma once

#include <span>
#include <string_view>

namespace circumspect {

enum class Claim {
  kTriangulation,
  kDelaunay,
  kWeightedDelaunay,
  kComplex,  // nothing of a hull, of balls, of a domain
  // Of a mesh and a domain.
  kPlcTriangulation,
  kSteinerTriangulation,
  kCdt,
  kSteinerCdt,
  kConformingDelaunay,
};

struct ClaimEntry {
  Claim claim;
  std::string_view name;   // "steiner-cdt"
  bool is_about_a_domain;  // is one needed to judge it?
};

// All claims, as a user may choose among them.
std::span<const ClaimEntry> claims();

std::string_view name(Claim claim);
bool is_about_a_domain(Claim claim);

}  // namespace circumspect
