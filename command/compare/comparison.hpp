// What compare finds, as text and as JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "command/input/input.hpp"
#include "oracle/judge/mesh_difference.hpp"
#include "oracle/report/json.hpp"

namespace circumspect::cli {

// A point or a simplex that the other mesh lacks, by the user's own indices.
struct NamedPoint {
  Vertex label;
  Point coordinates;
  std::optional<Rational> weight;
};

// What one of the two meshes has and the other has not.
struct Side {
  const std::string& name;
  std::size_t point_count = 0;
  std::size_t simplex_count = 0;
  std::size_t repeated_count = 0;       // simplices that the other lists less often
  std::vector<NamedPoint> points = {};  // those that are shown
  std::vector<Simplex> simplices = {};
  std::vector<Simplex> repeated = {};
};

struct Comparison {
  std::size_t points_of_a = 0;
  std::size_t simplices_of_a = 0;
  bool weighted = false;
  Side only_in_a;
  Side only_in_b;

  bool is_same() const {
    const auto is_empty = [](const Side& side) {
      return side.point_count + side.simplex_count + side.repeated_count == 0;
    };
    return is_empty(only_in_a) && is_empty(only_in_b);
  }
};

// At most `most` of each kind are shown; 0: all.
Comparison compared(const LoadedMesh& a, const LoadedMesh& b, const check::Difference& found,
                    std::size_t most);

// The names of the two files.
struct ComparedFiles {
  const std::string& a;
  const std::string& b;
};

// For people, a line for each thing that only one of them has, and the last line, which sums them
// up; for programs, all of it as one document.
std::string text_of(const Comparison& comparison);
std::string line_of(const ComparedFiles& files, const Comparison& comparison);
report::Json json_of(const ComparedFiles& files, const Comparison& comparison,
                     const std::vector<std::string>& notes);

}  // namespace circumspect::cli
