// From exact numbers to text.
#pragma once

#include <string>

#include "reference/exact/number.hpp"

namespace circumspect {

// The exact value, in lowest terms: "7", "-1/3".
std::string to_string(const Integer& value);
std::string to_string(const Rational& value);

// The shortest text that read_number(…, kDouble) turns back into exactly this value: a decimal if
// the value is a double, else a fraction.
std::string to_text_of_double_or_fraction(const Rational& value);

// Correctly rounded (to nearest, ties to even) to 53 bits and written as the shortest decimal that
// identifies that double; beyond the range of double, 17 significant digits. For people: never
// read back in a verdict.
std::string to_decimal(const Rational& value);

// The same for the square root of a value. Requires: value >= 0.
std::string square_root_to_decimal(const Rational& value);

// The number libraries in use, with their versions: "GMP 6.2.1, MPFR 4.2.0".
std::string number_libraries();

}  // namespace circumspect
