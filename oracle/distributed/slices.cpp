#include "oracle/distributed/slices.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <utility>
#include <variant>
#include <vector>

#include "oracle/distributed/shared_file.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/npy.hpp"
#include "oracle/formats/plain_files.hpp"

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
  // The error of load() for something that is not a file, or may not be read.
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
  return header->shape.empty() ? 0 : header->shape.front();
}

// How many rows of an array are read at a time, to be checked or stored.
constexpr std::size_t kRowsAtATime = std::size_t{1} << 14;

// Calls visit(rows) for the points of a slice of an array, batch after batch.
template <class Visit>
formats::Status for_some_points(const RandomAccess& file, const std::string& path, Slice slice,
                                const Visit& visit) {
  for (std::uint64_t first = slice.begin;; first += kRowsAtATime) {
    const std::uint64_t last = std::min(first + kRowsAtATime, slice.end);
    const auto rows = formats::read_rows_of_npy_points(file, path, {first, last});
    if (!rows) return tl::unexpected(rows.error());
    visit(*rows);
    if (last == slice.end) return {};
  }
}

// The points of the part, and facts about all points.
formats::Status read_points(const std::string& path, bool weighted, PartOf part, Dealt& dealt) {
  const auto file = opened(path);
  if (!file) return tl::unexpected(file.error());
  const auto take = [](const Rows<double>& rows, std::pmr::vector<double>& to) {
    to.insert(to.end(), rows.values().begin(), rows.values().end());
  };
  if (formats::extension(path) == ".npy") {
    const auto count = rows_of_npy(*file, path);
    if (!count) return tl::unexpected(count.error());
    dealt.points = *count;
    const Slice slice = part.slice(*count);
    const auto read = for_some_points(*file, path, slice, [&](const Rows<double>& rows) {
      dealt.dimension = rows.columns();
      dealt.coordinates.reserve(slice.size() * rows.columns());
      take(rows, dealt.coordinates);
    });
    if (!read) return read;
  } else if (formats::extension(path) == ".node") {
    const auto points = formats::read_plain_node(*file, {.threads = 1, .part = part});
    if (!points) return not_plain(path);
    dealt.points = points->in_file;
    dealt.first_index = points->first_index;
    dealt.dimension = points->coordinates.columns();
    take(points->coordinates, dealt.coordinates);
    if (weighted && points->weights.columns() == 0) {
      return fail(path, "a weight for each point (the first attribute of a .node file)", "none");
    }
    if (weighted) take(points->weights, dealt.weights);
  } else {
    return fail(path, "points in a .npy or a .node file", "another file");
  }
  if (weighted && formats::extension(path) == ".npy") {
    return fail(path, "a weight for each point (the first attribute of a .node file)", "none");
  }
  if (dealt.dimension != 2 && dealt.dimension != 3) {
    return fail(path, "points of dimension 2 or 3 (circumspect check judges those of others)",
                "dimension " + std::to_string(dealt.dimension));
  }
  return {};
}

// Rows of an array that has been checked, so that only a change of the file meanwhile can cause a
// fault. The file is not kept open, because there may be as many ranks as a process may have open
// files.
ListedRows rows_of_array(const std::string& path, Slice slice, std::size_t columns) {
  const auto read = [path, slice, columns](std::uint64_t first, std::span<std::int64_t> to) {
    const auto file = opened(path);
    if (!file) throw FileChanged(file.error().to_string());
    const std::uint64_t begin = slice.begin + first;
    const auto some =
        formats::read_rows_of_npy_simplices(*file, path, {begin, begin + to.size() / columns});
    if (!some) throw FileChanged(some.error().to_string());
    const std::size_t found = std::visit(
        [&](const auto& rows) {
          const std::size_t count = std::min(rows.values().size(), to.size());
          std::copy_n(rows.values().begin(), count, to.begin());
          return count;
        },
        *some);
    if (found != to.size())
      throw FileChanged(path + ": expected as many rows as before, found fewer");
  };
  return ListedRows(slice.size(), columns, read);
}

// The simplices of the part, as listed.
formats::Status read_simplices(const std::string& path, PartOf part, Dealt& dealt) {
  const auto file = opened(path);
  if (!file) return tl::unexpected(file.error());
  if (formats::extension(path) == ".npy") {
    const auto header = formats::read_npy_header(*file, path);
    if (!header) return tl::unexpected(header.error());
    const std::uint64_t count = header->shape.empty() ? 0 : header->shape.front();
    // All of it is read later, except indices that do not fit signed integers of 64 bits.
    const bool may_overflow = header->type.ends_with("u8");
    const Slice slice = part.slice(count);
    std::size_t columns = 0;
    for (std::uint64_t first = slice.begin;; first += kRowsAtATime) {
      const std::uint64_t last = std::min(first + (may_overflow ? kRowsAtATime : 0), slice.end);
      const auto rows = formats::read_rows_of_npy_simplices(*file, path, {first, last});
      if (!rows) return tl::unexpected(rows.error());
      columns = std::visit([](const auto& some) { return some.columns(); }, *rows);
      if (!may_overflow || last == slice.end) break;
    }
    dealt.simplices = count;
    dealt.lists = rows_of_array(path, slice, columns);
  } else if (formats::extension(path) == ".ele") {
    auto simplices = formats::read_plain_wide_ele(*file, 0, {.threads = 1, .part = part});
    if (!simplices) return not_plain(path);
    dealt.simplices = simplices->in_file;
    dealt.lists = ListedRows(std::move(simplices->rows));
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

// Is the mesh non-empty?
formats::Status check_not_empty(const std::string& path, const Dealt& dealt) {
  if (dealt.points > 0 || dealt.simplices > 0) return {};
  return fail(path, "a mesh", "neither points nor simplices");
}

// Does a simplex have as many vertices as the dimension requires?
formats::Status check_width(const std::string& path, const Dealt& dealt) {
  const std::size_t columns = dealt.lists.columns();
  if (columns == dealt.dimension + 1) return {};
  return fail(path,
              "simplices of " + std::to_string(dealt.dimension + 1) +
                  " vertices, one more than points have coordinates",
              std::to_string(columns) + " vertices");
}

// Are there files, as far as their names tell?
formats::Status check_names(const Files& files) {
  if (files.indices) {
    for (const std::string& name : {files.mesh, files.points.value_or(""), *files.indices}) {
      if (formats::extension(name) == ".npy" && name.find("%d") != name.npos) continue;
      return fail(name,
                  "mesh, points and indices in .npy files with %d in their names, as part-%d.npy",
                  "another name");
    }
    return {};
  }
  const std::string end = formats::extension(files.mesh);
  if (end != ".ele" && end != ".npy") {
    return fail(files.mesh, "a mesh in a .npy or an .ele file", "another file");
  }
  if (end == ".npy" && !files.points) {
    return fail(files.mesh, "--points FILE beside simplices in a .npy file", "none");
  }
  return {};
}

// The name of the file of a part.
std::string of_part(const std::string& pattern, std::size_t part) {
  const std::size_t place = pattern.find("%d");
  return pattern.substr(0, place) + std::to_string(part) + pattern.substr(place + 2);
}

// A part as it is read: simplices name the part's own points.
struct Part {
  std::size_t dimension;
  std::pmr::vector<double> points;
  std::vector<std::int64_t> indices;  // of the points in the whole
  std::vector<std::int64_t> vertices;
};

std::vector<std::int64_t> wide(const formats::NpySimplices& lists) {
  return std::visit(
      [](const auto& rows) {
        return std::vector<std::int64_t>(rows.values().begin(), rows.values().end());
      },
      lists);
}

Result<Part> read_part(const Files& files, PartOf part) {
  const std::string points = of_part(*files.points, part.part);
  const std::string indices = of_part(*files.indices, part.part);
  // Files of further parts would be ignored.
  if (formats::exists(of_part(files.mesh, part.parts))) {
    return fail(of_part(files.mesh, part.parts), "no more parts than ranks", "one more");
  }
  Dealt dealt;
  if (auto read = read_simplices(of_part(files.mesh, part.part), {}, dealt); !read) {
    return tl::unexpected(read.error());
  }
  if (auto read = read_points(points, false, {}, dealt); !read) {
    return tl::unexpected(read.error());
  }
  if (auto fits = check_width(of_part(files.mesh, part.part), dealt); !fits) {
    return tl::unexpected(fits.error());
  }
  const auto file = opened(indices);
  if (!file) return tl::unexpected(file.error());
  const auto listed = formats::read_npy_indices(*file, indices);
  if (!listed) return tl::unexpected(listed.error());
  Part own{dealt.dimension, std::move(dealt.coordinates), wide(*listed), {}};
  if (own.indices.size() != dealt.points) {
    return fail(indices, std::to_string(dealt.points) + " indices, one a point of " + points,
                std::to_string(own.indices.size()));
  }
  constexpr std::int64_t kMost = std::int64_t{1} << 60;
  for (const std::int64_t v : own.indices) {
    if (v < 0 || v >= kMost) return fail(indices, "indices from 0 to 2^60 - 1", std::to_string(v));
  }
  own.vertices.resize(dealt.lists.size() * dealt.lists.columns());
  if (!own.vertices.empty()) dealt.lists.read(0, own.vertices);
  for (std::int64_t& v : own.vertices) {
    if (v < 0 || static_cast<std::size_t>(v) >= own.indices.size()) {
      return fail(of_part(files.mesh, part.part),
                  "vertices from 0 to " + std::to_string(own.indices.size()) + " - 1",
                  std::to_string(v));
    }
    v = own.indices[static_cast<std::size_t>(v)];
  }
  return own;
}

// Sends the points of all parts to their owners; several parts may have the same point.
formats::Status deal_points(Ranks& ranks, const Part& part, const std::string& name, Dealt& dealt) {
  struct Sent {
    std::uint64_t index;
    std::array<double, 3> at;
  };
  std::uint64_t most = 0;
  for (const std::int64_t v : part.indices) {
    most = std::max(most, static_cast<std::uint64_t>(v) + 1);
  }
  dealt.points = ranks.most(most);
  const Slice slice = PartOf{ranks.rank(), ranks.size()}.slice(dealt.points);
  // There cannot be more points than all parts have together; this is checked before memory is
  // allocated for them.
  if (dealt.points > ranks.sum(part.indices.size())) {
    return fail(name, "all indices from 0 to the largest, " + std::to_string(dealt.points - 1),
                "fewer points in all parts");
  }
  dealt.coordinates.resize(slice.size() * dealt.dimension);
  std::vector<bool> is_there(slice.size(), false);
  std::optional<std::uint64_t> differs;
  const std::size_t some = ranks.some(sizeof(Sent));
  const std::uint64_t rounds = ranks.most((part.indices.size() + some - 1) / some);
  for (std::size_t round = 0; round < rounds; ++round) {
    std::vector<std::vector<Sent>> out(ranks.size());
    const std::size_t last = std::min(part.indices.size(), (round + 1) * some);
    for (std::size_t i = round * some; i < last; ++i) {
      Sent one{static_cast<std::uint64_t>(part.indices[i]), {}};
      std::copy_n(part.points.data() + i * dealt.dimension, dealt.dimension, one.at.begin());
      out[PartOf::with(one.index, dealt.points, ranks.size())].push_back(one);
    }
    for (const Sent& one : ranks.exchanged(std::move(out))) {
      const auto row = std::span(dealt.coordinates)
                           .subspan((one.index - slice.begin) * dealt.dimension, dealt.dimension);
      if (is_there[one.index - slice.begin]) {
        if (!std::equal(row.begin(), row.end(), one.at.begin())) differs = one.index;
      } else {
        std::copy_n(one.at.begin(), dealt.dimension, row.begin());
        is_there[one.index - slice.begin] = true;
      }
    }
  }
  if (differs) {
    return fail(name, "the same coordinates of a point in all parts",
                "others for the point of index " + std::to_string(*differs));
  }
  const auto missing = std::find(is_there.begin(), is_there.end(), false);
  if (missing != is_there.end()) {
    const auto index = slice.begin + static_cast<std::uint64_t>(missing - is_there.begin());
    return fail(name, "all indices from 0 to the largest, " + std::to_string(dealt.points - 1),
                "no point of index " + std::to_string(index));
  }
  return {};
}

// `settled` combines the faults of all ranks into one, as in read_slices.
template <class Settled>
std::string read_all_parts(Ranks& ranks, const Files& files, const Settled& settled, Dealt& dealt) {
  if (files.weighted) return files.mesh + ": expected no claim about weights of parts, found one";
  auto part = read_part(files, {ranks.rank(), ranks.size()});
  std::string fault =
      settled(part ? formats::Status() : formats::Status(tl::unexpected(part.error())));
  if (!fault.empty()) return fault;
  dealt.dimension = part->dimension;
  if (ranks.most(dealt.dimension) != ranks.least(dealt.dimension)) {
    return *files.points + ": expected points of one dimension in all parts, found several";
  }
  fault = settled(deal_points(ranks, *part, *files.indices, dealt));
  Rows<std::int64_t> rows(part->vertices.size() / (dealt.dimension + 1), dealt.dimension + 1);
  std::copy(part->vertices.begin(), part->vertices.end(), rows.values().begin());
  const std::vector<std::uint64_t> sizes = ranks.of_each(std::uint64_t{rows.rows()});
  dealt.simplices = std::accumulate(sizes.begin(), sizes.end(), std::uint64_t{0});
  dealt.first_simplex = std::accumulate(
      sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(ranks.rank()), std::uint64_t{0});
  dealt.lists = std::move(rows);
  return fault;
}

}  // namespace

tl::expected<ReadSlices, std::string> read_slices(Ranks& ranks, const Files& files) {
  const PartOf part{ranks.rank(), ranks.size()};
  ReadSlices read;
  read.points_name =
      files.points ? *files.points : files.mesh.substr(0, files.mesh.find_last_of('.')) + ".node";
  // In the order in which one process finds faults of files; if several ranks find one, the first
  // of them reports it.
  const auto settled = [&](const formats::Status& own) -> std::string {
    const std::size_t failed = ranks.first_with(!own);
    if (failed == ranks.size()) return "";
    return ranks.of_rank(failed, own ? std::string() : own.error().to_string());
  };
  std::string fault = settled(check_names(files));
  if (fault.empty() && files.indices) {
    fault = read_all_parts(ranks, files, settled, read.dealt);
  } else if (fault.empty()) {
    const auto shared = [&](const std::string& path, std::uint64_t rows, std::size_t columns) {
      return settled(check_shared(ranks, path, {rows, columns, read.dealt.first_index}));
    };
    fault = settled(read_simplices(files.mesh, part, read.dealt));
    if (fault.empty()) {
      fault = shared(files.mesh, read.dealt.simplices, read.dealt.lists.columns());
    }
    if (fault.empty()) {
      fault = settled(read_points(read.points_name, files.weighted, part, read.dealt));
    }
    if (fault.empty()) fault = shared(read.points_name, read.dealt.points, read.dealt.dimension);
    if (fault.empty()) fault = settled(check_width(files.mesh, read.dealt));
  }
  if (fault.empty()) fault = settled(check_not_empty(files.mesh, read.dealt));
  ranks.end_phase("reading");
  if (!fault.empty()) return tl::unexpected(std::move(fault));
  return read;
}

}  // namespace circumspect::distributed
