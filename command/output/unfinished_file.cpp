#include "command/output/unfinished_file.hpp"

#include <array>
#include <atomic>
#include <cassert>
#include <filesystem>
#include <system_error>

#include <signal.h>
#include <unistd.h>

namespace circumspect::cli {
namespace {

constexpr std::array kSignals = {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXCPU};

std::atomic<const char*> name_to_remove = nullptr;
static_assert(std::atomic<const char*>::is_always_lock_free);

// Only what may be called in a handler. The signal's own meaning is back by then: it ends the command.
void remove_and_end(int number) {
  const char* const name = name_to_remove.exchange(nullptr);
  if (name != nullptr) unlink(name);
  raise(number);
}

void set_handlers(bool ours) {
  for (const int number : kSignals) {
    struct sigaction present {};
    if (sigaction(number, nullptr, &present) != 0) continue;
    const bool is_ours = present.sa_handler == remove_and_end;
    // Who ignores a signal, or does something else about it, is not in our way.
    if (ours ? present.sa_handler != SIG_DFL : !is_ours) continue;
    struct sigaction action {};
    action.sa_handler = ours ? remove_and_end : SIG_DFL;
    action.sa_flags = ours ? static_cast<int>(SA_RESETHAND) : 0;
    sigaction(number, &action, nullptr);
  }
}

}  // namespace

std::string name_until_complete(const std::string& path) { return path + ".unfinished"; }

UnfinishedFile::UnfinishedFile(std::string path)
    : path_(std::move(path)), unfinished_(name_until_complete(path_)) {
  assert(name_to_remove == nullptr);
  name_to_remove = unfinished_.c_str();
  set_handlers(true);
  stream_.open(unfinished_, std::ios::binary);
  is_there_ = stream_.is_open();
}

UnfinishedFile::~UnfinishedFile() {
  stream_.close();
  std::error_code ignored;
  if (is_there_) std::filesystem::remove(unfinished_, ignored);
  set_handlers(false);
  name_to_remove = nullptr;
}

bool UnfinishedFile::finish() {
  stream_.close();
  if (!stream_) return false;
  std::error_code error;
  std::filesystem::rename(unfinished_, path_, error);
  is_there_ = static_cast<bool>(error);
  return !is_there_;
}

void let_writing_fail_at_file_limits() {
  struct sigaction ignore {};
  ignore.sa_handler = SIG_IGN;
  sigaction(SIGXFSZ, &ignore, nullptr);
}

}  // namespace circumspect::cli
