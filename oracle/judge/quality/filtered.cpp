#include "oracle/judge/quality/filtered.hpp"

#include <cmath>

#include "oracle/judge/fast/in_chunks.hpp"
#include "oracle/judge/quality/enclosed_mesh.hpp"
#include "oracle/judge/quality/exact_measure.hpp"

namespace circumspect::quality {
namespace {

using Places = std::vector<std::vector<std::size_t>>;  // for each requirement

// A requirement as the filter compares it with values.
struct Bound {
  Measure measure;
  bool is_upper;  // values are to be at most this
  Enclosed value;
  // What rounding does to the comparison with plain doubles, if all edges were of length 1.
  Magnitude rounding = {};
  bool is_homogeneous = false;  // does it only grow with the edges?
};

// How much below the limit a value is: the sign says whether the requirement is kept.
template <class Number>
[[gnu::always_inline]] inline Number room(const Bound& bound, const Number& limit,
                                          const Quotient<Number>& quotient) {
  const Number scaled = limit * quotient.below;
  return bound.is_upper ? scaled - quotient.above : quotient.above - scaled;
}

template <std::size_t kDimension>
Bound bound_of(const Requirement& requirement) {
  const MeasureEntry& of = entry(requirement.measure);
  Bound bound{requirement.measure, of.is_angle == of.is_at_least,
              enclosed_bound(requirement.measure, requirement.bound)};
  SquaredLengths<kDimension, Magnitude> lengths;
  lengths.squared.fill(Magnitude::of_squared_length());
  const Magnitude limit{std::fabs(bound.value.value), bound.value.error, 0};
  each_value(bound.measure, lengths, [&](const Place&, const Quotient<Magnitude>& quotient) {
    bound.is_homogeneous = quotient.below.degree == quotient.above.degree;
    if (bound.is_homogeneous) bound.rounding = room(bound, limit, quotient);
  });
  return bound;
}

// Is the requirement surely kept, so far as plain doubles tell?
template <std::size_t kDimension>
[[gnu::always_inline]] inline bool is_plainly_kept(
    const Bound& bound, const SquaredLengths<kDimension, double>& lengths, double scale) {
  if (!bound.is_homogeneous) return false;
  double error = bound.rounding.error * (1 + Enclosed::kLoss);
  for (int i = 0; i < bound.rounding.degree; ++i) error *= scale;
  bool all = true;
  each_value(bound.measure, lengths, [&](const Place&, const Quotient<double>& quotient) {
    all &= room(bound, bound.value.value, quotient) > error;
  });
  return all & (scale > kLeastScale) & (scale < kLargestScale);
}

enum class Kept { kSurely, kSurelyNot, kUncertain };

template <std::size_t kDimension>
Kept is_kept(const Bound& bound, const SquaredLengths<kDimension, Enclosed>& lengths) {
  bool all = true, none = false;
  each_value(bound.measure, lengths, [&](const Place&, const Quotient<Enclosed>& quotient) {
    const Enclosed left = room(bound, bound.value, quotient);
    all &= left.is_surely_positive();
    none |= left.is_surely_negative();
  });
  if (all) return Kept::kSurely;
  const bool is_surely_not_flat = spread(lengths).is_surely_positive();
  return none && is_surely_not_flat ? Kept::kSurelyNot : Kept::kUncertain;
}

bool is_violated(const Requirement& requirement, const Mesh& mesh, std::size_t s, int dimension) {
  const auto found = measured(requirement.measure, mesh, mesh.simplices[s], dimension);
  return found && !keeps(requirement, found->value);
}

// Calls look(first, last, found) for chunks of the simplices, and joins what they find.
template <class Look>
Places in_order(std::size_t count, std::size_t requirements, unsigned threads, const Look& look) {
  std::vector<Places> of_chunk(fast::chunks_of(count, kChunk), Places(requirements));
  fast::in_chunks(count, kChunk, threads,
                  [&](std::size_t chunk, std::size_t first, std::size_t last) {
                    look(first, last, of_chunk[chunk]);
                  });
  Places all(requirements);
  for (const Places& some : of_chunk) {
    for (std::size_t r = 0; r < requirements; ++r) {
      all[r].insert(all[r].end(), some[r].begin(), some[r].end());
    }
  }
  return all;
}

template <class Enclosing>
Places filtered(const Mesh& mesh, const Enclosing& enclosing,
                const std::vector<Requirement>& requirements, unsigned threads) {
  constexpr std::size_t kDimension = Enclosing::kDimension;
  std::vector<Bound> bounds;
  for (const Requirement& one : requirements) bounds.push_back(bound_of<kDimension>(one));
  const auto look = [&](std::size_t first, std::size_t last, Places& found) {
    SquaredLengths<kDimension, double> lengths;
    for (std::size_t s = first; s < last; ++s) {
      if (!enclosing.set_lengths(s, lengths)) continue;
      const double scale = longest(lengths) * (1 + Enclosed::kLoss);
      for (std::size_t r = 0; r < bounds.size(); ++r) {
        if (is_plainly_kept(bounds[r], lengths, scale)) continue;
        const Kept kept = is_kept(bounds[r], enclosed(lengths));
        if (kept == Kept::kSurely) continue;
        if (kept == Kept::kSurelyNot ||
            is_violated(requirements[r], mesh, s, static_cast<int>(kDimension))) {
          found[r].push_back(s);
        }
      }
    }
  };
  return in_order(mesh.simplices.size(), requirements.size(), threads, look);
}

Places exactly(const Mesh& mesh, const std::vector<Requirement>& requirements, unsigned threads) {
  const int dimension = dimension_of_simplices(mesh);
  return in_order(mesh.simplices.size(), requirements.size(), threads,
                  [&](std::size_t first, std::size_t last, Places& found) {
                    for (std::size_t s = first; s < last; ++s) {
                      for (std::size_t r = 0; r < requirements.size(); ++r) {
                        if (!is_violated(requirements[r], mesh, s, dimension)) continue;
                        found[r].push_back(s);
                      }
                    }
                  });
}

}  // namespace

Places violators(const Mesh& mesh, const std::vector<Requirement>& requirements, unsigned threads) {
  return enclosed_or_else(
      mesh, [&](const auto& enclosing) { return filtered(mesh, enclosing, requirements, threads); },
      [&] { return exactly(mesh, requirements, threads); });
}

}  // namespace circumspect::quality
