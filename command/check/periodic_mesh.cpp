#include "command/check/periodic_mesh.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/options/number_list.hpp"
#include "command/options/option_rows.hpp"
#include "oracle/formats/format.hpp"
#include "oracle/formats/tetgen.hpp"
#include "oracle/judge/periodic/unfolded.hpp"

namespace circumspect::cli {
namespace {

// The vectors have as many numbers as points have coordinates; what is left makes one that is too
// short, for the fault to be found.
std::vector<Point> vectors_of(const std::vector<Rational>& numbers, std::size_t d) {
  std::vector<Point> vectors;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i % d == 0) vectors.emplace_back();
    vectors.back().push_back(numbers[i]);
  }
  return vectors;
}

std::vector<Point> edges_of(const JudgedBox& box) {
  const Point edges = box.high - box.low;
  std::vector<Point> vectors(edges.size(), Point(edges.size(), 0));
  for (std::size_t axis = 0; axis < edges.size(); ++axis) vectors[axis][axis] = edges[axis];
  return vectors;
}

}  // namespace

void add_lattice_option(CLI::App& command, LatticeOption& lattice) {
  const auto read = [&lattice](const std::string& text) {
    if (auto numbers = number_list(text)) {
      lattice.numbers = std::move(*numbers);
      return std::string();
    }
    return fmt::format("expected numbers with commas between them, found {}", text);
  };
  add_options(
      command,
      {{"--lattice", "X1,Y1,X2,Y2", read_by(read),
        "With the claim periodic-delaunay: the vectors along which the mesh repeats, one after the "
        "other (three of three numbers in space). The attributes of the .ele file are the offset "
        "of each corner in these vectors, which are integers. A mesh that repeats along the axes "
        "may have its --box instead"}});
}

std::string unfold(LoadedMesh& loaded, const LatticeOption& lattice,
                   const std::optional<JudgedBox>& box) {
  if (formats::extension(loaded.name) != ".ele") {
    return fmt::format(
        "{}: expected an .ele file, whose attributes are the offset of each corner of each cell",
        loaded.name);
  }
  const auto source = formats::load(loaded.name);
  if (!source) return source.error().to_string();
  const std::size_t d = loaded.mesh.dimension();
  auto offsets = formats::read_ele_offsets(*source, d);
  if (!offsets) return offsets.error().to_string();
  const Periodic periodic{lattice.is_given() ? vectors_of(lattice.numbers, d) : edges_of(*box),
                          std::move(*offsets)};
  const std::string fault = check::fault_of_periodic(loaded.mesh, periodic);
  if (!fault.empty()) return loaded.name + ": " + fault;
  loaded.mesh = check::unfolded(loaded.mesh, periodic);
  return "";
}

}  // namespace circumspect::cli
