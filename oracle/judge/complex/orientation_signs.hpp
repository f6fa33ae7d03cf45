// Orientations of many simplices of the same points.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "kernel/predicates/configuration.hpp"
#include "oracle/judge/fast/predicates/site.hpp"

namespace circumspect::check {

// Where all coordinates are doubles, in the plane or in space, the fast predicates answer, whose
// signs are those of `orientation` (their law F1): the corners of a surface are compared with
// those of every triangle whose box meets theirs.
class OrientationSigns {
 public:
  // `points` outlive this.
  explicit OrientationSigns(const Configuration& points);

  const Configuration& points() const { return points_; }
  // As `orientation`.
  int operator()(std::span<const std::size_t> axes, std::span<const Vertex> simplex) const;

 private:
  const Configuration& points_;
  std::vector<fast::Site<2>> in_plane_;  // of every point, or of none
  std::vector<fast::Site<3>> in_space_;
};

}  // namespace circumspect::check
