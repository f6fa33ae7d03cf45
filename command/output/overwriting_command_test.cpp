// Outputs never replace inputs; pages and pictures.
#include <cmath>
#include <filesystem>
#include <set>

#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {

// No command writes over what it reads, however that is spelt.

namespace {

namespace fs = std::filesystem;
using CommandWords = std::vector<std::string>;

constexpr const char* kQuadPoints = "4 2\n0 0 0\n1 1 0\n2 0 1\n3 2 2\n";
constexpr const char* kQuadTriangles = "2 3\n0 0 1 2\n1 1 3 2\n";
constexpr const char* kSquareDomain =
    "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n";
// Schonhardt's polyhedron, which has no triangulation, so that there are refutations to be written.
const std::string kNoTriangulation = CIRCUMSPECT_CORPUS_DIR "/domains/figure-4-10-schonhardt.poly";

struct Files {
  ScratchFolder folder;
  std::string mesh = folder.write("z.ele", kQuadTriangles);
  std::string points = folder.write("z.node", kQuadPoints);

  // A command that writes to `target` ends with exit code 2 and a line that names what it reads,
  // and leaves what is there as it is.
  void are_kept(const CommandWords& arguments, const std::string& target) const {
    const std::string before = contents(target);
    const Run refused = run(arguments);
    CAPTURE(arguments.front());
    CAPTURE(target);
    CHECK(refused.exit_code == 2);
    CHECK(refused.out.empty());
    CHECK(is_error_line(refused.err));
    CHECK(has(refused.err, "expected another name for "));
    CHECK(contents(target) == before);
  }
};

TEST_CASE(
    "check and certify: a certificate never replaces the mesh, its points or what stands beside") {
  const Files files;
  for (const char* const beside : {"z.neigh", "z.face", "z.edge", "z.poly", "z.smesh"}) {
    files.folder.write(beside, "a file of the user's\n");
  }
  for (const char* const name :
       {"z.ele", "z.node", "z.neigh", "z.face", "z.edge", "z.poly", "z.smesh"}) {
    const std::string target = files.folder.path(name);
    files.are_kept({"check", files.mesh, "--certificate", target}, target);
    files.are_kept({"certify", files.mesh, "-o", target}, target);
    files.are_kept({"certify", files.points, "-o", target}, target);
  }
  CHECK(run({"certify", files.mesh, "-o", files.folder.path("z.cert"), "--quiet"}).exit_code == 0);
  CHECK(run({"certify", files.mesh, "-o", files.folder.path("z.cert"), "--quiet"}).exit_code == 0);
}

TEST_CASE("certify: nor does it under another spelling, or through links") {
  const Files files;
  fs::create_directory(files.folder.path("sub"));
  fs::create_symlink(files.points, files.folder.path("soft"));
  fs::create_symlink("soft", files.folder.path("softer"));
  fs::create_hard_link(files.points, files.folder.path("hard"));
  fs::create_directory_symlink(files.folder.path("."), files.folder.path("here"));
  for (const char* const name :
       {"./z.node", "sub/../z.node", ".//z.node", "soft", "softer", "hard", "here/z.node"}) {
    files.are_kept({"certify", files.mesh, "-o", files.folder.path(name)}, files.points);
    CHECK(fs::is_symlink(files.folder.path("soft")));
    CHECK(fs::hard_link_count(files.points) == 2);
  }
  const std::string elsewhere = files.folder.write("elsewhere.txt", kQuadPoints);
  files.are_kept({"certify", files.mesh, "--points", elsewhere, "-o", elsewhere}, elsewhere);
  const std::string listed = files.folder.write(
      "in.json",
      R"({"circumspect":1,"dimension":2,"points":[[0,0],[1,0],[0,1]],"simplices":[[0,1,2]]})");
  files.are_kept({"certify", listed, "-o", files.folder.path("./in.json")}, listed);
}

TEST_CASE("build: neither the mesh nor its neighbours replace the input, nor each other") {
  const Files files;
  const std::string linked = files.folder.path("linked.ele");
  fs::create_symlink(files.points, linked);
  files.are_kept({"build", "delaunay", files.points, "-o", linked}, files.points);
  files.are_kept({"build", "delaunay", files.points, "-o", files.folder.path("o.ele"),
                  "--neighbors", files.folder.path("./z.node")},
                 files.points);
  const std::string same = files.folder.path("same.ele");
  files.are_kept({"build", "delaunay", files.points, "-o", same, "--neighbors",
                  files.folder.path("./same.ele")},
                 same);
  CHECK(!fs::exists(same));
  // What build wrote before, it may write again.
  for (int i = 0; i < 2; ++i) {
    CHECK(run({"build", "delaunay", files.points, "-o", files.folder.path("z.ele"), "--neighbors",
               files.folder.path("z.neigh"), "--quiet"})
              .exit_code == 0);
  }
}

TEST_CASE("build of a domain: no file of the mesh replaces the domain or its points") {
  const ScratchFolder folder;
  const std::string domain = folder.write("plan.poly", kSquareDomain);
  const auto build = [&](const std::string& out) {
    return run({"build", "cdt", domain, "-o", folder.path(out)});
  };
  for (const char* const beside : {"out.node", "out.edge", "out.ele", "out.mesh", "out.json"}) {
    CAPTURE(beside);
    fs::create_hard_link(domain, folder.path(beside));
    const std::string end = fs::path(beside).extension();
    const Run refused = build(end == ".mesh" || end == ".json" ? beside : "out.ele");
    CHECK(refused.exit_code == 2);
    CHECK(has(refused.err, "expected another name for "));
    CHECK(contents(domain) == kSquareDomain);
    CHECK(contents(folder.path(beside)) == kSquareDomain);
    fs::remove(folder.path(beside));
  }
  for (int i = 0; i < 2; ++i) CHECK(build("plan.ele").exit_code == 0);
  CHECK(contents(domain) == kSquareDomain);
}

TEST_CASE("inspect --refutations: a proof does not replace the domain") {
  const ScratchFolder folder;
  const std::string text = contents(kNoTriangulation);
  const std::string domain = folder.write("a.poly", text);
  for (const char* const name : {"p-cdt.cnf", "p-cdt.drat", "p-triangulation.cnf",
                                 "p-triangulation.drat", "p-triangulation.proof", "p-cdt.proof"}) {
    fs::create_hard_link(domain, folder.path(name));
    const Run refused = run({"inspect", domain, "--refutations", folder.path("p")});
    CAPTURE(name);
    CHECK(refused.exit_code == 2);
    CHECK(has(refused.err, "expected another name for "));
    CHECK(contents(folder.path(name)) == text);
    fs::remove(folder.path(name));
  }
  CHECK(run({"inspect", domain, "--refutations", folder.path("p"), "--quiet"}).exit_code == 0);
}

TEST_CASE("minimize: the small input replaces neither the large one nor the program") {
  const Files files;
  const std::string program = files.folder.write("program", "#!/bin/sh\nexit 3\n");
  const std::string script = files.folder.write("script.node", "#!/bin/sh\nexit 3\n");
  fs::permissions(program, fs::perms::owner_all);
  fs::create_hard_link(program, files.folder.path("hard.node"));
  const auto minimize = [&](const std::string& out) {
    return CommandWords{
        "minimize", files.points, "--dimension", "2",        "-o",    files.folder.path(out),
        "--",       program,      script,        "{points}", "{mesh}"};
  };
  files.are_kept(minimize("./z.node"), files.points);
  files.are_kept(minimize("hard.node"), program);
  files.are_kept(minimize("script.node"), script);
}

TEST_CASE("campaign: the report replaces neither the program, nor its corpus, nor its journal") {
  const Files files;
  const std::string program = files.folder.write(
      "program", "#!/bin/sh\nexec " CIRCUMSPECT_COMMAND
                 " build delaunay --quiet --duplicates merge \"$1\" -o \"$2\"\n");
  fs::permissions(program, fs::perms::owner_all);
  const std::string corpus = files.folder.path("corpus");
  fs::create_directory(corpus);
  std::ofstream(corpus + "/a.node") << kQuadPoints;
  const auto campaign = [&](const std::string& report, const std::string& out = "out") {
    return CommandWords{"campaign",
                        "--dimension",
                        "2",
                        "--cases",
                        "1",
                        "--families",
                        "integers",
                        "--corpus",
                        corpus,
                        "--limit-memory",
                        "0",
                        "--output",
                        files.folder.path(out),
                        "--junit",
                        report,
                        "--",
                        program,
                        "{points}",
                        "{mesh}"};
  };
  CHECK(run(campaign(files.folder.path("report.xml"))).exit_code == 0);
  files.are_kept(campaign(program), program);
  files.are_kept(campaign(corpus + "/../corpus/a.node"), corpus + "/a.node");
  files.are_kept(campaign(files.folder.path("out/journal.tsv")),
                 files.folder.path("out/journal.tsv"));
  // Findings are written over those of the same name.
  fs::create_directories(files.folder.path("own/findings"));
  fs::rename(corpus, files.folder.path("own/findings/crash-SIGSEGV"));
  fs::create_directory_symlink(files.folder.path("own/findings"), corpus);
  files.are_kept(campaign(files.folder.path("r.xml"), "own"),
                 files.folder.path("own/findings/crash-SIGSEGV/a.node"));
}

// --html and --vtu, as their users give them.

struct PicturedFiles {
  ScratchFolder folder;
  std::string page = folder.path("page.html");
  std::string cells = folder.path("cells.vtu");
  std::string bad =
      write("bad", "4 2\n1 -2 0\n2 2 0\n3 0 1\n4 0 -0.25\n", "2 3\n1 1 2 3\n2 4 2 1\n");
  std::string good = write("good", "3 2\n1 0 0\n2 1 0\n3 0 1\n", "1 3\n1 1 2 3\n");

  std::string write(const std::string& name, const std::string& points,
                    const std::string& simplices) {
    folder.write(name + ".node", points);
    return folder.write(name + ".ele", simplices);
  }
};

TEST_CASE("pictures: the page has the verdict of every mesh, and what is printed stays the same") {
  const PicturedFiles files;
  const Run plain = run({"check", files.bad, files.good});
  const Run result = run({"check", files.bad, files.good, "--html", files.page});
  CHECK(result.exit_code == 1);
  CHECK(result.out == plain.out);
  CHECK(result.err.empty());
  const std::string page = contents(files.page);
  CHECK(begins_with(page, "<!DOCTYPE html>"));
  CHECK(
      has(page, "fails: delaunay " + files.bad + " delaunay.facet-not-local 1 face 1 2 vertex 4"));
  CHECK(has(page, "holds: delaunay " + files.good));
  // The page has what the report has.
  const auto document = nlohmann::json::parse(run({"check", files.bad, "--format", "json"}).out);
  const std::size_t data = page.find("id=\"data\">") + 10;
  const auto shown = nlohmann::json::parse(page.substr(data, page.find("</script>", data) - data));
  CHECK(shown["results"][0]["report"]["violations"] == document["results"][0]["violations"]);
}

TEST_CASE("pictures: the words of a name that holds markup are escaped") {
  const PicturedFiles files;
  const std::string name = "<script>alert(1)<!--";  // a slash would be a folder's
  files.folder.write(name + ".node", contents(files.folder.path("bad.node")));
  const std::string mesh =
      files.folder.write(name + ".ele", contents(files.folder.path("bad.ele")));
  CHECK(run({"check", mesh, "--html", files.page}).exit_code == 1);
  const std::string page = contents(files.page);
  CHECK(!has(page, "<script>alert"));
  CHECK(has(page, "&lt;script&gt;alert(1)&lt;!--.ele"));
}

TEST_CASE("pictures: cells by the extension of their file") {
  const PicturedFiles files;
  CHECK(run({"check", files.bad, "--vtu", files.cells, "--html", files.page}).exit_code == 1);
  CHECK(begins_with(contents(files.cells), "<?xml"));
  CHECK(std::filesystem::exists(files.page));
  const std::string gmsh = files.folder.path("cells.msh");
  CHECK(run({"check", files.bad, "--vtu", gmsh}).exit_code == 1);
  CHECK(has(contents(gmsh), "\"delaunay.facet-not-local\""));
}

TEST_CASE("pictures: a mesh that cannot be judged has none") {
  const PicturedFiles files;
  const std::string broken = files.folder.write("broken.ele", "1 3\n");
  CHECK(run({"check", broken, "--html", files.page}).exit_code == 3);
  CHECK(!std::filesystem::exists(files.page));
}

TEST_CASE("pictures: what is wrong with the options is said before anything is read") {
  const PicturedFiles files;
  const auto refused = [](std::vector<std::string> arguments, const std::string& words) {
    arguments.insert(arguments.begin(), "check");
    const Run result = run(arguments);
    CHECK(result.exit_code == 2);
    CHECK(is_error_line(result.err));
    CHECK_MESSAGE(has(result.err, words), result.err);
  };
  refused({files.bad, "--html", "-"}, "expected a file for --html, found -");
  refused({files.bad, "--vtu", files.folder.path("x.vtk")},
          "expected a file .vtu or .msh for --vtu");
  refused({files.bad, files.good, "--vtu", files.cells}, "expected one mesh beside --vtu, found 2");
  refused({files.bad, files.good, "--html", files.good}, "expected another name for the page");
  refused({files.bad, "--html", files.cells, "--vtu", files.cells}, "to which the page is written");
  refused({files.bad, "--html", files.folder.path("nowhere/page.html")},
          "expected a place that can be written to");
}

TEST_CASE("pictures: points of four coordinates have words in a page, and no cells") {
  const PicturedFiles files;
  const std::string mesh =
      files.folder.write("four.json",
                         R"({"circumspect": 1, "dimension": 4, "first_index": 0,
          "points": [["0","0","0","0"], ["1","0","0","0"], ["0","1","0","0"], ["0","0","1","0"],
                     ["0","0","0","1"], ["1","1","1","1"]],
          "simplices": [[0, 1, 2, 3, 4]]})");
  CHECK(run({"check", mesh, "--html", files.page}).exit_code == 1);
  CHECK(has(contents(files.page), "The points have 4 coordinates, and a picture shows three."));
  const Run cells = run({"check", mesh, "--vtu", files.cells});
  CHECK(cells.exit_code == 2);
  CHECK(has(cells.err, "expected points of at most 3 coordinates for --vtu, found 4"));
}

TEST_CASE("pictures: 1e300 beside 1e-300, rational coordinates, and no points at all") {
  PicturedFiles files;
  const std::string wide = files.write(
      "wide", "4 2\n1 -2e300 0\n2 2e300 0\n3 0 1e-300\n4 0 -1e-300\n", "2 3\n1 1 2 3\n2 4 2 1\n");
  CHECK(run({"check", wide, "--html", files.page}).exit_code == 1);
  const auto picture = shown(files.page)["pictures"][0];
  std::set<std::vector<double>> places;
  for (const auto& point : picture["points"]) {
    places.insert(point.get<std::vector<double>>());
    for (const auto& x : point) CHECK(std::abs(x.get<double>()) <= 1);
  }
  CHECK(places.size() == 3);  // no eye tells 3 from 4
  CHECK(shown(files.page)["report"]["violations"][0]["coordinates"]["1"][0]
            .get<std::string>()
            .size() == 302);
  // What stretches the direction in which they differ does, as far as doubles reach.
  const std::string thin = files.write(
      "thin", "4 2\n1 -2e150 0\n2 2e150 0\n3 0 1e-150\n4 0 -1e-150\n", "2 3\n1 1 2 3\n2 4 2 1\n");
  CHECK(run({"check", thin, "--html", files.page}).exit_code == 1);
  const auto heights = shown(files.page)["pictures"][0]["thin"]["heights"];
  CHECK(std::signbit(heights[2].get<double>()) != std::signbit(heights[3].get<double>()));
  CHECK(heights[3] != 0);
  const std::string thirds = files.write("thirds", "4 2\n1 -2/3 0\n2 2/3 0\n3 0 1/3\n4 0 -1/12\n",
                                         "2 3\n1 1 2 3\n2 4 2 1\n");
  CHECK(run({"check", thirds, "--html", files.page}).exit_code == 1);
  CHECK(shown(files.page)["report"]["violations"][0]["coordinates"]["1"] ==
        nlohmann::json({"-2/3", "0"}));
  CHECK(shown(files.page)["pictures"][0]["dimension"] == 2);
  const std::string none = files.write("none", "0 2 0 0\n", "0 3\n");
  CHECK(run({"check", none, "--allow-empty", "--html", files.page}).exit_code == 0);
  CHECK(shown(files.page)["pictures"].empty());
}

TEST_CASE("pictures: twenty thousand violations make no large page") {
  PicturedFiles files;
  std::string points = "20003 2\n1 0 0\n2 1 0\n3 0 1\n";
  for (int i = 4; i <= 20003; ++i) {
    points += std::to_string(i) + " " + std::to_string(i) + " " + std::to_string(i % 7) + "\n";
  }
  const std::string mesh = files.write("many", points, "1 3\n1 1 2 3\n");
  CHECK(run({"check", mesh, "--claim", "triangulation", "--max-errors", "0", "--quiet", "--html",
             files.page})
            .exit_code == 1);
  CHECK(shown(files.page)["cards_note"] ==
        "100 of 20000 violations have a card here; a page has at most 100, and --format json "
        "gives the others.");
  CHECK(contents(files.page).size() < 3'000'000);
}

}  // namespace

}  // namespace circumspect::cli
