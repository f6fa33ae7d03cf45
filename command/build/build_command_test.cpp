// The command `build`: what it writes, other CDTs, and Steiner points.
#include <algorithm>
#include <map>
#include <set>

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {

// circumspect build and inspect, as their users run them.

namespace {

const std::string kDomains = std::string(CIRCUMSPECT_CORPUS_DIR) + "/domains/";

std::string cube(int first_index) {
  std::string text = "8 3 0 0\n";
  for (int v = 0; v < 8; ++v) {
    text += std::to_string(v + first_index) + ' ' + std::to_string(v / 4) + ' ' +
            std::to_string(v / 2 % 2) + ' ' + std::to_string(v % 2) + '\n';
  }
  return text;
}

TEST_CASE("build: what it writes, check accepts as canonical, counting from 0, 1 or 7") {
  const ScratchFolder folder;
  for (const int first : {0, 1, 7}) {
    const std::string points = folder.write("cube.node", cube(first));
    const std::string mesh = folder.path("cube.ele");
    const Run built =
        run({"build", "delaunay", points, "-o", mesh, "--neighbors", folder.path("cube.neigh")});
    CHECK(built.exit_code == 0);
    CHECK(built.out ==
          "built: delaunay " + points + " 8 points 6 tetrahedra not-unique canonical\n");
    CHECK(begins_with(contents(mesh), "6 4 0\n" + std::to_string(first) + ' '));
    const Run checked = run({"check", "--oriented", "--neighbors", mesh});
    CHECK(checked.exit_code == 0);
    CHECK(checked.out ==
          "holds: delaunay " + mesh + " 8 points 6 tetrahedra not-unique canonical\n");
    const std::string again = folder.path("again.ele");
    CHECK(
        run({"build", "delaunay", "--algorithm", "by-definition", points, "-o", again}).exit_code ==
        0);
    CHECK(contents(again) == contents(mesh));
  }
}

// What the steps of a page lead to: simplices by the places of their points.
std::set<std::set<int>> played(const nlohmann::json& steps) {
  std::set<std::set<int>> alive;
  for (const auto& frame : steps["frames"]) {
    if (frame.contains("all")) break;
    for (const auto& gone : frame.value("deleted", nlohmann::json::array())) {
      CHECK(alive.erase(gone.get<std::set<int>>()) == 1);
    }
    for (const auto& next : frame.value("created", nlohmann::json::array())) {
      CHECK(alive.insert(next.get<std::set<int>>()).second);
    }
  }
  return alive;
}

TEST_CASE("build: a page plays the steps of each algorithm up to the triangulation") {
  const ScratchFolder folder;
  const std::string page = folder.path("page.html");
  const std::string points =
      folder.write("<script>alert(1)<!--.node",
                   "8 2\n3 0 0\n4 1 0\n5 0 1\n6 1 1\n7 1/2 1/4\n8 3 1/3\n9 1 -2\n10 1/2 5/7\n");
  const std::string cubes = folder.write("cube.node", cube(1));
  const std::map<std::string, std::string> names = {
      {"bowyer-watson", "DigCavity"},
      {"gift-wrapping", "Finish"},
      {"flips", "Flip algorithm"},
      {"lifted-hull", "Convex hull of the lifted points"}};
  for (const auto& one : names) {
    const std::string& algorithm = one.first;
    CAPTURE(algorithm);
    CHECK(
        run({"build", "delaunay", points, "--algorithm", algorithm, "--statistics", "--html", page})
            .exit_code == 0);
    CHECK(!has(contents(page), "<script>alert"));
    const auto result = shown(page);
    const auto facts = result["facts"].get<std::string>();
    CHECK(has(facts, algorithm == "bowyer-watson" ? "created: " : "statistics: counted by "));
    CHECK(has(facts, "created: ") == (algorithm == "bowyer-watson"));
    const auto& frames = result["steps"]["frames"];
    CHECK(std::any_of(frames.begin(), frames.end(),
                      [&](const auto& frame) { return frame["step"] == one.second; }));
    const auto all = frames.back()["all"].get<std::set<std::set<int>>>();
    CHECK(all.size() == 9);
    if (algorithm == "lifted-hull") {
      std::set<std::set<int>> lower;
      for (const auto& frame : frames) {
        if (frame.value("lower", false)) lower.insert(frame["outline"].get<std::set<int>>());
      }
      CHECK(lower == all);
      CHECK(result["steps"]["picture"]["dimension"] == 3);
      CHECK(result["steps"]["picture"]["points"].size() == 16);
    } else {
      CHECK(played(result["steps"]) == all);
      CHECK(result["steps"]["picture"]["names"][0] == "3");
      CHECK(run({"build", "delaunay", cubes, "--algorithm", algorithm, "--html", page}).exit_code ==
            0);
      CHECK(played(shown(page)["steps"]).size() == 6);
    }
  }
}

TEST_CASE("build: a page of flips that insert polygons, and pages without steps") {
  const ScratchFolder folder;
  const std::string page = folder.path("page.html");
  const std::string notched = kDomains + "figure-4-13-chazelle-1.poly";
  CHECK(run({"build", "cdt", notched, "--algorithm", "polygon-flips", "--html", page}).exit_code ==
        0);
  const auto frames = shown(page)["steps"]["frames"];
  CHECK(frames.size() == 5);
  CHECK(frames[1]["step"] == "FlipInsertPolygon");
  // What the flips come to has all of the mesh, and what is outside.
  const auto whole = played(shown(page)["steps"]);
  for (const auto& simplex : frames.back()["all"]) {
    CHECK(whole.count(simplex.get<std::set<int>>()) == 1);
  }
  const std::string rooms = kDomains + "two-rooms.poly";
  CHECK(run({"build", "cdt", rooms, "--html", page}).exit_code == 0);
  CHECK(shown(page)["steps"]["frames"].size() == 1);
  std::string many = "201 2\n";
  for (int i = 0; i < 201; ++i) {
    many += std::to_string(i) + " " + std::to_string(i) + " " + std::to_string(i * i % 101) + "\n";
  }
  CHECK(run({"build", "delaunay", folder.write("many.node", many), "--html", page}).exit_code == 0);
  CHECK(!shown(page).contains("steps"));
  CHECK(shown(page)["facts"] == "steps: none are shown of more than 200 points\n");
  const std::string four =
      folder.write("four.node", "5 4\n1 0 0 0 0\n2 1 0 0 0\n3 0 1 0 0\n4 0 0 1 0\n5 0 0 0 1\n");
  CHECK(run({"build", "delaunay", four, "--html", page}).exit_code == 0);
  CHECK(!shown(page).contains("steps"));
  // Only those of the plane are lifted in a picture.
  const std::string line = folder.write("line.node", "3 1\n1 0\n2 5\n3 2\n");
  for (const std::string& points : {line, folder.write("cube.node", cube(1))}) {
    CHECK(run({"build", "delaunay", points, "--algorithm", "lifted-hull", "--html", page})
              .exit_code == 0);
    const auto steps = shown(page)["steps"];
    CHECK(steps["frames"].size() >= 3);
    for (const auto& frame : steps["frames"]) CHECK(!frame.contains("outline"));
  }
  // It never replaces what is read.
  const std::string before = contents(four);
  CHECK(run({"build", "delaunay", four, "--html", four}).exit_code == 2);
  CHECK(contents(four) == before);
  CHECK(run({"build", "cdt", rooms, "--html", "-"}).exit_code == 2);
}

TEST_CASE("build: flat sets and small ones, by .ele and by JSON") {
  const ScratchFolder folder;
  for (const std::string& text :
       {std::string("4 3 0 0\n0 0 0 5\n1 1 0 5\n2 1 1 5\n3 0 1 5\n"),  // a square in space
        std::string("3 2 0 0\n1 0 0\n2 2 2\n3 1 1\n"),                 // a line in the plane
        std::string("1 3 0 0\n1 4 5 6\n"), std::string("2 1 0 0\n0 3\n1 1\n"),
        std::string("0 2 0 0\n")}) {
    CAPTURE(text);
    const std::string points = folder.write("x.node", text);
    const std::string mesh = folder.path("x.ele");
    CHECK(run({"build", "delaunay", points, "-o", mesh}).exit_code == 0);
    CHECK(run({"check", "--allow-empty", mesh}).exit_code == 0);
    const Run json = run({"build", "delaunay", points, "--format", "json"});
    CHECK(json.exit_code == 0);
    CHECK(document(json)["circumspect"] == 1);
    CHECK(run({"check", "--allow-empty", "-"}, json.out).exit_code == 0);
  }
}

TEST_CASE("build: -o - writes the mesh and nothing else") {
  const ScratchFolder folder;
  const std::string points = folder.write("x.node", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n");
  const Run result = run({"build", "delaunay", points, "-o", "-"});
  CHECK(result.exit_code == 0);
  CHECK(result.out == "1 3 0\n1 1 2 3\n");
  CHECK(result.err.empty());
  CHECK(run({"build", "delaunay", "-", "-o", "-"}, contents(points)).out == result.out);
}

TEST_CASE("build: -o x.json writes what --format json prints, but never over the points") {
  const ScratchFolder folder;
  const std::string points = folder.write("x.node", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n");
  const std::string mesh = folder.path("x.json");
  CHECK(run({"build", "delaunay", points, "-o", mesh}).exit_code == 0);
  CHECK(contents(mesh) == run({"build", "delaunay", points, "--format", "json"}).out);
  CHECK(run({"check", mesh}).exit_code == 0);
  const std::string before = contents(mesh);
  const Run over = run({"build", "lexicographic", mesh, "-o", mesh});
  CHECK(over.exit_code == 2);
  CHECK(has(over.err, "expected another name for the mesh, found "));
  CHECK(contents(mesh) == before);
}

TEST_CASE("build --help has examples, which work, and the exit codes") {
  const std::string help = run({"build", "--help"}).out;
  CHECK(has(help, "  circumspect build delaunay points.node -o reference.ele\n"));
  CHECK(has(help, "  circumspect build cdt part.poly -o part.1.ele\n"));
  CHECK(has(help, "Exit codes: 0 built, 1 the domain has no such triangulation"));
  CHECK(has(help, "5 internal error."));
}

TEST_CASE("build: usage errors") {
  const ScratchFolder folder;
  const std::string points = folder.write("x.node", "1 1 0 0\n0 0\n");
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"build"},
           {"build", "castle", points},
           {"build", "delaunay"},
           {"build", "delaunay", points},  // where to?
           {"build", "delaunay", points, "-o", "-", "--format", "json"},
           {"build", "delaunay", points, "-o", "-", "--algorithm", "magic"}}) {
    const Run result = run(arguments);
    CHECK(result.exit_code == 2);
    CHECK(result.out.empty());
    CHECK(!result.err.empty());
  }
}

// What stands in a folder.
std::vector<std::string> listing(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.push_back(entry.path().filename());
  }
  return names;
}

TEST_CASE("build: a place that cannot be written to, and nothing half-written anywhere") {
  const ScratchFolder folder;
  const std::string points = folder.write("x.node", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n");
  std::filesystem::create_directory(folder.path("directory"));
  for (const std::string& place : {folder.path("nowhere/x.ele"), folder.path("directory")}) {
    const Run result = run({"build", "delaunay", points, "-o", place});
    CHECK(result.exit_code == 2);
    CHECK(result.out.empty());
    CHECK(is_error_line(result.err));
    CHECK(has(result.err, place));
  }
  CHECK(listing(folder.path("")).size() == 2);
  CHECK(listing(folder.path("directory")).empty());
  // A mesh that stands there survives an input that cannot be read.
  const std::string mesh = folder.write("x.ele", "precious");
  CHECK(run({"build", "delaunay", folder.path("nowhere.node"), "-o", mesh}).exit_code == 3);
  CHECK(contents(mesh) == "precious");
}

// Renaming a finished file over a device or a pipe would put a file in its place.
TEST_CASE("build: what is not a file, a pipe say, is written to and stays what it is") {
  const ScratchFolder folder;
  const std::string points = folder.write("x.node", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n");
  const std::string pipe = folder.path("pipe");
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  CHECK(run({"build", "delaunay", points, "-o", pipe}).exit_code == 0);
  CHECK(std::filesystem::is_fifo(pipe));
  char buffer[100];
  const auto size = read(reader, buffer, sizeof buffer);
  close(reader);
  REQUIRE(size > 0);
  CHECK(std::string(buffer, static_cast<std::size_t>(size)) == "1 3 0\n1 1 2 3\n");
  CHECK(listing(folder.path("")).size() == 2);
}

TEST_CASE("build: an input at fault is said on stderr, and in JSON as one document") {
  const Run text = run({"build", "delaunay", "nowhere.node", "-o", "-"});
  CHECK(text.exit_code == 3);
  CHECK(text.out.empty());
  CHECK(is_error_line(text.err));
  const Run json = run({"build", "delaunay", "nowhere.node", "--format", "json"});
  CHECK(json.exit_code == 3);
  CHECK(is_error_line(json.err));
  CHECK(has(document(json)["results"][0]["error"], "nowhere.node"));
}

TEST_CASE("build: duplicates are rejected, or merged under the first one's index") {
  const ScratchFolder folder;
  const std::string points = folder.write("d.node", "4 2 0 0\n5 1 1\n6 0 0\n7 1 1\n8 1 0\n");
  CHECK(run({"build", "delaunay", points, "-o", "-"}).exit_code == 3);
  const Run merged = run({"build", "delaunay", "--duplicates", "merge", points, "-o", "-"});
  CHECK(merged.exit_code == 0);
  const std::string mesh = folder.write("d.ele", merged.out);
  CHECK(!has(merged.out, " 7"));
  CHECK(run({"check", "--duplicates", "merge", mesh}).exit_code == 0);
  const Run json = run({"build", "delaunay", "--duplicates", "merge", points, "--format", "json"});
  CHECK(run({"check", "-", "--duplicates", "merge"}, json.out).exit_code == 0);
  for (const char* made : {"delaunay-subdivision", "all-triangulations"}) {
    CAPTURE(made);
    CHECK(has(run({"build", made, "--duplicates", "merge", points}).out,
              "d.node: points 5 and 7 are equal and count as one\n"));
  }
  const Run diagram = run({"build", "voronoi", "--duplicates", "merge", points});
  CHECK(begins_with(diagram.out, "2\n"));
  CHECK(has(diagram.err, "d.node: points 5 and 7 are equal and count as one\n"));
}

TEST_CASE("inspect: dimension, duplicates, genericity with a witness, uniqueness") {
  const ScratchFolder folder;
  const std::string square = folder.write("s.node",
                                          "6 3 0 0\n1 0 0 5\n2 1 0 5\n3 1 1 5\n4 0 1 5\n"
                                          "5 1 0 5\n6 9 7 5\n");
  const Run text = run({"inspect", square});
  CHECK(text.exit_code == 0);
  CHECK(text.out.substr(text.out.rfind('\n', text.out.size() - 2) + 1) ==
        "inspected: " + square + " 6 points 1 duplicate dimension 2 of 3 not-generic not-unique\n");
  CHECK(has(text.out, "duplicate: points 2 and 5 are equal\n"));
  CHECK(has(text.out, "cospherical: points 1 2 3 4 on an empty sphere"));
  const nlohmann::json facts = document(run({"inspect", "--format", "json", square}))["results"][0];
  CHECK(facts["points"] == 6);
  CHECK(facts["duplicates"].dump() == "[[2,5]]");
  CHECK(facts["ambient_dimension"] == 3);
  CHECK(facts["dimension"] == 2);
  CHECK(facts["generic"] == "not-generic");
  CHECK(facts["unique"] == false);
  CHECK(facts["cospherical"]["vertices"].dump() == "[1,2,3,4]");
  CHECK(facts["cospherical"]["ball"]["centre"].dump() == R"(["1/2","1/2","5"])");
  CHECK(facts["cospherical"]["ball"]["squared_radius"]["exact"] == "1/2");
  CHECK(facts["cospherical"]["coordinates"]["3"].dump() == R"(["1","1","5"])");
}

TEST_CASE("inspect: generic, cospherical around a point, undecided, nothing at all") {
  const ScratchFolder folder;
  const std::string generic = folder.write("g.node", "4 2 0 0\n0 0 0\n1 3 0\n2 0 4\n3 9 9\n");
  CHECK(has(run({"inspect", generic}).out,
            " 4 points 0 duplicates dimension 2 of 2 generic unique\n"));
  const std::string centre = folder.write("c.node", "5 2 0 0\n0 0 0\n1 2 0\n2 2 2\n3 0 2\n4 1 1\n");
  CHECK(has(run({"inspect", centre}).out, "cospherical: points 0 1 2 3 on a sphere"));
  CHECK(has(run({"inspect", centre}).out, " not-generic unique\n"));
  CHECK(has(run({"inspect", "--subsets", "4", centre}).out, " generic-undecided unique\n"));
  CHECK(has(run({"inspect", "--subsets", "5", centre}).out, " not-generic unique\n"));
  CHECK(has(run({"inspect", "--subsets", "0", centre}).out, " not-generic unique\n"));
  const std::string none = folder.write("n.node", "0 2 0 0\n");
  CHECK(run({"inspect", none}).exit_code == 0);
  CHECK(has(run({"inspect", none}).out, " 0 points 0 duplicates "));
}

TEST_CASE("inspect: several inputs, the worst exit code, one JSON document") {
  const ScratchFolder folder;
  const std::string points = folder.write("g.node", "2 1 0 0\n0 0\n1 1\n");
  const Run result = run({"inspect", "--format", "json", "nowhere.node", points});
  CHECK(result.exit_code == 3);
  CHECK(is_error_line(result.err));
  CHECK(document(result)["results"].size() == 2);
  CHECK(document(result)["results"][0]["input"] == "nowhere.node");
  CHECK(run({"inspect"}).exit_code == 2);
  CHECK(run({"inspect", "--quiet", points}).out.empty());
}

}  // namespace

// build cdt of domains that have a CDT, but not the canonical one, as its users run it.

TEST_CASE("build cdt: where there is no canonical CDT, another one is built, if there is any") {
  const ScratchFolder folder;
  for (const std::string name : {"cube-with-diagonal", "cube-with-diagonal-and-floor"}) {
    const std::string domain = std::string(CIRCUMSPECT_CORPUS_DIR) + "/domains/" + name + ".poly";
    CHECK(has(run({"inspect", domain}).out, "triangulation: another (proved)\n"));
    const std::string mesh = folder.path(name + ".1.ele");
    const Run built = run({"build", "cdt", domain, "-o", mesh});
    CHECK_MESSAGE(built.exit_code == 0, (built.out + built.err));
    CHECK(has(built.out, "note: there is no canonical CDT, for segment 1 6 is not an edge; "));
    CHECK(has(built.out, "\nbuilt: cdt " + domain + " "));
    CHECK(has(built.out, " not-canonical\n"));
    for (const std::string by : {"lemma", "definition"}) {
      const Run checked = run({"check", mesh, "--domain", domain, "--claim", "cdt", "--by", by});
      CHECK_MESSAGE(checked.exit_code == 0, checked.out);
    }
    // As JSON it is the mesh alone; so the note is on the standard error.
    const Run json = run({"build", "cdt", domain, "--format", "json"});
    CHECK(document(json)["circumspect"] == 1);
    CHECK(has(json.err, "note: there is no canonical CDT, for "));
    // An algorithm makes the canonical one or none, and does not say that there is no other.
    for (const char* algorithm : {"gift-wrapping", "polygon-flips", "polygon-cavities"}) {
      const Run none =
          run({"build", "cdt", domain, "--algorithm", algorithm, "-o", folder.path("none.1.ele")});
      CHECK(none.exit_code == 4);
      CHECK(has(none.out, "undecided: cdt " + domain + ": there is a CDT, but no canonical one"));
    }
    const Run limited =
        run({"build", "cdt", domain, "--search-vertices", "7", "-o", folder.path("none.1.ele")});
    CHECK(limited.exit_code == 4);
    CHECK(has(limited.out, "undecided: cdt " + domain + ": there is no canonical CDT, and "));
    CHECK(has(limited.out, "more than 7 vertices; --search-vertices"));
    CHECK(!std::filesystem::exists(folder.path("none.1.ele")));
  }
}

// build steiner-cdt: which algorithm makes it, and how many Steiner points it takes.

TEST_CASE("build steiner-cdt: all algorithms give the same files") {
  const ScratchFolder folder;
  const std::string domain = kDomains + "figure-4-13-chazelle-2.poly";
  const std::string usual = folder.path("usual.ele");
  CHECK(run({"build", "steiner-cdt", domain, "-o", usual}).exit_code == 0);
  for (const std::string algorithm : {"gift-wrapping", "polygon-flips", "polygon-cavities"}) {
    const std::string mesh = folder.path(algorithm + ".ele");
    CHECK(run({"build", "steiner-cdt", domain, "--algorithm", algorithm, "-o", mesh}).exit_code ==
          0);
    CHECK(contents(mesh) == contents(usual));
  }
}

TEST_CASE("build steiner-cdt: a needle takes few Steiner points, and a limit ends in exit code 4") {
  const ScratchFolder folder;
  const std::string domain = kDomains + "needle.poly";
  const std::string mesh = folder.path("needle.1.ele");
  const std::vector<std::string> build = {"build", "steiner-cdt", domain, "--domain-kind",
                                          "hull",  "-o",          mesh,   "--steiner-points"};
  const auto with_limit = [&](const std::string& limit) {
    std::vector<std::string> arguments = build;
    arguments.push_back(limit);
    return run(arguments);
  };
  const Run limited = with_limit("1");
  CHECK(limited.exit_code == 4);
  CHECK(limited.out == "undecided: steiner-cdt " + domain +
                           ": 1 Steiner points do not suffice; --steiner-points allows more\n");
  CHECK(!std::filesystem::exists(mesh));
  const Run built = with_limit("8");
  CHECK_MESSAGE(built.exit_code == 0, built.out);
  const Run checked =
      run({"check", mesh, "--domain", domain, "--domain-kind", "hull", "--claim", "steiner-cdt"});
  CHECK_MESSAGE(checked.exit_code == 0, checked.out);
}

}  // namespace circumspect::cli
