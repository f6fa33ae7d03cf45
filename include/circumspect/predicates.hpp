// Compares floating-point predicates with exact ones, as TestFloat does for arithmetic, on
// arguments that are degenerate, nearly so, huge, tiny and mixed. Catches builds that contract
// multiplications and additions (FMA) or keep more digits (x87) where a proof assumes IEEE doubles.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace circumspect {

// Each takes the coordinates of its points one point after the other: orientation d+1 points,
// in-sphere d+2 (the last one is the query q). Each returns a number with the sign of
//   orientation: det(p_0 − p_d, …, p_{d−1} − p_d)      Book: Section 3.1, Orient2D and Orient3D
//   in_sphere:   det(p_0⁺ − q⁺, …, p_d⁺ − q⁺), p⁺ = (p, |p|²): if p_0 … p_d are positively
//                oriented, positive if q is inside their circumsphere, negative outside, 0 on it
//                                                      Book: Section 3.1, InCircle and InSphere
// Only the sign counts. These are the signs of Shewchuk's orient2d, orient3d, incircle and
// insphere; CGAL's orientation and side_of_oriented_sphere have the opposite orientation in space.
using Predicate = std::function<double(const double* coordinates)>;

enum class PredicateKind { kOrientation, kInSphere };

struct PredicateOptions {
  PredicateKind kind = PredicateKind::kOrientation;
  std::size_t dimension = 3;  // 2 or 3
  std::size_t cases = 100'000;
  std::uint64_t seed = 20260101;
  // The largest binary exponent of a coordinate (std::ilogb), and the least of one that is not 0:
  // adaptive predicates are right only where no product overflows or underflows. The defaults suit
  // degree 5, in-sphere in space. At least 60 apart.
  int max_exponent = 150;
  int min_exponent = -142;
};

struct PredicateFinding {
  std::string family;               // of arguments
  std::vector<double> coordinates;  // the simplest found on which it is wrong
  int expected = 0;                 // the sign: −1, 0 or 1
  double found = 0;                 // what the predicate returned
  std::string report;               // for people; includes the coordinates as hexadecimal floats
};

// The first arguments on which a predicate has the wrong sign, made simpler; nothing if there are
// none among options.cases. Every machine tries the same arguments. Throws std::invalid_argument: a
// dimension other than 2 and 3; exponents less than 60 apart or beyond ±300.
std::optional<PredicateFinding> find_wrong_sign(const Predicate& predicate,
                                                const PredicateOptions& options = {});

}  // namespace circumspect
