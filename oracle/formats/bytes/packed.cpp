#include "oracle/formats/bytes/packed.hpp"

#include <algorithm>
#include <array>
#include <exception>
#include <utility>

#include <zlib.h>

#include "oracle/formats/bytes/zstd.hpp"

namespace circumspect::formats {
namespace {

constexpr std::array<std::string_view, 2> kEndings = {".gz", ".zst"};
constexpr std::string_view kMagic = "\x1f\x8b";

// zlib packs bytes that are all equal into a thousandth, and numbers of meshes into a third; fields
// of zeros beside them are why a file may be packed better.
constexpr std::size_t kSmallFile = 1'000'000;
constexpr std::size_t kLargestGrowth = 200;

std::size_t most_unpacked(const Source& source) {
  return std::max(kSmallFile, source.text.size() * kLargestGrowth);
}

class Inflater {
 public:
  explicit Inflater(const Source& source) : source_(source), rest_(source.text) {
    constexpr int kGzipAlone = 16;
    is_ready_ = inflateInit2(&stream_, MAX_WBITS + kGzipAlone) == Z_OK;
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  Result<std::string> unpack();

 private:
  // Unpacks into so many bytes from `to` on; returns how many are still free.
  std::size_t unpack_into(char* to, std::size_t room);
  tl::unexpected<FormatError> fail(std::string expected, std::string found) const {
    return tl::unexpected(FormatError{source_.name, 0, std::move(expected), std::move(found)});
  }

  const Source& source_;
  std::string_view rest_;
  z_stream stream_ = {};
  bool is_ready_ = false;
  int status_ = Z_OK;
};

std::size_t Inflater::unpack_into(char* to, std::size_t room) {
  constexpr std::size_t kMost = std::size_t{1} << 30U;  // zlib counts in 32 bits
  stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(rest_.data()));
  stream_.avail_in = static_cast<uInt>(std::min(rest_.size(), kMost));
  stream_.next_out = reinterpret_cast<Bytef*>(to);
  stream_.avail_out = static_cast<uInt>(std::min(room, kMost));
  const std::size_t given = stream_.avail_in;
  const std::size_t offered = stream_.avail_out;
  status_ = inflate(&stream_, Z_NO_FLUSH);
  rest_.remove_prefix(given - stream_.avail_in);
  return room - (offered - stream_.avail_out);
}

// Several packed files may follow one another: together they are one. Zeros may pad the last.
Result<std::string> Inflater::unpack() {
  constexpr std::size_t kStep = std::size_t{1} << 16U;
  const std::size_t most = most_unpacked(source_);
  std::string text;
  std::size_t size = 0;
  if (!is_ready_) return fail("memory to unpack it", "none");
  while (true) {
    if (text.size() == size) text.resize(std::min(2 * size + kStep, most + 1));
    size = text.size() - unpack_into(text.data() + size, text.size() - size);
    if (size > most) {
      return fail("at most " + std::to_string(most) + " bytes in a packed file of " +
                      std::to_string(source_.text.size()),
                  "more (unpack it first)");
    }
    if (status_ == Z_STREAM_END) {
      if (rest_.find_first_not_of('\0') == std::string_view::npos) break;
      if (!rest_.starts_with(kMagic)) return fail("the end of the packed data", "more bytes");
      if (inflateReset(&stream_) != Z_OK) break;
    } else if (status_ == Z_BUF_ERROR && rest_.empty()) {
      return fail("the end of the packed data", "the end of the file");
    } else if (status_ != Z_OK && status_ != Z_BUF_ERROR) {
      return fail("data that gzip packed",
                  "a fault at byte " + std::to_string(source_.text.size() - rest_.size()));
    }
  }
  text.resize(size);
  return text;
}

}  // namespace

std::string_view name_inside(std::string_view path) {
  for (const std::string_view ending : kEndings) {
    if (path.size() <= ending.size() || !path.ends_with(ending)) continue;
    path.remove_suffix(ending.size());
    break;
  }
  return path;
}

std::string packed_or_not(const std::string& path) {
  if (exists(path)) return path;
  for (const std::string_view ending : kEndings) {
    std::string packed = path + std::string(ending);
    if (exists(packed)) return packed;
  }
  return path;
}

Result<Source> load_unpacked(const std::string& path) {
  Result<Source> source = load(path);
  if (!source) return source;
  const bool is_zstd = source->text.starts_with(kZstdMagic);
  if (!is_zstd && !source->text.starts_with(kMagic)) return source;
  try {
    Result<std::string> text =
        is_zstd ? unpack_zstd(*source, most_unpacked(*source)) : Inflater(*source).unpack();
    if (!text) return tl::unexpected(text.error());
    source->text = std::move(*text);
    return source;
  } catch (const std::exception&) {  // std::bad_alloc
    return tl::unexpected(
        FormatError{source->name, 0, "a file that fits into memory", "a larger one"});
  }
}

}  // namespace circumspect::formats
