// `inspect` of a point set: dimension, duplicates, genericity with a witness, counts. Book: Section 4.1.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "command/input/input.hpp"
#include "command/output/output.hpp"
#include "kernel/complex/triangulation.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/picture/page.hpp"
#include "oracle/report/json.hpp"

namespace circumspect::cli {

struct PointsInspection {
  std::size_t subsets = 200'000;            // so many are looked at for genericity; 0: all
  std::vector<std::string> simplices = {};  // "1 2 3", by the user's indices
};

// The facts that --only may name.
std::vector<std::string> point_facts();

// `only`: some of the facts; none means all. Requires: point_facts() has them. What is found is added to `page`, if
// there is one.
void inspect_points(const std::string& path, const InputOptions& input,
                    const PointsInspection& options, const std::vector<std::string>& only,
                    Output& output, picture::Page* page);

// ---- One simplex ----
// What `inspect` says of a set of points: of one simplex, and of how many there are. Book: Section 4.2.

struct SimplexAnswer {
  std::string text;  // one line
  report::Json json;
};

// `vertices` are the user's own indices, separated by blanks or commas. Returns the answer with a
// ball that shows it or the points that forbid it; or one line that says what is wrong with the
// question: an index that names no point, a vertex twice, vertices that are affinely dependent.
// `repeated`: the points that were merged into equal ones, by places in the file; they name these.
tl::expected<SimplexAnswer, std::string> inspect_simplex(const ExactMesh& mesh,
                                                         const std::vector<Duplicate>& repeated,
                                                         const std::string& vertices);

// ---- Counts ----
// How many simplices the canonical Delaunay triangulation has, and how many it could have.
// Book: Section 4.1 ("a triangulation of n vertices in R³ has at most …").

struct SimplexCount {
  int dimension;
  std::size_t count;
  // What no triangulation of as many points exceeds; known for three-dimensional sets.
  std::optional<std::size_t> bound;
};

// One entry for each dimension from 1 to that of the triangulation of `points` points; of simplices that have
// too many faces to list them (20,000,000, in high dimensions) only that of the last.
std::vector<SimplexCount> simplex_counts(const Triangulation& triangulation, std::size_t points);

}  // namespace circumspect::cli
