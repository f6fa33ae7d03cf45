// Campaigns whose meshes are to be complexes, and nothing more.
#include <doctest/doctest.h>

#include "command/campaign/program_test.hpp"

namespace circumspect::cli {
namespace {

// Of the mesh of the points, the lines that `rows` makes of its lines.
std::string with_rows(const std::string& rows) {
  return "CIRCUMSPECT=" CIRCUMSPECT_COMMAND
         "\n\"$CIRCUMSPECT\" build delaunay --quiet --duplicates merge \"$1\" -o whole.ele || exit "
         "9\nawk '" +
         rows + "' whole.ele > \"$2\"\n";
}

const Arguments kAsked = {"--claim",         "complex", "--cases",         "40",
                          "--max-points",    "9",       "--minimize-runs", "20",
                          "--full-dimension"};

TEST_CASE("campaign --claim complex: a right program holds") {
  const Program right(kRight);
  const Run held = run(right.campaign(kAsked));
  CHECK_MESSAGE(held.exit_code == 0, held.out);
  CHECK(has(last_line(held.out), "holds: campaign program 40 cases"));
}

TEST_CASE("campaign --claim complex: a simplex that is listed twice is found, and made small") {
  const Program twice(
      with_rows("NF && !/^#/ { if (!n++) { print $1 + 1, $2, $3; next } "
                "if (!first) { first = $0; sub(/^ *[0-9]+/, \"\", first) } last = $1; print } "
                "END { print last + 1 first }"));
  Arguments asked = kAsked;
  asked.push_back("--go-on");  // it fails on every input
  const Run failed = run(twice.campaign(asked));
  CHECK(failed.exit_code == 1);
  CHECK(twice.signatures() == std::set<std::string>{"complex.duplicate-simplex"});
  CHECK(has(twice.finding("complex.duplicate-simplex", "reproduce.sh"), "--claim complex"));
  const std::string small = twice.finding("complex.duplicate-simplex", "verdict.json");
  CHECK(has(small, "\"minimal_points\": 4"));
}

}  // namespace
}  // namespace circumspect::cli
