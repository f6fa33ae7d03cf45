#include "fuzz/campaign/journal.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <doctest/doctest.h>
#include <sys/stat.h>

#include "fuzz/campaign/finding_folder.hpp"
#include "inputs/scratch_folder_test.hpp"

namespace circumspect::campaign {

namespace {

const Settings kSettings = {{"command", "tetgen -Q"}, {"--seed", "7"}};

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST_CASE("a journal goes on where it ended") {
  const formats::ScratchFolder folder;
  {
    auto journal = Journal::open(folder.path("out"), kSettings);
    REQUIRE(journal);
    journal->add_case(0, {"grid", "holds", false, 7});
    journal->add_finding("hang", 1);
    journal->add_case(1, {"sphere", "hang", true});
    journal->add_finding("no-mesh", 2);
    journal->add_cut_off("hang");
    journal->add_minimised("hang");
    journal->add_cut_off("no-mesh");
  }
  auto journal = Journal::open(folder.path("out"), kSettings);
  REQUIRE(journal);
  REQUIRE(journal->cases().size() == 2);
  CHECK(journal->cases()[1].family == "sphere");
  CHECK(journal->cases()[1].is_finding);
  CHECK(journal->cases()[0].points == 7);
  CHECK(!journal->cases()[1].points);
  REQUIRE(journal->findings().size() == 2);
  CHECK(journal->findings()[0].is_minimised);
  CHECK(!journal->findings()[1].is_minimised);
  CHECK(journal->findings()[1].is_cut_off);
  CHECK(journal->findings()[1].case_number == 2);
}

TEST_CASE("a journal says whether the call before was killed") {
  const formats::ScratchFolder folder;
  const auto open = [&] { return Journal::open(folder.path("out"), kSettings).value(); };
  {
    Journal first = open();
    CHECK(!first.was_killed());
    first.add_begin();
    first.add_case(0, {"grid", "holds", false, 7});
  }
  {
    Journal second = open();
    CHECK(second.was_killed());
    second.add_begin();
    second.add_end();
  }
  CHECK(!open().was_killed());
}

TEST_CASE("whatever byte a journal is cut off at, it goes on from the last whole line") {
  const formats::ScratchFolder folder;
  std::string whole;
  {
    auto journal = Journal::open(folder.path("out"), kSettings);
    for (std::size_t i = 0; i < 3; ++i) journal->add_case(i, {"grid", "holds", false, 12});
    whole = text_of(folder.path("out/journal.tsv"));
  }
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    std::ofstream(folder.path("out/journal.tsv")) << whole.substr(0, size);
    auto journal = Journal::open(folder.path("out"), kSettings);
    CAPTURE(size);
    REQUIRE(journal);
    for (std::size_t i = journal->cases().size(); i < 3; ++i) {
      journal->add_case(i, {"grid", "holds", false, 12});
    }
    CHECK(text_of(folder.path("out/journal.tsv")) == whole);
  }
}

TEST_CASE("a finding that is found again, since its case was lost in a crash, is one finding") {
  const formats::ScratchFolder folder;
  for (const std::size_t first : {1, 2}) {
    auto journal = Journal::open(folder.path("out"), kSettings);
    REQUIRE(journal);
    if (first == 1) journal->add_case(0, {"grid", "holds", false, 7});
    journal->add_finding("hang", first);
  }
  const auto journal = Journal::open(folder.path("out"), kSettings);
  REQUIRE(journal);
  REQUIRE(journal->findings().size() == 1);
  CHECK(journal->findings()[0].case_number == 1);
}

TEST_CASE("a journal of another campaign is refused, and says why") {
  const formats::ScratchFolder folder;
  {
    auto journal = Journal::open(folder.path("out"), kSettings);
    REQUIRE(journal);
    journal->add_case(0, {"grid", "holds", false, 7});
  }
  const auto other = Journal::open(folder.path("out"), {{"command", "tetgen -Q"}, {"--seed", "8"}});
  REQUIRE(!other);
  CHECK(other.error().find("expected --seed '7' as when it began, found '8'") != std::string::npos);
  const auto held = Journal::open(folder.path("out"), kSettings);
  REQUIRE(held);
  const auto twice = Journal::open(folder.path("out"), kSettings);
  REQUIRE(!twice);
  CHECK(twice.error().find("another campaign writes to it") != std::string::npos);
  folder.write("journal.tsv", "something else\n");
  CHECK(!Journal::open(folder.path(""), kSettings));
  CHECK(text_of(folder.path("journal.tsv")) == "something else\n");
}

TEST_CASE("a journal without a case is begun anew by any campaign") {
  const formats::ScratchFolder folder;
  { CHECK(Journal::open(folder.path("out"), kSettings)); }
  { CHECK(Journal::open(folder.path("out"), {{"command", "another"}})); }
  CHECK(text_of(folder.path("out/journal.tsv")) ==
        "circumspect-campaign 1\nsetting\tcommand\tanother\n");
}

TEST_CASE("a journal says why its folder cannot be") {
  const formats::ScratchFolder folder;
  folder.write("file", "");
  const auto in_file = Journal::open(folder.path("file/out"), kSettings);
  REQUIRE(!in_file);
  CHECK(in_file.error().find("file/out: expected a folder, or a place for one: Not a directory") !=
        std::string::npos);
  const auto in_proc = Journal::open("/proc/nowhere/out", kSettings);
  REQUIRE(!in_proc);
  CHECK(in_proc.error().find("/proc/nowhere/out: expected a folder, or a place for one: ") == 0);
}

TEST_CASE("what is not a file, or a line that no campaign wrote, is not a journal") {
  const formats::ScratchFolder folder;
  REQUIRE(mkfifo(folder.path("journal.tsv").c_str(), 0600) == 0);
  CHECK(!Journal::open(folder.path(""), kSettings));
  std::filesystem::remove(folder.path("journal.tsv"));
  { CHECK(Journal::open(folder.path(""), kSettings)); }
  // A signature names a folder among the findings, and nothing elsewhere.
  for (const char* line :
       {"finding\thang\t-1\n", "case\t1\tgrid\tholds\tholds\n", "nonsense\n",
        "finding\t../../mine\t0\n", "finding\t/etc\t0\n", "finding\t.\t0\n", "finding\t\t0\n",
        "finding\ta\x1b[2J\t0\n", "case\t0\tgrid\tfinding\t../mine\n"}) {
    const std::string whole = text_of(folder.path("journal.tsv"));
    folder.write("journal.tsv", whole + line);
    const auto journal = Journal::open(folder.path(""), kSettings);
    REQUIRE(!journal);
    CHECK(journal.error().find("line 4: expected ") != std::string::npos);
    folder.write("journal.tsv", whole);
  }
}

}  // namespace

namespace {

// The picture of one witness, given as JSON.
std::string drawn(const std::string& witness) {
  return witness_picture(report::Json::parse("{\"violations\": [" + witness + "]}"));
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++found;
  return found;
}

// Every number of the drawing lies on it.
void check_numbers(const std::string& svg) {
  CHECK(svg.find("nan") == std::string::npos);
  CHECK(svg.find("inf") == std::string::npos);
  for (std::size_t i = 0, digits = 0; i < svg.size(); ++i) {
    digits = svg[i] >= '0' && svg[i] <= '9' ? digits + 1 : 0;
    REQUIRE(digits <= 4);
  }
}

TEST_CASE("a witness is drawn in the plane and, aslant, in space") {
  const std::string plane = drawn(R"({"simplices": [[1, 2, 3]], "face": [1, 2], "vertices": [4],
      "coordinates": {"1": ["0", "0"], "2": ["4", "0"], "3": ["0", "4"], "4": ["1", "1"]}})");
  CHECK(plane.rfind("<svg xmlns=", 0) == 0);
  // The lower left corner, the lower right one and the upper left one; the ring is around the
  // fourth.
  CHECK(plane.find("M30.00 330.00 L330.00 330.00 L30.00 30.00 Z") != std::string::npos);
  CHECK(plane.find("M30.00 330.00 L330.00 330.00 Z\" fill=\"none\" stroke=\"black\"") !=
        std::string::npos);
  CHECK(plane.find("translate(105.00 255.00)\"><circle r=\"8\"") != std::string::npos);
  CHECK(plane.find(">4</text>") != std::string::npos);
  const std::string space = drawn(R"({"simplices": [[0, 1, 2, 3]],
      "coordinates": {"0": ["0", "0", "0"], "1": ["2", "0", "0"], "2": ["0", "2", "0"], "3": ["0", "0", "2"]}})");
  CHECK(count(space, "<path") == 4);
  // A fifth of the way to the right, and an eighth up: 2/5 and 1/4 of two, of an extent of two.
  CHECK(space.find("translate(150.00 255.00)\"><circle r=\"3\"") != std::string::npos);
  check_numbers(plane);
  check_numbers(space);
}

TEST_CASE("of what cannot be drawn there is no picture, or what can be drawn") {
  CHECK(witness_picture(report::Json()).empty());
  CHECK(witness_picture(report::Json{{"violations", report::Json::array()}}).empty());
  CHECK(drawn(R"({"rule": "x"})").empty());
  CHECK(drawn(R"({"coordinates": {"0": ["0"], "1": ["1"], "2": ["2"]}})").empty());
  CHECK(drawn(R"({"coordinates": {"0": ["0", "0", "0", "0"], "1": ["1", "0", "0", "0"],
      "2": ["0", "1", "0", "0"]}})")
            .empty());
  CHECK(drawn(R"({"coordinates": {"0": ["7", "7"], "1": ["7", "7"], "2": ["7", "7"]}})").empty());
  CHECK(
      drawn(
          R"({"coordinates": {"0": ["0", "0", "x"], "1": ["1", "0", "0"], "2": ["0", "1", "0"]}})")
          .empty());
  // Vertex 9 is not a point of the mesh: its simplex is left out, and the other is drawn.
  const std::string missing = drawn(R"({"simplices": [[0, 1, 9], [0, 1, 2]], "vertices": [9],
      "coordinates": {"0": ["0", "0"], "1": ["1", "0"], "2": ["0", "1"]}})");
  CHECK(count(missing, "<path") == 1);
  CHECK(count(missing, "r=\"8\"") == 0);
  std::string many;
  for (int i = 0; i < 200; ++i) {
    const std::string index = std::to_string(i);
    many += (i == 0 ? "\"" : ", \"") + index + "\": [\"" + index + "\", \"0\"]";
  }
  CHECK(drawn("{\"coordinates\": {" + many + "}}").empty());
}

TEST_CASE("exact places of thousands of digits are drawn, and labels that would hide each other") {
  const std::string huge = "1" + std::string(3000, '0');
  const std::string third = "1/3" + std::string(3000, '0');
  const std::string far = drawn(R"({"simplices": [[0, 1, 2]], "coordinates": {"0": [")" + huge +
                                R"(", "0"], "1": ["-)" + huge + R"(", ")" + third +
                                R"("], "2": ["0", ")" + huge + R"("]}})");
  CHECK(far.find("M330.00 255.00 L30.00 255.00 L180.00 105.00 Z") != std::string::npos);
  check_numbers(far);
  // The extent is the smallest possible, far from the origin.
  const std::string near =
      drawn(R"({"simplices": [[0, 1, 2]], "coordinates": {"0": [")" + huge + R"(", ")" + third +
            R"("], "1": [")" + huge + R"(", "0"], "2": [")" + huge + R"(", "1/6)" +
            std::string(3000, '0') + R"("]}})");
  CHECK(near.find("M180.00 30.00 L180.00 330.00 L180.00 180.00 Z") != std::string::npos);
  check_numbers(near);
  const std::string equal =
      drawn(R"({"point": ["0", "0"], "domain": {"segment": {"0<1>&": ["1", "1"],
      "7": ["0", "0"]}, "polygon": "p"}, "coordinates": {"3": ["0", "0"], "4": ["1", "0"]}})");
  CHECK(equal.find(">3, domain 7, point</text>") != std::string::npos);
  CHECK(equal.find(">domain 0&lt;1&gt;&amp;</text>") != std::string::npos);
  CHECK(equal.find("stroke-dasharray") != std::string::npos);
}

}  // namespace

}  // namespace circumspect::campaign
