#include "properties/arguments/random_flips.hpp"

#include <optional>
#include <ostream>
#include <utility>

#include "properties/arguments/generated.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::properties {
namespace {

using delaunay::BasicFlip;
using delaunay::ExtendedFlip;

// The facet's flip, if it is possible and deletes no vertex: then T_C is one simplex.
std::optional<ExtendedFlip> vertex_keeping_flip(const PointSet& points,
                                                const StarIndex& triangulation,
                                                const Simplex& facet) {
  if (triangulation.star(facet).size() < 2) return std::nullopt;
  const BasicFlip basic = delaunay::flip_of_facet(points, triangulation, facet);
  if (basic.created.size() == 1) return std::nullopt;
  auto flip = delaunay::extended_flip(triangulation, basic);
  if (!flip) return std::nullopt;
  return std::move(*flip);
}

std::vector<Simplex> all_facets(const StarIndex& triangulation) {
  return facets_of({triangulation.simplices().begin(), triangulation.simplices().end()});
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const TriangulationCase& value) {
  const Triangulation& triangulation = value.triangulation;
  out << value.set << triangulation.simplices().size() << " " << triangulation.dimension() + 1
      << " 0\n";
  std::size_t index = 0;
  for (const Simplex& simplex : triangulation.simplices()) {
    out << index++;
    for (const Vertex v : simplex) out << " " << v;
    out << "\n";
  }
  return out;
}

std::vector<ExtendedFlip> possible_flips(const PointSet& points, const StarIndex& triangulation) {
  std::vector<ExtendedFlip> flips;
  for (const Simplex& facet : all_facets(triangulation)) {
    auto flip = vertex_keeping_flip(points, triangulation, facet);
    if (flip) flips.push_back(std::move(*flip));
  }
  return flips;
}

Triangulation after_flips(const PointSet& points, const Triangulation& start,
                          const std::vector<long>& choices) {
  StarIndex triangulation(start.simplices());
  for (const long choice : choices) {
    const std::vector<ExtendedFlip> flips = possible_flips(points, triangulation);
    if (flips.empty()) break;
    const ExtendedFlip& flip = flips[static_cast<std::size_t>(choice) % flips.size()];
    triangulation.replace(flip.deleted, flip.created);
  }
  return triangulation.triangulation(start.dimension());
}

rc::Gen<TriangulationCase> flipped_triangulations(const rc::Gen<generators::PointsCase>& sets,
                                                  std::size_t max_flips) {
  return rc::gen::exec([=] {
    generators::PointsCase set = *sets;
    const auto count =
        static_cast<std::size_t>(*generators::below(static_cast<long>(max_flips) + 1));
    const auto choices =
        *rc::gen::container<std::vector<long>>(count, generators::below(1'000'000));
    const PointSet unweighted(set.points);
    Triangulation walked = after_flips(unweighted, delaunay::bowyer_watson(unweighted), choices);
    return TriangulationCase{std::move(set), std::move(walked)};
  });
}

}  // namespace circumspect::properties
