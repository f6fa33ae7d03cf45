#include "command/build/point_constructions.hpp"

#include <map>
#include <string>

#include "kernel/complex/triangulation.hpp"
#include "oracle/formats/point_file.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/flip_algorithm.hpp"
#include "reference/delaunay/flip_insertion.hpp"
#include "reference/delaunay/gift_wrapping.hpp"
#include "reference/delaunay/gift_wrapping_cells.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::cli {
namespace {

// A construction that takes no options.
Construction plain(Triangulation (*construct)(const PointSet&)) {
  return
      [construct](const PointSet& points, const ConstructionOptions&) { return construct(points); };
}

Triangulation by_insertion(const PointSet& points, const ConstructionOptions& options) {
  delaunay::BowyerWatsonOptions how = options.bowyer_watson;
  if (options.steps != nullptr) {
    how.watch = [&options](const auto& insertion) { options.steps->inserted(insertion); };
  }
  return delaunay::bowyer_watson(points, how, options.statistics);
}

Triangulation by_flips(const PointSet& points, const ConstructionOptions& options) {
  if (options.steps == nullptr) return delaunay::flip_insertion(points);
  return delaunay::flip_insertion(
      points, [&options](const delaunay::FlipStep& step) { options.steps->flipped(step); });
}

Triangulation by_wrapping(const PointSet& points, const ConstructionOptions& options) {
  if (options.steps == nullptr) return delaunay::gift_wrapping(points);
  return delaunay::gift_wrapping(points, [&options](const auto& facet, std::optional<Vertex> apex) {
    options.steps->finished(facet, apex);
  });
}

Triangulation by_lifting(const PointSet& points, const ConstructionOptions& options) {
  if (options.steps == nullptr) return delaunay::lifted_hull(points);
  return delaunay::lifted_hull(points, [&options](const Face& facet, bool is_lower) {
    options.steps->wrapped(facet, is_lower);
  });
}

}  // namespace

const std::map<std::string, Construction>& constructions() {
  static const std::map<std::string, Construction> table = {
      {"bowyer-watson", by_insertion},
      {"by-definition", plain(delaunay::by_definition)},
      {"flips", by_flips},
      {"gift-wrapping", by_wrapping},
      {"gift-wrapping-cells", plain(delaunay::gift_wrapping_by_cells)},
      {"lifted-hull", by_lifting},
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
