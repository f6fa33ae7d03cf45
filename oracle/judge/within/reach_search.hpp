// The least reach at which every cell of a domain has an image in a mesh. docs/theory/within.md.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oracle/judge/within/image_set.hpp"

namespace circumspect::check {

struct ReachAnswer {
  // kFound: `images` at `squared_reach`. kNone: there is no such reach up to the limit; `breaches`
  // are what is wrong at squared_reach, which mends whatever a reach up to the limit mends.
  // kAmbiguous: the least reach that is left is squared_reach, from which on reaches are ambiguous,
  // for `reason`. kOpen: the images at squared_reach are not forced, for `reason`.
  // kTooMuchWork: the search was given up.
  enum class Kind { kFound, kNone, kAmbiguous, kOpen, kTooMuchWork };
  Kind kind = Kind::kNone;
  Rational squared_reach = 0;
  ImageSet images = {};
  std::vector<Violation> breaches = {};
  std::vector<Cell> cells = {};       // that make reaches ambiguous, or are open
  std::vector<Vertex> vertices = {};  // likewise, of the mesh
  // Points that the mesh lists and does not use count for nothing: vertices_of in judge_within.cpp.
  std::vector<Carrier> carriers = {};  // of each point of the mesh, if found
  std::vector<bool> moved = {};        // is it off the cell that carries it?
};

// Requires: simplices and listed faces that are sound each by itself; a domain of the kind
// enclosed.
ReachAnswer least_reach(const ExactMesh& mesh, const std::vector<bool>& used, const Cells& cells,
                        const Regions& regions, const Rational& squared_limit, unsigned threads,
                        Work& work);

}  // namespace circumspect::check
