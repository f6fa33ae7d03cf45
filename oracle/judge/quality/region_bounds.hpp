// Bounds on the size of elements, region by region of a domain: what "area:regions" requires.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "oracle/model/domain.hpp"
#include "oracle/model/measure.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::quality {

// Why the bounds of the regions of a domain can bound nothing in a mesh; one line, empty if they
// can. `is_moved`: the mesh is held against the domain up to a distance, so that its elements need
// not be in one region each.
std::string fault_of_region_bounds(const Requirement& requirement, const Mesh& mesh,
                                   const Domain* domain, bool is_moved);

// A requirement with its bound, of the elements in one region, or of all.
struct RegionRequirement {
  Requirement requirement;
  std::optional<std::size_t> region = {};
};

// One for each region that has a bound. Requires: no fault_of_region_bounds.
std::vector<RegionRequirement> by_region(const Requirement& requirement, const Domain& domain,
                                         const Regions& regions);

// In which region the barycentre of a simplex is. No wall meets the interior of a simplex of a mesh
// that respects the domain, so that all of it is in the region of this point.
class RegionOfSimplex {
 public:
  // Keeps references to both.
  RegionOfSimplex(const Mesh& mesh, const Regions& regions) : mesh_(mesh), regions_(regions) {}

  // None if the barycentre is on a wall.
  std::optional<std::size_t> operator()(const Simplex& simplex);

 private:
  const Mesh& mesh_;
  const Regions& regions_;
  // Of the simplex before: where no wall lies between, the region is the same.
  Point last_ = {};
  std::optional<std::size_t> region_of_last_ = {};
};

}  // namespace circumspect::quality
