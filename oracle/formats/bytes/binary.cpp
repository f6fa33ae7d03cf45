#include "oracle/formats/bytes/binary.hpp"

#include <bit>
#include <cmath>

namespace circumspect::formats {

bool Bytes::skip(std::size_t count) {
  if (count > rest_.size()) return false;
  rest_.remove_prefix(count);
  return true;
}

std::optional<std::uint64_t> Bytes::unsigned_integer(std::size_t size) {
  if (size > rest_.size()) return std::nullopt;
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t place = order_ == ByteOrder::kBigEndian ? i : size - 1 - i;
    value = value << 8U | static_cast<unsigned char>(rest_[place]);
  }
  rest_.remove_prefix(size);
  return value;
}

std::int64_t as_signed(std::uint64_t bits, std::size_t size) {
  const std::size_t unused = 8 * (8 - size);
  return static_cast<std::int64_t>(bits << unused) >> unused;
}

double double_of_bits(std::uint64_t bits, std::size_t size) {
  return size == 4 ? std::bit_cast<float>(static_cast<std::uint32_t>(bits))
                   : std::bit_cast<double>(bits);
}

std::optional<Rational> as_floating(std::uint64_t bits, std::size_t size) {
  const double value = double_of_bits(bits, size);
  if (!std::isfinite(value)) return std::nullopt;
  return exact_value(value);
}

}  // namespace circumspect::formats
