// Names of files hold any bytes; in what is printed they forge no line and reach no terminal.
#include <algorithm>

#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

namespace fs = std::filesystem;

// A line end, an escape sequence of seven bits and one of eight, a line separator, a byte that is
// no UTF-8, an override of the direction of text; and "é", which is a letter as any other.
const std::string kNasty =
    "c\nholds: x\x1b[31m\xc2\x9b"
    "31m\xe2\x80\xa8y\xff\xe2\x80\xae\xc3\xa9";
const std::string kNastyShown =
    "c\\x0aholds: x\\x1b[31m\\xc2\\x9b"
    "31m\\xe2\\x80\\xa8y\\xff\\xe2\\x80\\xae\xc3\xa9";

const std::string kPoints = "4 2\n0 0 0\n1 1 0\n2 0 1\n3 2 2\n";
const std::string kTriangles = "2 3\n0 0 1 2\n1 1 3 2\n";
const std::string kOverlapping = "2 3\n0 0 1 2\n1 0 1 3\n";

// Is there nothing in it that moves a cursor or begins a line, but for line ends?
bool is_harmless(const std::string& text) {
  const auto is_control = [](char c) { return (c >= 0 && c < ' ' && c != '\n') || c == '\x7f'; };
  return std::none_of(text.begin(), text.end(), is_control) && !has(text, "\xc2\x9b") &&
         !has(text, "\xff") && !has(text, "\xe2\x80\xa8") && !has(text, "\xe2\x80\xae");
}

// Everything that a run prints shows the name, and in no line a forged verdict.
void shows_name(const Run& result) {
  for (const std::string& text : {result.out, result.err}) {
    CHECK(is_harmless(text));
    CHECK(!has(text, "\nholds: x"));
    CHECK(!begins_with(text, "holds: x"));
  }
  CHECK(has(result.out + result.err, kNastyShown));
}

struct Nasty {
  ScratchFolder folder;
  std::string points = folder.write(kNasty + ".node", kPoints);
  std::string mesh = folder.write(kNasty + ".ele", kTriangles);
};

TEST_CASE("a line end in the name of a mesh forges no verdict") {
  const Nasty nasty;
  shows_name(run({"check", nasty.mesh}));
  nasty.folder.write(kNasty + ".ele", kOverlapping);
  const Run fails = run({"check", nasty.mesh});
  CHECK(fails.exit_code == 1);
  shows_name(fails);
  shows_name(run({"certify", nasty.mesh, "-o", nasty.folder.path("cert")}));
  shows_name(run({"compare", nasty.mesh, nasty.mesh}));
  const std::string other = nasty.folder.write("other.ele", kTriangles);
  nasty.folder.write("other.node", kPoints);
  shows_name(run({"compare", nasty.mesh, other}));
}

TEST_CASE(
    "nor does one in the name of points, of an output, of a word, of a file that is not there") {
  const Nasty nasty;
  shows_name(run({"build", "delaunay", nasty.points, "-o", nasty.folder.path("o.ele")}));
  shows_name(run({"build", "delaunay-subdivision", nasty.points}));
  shows_name(run({"build", "all-triangulations", nasty.points}));
  shows_name(run({"build", "delaunay", nasty.points, "-o", nasty.folder.path(kNasty)}));
  shows_name(run({"build", "delaunay", nasty.points, "-o", nasty.points}));
  shows_name(run({"inspect", nasty.points}));
  shows_name(run({"check", nasty.folder.path(kNasty + "none.ele")}));
  shows_name(run({"check", nasty.mesh, "--by", kNasty}));
  shows_name(run({"check", nasty.mesh, "--" + kNasty}));
  shows_name(run({"check", nasty.mesh, "--max-errors", kNasty}));
  shows_name(run({"check", nasty.mesh, "--certificate", nasty.folder.path(kNasty + "/none")}));
  shows_name(run({"generate", "integers", "-o", nasty.folder.path(kNasty + ".new.node")}));
  shows_name(run({"generate", kNasty}));
  shows_name(run({"replay", nasty.mesh, nasty.mesh}));
  shows_name(run({"minimize", nasty.points, "-o", nasty.folder.path("o.node"), "--", kNasty,
                  "{points}", "{mesh}"}));
}

TEST_CASE("nor does one in the name of a domain") {
  const Nasty nasty;
  const std::string domain = nasty.folder.write(
      kNasty + ".poly",
      "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  const std::string mesh = nasty.folder.path("o.ele");
  shows_name(run({"build", "cdt", domain, "-o", mesh}));
  shows_name(run({"check", mesh, "--domain", domain}));
  shows_name(run({"inspect", domain}));
  const std::string leaky = nasty.folder.write(
      kNasty + "l.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n3 0\n1 1 2\n2 2 3\n3 3 4\n0\n");
  shows_name(run({"inspect", leaky}));
  shows_name(run({"check", mesh, "--domain", leaky}));
  shows_name(run({"build", "cdt", leaky, "--domain-kind", "enclosed", "-o", mesh}));
  const std::string invalid = nasty.folder.write(
      kNasty + "i.poly", "4 2 0 0\n1 0 0\n2 2 2\n3 2 0\n4 0 2\n2 0\n1 1 2\n2 3 4\n0\n");
  shows_name(run({"inspect", invalid}));
  shows_name(run({"check", mesh, "--domain", invalid}));
}

TEST_CASE(
    "JSON gives names as they are, escaped, if they are UTF-8, and is ASCII where it matters") {
  const ScratchFolder folder;
  const std::string name = "c\nholds: x\x1b[31m\x7f\xc2\x9b\xe2\x80\xa8\xe2\x80\xae\xc3\xa9";
  folder.write(name + ".node", kPoints);
  const std::string mesh = folder.write(name + ".ele", kTriangles);
  const Run judged = run({"check", mesh, "--format", "json"});
  CHECK(is_harmless(judged.out));
  CHECK(document(judged)["results"][0]["mesh"] == mesh);
  CHECK(has(judged.out, "\xc3\xa9"));
  const Nasty nasty;
  for (const Run& result : {run({"check", nasty.mesh, "--format", "json"}),
                            run({"inspect", nasty.points, "--format", "json"}),
                            run({"compare", nasty.mesh, nasty.mesh, "--format", "json"}),
                            run({"check", nasty.mesh + "x", "--format", "json"})}) {
    CHECK(is_harmless(result.out));
    CHECK(is_harmless(result.err));
    CHECK(document(result)["results"].size() == 1);
  }
}

}  // namespace
}  // namespace circumspect::cli
