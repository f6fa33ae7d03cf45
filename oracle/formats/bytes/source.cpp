#include "oracle/formats/bytes/source.hpp"

#include <cerrno>
#include <cstring>
#include <exception>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "oracle/model/printable.hpp"

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

// ---- Source ----

namespace {

// An open file that closes itself; standard input stays open.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ > STDIN_FILENO) close(number_);
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
Status check_kind(const std::string& name, const struct stat& status) {
  if (S_ISREG(status.st_mode) || S_ISFIFO(status.st_mode)) return {};
  const std::string kind = S_ISDIR(status.st_mode) ? "a directory" : "a device";
  return tl::unexpected(FormatError{name, 0, "a file", kind});
}

// `expected`: how many bytes there should be, if that is known; there may be more or fewer.
Result<std::string> read_all(const std::string& name, int descriptor, std::size_t expected) {
  constexpr std::size_t kStep = std::size_t{1} << 12;
  std::string text(expected + 1, '\0');  // the last one finds that the file has ended
  std::size_t size = 0;
  while (true) {
    if (text.size() == size) text.resize(2 * size + kStep);
    const ssize_t count = ::read(descriptor, text.data() + size, text.size() - size);
    if (count < 0 && errno == EINTR) continue;
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
  const std::string name = is_stdin ? "<stdin>" : path;
  struct stat status = {};
  if (!is_stdin) {
    // Asked before opening, since to open a device can already have an effect.
    if (stat(path.c_str(), &status) != 0) return system_error(name, errno);
    if (Status kind = check_kind(name, status); !kind) return tl::unexpected(kind.error());
  }
  const Descriptor file(is_stdin ? STDIN_FILENO : open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.number() < 0) return system_error(name, errno);
  try {
    const bool is_known = S_ISREG(status.st_mode) && status.st_size > 0;
    Result<std::string> text =
        read_all(name, file.number(), is_known ? static_cast<std::size_t>(status.st_size) : 0);
    if (!text) return tl::unexpected(text.error());
    return Source{name, std::move(*text)};
  } catch (const std::exception&) {  // std::bad_alloc, or std::length_error
    return tl::unexpected(FormatError{name, 0, "a file that fits into memory", "a larger one"});
  }
}

bool exists(const std::string& path) {
  struct stat status = {};
  return stat(path.c_str(), &status) == 0;
}

bool is_folder(const std::string& path) {
  struct stat status = {};
  return stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode);
}

bool is_regular(const std::string& path) {
  struct stat status = {};
  return stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

// ---- Random access ----

std::optional<RandomAccess> RandomAccess::open(const std::string& path) {
  // Asked before opening, since to open a device can already have an effect.
  struct stat status = {};
  if (stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return std::nullopt;
  RandomAccess file(descriptor, 0);
  if (fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  file.size_ = static_cast<std::size_t>(status.st_size);
  return file;
}

RandomAccess::RandomAccess(RandomAccess&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), text_(other.text_), size_(other.size_) {}

RandomAccess::~RandomAccess() {
  if (descriptor_ >= 0) close(descriptor_);
}

bool RandomAccess::read(std::size_t offset, std::size_t count, char* to) const {
  if (offset > size_ || count > size_ - offset) return false;
  if (descriptor_ < 0) {
    if (count > 0) std::memcpy(to, text_.data() + offset, count);
    return true;
  }
  while (count > 0) {
    const ssize_t got = pread(descriptor_, to, count, static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    offset += static_cast<std::size_t>(got);
    count -= static_cast<std::size_t>(got);
    to += got;
  }
  return true;
}

}  // namespace circumspect::formats
