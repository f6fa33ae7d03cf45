#include "oracle/formats/bytes/source.hpp"

#include <cerrno>
#include <cstring>
#include <exception>
#include <system_error>
#include <utility>

#include "oracle/model/printable.hpp"
#include "platform/files.hpp"

namespace circumspect::formats {

std::string FormatError::to_string() const {
  const std::string place = line == 0 ? file : file + ":" + std::to_string(line);
  return on_one_line(place + ": expected " + expected + ", found " + found);
}

std::string quote(std::string_view bytes) {
  std::string text = "\"";
  for (const char c : bytes.substr(0, kLongestQuote)) {
    if (c >= ' ' && c <= '~') {
      text += c;
    } else {
      append_escaped(text, c);
    }
  }
  if (bytes.size() > kLongestQuote) text += "...";
  return text + "\"";
}

std::string shortened(std::string_view bytes) {
  return std::string(bytes.substr(0, kLongestQuote)) + (bytes.size() > kLongestQuote ? "..." : "");
}

namespace {

// An open file that closes itself; standard input stays open.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ > platform::kStandardInput) platform::close_file(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

tl::unexpected<FormatError> system_error(const std::string& name, int error) {
  switch (error) {
    case ENOENT:
    case ENOTDIR:
      return tl::unexpected(FormatError{name, 0, "a file", "no file of that name"});
    case EACCES:
    case EPERM:
      return tl::unexpected(FormatError{name, 0, "a file to read", "no permission to read it"});
    default:
      return tl::unexpected(FormatError{name, 0, "a file to read",
                                        "an error: " + std::generic_category().message(error)});
  }
}

// Devices are refused because some of them, such as /dev/zero, never end.
Status check_kind(const std::string& name, platform::FileKind found) {
  if (found == platform::FileKind::kRegular || found == platform::FileKind::kPipe) return {};
  const std::string kind = found == platform::FileKind::kFolder ? "a directory" : "a device";
  return tl::unexpected(FormatError{name, 0, "a file", kind});
}

// `expected`: how many bytes there should be, if that is known; there may be more or fewer.
Result<std::string> read_all(const std::string& name, int descriptor, std::size_t expected) {
  constexpr std::size_t kStep = std::size_t{1} << 12;
  std::string text(expected + 1, '\0');  // the last one finds that the file has ended
  std::size_t size = 0;
  while (true) {
    if (text.size() == size) text.resize(2 * size + kStep);
    const std::ptrdiff_t count =
        platform::read_some(descriptor, text.data() + size, text.size() - size);
    if (count < 0) return system_error(name, errno);
    if (count == 0) break;
    size += static_cast<std::size_t>(count);
  }
  text.resize(size);
  return text;
}

}  // namespace

Result<Source> load(const std::string& path) {
  const bool is_stdin = path == "-";
  const std::string name = is_stdin ? std::string(kStandardInputName) : path;
  std::size_t expected = 0;
  if (!is_stdin) {
    // Asked before opening, since to open a device can already have an effect.
    const auto status = platform::status_of(path);
    if (!status) return system_error(name, errno);
    if (Status kind = check_kind(name, status->kind); !kind) return tl::unexpected(kind.error());
    if (status->kind == platform::FileKind::kRegular) expected = status->size;
  }
  const Descriptor file(is_stdin ? platform::kStandardInput : platform::open_to_read(path));
  if (file.number() < 0) return system_error(name, errno);
  try {
    Result<std::string> text = read_all(name, file.number(), expected);
    if (!text) return tl::unexpected(text.error());
    return Source{name, std::move(*text)};
  } catch (const std::exception&) {  // std::bad_alloc, or std::length_error
    return tl::unexpected(FormatError{name, 0, "a file that fits into memory", "a larger one"});
  }
}

bool exists(const std::string& path) { return platform::status_of(path).has_value(); }

bool is_folder(const std::string& path) {
  const auto status = platform::status_of(path);
  return status && status->kind == platform::FileKind::kFolder;
}

bool is_regular(const std::string& path) {
  const auto status = platform::status_of(path);
  return status && status->kind == platform::FileKind::kRegular;
}

std::optional<RandomAccess> RandomAccess::open(const std::string& path) {
  // Asked before opening, since to open a device can already have an effect.
  if (!is_regular(path)) return std::nullopt;
  const int descriptor = platform::open_to_read(path);
  if (descriptor < 0) return std::nullopt;
  RandomAccess file(descriptor, 0);
  const auto status = platform::status_of(descriptor);
  if (!status || status->kind != platform::FileKind::kRegular) return std::nullopt;
  file.size_ = status->size;
  return file;
}

RandomAccess::RandomAccess(RandomAccess&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), text_(other.text_), size_(other.size_) {}

RandomAccess::~RandomAccess() {
  if (descriptor_ >= 0) platform::close_file(descriptor_);
}

bool RandomAccess::read(std::size_t offset, std::size_t count, char* to) const {
  if (offset > size_ || count > size_ - offset) return false;
  if (descriptor_ < 0) {
    if (count > 0) std::memcpy(to, text_.data() + offset, count);
    return true;
  }
  while (count > 0) {
    const std::ptrdiff_t got = platform::read_some_at(descriptor_, to, count, offset);
    if (got <= 0) return false;
    offset += static_cast<std::size_t>(got);
    count -= static_cast<std::size_t>(got);
    to += got;
  }
  return true;
}

}  // namespace circumspect::formats
