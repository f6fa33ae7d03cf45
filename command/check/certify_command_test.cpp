// circumspect certify, as its users run it.
#include <filesystem>
#include <string>

#include <doctest/doctest.h>

#include "command/check/certified_meshes_test.hpp"
#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

TEST_CASE("certify: a certificate of what holds, a refutation of what does not") {
  const CertifiedMeshes meshes;
  const Run holds = run({"certify", meshes.good, "-o", meshes.cert});
  CHECK(holds.exit_code == 0);
  CHECK(holds.out ==
        "holds: delaunay " + meshes.good + " 4 points 2 triangles not-unique canonical\n");
  const std::string certificate = contents(meshes.cert);
  CHECK(begins_with(certificate, "circumspect-certificate 1 delaunay 2 canonical\n"));
  CHECK(has(certificate, "\n0 0  1 0 5\n"));  // by the user's own index
  const Run fails =
      run({"certify", meshes.bad, "--output", meshes.cert, "--claim", "triangulation"});
  CHECK(fails.exit_code == 1);
  CHECK(fails.out ==
        "fails: triangulation " + meshes.bad + " triangulation.unused-point 1 vertex 8\n");
  CHECK(begins_with(contents(meshes.cert),
                    "circumspect-refutation 2 triangulation 2 triangulation.unused-point\n"));
  CHECK(has(contents(meshes.cert), "\nbecause 4\nend\n"));
}

// A square with an edge that is halved on one side only, and its two halves.
TEST_CASE("certify: a mesh alone") {
  CertifiedMeshes meshes;
  const Run holds = run({"certify", meshes.good, "-o", meshes.cert, "--claim", "complex"});
  CHECK(holds.exit_code == 0);
  CHECK(begins_with(contents(meshes.cert), "circumspect-certificate 1 complex 2\n"));
  CHECK(has(contents(meshes.cert), "\nsimplices 2 3\n"));
  const auto refuted = [&](const std::string& points, const std::string& simplices) {
    const std::string mesh = meshes.write("mesh", points, simplices);
    const Run fails = run({"certify", mesh, "-o", meshes.cert, "--claim", "complex"});
    CHECK(fails.exit_code == 1);
    const std::string text = contents(meshes.cert);
    return text.substr(0, text.find('\n')) + " because" +
           text.substr(text.find("\nbecause ") + 8,
                       text.find("\nend") - text.find("\nbecause ") - 8);
  };
  CHECK(refuted("5 2\n0 0 0\n1 2 0\n2 2 2\n3 0 2\n4 1 1\n", "2 3\n0 0 1 2\n1 0 4 3\n") ==
        "circumspect-refutation 2 complex 2 complex.hanging-vertex because 1 2 1 1 1");
  CHECK(refuted("4 2\n0 0 0\n1 2 0\n2 2 2\n3 2 0\n", "2 3\n0 0 1 2\n1 0 3 2\n") ==
        "circumspect-refutation 2 complex 2 complex.points-equal because 2 4");
  CHECK(begins_with(refuted(kSquareFrom5, "2 3\n5 5 6 7\n6 5 6 8\n"),
                    "circumspect-refutation 2 complex 2 complex.overlap because 1 2 "));
  // A point that no simplex uses is refuted, or let pass, and then the certificate says so.
  const std::string unused =
      meshes.write("unused", "4 2\n0 0 0\n1 2 0\n2 2 2\n3 0 2\n", "1 3\n0 0 1 2\n");
  CHECK(run({"certify", unused, "-o", meshes.cert, "--claim", "complex"}).exit_code == 1);
  CHECK(has(contents(meshes.cert), " triangulation.unused-point\n"));
  CHECK(run({"certify", unused, "-o", meshes.cert, "--claim", "complex", "--allow-unused"})
            .exit_code == 0);
  const std::string passed = contents(meshes.cert);
  CHECK(begins_with(passed, "circumspect-certificate 1 complex 2 unused\n"));
  CHECK(run({"check", unused, "--certificate", meshes.cert, "--claim", "complex", "--allow-unused"})
            .exit_code == 0);
  CHECK(contents(meshes.cert) == passed);
  CHECK(run({"certify", unused, "-o", meshes.cert, "--allow-unused"}).exit_code == 2);
  // Of edges it is not known where they cross.
  const std::string crossed = meshes.write("edges", kSquareFrom5, "2 2\n5 5 7\n6 6 8\n");
  const Run none = run({"certify", crossed, "-o", meshes.cert, "--claim", "complex"});
  CHECK(none.exit_code == 2);
  CHECK(has(none.err, "there is no refutation of this mesh"));
}

TEST_CASE("certify: a convex hull, and points of one plane in space") {
  CertifiedMeshes meshes;
  const std::vector<std::string> hull = {
      "certify", meshes.write("edges", kSquareFrom5, "4 2\n5 5 6\n6 6 7\n7 7 8\n8 8 5\n"),
      "-o",      meshes.cert,
      "--claim", "convex-hull"};
  CHECK(run(hull).exit_code == 0);
  CHECK(begins_with(contents(meshes.cert),
                    "circumspect-certificate 1 convex-hull 2 triangulation\n"));
  CHECK(has(contents(meshes.cert), " -\n"));  // the summit, which is nobody's
  // Its centre is a point already, which is not a vertex.
  meshes.write("edges", "5 2\n5 0 0\n6 3 0\n7 3 3\n8 0 3\n9 1 1\n",
               "4 2\n5 5 6\n6 6 7\n7 7 8\n8 8 5\n");
  CHECK(run(hull).exit_code == 0);
  CHECK(begins_with(contents(meshes.cert),
                    "circumspect-certificate 1 convex-hull 2 weighted-delaunay\n"));
  CHECK(has(contents(meshes.cert), "\npoints 6\n"));
  meshes.write("edges", kSquareFrom5, "3 2\n5 5 6\n6 6 7\n7 7 8\n");
  const Run open = run(hull);
  CHECK(open.exit_code == 1);
  CHECK(begins_with(contents(meshes.cert),
                    "circumspect-refutation 2 convex-hull 2 hull.uncovered\n"));
  meshes.write("edges", kSquareFrom5, "0 2\n");
  const Run none = run(hull);
  CHECK(none.exit_code == 2);
  CHECK(has(none.err, "there is no refutation of this mesh: none shows that facets are not"));
  meshes.write("edges", kSquareFrom5, "4 1\n5 5\n6 6\n7 7\n8 8\n");
  CHECK(run(hull).exit_code == 0);
  CHECK(begins_with(contents(meshes.cert),
                    "circumspect-certificate 1 convex-hull 2 triangulation\n"));
  const std::string tilted = "4 3\n5 0 0 0\n6 2 0 2\n7 2 2 4\n8 0 2 2\n";
  const auto certify = [&](const std::string& claim, const std::string& rows) {
    return run(
        {"certify", meshes.write("tilted", tilted, rows), "-o", meshes.cert, "--claim", claim});
  };
  CHECK(certify("triangulation", kTwoTriangles).exit_code == 0);
  CHECK(begins_with(contents(meshes.cert), "circumspect-certificate 1 triangulation 3 flat\n"));
  // The other diagonal of the rhombus is shorter.
  CHECK(certify("delaunay", kTwoTriangles).exit_code == 1);
  CHECK(begins_with(contents(meshes.cert),
                    "circumspect-refutation 2 delaunay 3 delaunay.vertex-in-ball flat\n"));
  CHECK(certify("delaunay", "2 3\n5 5 6 8\n6 6 7 8\n").exit_code == 0);
  CHECK(begins_with(contents(meshes.cert), "circumspect-certificate 1 delaunay 3 flat\n"));
  CHECK(has(contents(meshes.cert), "\nunseen 4\n0\n1\n1\n2\n"));
}

TEST_CASE("certify: to standard output, which then holds nothing else") {
  const CertifiedMeshes meshes;
  CHECK(run({"certify", meshes.good, "-o", meshes.cert}).exit_code == 0);
  const Run result = run({"certify", meshes.good, "-o", "-"});
  CHECK(result.exit_code == 0);
  CHECK(result.out == contents(meshes.cert));
  CHECK(run({"certify", meshes.bad, "-o", "-"}).exit_code == 1);
  CHECK(run({"certify", meshes.good, "-o", "-", "--format", "json"}).exit_code == 2);
}

TEST_CASE("certify: ends when its time is up, and writes nothing") {
  CertifiedMeshes meshes;
  std::string points = "2000 2\n";
  for (int i = 0; i < 2000; ++i) {
    points += std::to_string(i) + " " + std::to_string(i) + " " + std::to_string(i * i) + "\n";
  }
  const std::string parabola = meshes.folder.write("parabola.node", points);
  const std::string mesh = meshes.folder.path("parabola.ele");
  REQUIRE(run({"build", "delaunay", parabola, "-o", mesh}).exit_code == 0);
  const Run ended =
      run({"certify", mesh, "-o", meshes.cert, "--by", "definition", "--limit", "100ms"});
  CHECK(ended.exit_code == 4);
  CHECK(begins_with(ended.out, "undecided: certify stopped by --limit after "));
  CHECK(has(ended.out, "while judging " + mesh));
  CHECK(!meshes.has_cert());
}

// A square of two triangles, and one without its corner.
constexpr const char* kOutline =
    "4 2 0 0\n5 0 0\n6 2 0\n7 2 2\n8 0 2\n4 0\n1 5 6\n2 6 7\n3 7 8\n4 8 5\n0\n";
constexpr const char* kChevron = "4 2\n5 0 0\n6 4 1\n7 0 2\n8 1 1\n";
constexpr const char* kChevronOutline =
    "4 2 0 0\n5 0 0\n6 4 1\n7 0 2\n8 1 1\n4 0\n1 5 6\n2 6 7\n3 7 8\n4 8 5\n0\n";

TEST_CASE("certify: a mesh of a domain, with what fills its hull besides") {
  CertifiedMeshes meshes;
  const std::string square = meshes.folder.write("square.poly", kOutline);
  const Run holds = run({"certify", meshes.good, "-o", meshes.cert, "--domain", square, "--claim",
                         "conforming-delaunay"});
  CHECK(holds.exit_code == 0);
  CHECK(begins_with(contents(meshes.cert),
                    "circumspect-certificate 1 conforming-delaunay 2 enclosed plc\n"));
  CHECK(has(contents(meshes.cert), "\nmarks 2\n"));
  const std::string chevron = meshes.write("chevron", kChevron, "2 3\n1 5 6 8\n2 6 7 8\n");
  const std::string outline = meshes.folder.write("chevron.poly", kChevronOutline);
  CHECK(run({"certify", chevron, "-o", meshes.cert, "--domain", outline, "--claim",
             "plc-triangulation"})
            .exit_code == 0);
  CHECK(has(contents(meshes.cert), "\nmarks 3\n"));
  CHECK(run({"certify", meshes.good, "-o", meshes.cert, "--domain", square, "--domain-kind", "hull",
             "--claim", "steiner-triangulation"})
            .exit_code == 0);
  CHECK(begins_with(contents(meshes.cert),
                    "circumspect-certificate 1 steiner-triangulation 2 hull plc\n"));
  CHECK(run({"certify", meshes.good, "-o", meshes.cert, "--domain", square, "--domain-kind", "hull",
             "--claim", "cdt"})
            .exit_code == 0);
  CHECK(begins_with(contents(meshes.cert), "circumspect-certificate 1 cdt 2 hull plc\n"));
}

// A mesh of the hull without its hole is not a mesh of the hull: certificates are about the latter.
TEST_CASE("certify refuses a hull with holes: check says something else of it than of the hull") {
  const CertifiedMeshes meshes;
  meshes.folder.write("holed.edge", "4 0\n1 5 6\n2 6 7\n3 7 8\n4 8 5\n");
  meshes.folder.write("holed.node", kSquareFrom5);
  const std::string none = meshes.folder.write("holed.ele", "0 3\n");
  const std::string square = meshes.folder.write(
      "holed.poly",
      "4 2 0 0\n5 0 0\n6 2 0\n7 2 2\n8 0 2\n4 0\n1 5 6\n2 6 7\n3 7 8\n4 8 5\n1\n1 1 1\n");
  const std::vector<std::string> about = {none,   "--domain", square, "--fill",
                                          "hull", "--claim",  "cdt"};
  std::vector<std::string> certify = {"certify", "-o", meshes.cert};
  std::vector<std::string> check = {"check"}, both = {"check", "--certificate", meshes.cert};
  for (auto* words : {&certify, &check, &both})
    words->insert(words->end(), about.begin(), about.end());
  CHECK(run(check).exit_code == 0);
  for (const auto& words : {certify, both}) {
    const Run refused = run(words);
    CHECK(refused.exit_code == 2);
    CHECK(has(refused.err, "nothing is proved of a hull with holes"));
    CHECK(!meshes.has_cert());
  }
}

TEST_CASE("certify: a refutation of a claim about a domain") {
  const CertifiedMeshes meshes;
  const std::string square = meshes.folder.write("square.poly", kOutline);
  const std::vector<std::string> bad = {"certify",  meshes.bad, "-o",      meshes.cert,
                                        "--domain", square,     "--claim", "plc-triangulation"};
  CHECK(run(bad).exit_code == 1);
  // The segment from (0, 0) to (0, 2), at its midpoint.
  CHECK(begins_with(contents(meshes.cert),
                    "circumspect-refutation 2 plc-triangulation 2 domain.segment-missing\n"));
  CHECK(has(contents(meshes.cert), "\nvertices 4\n"));
  CHECK(has(contents(meshes.cert), "\nsegments 4\n1 2\n1 4\n2 3\n3 4\nbecause 2 0 1 2\nend\n"));
  // The upper side is there, as an edge that dangles; a point makes a triangle of it.
  meshes.folder.write("bad.edge", "1 0\n1 7 8\n");
  CHECK(run(bad).exit_code == 1);
  CHECK(has(contents(meshes.cert), "\npads 1\n1 2\ndangling 1\n2  3 4  5\nvertices 4\n"));
  CHECK(has(contents(meshes.cert), "\nbecause 2 0 1 2\nend\n"));
  // A diagonal that the mesh does not have.
  const std::string diagonal = meshes.folder.write(
      "diagonal.poly",
      "4 2 0 0\n5 0 0\n6 2 0\n7 2 2\n8 0 2\n5 0\n1 5 6\n2 6 7\n3 7 8\n4 8 5\n5 6 8\n0\n");
  const std::vector<std::string> missing = {"certify",  meshes.good, "-o",      meshes.cert,
                                            "--domain", diagonal,    "--claim", "cdt"};
  CHECK(run(missing).exit_code == 1);
  CHECK(has(contents(meshes.cert), "\nbecause 4 1 1 2\nend\n"));
  // It dangles: the rule that is named has no evidence.
  std::filesystem::remove(meshes.cert);
  meshes.folder.write("good.edge", "1 0\n1 6 8\n");
  const Run dangling = run(missing);
  CHECK(dangling.exit_code == 2);
  CHECK(has(dangling.err, "there is no refutation of this mesh: domain.uncovered is broken"));
  CHECK(!meshes.has_cert());
}

TEST_CASE("certify: of three triangles at an edge of a domain two overlap") {
  CertifiedMeshes meshes;
  const std::string square = meshes.folder.write("square.poly", kOutline);
  const std::string mesh = meshes.write("three", "5 2\n5 0 0\n6 2 0\n7 2 2\n8 0 2\n9 1 0.5\n",
                                        "5 3\n1 5 6 9\n2 6 7 9\n3 7 8 9\n4 8 5 9\n5 6 9 8\n");
  const Run result = run({"certify", mesh, "-o", meshes.cert, "--domain", square});
  CHECK(result.exit_code == 1);
  CHECK(begins_with(contents(meshes.cert),
                    "circumspect-refutation 2 steiner-cdt 2 complex.overlap\n"));
}

TEST_CASE("certify: a refutation that speaks of the whole domain") {
  CertifiedMeshes meshes;
  // The wrong diagonal of a kite, by its midpoint; and the vertex beyond it that is visible.
  const std::string kite =
      meshes.write("kite", "4 2\n5 0 0\n6 6 0\n7 7 2\n8 0 2\n", "2 3\n1 5 6 7\n2 5 7 8\n");
  const std::string outline = meshes.folder.write(
      "kite.poly", "4 2 0 0\n5 0 0\n6 6 0\n7 7 2\n8 0 2\n4 0\n1 5 6\n2 6 7\n3 7 8\n4 8 5\n0\n");
  std::vector<std::string> wrong = {"certify",  kite,    "-o",      meshes.cert,
                                    "--domain", outline, "--claim", "cdt"};
  CHECK(run(wrong).exit_code == 1);
  CHECK(begins_with(contents(meshes.cert),
                    "circumspect-refutation 2 cdt 2 cdt.facet-not-local enclosed\n"));
  CHECK(has(contents(meshes.cert), "\nholes 0\npolygons 0\nbecause "));
  CHECK(has(contents(meshes.cert), " 7 2 2\nend\n"));
  wrong.insert(wrong.end(), {"--by", "definition"});
  CHECK(run(wrong).exit_code == 1);
  CHECK(begins_with(contents(meshes.cert),
                    "circumspect-refutation 2 cdt 2 cdt.visible-vertex-in-ball enclosed\n"));
}

TEST_CASE("certify: what has no certificate with a domain, and the answer says so") {
  CertifiedMeshes meshes;
  const std::string square = meshes.folder.write("square.poly", kOutline);
  const auto refused = [&](const std::vector<std::string>& arguments, const std::string& found) {
    const Run result = run(arguments);
    CHECK(result.exit_code == 2);
    CHECK(is_error_line(result.err));
    CHECK(has(result.err, found));
    CHECK(!meshes.has_cert());
  };
  refused({"certify", meshes.good, "-o", meshes.cert, "--domain", square, "--claim", "delaunay"},
          "expected no --domain for the claim delaunay, found one");
  refused({"certify", meshes.good, "-o", meshes.cert, "--domain-kind", "hull"},
          "expected --domain FILE beside --fill, --hole, --region, --resolve or --merge-coplanar, "
          "found none");
  // Polygons that were joined are in no file.
  for (const char* command : {"certify", "check"}) {
    refused({command, meshes.good, command == std::string("check") ? "--certificate" : "-o",
             meshes.cert, "--domain", square, "--merge-coplanar"},
            "expected no --merge-coplanar for a certificate, found it");
  }
  refused({"certify", meshes.good, "-o", meshes.cert, "--claim", "plc-triangulation"},
          "expected --domain FILE for the claim plc-triangulation, found none");
  refused({"check", meshes.good, "--certificate", meshes.cert, "--claim", "cdt"},
          "expected --domain FILE for the claim cdt, found none");
  refused({"check", meshes.good, "--certificate", meshes.cert, "--domain", square, "--within", "1"},
          "expected no --within beside --certificate, found it");
}

TEST_CASE("certify: the certificate of a mesh in which a segment dangles says so") {
  CertifiedMeshes meshes;
  const std::string dangling = meshes.write("dangling", "5 2\n5 0 0\n6 2 0\n7 2 2\n8 0 2\n9 4 4\n",
                                            "2 3\n1 5 6 7\n2 5 7 8\n");
  meshes.folder.write("dangling.edge", "1 0\n1 7 9\n");
  const std::string whip = meshes.folder.write(
      "whip.poly",
      "5 2 0 0\n5 0 0\n6 2 0\n7 2 2\n8 0 2\n9 4 4\n5 0\n1 5 6\n2 6 7\n3 7 8\n4 8 5\n5 7 9\n0\n");
  CHECK(
      run({"certify", dangling, "-o", meshes.cert, "--claim", "cdt", "--domain", whip}).exit_code ==
      0);
  CHECK(begins_with(contents(meshes.cert), "circumspect-certificate 1 cdt 2 enclosed dangling\n"));
}

TEST_CASE(
    "certify, check --certificate: with a domain the claim is the same where nobody says it") {
  CertifiedMeshes meshes;
  const std::string square = meshes.folder.write("square.poly", kOutline);
  CHECK(run({"certify", meshes.good, "-o", meshes.cert, "--domain", square}).exit_code == 0);
  CHECK(begins_with(contents(meshes.cert), "circumspect-certificate 1 cdt 2 enclosed plc\n"));
  const std::string fan = meshes.write("fan", "5 2\n5 0 0\n6 2 0\n7 2 2\n8 0 2\n9 1 1\n",
                                       "4 3\n1 5 6 9\n2 6 7 9\n3 7 8 9\n4 8 5 9\n");
  for (const std::string& mesh : {meshes.good, meshes.bad, fan}) {
    const Run certified = run({"certify", mesh, "-o", meshes.cert, "--domain", square});
    const std::string written = contents(meshes.cert);
    const Run checked = run({"check", mesh, "--domain", square, "--certificate", meshes.cert});
    CHECK(checked.exit_code == certified.exit_code);
    CHECK(has(checked.out, certified.out));
    CHECK(contents(meshes.cert) == written);
    CHECK(has(written, mesh == fan ? " steiner-cdt 2 " : " cdt 2 "));
  }
}

TEST_CASE("certify: hole points that are in no file are told of") {
  CertifiedMeshes meshes;
  const std::string rings =
      meshes.folder.write("rings.poly",
                          "8 2 0 0\n1 0 0\n2 9 0\n3 9 9\n4 0 9\n5 3 3\n6 6 3\n7 6 6\n8 3 6\n8 0\n"
                          "1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 7\n7 7 8\n8 8 5\n0\n");
  const std::string ring =
      meshes.write("ring", "8 2\n1 0 0\n2 9 0\n3 9 9\n4 0 9\n5 3 3\n6 6 3\n7 6 6\n8 3 6\n",
                   "8 3\n1 1 2 6\n2 1 6 5\n3 2 3 7\n4 2 7 6\n5 3 4 8\n6 3 8 7\n7 4 1 5\n8 4 5 8\n");
  for (const std::vector<std::string>& option : std::vector<std::vector<std::string>>{
           {"--fill", "even-odd"}, {"--region", "1,1"}, {"--hole", "4,4"}}) {
    std::vector<std::string> arguments = {"certify", ring, "-o", meshes.cert, "--domain", rings};
    arguments.insert(arguments.end(), option.begin(), option.end());
    const Run result = run(arguments);
    CHECK(result.exit_code == 0);
    CHECK(has(result.err + result.out, "also tell circumspect-verified of them: --hole "));
    CHECK(has(contents(meshes.cert), "\nholes 1\n"));
  }
}

TEST_CASE("certify: JSON, and nothing at all") {
  const CertifiedMeshes meshes;
  const auto json =
      document(run({"certify", meshes.good, "-o", meshes.cert, "--format", "json"}))["results"][0];
  CHECK(json["verdict"] == "holds");
  CHECK(json["certificate"] == meshes.cert);
  CHECK(run({"certify", meshes.good, "-o", meshes.cert, "--quiet"}).out.empty());
}

TEST_CASE("certify: options of the input") {
  const CertifiedMeshes meshes;
  const ScratchFolder folder;
  const std::string points = folder.write("other.node", "4 2\n1 0 0\n2 1 0\n3 1 1\n4 1 1\n");
  const std::string mesh = folder.write("other.ele", "1 3\n1 1 2 4\n");
  CHECK(run({"certify", mesh, "-o", meshes.cert}).exit_code == 3);
  CHECK(!meshes.has_cert());
  CHECK(run({"certify", mesh, "-o", meshes.cert, "--duplicates", "merge"}).exit_code == 0);
  CHECK(has(contents(meshes.cert), "\npoints 3\n"));
  CHECK(run({"certify", mesh, "--points", folder.write("p.node", kSquareFrom5), "-o", meshes.cert})
            .exit_code == 1);
  const std::string weighted =
      folder.write("w.node", "4 2 1\n1 0 0 0\n2 4 0 0\n3 0 4 0\n4 1 1 -9.5\n");
  const std::string around = folder.write("w.ele", "1 3\n1 1 2 3\n");
  CHECK(run({"certify", around, "--claim", "weighted-delaunay", "-o", meshes.cert}).exit_code == 0);
  CHECK(has(contents(meshes.cert), "scale 1 2\n"));
  CHECK(has(contents(meshes.cert), "\n2 2 -38  1 - 4\n"));
}

TEST_CASE("certify: what has no certificate, and where none can be written") {
  const CertifiedMeshes meshes;
  const ScratchFolder folder;
  folder.write("line.node", "3 2\n1 0 0\n2 1 1\n3 2 2\n");
  const std::string line = folder.write("line.ele", "2 2\n1 1 2\n2 2 3\n");
  const Run flat = run({"certify", line, "-o", meshes.cert, "--claim", "convex-hull"});
  CHECK(flat.exit_code == 2);
  CHECK(is_error_line(flat.err));
  CHECK(has(flat.err, "on one line"));
  CHECK(!meshes.has_cert());
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"certify", meshes.good},
           {"certify", meshes.good, "-o", folder.path("no/where")},
           {"certify", meshes.good, "-o", meshes.cert, "--claim", "cdt"}}) {
    const Run result = run(arguments);
    CHECK(result.exit_code == 2);
    CHECK(!result.err.empty());
    CHECK(result.out.empty());
  }
  CHECK(run({"certify", folder.path("none.ele"), "-o", meshes.cert}).exit_code == 3);
}

TEST_CASE("certify: a mesh of the plane and a domain in a plane of space are refused") {
  const ScratchFolder folder;
  const std::string domain =
      folder.write("d.poly", "3 3\n1 0 0 5\n2 3 0 5\n3 0 2 5\n1 0\n1\n3 1 2 3\n0\n");
  folder.write("m.node", "3 2\n1 0 0\n2 3 0\n3 0 2\n");
  const std::string mesh = folder.write("m.ele", "1 3\n1 1 2 3\n");
  CHECK(run({"check", mesh, "--domain", domain}).exit_code == 0);
  const Run refused = run({"certify", mesh, "--domain", domain, "-o", folder.path("c")});
  CHECK(refused.exit_code == 3);
  CHECK(has(refused.err, mesh + ": expected points of dimension 3, as the domain has them, found "
                                "dimension 2"));
}

}  // namespace
}  // namespace circumspect::cli
