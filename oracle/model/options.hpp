// How a claim about a mesh is judged, and what is demanded beside it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <thread>

#include "oracle/model/complex_demands.hpp"
#include "oracle/model/hull_demands.hpp"
#include "oracle/model/measure.hpp"

namespace circumspect::check {

// By lemma: linear in the mesh, by the conditions that docs/theory/points.md proves sufficient. By
// definition (oracle/judge/definition): quadratic or slower, and obvious. Property tests compare
// the two.
enum class By { kLemma, kDefinition };

struct Options {
  By by = By::kLemma;
  bool oriented = false;            // demand one consistent orientation
  ComplexDemands complex = {};      // of the claim `complex`, instead of `oriented`
  QualityDemands quality = {};      // beside any claim: judged by oracle/judge/judge.hpp
  HullDemands hull = {};            // of the claim `convex-hull`
  bool structure = false;           // of the claim `voronoi`: demand its vertices and ridges, too
  std::size_t max_violations = 20;  // witnesses kept; 0: all
  // Threads of the fast engine, if it is asked (oracle/judge/judge.hpp); 0: as many as the machine
  // has. The answer is the same for any number.
  unsigned threads = 0;
};

inline unsigned threads_of(const Options& options) {
  return options.threads > 0 ? options.threads : std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace circumspect::check
