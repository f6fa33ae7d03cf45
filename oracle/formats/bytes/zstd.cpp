#include "oracle/formats/bytes/zstd.hpp"

#ifdef CIRCUMSPECT_ZSTD
#include <algorithm>
#include <memory>

#include <zstd.h>
#endif

namespace circumspect::formats {

#ifdef CIRCUMSPECT_ZSTD

Result<std::string> unpack_zstd(const Source& source, std::size_t most) {
  const auto fail = [&](std::string expected, std::string found) {
    return tl::unexpected(FormatError{source.name, 0, std::move(expected), std::move(found)});
  };
  const std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context(ZSTD_createDCtx(),
                                                                        ZSTD_freeDCtx);
  if (!context) return fail("memory to unpack it", "none");
  constexpr std::size_t kStep = std::size_t{1} << 16U;
  std::string text;
  ZSTD_inBuffer packed = {source.text.data(), source.text.size(), 0};
  ZSTD_outBuffer made = {nullptr, 0, 0};
  while (true) {
    if (made.pos == text.size()) text.resize(std::min(2 * text.size() + kStep, most + 1));
    made.dst = text.data();
    made.size = text.size();
    const std::size_t hint = ZSTD_decompressStream(context.get(), &made, &packed);
    if (ZSTD_isError(hint) != 0) {
      return fail("data that zstd packed", "a fault before byte " + std::to_string(packed.pos) +
                                               ": " + ZSTD_getErrorName(hint));
    }
    if (made.pos > most) {
      return fail("at most " + std::to_string(most) + " bytes in a packed file of " +
                      std::to_string(source.text.size()),
                  "more (unpack it first)");
    }
    const bool is_at_end = packed.pos == packed.size && made.pos < made.size;
    if (is_at_end && hint == 0) break;
    if (is_at_end) return fail("the end of the packed data", "the end of the file");
  }
  text.resize(made.pos);
  return text;
}

std::string version_of_zstd() { return ZSTD_versionString(); }

#else

Result<std::string> unpack_zstd(const Source& source, std::size_t /*most*/) {
  return tl::unexpected(
      FormatError{source.name, 0, "a file that is not packed, or packed by gzip",
                  "one that zstd packed (unpack it first by zstd -d, or build Circumspect where "
                  "Debian's libzstd-dev is installed)"});
}

std::string version_of_zstd() { return ""; }

#endif

}  // namespace circumspect::formats
