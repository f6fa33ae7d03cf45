// circumspect._core: draws inputs from families, and makes them small.
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

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

namespace py = pybind11;

namespace circumspect {

void bind_inputs(py::module_& module);

namespace {

using Doubles = py::array_t<double, py::array::c_style>;

// Points as (n × d doubles, n weights or None).
py::tuple arrays_of(const generators::PointsCase& set, std::size_t dimension) {
  const PointArray points = generators::array(set, dimension);
  const auto count = static_cast<py::ssize_t>(points.size());
  py::object weights = py::none();
  if (!points.weights.empty()) weights = Doubles(count, points.weights.data());
  return py::make_tuple(
      Doubles({count, static_cast<py::ssize_t>(dimension)}, points.coordinates.data()), weights);
}

generators::PointsCase set_of(const Doubles& points, const std::optional<Doubles>& weights) {
  PointArray array{static_cast<std::size_t>(points.shape(1)), {}, {}};
  array.coordinates.assign(points.data(), points.data() + points.size());
  if (weights) array.weights.assign(weights->data(), weights->data() + weights->size());
  return generators::from(array);
}

py::list families() {
  py::list all;
  for (const generators::Family& family : generators::modified_families()) {
    std::vector<std::size_t> dimensions;
    for (std::size_t d = 1; d <= 8; ++d) {
      if (family.exists_in(d)) dimensions.push_back(d);
    }
    all.append(py::make_tuple(family.name, family.about, dimensions, family.weighted,
                              family.repeats_points));
  }
  return all;
}

py::list domain_families() {
  py::list all;
  for (const generators::ComplexFamily& family : properties::domain_families()) {
    all.append(py::make_tuple(family.name, family.about, family.dimension));
  }
  return all;
}

const generators::Family& family_in(const std::string& name, std::size_t dimension) {
  return *harness::chosen_families({name}, dimension, false).front();
}

py::tuple generate(const std::string& name, std::size_t dimension, std::size_t max_points,
                   std::uint64_t seed, bool fewer) {
  const generators::Family& family = family_in(name, dimension);
  const generators::PointsCase set =
      generators::drawn(family, dimension, {max_points, !fewer}, seed);
  return arrays_of(generators::in_doubles(set, family.repeats_points), dimension);
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

// A domain as the Python package represents it: (points, segments, polygons as lists of lines, hole
// seeds, holes of polygons as pairs of a polygon and a seed, fills the hull?)
py::tuple tuple_of(const PiecewiseLinearInput& input, std::size_t dimension) {
  py::list polygons;
  for (const PolygonLines& polygon : input.polygons) polygons.append(py::cast(polygon.lines));
  py::list polygon_holes;
  for (std::size_t p = 0; p < input.polygons.size(); ++p) {
    for (const Point& seed : input.polygons[p].hole_seeds) {
      std::vector<double> numbers;
      for (const Rational& x : seed) numbers.push_back(x.get_d());
      polygon_holes.append(py::make_tuple(p, numbers));
    }
  }
  return py::make_tuple(arrays_of({input.points}, dimension)[0], input.segments, polygons,
                        arrays_of({input.hole_seeds}, dimension)[0], polygon_holes,
                        input.kind == DomainKind::kHull);
}

PiecewiseLinearInput input_of(const py::tuple& parts) {
  const auto points = parts[0].cast<Doubles>();
  PiecewiseLinearInput input;
  input.points = set_of(points, std::nullopt).points;
  input.segments = parts[1].cast<std::vector<std::vector<Vertex>>>();
  for (auto& lines : parts[2].cast<std::vector<std::vector<std::vector<Vertex>>>>()) {
    input.polygons.push_back({std::move(lines), {}});
  }
  input.hole_seeds = set_of(parts[3].cast<Doubles>(), std::nullopt).points;
  for (const auto& [polygon, seed] :
       parts[4].cast<std::vector<std::pair<std::size_t, std::vector<double>>>>()) {
    Point& point = input.polygons.at(polygon).hole_seeds.emplace_back();
    for (const double x : seed) point.push_back(exact_value(x));
  }
  if (parts[5].cast<bool>()) input.kind = DomainKind::kHull;
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

py::tuple generate_domain(const std::string& name, std::size_t max_points, std::uint64_t seed) {
  const generators::ComplexFamily& family = domain_family(name);
  return tuple_of(drawn_domain(family, max_points, seed), family.dimension);
}

// Case number `index` of a run on domains, taking the families in turn; without names, all families
// of the dimension: (family, seed, domain).
py::tuple drawn_domain_case(const std::vector<std::string>& names, std::size_t dimension,
                            std::size_t max_points, std::uint64_t run_seed, std::uint64_t index) {
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
  return py::make_tuple(family.name, seed,
                        tuple_of(drawn_domain(family, max_points, seed), dimension));
}

// Case number `index` of a run: (family, seed, points, weights).
py::tuple drawn_case(const std::vector<std::string>& names, std::size_t dimension, bool weighted,
                     std::size_t max_points, std::uint64_t run_seed, std::uint64_t index) {
  const auto chosen = harness::chosen_families(names, dimension, weighted);
  const harness::DrawnCase drawn =
      harness::drawn_case(chosen, dimension, max_points, run_seed, index);
  const py::tuple arrays = arrays_of(drawn.set, dimension);
  return py::make_tuple(drawn.family, drawn.seed, arrays[0], arrays[1]);
}

// The smallest points found for which `still_fails(points, weights)` is true.
py::tuple minimized(const Doubles& points, const std::optional<Doubles>& weights,
                    const std::function<bool(const py::object&, const py::object&)>& still_fails,
                    std::size_t tries, double seconds) {
  const auto dimension = static_cast<std::size_t>(points.shape(1));
  const auto fails = [&](const generators::PointsCase& set) {
    if (!harness::are_doubles(set)) return false;
    const py::tuple arrays = arrays_of(set, dimension);
    return still_fails(arrays[0], arrays[1]);
  };
  return arrays_of(
      generators::minimised(set_of(points, weights), fails,
                            {.tries = tries, .time = std::chrono::duration<double>(seconds)}),
      dimension);
}

// The same for domains. Requires: a valid domain.
py::tuple minimized_domain(const py::tuple& domain,
                           const std::function<bool(const py::object&)>& still_fails,
                           std::size_t tries, double seconds) {
  const generators::ComplexCase whole{"", input_of(domain)};
  const std::size_t dimension = whole.input.points.front().size();
  const auto fails = [&](const generators::ComplexCase& smaller) {
    const bool is_hull = smaller.input.kind == DomainKind::kHull;
    if (is_hull && PointSet(smaller.input.points).dimension() < static_cast<int>(dimension)) {
      return false;  // there is no such hull
    }
    return campaign::is_of_doubles(smaller) && still_fails(tuple_of(smaller.input, dimension));
  };
  return tuple_of(
      generators::minimised(whole, fails,
                            {.tries = tries, .time = std::chrono::duration<double>(seconds)})
          .input,
      dimension);
}

// As the text of a .poly file, counted from 0.
std::string poly_text(const py::tuple& domain) { return campaign::poly_text(input_of(domain), 0); }

}  // namespace

void bind_inputs(py::module_& module) {
  module.def("families", &families);
  module.def("domain_families", &domain_families);
  module.def("generate", &generate);
  module.def("generate_exact", &generate_exact);
  module.def("generate_domain", &generate_domain);
  module.def("drawn_case", &drawn_case);
  module.def("drawn_domain_case", &drawn_domain_case);
  module.def("minimized", &minimized);
  module.def("minimized_domain", &minimized_domain);
  module.def("poly_text", &poly_text);
}

}  // namespace circumspect
