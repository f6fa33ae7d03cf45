// circumspect inspect and other long work, as their users see it: one fact after the other, limits,
// interrupts, and what a terminal shows.
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

constexpr const char* kCube =
    "8 3\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n6 1 0 1\n7 1 1 1\n8 0 1 1\n"
    "6 0\n1\n4 1 2 3 4\n1\n4 5 6 7 8\n1\n4 1 2 6 5\n1\n4 2 3 7 6\n1\n4 3 4 8 7\n1\n4 4 1 5 8\n0\n";

// Schönhardt's polyhedron, which has no triangulation, and so many more vertices outside.
std::string schonhardt_and(int more) {
  std::string text = fmt::format(
      "{} 3\n1 10 0 0\n2 -5 8 0\n3 -5 -8 0\n4 8 6 10\n5 -9 4 10\n6 1 -10 10\n", 6 + more);
  for (int i = 0; i < more; ++i) {
    text += fmt::format("{} {} {} {}\n", 7 + i, 100 + i, i * i % 97, i * i * i % 89);
  }
  return text +
         "8 0\n1\n3 1 2 3\n1\n3 4 5 6\n1\n3 1 2 5\n1\n3 1 5 4\n1\n3 2 3 6\n1\n3 2 6 5\n1\n3 3 1 "
         "4\n1\n"
         "3 3 4 6\n0\n";
}

// Points whose Delaunay triangulations have very many simplices.
std::string points_in_dimension(int dimension, int points) {
  std::string text = fmt::format("{} {} 0 0\n", points, dimension);
  unsigned state = 1;
  for (int i = 1; i <= points; ++i) {
    text += std::to_string(i);
    for (int j = 0; j < dimension; ++j) {
      state = state * 1103515245u + 12345u;
      text += fmt::format(" {}", state >> 12);
    }
    text += "\n";
  }
  return text;
}

TEST_CASE("inspect: one line for each fact, and --only some of them") {
  const ScratchFolder folder;
  const std::string cube = folder.write("cube.poly", kCube);
  const std::string valid = fmt::format("valid: {} 8 vertices 12 segments 6 polygons\n", cube);
  const std::string inspected =
      fmt::format("inspected: {} 8 vertices 12 segments 6 polygons", cube);
  CHECK(run({"inspect", cube}).out ==
        valid + "enclosed: 1 polyhedron\nsegments: edge-protected\n" +
            "constrained Delaunay triangulation: canonical (proved)\n" + inspected +
            " 1 polyhedron enclosed edge-protected cdt canonical\n");
  CHECK(run({"inspect", cube, "--only", "validity"}).out == valid + inspected + "\n");
  CHECK(run({"inspect", cube, "--only", "cdt,regions"}).out ==
        valid + "enclosed: 1 polyhedron\nconstrained Delaunay triangulation: canonical (proved)\n" +
            inspected + " 1 polyhedron enclosed cdt canonical\n");
  const auto json = document(run({"inspect", cube, "--only", "validity", "--format", "json"}));
  CHECK(json["results"][0]["valid"] == true);
  CHECK(!json["results"][0].contains("cdt"));

  const std::string square = folder.write("s.node", "4 2\n1 0 0\n2 1 0\n3 0 1\n4 1 1\n");
  CHECK(run({"inspect", square, "--only", "dimension"}).out ==
        "points: 4 points 0 duplicates dimension 2 of 2\ninspected: " + square +
            " 4 points 0 duplicates dimension 2 of 2\n");
  const Run wrong = run({"inspect", square, "--only", "validity"});
  CHECK(wrong.exit_code == 2);
  CHECK(
      has(wrong.err, "expected --only dimension|genericity|simplices for points, found validity"));
  CHECK(run({"inspect", cube, "--only", "cdts"}).exit_code == 2);
}

TEST_CASE("inspect: a page has a card for each breach of a domain, with a picture") {
  const ScratchFolder folder;
  const std::string page = folder.path("page.html");
  const std::string name = folder.path("<script>alert(1)<!--.poly");
  // A corner that is off the plane of its polygon.
  folder.write("<script>alert(1)<!--.poly",
               "4 3\n9 9 0 0\n10 10 0 0\n11 10 1 0\n12 9 1 1/3\n1 0\n1\n4 9 10 11 12\n0\n");
  const Run plain = run({"inspect", name});
  const Run drawn = run({"inspect", name, "--html", page});
  CHECK(drawn.exit_code == 3);
  CHECK(drawn.out == plain.out);
  CHECK(!has(contents(page), "<script>alert"));
  const auto result = shown(page);
  CHECK(has(plain.out, result["line"].get<std::string>()));
  CHECK(result["verdict"] == "fails");
  REQUIRE(result["cards"].size() == 1);
  const auto& off = result["cards"][0];
  CHECK(off["rule"] == "plc.polygon-not-planar");
  CHECK(off["groups"][0] ==
        nlohmann::json(
            {{"role", "first"}, {"words", "polygon 1 (line 7)"}, {"count", 4}, {"closed", true}}));
  CHECK(off["vertices"] == nlohmann::json({9, 10, 11, 12}));
  CHECK(off["values"]["squared distance"]["exact"] == "1/152");
  CHECK(off["coordinates"]["12"] == nlohmann::json({"9", "1", "1/3"}));
  // Two squares that cross.
  const std::string two =
      folder.write("two.poly",
                   "8 3\n1 0 0 0\n2 4 0 0\n3 4 4 0\n4 0 4 0\n5 2 1 -1\n6 2 3 -1\n7 2 3 1\n8 2 1 1\n"
                   "2 0\n1\n4 1 2 3 4\n1\n4 5 6 7 8\n0\n");
  CHECK(run({"inspect", two, "--max-errors", "1", "--html", page}).exit_code == 3);
  REQUIRE(shown(page)["cards"].size() == 1);
  const auto cross = shown(page)["cards"][0];
  CHECK(cross["simplices"].size() >= 5);
  CHECK(has(cross["caption"].get<std::string>(), "olygon 1 (line 1"));
  const auto picture = shown(page)["pictures"][0];
  CHECK(picture["dimension"] == 3);
  CHECK(picture["simplices"].size() == cross["simplices"].size());
  CHECK(picture.contains("point"));
}

TEST_CASE("inspect: a page of what is in order has the facts, and the points of one sphere") {
  const ScratchFolder folder;
  const std::string page = folder.path("page.html");
  const std::string cube = folder.write("cube.poly", kCube);
  const std::string square = folder.write("s.node", "5 2\n1 0 0\n2 1 0\n3 0 1\n4 1 1\n5 3 3\n");
  CHECK(run({"inspect", cube, square, "--html", page}).exit_code == 0);
  const auto results = data_of_page(page)["results"];
  REQUIRE(results.size() == 2);
  CHECK(results[0]["verdict"] == "holds");
  CHECK(results[0]["cards"][0]["meaning"] == "the domain as it was read");
  CHECK(results[0]["cards"][0]["simplices"].size() == 24);
  CHECK(results[0]["pictures"][0]["core"] == 8);
  CHECK(has(results[0]["facts"].get<std::string>(), "segments: edge-protected\n"));
  CHECK(results[1]["cards"][0]["vertices"] == nlohmann::json({1, 2, 3, 4}));
  CHECK(results[1]["cards"][0]["ball"]["centre"] == nlohmann::json({"1/2", "1/2"}));
  CHECK(results[1]["pictures"][0]["near"].size() == 4);
  // Of four coordinates there are words.
  const std::string four = folder.write("four.node",
                                        "6 4\n1 1 0 0 0\n2 -1 0 0 0\n3 0 1 0 0\n4 0 0 1 0\n"
                                        "5 0 0 0 1\n6 0 0 0 -1\n");
  CHECK(run({"inspect", four, "--html", page}).exit_code == 0);
  CHECK(has(contents(page), "The points have 4 coordinates, and a picture shows three."));
  const std::string none = folder.write("none.node", "0 3 0 0\n");
  CHECK(run({"inspect", none, "--html", page}).exit_code == 0);
  CHECK(shown(page)["cards"].empty());
}

TEST_CASE("inspect: a page has the first hundred of many breaches, and says so") {
  const ScratchFolder folder;
  const std::string page = folder.path("page.html");
  std::string points;
  std::string segments;
  for (int i = 0; i < 105; ++i) {
    const auto at = [&](int corner) { return std::to_string(4 * i + corner + 1); };
    const std::string x = std::to_string(10 * i);
    const std::string right = std::to_string(10 * i + 2);
    points += at(0) + " " + x + " 0\n" + at(1) + " " + right + " 2\n" + at(2) + " " + x + " 2\n" +
              at(3) + " " + right + " 0\n";
    segments += std::to_string(2 * i + 1) + " " + at(0) + " " + at(1) + "\n" +
                std::to_string(2 * i + 2) + " " + at(2) + " " + at(3) + "\n";
  }
  const std::string crossed =
      folder.write("x.poly", "420 2\n" + points + "210 0\n" + segments + "0\n");
  CHECK(run({"inspect", crossed, "--max-errors", "0", "--html", page}).exit_code == 3);
  CHECK(shown(page)["cards"].size() == 100);
  CHECK(shown(page)["cards_note"] == "100 of 105 have a card here; a page has at most 100.");
}

TEST_CASE("inspect: a page never replaces what is read, and there is none of what is not") {
  const ScratchFolder folder;
  const std::string cube = folder.write("cube.poly", kCube);
  const Run over = run({"inspect", cube, "--html", cube});
  CHECK(over.exit_code == 2);
  CHECK(has(over.err, "expected another name for the page"));
  CHECK(contents(cube) == kCube);
  CHECK(has(run({"inspect", cube, "--html", "-"}).err, "expected a file for --html, found -"));
  const std::string page = folder.path("page.html");
  CHECK(run({"inspect", folder.write("broken.poly", "3 x\n"), "--html", page}).exit_code == 3);
  CHECK(!std::filesystem::exists(page));
}

TEST_CASE("inspect: whether there is a CDT may stay open, unless --decide asks") {
  const ScratchFolder folder;
  const std::string domain = folder.write("s.poly", schonhardt_and(200));
  const Run open = run({"inspect", domain});
  CHECK(open.exit_code == 0);
  CHECK(has(open.out, "constrained Delaunay triangulation: unknown (more than 200 vertices; "));
  CHECK(has(open.out, " cdt unknown\n"));
  const Run asked = run({"inspect", domain, "--decide", "--only", "cdt"});
  CHECK(asked.exit_code == 4);
  CHECK(has(asked.out, " cdt unknown\n"));
  const std::string small = folder.write("small.poly", schonhardt_and(0));
  const Run decided = run({"inspect", small, "--decide"});
  CHECK(decided.exit_code == 0);
  CHECK(has(decided.out, " cdt none\n"));
  CHECK(has(decided.out, "triangulation without Steiner points: none (proved)\n"));
}

TEST_CASE("inspect: a set is decided to be generic if at most so many subsets are to be tested") {
  const ScratchFolder folder;
  const std::string five = folder.write("p.node", "5 2\n1 0 0\n2 9 1\n3 4 7\n4 -3 5\n5 2 -8\n");
  const auto with = [&](const std::string& subsets) {
    return run({"inspect", five, "--only", "genericity", "--subsets", subsets}).out;
  };
  for (const char* const enough : {"0", "5", "6"}) CHECK(has(with(enough), " generic unique\n"));
  CHECK(has(with("4"), " generic-undecided unique\n"));
}

TEST_CASE("inspect --max-errors 0: what crosses is printed, and JSON has all up to its limit") {
  const ScratchFolder folder;
  std::string text = "60 2 0 0\n";
  for (int i = 0; i < 30; ++i) {
    text += fmt::format("{} {} 0\n{} {}.25 30\n", 2 * i + 1, i, 2 * i + 2, 29 - i);
  }
  text += "30 0\n";
  for (int i = 0; i < 30; ++i) text += fmt::format("{} {} {}\n", i + 1, 2 * i + 1, 2 * i + 2);
  const std::string domain = folder.write("x.poly", text + "0\n");
  const Run all = run({"inspect", domain, "--max-errors", "0"});
  CHECK(all.exit_code == 3);
  CHECK(std::count(all.out.begin(), all.out.end(), '\n') == 30 * 29 / 2 + 1);
  CHECK(has(all.out, "not a piecewise linear complex, 435 breaches, first "));
  const auto json =
      document(run({"inspect", domain, "--max-errors", "0", "--format", "json"}))["results"][0];
  CHECK(json["breaches"].size() == 435);
  CHECK(json["truncated"] == false);
  const Run some = run({"inspect", domain});
  CHECK(std::count(some.out.begin(), some.out.end(), '\n') == 22);
  CHECK(has(some.out, "not a piecewise linear complex, more than 20 breaches, "));
}

TEST_CASE("--limit ends long work with what is known") {
  const ScratchFolder folder;
  const std::string points = folder.write("p.node", points_in_dimension(12, 60));
  const auto start = std::chrono::steady_clock::now();
  const Run ended = run({"inspect", points, "--limit", "500ms"});
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(10));
  CHECK(ended.exit_code == 4);
  CHECK(has(ended.out,
            "points: 60 points 0 duplicates dimension 12 of 12\nundecided: inspect "
            "stopped by --limit after 0."));
  CHECK(has(ended.out, " s, while triangulating " + points + ", points inserted: "));
  CHECK(has(ended.err, "circumspect: triangulating " + points + " may take about "));
  CHECK(has(ended.err, " (--limit TIME ends it)\n"));
  const Run quiet = run({"inspect", points, "--limit", "500ms", "--quiet"});
  CHECK((quiet.exit_code == 4 && quiet.out.empty() && quiet.err.empty()));
  const auto json =
      document(run({"inspect", points, "--limit", "500ms", "--format", "json"}))["results"][0];
  CHECK(json["dimension"] == 12);
  CHECK(begins_with(json["undecided"], "inspect stopped by --limit after 0."));
  CHECK(run({"inspect", points, "--limit", "0"}).exit_code == 2);
}

// The command with a terminal for its standard error, interrupted once the terminal shows
// `awaited`.
struct Session {
  int exit_code = -1;
  std::string out;
  std::string terminal;
  double seconds_to_end = 0;  // after the interrupt
};

Session interrupted(const std::vector<std::string>& arguments, const std::string& awaited) {
  const ScratchFolder folder;
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  REQUIRE(terminal >= 0);
  REQUIRE(grantpt(terminal) == 0);
  REQUIRE(unlockpt(terminal) == 0);
  const int end = open(ptsname(terminal), O_RDWR | O_NOCTTY);
  Streams streams;
  streams.write(1, folder.path("out"));
  streams.copy(2, end);
  const pid_t process = start(arguments, streams);
  close(end);
  Session session;
  std::chrono::steady_clock::time_point sent;
  bool is_sent = false;
  for (char bytes[4096];;) {
    pollfd ready = {terminal, POLLIN, 0};
    poll(&ready, 1, 20'000);
    const ssize_t count = read(terminal, bytes, sizeof bytes);
    if (count <= 0) break;  // the command has ended
    session.terminal.append(bytes, static_cast<std::size_t>(count));
    if (is_sent || !has(session.terminal, awaited)) continue;
    is_sent = true;
    sent = std::chrono::steady_clock::now();
    kill(process, SIGINT);
  }
  session.exit_code = exit_code_of(process);
  close(terminal);
  REQUIRE(is_sent);
  session.seconds_to_end =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - sent).count();
  session.out = contents(folder.path("out"));
  return session;
}

TEST_CASE("a terminal shows how far long work is, and an interrupt ends it with what is known") {
  const ScratchFolder folder;
  const std::string points = folder.write("p.node", points_in_dimension(12, 60));
  const Session session = interrupted({"inspect", points}, "points inserted: ");
  CHECK(session.exit_code == 4);
  CHECK(session.seconds_to_end < 5);  // a second, where nothing else runs
  CHECK(has(session.terminal, "\r\x1b[Kinspect: tri"));
  CHECK(has(session.terminal, " of about "));
  CHECK(begins_with(session.out, "points: 60 points 0 duplicates dimension 12 of 12\n"));
  CHECK(has(session.out, "undecided: inspect interrupted after "));
}

}  // namespace
}  // namespace circumspect::cli
