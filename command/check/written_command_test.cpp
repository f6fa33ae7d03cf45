// The surfaces of corpus/domains/written, as programs write them, with the options that say what is
// meant.
#include <set>

#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

const std::string kWritten = CIRCUMSPECT_CORPUS_DIR "/domains/";

struct WrittenRow {
  std::vector<std::string> arguments;
  std::string verdict;
};

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::vector<WrittenRow> written_rows() {
  std::istringstream table(contents(kWritten + "written/written.tsv"));
  std::vector<WrittenRow> rows;
  for (std::string line; std::getline(table, line);) {
    if (line.starts_with("#")) continue;
    const std::size_t first = line.find('\t');
    WrittenRow row{{"check"}, line.substr(first + 1, line.find('\t', first + 1) - first - 1)};
    for (const std::string& word : words_of(line.substr(0, first))) {
      row.arguments.push_back((word.starts_with("written/") ? kWritten : "") + word);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

// The rules on the last line, as "domain.outside,domain.uncovered".
std::string verdict_of(const Run& result) {
  if (result.exit_code == 0) return "holds";
  if (result.exit_code == 3) return "input";
  if (result.exit_code != 1) return "exit code " + std::to_string(result.exit_code);
  std::set<std::string> rules;
  const std::string last = result.out.substr(result.out.rfind("fails: "));
  for (const std::string& word : words_of(last)) {
    for (const char* family : {"domain.", "complex.", "cdt.", "quality."}) {
      if (word.starts_with(family)) rules.insert(word);
    }
  }
  std::string text;
  for (const std::string& rule : rules) text += (text.empty() ? "" : ",") + rule;
  return text;
}

// The arguments of a row up to its options, and these.
Run check_written(const std::string& mesh, const std::string& domain,
                  const std::vector<std::string>& more) {
  std::vector<std::string> words = {"check", kWritten + "written/" + mesh, "--domain",
                                    kWritten + "written/" + domain};
  words.insert(words.end(), more.begin(), more.end());
  return run(words);
}

}  // namespace

TEST_CASE("surfaces as programs write them have the verdicts of their table") {
  const std::vector<WrittenRow> rows = written_rows();
  CHECK(rows.size() >= 80);
  for (const WrittenRow& row : rows) {
    std::string text;
    for (const std::string& word : row.arguments) text += word + " ";
    INFO(text);
    CHECK(verdict_of(run(row.arguments)) == row.verdict);
  }
}

TEST_CASE("where edges between coplanar polygons are all that is missing, a note says so") {
  const Run cube = check_written("cube.ele", "cube-in-triangles.off", {});
  CHECK(has(cube.out,
            "note: the program that made the mesh may have joined polygons of one plane "
            "(domain.segment-missing 6): with --merge-coplanar the claim holds\n"));
  const Run within = check_written("cube.ele", "cube-in-triangles.off", {"--within", "1e-12x"});
  CHECK(within.exit_code == 1);
  CHECK(has(within.out, "with --merge-coplanar the claim holds\n"));
  const Run slanted =
      check_written("slanted-cube.ele", "slanted-cube.off", {"--claim", "steiner-triangulation"});
  CHECK(has(slanted.out, "with --merge-coplanar 0.1deg --within "));
  // What is joined is asked for already, or is not all.
  CHECK(!has(check_written("cube.ele", "cube-with-seam.poly", {"--merge-coplanar"}).out,
             "the claim holds"));
  CHECK(!has(check_written("cube.ele", "cube-with-seam.poly", {}).out, "the claim holds"));
}

TEST_CASE("a mesh whose only fault is that it is not Delaunay is said to be a triangulation") {
  const std::string note =
      "note: the mesh is a triangulation of the domain, but not a constrained Delaunay one. If the "
      "program does not promise one, add --claim plc-triangulation, which holds\n";
  CHECK(has(check_written("bipyramid.ele", "bipyramid.off", {}).out, note));
  CHECK(!has(check_written("bipyramid.ele", "bipyramid.off", {"--claim", "cdt"}).out, note));
  CHECK(!has(check_written("cube.ele", "cube-in-triangles.off", {}).out, note));
}

TEST_CASE("where other cells are near what is not flat, the verdict says how far it has looked") {
  const auto checked = [](const std::string& mesh) {
    return check_written(
        mesh, "lid-with-bulb.poly",
        {"--claim", "steiner-triangulation", "--merge-coplanar", "0.1deg", "--within", "1e-3x"});
  };
  CHECK(checked("lid-with-bulb.ele").exit_code == 0);
  const Run bare = checked("lid.ele");
  CHECK(bare.exit_code == 1);
  CHECK(has(bare.out, "beyond ~ "));
  CHECK(!has(bare.out, "beyond ~ 6.0e-03"));
}

TEST_CASE("a polygon that bounds nothing is named with its line, and so is a failure by it") {
  const Run fin = check_written("cube.ele", "cube-with-fin.poly", {});
  CHECK(has(fin.out,
            "bounds nothing: edge 2 9, from (9, 0, 0) to (12, 0, 0), belongs to one polygon "
            "alone, polygon 7 (line 25)"));
  CHECK(has(fin.out, "note: polygon 7 (line 25) bounds nothing that is filled: "));
  ScratchFolder folder;
  const std::string here = kWritten + "written/cube-with-fin";
  const std::string node = folder.write("m.node", contents(here + ".node"));
  const std::string mesh = folder.write("m.ele", contents(here + ".ele"));
  folder.write("m.edge", "4 0\n1 2 9\n2 9 10\n3 10 5\n4 2 5\n");
  const Run bare = run({"check", mesh, "--domain", here + ".poly"});
  CHECK(bare.exit_code == 1);
  CHECK(has(bare.out, "domain.polygon-not-tiled 1"));
  CHECK(has(bare.out, "note: polygon 7 (line 25) bounds nothing that is filled: "));
}

TEST_CASE("options about domains: what they expect") {
  const std::string cube = kWritten + "written/cube-in-triangles.off";
  const std::string mesh = kWritten + "written/cube.ele";
  const std::vector<std::string> check = {"check", mesh, "--domain", cube};
  const auto usage = [&](const std::vector<std::string>& more, const std::string& text) {
    std::vector<std::string> words = check;
    words.insert(words.end(), more.begin(), more.end());
    const Run result = run(words);
    INFO(result.err);
    CHECK(result.exit_code == 2);
    CHECK(has(result.err, text));
  };
  usage({"--merge-coplanar", "0.1deg"}, "expected --within DISTANCE beside --merge-coplanar");
  usage({"--merge-coplanar", "6deg", "--within", "1"}, "at most 5deg");
  usage({"--merge-coplanar=0deg", "--within", "1"}, "more than 0deg");
  usage({"--merge-coplanar=some", "--within", "1"}, "found some");
  // A number without a unit is not a mesh of that name.
  const auto angle = [&](const std::string& text, const std::string& said) {
    usage({"--within", "1e-9", "--merge-coplanar", text}, said);
  };
  angle("0.1", "--merge-coplanar: expected an angle with its unit, such as 0.1deg, found 0.1; ");
  angle("-1/10", "such as 0.1deg, found -1/10; ");
  angle("0.1rad", "found 0.1rad");
  angle("0.1\u00b0", "found 0.1\u00b0");
  const Run no_angle = run({"certify", mesh, "--domain", cube, "--claim", "steiner-cdt", "-o", "x",
                            "--merge-coplanar", "0.1"});
  CHECK(no_angle.exit_code == 2);
  CHECK(has(no_angle.err, "--merge-coplanar: expected no angle, found 0.1: circumspect check"));
  // Behind -- stands another program's command line.
  CHECK(has(run({"campaign", "--", "./none", "--merge-coplanar", "0.1", "{points}", "{mesh}"}).err,
            "none"));
  usage({"--hole", "1,2,x"}, "expected a point, as 1,2.5,1/3");
  usage({"--region", "1"}, "expected a point");
  usage({"--region", "1,1,1", "--fill", "even-odd"}, "expected --region alone");
  usage({"--fill", "odd"}, "expected enclosed|even-odd|hull|winding");
  usage({"--keep-label", "1", "--neighbors"}, "expected no --neighbors beside --keep-label");
  CHECK(run({"check", mesh, "--fill", "hull"}).exit_code == 2);
  const Run of_plane = run({"check", mesh, "--domain", cube, "--hole", "1,2"});
  CHECK(of_plane.exit_code == 3);
  CHECK(has(of_plane.err, "expected --hole with 3 coordinates"));
  CHECK(run({"build", "cdt", cube, "--merge-coplanar=1deg", "--format", "json"}).exit_code == 2);
  // The option takes no file for an angle.
  CHECK(run({"check", "--merge-coplanar", mesh, "--domain", cube}).exit_code == 0);
  CHECK(run({"check", mesh, "--domain", cube, "--within", "1e-9", "--merge-coplanar", "0.1deg"})
            .exit_code == 0);
  const Run turned = run({"inspect", kWritten + "written/cube-in-cube.off", "--domain", "--fill",
                          "winding", "--search-vertices", "1", "--hole", "4,4,4"});
  CHECK(has(turned.out, "1 polyhedron"));
}

TEST_CASE("build and inspect: what is filled, and polygons that are one") {
  ScratchFolder folder;
  const std::string hollow = kWritten + "written/cube-in-cube.off";
  const std::string out = folder.path("built.ele");
  CHECK(run({"build", "cdt", hollow, "-o", out, "--fill", "even-odd"}).exit_code == 0);
  CHECK(run({"check", out, "--domain", hollow}).exit_code == 1);
  CHECK(run({"check", out, "--domain", hollow, "--fill", "even-odd"}).exit_code == 0);
  const std::string cube = kWritten + "written/cube-in-triangles.off";
  CHECK(has(run({"inspect", cube, "--domain", "--merge-coplanar"}).out,
            " 12 segments 6 polygons 1 polyhedron"));
  CHECK(has(run({"inspect", cube, "--domain"}).out, " 18 segments 12 polygons 1 polyhedron"));
  CHECK(run({"build", "cdt", cube, "-o", out, "--merge-coplanar"}).exit_code == 0);
  CHECK(run({"check", out, "--domain", cube, "--merge-coplanar"}).exit_code == 0);
}

TEST_CASE("build and compare write surfaces for viewers") {
  ScratchFolder folder;
  const std::string fin = kWritten + "written/cube-with-fin.poly";
  for (const std::string end : {".obj", ".ply"}) {
    const std::string out = folder.path("built" + end);
    CHECK(run({"build", "steiner-cdt", fin, "-o", out}).exit_code == 0);
    // The boundary, and what dangles, is a mesh of the same surface.
    const Run inspected = run({"inspect", out, "--domain"});
    CHECK(has(inspected.out, "10 vertices"));
    CHECK(has(inspected.out, "14 polygons 1 polyhedron"));
    const Run turned = run({"inspect", out, "--domain", "--fill", "winding"});
    CHECK(has(turned.out, "1 polyhedron"));
  }
  const std::string cube = kWritten + "written/cube.ele";
  const std::string other = folder.path("other.ele");
  CHECK(run({"build", "cdt", kWritten + "written/cube-in-triangles.off", "-o", other}).exit_code ==
        0);
  for (const std::string end : {".vtu", ".msh", ".obj", ".ply"}) {
    const std::string out = folder.path("differ" + end);
    const Run compared = run({"compare", cube, other, "-o", out});
    CHECK(compared.exit_code == 1);
    CHECK(run({"inspect", out, "--domain", "--duplicates", "merge"}).exit_code != 2);
    CHECK(contents(out).size() > 100);
  }
  CHECK(has(contents(folder.path("differ.vtu")), "Name=\"label\""));
  CHECK(run({"check", folder.path("differ.msh"), "--keep-label", "1", "--claim", "triangulation"})
            .exit_code == 0);
  CHECK(run({"compare", cube, other, "-o", folder.path("differ.ele")}).exit_code == 2);
  CHECK(run({"compare", cube, other, "-o", cube}).exit_code == 2);
}

}  // namespace circumspect::cli
