// A thread that looks on while others work, and hears of interruptions: SIGINT, SIGTERM, Ctrl-C.
#pragma once

#include <functional>
#include <memory>

namespace circumspect::platform {

// One at a time. The second interruption ends the process as the system does. Who ignores them, or
// has a handler of his own, is not in the way.
class InterruptionWatch {
 public:
  InterruptionWatch();
  // Ends it.
  ~InterruptionWatch();
  InterruptionWatch(const InterruptionWatch&) = delete;
  InterruptionWatch& operator=(const InterruptionWatch&) = delete;

  // Calls look_on in a thread of its own, which gets no signals. False if the system gives none:
  // then interruptions keep their meaning.
  bool start(std::function<void()> look_on);
  bool is_running() const;
  // Wakes that thread and waits until it returns. From now on interruptions have their usual
  // meaning.
  void end();

  // For the thread: waits for so many milliseconds (negative: as long as it takes), at most until
  // there is an interruption, or end() is called.
  void wait(int milliseconds);
  // Has there been one?
  bool is_interrupted() const;

 private:
  struct System;
  std::unique_ptr<System> system_;
};

}  // namespace circumspect::platform
