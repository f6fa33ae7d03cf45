// The notes beside a verdict: what may be all that is wrong.
#include <algorithm>

#include <doctest/doctest.h>

#include "command/run_command_test.hpp"

namespace circumspect::cli {
namespace {

Run check_triangulation(const std::string& mesh, const std::string& domain,
                        std::vector<std::string> more = {}) {
  std::vector<std::string> words = {"check", mesh,      "--domain",
                                    domain,  "--claim", "steiner-triangulation"};
  words.insert(words.end(), more.begin(), more.end());
  return run(words);
}

}  // namespace

TEST_CASE("check: where rounding is all that is wrong, the note names no other option") {
  // One face of the tetrahedron is cut in two by the segment 1 4. The Steiner point on it is
  // rounded.
  ScratchFolder folder;
  folder.write("m.node",
               "6 3 0 0\n0 0 0 0\n1 3 0 0\n2 0 3 0\n3 0 0 3\n4 0 1 2\n"
               "5 2 0.3333333333333333 0.6666666666666666\n");
  const std::string mesh =
      folder.write("m.ele", "4 4 0\n0 0 1 2 5\n1 0 5 2 4\n2 0 1 5 3\n3 0 5 4 3\n");
  const std::string domain =
      folder.write("d.poly",
                   "5 3 0 0\n0 0 0 0\n1 3 0 0\n2 0 3 0\n3 0 0 3\n4 0 1 2\n6 0\n"
                   "1\n3 0 1 2\n1\n3 0 1 3\n1\n3 0 2 4\n1\n3 0 4 3\n1\n3 1 2 4\n1\n3 1 4 3\n0\n");
  const Run result = check_triangulation(mesh, domain);
  CHECK(result.exit_code == 1);
  CHECK(has(result.out, "may have been rounded"));
  CHECK(has(result.out, "with --within 3.4e-17 the claim holds"));
  CHECK(!has(result.out, "--merge-coplanar"));
  CHECK(check_triangulation(mesh, domain, {"--within", "3.4e-17"}).exit_code == 0);
}

TEST_CASE("check: a note says that a point of a convex hull may have been rounded") {
  // The Steiner point 4 is on an edge of the hull, but for rounding: inward, and outward.
  ScratchFolder folder;
  const std::string corners = "0 0 0\n1 3 0\n2 0 1\n3 1 0.25\n";
  const std::string domain = folder.write("d.poly", "4 2 0 0\n" + corners + "0 0\n0\n");
  const std::string mesh = folder.write("m.ele", "4 3 0\n0 0 1 3\n1 1 4 3\n2 4 2 3\n3 2 0 3\n");
  for (const auto& [y, rule] : {std::pair("0.3333333333333333", "triangulation.hull-not-convex 1"),
                                std::pair("0.33333333333333337", "domain.outside 2")}) {
    folder.write("m.node", "5 2 0 0\n" + corners + "4 2 " + y + "\n");
    const Run result = check_triangulation(mesh, domain);
    CHECK(result.exit_code == 1);
    CHECK(has(result.out, "may have been rounded (" + std::string(rule) + "): with --within "));
    CHECK(has(result.out, "the claim holds"));
  }
  // Far off, it is not rounded.
  folder.write("m.node", "5 2 0 0\n" + corners + "4 2 0.25\n");
  CHECK(!has(check_triangulation(mesh, domain).out, "rounded"));
}

TEST_CASE("check: notes about a verdict stand beside it, after the witnesses") {
  ScratchFolder folder;
  const std::string domain =
      folder.write("d.poly", "3 2 0 0\n0 0 0\n1 3 0\n2 0 1\n3 0\n0 0 1\n1 1 2\n2 2 0\n0\n");
  folder.write("m.node", "4 2 0 0\n0 0 0\n1 3 0\n2 0 1\n3 2 0.3333333333333333\n");
  const std::string mesh = folder.write("m.ele", "2 3 0\n0 0 1 3\n1 0 3 2\n");
  const std::string out = check_triangulation(mesh, domain).out;
  const std::size_t witness = out.find("domain.segment-missing: "), note = out.find("note: "),
                    verdict = out.find("fails: ");
  CHECK(witness < note);
  CHECK(note < verdict);
  CHECK(out.find('\n', note) + 1 == verdict);
  CHECK(out.find('\n', verdict) + 1 == out.size());
  // A mesh without a domain.
  folder.write("n.node", "4 2 0 0\n0 0 0\n1 3 0\n2 1 1\n3 0 3\n");
  const std::string alone = run({"check", folder.write("n.ele", "2 3 0\n0 0 1 2\n1 0 2 3\n")}).out;
  CHECK(alone.find("hull-not-convex: ") < alone.find("note: "));
  CHECK(alone.find("note: ") < alone.find("fails: "));
}

TEST_CASE("check --within: a facet of three simplices does not make misses of what is permitted") {
  ScratchFolder folder;
  const std::string domain = folder.write(
      "d.poly", "4 2 0 0\n0 0 0\n1 10 0\n2 10 10\n3 0 10\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n");
  folder.write("m.node", "5 2 0 0\n0 0 0\n1 10.000000000001 0\n2 10 10\n3 0 10\n4 5 6\n");
  const std::string mesh =
      folder.write("m.ele", "5 3 0\n0 0 1 4\n1 1 2 4\n2 2 3 4\n3 3 0 4\n4 1 4 3\n");
  for (const char* by : {"lemma", "definition"}) {
    const Run result = run({"check", mesh, "--domain", domain, "--within", "1e-9", "--by", by});
    CHECK(result.exit_code == 1);
    CHECK(!has(result.out, "domain.vertex-missing"));
    CHECK(has(result.out, "within ~ 1.1e-12"));
  }
  CHECK(has(run({"check", mesh, "--domain", domain, "--within", "1e-9"}).out,
            "complex.facet-overused 2"));
}

}  // namespace circumspect::cli
