#include "oracle/formats/bytes/unfinished_file.hpp"

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <signal.h>
#include <sys/random.h>
#include <unistd.h>

namespace circumspect::formats {
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

// An unpredictable name beside the file, so that it can be renamed.
std::string hidden_name(const std::string& path) {
  std::uint64_t number = 0;
  if (getrandom(&number, sizeof(number), 0) < 0) number = static_cast<std::uint64_t>(getpid());
  char name[64];
  std::snprintf(name, sizeof(name), ".unfinished-%016llx", static_cast<unsigned long long>(number));
  return folder_of(path) + "/" + name;
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

FileBuffer::int_type FileBuffer::overflow(int_type c) {
  if (!write_out()) return traits_type::eof();
  if (!traits_type::eq_int_type(c, traits_type::eof())) sputc(traits_type::to_char_type(c));
  return traits_type::not_eof(c);
}

int FileBuffer::sync() { return write_out() ? 0 : -1; }

bool FileBuffer::write_out() {
  for (const char* at = pbase(); failure == 0 && at < pptr();) {
    const ssize_t count = write(file, at, static_cast<std::size_t>(pptr() - at));
    if (count >= 0) at += count;
    if (count < 0 && errno != EINTR) failure = errno;
  }
  setp(block_.data(), block_.data() + block_.size());
  return failure == 0;
}

UnfinishedFile::UnfinishedFile(std::string path) : path_(std::move(path)), stream_(&buffer_) {
  const int flags = O_WRONLY | O_CLOEXEC;
  // An anonymous file gets a name through its entry in /proc.
  if (access("/proc/self/fd", X_OK) == 0) {
    buffer_.file = open(folder_of(path_).c_str(), O_TMPFILE | flags, 0666);
  }
  if (buffer_.file >= 0 || open_named()) return;
  buffer_.failure = errno;
  stream_.setstate(std::ios::badbit);
}

bool UnfinishedFile::open_named() {
  set_handlers();
  unfinished_ = hidden_name(path_);
  remember(unfinished_.c_str());
  const int flags = O_WRONLY | O_CLOEXEC | O_CREAT | O_EXCL | O_NOFOLLOW;
  buffer_.file = open(unfinished_.c_str(), flags, 0666);
  if (buffer_.file >= 0) return true;
  const int reason = errno;
  forget(unfinished_.c_str());
  unfinished_.clear();
  errno = reason;
  return false;
}

UnfinishedFile::~UnfinishedFile() {
  if (buffer_.file >= 0) close(buffer_.file);
  if (unfinished_.empty()) return;
  unlink(unfinished_.c_str());
  forget(unfinished_.c_str());
}

// Sets errno if it fails.
bool UnfinishedFile::give_name() {
  if (!unfinished_.empty()) {
    if (rename(unfinished_.c_str(), path_.c_str()) != 0) return false;
    forget(unfinished_.c_str());
    unfinished_.clear();
    return true;
  }
  const std::string own = "/proc/self/fd/" + std::to_string(buffer_.file);
  const auto link_as = [&own](const std::string& name) {
    return linkat(AT_FDCWD, own.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
  };
  if (link_as(path_)) return true;
  if (errno != EEXIST) return false;
  // No system call replaces a file by an anonymous one, so it gets another name first, for a
  // moment.
  const WithoutSignals undisturbed;
  const std::string passing = hidden_name(path_);
  if (!link_as(passing)) return false;
  if (rename(passing.c_str(), path_.c_str()) == 0) return true;
  const int reason = errno;
  unlink(passing.c_str());
  errno = reason;
  return false;
}

int UnfinishedFile::finish(bool to_disk) {
  stream_.flush();
  if (buffer_.failure == 0 && !stream_)
    buffer_.failure = EIO;  // the writer reports that the file is incomplete
  if (buffer_.failure == 0 && to_disk && fsync(buffer_.file) != 0) buffer_.failure = errno;
  if (buffer_.failure == 0 && !give_name()) buffer_.failure = errno;
  return buffer_.failure;
}

int write_whole_file(const std::string& path, const std::string& text) {
  UnfinishedFile file(path);
  file.stream() << text;
  return file.finish(true);
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

}  // namespace circumspect::formats
