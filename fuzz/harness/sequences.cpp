#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include <circumspect/sequences.hpp>
#include <fmt/format.h>

#include "fuzz/harness/cases.hpp"
#include "oracle/judge/arrays/mesh_of.hpp"
#include "oracle/report/text.hpp"

namespace circumspect {
namespace {

using Make = std::function<std::unique_ptr<DynamicTriangulation>()>;
using Steps = std::vector<Step>;

// Where a sequence first goes wrong.
struct Failure {
  std::size_t steps = 0;  // the number of steps done, it being the last
  std::string rule = {};
  std::string report = {};
};

// The points that are present, in the order of their numbers.
struct Present {
  PointArray points = {};
  std::vector<std::int64_t> numbers = {};
};

Present present_after(const Steps& steps, std::size_t count, std::size_t dimension) {
  std::map<std::int64_t, const Step*> insertions;
  for (std::size_t i = 0; i < count; ++i) {
    if (steps[i].is_removal) {
      insertions.erase(steps[i].number);
    } else {
      insertions[steps[i].number] = &steps[i];
    }
  }
  Present present;
  present.points.dimension = dimension;
  for (const auto& [number, step] : insertions) {
    present.numbers.push_back(number);
    auto& coordinates = present.points.coordinates;
    coordinates.insert(coordinates.end(), step->point.begin(), step->point.end());
  }
  return present;
}

// The simplices with the judge's indices, which are places among the present points. An index that
// names no present point names none there.
SimplexArray in_places(const Present& present, SimplexArray simplices) {
  for (auto& simplex : simplices) {
    for (std::int64_t& v : simplex) {
      const auto found = std::lower_bound(present.numbers.begin(), present.numbers.end(), v);
      v = found != present.numbers.end() && *found == v ? found - present.numbers.begin() : -1;
    }
  }
  return simplices;
}

// Names for places in a witness, if they are not the points' own numbers.
std::string numbers_of_places(const Present& present) {
  std::string text;
  for (std::size_t place = 0; place < present.numbers.size(); ++place) {
    if (present.numbers[place] == static_cast<std::int64_t>(place)) continue;
    text += fmt::format("{} vertex {} is point {}", text.empty() ? "where" : ",", place,
                        present.numbers[place]);
  }
  return text.empty() ? "" : text + "\n";
}

void take(DynamicTriangulation& structure, const Step& step) {
  if (step.is_removal) {
    structure.remove(step.number);
  } else {
    structure.insert(step.point.data());
  }
}

std::optional<Failure> failure_of(const Make& make, const SequenceOptions& options,
                                  const Steps& steps) {
  std::unique_ptr<DynamicTriangulation> structure;
  for (std::size_t done = 0; done < steps.size(); ++done) {
    SimplexArray simplices;
    try {
      if (!structure) structure = make();
      take(*structure, steps[done]);
      simplices = structure->simplices();
    } catch (const std::exception& error) {
      return Failure{done + 1, "crash", fmt::format("the structure threw: {}\n", error.what())};
    } catch (...) {
      return Failure{done + 1, "crash", "the structure threw what is not a std::exception\n"};
    }
    const Present present = present_after(steps, done + 1, options.dimension);
    const Judgement judgement =
        judge(options.claim, present.points, in_places(present, std::move(simplices)),
              harness::kJudgeOfCases);
    if (!judgement.holds) {
      return Failure{done + 1, judgement.rule, judgement.report + numbers_of_places(present)};
    }
  }
  return std::nullopt;
}

// Drops chunks of steps, half of all at first, as long as the same rule is broken in the end (delta
// debugging: Zeller and Hildebrandt, 2002), and then makes coordinates simpler.
class Shortener {
 public:
  Shortener(const Make& make, const SequenceOptions& options, std::string rule, Steps steps)
      : make_(make), options_(options), rule_(std::move(rule)), steps_(std::move(steps)) {}

  Steps result() {
    do {
      drop_steps();
    } while (drop_two_steps() || simplify_points());
    return steps_;
  }

 private:
  bool keep(const Steps& tried) {
    const auto failure = failure_of(make_, options_, tried);
    if (!failure || failure->rule != rule_) return false;
    steps_.assign(tried.begin(), tried.begin() + static_cast<std::ptrdiff_t>(failure->steps));
    return true;
  }

  void drop_steps() {
    for (std::size_t chunk = std::max<std::size_t>(steps_.size() / 2, 1); chunk > 0;) {
      bool dropped = false;
      for (std::size_t from = 0; from < steps_.size();) {
        std::vector<bool> marks(steps_.size(), true);
        std::fill_n(marks.begin() + static_cast<std::ptrdiff_t>(from),
                    std::min(chunk, steps_.size() - from), false);
        if (keep(harness::kept_steps(steps_, marks))) {
          dropped = true;
        } else {
          from += chunk;
        }
      }
      if (!dropped || chunk > 1) chunk = chunk == 1 ? 0 : chunk / 2;
    }
  }

  // Two steps may help only together: a point inserted instead of another one.
  bool drop_two_steps() {
    if (steps_.size() > 20) return false;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      for (std::size_t j = i + 1; j < steps_.size(); ++j) {
        std::vector<bool> marks(steps_.size(), true);
        marks[i] = marks[j] = false;
        if (keep(harness::kept_steps(steps_, marks))) return true;
      }
    }
    return false;
  }

  // Replaces all points by ranks, or scales and rounds them to integers of few bits, if that is
  // accepted; returns whether it was. After ranks, fewer bits give fewer different coordinates, so
  // this ends.
  bool simplify_points() {
    double largest = 0;
    bool integers = true;
    for (const Step& step : steps_) {
      for (const double x : step.point) {
        largest = std::max(largest, std::fabs(x));
        integers = integers && x == std::nearbyint(x);
      }
    }
    if (largest == 0) return false;
    if (keep_ranks()) return true;
    const int most_bits = integers ? std::min(std::ilogb(largest), 20) : 20;
    for (int bits = 1; bits <= most_bits; ++bits) {
      if (keep_rounded(bits - 1 - std::ilogb(largest))) return true;
    }
    return false;
  }

  // Replaces each coordinate by its rank on the axis, from 0.
  bool keep_ranks() {
    std::vector<std::set<double>> values(options_.dimension);
    for (const Step& step : steps_) {
      for (std::size_t axis = 0; axis < step.point.size(); ++axis) {
        values[axis].insert(step.point[axis]);
      }
    }
    return keep_image([&](std::size_t axis, double x) {
      const auto place = values[axis].find(x);
      return static_cast<double>(std::distance(values[axis].begin(), place));
    });
  }

  bool keep_rounded(int shift) {
    return keep_image(
        [shift](std::size_t, double x) { return std::nearbyint(std::ldexp(x, shift)) + 0.0; });
  }

  template <typename Map>
  bool keep_image(const Map& map) {
    Steps tried = steps_;
    bool changed = false;
    for (Step& step : tried) {
      for (std::size_t axis = 0; axis < step.point.size(); ++axis) {
        const double image = map(axis, step.point[axis]);
        changed = changed || image != step.point[axis];
        step.point[axis] = image;
      }
    }
    return changed && has_distinct_points(tried) && keep(tried);
  }

  // Among points present at the same time.
  static bool has_distinct_points(const Steps& steps) {
    std::map<std::int64_t, std::vector<double>> present;
    for (const Step& step : steps) {
      if (step.is_removal) {
        present.erase(step.number);
        continue;
      }
      for (const auto& [number, point] : present) {
        if (point == step.point) return false;
      }
      present[step.number] = step.point;
    }
    return true;
  }

  const Make& make_;
  const SequenceOptions& options_;
  std::string rule_;
  Steps steps_;
};

std::string text_of(const Steps& steps) {
  std::string text;
  for (const Step& step : steps) {
    text += fmt::format("  {} {}", step.is_removal ? "remove" : "insert", step.number);
    for (const double x : step.point) text += fmt::format(" {}", x);
    text += '\n';
  }
  return text;
}

}  // namespace

std::optional<SequenceFinding> find_wrong_sequence(const Make& make,
                                                   const SequenceOptions& options) {
  if (options.dimension < 1 || options.dimension > 4) {
    throw std::invalid_argument("expected a dimension from 1 to 4, found " +
                                std::to_string(options.dimension));
  }
  if (options.claim == "weighted-delaunay") {
    throw std::invalid_argument("expected triangulation or delaunay, found weighted-delaunay");
  }
  arrays::claim_named(options.claim);  // throws if it is unknown
  const auto families = harness::chosen_families(options.families, options.dimension, false);
  for (std::uint64_t index = 0; index < options.cases; ++index) {
    const harness::DrawnSequence drawn = harness::drawn_sequence(families, options, index);
    const auto first = failure_of(make, options, drawn.steps);
    if (!first) continue;
    Steps steps(drawn.steps.begin(),
                drawn.steps.begin() + static_cast<std::ptrdiff_t>(first->steps));
    steps = Shortener(make, options, first->rule, std::move(steps)).result();
    // A structure that is wrong now and then may be right again.
    const Failure last = failure_of(make, options, steps).value_or(*first);
    return SequenceFinding{steps, first->rule,
                           fmt::format("{} after {} (family {}, case {}):\n{}{}", first->rule,
                                       report::counted(steps.size(), "step"), drawn.family, index,
                                       text_of(steps), last.report)};
  }
  return std::nullopt;
}

}  // namespace circumspect
