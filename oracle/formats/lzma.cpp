#include "oracle/formats/lzma.hpp"

#ifdef CIRCUMSPECT_LZMA
#include <cstddef>
#include <cstdint>

#include <lzma.h>
#endif

namespace circumspect::formats {

#ifdef CIRCUMSPECT_LZMA

namespace {

bool unpack_lzma(std::string_view block, std::span<char> to) {
  std::uint64_t memory = std::uint64_t{1} << 27U;
  std::size_t taken = 0;
  std::size_t made = 0;
  return lzma_stream_buffer_decode(&memory, 0, nullptr,
                                   reinterpret_cast<const std::uint8_t*>(block.data()), &taken,
                                   block.size(), reinterpret_cast<std::uint8_t*>(to.data()), &made,
                                   to.size()) == LZMA_OK &&
         taken == block.size() && made == to.size();
}

}  // namespace

UnpackBlock lzma_unpacker() { return unpack_lzma; }
std::string version_of_lzma() { return lzma_version_string(); }

#else

UnpackBlock lzma_unpacker() { return nullptr; }
std::string version_of_lzma() { return ""; }

#endif

}  // namespace circumspect::formats
