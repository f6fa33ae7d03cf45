// Certificates that claims hold.
#include "oracle/certificate/certificate.hpp"

#include <sstream>

#include <doctest/doctest.h>

#include "oracle/certificate/accepted_test.hpp"
#include "oracle/certificate/document.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"

namespace circumspect::certificate {
namespace {

// Requires: the claim holds.
std::string certificate_text(const ExactMesh& mesh, Claim claim = Claim::kDelaunay) {
  const Verdict verdict = check::judge_exactly(claim, mesh);
  REQUIRE(verdict.holds());
  const std::string text = text_of(mesh, *document_of(mesh, verdict));
  CHECK(fault_of(mesh, verdict, text) == "");
  // From the arrays of the mesh it is the same.
  const Mesh rows = in_rows(mesh);
  const auto from_rows = certificate_of(rows, verdict);
  CHECK(from_rows.has_value() == (claim != Claim::kWeightedDelaunay));
  if (from_rows) {
    std::ostringstream written;
    write(written, rows, *from_rows);
    CHECK(written.str() == text);
  }
  return text;
}

ExactMesh square() {
  return {PointSet({{0, 0}, {2, 0}, {2, 2}, {0, 2}}), {{0, 1, 2}, {0, 3, 2}}, {}, 1};
}

TEST_CASE("the certificate of a triangle, as it stands in the file") {
  const ExactMesh mesh{PointSet({{0, 0}, {3, 0}, {0, Rational(3, 2)}}), {{0, 2, 1}}, {}, 7};
  CHECK(certificate_text(mesh) ==
        "circumspect-certificate 1 delaunay 2 unique\n"
        "scale 3 2\n"
        "points 3\n"
        "0 0  1 0 7\n"
        "0 1  1 2 9\n"
        "2 0  1 1 8\n"
        "simplices 1\n"
        "1 3 2  - 3 - 2 - 1  -\n"
        "hull 3\n"
        "1 2  3 1 2 1\n"
        "1 1  3 0 1 1\n"
        "1 0  2 0 1 0\n"
        "sample 1 2 1 3\n"
        "end\n");
}

TEST_CASE("the certificate of a square, with an orientation turned and a facet between") {
  const std::string text = certificate_text(square(), Claim::kTriangulation);
  CHECK(text.find("circumspect-certificate 1 triangulation 2\nscale 2 1\n") == 0);
  CHECK(text.find("simplices 2\n1 3 4  - 3 2 2 - 1  -\n1 4 2  - 4 - 2 1 1  2\n") !=
        std::string::npos);
}

TEST_CASE("labels are the user's own") {
  ExactMesh mesh = square();
  mesh.labels = {10, 30, 20, -4};
  const std::string text = certificate_text(mesh);
  CHECK(text.find("0 0  1 0 10\n0 1  2 2 -4\n") != std::string::npos);
}

TEST_CASE("weighted points that are not vertices are given the simplex that contains them") {
  const PointSet points({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {3, 1}, {2, 2}, {4, 2}},
                        {0, 0, 0, 0, -9, -9, -9});
  const ExactMesh mesh{points, {{0, 1, 2}, {0, 3, 2}}};
  const std::string text = certificate_text(mesh, Claim::kWeightedDelaunay);
  CHECK(text.find("3 1 -9  1 - 4\n") != std::string::npos);
  CHECK(text.find("4 2 -9  1 - 6\n") != std::string::npos);
  CHECK(text.find("2 2 -9  ") != std::string::npos);
}

TEST_CASE("a certificate in space") {
  // A cube in five tetrahedra.
  std::vector<Point> corners;
  for (int i = 0; i < 8; ++i) corners.push_back({i & 1, (i >> 1) & 1, (i >> 2) & 1});
  const ExactMesh mesh{PointSet(corners),
                       {{0, 3, 5, 6}, {1, 0, 3, 5}, {2, 0, 3, 6}, {4, 0, 5, 6}, {7, 3, 5, 6}}};
  const std::string text = certificate_text(mesh);
  CHECK(text.find("simplices 5\n") != std::string::npos);
  CHECK(text.find("hull 12\n") != std::string::npos);
  CHECK(text.find("sample 1 1 1 1 2\n") != std::string::npos);
}

TEST_CASE("the certificate of a mesh alone, as it stands in the file") {
  // Two triangles that meet in a point: of all lines through it only x = 2 parts them.
  const ExactMesh mesh{PointSet({{0, 0}, {0, 4}, {2, 2}, {4, 0}, {4, 4}}), {{0, 1, 2}, {3, 4, 2}}};
  const auto document = document_of(mesh, Verdict(Claim::kComplex, mesh, 1));
  REQUIRE(document);
  const std::string text = text_of(mesh, *document);
  CHECK(text.find("circumspect-certificate 1 complex 2\nscale 2 1\npoints 5\n"
                  "0 0  1 0 0\n0 2  1 1 1\n1 1  2 2 2\n2 0  2 0 3\n2 2  2 1 4\n"
                  "simplices 2 3\n1 2 3  1  2 ") == 0);
  CHECK(text.find("\n4 5 3  2\norder 2\n1\n2\nend\n") != std::string::npos);
}

TEST_CASE("a triangle in space is certified with a point beside it") {
  const ExactMesh mesh{PointSet({{0, 0, 0}, {0, 0, 2}, {0, 2, 0}}), {{0, 1, 2}}};
  const auto document = document_of(mesh, Verdict(Claim::kComplex, mesh, 1));
  REQUIRE(document);
  CHECK(text_of(mesh, *document).find("simplices 1 3\n1 2 3  1  1 0 0\n") != std::string::npos);
}

TEST_CASE("the certificate of points on a line, as it stands in the file") {
  const ExactMesh mesh{PointSet({{2, 4, 0}, {0, 0, 0}, {1, 2, 0}}), {{0, 2}, {1, 2}}};
  const auto document = document_of(mesh, Verdict(Claim::kDelaunay, mesh, 1));
  REQUIRE(document);
  CHECK(text_of(mesh, *document) ==
        "circumspect-certificate 1 delaunay 3 line\nscale 1 1\n"
        "points 3\n0 0 0  1\n1 2 0  2\n2 4 0  0\n"
        "simplices 2\n3 2\n1 2\norder 2\n2\n1\n"
        "pads 2\n2 5 0\n2 4 1\nend\n");
}

TEST_CASE("without a plane or a space, or of another claim, there is none, and it says why") {
  const auto refusal = [](const ExactMesh& mesh, Claim claim) {
    const auto document = document_of(mesh, Verdict(claim, mesh, 1));
    return document ? "" : document.error();
  };
  CHECK(refusal(square(), Claim::kDelaunay) == "");
  CHECK(refusal(square(), Claim::kCdt).find("found cdt") != std::string::npos);
  CHECK(refusal({PointSet({{0, 0}, {1, 1}}), {{0, 1}}}, Claim::kDelaunay) == "");
  CHECK(refusal({PointSet({{0, 0}, {1, 1}}), {{0, 1}}}, Claim::kConvexHull).find("on one line") !=
        std::string::npos);
  const std::vector<Point> two_of_line = {{0}, {1}};
  CHECK(refusal({PointSet(two_of_line), {{0, 1}}}, Claim::kDelaunay).find("found dimension 1") !=
        std::string::npos);
  CHECK(refusal({PointSet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), {{0, 1, 2}}}, Claim::kDelaunay) ==
        "");
  CHECK(refusal({PointSet(std::vector<Point>{{0, 0}}), {{0}}}, Claim::kConvexHull)
            .find("in one place") != std::string::npos);
  CHECK(refusal({PointSet(std::vector<Point>()), {}}, Claim::kDelaunay).find("found none") !=
        std::string::npos);
}

// So that what the acceptor accepts says something.
TEST_CASE("the acceptor of the tests finds each condition broken") {
  const std::string good = certificate_text(square());
  const auto verdict_with = [&](const std::string& line, const std::string& other) {
    std::string text = good;
    const std::size_t at = text.find(line + "\n");
    REQUIRE(at != std::string::npos);
    text.replace(at, line.size(), other);
    return CertificateAcceptor(text).verdict();
  };
  CHECK(CertificateAcceptor(good).verdict() == "accepted");
  CHECK(verdict_with("0 1  2 2 4", "0 0  2 2 4") == "points-increasing");
  CHECK(verdict_with("0 1  2 2 4", "0 1  2 1 4") == "point-used");
  CHECK(verdict_with("1 3 4  - 3 2 2 - 1  -", "1 3 5  - 3 2 2 - 1  -") == "vertex-known");
  CHECK(verdict_with("1 3 4  - 3 2 2 - 1  -", "3 1 4  2 2 - 3 - 1  -") == "simplex-positive");
  CHECK(verdict_with("1 3 4  - 3 2 2 - 1  -", "1 3 4  - 3 2 1 - 1  -") == "facet-matched");
  CHECK(verdict_with("1 4 2  - 4 - 2 1 1  2", "1 4 2  - 4 - 2 - 1  2") == "back-pointer");
  CHECK(verdict_with("1 3 4  - 3 2 2 - 1  -", "1 3 4  - 2 2 2 - 1  -") == "hull-pointer");
  CHECK(verdict_with("sample 1 2 1 3", "sample 2 2 1 3") == "sample-outside");
  CHECK(verdict_with("sample 1 2 1 3", "sample 1 1 2 3") == "sample-inside");
  CHECK(verdict_with("1 4 2  - 4 - 2 1 1  2", "1 4 2  - 4 - 2 1 1  1") == "sample-outside");
  CHECK(verdict_with("1 2  3 1 2 1", "1 2  3 1 3 1") == "ridge-matched");
  CHECK(verdict_with("1 2  3 1 2 1", "1 2  2 1 2 1") == "ridge-matched");
  CHECK(verdict_with("2 1  4 0 1 1", "2 1  4 0 1 0") == "ridge-back-pointer");
}

TEST_CASE("the acceptor of the tests finds a notch, and a facet that is not locally Delaunay") {
  const auto verdict_of = [](const ExactMesh& mesh) {
    const Certificate certificate =
        certificate_of(mesh, Claim::kDelaunay, *scaled_to_integers(mesh.points));
    return CertificateAcceptor(text_of(mesh, certificate)).verdict();
  };
  const PointSet notched({{0, 0}, {4, 1}, {8, 0}, {4, 7}});
  CHECK(verdict_of({notched, {{0, 1, 3}, {1, 2, 3}}}) == "hull-locally-convex");
  const PointSet flat({{0, 0}, {2, -1}, {4, 0}, {2, 1}});
  CHECK(verdict_of({flat, {{0, 1, 2}, {2, 3, 0}}}) == "facet-locally-delaunay");
}

}  // namespace
}  // namespace circumspect::certificate
