// The bytes of a binary file, read from the front; nothing beyond the end is ever touched.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

#include "kernel/exact/number.hpp"

namespace circumspect::formats {

enum class ByteOrder { kLittleEndian, kBigEndian };

class Bytes {
 public:
  explicit Bytes(std::string_view bytes, ByteOrder order) : rest_(bytes), order_(order) {}

  std::size_t left() const { return rest_.size(); }
  // False if there are not as many.
  bool skip(std::size_t count);
  // An unsigned integer of 1, 2, 4 or 8 bytes; none if there are not as many.
  std::optional<std::uint64_t> unsigned_integer(std::size_t size);

 private:
  std::string_view rest_;
  ByteOrder order_;
};

// The same bits as a number in two's complement.
std::int64_t as_signed(std::uint64_t bits, std::size_t size);

// The IEEE number of 4 or 8 bytes.
double double_of_bits(std::uint64_t bits, std::size_t size);
// Its exact value; none if it is not finite.
std::optional<Rational> as_floating(std::uint64_t bits, std::size_t size);

// The number of these bytes, from the front.
template <class Stored>
Stored stored_number(const char* from, bool is_swapped) {
  Stored value;
  std::memcpy(&value, from, sizeof value);
  if constexpr (sizeof value == 2) {
    if (is_swapped)
      value = std::bit_cast<Stored>(__builtin_bswap16(std::bit_cast<std::uint16_t>(value)));
  } else if constexpr (sizeof value == 4) {
    if (is_swapped)
      value = std::bit_cast<Stored>(__builtin_bswap32(std::bit_cast<std::uint32_t>(value)));
  } else if constexpr (sizeof value == 8) {
    if (is_swapped)
      value = std::bit_cast<Stored>(__builtin_bswap64(std::bit_cast<std::uint64_t>(value)));
  }
  return value;
}

inline bool is_swapped(ByteOrder order) {
  return (order == ByteOrder::kBigEndian) != (std::endian::native == std::endian::big);
}

}  // namespace circumspect::formats
