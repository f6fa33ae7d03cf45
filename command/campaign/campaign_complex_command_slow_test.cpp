// Campaigns whose meshes are to be complexes, and nothing more, and those of Voronoi diagrams.
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

// The diagrams whose lines `rows` makes.
std::string diagrams(const std::string& rows) {
  return "CIRCUMSPECT=" CIRCUMSPECT_COMMAND
         "\n\"$CIRCUMSPECT\" build voronoi \"$1\" > whole || exit 9\nawk '" +
         rows + "' whole > \"$2\"\n";
}

const Arguments kAskedOfCells = {"--claim",
                                 "voronoi",
                                 "--within",
                                 "1e-6x",
                                 "--cases",
                                 "12",
                                 "--max-points",
                                 "8",
                                 "--families",
                                 "integers",
                                 "--full-dimension",
                                 "--dimension",
                                 "2",
                                 "--minimize-runs",
                                 "40"};

TEST_CASE("campaign --claim voronoi: a right program holds, and one that moves a corner does not") {
  const Program right(diagrams("{ print }"));
  const Run held = run(right.campaign(kAskedOfCells));
  CHECK_MESSAGE(held.exit_code == 0, (held.out + held.err));
  const Program wrong(diagrams("NR == 4 { $1 += 1 } { print }"));
  Arguments asked = kAskedOfCells;
  asked.push_back("--go-on");
  const Run failed = run(wrong.campaign(asked));
  CHECK(failed.exit_code == 1);
  CHECK(wrong.signatures() == std::set<std::string>{"voronoi.cell-differs"});
  CHECK(has(wrong.finding("voronoi.cell-differs", "reproduce.sh"),
            "--claim voronoi --points \"$here/minimal.node\" --within 1/1000000x"));
  CHECK(has(wrong.finding("voronoi.cell-differs", "verdict.json"), "\"minimal_points\": 3"));
  const Run bare = run(right.campaign({"--claim", "delaunay", "--within", "1e-6"}));
  CHECK(bare.exit_code == 2);
}

}  // namespace
}  // namespace circumspect::cli
