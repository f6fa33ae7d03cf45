#include "oracle/distributed/slices.hpp"

#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/npy.hpp"
#include "oracle/formats/plain_files.hpp"
#include "oracle/formats/source.hpp"

namespace circumspect::distributed {
namespace {

using formats::FormatError;
using formats::PlainReading;
using formats::RandomAccess;
using formats::Result;

tl::unexpected<FormatError> fail(const std::string& file, std::string expected, std::string found) {
  return tl::unexpected(FormatError{file, 0, std::move(expected), std::move(found)});
}

Result<RandomAccess> opened(const std::string& path) {
  auto file = RandomAccess::open(path);
  if (file) return std::move(*file);
  // What load() says of what is no file, or may not be read.
  if (const auto source = formats::load(path); !source) return tl::unexpected(source.error());
  return fail(path, "a file that each rank can read a part of", "a pipe");
}

tl::unexpected<FormatError> not_plain(const std::string& path) {
  return fail(path, "numbered rows as TetGen and Triangle write them",
              "something else; circumspect check reads it, or says what is wrong with it");
}

Result<std::uint64_t> rows_of_npy(const RandomAccess& file, const std::string& path) {
  const auto header = formats::read_npy_header(file, path);
  if (!header) return tl::unexpected(header.error());
  return header->shape.front();
}

// The points of the part, and what is known of all.
formats::Status read_points(const std::string& path, bool weighted, PartOf part, Dealt& dealt) {
  const auto file = opened(path);
  if (!file) return tl::unexpected(file.error());
  if (formats::extension(path) == ".npy") {
    auto rows = formats::read_rows_of_npy_points(*file, path, part);
    if (!rows) return tl::unexpected(rows.error());
    const auto count = rows_of_npy(*file, path);
    if (!count) return tl::unexpected(count.error());
    dealt.points = *count;
    dealt.coordinates = std::move(*rows);
  } else if (formats::extension(path) == ".node") {
    auto points = formats::read_plain_node(*file, {.threads = 1, .part = part});
    if (!points) return not_plain(path);
    dealt.points = points->in_file;
    dealt.first_index = points->first_index;
    dealt.coordinates = std::move(points->coordinates);
    if (weighted) dealt.weights = std::move(points->weights);
  } else {
    return fail(path, "points in a .npy or a .node file", "another file");
  }
  dealt.dimension = dealt.coordinates.columns();
  const bool has_weights = dealt.weights.columns() > 0;
  if (weighted && !has_weights) {
    return fail(path, "a weight for each point (the first attribute of a .node file)", "none");
  }
  if (dealt.dimension != 2 && dealt.dimension != 3) {
    return fail(path, "points of dimension 2 or 3 (circumspect check judges those of others)",
                "dimension " + std::to_string(dealt.dimension));
  }
  return {};
}

// The simplices of the part, as they are listed.
formats::Status read_simplices(const std::string& path, PartOf part, Dealt& dealt) {
  const auto file = opened(path);
  if (!file) return tl::unexpected(file.error());
  if (formats::extension(path) == ".npy") {
    auto rows = formats::read_rows_of_npy_simplices(*file, path, part);
    if (!rows) return tl::unexpected(rows.error());
    const auto count = rows_of_npy(*file, path);
    if (!count) return tl::unexpected(count.error());
    dealt.simplices = *count;
    std::visit([&dealt](auto& lists) { dealt.lists = std::move(lists); }, *rows);
  } else if (formats::extension(path) == ".ele") {
    auto simplices = formats::read_plain_wide_ele(*file, 0, {.threads = 1, .part = part});
    if (!simplices) return not_plain(path);
    dealt.simplices = simplices->in_file;
    dealt.lists = std::move(simplices->rows);
  } else {
    return fail(path, "simplices in a .npy or an .ele file", "another file");
  }
  dealt.first_simplex = part.slice(dealt.simplices).begin;
  const std::size_t most = LocalMesh<3>::kMostSimplices;
  if (part.slice(dealt.simplices).size() > most) {
    return fail(path, "at most " + std::to_string(most) + " simplices a rank",
                std::to_string(dealt.simplices) + " in all; start more ranks");
  }
  return {};
}

// Is it a mesh, with as many vertices a simplex as the dimension wants?
formats::Status check_shape(const std::string& path, const Dealt& dealt) {
  if (dealt.points == 0 && dealt.simplices == 0) {
    return fail(path, "a mesh", "neither points nor simplices");
  }
  const std::size_t columns = dealt.lists.visit([]<class Lists>(const Lists& lists) {
    if constexpr (std::is_same_v<Lists, std::vector<Simplex>>)
      return std::size_t{0};
    else
      return lists.columns();
  });
  if (columns == dealt.dimension + 1) return {};
  return fail(path,
              "simplices of " + std::to_string(dealt.dimension + 1) +
                  " vertices, one more than points have coordinates",
              std::to_string(columns) + " vertices");
}

// Are there files, as far as their names tell?
formats::Status check_names(const Files& files) {
  const std::string end = formats::extension(files.mesh);
  if (end != ".ele" && end != ".npy") {
    return fail(files.mesh, "a mesh in a .npy or an .ele file", "another file");
  }
  if (end == ".npy" && !files.points) {
    return fail(files.mesh, "--points FILE beside simplices in a .npy file", "none");
  }
  return {};
}

}  // namespace

tl::expected<ReadSlices, std::string> read_slices(Ranks& ranks, const Files& files) {
  const PartOf part{ranks.rank(), ranks.size()};
  ReadSlices read;
  read.points_name =
      files.points ? *files.points : files.mesh.substr(0, files.mesh.find_last_of('.')) + ".node";
  // In the order in which one process finds what is wrong with files; of several ranks the first one says it.
  const auto settled = [&](const formats::Status& own) -> std::string {
    const std::size_t failed = ranks.first_with(!own);
    if (failed == ranks.size()) return "";
    return ranks.of_rank(failed, own ? std::string() : own.error().to_string());
  };
  std::string fault = settled(check_names(files));
  if (fault.empty()) fault = settled(read_simplices(files.mesh, part, read.dealt));
  if (fault.empty()) {
    fault = settled(read_points(read.points_name, files.weighted, part, read.dealt));
  }
  if (fault.empty()) fault = settled(check_shape(files.mesh, read.dealt));
  ranks.end_phase("reading");
  if (!fault.empty()) return tl::unexpected(std::move(fault));
  return read;
}

}  // namespace circumspect::distributed
