// The same mesh gets the same verdict in every format, against its domain in every format, and part
// after part.
#include <sstream>

#include <doctest/doctest.h>

#include "command/run_command_test.hpp"
#include "oracle/formats/written_elements_test.hpp"
#include "oracle/judge/fast/grid_mesh_test.hpp"

namespace circumspect::cli {
namespace {

using formats::WrittenForm;
using formats::WrittenMesh;

// Two tetrahedra on one triangle, with their surface and an edge of it; the second apex is within
// the circumsphere of the first, or it is not.
WrittenMesh two_tetrahedra(double depth) {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.1, 0.1, 1.0 / 3}, {0.1, 0.1, -depth}},
          {{0, 1},
           {0, 3, 1},
           {1, 3, 2},
           {0, 2, 3},
           {0, 1, 4},
           {1, 2, 4},
           {0, 4, 2},
           {0, 1, 2, 3},
           {0, 2, 1, 4}}};
}

std::string off_of(const WrittenMesh& mesh) {
  std::ostringstream text;
  text.precision(17);
  text << "OFF\n" << mesh.points.size() << " 6 0\n";
  for (const auto& point : mesh.points)
    text << point[0] << ' ' << point[1] << ' ' << point[2] << '\n';
  for (const auto& cell : mesh.cells) {
    if (cell.size() == 3) text << "3 " << cell[0] << ' ' << cell[1] << ' ' << cell[2] << '\n';
  }
  return text.str();
}

// The verdict without the name of the file.
std::string without(std::string text, const std::string& name) {
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name)) {
    text.replace(at, name.size(), "MESH");
  }
  return text;
}

// The first words of the verdict: the claim, and the rule that it breaks.
std::string rule_of(const Run& result, const std::string& path) {
  const std::string out = without(result.out, path);
  const std::size_t last = out.rfind('\n', out.size() - 2);
  const std::string line = out.substr(last == std::string::npos ? 0 : last + 1);
  return begins_with(line, "fails: ")
             ? line.substr(0, line.find(" MESH") + 5) +
                   line.substr(line.find(" MESH") + 5,
                               line.find(' ', line.find(" MESH") + 6) - line.find(" MESH") - 5)
             : line;
}

// As NumPy saves them.
template <class Number>
std::string npy(const std::string& type, std::size_t columns, const std::vector<Number>& numbers) {
  std::string header = "{'descr': '" + type + "', 'fortran_order': False, 'shape': (" +
                       std::to_string(numbers.size() / columns) + ", " + std::to_string(columns) +
                       "), }";
  header += std::string(117 - header.size(), ' ') + "\n";
  const auto* const bytes = reinterpret_cast<const char*>(numbers.data());
  return std::string("\x93NUMPY\x01\x00\x76\x00", 10) + header +
         std::string(bytes, numbers.size() * sizeof(Number));
}

}  // namespace

TEST_CASE("the same verdict of a mesh in every format") {
  const ScratchFolder folder;
  for (const auto& [depth, exit_code, begins] :
       {std::tuple{2.0, 0, "holds: delaunay MESH 5 points 2 tetrahedra"},
        {0.01, 1, "fails: delaunay MESH delaunay.facet-not-local"},
        {-0.25, 1, "fails: delaunay MESH complex.overlap"}}) {
    std::size_t number = 0;
    for (const WrittenForm& form : all_forms(two_tetrahedra(depth))) {
      CAPTURE(form.name);
      const std::string path =
          folder.write("m" + std::to_string(++number) + form.extension, form.text);
      const Run result = run({"check", path});
      CHECK_MESSAGE(result.exit_code == exit_code, result.err);
      CHECK_MESSAGE(begins_with(rule_of(result, path), begins), result.out);
      CHECK(result.err.empty());
    }
  }
}

TEST_CASE("the same verdict against a domain, whatever the formats of both") {
  const ScratchFolder folder;
  const WrittenMesh mesh = two_tetrahedra(2);
  const std::string off = folder.write("d.off", off_of(mesh));
  const std::string ele = folder.write("m.tet", formats::tet(mesh, false));
  std::size_t number = 0;
  for (const WrittenForm& form : all_forms(mesh)) {
    CAPTURE(form.name);
    const std::string path =
        folder.write("m" + std::to_string(++number) + form.extension, form.text);
    const Run against_off = run({"check", path, "--domain", off});
    CHECK_MESSAGE(against_off.exit_code == 0, (against_off.out + against_off.err));
    CHECK(begins_with(rule_of(against_off, path), "holds: cdt MESH 5 points 2 tetrahedra"));
    if (!form.has_faces) continue;
    const Run against_form = run({"check", ele, "--domain", path});
    CHECK_MESSAGE(against_form.exit_code == 0, (against_form.out + against_form.err));
  }
}

TEST_CASE("without a domain, a surface and a mesh that is not convex get a note that leads on") {
  const ScratchFolder folder;
  const std::string faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  const std::string surface = folder.write("s.off", "OFF\n4 4 0\n" + points + faces);
  const Run judged = run({"check", surface});
  CHECK(judged.exit_code == 1);
  CHECK(has(judged.out, "note: " + surface + ": triangles in space are a surface, "));
  CHECK(has(judged.out, "circumspect inspect --domain " + surface + " tells"));
  CHECK(has(judged.out, "circumspect check MESH --domain " + surface + " judges"));
  CHECK(run({"inspect", "--domain", surface}).exit_code == 0);
  CHECK(!has(run({"check", surface, "--format", "json"}).out, "triangles in space"));
  // Where the file cannot be a domain, the note names claims.
  folder.write("t.node", "4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n");
  const std::string triangle = folder.write("t.ele", "1 3\n0 0 1 2\n");
  CHECK(!has(run({"check", triangle}).out, "--domain"));
  CHECK(has(run({"check", triangle}).out, "--claim convex-hull tells"));

  const std::string dented =
      folder.write("d.off", "OFF\n4 2 0\n-2 0 0\n2 0 0\n0 3 0\n0 1 0\n3 0 3 2\n3 1 2 3\n");
  const Run not_convex = run({"check", dented});
  CHECK(not_convex.exit_code == 1);
  CHECK(has(not_convex.out, "is judged with --domain FILE: what its mesher was given\n"));
  CHECK(run({"check", dented, "--domain", dented}).exit_code != 2);
  CHECK(!has(run({"check", dented, "--format", "json"}).out, "--domain"));
}

TEST_CASE("build writes what check reads, in every format") {
  const ScratchFolder folder;
  const std::string domain = folder.write("d.off", off_of(two_tetrahedra(2)));
  for (const std::string name : {"o.ele", "o.mesh", "o.msh", "o.vtu", "o.json"}) {
    const std::string path = folder.path(name);
    CHECK(run({"build", "cdt", domain, "-o", path}).exit_code == 0);
    const Run result = run({"check", path, "--domain", domain});
    CHECK_MESSAGE(result.exit_code == 0, (result.out + result.err));
    CHECK(run({"compare", folder.path("o.ele"), path}).exit_code == 0);
  }
}

// A mesh that does not fit the memory in one piece: two parts for each thread.
// The text without its lines that have these words.
std::string without_line(const std::string& text, const std::string& words) {
  std::string rest;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!has(line, words)) rest += line + "\n";
  }
  return rest;
}

TEST_CASE("check --memory says what check says, and refuses what it cannot do") {
  const ScratchFolder folder;
  auto grid = fast::grid_mesh<3>(41);
  const std::vector<std::int32_t> good = grid.simplices;
  const std::string points = folder.write("p.npy", npy("<f8", 3, grid.coordinates));
  const std::string mesh = folder.path("s.npy");
  const auto said = [&](std::vector<std::string> more) {
    std::vector<std::string> words = {"check", mesh, "--points", points, "--threads", "1"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  };
  const auto same = [&](int exit_code, const std::string& format) {
    folder.write("s.npy", npy("<i4", 4, grid.simplices));
    const Run whole = said({"--format", format});
    const Run parts = said({"--format", format, "--memory", "64M"});
    CHECK_MESSAGE(parts.exit_code == exit_code, parts.err);
    CHECK(whole.exit_code == exit_code);
    // Causes are looked for in a whole mesh alone, and whether it is a complex at least.
    const std::string rest = without_line(without_line(whole.out, "--claim complex"), "cause: ");
    CHECK(without_line(parts.out, "--claim complex") == rest);
    CHECK(parts.err == whole.err);
  };
  same(0, "text");
  grid.simplices[4 * 1000 + 1] = grid.simplices[4 * 300000 + 2];
  same(1, "text");
  grid.simplices = good;
  grid.simplices.resize(good.size() - 4);
  same(1, "text");
  CHECK(has(said({"--memory", "64M"}).out, ": --claim complex tells whether the simplices fit"));
  grid.simplices = good;
  grid.simplices[4 * 1000 + 1] = -5;
  same(1, "json");
  CHECK(said({"--memory", "64M", "--oriented"}).exit_code == 2);
  CHECK(said({"--memory", "63M"}).exit_code == 2);
  const Run absent = run({"check", folder.path("none.npy"), "--points", points, "--memory", "1G"});
  CHECK(absent.exit_code == 3);
  const std::string line = "TMPDIR=/nowhere " CIRCUMSPECT_COMMAND " check " + mesh + " --points " +
                           points + " --threads 1 --memory 64M 2> " + folder.path("err");
  CHECK(WEXITSTATUS(std::system(line.c_str())) == 5);
  const std::string error = contents(folder.path("err"));
  CHECK(is_error_line(error));
  CHECK(has(error, "TMPDIR names another folder"));
}

}  // namespace circumspect::cli
