// Ranks that read a mesh from files have together what was written, whether it is in two files or
// each rank has files of its own; with one slip in a file they say which file, and what is wrong.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "inputs/dice.hpp"
#include "inputs/scratch_folder_test.hpp"
#include "oracle/distributed/slices.hpp"
#include "oracle/distributed/turns.hpp"

namespace circumspect::properties {
namespace {

using generators::Dice;

template <class Value>
void write_npy(const std::string& path, const std::string& type, const std::vector<Value>& values,
               std::size_t columns) {
  const std::string rows = std::to_string(values.size() / std::max<std::size_t>(1, columns));
  const std::string second = columns == 0 ? "" : " " + std::to_string(columns);
  std::string header = "{'descr': '" + type + "', 'fortran_order': False, 'shape': (" +
                       (columns == 0 ? std::to_string(values.size()) : rows) + "," + second +
                       "), }";
  header.resize(117, ' ');
  header += '\n';
  std::ofstream file(path, std::ios::binary);
  file << std::string("\x93NUMPY\x01\x00\x76\x00", 10) << header;
  file.write(reinterpret_cast<const char*>(values.data()),
             static_cast<std::streamsize>(values.size() * sizeof(Value)));
}

struct Part {
  std::vector<double> points = {};
  std::vector<std::int64_t> indices = {}, simplices = {};  // the latter by the part's own points
};

// Any simplices of any points: reading asks nothing else of them.
struct Whole {
  std::size_t dimension, count;
  std::vector<double> points = {};
  std::vector<std::int64_t> simplices = {};

  explicit Whole(Dice& dice) : dimension(2 + dice.below(2)), count(dimension + 1 + dice.below(30)) {
    for (std::size_t i = 0; i < count * dimension; ++i) {
      points.push_back(static_cast<double>(dice.within(-99L, 99L)) / 4);
    }
    for (std::size_t rows = 1 + dice.below(40), i = 0; i < rows * (dimension + 1); ++i) {
      simplices.push_back(static_cast<std::int64_t>(dice.below(count)));
    }
  }

  std::vector<Part> in_parts(Dice& dice, std::size_t parts) const {
    std::vector<Part> all(parts);
    std::vector<std::vector<std::int64_t>> place(parts, std::vector<std::int64_t>(count, -1));
    const auto own = [&](std::size_t part, std::int64_t v) {
      std::int64_t& at = place[part][static_cast<std::size_t>(v)];
      if (at >= 0) return at;
      const auto from = points.begin() + v * static_cast<std::int64_t>(dimension);
      all[part].points.insert(all[part].points.end(), from,
                              from + static_cast<std::int64_t>(dimension));
      all[part].indices.push_back(v);
      return at = std::ssize(all[part].indices) - 1;
    };
    for (std::size_t i = 0, part = 0; i < simplices.size(); ++i) {
      if (i % (dimension + 1) == 0) part = i * parts / simplices.size();
      all[part].simplices.push_back(own(part, simplices[i]));
    }
    for (std::size_t v = 0; v < count; ++v) {
      own(dice.below(parts), static_cast<std::int64_t>(v));
    }
    return all;
  }
};

struct Read {
  std::set<std::string> faults = {};
  std::vector<double> points = {};
  std::vector<std::int64_t> simplices = {};
  bool numbers_agree = true;  // those that a rank has of the whole
};

Read read_in_turns(const distributed::Files& files, std::size_t parts, const Whole& whole) {
  Read all;
  std::vector<std::vector<double>> points(parts);
  std::vector<std::vector<std::int64_t>> simplices(parts);
  std::vector<std::uint64_t> first(parts, 0);
  const std::size_t columns = whole.dimension + 1;
  distributed::in_turns(
      {.parts = parts, .room = 2000, .folder = "/tmp", .few = 5}, [&](distributed::Ranks& ranks) {
        const auto read = read_slices(ranks, files);
        if (!read) {
          all.faults.insert(read.error());
          return;
        }
        const distributed::Dealt& dealt = read->dealt;
        const std::size_t rank = ranks.rank();
        points[rank].assign(dealt.coordinates.begin(), dealt.coordinates.end());
        simplices[rank].resize(dealt.lists.size() * dealt.lists.columns());
        if (!simplices[rank].empty()) dealt.lists.read(0, simplices[rank]);
        first[rank] = dealt.first_simplex;
        all.numbers_agree &= dealt.points == whole.count && dealt.dimension == whole.dimension &&
                             dealt.simplices == whole.simplices.size() / columns;
      });
  for (std::size_t rank = 0; rank < parts && all.faults.empty(); ++rank) {
    all.numbers_agree &= first[rank] == all.simplices.size() / columns;
    all.points.insert(all.points.end(), points[rank].begin(), points[rank].end());
    all.simplices.insert(all.simplices.end(), simplices[rank].begin(), simplices[rank].end());
  }
  return all;
}

void check_read(const distributed::Files& files, std::size_t parts, const Whole& whole) {
  const Read read = read_in_turns(files, parts, whole);
  CHECK(read.faults.empty());
  CHECK(read.numbers_agree);
  CHECK(read.points == whole.points);
  CHECK(read.simplices == whole.simplices);
}

class SlicesInFolder {
 public:
  distributed::Files files() const {
    return {
        .mesh = in("mesh-%d.npy"), .points = in("points-%d.npy"), .indices = in("indices-%d.npy")};
  }
  std::string in(const std::string& name) const { return folder_.path(name); }

  void write(const std::vector<Part>& parts, std::size_t dimension) const {
    for (std::size_t i = 0; i < parts.size(); ++i) write(i, parts[i], dimension, dimension + 1);
  }
  void write(std::size_t i, const Part& part, std::size_t dimension, std::size_t columns) const {
    const std::string end = "-" + std::to_string(i) + ".npy";
    write_npy(in("mesh" + end), "<i8", part.simplices, columns);
    write_npy(in("points" + end), "<f8", part.points, dimension);
    write_npy(in("indices" + end), "<i8", part.indices, 0);
  }

 private:
  formats::ScratchFolder folder_ = {};
};

TEST_CASE("slices: ranks read what was written, in two files or in some for each of them") {
  const SlicesInFolder folder;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    CAPTURE(seed);
    Dice dice(seed);
    const Whole whole(dice);
    const std::size_t parts = 1 + dice.below(4), columns = whole.dimension + 1;
    std::vector<Part> dealt = whole.in_parts(dice, parts);
    folder.write(dealt, whole.dimension);
    check_read(folder.files(), parts, whole);
    for (std::size_t i = 0; i < parts; ++i)
      std::filesystem::remove(folder.in("mesh-" + std::to_string(i) + ".npy"));
    write_npy(folder.in("points.npy"), "<f8", whole.points, whole.dimension);
    for (const std::string type : {"<i8", "<u8"}) {
      write_npy(folder.in("mesh.npy"), type, whole.simplices, columns);
      check_read({.mesh = folder.in("mesh.npy"), .points = folder.in("points.npy")}, parts, whole);
    }
    std::ofstream node(folder.in("mesh.node")), ele(folder.in("mesh.ele"));
    node << whole.count << " " << whole.dimension << " 0 0\n";
    for (std::size_t v = 0; v < whole.count; ++v) {
      node << v;
      for (std::size_t k = 0; k < whole.dimension; ++k)
        node << " " << whole.points[v * whole.dimension + k];
      node << "\n";
    }
    ele << whole.simplices.size() / columns << " " << columns << " 0\n";
    for (std::size_t i = 0; i < whole.simplices.size(); ++i) {
      if (i % columns == 0) ele << i / columns;
      ele << " " << whole.simplices[i] << ((i + 1) % columns == 0 ? "\n" : "");
    }
    node.close();
    ele.close();
    check_read({.mesh = folder.in("mesh.ele")}, parts, whole);
    const Read weighted =
        read_in_turns({.mesh = folder.in("mesh.ele"), .weighted = true}, parts, whole);
    REQUIRE(weighted.faults.size() == 1);
    CHECK(weighted.faults.begin()->find("mesh.node: expected a weight for each point") !=
          std::string::npos);
  }
}

// What all ranks say of the files of three parts once there is a slip in those of the second.
class OneSlip {
 public:
  OneSlip() : OneSlip(Dice(1)) {}

  std::size_t dimension() const { return whole_.dimension; }
  std::int64_t count() const { return static_cast<std::int64_t>(whole_.count); }
  std::size_t own_points() const { return second().indices.size(); }

  template <class Slip>
  std::string said(const Slip& slip) const {
    const SlicesInFolder folder;
    Dice dice(2);
    folder.write(whole_.in_parts(dice, kParts), whole_.dimension);
    slip(folder, second());
    const Read read = read_in_turns(folder.files(), kParts, whole_);
    return read.faults.size() == 1 ? *read.faults.begin() : "no error, or several";
  }
  template <class Change>
  std::string changed(const Change& change) const {
    return said([&](const SlicesInFolder& folder, Part part) {
      change(part);
      folder.write(1, part, whole_.dimension, whole_.dimension + 1);
    });
  }
  // With one point more.
  std::string with_point(std::int64_t index, double coordinate) const {
    return changed([&](Part& part) {
      part.points.insert(part.points.end(), whole_.dimension, coordinate);
      part.indices.push_back(index);
    });
  }

 private:
  static constexpr std::size_t kParts = 3;

  explicit OneSlip(Dice dice) : whole_(dice) {}
  Part second() const {
    Dice dice(2);
    return whole_.in_parts(dice, kParts)[1];
  }

  Whole whole_;
};

void has(const std::string& text, const std::string& file, const std::string& words) {
  CAPTURE(text);
  CHECK(text.find(file + ": expected " + words) != std::string::npos);
}

TEST_CASE("slices: a wrong index in a part is an error that says which") {
  const OneSlip one;
  for (const bool is_last : {false, true}) {
    has(one.changed(
            [&](Part& part) { part.simplices[1] = is_last ? std::ssize(part.indices) : -1; }),
        "mesh-1.npy", "vertices from 0 to ");
    has(one.changed([&](Part& part) { part.indices[1] = is_last ? std::int64_t{1} << 60 : -1; }),
        "indices-1.npy", "indices from 0 to 2^60 - 1, found ");
  }
  has(one.changed([](Part& part) { part.indices.pop_back(); }), "indices-1.npy",
      std::to_string(one.own_points()) + " indices, one a point of ");
  has(one.with_point(0, 0.125), "indices-%d.npy",
      "the same coordinates of a point in all parts, found others for the point of index 0");
  const std::string all = "all indices from 0 to the largest, ";
  has(one.with_point(one.count() + 1, 1), "indices-%d.npy",
      all + std::to_string(one.count() + 1) + ", found no point of index " +
          std::to_string(one.count()));
  has(one.with_point(std::int64_t{1} << 59, 1), "indices-%d.npy",
      all + std::to_string(std::int64_t{1} << 59) + ", found fewer points");
}

TEST_CASE("slices: a file of other columns, and one too many, are errors") {
  const OneSlip one;
  const std::size_t d = one.dimension(), other = 5 - d;
  const auto with_columns = [&](std::size_t of_points, std::size_t of_simplices) {
    return one.said([&](const SlicesInFolder& folder, Part part) {
      part.points.resize(part.indices.size() * of_points);
      part.simplices.resize(of_simplices * (part.simplices.size() / of_simplices));
      folder.write(1, part, of_points, of_simplices);
    });
  };
  has(with_columns(d, d), "mesh-1.npy", "simplices of " + std::to_string(d + 1) + " vertices");
  has(with_columns(4, 5), "points-1.npy", "points of dimension 2 or 3");
  has(with_columns(other, other + 1), "points-%d.npy",
      "points of one dimension in all parts, found several");
  has(one.said([&](const SlicesInFolder& folder, const Part& part) {
    write_npy(folder.in("mesh-3.npy"), "<i8", part.simplices, d + 1);
  }),
      "mesh-3.npy", "no more parts than ranks, found one more");
}

TEST_CASE("slices: files without points and simplices hold no mesh, in one file or in parts") {
  Dice dice(1);
  Whole nothing(dice);
  nothing.count = 0;
  nothing.points.clear();
  nothing.simplices.clear();
  const SlicesInFolder folder;
  folder.write(nothing.in_parts(dice, 2), nothing.dimension);
  write_npy(folder.in("mesh.npy"), "<i8", nothing.simplices, nothing.dimension + 1);
  write_npy(folder.in("points.npy"), "<f8", nothing.points, nothing.dimension);
  const distributed::Files whole = {.mesh = folder.in("mesh.npy"),
                                    .points = folder.in("points.npy")};
  for (const distributed::Files& files : {folder.files(), whole}) {
    const Read read = read_in_turns(files, 2, nothing);
    REQUIRE(read.faults.size() == 1);
    has(*read.faults.begin(), files.mesh.substr(files.mesh.rfind('/') + 1),
        "a mesh, found neither points nor simplices");
  }
}

}  // namespace
}  // namespace circumspect::properties
