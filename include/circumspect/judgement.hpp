// What the oracle answers to a harness.
#pragma once

#include <string>

#include <circumspect/subject.hpp>

namespace circumspect {

struct Judgement {
  bool holds = false;
  // Why it does not: the identifier of the first broken rule ("delaunay.facet-not-local"), or how the
  // program ended instead of answering: "crash", "signal 11", "hang".
  std::string rule = {};
  // For people, several lines: every witness with its exact values; the text of an exception.
  std::string report = {};
};

// Judges, exactly, what a program made of points. The claims that need no domain are known here:
// "triangulation", "delaunay" (Book: Definitions 2.1 and 4.1) and "weighted-delaunay" (Section 5.2).
// Equal points count as one, the first. An index that names no point is the program's fault.
// Throws std::invalid_argument: an unknown claim; coordinates that are no multiple of the dimension or
// not finite; weights that are not as many as the points.
Judgement judge(const std::string& claim, const PointArray& points, const SimplexArray& simplices);

}  // namespace circumspect
