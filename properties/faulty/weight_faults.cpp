// Weighted Delaunay triangulations with the weights misread. Book: Section 5.2.
#include <cmath>
#include <functional>

#include "properties/faulty/fault.hpp"
#include "properties/faulty/plain_delaunay.hpp"

namespace circumspect::faulty {
namespace {

Fault weighing_fault(std::string name, std::string about, Triangulator triangulate) {
  return {std::move(name), std::move(about), Kind::kImplementation, Claim::kWeightedDelaunay,
          std::move(triangulate)};
}

Fault reading(std::string name, std::string about, const std::function<double(double)>& read) {
  return weighing_fault(std::move(name), std::move(about), [read](const PointArray& points) {
    PointArray misread = points;
    for (double& weight : misread.weights) {
      const double now = read(weight);
      if (std::isfinite(now)) weight = now;
    }
    return right_answer(misread);
  });
}

}  // namespace

std::vector<Fault> weight_faults() {
  return {
      reading("weights-ignored", "The weights are read and never used.",
              [](double) { return 0.0; }),
      reading("weight-sign-swapped", "The height is |p|² + w for |p|² − w.",
              [](double weight) { return -weight; }),
      reading("weights-squared", "Squared radii are taken for radii, and squared once more.",
              [](double weight) { return weight * weight; }),
      reading("weights-as-radii", "Square roots of the weights are used: the opposite mix-up.",
              [](double weight) { return std::sqrt(std::abs(weight)); }),
      weighing_fault(
          "inserts-submerged-points",
          "A point that conflicts with nothing, because it is submerged, is inserted into the "
          "simplex around it all the same: unweighted code with a power test.",
          [](const PointArray& points) {
            return plain_delaunay(points, {.keeps_submerged_points = true});
          }),
      weighing_fault(
          "never-submerges-a-vertex",
          "A vertex that a new point submerges keeps a simplex: in unweighted code vertices never "
          "vanish.",
          [](const PointArray& points) {
            return plain_delaunay(points, {.never_removes_vertices = true});
          }),
  };
}

}  // namespace circumspect::faulty
