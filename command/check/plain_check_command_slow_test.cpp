// What `check` says of a mesh does not depend on how it is read and judged: the same meshes, once
// as they are, and once with a plus sign in front of a number, which keeps them out of flat arrays.
#include <algorithm>
#include <filesystem>

#include <doctest/doctest.h>

#include "command/run_command_test.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/reading_test.hpp"

namespace circumspect::cli {
namespace {

namespace fs = std::filesystem;

// Where the next number of a .ele file stands, from this place on; npos if there is none.
std::size_t next_number(const std::string& text, std::size_t from) {
  std::size_t token = text.find_first_not_of(" \t\r\n", from);
  while (token != std::string::npos && text[token] == '#') {
    token = text.find_first_not_of(" \t\r\n", text.find('\n', token));
  }
  return token;
}

// The text with a plus sign in front of the index of its first simplex; as it is if it has none.
std::string with_plus(std::string text) {
  const std::size_t end_of_header = text.find('\n', next_number(text, 0));
  const std::size_t index = next_number(text, end_of_header);
  return index == std::string::npos ? text : text.insert(index, "+");
}

// Larger files take most of the time, and differ from small ones in nothing that options change.
constexpr std::uintmax_t kLarge = 3000;

// The meshes of the corpus that are read into flat arrays, in two folders.
struct CorpusMeshes {
  CorpusMeshes() {
    fs::create_directories(fast_folder);
    fs::create_directories(slow_folder);
    std::size_t count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(CIRCUMSPECT_CORPUS_DIR)) {
      if (entry.path().extension() != ".ele" || !formats::read_plain_mesh({entry.path()})) continue;
      add(entry.path(), std::to_string(count++), entry.file_size() <= kLarge);
    }
  }

  void add(fs::path original, const std::string& name, bool is_small) {
    const std::string ele = contents(original), other = with_plus(ele);
    if (other == ele) return;  // an empty mesh is read into flat arrays anyway
    scratch.write("fast/" + name + ".ele", ele);
    scratch.write("slow/" + name + ".ele", other);
    for (const std::string beside : {".node", ".neigh"}) {
      original.replace_extension(beside);
      if (!fs::exists(original)) continue;
      fs::copy(original, fast_folder + name + beside);
      fs::copy(original, slow_folder + name + beside);
    }
    // The small ones first.
    const auto at = is_small ? static_cast<std::ptrdiff_t>(small++) : std::ssize(fast);
    CHECK(formats::read_plain_mesh({*fast.insert(fast.begin() + at, fast_folder + name + ".ele")}));
    CHECK(
        !formats::read_plain_mesh({*slow.insert(slow.begin() + at, slow_folder + name + ".ele")}));
  }

  ScratchFolder scratch;
  std::string fast_folder = scratch.path("fast/");
  std::string slow_folder = scratch.path("slow/");
  std::vector<std::string> fast;
  std::vector<std::string> slow;
  std::size_t small = 0;
};

std::string with_folder(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at)) {
    text.replace(at, from.size(), to);
  }
  return text;
}

// All meshes in one run, or the small ones, with some options.
void compare(const CorpusMeshes& meshes, std::vector<std::string> options, bool all = false) {
  const auto count = static_cast<std::ptrdiff_t>(all ? meshes.fast.size() : meshes.small);
  options.insert(options.begin(), "check");
  std::vector<std::string> as_they_are = options;
  as_they_are.insert(as_they_are.end(), meshes.fast.begin(), meshes.fast.begin() + count);
  options.insert(options.end(), meshes.slow.begin(), meshes.slow.begin() + count);
  const Run fast = run(as_they_are);
  const Run slow = run(options);
  CHECK(fast.exit_code == slow.exit_code);
  CHECK(fast.out.find("holds") != std::string::npos);
  // Not compared by doctest, which would print all of it.
  const bool same_out = fast.out == with_folder(slow.out, meshes.slow_folder, meshes.fast_folder);
  const bool same_err = fast.err == with_folder(slow.err, meshes.slow_folder, meshes.fast_folder);
  CHECK(same_out);
  CHECK(same_err);
}

}  // namespace

TEST_CASE("check: the same words whether a mesh is read into flat arrays or not") {
  const CorpusMeshes meshes;
  CHECK(meshes.fast.size() > 100);
  CHECK(meshes.small > 100);
  compare(meshes, {}, true);
  compare(meshes, {"--format", "json"});
  compare(meshes, {"--claim", "triangulation"});
  compare(meshes, {"--claim", "weighted-delaunay", "--format", "json"});
  compare(meshes, {"--oriented"});
  compare(meshes, {"--neighbors"});
  compare(meshes, {"--duplicates", "merge"});
}

TEST_CASE("check: .npy points and simplices") {
  const ScratchFolder folder;
  const std::vector<double> square = {0, 0, 1, 0, 0, 1, 1, 1.5};
  const std::string points = folder.write("points.npy", formats::npy("<f8", "(4, 2)", square));
  const std::string simplices = folder.write(
      "simplices.npy", formats::npy<std::int32_t>("<i4", "(2, 3)", {0, 1, 2, 1, 3, 2}));
  const Run holds = run({"check", simplices, "--points", points});
  CHECK(holds.err.empty());
  CHECK(holds.out == "holds: delaunay " + simplices + " 4 points 2 triangles unique canonical\n");
  const std::string other =
      folder.write("other.npy", formats::npy<std::int64_t>("<i8", "(2, 3)", {0, 1, 3, 0, 3, 2}));
  const Run fails = run({"check", other, "--points", points});
  CHECK(fails.exit_code == 1);
  CHECK(fails.out.find("fails: delaunay " + other + " delaunay.facet-not-local 1 face 0 3") !=
        std::string::npos);
  CHECK(run({"check", simplices}).exit_code == 3);
}

}  // namespace circumspect::cli
