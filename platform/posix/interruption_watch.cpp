#include "platform/interruption_watch.hpp"

#include <atomic>
#include <cerrno>
#include <system_error>
#include <thread>
#include <utility>

#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include "platform/posix/descriptors.hpp"

namespace circumspect::platform {
namespace {

constexpr int kInterruptions[] = {SIGINT, SIGTERM};

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
  for (const int number : kInterruptions) {
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

}  // namespace

struct InterruptionWatch::System {
  int listening = -1;  // the end of the pipe that the thread reads
  std::thread thread;
};

InterruptionWatch::InterruptionWatch() : system_(std::make_unique<System>()) {}

InterruptionWatch::~InterruptionWatch() { end(); }

bool InterruptionWatch::start(std::function<void()> look_on) {
  int ends[2];
  if (!open_pipe(ends)) return false;
  received = 0;
  system_->listening = ends[0];
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);  // signals go to other threads
  try {
    system_->thread = std::thread(std::move(look_on));
  } catch (const std::system_error&) {
    close(ends[0]);
    close(ends[1]);
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  if (!is_running()) return false;
  wake_up = ends[1];
  set_meaning(true);
  return true;
}

bool InterruptionWatch::is_running() const { return system_->thread.joinable(); }

void InterruptionWatch::end() {
  if (!is_running()) return;
  set_meaning(false);
  // The end of the pipe wakes the thread, as a byte in it would; only it cannot fail to.
  close(wake_up.exchange(-1));
  system_->thread.join();
  close(system_->listening);
}

void InterruptionWatch::wait(int milliseconds) {
  pollfd awaited = {system_->listening, POLLIN, 0};
  ::poll(&awaited, 1, milliseconds);
}

bool InterruptionWatch::is_interrupted() const { return received != 0; }

}  // namespace circumspect::platform
