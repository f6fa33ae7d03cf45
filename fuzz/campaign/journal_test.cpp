#include "fuzz/campaign/journal.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <doctest/doctest.h>
#include <sys/stat.h>

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
    journal->add_case(0, {"grid", "holds", false});
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
  REQUIRE(journal->findings().size() == 2);
  CHECK(journal->findings()[0].is_minimised);
  CHECK(!journal->findings()[1].is_minimised);
  CHECK(journal->findings()[1].is_cut_off);
  CHECK(journal->findings()[1].case_number == 2);
}

TEST_CASE("whatever byte a journal is cut off at, it goes on from the last whole line") {
  const formats::ScratchFolder folder;
  std::string whole;
  {
    auto journal = Journal::open(folder.path("out"), kSettings);
    for (std::size_t i = 0; i < 3; ++i) journal->add_case(i, {"grid", "holds", false});
    whole = text_of(folder.path("out/journal.tsv"));
  }
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    std::ofstream(folder.path("out/journal.tsv")) << whole.substr(0, size);
    auto journal = Journal::open(folder.path("out"), kSettings);
    CAPTURE(size);
    REQUIRE(journal);
    for (std::size_t i = journal->cases().size(); i < 3; ++i) {
      journal->add_case(i, {"grid", "holds", false});
    }
    CHECK(text_of(folder.path("out/journal.tsv")) == whole);
  }
}

TEST_CASE("a journal of another campaign is refused, and says why") {
  const formats::ScratchFolder folder;
  { CHECK(Journal::open(folder.path("out"), kSettings)); }
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

TEST_CASE("what is no file, or a line that no campaign wrote, is no journal") {
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

}  // namespace circumspect::campaign
