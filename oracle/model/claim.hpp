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
};

// All claims that a user may choose.
std::span<const ClaimEntry> claims();

std::string_view name(Claim claim);
bool is_about_a_domain(Claim claim);

}  // namespace circumspect
