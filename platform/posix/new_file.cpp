#include "platform/new_file.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <utility>

#include <fcntl.h>
#include <signal.h>
#include <sys/random.h>
#include <unistd.h>

#include "platform/posix/descriptors.hpp"

namespace circumspect::platform {
namespace {

constexpr std::array kSignals = {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXCPU};

// The names of unfinished files that have a name; several threads may write one each.
std::array<std::atomic<const char*>, 64> names_to_remove = {};
static_assert(std::atomic<const char*>::is_always_lock_free);

// Calls only async-signal-safe functions. The signal's default action has been restored by then: it
// ends the command.
void remove_and_end(int number) {
  remove_unfinished_files();
  raise(number);
}

// A signal that is ignored or handled by someone else is left alone.
void set_handlers() {
  for (const int number : kSignals) {
    struct sigaction present {};
    if (sigaction(number, nullptr, &present) != 0 || present.sa_handler != SIG_DFL) continue;
    struct sigaction action {};
    action.sa_handler = remove_and_end;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(number, &action, nullptr);
  }
}

void remember(const char* name) {
  for (std::atomic<const char*>& place : names_to_remove) {
    const char* none = nullptr;
    if (place.compare_exchange_strong(none, name)) return;
  }
}

void forget(const char* name) {
  for (std::atomic<const char*>& place : names_to_remove) {
    const char* same = name;
    place.compare_exchange_strong(same, nullptr);
  }
}

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "." : path.substr(0, slash + 1);
}

// Signals are blocked in this thread meanwhile.
class WithoutSignals {
 public:
  WithoutSignals() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before_);
  }
  ~WithoutSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  WithoutSignals(const WithoutSignals&) = delete;
  WithoutSignals& operator=(const WithoutSignals&) = delete;

 private:
  sigset_t before_ = {};
};

}  // namespace

// Not std::random_device, which asks for a glibc of 2022 where libstdc++ is linked statically.
std::uint64_t random_number() {
  std::uint64_t number = 0;
  if (getentropy(&number, sizeof number) == 0) return number;
  static int place;
  return reinterpret_cast<std::uintptr_t>(&place);
}

NewFile::NewFile(std::string path)
    : path_(std::move(path)), descriptor_(open_unnamed(folder_of(path_))) {
  if (descriptor_ >= 0) return;
  set_handlers();
  unfinished_ = unpredictable_name(path_);
  remember(unfinished_.c_str());
  const int flags = O_WRONLY | O_CLOEXEC | O_CREAT | O_EXCL | O_NOFOLLOW;
  descriptor_ = open(unfinished_.c_str(), flags, 0666);
  if (descriptor_ >= 0) return;
  const int reason = errno;
  forget(unfinished_.c_str());
  unfinished_.clear();
  errno = reason;
}

NewFile::~NewFile() {
  if (descriptor_ >= 0) close(descriptor_);
  if (unfinished_.empty()) return;
  unlink(unfinished_.c_str());
  forget(unfinished_.c_str());
}

bool NewFile::give_name() {
  if (!unfinished_.empty()) {
    if (rename(unfinished_.c_str(), path_.c_str()) != 0) return false;
    forget(unfinished_.c_str());
    unfinished_.clear();
    return true;
  }
  if (name_unnamed(descriptor_, path_)) return true;
  if (errno != EEXIST) return false;
  // No system call replaces a file by an anonymous one, so it gets another name first, for a
  // moment.
  const WithoutSignals undisturbed;
  const std::string passing = unpredictable_name(path_);
  if (!name_unnamed(descriptor_, passing)) return false;
  if (rename(passing.c_str(), path_.c_str()) == 0) return true;
  const int reason = errno;
  unlink(passing.c_str());
  errno = reason;
  return false;
}

void remove_unfinished_files() {
  for (std::atomic<const char*>& place : names_to_remove) {
    const char* const name = place.exchange(nullptr);
    if (name != nullptr) unlink(name);
  }
}

void let_writing_fail_at_file_limits() {
  struct sigaction ignore {};
  ignore.sa_handler = SIG_IGN;
  sigaction(SIGXFSZ, &ignore, nullptr);
}

}  // namespace circumspect::platform
