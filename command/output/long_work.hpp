// Shows the progress of long work, and ends it early.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include "kernel/exact/progress.hpp"
#include "platform/interruption_watch.hpp"

namespace circumspect::cli {

// While there is one, a thread of its own looks on. From the third second on it shows on standard
// error, if that is a terminal, what is being done, how far it has come and how long it has taken.
// At the first SIGINT or SIGTERM (not if these were ignored), or when the time is up, it says the
// last words, and ends the process within a second, whatever the other threads are at; the second
// signal ends it as signals do. So nothing that computes need ask whether it is to end. Nothing may
// be written to files meanwhile, which would stay unfinished: whoever writes one ends this first.
//
// One at a time. Where the system gives no thread there is nothing to see, and signals keep their
// meaning.
class LongWork {
 public:
  // `last_words` is called in the thread, with why the work ends: "interrupted after 12.3 s, while
  // judging part.1.ele". It returns the exit code. `seconds`: how long the work may take.
  LongWork(std::string command, std::optional<double> seconds, bool shows,
           std::function<int(const std::string& why)> last_words);
  ~LongWork();
  LongWork(const LongWork&) = delete;
  LongWork& operator=(const LongWork&) = delete;

  // What is being done from now on: "judging part.1.ele". `expected`: how many seconds that takes,
  // about.
  void begin(std::string what, std::optional<double> expected = {});
  // Who is told how far that has come. It may be called as long as this lives.
  Progress progress();
  // Takes what is shown off the terminal, so that lines can be printed on it.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  void look_on();
  void show();
  void end_with(const std::string& cause);
  std::string so_far() const;

  const std::string command_;
  const std::optional<double> seconds_;
  const bool shows_;
  const std::function<int(const std::string&)> last_words_;
  const Clock::time_point start_ = Clock::now();

  mutable std::mutex mutex_;  // of what follows
  std::string what_;
  std::optional<double> expected_;
  Clock::time_point begun_ = start_;
  bool is_shown_ = false;

  std::atomic<const char*> counted_ = nullptr;
  std::atomic<std::size_t> done_ = 0, of_ = 0;
  std::atomic<bool> is_over_ = false;
  platform::InterruptionWatch interruptions_;
};

// "3 min", "12 s": how long something takes, about.
std::string about(double seconds);

}  // namespace circumspect::cli
