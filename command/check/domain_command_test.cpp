// check --domain, inspect of a domain and build of its triangulations, as their users run them.
#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

const std::string kFour = "4 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n";
const std::string kFourFacets = "4 0\n3 1 2 3\n3 1 2 4\n3 1 3 4\n3 2 3 4\n0\n";

// The unit cube from 0, its faces squares; `lift` raises one corner.
std::string lifted_cube(const std::string& lift = "1") {
  return "8 3\n0 0 0 0\n1 1 0 0\n2 1 1 0\n3 0 1 0\n4 0 0 1\n5 1 0 1\n6 1 1 " + lift +
         "\n7 0 1 1\n6\n1\n4 0 1 2 3\n1\n4 4 5 6 7\n1\n4 0 1 5 4\n1\n4 1 2 6 5\n1\n4 2 3 7 6\n"
         "1\n4 3 0 4 7\n0\n";
}

// Schonhardt's polyhedron: a prism whose top is twisted, so that no tetrahedron fits in.
const std::string kSchonhardt =
    "OFF\n6 8 0\n8 0 0\n-4 7 0\n-4 -7 0\n7 4 9\n-7 4 9\n0 -8 9\n3 0 1 2\n3 3 4 5\n"
    "3 0 1 4\n3 1 2 5\n3 2 0 3\n3 0 4 3\n3 1 5 4\n3 2 3 5\n";

std::string line_of_verdict(const std::string& text) {
  if (text.empty()) return "";
  const std::size_t before = text.rfind('\n', text.size() - 2);
  return text.substr(before == std::string::npos ? 0 : before + 1);
}

struct Tetrahedron {
  ScratchFolder folder;
  std::string domain = folder.write("t.smesh", kFour + kFourFacets);
  std::string mesh;
  Tetrahedron() {
    folder.write("t.1.node", kFour);
    mesh = folder.write("t.1.ele", "1 4\n1 1 2 3 4\n");
  }
};

}  // namespace

TEST_CASE("check --domain: the default claim is cdt, or steiner-cdt with more vertices") {
  const Tetrahedron files;
  const Run cdt = run({"check", files.mesh, "--domain", files.domain});
  CHECK(cdt.exit_code == 0);
  CHECK(begins_with(cdt.out, "domain: " + files.domain +
                                 " enclosed, what its polygons enclose\nholds: cdt " + files.mesh +
                                 " 4 points 1 tetrahedron"));
  CHECK(cdt.err.empty());
  files.folder.write("s.node", "5 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 .125 .125 .125\n");
  const std::string steiner =
      files.folder.write("s.ele", "4 4\n1 1 2 3 5\n2 1 2 4 5\n3 1 3 4 5\n4 2 3 4 5\n");
  const Run result = run({"check", steiner, "--domain", files.domain});
  CHECK(result.exit_code == 0);
  CHECK(begins_with(line_of_verdict(result.out),
                    "holds: steiner-cdt " + steiner + " 5 points 4 tetrahedra"));
  const Run strict = run({"check", steiner, "--domain", files.domain, "--claim", "cdt"});
  CHECK(strict.exit_code == 1);
  CHECK(has(strict.out, "domain.steiner-forbidden"));
  for (const char* claim : {"plc-triangulation", "steiner-triangulation", "conforming-delaunay"}) {
    CHECK(run({"check", files.mesh, "--domain", files.domain, "--claim", claim}).exit_code == 0);
  }
}

TEST_CASE("check --domain: JSON names the domain") {
  const Tetrahedron files;
  const auto json =
      document(run({"check", files.mesh, "--domain", files.domain, "--format", "json"}));
  CHECK(json["results"][0]["verdict"] == "holds");
  CHECK(json["results"][0]["domain"] == files.domain);
  CHECK(json["results"][0]["domain_kind"] == "enclosed");
}

TEST_CASE("check --domain: claims and domains that do not go together are usage errors") {
  const Tetrahedron files;
  CHECK(run({"check", files.mesh, "--claim", "cdt"}).exit_code == 2);
  CHECK(run({"check", files.mesh, "--domain-kind", "hull"}).exit_code == 2);
  CHECK(run({"check", files.mesh, "--domain", files.domain, "--claim", "delaunay"}).exit_code == 2);
}

TEST_CASE("check --domain: dangling triangles and edges are in the .face and .edge files") {
  const ScratchFolder folder;
  const std::string points = kFour.substr(4) + "5 3 3 3\n6 4 3 3\n7 3 4 3\n8 9 9 9\n";
  const std::string domain =
      folder.write("t.poly", "8 3\n" + points +
                                 "6\n1\n3 1 2 3\n1\n3 1 2 4\n1\n3 1 3 4\n1\n3 2 3 4\n1\n3 5 6 7\n"
                                 "1\n2 5 8\n0\n");
  folder.write("t.1.node", "8 3\n" + points);
  const std::string mesh = folder.write("t.1.ele", "1 4\n1 1 2 3 4\n");
  const Run without = run({"check", mesh, "--domain", domain});
  CHECK(without.exit_code == 1);
  CHECK(has(without.out, "domain.segment-missing"));
  folder.write("t.1.face", "2 0\n1 1 2 3\n2 5 6 7\n");
  folder.write("t.1.edge", "1 0\n1 5 8\n");
  const Run with = run({"check", mesh, "--domain", domain});
  CHECK_MESSAGE(with.exit_code == 0, with.out);
}

TEST_CASE("a domain at fault: exit code 3, with the line and the distance") {
  const Tetrahedron files;
  const std::string domain = files.folder.write("bad.poly", lifted_cube("1.125"));
  const Run result = run({"check", files.mesh, "--domain", domain});
  CHECK(result.exit_code == 3);
  CHECK(result.out.empty());
  CHECK(is_error_line(result.err));
  CHECK(begins_with(result.err, "circumspect: " + domain +
                                    ":13: expected a piecewise linear complex, found "
                                    "plc.polygon-not-planar: "));
  CHECK(has(result.err, "polygon 2 (line 13)"));
  CHECK(has(result.err, "vertices 4 5 6 7, ~ 0.031128640318234518"));
  CHECK(has(result.err, " off the plane that is nearest to all its vertices"));
  const Run inspected = run({"inspect", domain});
  CHECK(inspected.exit_code == 3);
  CHECK(inspected.err.empty());
  CHECK(has(inspected.out, "plc.polygon-not-planar: "));
  const auto json = document(run({"inspect", domain, "--format", "json"}));
  CHECK(json["results"][0]["valid"] == false);
  CHECK(json["results"][0]["breaches"][0]["rule"] == "plc.polygon-not-planar");
  CHECK(json["results"][0]["breaches"][0]["polygons"][0]["line"] == 13);
  CHECK(json["results"][0]["breaches"][0]["squared_distance"] == "1/1032");
}

TEST_CASE("a domain at fault: when breaches are left out, it is said") {
  // Crossing segments: three with each other make three breaches.
  const ScratchFolder folder;
  const std::string domain = folder.write("star.poly",
                                          "6 2\n1 0 0\n2 4 4\n3 0 4\n4 4 0\n5 0 1\n6 4 2\n3 0\n"
                                          "1 1 2\n2 3 4\n3 5 6\n0\n");
  const Run all = run({"inspect", domain});
  CHECK(all.exit_code == 3);
  CHECK(!has(all.out, "stopped"));
  CHECK(has(all.out, " not a piecewise linear complex, 3 breaches, first plc."));
  const auto whole = document(run({"inspect", domain, "--format", "json"}))["results"][0];
  CHECK(whole["breaches"].size() == 3);
  CHECK(whole["truncated"] == false);
  CHECK(run({"inspect", domain, "--max-errors", "0"}).out == all.out);
  CHECK(run({"inspect", domain, "--max-errors", "3"}).out == all.out);
  const Run cut = run({"inspect", domain, "--max-errors", "2"});
  CHECK(has(cut.out, "\n… stopped at 2; --max-errors 0 lists all\ninspected: "));
  CHECK(has(cut.out, " not a piecewise linear complex, more than 2 breaches, first "));
  const auto part =
      document(run({"inspect", domain, "--max-errors", "2", "--format", "json"}))["results"][0];
  CHECK(part["breaches"].size() == 2);
  CHECK(part["truncated"] == true);
  const Tetrahedron files;
  CHECK(has(run({"check", files.mesh, "--domain", domain}).err, " (and 2 more)\n"));
  const Run checked = run({"check", files.mesh, "--domain", domain, "--max-errors", "1"});
  CHECK(checked.exit_code == 3);
  CHECK(is_error_line(checked.err));
  CHECK(
      has(checked.err, " (and at least 1 more; `circumspect inspect --max-errors 0` lists all)\n"));
}

TEST_CASE(
    "check --domain: what is missing is told with what is nearest, and Steiner points are named") {
  const Tetrahedron files;
  files.folder.write("off.node", "4 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1.0000000000000002\n");
  const std::string off = files.folder.write("off.ele", "1 4\n1 1 2 3 4\n");
  const Run text = run({"check", off, "--domain", files.domain, "--claim", "steiner-cdt"});
  CHECK(text.exit_code == 1);
  CHECK(has(text.out, "  nearest  vertex 4 at (0, 0, 1.0000000000000002), squared distance "));
  CHECK(has(text.out, ", distance ~ 2.220446049250313e-16\n"));
  const std::vector<std::string> json = {"check",   off,           "--domain", files.domain,
                                         "--claim", "steiner-cdt", "--format", "json"};
  const auto result = document(run(json))["results"][0];
  const auto nearest = result["violations"][0]["nearest"];
  CHECK(nearest["vertex"] == 4);
  CHECK(nearest["distance_decimal"] == "2.220446049250313e-16");
  CHECK(nearest["squared_distance"]["exact"] == "1/20282409603651670423947251286016");
  CHECK(result["violations"][0]["coordinates"].contains("4"));
  CHECK(result["steiner_vertices"]["count"] == 1);
  CHECK(result["steiner_vertices"]["first"][0]["vertex"] == 4);
  CHECK(result["steiner_vertices"]["truncated"] == false);
}

TEST_CASE("a domain at fault: duplicates, unless they are merged") {
  const ScratchFolder folder;
  const std::string twice =
      folder.write("d.smesh",
                   "5 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 0 0 0\n4 0\n3 1 2 3\n"
                   "3 5 2 4\n3 1 3 4\n3 2 3 4\n0\n");
  const Run reject = run({"inspect", twice});
  CHECK(reject.exit_code == 3);
  CHECK(has(reject.out, "plc.duplicate-vertex"));
  const Run merge = run({"inspect", twice, "--duplicates", "merge"});
  CHECK_MESSAGE(merge.exit_code == 0, (merge.out + merge.err));
  CHECK(has(merge.out, "note: " + twice + ": 1 point merged with an equal one\n"));
  CHECK(has(merge.out, " 4 vertices 6 segments 4 polygons 1 polyhedron enclosed "));
}

TEST_CASE("a domain at fault: notes say how the file was read, where the fault names points") {
  const ScratchFolder folder;
  const std::string bent = folder.write(
      "gaps.msh",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n10 0 0 0\n20 1 0 0\n30 1 1 0\n40 0 1 1\n"
      "$EndNodes\n$Elements\n1\n1 3 2 0 1 10 20 30 40\n$EndElements\n");
  const std::string note =
      bent + ": the tags of nodes leave gaps; nodes are counted from 1 in their order";
  const Run inspected = run({"inspect", bent, "--domain"});
  CHECK(inspected.exit_code == 3);
  CHECK(inspected.out.starts_with("note: " + note + "\nplc.polygon-not-planar"));
  CHECK(document(run(
            {"inspect", bent, "--domain", "--format", "json"}))["results"][0]["notes"][0] == note);
  CHECK(run({"check", bent, "--domain", bent}).out == "note: " + note + "\n");
  CHECK(run({"certify", bent, "--domain", bent, "--claim", "cdt", "-o", folder.path("c")}).out ==
        "note: " + note + "\n");
}

TEST_CASE("inspect: what a domain is made of, and its canonical CDT") {
  const ScratchFolder folder;
  const std::string domain = folder.write("cube.poly", lifted_cube());
  const Run result = run({"inspect", domain, "--all-segments"});
  CHECK(result.exit_code == 0);
  CHECK(has(result.out, "segment 0 1: strongly-delaunay, present\n"));
  CHECK(has(result.out, "constrained Delaunay triangulation: canonical (proved)\n"));
  CHECK(line_of_verdict(result.out) ==
        "inspected: " + domain +
            " 8 vertices 12 segments 6 polygons 1 polyhedron enclosed "
            "edge-protected cdt canonical\n");
  const auto json = document(run({"inspect", domain, "--format", "json"}));
  CHECK(json["results"][0]["cdt"] == "canonical");
  CHECK(json["results"][0]["protection"].size() == 12);
  const std::string off = folder.write("cube.off", kSchonhardt);
  CHECK(has(run({"inspect", off}).out, "generic"));
  CHECK(has(run({"inspect", off, "--domain"}).out, " 1 polyhedron "));
}

TEST_CASE("inspect: adopted cells and hole seeds outside are told") {
  const ScratchFolder folder;
  const std::string domain =
      folder.write("a.poly",
                   "6 2\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 1 1\n6 2 1\n5 0\n1 1 2\n2 2 3\n"
                   "3 3 4\n4 4 1\n5 5 6\n1\n1 9 9\n");
  const Run plane = run({"inspect", domain});
  CHECK(plane.exit_code == 0);
  CHECK(has(plane.out, "hole seed 1 at (9, 9): ignored, it is in nothing enclosed\n"));
  CHECK(has(plane.out, " 6 vertices 5 segments 1 region enclosed "));
  const std::string space =
      folder.write("b.poly", "4 3\n1 0 0 0\n2 4 0 4\n3 0 4 0\n4 1 1 1\n1\n1\n3 1 2 3\n0\n");
  const Run adopts = run({"inspect", space});
  CHECK(has(adopts.out, "polygon 1 (line 7): adopts vertices 4\n"));
}

TEST_CASE("Schonhardt's polyhedron has no triangulation, which is proved") {
  const ScratchFolder folder;
  const std::string domain = folder.write("schonhardt.off", kSchonhardt);
  const Run inspected = run({"inspect", domain, "--domain"});
  CHECK(inspected.exit_code == 0);
  CHECK(has(inspected.out, "constrained Delaunay triangulation: none (proved)\n"));
  CHECK(has(inspected.out, "triangulation without Steiner points: none (proved)\n"));
  const Run unknown = run({"inspect", domain, "--domain", "--search-vertices", "5"});
  CHECK(unknown.exit_code == 0);
  CHECK(has(unknown.out, "constrained Delaunay triangulation: unknown ("));
  for (const char* algorithm : {"gift-wrapping", "polygon-flips", "polygon-cavities"}) {
    const Run built = run(
        {"build", "cdt", domain, "--algorithm", algorithm, "-o", folder.path("schonhardt.1.ele")});
    CHECK(built.exit_code == 1);
    CHECK(begins_with(built.out, "impossible: cdt " + domain + ": none (proved); "));
  }
  const Run limited = run(
      {"build", "cdt", domain, "--search-vertices", "5", "-o", folder.path("schonhardt.1.ele")});
  CHECK(limited.exit_code == 4);
  CHECK(begins_with(limited.out, "undecided: cdt " + domain + ": "));
  CHECK(!std::filesystem::exists(folder.path("schonhardt.1.ele")));
}

TEST_CASE("inspect --refutations and replay: the proofs as files") {
  const ScratchFolder folder;
  const std::string prefix = folder.path("proof");
  const std::string domain =
      std::string(CIRCUMSPECT_CORPUS_DIR) + "/domains/figure-4-12-three-segments.poly";
  CHECK(run({"inspect", domain, "--refutations", prefix}).exit_code == 0);
  for (const std::string what : {"-cdt", "-triangulation"}) {
    const std::string formula = prefix + what + ".cnf";
    const std::string refutation = prefix + what + ".drat";
    const Run replayed = run({"replay", formula, refutation});
    CHECK(replayed.exit_code == 0);
    CHECK(begins_with(replayed.out, "refuted: " + formula));
    // Without its clauses the formula is not refuted; a cut file is the input's fault.
    const std::string weaker = folder.write("weaker.cnf", "p cnf 1000 1\n1 2 0\n");
    CHECK(run({"replay", weaker, refutation}).exit_code == 1);
    const std::string text = contents(formula);
    const std::string cut = folder.write("cut.cnf", text.substr(0, text.size() - 3));
    const Run malformed = run({"replay", cut, refutation});
    CHECK(malformed.exit_code == 3);
    CHECK(begins_with(malformed.err, "circumspect: " + cut + ":"));
    CHECK(has(malformed.err, ": expected a 0 at the end of the clause, found the end of the file"));
  }
  // What circumspect-verified reads (proofs/domains.sh).
  const std::string proof = contents(prefix + "-triangulation.proof");
  CHECK(begins_with(proof, "circumspect-impossibility 2 plc-triangulation 3 enclosed\n"));
  CHECK(has(proof, "\nvertices 14\n"));
  CHECK(has(proof, "\ncandidates 1001\n"));
  const std::string encircled =
      std::string(CIRCUMSPECT_CORPUS_DIR) + "/domains/figure-4-15-encircled-segment.poly";
  CHECK(run({"inspect", encircled, "--refutations", prefix}).exit_code == 0);
  CHECK(
      begins_with(contents(prefix + "-cdt.proof"), "circumspect-impossibility 2 cdt 3 enclosed\n"));
  CHECK(has(contents(prefix + "-cdt.proof"), "\nsees "));
  const Run absent = run({"replay", folder.path("absent.cnf"), folder.path("absent.drat")});
  CHECK(absent.exit_code == 3);
  CHECK(has(absent.err, "absent.cnf: expected a file, found no file of that name\n"));
  CHECK(run({"replay", prefix + "-cdt.cnf", folder.path("")}).exit_code == 3);
  const std::string wrong = folder.write("wrong.drat", "1 0\nx 0\n");
  CHECK(run({"replay", prefix + "-cdt.cnf", wrong}).err ==
        "circumspect: " + wrong +
            ":2: expected literals and a 0, after d for a deletion, found 'x 0'\n");
  CHECK(has(unbroken(run({"replay", "--help"}).out),
            "replay does not check that the formula encodes the domain"));
  CHECK(run({"replay", prefix + "-cdt.cnf"}).exit_code == 2);
}

TEST_CASE("build cdt: every algorithm writes the same files, and they pass") {
  const ScratchFolder folder;
  const std::string domain = folder.write("cube.poly", lifted_cube());
  std::string first;
  for (const std::string algorithm : {"gift-wrapping", "polygon-flips", "polygon-cavities"}) {
    const std::string mesh = folder.path(algorithm + ".ele");
    const Run built = run({"build", "cdt", domain, "--algorithm", algorithm, "-o", mesh});
    CHECK_MESSAGE(built.exit_code == 0, (built.out + built.err));
    CHECK(begins_with(built.out, "built: cdt " + domain + " 8 points "));
    if (first.empty()) first = contents(mesh);
    CHECK(contents(mesh) == first);
    const Run checked = run({"check", mesh, "--domain", domain, "--claim", "cdt"});
    CHECK_MESSAGE(checked.exit_code == 0, checked.out);
  }
  const std::string medit = folder.path("cube.mesh");
  CHECK(run({"build", "cdt", domain, "-o", medit}).exit_code == 0);
  CHECK(run({"check", medit, "--domain", domain, "--claim", "cdt"}).exit_code == 0);
  CHECK(document(run({"build", "cdt", domain, "--format", "json"}))["circumspect"] == 1);
}

TEST_CASE("build planar-cdt and cdt in the plane") {
  const ScratchFolder folder;
  const std::string domain =
      folder.write("a.poly",
                   "6 2\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 1 1\n6 2 1\n5 0\n1 1 2\n2 2 3\n"
                   "3 3 4\n4 4 1\n5 5 6\n0\n");
  const std::string mesh = folder.path("a.1.ele");
  std::string first;
  for (const char* algorithm : {"gift-wrapping", "segment-insertion"}) {
    const Run built = run({"build", "planar-cdt", domain, "--algorithm", algorithm, "-o", mesh});
    CHECK_MESSAGE(built.exit_code == 0, (built.out + built.err));
    if (first.empty()) first = contents(mesh);
    CHECK(contents(mesh) == first);
  }
  CHECK(run({"check", mesh, "--domain", domain}).exit_code == 0);
  CHECK(run({"build", "cdt", domain, "--algorithm", "polygon-flips", "-o", mesh}).exit_code == 2);
}

TEST_CASE("build steiner-cdt and conforming-delaunay of what has no CDT") {
  const ScratchFolder folder;
  const std::string domain = folder.write("schonhardt.off", kSchonhardt);
  for (const std::string what : {"steiner-cdt", "conforming-delaunay"}) {
    const std::string mesh = folder.path(what + ".ele");
    const Run built = run({"build", what, domain, "-o", mesh});
    CHECK_MESSAGE(built.exit_code == 0, (built.out + built.err));
    CHECK(has(built.out, "steiner point 6 on segment "));
    CHECK(has(line_of_verdict(built.out), " steiner-points\n"));
    const Run checked = run({"check", mesh, "--domain", domain, "--claim", what});
    CHECK_MESSAGE(checked.exit_code == 0, checked.out);
  }
  for (const std::string what : {"steiner-cdt", "conforming-delaunay"}) {
    const Run limited =
        run({"build", what, domain, "--steiner-points", "1", "-o", folder.path("limited.ele")});
    CHECK(limited.exit_code == 4);
    CHECK(limited.out == "undecided: " + what + " " + domain +
                             ": 1 Steiner points do not suffice; --steiner-points allows more\n");
    CHECK(!std::filesystem::exists(folder.path("limited.ele")));
  }
}

TEST_CASE("circumspect --help has an example and the exit codes") {
  const Run help = run({"--help"});
  CHECK(help.exit_code == 0);
  CHECK(has(help.out, "Example:\n  circumspect check "));
  CHECK(has(help.out, "Exit codes: 0 it holds, 1 it does not, 2 usage, 3 the input is at fault"));
}

TEST_CASE("build: the points of the input are not replaced") {
  const ScratchFolder folder;
  folder.write("t.node", kFour);
  const std::string domain = folder.write("t.smesh", "0 3\n" + kFourFacets);
  const Run result = run({"build", "cdt", domain, "-o", folder.path("t.ele")});
  CHECK(result.exit_code == 2);
  CHECK(contents(folder.path("t.node")) == kFour);
  CHECK(run({"build", "cdt", domain, "-o", folder.path("t.1.ele")}).exit_code == 0);
  CHECK(run({"build", "cdt", domain, "-o", domain}).exit_code == 2);
  CHECK(contents(domain) == "0 3\n" + kFourFacets);
  CHECK(run({"build", "cdt", domain}).exit_code == 2);
}

}  // namespace circumspect::cli
