#include "command/build/constructions.hpp"

#include "reference/delaunay/flip.hpp"
#include "reference/delaunay/gift_wrapping.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::cli {
namespace {

// A construction that takes no options.
Construction plain(Triangulation (*construct)(const PointSet&)) {
  return
      [construct](const PointSet& points, const ConstructionOptions&) { return construct(points); };
}

Triangulation by_insertion(const PointSet& points, const ConstructionOptions& options) {
  return delaunay::bowyer_watson(points, options.bowyer_watson, options.statistics);
}

}  // namespace

const std::map<std::string, Construction>& constructions() {
  static const std::map<std::string, Construction> table = {
      {"bowyer-watson", by_insertion},
      {"by-definition", plain(delaunay::by_definition)},
      {"flips", plain(delaunay::flip_insertion)},
      {"gift-wrapping", plain(delaunay::gift_wrapping)},
      {"gift-wrapping-cells", plain(delaunay::gift_wrapping_by_cells)},
      {"lifted-hull", plain(delaunay::lifted_hull)},
      {"lifted-hull-by-definition", plain(delaunay::lifted_hull_by_definition)},
  };
  return table;
}

std::string construction_names() {
  std::string names;
  for (const auto& [name, construction] : constructions()) {
    names += (names.empty() ? "" : "|") + name;
  }
  return names;
}

}  // namespace circumspect::cli
