// The bytes of a binary file, taken from the front: nothing beyond the end is ever touched.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "reference/kernel/exact/number.hpp"

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

// The exact value of an IEEE number of 4 or 8 bytes; none if it is not finite.
std::optional<Rational> as_floating(std::uint64_t bits, std::size_t size);

}  // namespace circumspect::formats
