// No command writes over what it reads, however that is spelt.
#include <doctest/doctest.h>

#include "command/run_command.hpp"

namespace circumspect::cli {
namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

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

  // A command that writes to `target` ends with exit code 2 and a line that names what it reads, and leaves
  // what is there as it is.
  void are_kept(const Arguments& arguments, const std::string& target) const {
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
  for (const char* const name :
       {"p-cdt.cnf", "p-cdt.drat", "p-triangulation.cnf", "p-triangulation.drat"}) {
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
    return Arguments{
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
    return Arguments{"campaign",
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

}  // namespace
}  // namespace circumspect::cli
