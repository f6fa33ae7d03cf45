// The answer of a program under test, which may return, throw, crash or never end.
#pragma once

#include <chrono>
#include <string>

#include <circumspect/subject.hpp>

namespace circumspect::harness {

struct Answer {
  SimplexArray simplices = {};
  // Empty if it returned. Else how it ended: "crash" (it threw), "signal 11", "exit 3", "hang",
  // "too-much-output".
  std::string failure = {};
  std::string text = {};  // of an exception
};

// In this process.
Answer answer(const Triangulator& subject, const PointArray& points);

// In a process of its own, which is killed after the time limit. Throws std::system_error if there
// cannot be a process. The child is a fork: threads of this process do not exist there.
Answer isolated_answer(const Triangulator& subject, const PointArray& points,
                       std::chrono::milliseconds time_limit);

}  // namespace circumspect::harness
