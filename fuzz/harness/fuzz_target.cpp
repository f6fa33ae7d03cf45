#include <algorithm>
#include <cstdlib>

#include <circumspect/fuzz.hpp>
#include <fmt/format.h>

#include "fuzz/harness/answer.hpp"
#include "fuzz/harness/node_text.hpp"
#include "inputs/arrays.hpp"
#include "oracle/report/wording.hpp"
#include "reference/kernel/exact/point.hpp"

namespace circumspect {

namespace {

bool is_wanted(const FuzzOptions& options, const PointArray& points) {
  if (points.size() < std::max<std::size_t>(options.min_points, 1)) return false;
  return options.flat_sets || affine_hull(generators::from(points).points).dimension ==
                                  static_cast<int>(options.dimension);
}

}  // namespace

int fuzz_once(const Triangulator& subject, const FuzzOptions& options, const std::uint8_t* data,
              std::size_t size) {
  const bool weighted = options.claim == "weighted-delaunay";
  const PointArray points = points_from_bytes(data, size, options.dimension, weighted);
  if (!is_wanted(options, points)) return 0;
  const harness::Answer given = harness::answer(subject, points);
  Judgement judgement{false, given.failure, "the program threw: " + given.text + "\n"};
  if (given.failure.empty()) judgement = judge(options.claim, points, given.simplices);
  if (judgement.holds) return 0;
  fmt::print(stderr, "{}: {} on {}\n{}{}", options.claim, judgement.rule,
             report::counted(points.size(), "point"), harness::node_text(points), judgement.report);
  std::abort();
}

}  // namespace circumspect
