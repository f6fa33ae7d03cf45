#include "oracle/formats/random_access.hpp"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace circumspect::formats {

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
