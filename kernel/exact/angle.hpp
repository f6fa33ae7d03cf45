// Angles of rational vectors, compared with degrees exactly. Such an angle is seldom a rational
// number of degrees, but sign(cos) · cos² of it is rational: its signed square. It is 1 at 0°, 0 at
// 90° and −1 at 180°, and falls as the angle grows.
#pragma once

#include <string>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"

namespace circumspect {

// The sign of the angle with this signed square minus so many degrees. Requires: a signed square
// from −1 to 1; degrees from 0 to 180.
//
// Where degrees and cos² are both rational, degrees is one of 0, 30, 45, 60, 90, 120, 135, 150 and
// 180: 2·cos² − 1 is the cosine of twice the angle, and the only rational cosines of rational
// multiples of a right angle are 0, ±1/2 and ±1 (I. Niven, Irrational Numbers, Corollary 3.12).
// Those are compared as rationals. All others differ, so that intervals of growing precision
// separate them.
int compare_angle(const Rational& signed_square, const Rational& degrees);

// Doubles that enclose a number.
struct DoubleRange {
  double low, high;
};
// Around the signed square of an angle of so many degrees. Requires: degrees from 0 to 180.
DoubleRange signed_square_of_degrees(const Rational& degrees);

// The angle in degrees, correctly rounded, as to_decimal writes numbers. Requires: a signed square
// from −1 to 1.
std::string degrees_to_decimal(const Rational& signed_square);

// α + β − 180 in degrees, likewise, of two angles with these signed squares.
std::string excess_in_degrees(const Rational& alpha, const Rational& beta);

}  // namespace circumspect
