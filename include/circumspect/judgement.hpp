// The oracle's answer to a harness.
#pragma once

#include <stdexcept>
#include <string>

#include <circumspect/subject.hpp>

namespace circumspect {

struct Judgement {
  bool holds = false;
  // Why it does not: the identifier of the first broken rule ("delaunay.facet-not-local"), or how
  // the program ended instead of answering: "crash", "signal 11", "hang".
  std::string rule = {};
  // For people, several lines: every witness with its exact values; the text of an exception.
  std::string report = {};
};

struct JudgeOptions {
  unsigned threads = 1;  // 0: as many as the machine has. The answer is the same for any number
  // Equal points count as one: the first, or if weights count, the heaviest. Otherwise they are
  // refused: a program that forgets to share vertices would pass.
  bool merge_equal_points = false;
  // A mesh without points and simplices is judged. Otherwise it is refused, because usually a
  // program has made nothing.
  bool allow_empty = false;
};

// Judges, exactly, what a program made of points. It knows the claims that need no domain:
// "triangulation", "delaunay" (Book: Definitions 2.1 and 4.1) and "weighted-delaunay" (Section
// 5.2). An index that names no point is the program's fault. Throws std::invalid_argument: an
// unknown claim; coordinates that are not a multiple of the dimension or not finite; a number of
// weights other than that of the points; equal points, or neither points nor simplices, unless
// `options` let them pass.
Judgement judge(const std::string& claim, const PointArray& points, const SimplexArray& simplices,
                const JudgeOptions& options = {});

// What a claim fails by: the text of the witnesses.
struct DoesNotHold : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// For tests of any framework: as judge(), and throws DoesNotHold if the claim does not hold.
inline void assert_holds(const std::string& claim, const PointArray& points,
                         const SimplexArray& simplices, const JudgeOptions& options = {}) {
  const Judgement found = judge(claim, points, simplices, options);
  if (!found.holds) throw DoesNotHold(found.report);
}

}  // namespace circumspect
