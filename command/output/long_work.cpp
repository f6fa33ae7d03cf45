#include "command/output/long_work.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "oracle/model/printable.hpp"

namespace circumspect::cli {
namespace {

constexpr double kLong = 2;         // seconds that nobody need hear of
constexpr int kBetweenLooks = 200;  // milliseconds
constexpr int kSignals[] = {SIGINT, SIGTERM};

std::atomic<int> received = 0;
std::atomic<int> wake_up = -1;  // the end of a pipe that the thread listens to
static_assert(std::atomic<int>::is_always_lock_free);

void wake() {
  const int pipe = wake_up;
  // If the pipe is full the thread is awake.
  if (pipe >= 0 && ::write(pipe, "", 1) < 0) return;
}

// Only what may be called in a handler.
void receive(int number) {
  const int before = errno;
  received = number;
  wake();
  errno = before;
}

void set_meaning(bool ours) {
  for (const int number : kSignals) {
    struct sigaction present {};
    if (sigaction(number, nullptr, &present) != 0) continue;
    // Who ignores a signal, or does something else about it, is not in our way.
    if (ours ? present.sa_handler != SIG_DFL : present.sa_handler != receive) continue;
    struct sigaction action {};
    action.sa_handler = ours ? receive : SIG_DFL;
    action.sa_flags = ours ? static_cast<int>(SA_RESETHAND | SA_RESTART) : 0;
    sigaction(number, &action, nullptr);
  }
}

double since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::size_t width_of_terminal() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

}  // namespace

std::string about(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", std::max(1.0, seconds));
  if (seconds < 100 * 60) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 100 * 3600) return fmt::format("{:.0f} hours", seconds / 3600);
  if (seconds < 1e10) return fmt::format("{:.0f} days", seconds / 86400);
  return "longer than anybody waits";
}

LongWork::LongWork(std::string command, std::optional<double> seconds, bool shows,
                   std::function<int(const std::string& why)> last_words)
    : command_(std::move(command)),
      seconds_(seconds),
      shows_(shows && isatty(STDERR_FILENO) != 0),
      last_words_(std::move(last_words)) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return;
  received = 0;
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);  // signals go to other threads
  try {
    thread_ = std::thread([this, listening = ends[0]] { look_on(listening); });
  } catch (const std::system_error&) {
    close(ends[0]);
    close(ends[1]);
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  if (!thread_.joinable()) return;
  listening_ = ends[0];
  wake_up = ends[1];
  set_meaning(true);
}

LongWork::~LongWork() {
  if (!thread_.joinable()) return;
  is_over_ = true;
  set_meaning(false);
  // The end of the pipe wakes the thread, as a byte in it would; only it cannot fail to.
  close(wake_up.exchange(-1));
  thread_.join();
  close(listening_);
  clear();
}

void LongWork::begin(std::string what, std::optional<double> expected) {
  const std::lock_guard lock(mutex_);
  what_ = on_one_line(what);
  expected_ = expected;
  begun_ = Clock::now();
  counted_ = nullptr;
}

Progress LongWork::progress() {
  return [this](const char* what, std::size_t done, std::size_t of) {
    done_ = done;
    of_ = of;
    counted_ = what;
  };
}

void LongWork::clear() {
  const std::lock_guard lock(mutex_);
  if (is_shown_) std::fputs("\r\x1b[K", stderr);
  is_shown_ = false;
}

void LongWork::look_on(int listening) {
  while (!is_over_) {
    int wait = shows_ ? kBetweenLooks : -1;
    if (seconds_) {
      const double left = std::ceil(std::max(0.0, *seconds_ - since(start_)) * 1000);
      if (wait < 0 || left < wait) wait = static_cast<int>(std::min(left, 1e9));
    }
    pollfd awaited = {listening, POLLIN, 0};
    ::poll(&awaited, 1, wait);
    if (is_over_) return;
    if (received != 0) end_with("interrupted");
    if (seconds_ && since(start_) >= *seconds_) end_with("stopped by --limit");
    if (shows_ && since(start_) >= kLong) show();
  }
}

// "segments: 1200 of 9680, 12 %"
std::string LongWork::so_far() const {
  const char* const counted = counted_;
  if (counted == nullptr) return "";
  const std::size_t done = done_, of = of_;
  if (of == 0) return fmt::format(", {}: {}", counted, done);
  return fmt::format(", {}: {} of {}, {:.0f} %", counted, done, of,
                     std::floor(100.0 * static_cast<double>(done) / static_cast<double>(of)));
}

void LongWork::show() {
  const std::lock_guard lock(mutex_);
  if (what_.empty()) return;
  std::string line = command_ + ": " + what_;
  std::string rest = fmt::format("{}, {:.0f} s", so_far(), std::floor(since(begun_)));
  if (expected_) rest += " of about " + about(*expected_);
  // Where both do not fit on a line, the name of a file, which the user knows, is cut.
  const std::size_t room = width_of_terminal() - 1;
  if (line.size() + rest.size() > room) {
    line.resize(room > rest.size() + 3 ? room - rest.size() - 3 : 0);
    line += "...";
  }
  line += rest;
  std::fputs(("\r\x1b[K" + line).c_str(), stderr);
  std::fflush(stderr);
  is_shown_ = true;
}

void LongWork::end_with(const std::string& cause) {
  clear();
  std::string why = fmt::format("{} after {:.1f} s", cause, since(start_));
  {
    const std::lock_guard lock(mutex_);
    if (!what_.empty()) why += ", while " + what_ + so_far();
  }
  _exit(last_words_(why));
}

}  // namespace circumspect::cli
