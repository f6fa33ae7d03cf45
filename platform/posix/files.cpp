#include "platform/files.hpp"

#include <cerrno>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace circumspect::platform {
namespace {

FileStatus from_system(const struct stat& status) {
  return {.kind = S_ISREG(status.st_mode)    ? FileKind::kRegular
                  : S_ISFIFO(status.st_mode) ? FileKind::kPipe
                  : S_ISDIR(status.st_mode)  ? FileKind::kFolder
                                             : FileKind::kDevice,
          .size = status.st_size > 0 ? static_cast<std::size_t>(status.st_size) : 0,
          .device = static_cast<std::uint64_t>(status.st_dev),
          .number = static_cast<std::uint64_t>(status.st_ino)};
}

}  // namespace

const std::string_view kSeparators = "/";

bool is_relative(std::string_view path) { return !path.starts_with('/'); }

std::filesystem::path path_of(const std::string& text) { return text; }

std::optional<FileStatus> status_of(const std::string& path) {
  struct stat status = {};
  if (stat(path.c_str(), &status) != 0) return std::nullopt;
  return from_system(status);
}

std::optional<FileStatus> status_of(int descriptor) {
  struct stat status = {};
  if (fstat(descriptor, &status) != 0) return std::nullopt;
  return from_system(status);
}

int open_to_read(const std::string& path) { return open(path.c_str(), O_RDONLY | O_CLOEXEC); }

void close_file(int descriptor) { close(descriptor); }

std::ptrdiff_t read_some(int descriptor, char* to, std::size_t count) {
  while (true) {
    const ssize_t got = read(descriptor, to, count);
    if (got >= 0 || errno != EINTR) return got;
  }
}

std::ptrdiff_t write_some(int descriptor, const char* from, std::size_t count) {
  while (true) {
    const ssize_t put = write(descriptor, from, count);
    if (put >= 0 || errno != EINTR) return put;
  }
}

std::ptrdiff_t read_some_at(int descriptor, char* to, std::size_t count, std::size_t offset) {
  while (true) {
    const ssize_t got = pread(descriptor, to, count, static_cast<off_t>(offset));
    if (got >= 0 || errno != EINTR) return got;
  }
}

bool put_on_disk(int descriptor) { return fsync(descriptor) == 0; }

}  // namespace circumspect::platform
