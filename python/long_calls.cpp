#include "python/long_calls.hpp"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <set>
#include <system_error>
#include <thread>

#include <pthread.h>

#include "python/values.hpp"

namespace circumspect {
namespace {

[[noreturn]] void wait_for_end_of_process() {
  while (true) std::this_thread::sleep_for(std::chrono::hours(1));
}

// Takes back the interpreter's lock. If the interpreter has ended meanwhile, no thread can get it:
// Python before 3.14 then ends the thread by an exception that cannot pass through C++ code, which
// ends the process. This thread waits instead, as Python does from 3.14 on.
void take_lock_back(PyThreadState* state) {
  try {
    PyEval_RestoreThread(state);
  } catch (...) {
    wait_for_end_of_process();
  }
}

// The calls that are being made.
class Calls {
 public:
  void begin(std::int32_t* stop) {
    const std::lock_guard lock(mutex_);
    stops_.insert(stop);
    if (is_over_here()) ask_to_stop(stop);
  }
  void end(std::int32_t* stop) {
    const std::lock_guard lock(mutex_);
    stops_.erase(stop);
    changed_.notify_all();
  }
  void stop_all() {
    std::unique_lock lock(mutex_);
    ending_ = std::this_thread::get_id();
    for (std::int32_t* const stop : stops_) ask_to_stop(stop);
    changed_.wait(lock, [this] { return stops_.empty(); });
  }
  // Is the interpreter ending, in a thread other than this one?
  bool is_over() {
    const std::lock_guard lock(mutex_);
    return is_over_here();
  }
  static void ask_to_stop(std::int32_t* stop) { __atomic_store_n(stop, 1, __ATOMIC_RELAXED); }

 private:
  bool is_over_here() const { return ending_ && *ending_ != std::this_thread::get_id(); }

  std::mutex mutex_ = {};
  std::condition_variable changed_ = {};
  std::set<std::int32_t*> stops_ = {};
  std::optional<std::thread::id> ending_ =
      {};  // the thread that ends the interpreter, which may make calls yet
};

// They live until the process ends. A forked process has none of the threads that make calls.
Calls* calls_of_process = new Calls;
[[maybe_unused]] const int is_fork_known =
    pthread_atfork(nullptr, nullptr, [] { calls_of_process = new Calls; });

Calls& all_calls() { return *calls_of_process; }

// A thread without a waiting caller ends with the interpreter; nothing reports the call that was
// stopped.
void return_to_python(PyThreadState* state) {
  if (all_calls().is_over()) wait_for_end_of_process();
  take_lock_back(state);
}

// As long as this exists a call is being made.
class Stop {
 public:
  Stop() { all_calls().begin(&number_); }
  ~Stop() { all_calls().end(&number_); }
  Stop(const Stop&) = delete;
  Stop& operator=(const Stop&) = delete;

  const std::int32_t* number() const { return &number_; }
  void ask() { Calls::ask_to_stop(&number_); }

 private:
  std::int32_t number_ = 0;
};

Outcome made_within(double seconds, const Stop& stop,
                    const std::function<circumspect_status()>& call) {
  circumspect_end_calls_after(seconds, stop.number());
  Outcome outcome = outcome_of(call());
  circumspect_end_calls_after(0, nullptr);
  return outcome;
}

// A call in a thread of its own.
class CallBeside {
 public:
  CallBeside(const std::function<circumspect_status()>& call, double seconds)
      : thread_([this, &call, seconds] {
          Outcome outcome = made_within(seconds, stop_, call);
          const std::lock_guard lock(mutex_);
          outcome_ = std::move(outcome);
          has_ended_ = true;
          changed_.notify_all();
        }) {}

  void stop() { stop_.ask(); }
  bool ends_within(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, time, [this] { return has_ended_; });
  }
  // Requires: the call has ended.
  Outcome outcome() { return std::move(outcome_); }

 private:
  Stop stop_ = {};
  std::mutex mutex_ = {};
  std::condition_variable changed_ = {};
  bool has_ended_ = false;
  Outcome outcome_ = {};
  std::jthread thread_;  // the last, so that it ends first
};

}  // namespace

Outcome outcome_of(circumspect_status status) {
  return {status, circumspect_last_fault(), circumspect_last_option()};
}

Outcome made(const std::function<circumspect_status()>& call, double seconds) {
  using std::chrono_literals::operator""ms;
  PyThreadState* state = PyEval_SaveThread();
  bool is_interrupted = false;
  Outcome outcome;
  try {
    CallBeside beside(call, seconds);
    while (!beside.ends_within(50ms)) {
      take_lock_back(state);
      is_interrupted = is_interrupted || PyErr_CheckSignals() != 0;
      state = PyEval_SaveThread();
      if (is_interrupted) beside.stop();
    }
    outcome = beside.outcome();
  } catch (const std::system_error&) {  // the system gives no more threads
    outcome = made_within(seconds, Stop(), call);
  }
  return_to_python(state);
  if (is_interrupted) throw python::Raised();
  return outcome;
}

Outcome made_here(const std::function<circumspect_status()>& call) {
  PyThreadState* const state = PyEval_SaveThread();
  Outcome outcome = made_within(0, Stop(), call);
  return_to_python(state);
  return outcome;
}

void stop_all_calls() {
  PyThreadState* const state = PyEval_SaveThread();
  all_calls().stop_all();
  take_lock_back(state);
}

}  // namespace circumspect
