// --html and --vtu, as their users give them.
#include <filesystem>

#include <doctest/doctest.h>

#include "command/run_command.hpp"

namespace circumspect::cli {
namespace {

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

}  // namespace
}  // namespace circumspect::cli
