// How far the polynomials of polynomials.hpp, evaluated with doubles, may be from their exact values.
#pragma once

namespace circumspect::fast {

// Each is proved by the script proofs/filters/NAME.gappa, for differences (and weights) scaled so that
// the largest in its column is 1. Columns have degree one in the polynomials, so that for others the
// bound is multiplied by the largest entry of each column; see proofs/filters/README.md.
inline constexpr double kOrientation2 = 0x1.001p-50;      // orientation_2.gappa
inline constexpr double kOrientation3 = 0x1.701p-48;      // orientation_3.gappa
inline constexpr double kInCircle = 0x1.001p-46;          // in_circle.gappa
inline constexpr double kInCircleWeighted = 0x1.801p-46;  // in_circle_weighted.gappa
inline constexpr double kInSphere = 0x1.189p-43;          // in_sphere.gappa
inline constexpr double kInSphereWeighted = 0x1.781p-43;  // in_sphere_weighted.gappa

// What multiplying with the largest entries may lose by rounding: at most five products, each rounded,
// are low by a factor of at most (1 − 2^-53)^5 > 1 − 2^-50.
inline constexpr double kRoundedBound = 1 + 0x1p-40;

// Within these limits of the largest entry of each column of coordinates (their squares: of heights)
// nothing overflows, and what underflow adds to one product is at most 2^-125 after scaling, which
// is what the scripts assume. Largest: 2^(5·190) times at most 2^7.
inline constexpr double kSmallestScale = 0x1p-190;
inline constexpr double kLargestScale = 0x1p190;
inline constexpr double kLargestHeight = 0x1p380;

}  // namespace circumspect::fast
