#include "kernel/exact/int64.hpp"

#include <cstddef>
#include <limits>

#include <gmp.h>

namespace circumspect {

std::optional<std::int64_t> to_int64(const Integer& value) {
  constexpr std::size_t kBits = std::numeric_limits<std::int64_t>::digits;
  const bool is_least = value == -to_integer(std::uint64_t{1} << kBits);
  if (bit_length(value) > kBits && !is_least) return std::nullopt;
  std::uint64_t size = 0;
  mpz_export(&size, nullptr, -1, sizeof size, 0, 0, value.get_mpz_t());
  return static_cast<std::int64_t>(sign(value) < 0 ? 0 - size : size);
}

}  // namespace circumspect
