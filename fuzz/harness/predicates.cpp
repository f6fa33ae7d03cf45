#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <circumspect/predicates.hpp>
#include <fmt/format.h>

#include "fuzz/harness/cases.hpp"
#include "fuzz/harness/predicate_arguments.hpp"

namespace circumspect {
namespace {

using Coordinates = std::vector<double>;

void require_sound(const PredicateOptions& options) {
  if (options.dimension != 2 && options.dimension != 3) {
    throw std::invalid_argument("expected dimension 2 or 3, found " +
                                std::to_string(options.dimension));
  }
  if (options.max_exponent > 300 || options.min_exponent < -300 ||
      options.max_exponent - options.min_exponent < 60) {
    throw std::invalid_argument("expected exponents from -300 to 300, at least 60 apart, found " +
                                std::to_string(options.min_exponent) + " to " +
                                std::to_string(options.max_exponent));
  }
}

// How the two signs differ, if they do.
struct Wrong {
  int expected;
  double found;
};
std::optional<Wrong> wrong_sign(const Predicate& predicate, const PredicateOptions& options,
                                const Coordinates& coordinates) {
  const double found = predicate(coordinates.data());
  const int expected = harness::exact_sign(options.kind, options.dimension, coordinates);
  const int sign_found = found > 0 ? 1 : found < 0 ? -1 : 0;
  if (!std::isnan(found) && sign_found == expected) return std::nullopt;
  return Wrong{expected, found};
}

// The number of bits needed to write a number, including its exponent.
int complexity(double x) {
  if (x == 0) return 0;
  const int exponent = std::ilogb(x);
  double rest = std::ldexp(std::fabs(x), -exponent);
  int bits = 1;
  for (rest -= 1; rest > 0; rest = 2 * rest - std::floor(2 * rest)) ++bits;
  return 1 + bits + std::abs(exponent) + (x < 0 ? 1 : 0);
}

int complexity(const Coordinates& coordinates) {
  int sum = 0;
  for (const double x : coordinates) sum += complexity(x);
  return sum;
}

// Rounds to nearest, to at most so many bits.
double rounded_to_bits(double x, int bits) {
  if (x == 0) return 0;
  const int shift = bits - 1 - std::ilogb(x);
  return std::ldexp(std::nearbyint(std::ldexp(x, shift)), -shift);
}

// Makes arguments simpler as long as the sign is wrong.
class Simplifier {
 public:
  Simplifier(const Predicate& predicate, const PredicateOptions& options, Coordinates coordinates)
      : predicate_(predicate), options_(options), simplest_(std::move(coordinates)) {}

  Coordinates result() {
    while (step()) {
    }
    return simplest_;
  }

 private:
  bool keep(Coordinates tried) {
    for (double& x : tried) x += 0.0;  // no −0
    if (complexity(tried) >= complexity(simplest_)) return false;
    if (!harness::is_within_limits(options_, tried)) return false;
    if (!wrong_sign(predicate_, options_, tried)) return false;
    simplest_ = std::move(tried);
    return true;
  }

  template <typename Map>
  bool keep_image(const Map& map) {
    Coordinates image = simplest_;
    for (std::size_t i = 0; i < image.size(); ++i) image[i] = map(i, image[i]);
    return keep(std::move(image));
  }

  bool step() { return move_all() || round_all() || change_one(); }

  // Moves a point to the origin; multiplies all by a power of two.
  bool move_all() {
    const std::size_t d = options_.dimension;
    const Coordinates old = simplest_;
    for (std::size_t origin = 0; origin < old.size(); origin += d) {
      if (keep_image([&](std::size_t i, double x) { return x - old[origin + i % d]; })) return true;
    }
    for (const double pivot : old) {
      if (pivot == 0) continue;
      const int exponent = std::ilogb(pivot);
      if (keep_image([&](std::size_t, double x) { return std::ldexp(x, -exponent); })) return true;
    }
    for (const int shift : {-1, 1}) {
      if (keep_image([&](std::size_t, double x) { return std::ldexp(x, shift); })) return true;
    }
    return false;
  }

  bool round_all() {
    for (const int bits : {1, 2, 4, 8, 16, 32, 44}) {
      if (keep_image([&](std::size_t, double x) { return rounded_to_bits(x, bits); })) return true;
    }
    return false;
  }

  bool change_one() {
    for (std::size_t at = 0; at < simplest_.size(); ++at) {
      const double old = simplest_[at];
      if (old == 0) continue;
      for (const double simpler :
           {0.0, 1.0, -old, std::ldexp(old, -std::ilogb(old)), old / 2, old * 2}) {
        if (keep_with(at, simpler)) return true;
      }
      for (int bits = 1; bits <= 52; ++bits) {
        if (keep_with(at, rounded_to_bits(old, bits))) return true;
      }
    }
    return false;
  }

  bool keep_with(std::size_t at, double value) {
    Coordinates tried = simplest_;
    tried[at] = value;
    return keep(std::move(tried));
  }

  const Predicate& predicate_;
  const PredicateOptions& options_;
  Coordinates simplest_;
};

std::string report_text(const PredicateOptions& options, const PredicateFinding& finding) {
  std::string text = fmt::format(
      "{} in dimension {}: expected {}, found {:g} (family {})\n",
      options.kind == PredicateKind::kOrientation ? "orientation" : "in-sphere", options.dimension,
      finding.expected > 0   ? "a positive number"
      : finding.expected < 0 ? "a negative number"
                             : "0",
      finding.found, finding.family);
  const std::size_t d = options.dimension;
  for (std::size_t i = 0; i < finding.coordinates.size() / d; ++i) {
    text += fmt::format("  p{}", i);
    for (std::size_t axis = 0; axis < d; ++axis) {
      text += fmt::format(" {}", finding.coordinates[i * d + axis]);
    }
    text += "   =";
    for (std::size_t axis = 0; axis < d; ++axis) {
      text += fmt::format(" {:a}", finding.coordinates[i * d + axis]);
    }
    text += '\n';
  }
  return text;
}

}  // namespace

std::optional<PredicateFinding> find_wrong_sign(const Predicate& predicate,
                                                const PredicateOptions& options) {
  require_sound(options);
  const auto& families = harness::argument_families();
  for (std::uint64_t index = 0; index < options.cases; ++index) {
    const harness::ArgumentFamily& family = families[index % families.size()];
    generators::Dice dice(harness::mixed_seed(options.seed, index));
    Coordinates coordinates = family.made(options, dice);
    if (!wrong_sign(predicate, options, coordinates)) continue;
    PredicateFinding finding{std::string(family.name), {}, 0, 0, ""};
    finding.coordinates = Simplifier(predicate, options, std::move(coordinates)).result();
    const auto wrong = wrong_sign(predicate, options, finding.coordinates);
    // A predicate that is wrong now and then may be right again.
    if (wrong) {
      finding.expected = wrong->expected;
      finding.found = wrong->found;
    }
    finding.report = report_text(options, finding);
    return finding;
  }
  return std::nullopt;
}

}  // namespace circumspect
