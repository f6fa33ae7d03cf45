#include "platform/terminal.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "platform/files.hpp"

namespace circumspect::platform {

bool is_terminal(int descriptor) { return isatty(descriptor) != 0; }

bool shows_colours(int descriptor) {
  const char* const terminal = std::getenv("TERM");
  return is_terminal(descriptor) && terminal != nullptr && std::strcmp(terminal, "dumb") != 0;
}

std::size_t terminal_width(int descriptor) {
  winsize size{};
  return ioctl(descriptor, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

char** arguments(int& /*argc*/, char** argv) { return argv; }

void prepare_standard_files() {
  for (const int file : {kStandardInput, kStandardOutput, kStandardError}) {
    if (fcntl(file, F_GETFD) >= 0 || errno != EBADF) continue;
    // Opened the wrong way round, so that reading from it or writing to it still fails.
    const int opened = open("/dev/null", file == kStandardInput ? O_WRONLY : O_RDONLY);
    if (opened >= 0 && opened != file) close(opened);
  }
}

}  // namespace circumspect::platform
