#include "oracle/formats/lz4.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace circumspect::formats {
namespace {

constexpr std::size_t kLongest = 15;  // a length that goes on in further bytes
constexpr std::size_t kShortestMatch = 4;

// Takes bytes from the front of a block.
class Taken {
 public:
  explicit Taken(std::string_view block) : rest_(block) {}

  bool is_empty() const { return rest_.empty(); }
  std::optional<std::string_view> bytes(std::size_t count) {
    if (count > rest_.size()) return std::nullopt;
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }
  std::optional<std::size_t> byte() {
    const auto taken = bytes(1);
    if (!taken) return std::nullopt;
    return static_cast<unsigned char>(taken->front());
  }
  // A length whose first four bits are known: each further byte adds to it, and 255 goes on.
  std::optional<std::size_t> length(std::size_t bits) {
    std::size_t length = bits;
    std::optional<std::size_t> more = bits == kLongest ? byte() : std::size_t{0};
    while (more == std::size_t{255}) {
      length += 255;
      more = byte();
    }
    return more ? std::optional(length + *more) : std::nullopt;
  }

 private:
  std::string_view rest_;
};

}  // namespace

bool unpack_lz4(std::string_view block, std::span<char> to) {
  Taken taken(block);
  std::size_t made = 0;
  while (const auto token = taken.byte()) {
    const auto literals = taken.length(*token >> 4U);
    const auto copied = literals ? taken.bytes(*literals) : std::nullopt;
    if (!copied || copied->size() > to.size() - made) return false;
    std::copy(copied->begin(), copied->end(), to.data() + made);
    made += copied->size();
    if (taken.is_empty()) return made == to.size();
    const auto low = taken.byte();
    const auto high = taken.byte();
    const auto match = taken.length(*token & kLongest);
    if (!high || !match) return false;
    const std::size_t back = *low | *high << 8U;
    if (back == 0 || back > made || *match > to.size() - made ||
        kShortestMatch > to.size() - made - *match) {
      return false;
    }
    // What is copied may be what was made just before.
    for (std::size_t i = *match + kShortestMatch; i > 0; --i, ++made) to[made] = to[made - back];
  }
  return false;
}

}  // namespace circumspect::formats
