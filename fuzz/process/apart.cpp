#include "fuzz/process/apart.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <fstream>
#include <new>
#include <stdexcept>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace circumspect::campaign {
namespace {

using Clock = std::chrono::steady_clock;

// The bytes that this process already has: sanitizers reserve terabytes.
rlim_t address_space() {
  rlim_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

// The life of the child. It keeps no file of its parent open, because otherwise a supervisor would
// not notice the parent's death. It prints nothing.
[[noreturn]] void compute_and_end(const std::function<std::string()>& compute, int answer,
                                  std::uint64_t memory, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  const int null = open("/dev/null", O_RDWR);
  for (int file = 0; file < 3; ++file) dup2(null, file);
  const int own = 3;
  if (answer != own) dup2(answer, own);
  close_range(own + 1, ~0U, 0);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) signal(number, SIG_IGN);
  const rlim_t most = address_space() + memory;
  const rlimit limit = {most, most};
  if (memory != 0) setrlimit(RLIMIT_AS, &limit);
  try {
    const std::string text = compute();
    for (std::size_t at = 0; at < text.size();) {
      const ssize_t count = write(own, text.data() + at, text.size() - at);
      if (count < 0 && errno != EINTR) _exit(1);
      at += static_cast<std::size_t>(std::max<ssize_t>(count, 0));
    }
  } catch (const std::bad_alloc&) {
    _exit(kOutOfMemory);
  } catch (...) {
    _exit(1);
  }
  _exit(0);
}

class Child {
 public:
  explicit Child(pid_t number) : number_(number) {}
  ~Child() {
    if (number_ > 0) kill(number_, SIGKILL);
    status();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  // Waits for its end.
  int status() {
    while (number_ > 0 && waitpid(number_, &status_, 0) < 0 && errno == EINTR) {
    }
    number_ = -1;
    return status_;
  }

 private:
  pid_t number_;
  int status_ = 0;
};

// Reads everything that the child writes. kDone: it wrote everything.
Apart read_answer(int file, Clock::time_point end, const std::atomic<bool>& stop) {
  constexpr double kTick = 0.05;  // seconds between two looks at `stop`
  Apart apart;
  while (true) {
    const double left = std::chrono::duration<double>(end - Clock::now()).count();
    if (stop) return {Apart::End::kInterrupted, {}};
    if (left <= 0) return {Apart::End::kTimeLimit, {}};
    pollfd waited = {file, POLLIN, 0};
    if (poll(&waited, 1, static_cast<int>(std::ceil(std::min(left, kTick) * 1000))) <= 0) continue;
    char block[1 << 14];
    const ssize_t count = read(file, block, sizeof(block));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return apart;
    apart.text.append(block, static_cast<std::size_t>(count));
  }
}

}  // namespace

Apart computed_apart(const std::function<std::string()>& compute, double seconds,
                     std::uint64_t memory, const std::atomic<bool>& stop) {
  const auto limit = std::chrono::duration<double>(std::min(seconds, 1e9));
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(limit);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return {Apart::End::kDone, compute()};
  const pid_t parent = getpid();
  const pid_t number = fork();
  if (number == 0) compute_and_end(compute, ends[1], memory, parent);
  close(ends[1]);
  if (number < 0) {
    close(ends[0]);
    return {Apart::End::kDone, compute()};
  }
  Child child(number);
  Apart apart = read_answer(ends[0], end, stop);
  close(ends[0]);
  if (apart.end != Apart::End::kDone) return apart;
  const int status = child.status();
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return apart;
  // The kernel kills whatever takes most of the memory when there is none left.
  const bool wants_memory =
      WIFEXITED(status) ? WEXITSTATUS(status) == kOutOfMemory : WTERMSIG(status) == SIGKILL;
  if (wants_memory) return {Apart::End::kMemoryLimit, {}};
  throw std::runtime_error(WIFEXITED(status) ? "judging a mesh in a process apart failed"
                                             : "judging a mesh died of signal " +
                                                   std::to_string(WTERMSIG(status)));
}

}  // namespace circumspect::campaign
