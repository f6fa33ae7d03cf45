#include "inputs/scalars.hpp"

#include <cmath>

namespace circumspect::generators {

rc::Gen<long> below(long count) {
  return rc::gen::resize(rc::kNominalSize, rc::gen::inRange<long>(0, count));
}

rc::Gen<long> integer_within(long bound) {
  // 0, 1, −1, 2, −2, …: RapidCheck shrinks the place in this row towards 0.
  return rc::gen::map(below(2 * bound + 1),
                      [](long place) { return place % 2 == 0 ? -place / 2 : (place + 1) / 2; });
}

rc::Gen<Rational> integer_number(long bound) {
  return rc::gen::map(integer_within(bound), [](long value) { return Rational(value); });
}

rc::Gen<Rational> small_rational() {
  return rc::gen::map(rc::gen::pair(integer_within(12), below(6)),
                      [](const std::pair<long, long>& parts) {
                        Rational value(parts.first, parts.second + 1);
                        value.canonicalize();
                        return value;
                      });
}

rc::Gen<Rational> dyadic_number() {
  const long largest_mantissa = 1L << 53;
  return rc::gen::map(rc::gen::pair(integer_within(largest_mantissa), below(61)),
                      [](const std::pair<long, long>& parts) {
                        const auto mantissa = static_cast<double>(parts.first);
                        return exact_value(std::ldexp(mantissa, -static_cast<int>(parts.second)));
                      });
}

rc::Gen<Rational> extreme_number() {
  return rc::gen::map(rc::gen::pair(integer_within(3), integer_within(300)),
                      [](const std::pair<long, long>& parts) {
                        const auto mantissa = static_cast<double>(parts.first);
                        return exact_value(std::ldexp(mantissa, static_cast<int>(parts.second)));
                      });
}

rc::Gen<std::vector<Rational>> small_weights(std::size_t count) {
  return rc::gen::container<std::vector<Rational>>(count, small_rational());
}

}  // namespace circumspect::generators
