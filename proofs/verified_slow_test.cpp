// The proved checker against the C++ one: of the corpus, and of a thousand random and degenerate
// meshes, whole and broken, what the oracle says is verified, and in the words of its first rule.
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>

#include <doctest/doctest.h>
#include <unistd.h>

#include "corpus/expected_table.hpp"
#include "oracle/certificate/document.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/judge/points/delaunay.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "properties/mutations/mutations.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::proofs {
namespace {

using generators::PointsCase;

// What circumspect-verified prints of a file with this text.
std::string verified(const std::string& text) {
  const auto path = std::filesystem::temp_directory_path() /
                    ("circumspect-verified-" + std::to_string(getpid()) + ".cert");
  std::ofstream(path) << text;
  const std::string command = CIRCUMSPECT_VERIFIED " " + path.string();
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  REQUIRE(pipe);
  std::string line;
  std::array<char, 256> part = {};
  while (fgets(part.data(), part.size(), pipe.get()) != nullptr) line += part.data();
  std::filesystem::remove(path);
  return line;
}

struct Answer {
  std::string expected;  // how the line begins
  std::string found;
  std::string ending = "\n";  // and how it ends

  bool is_right() const {
    return found.starts_with(expected) && found.ends_with(ending) &&
           (ending != "\n" || found.find("canonical") == std::string::npos);
  }
};

Answer answer_of(const ExactMesh& mesh, const Verdict& verdict) {
  const auto document = certificate::document_of(mesh, verdict);
  if (!document) return {"a document", document.error()};
  std::ostringstream text;
  certificate::write(text, mesh, *document);
  const std::string claim(name(verdict.claim()));
  if (std::holds_alternative<certificate::FlatCertificate>(*document)) {
    return {"verified: " + claim + ", ", verified(text.str()), ", in one plane\n"};
  }
  if (std::holds_alternative<certificate::LineCertificate>(*document)) {
    return {"verified: " + claim + ", ", verified(text.str()),
            mesh.points.size() == 1 ? ", in one place\n" : ", on one line\n"};
  }
  if (verdict.holds()) {
    const std::string standing = verdict.unique.value_or(false)      ? ", unique, canonical\n"
                                 : verdict.canonical.value_or(false) ? ", canonical\n"
                                                                     : "\n";
    return {"verified: " + claim + ", ", verified(text.str()), standing};
  }
  const auto& refutation = std::get<certificate::RefutationWithPoints>(*document).refutation;
  return {"verified: not " + claim + ", " + std::string(identifier(refutation.rule)),
          verified(text.str())};
}

bool spans_plane_or_space(const PointSet& points) {
  const int d = static_cast<int>(points.ambient_dimension());
  return (d == 2 || d == 3) && points.dimension() == d;
}

bool lie_lower_in_plane_or_space(const PointSet& points) {
  const std::size_t d = points.ambient_dimension();
  return (d == 2 || d == 3) && !points.empty() && !spans_plane_or_space(points);
}

// The one rule that the corpus breaks of such points and that has no refutation.
bool is_refuted(const std::set<std::string>& rules) {
  return rules != std::set<std::string>{"triangulation.hull-not-closed"};
}

// Rules of the options, not of the claim.
bool is_about_options(const std::set<std::string>& rules) {
  return rules == std::set<std::string>{"simplex.orientation"} ||
         rules == std::set<std::string>{"complex.wrong-neighbor"};
}

TEST_CASE("each verdict of the corpus in the plane and in space is verified") {
  std::size_t accepted = 0;
  std::size_t refuted = 0;
  std::size_t lower = 0;
  for (const corpus::Row& row : corpus::expected_rows()) {
    if (is_about_options(row.broken) || corpus::is_of_a_mesh_alone(row)) continue;
    INFO(row.text);
    const ExactMesh mesh = corpus::mesh_of(row);
    const bool lies_lower = lie_lower_in_plane_or_space(mesh.points);
    if (!spans_plane_or_space(mesh.points) && !lies_lower) continue;
    if (lies_lower && !is_refuted(row.broken)) continue;
    const Verdict verdict = check::judge_exactly(row.claim, mesh, nullptr, row.options);
    if (lies_lower) ++lower;
    CHECK(verdict.holds() == row.broken.empty());
    const Answer answer = answer_of(mesh, verdict);
    CHECK_MESSAGE(answer.is_right(), answer.expected << " found " << answer.found);
    ++(verdict.holds() ? accepted : refuted);
  }
  MESSAGE(accepted << " certificates and " << refuted << " refutations of the corpus verified");
  CHECK(accepted > 100);
  CHECK(refuted > 50);
  CHECK(lower >= 18);
}

TEST_CASE("verdicts on a thousand random and degenerate meshes, whole and broken, are verified") {
  std::size_t accepted = 0;
  std::size_t refuted = 0;
  for (const std::size_t d : {2u, 3u}) {
    for (const bool is_weighted : {false, true}) {
      CAPTURE(d);
      CAPTURE(is_weighted);
      CHECK(properties::holds("what the oracle says is verified", 750, [&] {
        const auto sets = generators::any_point_set(d, 12);
        const PointsCase set =
            is_weighted ? *generators::weighted(sets) : *generators::unweighted(sets);
        const PointSet points(set.points, set.weights);
        RC_PRE(spans_plane_or_space(points));
        std::vector<Simplex> simplices = delaunay::bowyer_watson(points).simplices();
        const int kind = *rc::gen::inRange(0, 3);
        if (kind == 1) simplices = (*properties::corruption(simplices, points.size())).simplices;
        if (kind == 2) simplices = (*properties::alteration(simplices, points.size())).simplices;
        const Claim claim = points.is_weighted()          ? Claim::kWeightedDelaunay
                            : *rc::gen::arbitrary<bool>() ? Claim::kDelaunay
                                                          : Claim::kTriangulation;
        const ExactMesh mesh{points, simplices};
        const Verdict verdict = check::judge_points(claim, mesh);
        const Answer answer = answer_of(mesh, verdict);
        RC_ASSERT(answer.is_right());
        ++(verdict.holds() ? accepted : refuted);
      }));
    }
  }
  MESSAGE(accepted << " certificates and " << refuted << " refutations of random meshes verified");
  CHECK(properties::occurs(accepted, 500));
  CHECK(properties::occurs(refuted, 300));
}

}  // namespace
}  // namespace circumspect::proofs
