#include "oracle/judge/within/judge_within.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "kernel/complex/polytope.hpp"
#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/judge/domain/listed_faces.hpp"
#include "oracle/judge/domain/vertex_places.hpp"
#include "oracle/judge/within/hull_faces.hpp"
#include "oracle/judge/within/hull_walls.hpp"
#include "oracle/judge/within/image_complex.hpp"
#include "oracle/judge/within/reach_by_definition.hpp"
#include "oracle/judge/within/reach_search.hpp"

namespace circumspect::check {
namespace {

constexpr std::size_t kMostPointsByDefinition = 300;  // of a convex hull
// Each cell is put into boxes, and its image looked for: see Work.
constexpr std::size_t kStepsOfCell = 10;
constexpr const char* kGivenUp = "The search for the least distance was given up.";

// Are there so many cells that a search need not begin?
bool is_too_large(const PiecewiseLinearComplex& complex, Work& work) {
  const std::size_t steps =
      kStepsOfCell * (complex.points.size() + complex.segments.size() + complex.polygons.size());
  const bool has_room = work.has_room_for(steps);
  if (!has_room) work.add(steps);
  return !has_room;
}

bool forbids_steiner_points(Claim claim) {
  return claim == Claim::kPlcTriangulation || claim == Claim::kCdt;
}
// The same claim, of the image with all its vertices.
Claim with_steiner_points(Claim claim) {
  if (claim == Claim::kPlcTriangulation) return Claim::kSteinerTriangulation;
  return claim == Claim::kCdt ? Claim::kSteinerCdt : claim;
}

// Is a simplex or a listed face at fault by itself, or listed twice? A facet that three simplices
// share is no such fault: the distance at which all cells have images is found as well.
bool is_unsound(const Verdict& verdict) {
  return std::any_of(verdict.tallies().begin(), verdict.tallies().end(), [](const auto& tally) {
    return stage(tally.first) == Stage::kSimplices && tally.first != Rule::kOrientation;
  });
}

// A domain with all cells that are to have an image: those of a convex hull follow the user's own.
struct CellsOfDomain {
  const Domain& domain;
  const Cells& cells;
  const Regions& regions;
  std::size_t own_polygons;  // the user's

  // The user has no polygon that is a part of a face of the convex hull: three corners of it say
  // which.
  Witness in_own_words(Witness witness) const {
    if (!witness.polygon || *witness.polygon < own_polygons) return witness;
    witness.domain_cell = cells.complex().polygons[*witness.polygon].triangles.front();
    witness.polygon.reset();
    return witness;
  }
};

std::string cell_name(Cell cell, const CellsOfDomain& all) {
  const Domain& domain = all.domain;
  if (cell.dimension == 2 && cell.place >= all.own_polygons) {
    const Simplex& some = all.cells.complex().polygons[cell.place].triangles.front();
    return "the face of the convex hull at vertices " + std::to_string(domain.label(some[0])) +
           ", " + std::to_string(domain.label(some[1])) + " and " +
           std::to_string(domain.label(some[2]));
  }
  if (cell.dimension == 0) {
    return "vertex " + std::to_string(domain.label(static_cast<Vertex>(cell.place)));
  }
  if (cell.dimension == 2) return "polygon " + domain.polygon_name(cell.place);
  const Simplex& ends = all.cells.complex().segments[cell.place];
  return "segment " + std::to_string(domain.label(ends[0])) + " " +
         std::to_string(domain.label(ends[1]));
}

NotJudged not_judged(const ReachAnswer& answer, const ExactMesh& mesh,
                     const CellsOfDomain& domain) {
  const std::string reach = square_root_to_decimal(answer.squared_reach);
  const std::string no_smaller = ", and no smaller distance will do. ";
  const std::string advice = "Name a smaller distance to see what is missing.";
  if (answer.kind == ReachAnswer::Kind::kOpen) {
    return {"At a distance of about " + reach + " the image of " +
            cell_name(answer.cells.front(), domain) +
            " of the domain is not forced: flat simplices lie between several sets of triangles, "
            "and none of those that were tried will do. A .face file may say by its markers which "
            "triangles are meant."};
  }
  if (answer.vertices.empty() && !answer.cells.empty()) {
    return {"No distance below about " + reach + " will do. That is a third of what is between " +
            cell_name(answer.cells[0], domain) + " and " + cell_name(answer.cells[1], domain) +
            " of the domain, which do not meet, and no larger distance tells them apart. " +
            advice};
  }
  if (answer.cells.empty()) return {"Some distances do not tell cells of the domain apart."};
  std::string text = "At a distance of about " + reach + " ";
  if (answer.cells.size() == 1) {
    return {text + "vertices " + std::to_string(mesh.label(answer.vertices[0])) + " and " +
            std::to_string(mesh.label(answer.vertices[1])) +
            " of the mesh both are within reach of " + cell_name(answer.cells[0], domain) +
            " of the domain" + no_smaller + advice};
  }
  return {text + "vertex " + std::to_string(mesh.label(answer.vertices[0])) +
          " of the mesh is within reach of " + cell_name(answer.cells[0], domain) + " and of " +
          cell_name(answer.cells[1], domain) +
          " of the domain, but of nothing that these have in common" + no_smaller + advice};
}

// A witness against the image, in the words of the domain.
Witness translated(Witness witness, const ImageComplex& image, const ReachAnswer& answer,
                   const CellsOfDomain& domain) {
  if (witness.polygon) witness.polygon = image.polygons[*witness.polygon];
  if (!witness.domain_cell) return domain.in_own_words(std::move(witness));
  Simplex in_mesh;
  for (const Vertex v : *witness.domain_cell) {
    in_mesh.push_back(image.in_mesh[static_cast<std::size_t>(v)]);
  }
  witness.domain_cell.reset();
  if (witness.vertices.empty()) witness.vertices = in_mesh;
  std::vector<Cell> carriers;
  for (const Vertex v : in_mesh) {
    const auto& carrier = answer.carriers[static_cast<std::size_t>(v)];
    if (carrier.is_one()) carriers.push_back(*carrier.cell);
  }
  for (const Cell& cell : carriers) {
    if (cell.dimension == 1) {
      witness.domain_cell = domain.cells.complex().segments[cell.place];
    }
    if (cell.dimension == 2) witness.polygon = cell.place;
  }
  if (!witness.domain_cell && !witness.polygon) {
    Simplex vertices;
    for (const Cell& cell : carriers) vertices.push_back(static_cast<Vertex>(cell.place));
    if (!vertices.empty()) witness.domain_cell = sorted(vertices);
  }
  return domain.in_own_words(std::move(witness));
}

// Which points of the mesh are its vertices: those of simplices and listed faces. No simplex can
// have a lone vertex of the domain that is outside what is filled, so there a point of the mesh is
// enough, as for the exact claim.
std::vector<bool> vertices_of(const ExactMesh& mesh, const PiecewiseLinearComplex& complex,
                              const Regions& regions) {
  VertexPlaces places = match_vertices(mesh, complex);
  std::vector<bool> is_lone(complex.points.size(), true);
  const auto belong = [&](const std::vector<Vertex>& vertices) {
    for (const Vertex v : vertices) is_lone[VertexPlaces::place(v)] = false;
  };
  for (const Simplex& segment : complex.segments) belong(segment);
  for (const auto& polygon : complex.polygons) belong(polygon.vertices);
  for (Vertex v = 0; complex.points.names(v); ++v) {
    const Vertex there = places.in_mesh[VertexPlaces::place(v)];
    if (!is_lone[VertexPlaces::place(v)] || there == kNoVertex) continue;
    if (places.used[VertexPlaces::place(there)]) continue;
    const Where where = regions.locate(complex.points[v]);
    if (where == Where::kOutside || where == Where::kHole) {
      places.used[VertexPlaces::place(there)] = true;
    }
  }
  return std::move(places.used);
}

// The vertices of the mesh that are not the image of a vertex of the domain.
void add_steiner_points(const ExactMesh& mesh, const std::vector<bool>& used,
                        const ReachAnswer& answer, Verdict& verdict) {
  SteinerPoints count;
  ExtraVertices extra;
  for (Vertex v = 0; mesh.points.names(v); ++v) {
    const std::size_t place = static_cast<std::size_t>(v);
    const auto& cell = answer.carriers[place].cell;
    if (!used[place] || (cell && cell->dimension == 0)) continue;
    count.add(cell ? cell->dimension : 3);
    extra.add(v, verdict.max_violations());
    if (forbids_steiner_points(verdict.claim())) {
      verdict.add(Rule::kSteinerForbidden, {.vertices = {v}});
    }
  }
  verdict.steiner_points = count;
  verdict.extra_vertices = std::move(extra);
}

void add_all(const Verdict& inner, const ImageComplex& image, const ReachAnswer& answer,
             const CellsOfDomain& domain, Verdict& verdict) {
  std::map<Rule, std::size_t> kept;
  for (const Violation& violation : inner.violations()) {
    ++kept[violation.rule];
    verdict.add(violation.rule, translated(violation.witness, image, answer, domain),
                inner.tallies().at(violation.rule).worst_margin);
  }
  for (const auto& [rule, tally] : inner.tallies()) {
    for (std::size_t i = kept[rule]; i < tally.count; ++i) verdict.count(rule, tally.worst_margin);
  }
  verdict.dangling = inner.dangling;
  if (!verdict.holds()) return;
  verdict.unique = inner.unique;
  verdict.canonical = inner.canonical;
}

Verdict judged_exactly(Claim claim, const ExactMesh& mesh, const Domain& domain,
                       const Options& options, const KnownBeside& known) {
  if (known.held) {
    if (auto held = known.held(claim, domain)) return *std::move(held);
  }
  return judge_exactly(claim, mesh, &domain, options, known.facts);
}

tl::expected<Verdict, NotJudged> judge_images(Claim claim, const ExactMesh& mesh,
                                              const std::vector<bool>& used,
                                              const CellsOfDomain& domain,
                                              const ReachAnswer& answer, const Options& options,
                                              const KnownBeside& known) {
  Verdict verdict(claim, mesh, options.max_violations);
  verdict.within = Within{.squared_reach = answer.squared_reach};
  const auto image = image_complex(answer.images, answer.moved, mesh, domain.cells, domain.regions);
  if (!image) {
    verdict.add(image.error().rule, image.error().witness);
    return verdict;
  }
  if (image->sides_differ) {
    return tl::unexpected(
        NotJudged{"The images of the cells divide space in another way than the cells do: of one "
                  "region some walls say that it is inside the domain, and others that it is not.",
                  false});
  }
  verdict.within->not_compared = image->not_flat_and_dangling;
  add_steiner_points(mesh, used, answer, verdict);
  const Verdict inner =
      judged_exactly(with_steiner_points(claim), mesh, image->domain, options, known);
  add_all(inner, *image, answer, domain, verdict);
  return verdict;
}

// The domain with the faces of its convex hull for walls.
PiecewiseLinearComplex with_hull_as_walls(const PiecewiseLinearComplex& complex,
                                          bool by_definition) {
  const PointSet& points = complex.points;
  std::vector<std::vector<Vertex>> faces;
  if (points.dimension() == static_cast<int>(points.ambient_dimension())) {
    faces = by_definition ? facets_by_definition(points, all_vertices(points)) : hull_faces(points);
  }
  return with_hull_walls(complex, faces);
}

// The verdict that the cells have no images up to this distance.
Verdict verdict_beyond(Claim claim, const ExactMesh& mesh, const ReachAnswer& answer,
                       const CellsOfDomain& domain, const Rational& squared_distance,
                       const Options& options) {
  Verdict verdict(claim, mesh, options.max_violations);
  for (const Violation& breach : answer.breaches) {
    verdict.add(breach.rule, domain.in_own_words(breach.witness));
  }
  assert(!verdict.holds());
  verdict.beyond = squared_distance;
  return verdict;
}

// The verdict of the exact claim, if that settles the matter. `are_known`: it is known of a large
// mesh of doubles that its simplices are sound, so only the listed faces may need that verdict.
template <class Exactly>
std::optional<Verdict> settled_exactly(Claim claim, const ExactMesh& mesh, const Domain& domain,
                                       bool are_known, const Exactly& exactly) {
  const bool is_empty = domain.complex.points.empty();
  if (are_known && !is_empty) {
    Verdict listed(claim, 1);
    if (judge_listed_faces(mesh, domain.complex.ambient_dimension(), listed)) return std::nullopt;
    return exactly();
  }
  Verdict exact = exactly();
  if (exact.holds() || is_empty || is_unsound(exact)) return exact;
  return std::nullopt;
}

tl::unexpected<NotJudged> left_open(std::string why) {
  return tl::unexpected(NotJudged{std::move(why), false});
}

}  // namespace

tl::expected<Verdict, NotJudged> judge_within(Claim claim, const ExactMesh& mesh,
                                              const Domain& domain,
                                              const Rational& squared_distance,
                                              const Options& options, const KnownBeside& known,
                                              const Domain* flat, const Markers& markers,
                                              Work* work) {
  const auto exactly = [&] {
    Verdict verdict = judged_exactly(claim, mesh, flat == nullptr ? domain : *flat, options, known);
    if (verdict.holds()) verdict.within = Within{};
    return verdict;
  };
  const bool is_hull = domain.complex.kind == DomainKind::kHull;
  const bool are_known = known.facts != nullptr && flat == nullptr;
  const auto settled = settled_exactly(claim, mesh, domain, are_known, exactly);
  if (settled) return *settled;
  if (is_hull && flat != nullptr) {
    return left_open(
        "The claim does not hold exactly. A convex hull is not judged at any other distance where "
        "polygons are joined by angle: leave out the angle of --merge-coplanar.");
  }
  const bool by_definition = options.by == By::kDefinition;
  if (work != nullptr && is_too_large(domain.complex, *work)) return left_open(kGivenUp);
  if (is_hull && by_definition && domain.complex.points.size() > kMostPointsByDefinition) {
    return left_open(
        "By definition every plane through three vertices is tried for a face of the convex hull, "
        "and here there are too many of them: judge by lemma.");
  }
  std::optional<PiecewiseLinearComplex> walled;
  if (is_hull) walled = with_hull_as_walls(domain.complex, by_definition);
  const Cells cells(walled ? *walled : domain.complex, markers);
  const Regions regions = walled ? Regions(*walled) : domain.regions();
  const std::vector<bool> used = vertices_of(mesh, domain.complex, regions);
  const CellsOfDomain all{domain, cells, regions, domain.complex.polygons.size()};
  if (by_definition && !is_small_enough_for_definition(mesh, used, cells, squared_distance)) {
    return left_open(
        "By definition every set of triangles near a polygon is tried, and here there are too many "
        "of them: judge by lemma.");
  }
  Work unlimited;
  const ReachAnswer answer =
      by_definition ? least_reach_by_definition(mesh, used, cells, regions, squared_distance)
                    : least_reach(mesh, used, cells, regions, squared_distance, threads_of(options),
                                  work != nullptr ? *work : unlimited);
  using Kind = ReachAnswer::Kind;
  if (answer.kind == Kind::kAmbiguous || answer.kind == Kind::kOpen) {
    return tl::unexpected(not_judged(answer, mesh, all));
  }
  if (answer.kind == Kind::kTooMuchWork) {
    return left_open(kGivenUp);
  }
  if (answer.kind == Kind::kNone) {
    return verdict_beyond(claim, mesh, answer, all, squared_distance, options);
  }
  if (sign(answer.squared_reach) != 0 || flat != nullptr) {
    return judge_images(claim, mesh, used, all, answer, options, known);
  }
  Verdict exact = exactly();
  exact.within = Within{};
  return exact;
}

}  // namespace circumspect::check
