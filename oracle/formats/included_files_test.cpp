// Decks that include files: what is read in which place, which line of which file an error names,
// and what is not followed.
#include "oracle/formats/included_files.hpp"

#include <doctest/doctest.h>

#include "inputs/scratch_folder_test.hpp"
#include "oracle/formats/format.hpp"
#include "oracle/formats/reading_test.hpp"

namespace circumspect::formats {
namespace {

class Decks {
 public:
  // Writes a file into the folder of the deck, or a folder below or above it.
  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
    folder_.write("jobs/" + name, text);
  }
  std::string path(const std::string& name) const { return folder_.path("jobs/" + name); }
  Result<Contents> read(const std::string& name, const std::string& text) const {
    const Source deck{path(name), text};
    return format_of(name.substr(name.find('.')))->read_mesh(deck, kDouble);
  }
  std::string error(const std::string& name, const std::string& text) const {
    return error_of(read(name, text));
  }

 private:
  ScratchFolder folder_;
};

const std::string kGrids = "GRID,1\nGRID,2,,1.\nGRID,3,,0.,1.\n";
const std::string kOneTriangle = "CTRIA3,1,1,1,2,3\n";
const std::vector<Point> kThreeGrids = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

}  // namespace

TEST_CASE("included files: a deck that is long already includes no file again") {
  const Decks decks;
  decks.write("part.inc", "0123456789\n");
  const Source deck{decks.path("deck.bdf"), "+part.inc\n+part.inc\nend\n"};
  const InclusionAt after_plus = [](TextLines lines) -> std::optional<Inclusion> {
    if (!lines.text().starts_with('+')) return std::nullopt;
    return Inclusion{std::string(lines.text().substr(1))};
  };
  CHECK(Deck(deck, after_plus, 24).source().text == "\n0123456789\n\n0123456789\nend\n");
  const Deck cut(deck, after_plus, 22);
  CHECK(cut.source().text == "\n0123456789\n+part.inc\nend\n");
  const Source renamed{deck.name, "+part.inc\n+../jobs/./part.inc\nend\n"};
  CHECK(Deck(renamed, after_plus, 22).source().text == "\n0123456789\n+../jobs/./part.inc\nend\n");
  FormatError error;
  error.file = deck.name;
  error.line = 3;
  CHECK(cut.at_its_place(error).line == 2);
  CHECK(cut.at_its_place(error).found == "\"part.inc\" again (12 bytes are read)");
}

TEST_CASE("included files: a deck of Nastran is read with all that it includes") {
  const Decks decks;
  decks.write("mesh/grids.inc", "\xEF\xBB\xBFGRID,1\r\nGRID,2,,1.\r\nINCLUDE 'more/last one.inc'");
  decks.write("mesh/more/last one.inc", "GRID,3,,0.,1.");
  decks.write("../all.inc", "INCLUDE 'mesh/grids.inc'\n");  // as from the folder of the deck
  for (const std::string include :
       {"INCLUDE 'mesh/grids.inc' $ nodes\n", "include mesh\\grids.inc $ nodes\n",
        "  Include \"mesh/\n grids\n  .inc\"\n", "INCLUDE'./mesh/../mesh/grids.inc'\n",
        "INCLUDE '../all.inc'\n"}) {
    CAPTURE(include);
    const auto mesh = decks.read("deck.bdf", "BEGIN BULK\n" + include + kOneTriangle + "ENDDATA\n");
    REQUIRE_MESSAGE(mesh, error_of(mesh));
    CHECK(mesh->points->points.points == kThreeGrids);
    CHECK(mesh->simplices.simplices == std::vector<Simplex>{{1, 2, 3}});
  }
  // What stands before the bulk and behind its end need not be there.
  CHECK(decks.read("deck.bdf", "INCLUDE 'dmap'\nBEGIN BULK\n" + kGrids + kOneTriangle +
                                   "ENDDATA\nINCLUDE 'results'\n"));
  decks.write("end.inc", kGrids + kOneTriangle + "ENDDATA\n");
  CHECK(decks.read("deck.bdf", "INCLUDE 'end.inc'\nCTRIA3,2,1,1,2,9\n"));
}

TEST_CASE("included files: a deck of Abaqus may include data lines, nodes and elements") {
  const Decks decks;
  decks.write("rows.csv", "2, 1, 0\n3, 0, 1\n");
  decks.write("mesh/cells.inp", "*Element, input=\"rows of cells\", type=S3\n");
  decks.write("mesh/rows of cells", "1, 1, 2, 3\n");
  const std::string cells = "*INCLUDE, INPUT=mesh/cells.inp\n";
  for (const std::string nodes :
       {"*Node\n1\n*Include, input=rows.csv\n", "*Node, nset=all, INPUT = rows.csv\n1, 0, 0\n"}) {
    CAPTURE(nodes);
    const auto mesh = decks.read("deck.inp", "*Heading\nx\n" + nodes + cells);
    REQUIRE_MESSAGE(mesh, error_of(mesh));
    CHECK(mesh->simplices.simplices == std::vector<Simplex>{{1, 2, 3}});
  }
}

TEST_CASE("included files: an error names the file and the line of the fault") {
  const Decks decks;
  decks.write("mesh/a.inc", kGrids + "INCLUDE 'b.inc'\nCTRIA3,2,1,1,2,x\n");
  decks.write("mesh/b.inc", "$\nCTRIA3,1,1,1,2,3\nCTRIA3,3,1,1,2\n");
  const std::string deck = "INCLUDE 'mesh/\n a.inc'\nGRID,y\n";
  CHECK(decks.error("deck.bdf", deck) ==
        decks.path("mesh/b.inc") + ":3: expected a triangle of 3 nodes, found an empty field");
  decks.write("mesh/b.inc", "");
  CHECK(
      decks.error("deck.bdf", deck).starts_with(decks.path("mesh/a.inc") + ":5: expected a node"));
  decks.write("mesh/a.inc", kGrids);
  CHECK(decks.error("deck.bdf", deck).starts_with(decks.path("deck.bdf") + ":3: expected the tag"));
  decks.write("mesh/a.inc", kGrids + "CQUAD4,1,1,1,2,3,1\n");
  CHECK(decks.error("deck.bdf", "INCLUDE 'mesh/a.inc'\n") ==
        decks.path("mesh/a.inc") +
            ":4: expected edges, triangles and tetrahedra, found a quadrilateral");
  decks.write("mesh/a.inc", "GRID,7\n" + kGrids + "CTRIA3,1,1,1,2,9\n");
  CHECK(decks.error("deck.bdf", "INCLUDE 'mesh/a.inc'\n") ==
        decks.path("mesh/a.inc") + ":5: expected the tag of a node of a GRID, found 9");
}

TEST_CASE("included files: what is missing, ambiguous or endless is said where it is included") {
  const Decks decks;
  const auto error = [&](const std::string& path) {
    return decks.error("deck.bdf", "BEGIN BULK\nINCLUDE '" + path + "'\n");
  };
  const std::string at = decks.path("deck.bdf") + ":2: expected ";
  CHECK(error("mesh/none.inc") ==
        at + "a file to include, " + decks.path("mesh/none.inc") +
            ", found no file of that name (put it there, or correct the path)");
  decks.write("folder/x", "");
  CHECK(error("folder").starts_with(at + "a file to include, "));
  for (const std::string path : {"/etc/hosts", "C:\\mesh.inc", "MESHES:nodes.inc", ""}) {
    CHECK(error(path) ==
          at + "a file to include by its path from the folder of the deck, found \"" + path +
              "\" (write such a path: absolute ones and names that stand for "
              "folders are not followed)");
  }
  CHECK(error(std::string(500, 'a')).size() < 500);
  CHECK(error_of(format_of(".bdf")->read_mesh({"<stdin>", "INCLUDE 'a.inc'\n"}, kDouble)) ==
        "<stdin>:1: expected no files to include from standard input, which has no folder, found "
        "\"a.inc\" (give the name of the deck)");
  decks.write("mesh/a.inc", "$\nINCLUDE '../b.inc'\n");
  decks.write("b.inc", "INCLUDE 'mesh/./a.inc'\n");
  CHECK(error("mesh/a.inc") == decks.path("mesh/../b.inc") +
                                   ":1: expected files that do not include themselves, found "
                                   "\"mesh/./a.inc\" again");
  decks.write("mesh/a.inc", "INCLUDE 'c.inc'\n");
  decks.write("mesh/c.inc", "GRID,1\n");
  decks.write("c.inc", "GRID,2\n");
  CHECK(error("mesh/a.inc") == decks.path("mesh/a.inc") +
                                   ":1: expected one file that \"c.inc\" may mean, found \"" +
                                   decks.path("mesh/c.inc") + "\" and \"" + decks.path("c.inc") +
                                   "\" (rename one: programs differ in which of them they take)");
}

TEST_CASE("included files: what a domain has of several files has no line in one of them") {
  const Decks decks;
  decks.write("grids.inc", kGrids + "GRID,4,,0.,0.,1.\n");
  const std::string cells = "CTRIA3,1,1,1,2,4\nCROD,2,1,2,3\n";
  const auto lines = [&](const std::string& text) {
    const auto domain = format_of(".bdf")->read_domain({decks.path("deck.bdf"), text}, kDouble);
    REQUIRE_MESSAGE(domain, error_of(domain));
    REQUIRE(domain->polygon_lines.size() == 1);
    REQUIRE(domain->segment_lines.size() == 1);
    return std::vector<std::size_t>{domain->polygon_lines[0], domain->segment_lines[0]};
  };
  CHECK(lines("INCLUDE 'grids.inc'\n" + cells) == std::vector<std::size_t>{0, 0});
  CHECK(lines(kGrids + "GRID,4,,0.,0.,1.\n" + cells) == std::vector<std::size_t>{5, 6});
}

TEST_CASE("included files: there is a limit to how many, and to how deep they are") {
  const Decks decks;
  for (int i = 0; i < 30; ++i) {
    const std::string next = "INCLUDE 'd" + std::to_string(i + 1) + ".inc'\n";
    decks.write("d" + std::to_string(i) + ".inc", next + next);
  }
  CHECK(decks.error("deck.bdf", "INCLUDE 'd0.inc'\n")
            .find("expected at most 1000 included files, "
                  "20 in one another, found another") != std::string::npos);
  decks.write("leaf.inc", "$\n");
  std::string many;
  for (int i = 0; i < 1001; ++i) many += "INCLUDE 'leaf.inc'\n";
  CHECK(decks.error("deck.bdf", many).find(":1000: expected at most 1000") != std::string::npos);
}

}  // namespace circumspect::formats
