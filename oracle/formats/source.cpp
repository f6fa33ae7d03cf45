#include "oracle/formats/source.hpp"

#include <cerrno>
#include <new>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace circumspect::formats {
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

Result<std::string> read_all(const std::string& name, int descriptor) {
  constexpr std::size_t kStep = std::size_t{1} << 12;
  std::string text;
  std::size_t size = 0;
  while (true) {
    if (text.size() < size + kStep) text.resize(2 * size + kStep);
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
    Result<std::string> text = read_all(name, file.number());
    if (!text) return tl::unexpected(text.error());
    return Source{name, std::move(*text)};
  } catch (const std::bad_alloc&) {
    return tl::unexpected(FormatError{name, 0, "a file that fits into memory", "a larger one"});
  }
}

bool exists(const std::string& path) {
  struct stat status = {};
  return stat(path.c_str(), &status) == 0;
}

bool is_regular(const std::string& path) {
  struct stat status = {};
  return stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

}  // namespace circumspect::formats
