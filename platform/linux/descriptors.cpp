#include "platform/posix/descriptors.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace circumspect::platform {

// It gets a name through its entry in /proc.
int open_unnamed(const std::string& folder) {
  if (access("/proc/self/fd", X_OK) != 0) return -1;
  return open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
}

bool name_unnamed(int descriptor, const std::string& name) {
  const std::string own = "/proc/self/fd/" + std::to_string(descriptor);
  return linkat(AT_FDCWD, own.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

bool open_pipe(int (&ends)[2]) { return pipe2(ends, O_CLOEXEC) == 0; }

void advise_large_pages(void* begin, std::size_t bytes) { madvise(begin, bytes, MADV_HUGEPAGE); }

}  // namespace circumspect::platform
