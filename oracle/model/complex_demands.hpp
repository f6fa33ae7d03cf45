// What more than the claim `complex` says can be demanded of a mesh alone, and what of it be let
// pass.
#pragma once

namespace circumspect {

enum class Orientations {
  kAny,
  kSame,      // of full dimension one sign; of a lower one consistent across facets
  kPositive,  // the sign of det[p_1 − p_0; …; p_d − p_0]
  kNegative,
};

struct ComplexDemands {
  bool manifold = false;
  bool connected = false;  // through facets
  bool closed = false;     // no facet in exactly one simplex
  bool faces = false;      // what is listed beside the simplices are faces of theirs
  Orientations oriented = Orientations::kAny;
  bool allow_hanging = false;  // hanging vertices are counted, and break no rule
  bool allow_unused = false;   // points without a simplex break no rule
};

}  // namespace circumspect
