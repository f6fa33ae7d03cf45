#include "properties/faulty/fault.hpp"
#include "properties/faulty/plain_delaunay.hpp"

namespace circumspect::faulty {

std::string_view name(Kind kind) {
  switch (kind) {
    case Kind::kPredicate:
      return "predicate";
    case Kind::kImplementation:
      return "implementation";
    case Kind::kCorruption:
      return "corruption";
    case Kind::kDomain:
      break;
  }
  return "domain";
}

const std::vector<Fault>& faults() {
  static const std::vector<Fault> all = [] {
    std::vector<Fault> table;
    for (const auto part :
         {predicate_faults, insertion_faults, size_faults, flip_faults, preparation_faults,
          weight_faults, corruptions, constraint_faults, domain_faults}) {
      const std::vector<Fault> more = part();
      table.insert(table.end(), more.begin(), more.end());
    }
    return table;
  }();
  return all;
}

namespace {

Fault of_points(std::string name, std::string about, Claim claim, Triangulator triangulate) {
  return {std::move(name), std::move(about), Kind::kImplementation, claim, std::move(triangulate)};
}

Fault of_domains(std::string name, std::string about, Claim claim, DomainMesher mesh) {
  return {std::move(name), std::move(about), Kind::kDomain, claim, {}, std::move(mesh)};
}

std::optional<ExactMesh> conforming(const PiecewiseLinearInput& input) {
  return conforming_mesh(assemble(input), 100);
}

SimplexArray plain(const PointArray& points) { return plain_delaunay(points); }

SimplexArray plain_by_walk(const PointArray& points) {
  return plain_delaunay(points, {.search = Search::kWalkThenNeighbors});
}

}  // namespace

std::vector<Fault> right_programs() {
  return {
      of_points("reference", "the canonical triangulation", Claim::kDelaunay, right_answer),
      of_points("plain", "plain Bowyer–Watson without a mistake", Claim::kDelaunay, plain),
      of_points("plain-by-walk", "the same, by walking", Claim::kDelaunay, plain_by_walk),
      of_points("reference-weighted", "the canonical weighted triangulation",
                Claim::kWeightedDelaunay, right_answer),
      of_points("plain-weighted", "plain Bowyer–Watson over weights", Claim::kWeightedDelaunay,
                plain),
      of_domains("reference-cdt", "the canonical CDT, where there is one", Claim::kCdt,
                 [](const PiecewiseLinearInput& input) { return cdt_mesh(assemble(input)); }),
      of_domains("reference-conforming", "a conforming Delaunay triangulation within 100 points",
                 Claim::kConformingDelaunay, conforming),
      of_domains("reference-steiner-cdt", "a Steiner CDT", Claim::kSteinerCdt,
                 [](const PiecewiseLinearInput& input) -> std::optional<ExactMesh> {
                   return steiner_mesh(assemble(input)).mesh;
                 }),
  };
}

}  // namespace circumspect::faulty
