// Written from Apple's manual pages, and never run.
#include "platform/posix/descriptors.hpp"

#include <cerrno>

#include <fcntl.h>
#include <unistd.h>

namespace circumspect::platform {

// There is no O_TMPFILE.
int open_unnamed(const std::string& /*folder*/) {
  errno = ENOTSUP;
  return -1;
}

bool name_unnamed(int /*descriptor*/, const std::string& /*name*/) {
  errno = ENOTSUP;
  return false;
}

// There is no pipe2. What is forked between the calls inherits the ends, and closes them when it
// ends: nothing waits for that.
bool open_pipe(int (&ends)[2]) {
  if (pipe(ends) != 0) return false;
  for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);
  return true;
}

// There is no madvise for it.
void advise_large_pages(void* /*begin*/, std::size_t /*bytes*/) {}

}  // namespace circumspect::platform
