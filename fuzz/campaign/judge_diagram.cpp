#include "fuzz/campaign/judge_diagram.hpp"

#include <algorithm>

#include "fuzz/campaign/judge_mesh.hpp"
#include "oracle/formats/voronoi_file.hpp"
#include "oracle/judge/definition/periodic_delaunay.hpp"
#include "oracle/judge/voronoi/judge_voronoi.hpp"

namespace circumspect::campaign {
namespace {

Rational squared_distance_of(const Subject& subject, const PointSet& sites) {
  Rational distance = subject.within;
  if (subject.is_within_relative) {
    const definition::Bounds box = definition::bounds_of(sites.points());
    const Point sides = box.high - box.low;
    distance *= *std::max_element(sides.begin(), sides.end());
  }
  return distance * distance;
}

}  // namespace

Outcome judged_diagram(const Subject& subject, const PointsCase& sites, const std::string& path) {
  const auto source = formats::load(path);
  if (!source) return unreadable(source.error().to_string());
  auto file = formats::read_voronoi(*source, NumberReading::kDouble);
  if (!file) return unreadable(file.error().to_string());
  const VoronoiDiagram diagram{PointSet(sites.points), std::move(file->vertices),
                               std::move(file->cells), std::move(file->neighbors)};
  const std::string fault = check::fault_of_diagram(diagram, {});
  if (!fault.empty()) return unreadable(subject.mesh_name + ": " + fault);
  const Rational squared = squared_distance_of(subject, diagram.sites);
  const Verdict verdict = check::judge_voronoi(diagram, {}, squared, false, kWitnessesOfFinding);
  return outcome_of(verdict, in_rows({diagram.sites, {}}), subject, nullptr);
}

}  // namespace circumspect::campaign
