// The images of all cells of a domain at one reach, and whether they lie to one another as the
// cells do. docs/theory/within.md, 4.
#pragma once

#include <optional>
#include <vector>

#include "oracle/judge/within/images.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

struct ImageSet {
  std::vector<Vertex> vertices;            // of each vertex of the domain
  std::vector<std::vector<Vertex>> paths;  // of each segment
  std::vector<Patch> patches;              // of each polygon
};

// Requires: every cell has an image.
ImageSet image_set(const Images& images, const Cells& cells, const Rational& squared_reach);

// Two cells whose images meet otherwise than in images of common faces, or stand about a segment in
// another order: rule domain.images-meet.
struct Misplaced {
  Cell a;
  Cell b;
  Violation violation;
};
std::optional<Misplaced> misplaced(const ImageSet& images, const ExactMesh& mesh,
                                   const Cells& cells);

}  // namespace circumspect::check
