// Replays findings/: the mesh that each program wrote is judged against what it was given, and
// breaks the rule that expected.tsv names. Needs none of the programs; findings/reproduce.sh runs
// them.
#include <algorithm>
#include <filesystem>
#include <optional>

#include <circumspect/judgement.hpp>
#include <doctest/doctest.h>

#include "corpus/domain_table.hpp"
#include "inputs/cases.hpp"
#include "oracle/formats/voronoi_file.hpp"
#include "oracle/judge/arrays/mesh_of.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/judge/voronoi/judge_voronoi.hpp"

namespace circumspect::corpus {
namespace {

namespace fs = std::filesystem;

const std::string kFindings = CIRCUMSPECT_CORPUS_DIR "/findings/";

// One line: a name; a claim, with the kind of the domain if it is one; the rule that is broken
// first, or how the program ended without a mesh; the file that it read; the mesh that it wrote or
// vouched for, "-" if there is none; the command, for people.
struct FindingRow {
  std::string name;
  std::vector<std::string> claim;
  std::string outcome;
  std::string input;
  std::string mesh;
  std::string text;
};

std::vector<FindingRow> finding_rows() {
  std::ifstream file(kFindings + "expected.tsv");
  std::vector<FindingRow> rows;
  for (std::string line; std::getline(file, line);) {
    const std::vector<std::string> cells = split(line, '\t');
    rows.push_back({cells.at(0), split(cells.at(1), ' '), cells.at(2), kFindings + cells.at(3),
                    cells.at(4) == "-" ? "" : kFindings + cells.at(4), line});
  }
  return rows;
}

// The claim about points; none if it is about a domain.
std::optional<Claim> claim_about_points(const FindingRow& row) {
  for (const Claim claim : {Claim::kDelaunay, Claim::kConvexHull}) {
    if (row.claim.at(0) == name(claim)) return claim;
  }
  return std::nullopt;
}
bool is_about_points(const FindingRow& row) { return claim_about_points(row).has_value(); }

formats::RawPoints points_of(const FindingRow& row) {
  auto raw = formats::read_points(row.input, NumberReading::kDouble);
  if (!raw) throw std::runtime_error(raw.error().to_string());
  return std::move(*raw);
}

// The rule by which campaigns name a failure: the first of those that are broken.
std::string first_rule(const Verdict& verdict) {
  return verdict.holds() ? "" : std::string(identifier(verdict.tallies().begin()->first));
}

// A program that writes indices alone means the points that it read.
std::string rule_of_points(const FindingRow& row) {
  const auto points = generators::array({points_of(row).points.points.points(), {}});
  auto raw = formats::read_mesh({.mesh = row.mesh, .points = row.input});
  if (!raw) return raw.error().to_string();
  const std::vector<Simplex> simplices = raw->mesh.simplices.lists();
  const ExactMesh mesh =
      arrays::exact_mesh_of(points, SimplexArray(simplices.begin(), simplices.end()));
  return first_rule(
      check::judge_exactly(*claim_about_points(row), mesh, nullptr, {.max_violations = 1}));
}

// How far cells may be off: "1e-6x" is a multiple of the longest side of the box of the sites.
Rational distance_of(const std::string& text, const std::vector<Point>& sites) {
  Rational longest = 0;
  for (std::size_t axis = 0; axis < sites.front().size(); ++axis) {
    const auto [low, high] =
        std::minmax_element(sites.begin(), sites.end(),
                            [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; });
    longest = std::max<Rational>(longest, (*high)[axis] - (*low)[axis]);
  }
  REQUIRE(text.ends_with("x"));
  return read_number(text.substr(0, text.size() - 1), NumberReading::kDecimal).value() * longest;
}

std::string rule_of_diagram(const FindingRow& row) {
  const std::vector<Point> sites = points_of(row).points.points.points();
  const auto source = formats::load(row.mesh);
  REQUIRE(source);
  const auto file = formats::read_voronoi(*source, NumberReading::kDouble);
  REQUIRE(file);
  const Rational distance = distance_of(row.claim.at(1), sites);
  const VoronoiDiagram diagram{PointSet(sites), file->vertices, file->cells, file->neighbors};
  return first_rule(check::judge_voronoi(diagram, {}, distance * distance, false, 1));
}

std::string rule_of_domain(const FindingRow& row) {
  const DomainKind kind = row.claim.back() == "hull" ? DomainKind::kHull : DomainKind::kEnclosed;
  return first_rule(check::judge_domain(claim_about_a_domain(row.claim.at(0)),
                                        mesh_with_faces(row.mesh), domain_of(row.input, kind),
                                        {.max_violations = 1}));
}

std::string rule_of(const FindingRow& row) {
  if (row.claim.at(0) == "voronoi") return rule_of_diagram(row);
  return is_about_points(row) ? rule_of_points(row) : rule_of_domain(row);
}

}  // namespace

TEST_CASE("each mesh that was found breaks the rule that it was found for") {
  std::size_t judged = 0;
  for (const FindingRow& row : finding_rows()) {
    INFO(row.text);
    if (row.mesh.empty()) continue;
    CHECK(rule_of(row) == row.outcome);
    ++judged;
  }
  CHECK(judged >= 10);
}

TEST_CASE("what a program crashed on, or never ended on, is an input without fault") {
  for (const FindingRow& row : finding_rows()) {
    INFO(row.text);
    if (!row.mesh.empty()) continue;
    if (is_about_points(row)) {
      CHECK_NOTHROW(points_of(row));
    } else {
      CHECK_NOTHROW(domain_of(row.input, DomainKind::kEnclosed));
    }
  }
}

TEST_CASE("expected.tsv names every file of findings/") {
  std::set<std::string> names;
  for (const FindingRow& row : finding_rows()) names.insert(row.name);
  for (const auto& entry : fs::directory_iterator(kFindings)) {
    const std::string file = entry.path().filename().string();
    if (entry.path().extension() == ".py" || file == "README.md" || file == "expected.tsv" ||
        file == "reproduce.sh") {
      continue;
    }
    CHECK_MESSAGE(names.contains(file.substr(0, file.find('.'))), file);
  }
}

}  // namespace circumspect::corpus
