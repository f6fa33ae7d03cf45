// Tests a structure that changes step by step, by insertions and deletions, after each step; a
// failing sequence is made as short as possible.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <circumspect/judgement.hpp>
#include <circumspect/subject.hpp>

namespace circumspect {

// A structure under test. Points keep the number with which they were inserted: 0, 1, 2, … in the
// order of insertion, never used again. Any exception is a finding.
class DynamicTriangulation {
 public:
  virtual ~DynamicTriangulation() = default;
  virtual void insert(const double* point) = 0;  // `dimension` doubles; never equal to one present
  virtual void remove(std::int64_t number) = 0;  // the point is present
  virtual SimplexArray simplices() const = 0;    // by those numbers
};

struct SequenceOptions {
  std::string claim = "delaunay";  // or "triangulation"
  std::size_t dimension = 3;
  std::size_t max_steps = 40;
  std::size_t cases = 300;
  std::uint64_t seed = 20260101;
  std::vector<std::string> families = {};  // of points; none: as PropertyOptions::families
  bool removes = true;                     // false: insertions only
};

struct Step {
  bool is_removal = false;
  std::int64_t number = 0;         // of the point inserted or removed
  std::vector<double> point = {};  // if it is inserted
};

struct SequenceFinding {
  std::vector<Step> steps;  // the shortest found; the last one breaks the rule
  std::string rule;
  std::string report;  // for people: the steps, and the witness
};

// The first sequence after which a fresh structure is wrong, made shorter; nothing if there is
// none. Every machine tries the same sequences. Throws std::invalid_argument: a claim other than
// "delaunay" and "triangulation"; a family that is unknown or does not exist in the dimension.
std::optional<SequenceFinding> find_wrong_sequence(
    const std::function<std::unique_ptr<DynamicTriangulation>()>& make,
    const SequenceOptions& options = {});

}  // namespace circumspect
