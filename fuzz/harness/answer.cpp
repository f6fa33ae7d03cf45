#include "fuzz/harness/answer.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <optional>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace circumspect::harness {
namespace {

using Clock = std::chrono::steady_clock;

// More than any mesh of the harness's inputs needs; a child that sends more is broken.
constexpr std::size_t kMostBytes = std::size_t{64} << 20;

// What the child sends: 'a' and the rows, each preceded by its length; or 'x' and the text of an
// exception.
std::string message(const Answer& answer) {
  if (!answer.failure.empty()) return "x" + answer.text;
  std::string bytes = "a";
  const auto append = [&bytes](std::int64_t value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
  };
  append(static_cast<std::int64_t>(answer.simplices.size()));
  for (const auto& simplex : answer.simplices) {
    append(static_cast<std::int64_t>(simplex.size()));
    for (const std::int64_t v : simplex) append(v);
  }
  return bytes;
}

// Reads the numbers of a message one after the other.
class Numbers {
 public:
  explicit Numbers(const std::string& bytes) : bytes_(bytes) {}

  std::optional<std::int64_t> next() {
    std::int64_t value = 0;
    if (bytes_.size() - place_ < sizeof value) return std::nullopt;
    std::memcpy(&value, bytes_.data() + place_, sizeof value);
    place_ += sizeof value;
    return value;
  }
  bool at_end() const { return place_ == bytes_.size(); }

 private:
  const std::string& bytes_;
  std::size_t place_ = 1;  // after the kind
};

// The rows, if the message is whole.
std::optional<SimplexArray> rows(const std::string& bytes) {
  Numbers numbers(bytes);
  const auto count = numbers.next();
  if (!count || *count < 0) return std::nullopt;
  SimplexArray simplices;
  for (std::int64_t i = 0; i < *count; ++i) {
    const auto length = numbers.next();
    if (!length || *length < 0) return std::nullopt;
    simplices.emplace_back();
    for (std::int64_t k = 0; k < *length; ++k) {
      const auto v = numbers.next();
      if (!v) return std::nullopt;
      simplices.back().push_back(*v);
    }
  }
  if (!numbers.at_end()) return std::nullopt;
  return simplices;
}

void write_all(int file, const std::string& bytes) {
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t count = write(file, bytes.data() + sent, bytes.size() - sent);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return;
    sent += static_cast<std::size_t>(count);
  }
}

enum class Reading { kEnd, kTimeLimit, kTooMuch };

Reading read_until(int file, Clock::time_point deadline, std::string& bytes) {
  char block[65536];
  while (true) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return Reading::kTimeLimit;
    pollfd waiting{file, POLLIN, 0};
    if (poll(&waiting, 1, static_cast<int>(std::min<long long>(left, 1000))) <= 0) continue;
    const ssize_t count = read(file, block, sizeof block);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return Reading::kEnd;
    bytes.append(block, static_cast<std::size_t>(count));
    if (bytes.size() > kMostBytes) return Reading::kTooMuch;
  }
}

Answer understood(const std::string& bytes, int status) {
  if (WIFSIGNALED(status)) return {{}, "signal " + std::to_string(WTERMSIG(status)), ""};
  if (!bytes.empty() && bytes.front() == 'x') return {{}, "crash", bytes.substr(1)};
  if (!bytes.empty() && bytes.front() == 'a') {
    if (auto simplices = rows(bytes)) return {std::move(*simplices), "", ""};
  }
  return {{}, "exit " + std::to_string(WEXITSTATUS(status)), ""};
}

// In the child: hands the answer to the parent, and ends.
[[noreturn]] void answer_to_parent(int file, const Triangulator& subject,
                                   const PointArray& points) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  // A test framework's handlers would report the crash as that of the test.
  for (const int number : {SIGSEGV, SIGABRT, SIGFPE, SIGILL, SIGBUS, SIGTERM}) {
    signal(number, SIG_DFL);
  }
  write_all(file, message(answer(subject, points)));
  _exit(0);
}

// Kills the child and what it started.
void kill_all_of(pid_t child) {
  kill(-child, SIGKILL);
  kill(child, SIGKILL);  // its group may not exist yet
}

int reaped(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

// The status with which the child ended; nothing if it outlives the deadline and is killed. A child
// may close its end of the pipe and go on.
std::optional<int> status_of(pid_t child, Clock::time_point deadline) {
  auto pause = std::chrono::microseconds(20);
  while (true) {
    siginfo_t ended{};
    const int found = waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT);
    if (found == 0 && ended.si_pid == child) {
      // Until it is reaped, its ID is not reused: kill what it left behind, if anything.
      kill(-child, SIGKILL);
      return reaped(child);
    }
    if (Clock::now() >= deadline) break;
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, std::chrono::microseconds(10'000));
  }
  kill_all_of(child);
  reaped(child);
  return std::nullopt;
}

}  // namespace

Answer answer(const Triangulator& subject, const PointArray& points) {
  try {
    return {subject(points), "", ""};
  } catch (const std::exception& error) {
    return {{}, "crash", error.what()};
  } catch (...) {
    return {{}, "crash", "something was thrown that is not a std::exception"};
  }
}

Answer isolated_answer(const Triangulator& subject, const PointArray& points,
                       std::chrono::milliseconds time_limit) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  // Otherwise both would write the buffered output.
  std::cout.flush();
  std::fflush(nullptr);
  const Clock::time_point deadline = Clock::now() + time_limit;
  const pid_t child = fork();
  if (child < 0) {
    close(ends[0]);
    close(ends[1]);
    throw std::system_error(errno, std::generic_category(), "fork");
  }
  if (child == 0) {
    close(ends[0]);
    answer_to_parent(ends[1], subject, points);
  }
  close(ends[1]);
  std::string bytes;
  const Reading reading = read_until(ends[0], deadline, bytes);
  close(ends[0]);
  if (reading != Reading::kEnd) kill_all_of(child);
  const std::optional<int> status = status_of(child, deadline);
  if (reading == Reading::kTooMuch) return {{}, "too-much-output", ""};
  if (reading == Reading::kTimeLimit || !status) return {{}, "hang", ""};
  return understood(bytes, *status);
}

}  // namespace circumspect::harness
