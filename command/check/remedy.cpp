#include "command/check/remedy.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "kernel/exact/each_once.hpp"
#include "oracle/domain/coplanar_polygons.hpp"
#include "oracle/formats/domain_file.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/read_domain.hpp"
#include "oracle/judge/complex/judge_complex.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/judge/judge.hpp"
#include "oracle/judge/within/nearly_coplanar.hpp"
#include "oracle/judge/within/without_image.hpp"
#include "oracle/judge/within/work.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::cli {
namespace {

constexpr int kTimesTenSmaller = 4;  // a distance is divided by ten

bool breaks(const Verdict& verdict, Rule rule) { return verdict.tallies().contains(rule); }

// A polygon that bounds nothing and has the vertex or segment that is missing, or is missing
// itself; none if another polygon has it as well.
std::optional<std::size_t> lone_polygon(const Witness& witness, const LoadedDomain& domain) {
  const auto bounds_nothing = [&](std::size_t polygon) {
    return std::binary_search(domain.bound_nothing.begin(), domain.bound_nothing.end(), polygon);
  };
  if (witness.polygon && bounds_nothing(*witness.polygon)) return witness.polygon;
  if (witness.polygon || !witness.domain_cell) return std::nullopt;
  const Simplex cell = sorted(*witness.domain_cell);
  std::optional<std::size_t> lone;
  for (std::size_t p = 0; p < domain.domain.complex.polygons.size(); ++p) {
    const std::vector<Vertex>& vertices = domain.domain.complex.polygons[p].vertices;
    if (!std::includes(vertices.begin(), vertices.end(), cell.begin(), cell.end())) continue;
    if (!bounds_nothing(p)) return std::nullopt;
    lone = p;
  }
  return lone;
}

// Edges in the plane, triangles in space, and so on: what a hull or a surface is made of. Some
// files of triangles can be read as a domain, too.
std::optional<std::string> note_of_facets(const Verdict& verdict, const Mesh& mesh,
                                          const std::string& path) {
  const bool is_of_facets_itself = verdict.claim() == Claim::kConvexHull;
  if (!breaks(verdict, Rule::kWrongDimension) || is_of_facets_itself || mesh.points() == 0) {
    return std::nullopt;
  }
  const std::size_t d = mesh.dimension();
  for (std::size_t i = 0; i < mesh.simplices.size(); ++i) {
    if (d < 2 || mesh.simplices[i].size() != d) return std::nullopt;
  }
  const bool may_be_domain =
      formats::extension_inside(path) == ".off" || formats::is_domain_file(path);
  if (d == 3 && may_be_domain) {
    return fmt::format(
        "{0}: triangles in space are a surface, not a mesh of what it encloses. circumspect "
        "inspect --domain {0} tells whether the surface is valid, and circumspect check MESH "
        "--domain {0} judges a mesh of its inside",
        path);
  }
  return fmt::format(
      "{}: {} are a boundary, not a mesh of what is inside. --claim convex-hull tells whether they "
      "bound the convex hull of the points, and --claim complex whether they fit together",
      path,
      d == 2   ? "edges in the plane"
      : d == 3 ? "triangles in space"
               : "these facets");
}

}  // namespace

tl::expected<Verdict, check::NotJudged> judged_within(
    const Distance& distance, Claim claim, const check::KnownMesh& mesh, const Domain& domain,
    const check::Options& options, const BentDomain* bent, const check::Markers& markers,
    check::Work* work) {
  Rational squared = distance.squared(domain.complex);
  if (bent != nullptr && bent->squared_limit) squared = std::min(squared, *bent->squared_limit);
  const auto judged = [&] {
    return check::judge_within(claim, mesh.exact(), bent != nullptr ? bent->domain : domain,
                               squared, options, mesh.beside(options),
                               bent != nullptr ? &domain : nullptr, markers, work);
  };
  auto verdict = judged();
  // The distance also says how flat joined polygons are. It may be larger than what tells cells
  // apart: then a smaller one finds what is missing, and what holds at none of those that were
  // looked at does not hold at it.
  for (int times = 0; bent != nullptr && !verdict && verdict.error().is_input_fault; ++times) {
    if (times == kTimesTenSmaller) break;
    squared /= 100;
    if (auto smaller = judged()) verdict = std::move(smaller);
  }
  return verdict;
}

std::vector<std::string> notes_without_domain(const Verdict& verdict, const Mesh& mesh,
                                              const std::string& path) {
  std::vector<std::string> notes;
  for (auto& note :
       {note_of_facets(verdict, mesh, path), report::note_of_domain_not_given(verdict, mesh, path),
        report::note_of_set_apart(verdict, path), report::note_of_cut_counts(verdict, path)}) {
    if (note) notes.push_back(*note);
  }
  return notes;
}

std::optional<std::string> note_of_complex(const Verdict& verdict, const std::string& path,
                                           const std::optional<Verdict>& alone) {
  auto note = report::note_of_claim_complex(verdict, path);
  if (!note || !alone) return note;
  if (alone->holds()) {
    return path + ": with --claim complex it holds: the simplices fit together, whatever they fill";
  }
  if (alone->complex->set_apart > 0) return report::note_of_set_apart(*alone, path);
  const auto& [rule, tally] = *alone->tallies().begin();
  return fmt::format("{}: with --claim complex it fails, too: {} {}", path, identifier(rule),
                     tally.count);
}

std::optional<std::string> note_of_lone_polygons(const Verdict& verdict,
                                                 const LoadedDomain& domain) {
  std::vector<std::size_t> missing;
  for (const Violation& violation : verdict.violations()) {
    const bool is_missing = violation.rule == Rule::kDomainVertexMissing ||
                            violation.rule == Rule::kSegmentMissing ||
                            violation.rule == Rule::kPolygonNotTiled;
    if (!is_missing || domain.bound_nothing.empty()) continue;
    if (const auto polygon = lone_polygon(violation.witness, domain)) missing.push_back(*polygon);
  }
  if (missing.empty()) return std::nullopt;
  keep_each_once(missing);
  const std::string first = domain.domain.polygon_name(missing.front());
  if (missing.size() == 1) {
    return fmt::format(
        "polygon {} bounds nothing that is filled: a program that meshes what is enclosed leaves "
        "it out. If it is to be in the mesh, list its triangles in the .face file; otherwise take "
        "it out of the domain",
        first);
  }
  return fmt::format(
      "polygon {} and {} more bound nothing that is filled: a program that meshes what is enclosed "
      "leaves them out. If they are to be in the mesh, list their triangles in the .face file; "
      "otherwise take them out of the domain",
      first, missing.size() - 1);
}

std::optional<std::string> note_of_weaker_claim(const Verdict& verdict) {
  const bool has_steiner_points = verdict.claim() == Claim::kSteinerCdt;
  if (verdict.holds() || (!has_steiner_points && verdict.claim() != Claim::kCdt)) {
    return std::nullopt;
  }
  for (const auto& [rule, tally] : verdict.tallies()) {
    if (!identifier(rule).starts_with("cdt.")) return std::nullopt;
  }
  return fmt::format(
      "the mesh is a triangulation of the domain, but not a constrained Delaunay one. If the "
      "program does not promise one, add --claim {}, which holds",
      name(has_steiner_points ? Claim::kSteinerTriangulation : Claim::kPlcTriangulation));
}

namespace {

// The first cells of the domain that a verdict says are missing.
std::vector<LinearCell> missing_cells(const Verdict& verdict, const PiecewiseLinearComplex& complex,
                                      std::size_t most) {
  std::vector<LinearCell> cells;
  for (const auto& [rule, witness] : verdict.violations()) {
    if (rule == Rule::kPolygonNotTiled && witness.polygon) cells.push_back({2, *witness.polygon});
    if (!witness.domain_cell) continue;
    const Simplex cell = sorted(*witness.domain_cell);
    if (rule == Rule::kDomainVertexMissing && cell.size() == 1) {
      cells.push_back({0, static_cast<std::size_t>(cell.front())});
    }
    const auto at = std::lower_bound(complex.segments.begin(), complex.segments.end(), cell);
    if (rule == Rule::kSegmentMissing && at != complex.segments.end() && *at == cell) {
      cells.push_back({1, static_cast<std::size_t>(at - complex.segments.begin())});
    }
  }
  keep_each_once(cells);
  cells.resize(std::min(cells.size(), most));
  return cells;
}

// What may be all that is wrong, each with options that allow for it, is tried in turn, until the
// claim holds.
class Remedies {
 public:
  Remedies(const Verdict& verdict, const Judged& judged, const check::Options& options)
      : verdict_(verdict),
        judged_(judged),
        options_(options),
        complex_(judged.domain.domain.complex) {}

  std::optional<std::string> note() {
    if (lacks_cell()) return std::nullopt;
    if (may_be_joined() && share_segments_in_one_plane(complex_)) {
      joined_ = with_coplanar_joined(judged_.domain);
      if (segments(*joined_) == segments(judged_.domain)) joined_.reset();
    }
    const bool holds = merged() || moved() || (!is_unsettled_ && (merged_and_moved() || bent()));
    if (!holds && is_unsettled_ && !judged_.within) {
      return "the coordinates may have been rounded: --within 1e-9x tells whether that is all "
             "that is wrong";
    }
    return std::move(note_);
  }

 private:
  // Finding out how far a mesh is moved usually takes less than to judge it. Where it takes more,
  // and more than half a second, the note proposes to find out.
  static constexpr std::size_t kLeastWork = 1'000'000;
  static constexpr std::size_t kWorkOfSimplex = 1;
  static constexpr std::size_t kMostCells = 20;

  std::size_t most_work() const {
    return kLeastWork + kWorkOfSimplex * judged_.mesh.mesh().simplices.size();
  }

  static std::size_t segments(const LoadedDomain& one) {
    return one.domain.complex.segments.size();
  }

  bool may_be_joined() const {
    return !judged_.has_merged && breaks(verdict_, Rule::kSegmentMissing) &&
           complex_.ambient_dimension() == 3;
  }

  // Does the verdict name a cell that the mesh lacks with every remedy? Such a segment must not be
  // one that goes when polygons are joined.
  bool lacks_cell() const {
    if (complex_.kind == DomainKind::kHull) return false;
    const Distance most = distance(may_be_joined() ? kBentParts : kRoundedParts);
    const check::WithoutImage without(judged_.mesh.mesh(), complex_, most.squared(complex_));
    std::optional<check::StayingSegments> staying;
    if (may_be_joined()) staying.emplace(complex_, kUsualSlope * kUsualSlope);
    const std::vector<LinearCell> cells = missing_cells(verdict_, complex_, kMostCells);
    return std::any_of(cells.begin(), cells.end(), [&](LinearCell cell) {
      const bool stays =
          !staying || (cell.dimension == 1 && staying->certainly(complex_.segments[cell.place]));
      return stays && without.certainly(cell);
    });
  }

  // Keeps the first note, or one about options with which the claim holds. Does it hold?
  bool keep(const Verdict& other, std::string note) {
    if (other.holds() || !note_) note_ = std::move(note);
    return other.holds();
  }
  static bool mends_segments(const Verdict& other) { return !breaks(other, Rule::kSegmentMissing); }

  bool merged() {
    if (!joined_ || judged_.within) return false;
    const Verdict merged = check::judge_exactly(judged_.claim, judged_.mesh.exact(),
                                                &joined_->domain, options_, judged_.mesh.known());
    return mends_segments(merged) && keep(merged, merging_note(verdict_, merged));
  }

  bool moved() {
    if (judged_.within) return false;
    const auto moved = judged_at(distance(kRoundedParts), judged_.domain);
    const bool has_moved = moved && moved->within && moved->within->squared_reach > 0;
    if (!has_moved || (joined_ && !moved->holds())) return false;
    return keep(*moved, rounding_note(verdict_, *moved));
  }

  bool merged_and_moved() {
    if (!joined_) return false;
    const auto both = judged_at(distance(kRoundedParts), *joined_);
    return both && mends_segments(*both) && keep(*both, merging_note(verdict_, *both));
  }

  // Rounded, hardly any triangles of a face are in one plane.
  bool bent() {
    if (!may_be_joined()) return false;
    const LoadedDomain& flat = joined_ ? *joined_ : judged_.domain;
    const Distance most = distance(kBentParts);
    const BentDomain bent =
        with_nearly_coplanar_joined(flat, kUsualSlope, most.squared(flat.domain.complex));
    if (bent.squared_height == 0) return false;
    check::Work work(most_work());
    const auto moved =
        judged_within(most, judged_.claim, judged_.mesh, flat.domain, options_, &bent, {}, &work);
    is_unsettled_ |= work.is_too_much();
    return moved && mends_segments(*moved) &&
           keep(*moved, bending_note(verdict_, *moved, bent.squared_height));
  }

  Distance distance(long parts) const {
    return judged_.within.value_or(Distance{Rational(1, parts), true});
  }
  tl::expected<Verdict, check::NotJudged> judged_at(const Distance& most,
                                                    const LoadedDomain& domain) {
    check::Work work(most_work());
    auto verdict =
        judged_within(most, judged_.claim, judged_.mesh, domain.domain, options_, nullptr,
                      {judged_.face_markers, domain.file.polygon_markers}, &work);
    is_unsettled_ |= work.is_too_much();
    return verdict;
  }

  const Verdict& verdict_;
  const Judged& judged_;
  const check::Options& options_;
  const PiecewiseLinearComplex& complex_;
  bool is_unsettled_ = false;           // was a search given up?
  std::optional<LoadedDomain> joined_;  // if that is not the domain itself
  std::optional<std::string> note_;
};

}  // namespace

std::optional<std::string> remedy(const Verdict& verdict, const Judged& judged,
                                  const check::Options& options) {
  if (!may_be_rounded(verdict, judged.domain.domain.complex.kind)) return std::nullopt;
  return Remedies(verdict, judged, options).note();
}

}  // namespace circumspect::cli
