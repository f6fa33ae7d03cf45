#include "python/inputs.hpp"

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "fuzz/campaign/domain_text.hpp"
#include "fuzz/campaign/input.hpp"
#include "fuzz/harness/cases.hpp"
#include "inputs/cases.hpp"
#include "inputs/families.hpp"
#include "inputs/family_faults.hpp"
#include "inputs/in_doubles.hpp"
#include "inputs/minimise.hpp"
#include "inputs/triangulated/domain_families.hpp"
#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "python/arrays.hpp"
#include "python/functions.hpp"

namespace circumspect::python {
namespace {

// Points as n × d doubles, and n weights or nothing.
struct Arrays {
  Object points;
  Object weights = {};

  std::pair<Object, Object> both() const { return {points, weights}; }
};

Arrays arrays_of(const generators::PointsCase& set, std::size_t dimension) {
  const PointArray points = generators::array(set, dimension);
  Arrays arrays{new_array({points.size(), dimension}, std::span(points.coordinates))};
  if (!points.weights.empty()) {
    arrays.weights = new_array({points.size()}, std::span(points.weights));
  }
  return arrays;
}

std::size_t dimension_of(const Doubles& points) {
  if (points.axes() != 2) throw std::invalid_argument("expected rows of coordinates");
  return static_cast<std::size_t>(points.length(1));
}

generators::PointsCase set_of(const Doubles& points, const std::optional<Doubles>& weights) {
  PointArray array{dimension_of(points), {}, {}};
  array.coordinates.assign(points.numbers().begin(), points.numbers().end());
  if (weights) array.weights.assign(weights->numbers().begin(), weights->numbers().end());
  return generators::from(array);
}

auto families() {
  std::vector<std::tuple<std::string, std::string, std::vector<std::size_t>, bool, bool>> all;
  for (const generators::Family& family : generators::modified_families()) {
    std::vector<std::size_t> dimensions;
    for (std::size_t d = 1; d <= 8; ++d) {
      if (family.exists_in(d)) dimensions.push_back(d);
    }
    all.emplace_back(family.name, family.about, dimensions, family.weighted, family.repeats_points);
  }
  return all;
}

auto domain_families() {
  std::vector<std::tuple<std::string, std::string, std::size_t>> all;
  for (const generators::ComplexFamily& family : properties::domain_families()) {
    all.emplace_back(family.name, family.about, family.dimension);
  }
  return all;
}

const generators::Family& family_in(const std::string& name, std::size_t dimension) {
  return *harness::chosen_families({name}, dimension, false).front();
}

std::pair<Object, Object> generate(const std::string& name, std::size_t dimension,
                                   std::size_t max_points, std::uint64_t seed, bool fewer) {
  const generators::Family& family = family_in(name, dimension);
  const generators::PointsCase set =
      generators::drawn(family, dimension, {max_points, !fewer}, seed);
  return arrays_of(generators::in_doubles(set, family.repeats_points), dimension).both();
}

// Coordinates as texts, row after row.
std::vector<std::string> generate_exact(const std::string& name, std::size_t dimension,
                                        std::size_t max_points, std::uint64_t seed, bool fewer) {
  const generators::Family& family = family_in(name, dimension);
  const generators::PointsCase set =
      generators::drawn(family, dimension, {max_points, !fewer}, seed);
  std::vector<std::string> texts;
  for (const Point& point : set.points) {
    for (const Rational& x : point) texts.push_back(to_string(x));
  }
  return texts;
}

// A domain as the package represents it: points, segments, polygons as lists of lines, hole seeds,
// holes of polygons as pairs of a polygon and a seed; does it fill the hull?
using HoleOfPolygon = std::pair<std::size_t, std::vector<double>>;
template <class Points>
using DomainParts = std::tuple<Points, std::vector<std::vector<Vertex>>,
                               std::vector<std::vector<std::vector<Vertex>>>, Points,
                               std::vector<HoleOfPolygon>, bool>;
using OwnDomain = DomainParts<Object>;

OwnDomain parts_of(const PiecewiseLinearInput& input, std::size_t dimension) {
  std::vector<std::vector<std::vector<Vertex>>> polygons;
  std::vector<HoleOfPolygon> polygon_holes;
  for (const PolygonLines& polygon : input.polygons) {
    for (const Point& seed : polygon.hole_seeds) {
      std::vector<double> numbers;
      for (const Rational& x : seed) numbers.push_back(x.get_d());
      polygon_holes.emplace_back(polygons.size(), numbers);
    }
    polygons.push_back(polygon.lines);
  }
  return {arrays_of({input.points}, dimension).points,
          input.segments,
          polygons,
          arrays_of({input.hole_seeds}, dimension).points,
          polygon_holes,
          input.kind == DomainKind::kHull};
}

PiecewiseLinearInput input_of(const Object& domain) {
  const auto [points, segments, polygons, hole_seeds, polygon_holes, is_hull] =
      value_of<DomainParts<Doubles>>(domain.get());
  PiecewiseLinearInput input;
  input.points = set_of(points, std::nullopt).points;
  input.segments = segments;
  for (const auto& lines : polygons) input.polygons.push_back({lines, {}});
  input.hole_seeds = set_of(hole_seeds, std::nullopt).points;
  for (const auto& [polygon, seed] : polygon_holes) {
    Point& point = input.polygons.at(polygon).hole_seeds.emplace_back();
    for (const double x : seed) point.push_back(exact_value(x));
  }
  if (is_hull) input.kind = DomainKind::kHull;
  return input;
}

const generators::ComplexFamily& domain_family(const std::string& name) {
  const generators::ComplexFamily* const family = properties::find_domain_family(name);
  if (family != nullptr) return *family;
  throw std::invalid_argument(generators::unknown_family_text("domains", name));
}

PiecewiseLinearInput drawn_domain(const generators::ComplexFamily& family, std::size_t max_points,
                                  std::uint64_t seed) {
  return generators::in_doubles(generators::drawn(family, max_points, seed)).input;
}

OwnDomain generate_domain(const std::string& name, std::size_t max_points, std::uint64_t seed) {
  const generators::ComplexFamily& family = domain_family(name);
  return parts_of(drawn_domain(family, max_points, seed), family.dimension);
}

// Case number `index` of a run on domains, taking the families in turn; without names, all families
// of the dimension: (family, seed, domain).
std::tuple<std::string, std::uint64_t, OwnDomain> drawn_domain_case(
    const std::vector<std::string>& names, std::size_t dimension, std::size_t max_points,
    std::uint64_t run_seed, std::uint64_t index) {
  std::vector<const generators::ComplexFamily*> chosen;
  for (const std::string& name : names) chosen.push_back(&domain_family(name));
  if (names.empty()) {
    for (const generators::ComplexFamily& family : properties::domain_families()) {
      if (family.dimension == dimension) chosen.push_back(&family);
    }
  }
  if (chosen.empty()) throw std::invalid_argument("expected domains of the plane or of space");
  const generators::ComplexFamily& family = *chosen[index % chosen.size()];
  if (family.dimension != dimension) {
    throw std::invalid_argument(generators::no_sets_text(
        family.name, std::to_string(family.dimension), static_cast<std::int64_t>(dimension)));
  }
  const std::uint64_t seed = harness::mixed_seed(run_seed, index);
  return {family.name, seed, parts_of(drawn_domain(family, max_points, seed), dimension)};
}

// Case number `index` of a run: (family, seed, points, weights).
std::tuple<std::string, std::uint64_t, Object, Object> drawn_case(
    const std::vector<std::string>& names, std::size_t dimension, bool weighted,
    std::size_t max_points, std::uint64_t run_seed, std::uint64_t index) {
  const auto chosen = harness::chosen_families(names, dimension, weighted);
  const harness::DrawnCase drawn =
      harness::drawn_case(chosen, dimension, max_points, run_seed, index);
  const Arrays arrays = arrays_of(drawn.set, dimension);
  return {drawn.family, drawn.seed, arrays.points, arrays.weights};
}

// With the exponents of all coordinates in a range, as the command's campaigns draw them.
std::pair<Object, Object> brought_within(const Doubles& points,
                                         const std::optional<Doubles>& weights, std::int32_t least,
                                         std::int32_t largest, bool may_repeat_points) {
  return arrays_of(generators::brought_within(set_of(points, weights), {least, largest},
                                              may_repeat_points),
                   dimension_of(points))
      .both();
}

// The smallest points found for which `still_fails(points, weights)` is true.
std::pair<Object, Object> minimized(const Doubles& points, const std::optional<Doubles>& weights,
                                    const Object& still_fails, std::size_t tries, double seconds) {
  const std::size_t dimension = dimension_of(points);
  const auto fails = [&](const generators::PointsCase& set) {
    if (!harness::are_doubles(set)) return false;
    const Arrays arrays = arrays_of(set, dimension);
    return value_of<bool>(called(still_fails, arrays.points, arrays.weights).get());
  };
  return arrays_of(generators::minimised(
                       set_of(points, weights), fails,
                       {.tries = tries, .time = std::chrono::duration<double>(seconds)}),
                   dimension)
      .both();
}

// The same for domains. Requires: a valid domain.
OwnDomain minimized_domain(const Object& domain, const Object& still_fails, std::size_t tries,
                           double seconds) {
  const generators::ComplexCase whole{"", input_of(domain)};
  const std::size_t dimension = whole.input.points.front().size();
  const auto fails = [&](const generators::ComplexCase& smaller) {
    const bool is_hull = smaller.input.kind == DomainKind::kHull;
    if (is_hull && PointSet(smaller.input.points).dimension() < static_cast<int>(dimension)) {
      return false;  // there is no such hull
    }
    return campaign::is_of_doubles(smaller) &&
           value_of<bool>(called(still_fails, object_of(parts_of(smaller.input, dimension))).get());
  };
  return parts_of(
      generators::minimised(whole, fails,
                            {.tries = tries, .time = std::chrono::duration<double>(seconds)})
          .input,
      dimension);
}

// As the text of a .poly file, counted from 0.
std::string poly_text(const Object& domain) { return campaign::poly_text(input_of(domain), 0); }

}  // namespace

PyMethodDef* methods_of_inputs() {
  static std::array methods = {
      method<&families>("families"),
      method<&domain_families>("domain_families"),
      method<&generate>("generate"),
      method<&generate_exact>("generate_exact"),
      method<&generate_domain>("generate_domain"),
      method<&drawn_case>("drawn_case"),
      method<&drawn_domain_case>("drawn_domain_case"),
      method<&brought_within>("brought_within"),
      method<&minimized>("minimized"),
      method<&minimized_domain>("minimized_domain"),
      method<&poly_text>("poly_text"),
      PyMethodDef{},
  };
  return methods.data();
}

}  // namespace circumspect::python
