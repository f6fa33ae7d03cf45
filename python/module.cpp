// circumspect._core: the C interface and the families of inputs, for the package around it. Arrays come
// in as the package has made them: doubles and indices in C order, or exact numbers as texts.
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <circumspect/circumspect.h>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "fuzz/harness/cases.hpp"
#include "inputs/arrays.hpp"
#include "inputs/families.hpp"
#include "inputs/in_doubles.hpp"
#include "inputs/minimise.hpp"
#include "inputs/triangulated/domain_families.hpp"
#include "reference/kernel/exact/number.hpp"

namespace py = pybind11;

namespace circumspect {
namespace {

struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};
struct NoTriangulation : std::runtime_error {
  using std::runtime_error::runtime_error;
};
struct Undecided : std::runtime_error {
  using std::runtime_error::runtime_error;
};

void require_ok(circumspect_status status) {
  const std::string message = circumspect_last_error();
  switch (status) {
    case CIRCUMSPECT_OK:
      return;
    case CIRCUMSPECT_INVALID_ARGUMENT:
      throw py::value_error(message);
    case CIRCUMSPECT_INPUT_FAULT:
      throw InputError(message);
    case CIRCUMSPECT_NONE:
      throw NoTriangulation(message);
    case CIRCUMSPECT_UNDECIDED:
      throw Undecided(message);
    case CIRCUMSPECT_OUT_OF_MEMORY:
      throw std::bad_alloc();
    case CIRCUMSPECT_INTERNAL_ERROR:
      break;
  }
  throw std::runtime_error(message);
}

using Doubles = py::array_t<double, py::array::c_style>;
using Indices = py::array_t<std::int64_t, py::array::c_style>;

// A list of numbers, doubles or texts, that lives as long as the call.
class NumberList {
 public:
  explicit NumberList(const py::object& numbers) {
    if (numbers.is_none()) return;
    if (py::isinstance<Doubles>(numbers)) {
      doubles_ = numbers.cast<Doubles>();
    } else {
      texts_ = numbers.cast<std::vector<std::string>>();
      for (const std::string& text : texts_) pointers_.push_back(text.c_str());
      pointers_.push_back(nullptr);  // so that there is an array, if an empty one
    }
  }
  const double* doubles() const { return doubles_ ? doubles_->data() : nullptr; }
  const char* const* texts() const { return pointers_.empty() ? nullptr : pointers_.data(); }
  std::int64_t size() const {
    return doubles_ ? doubles_->size() : static_cast<std::int64_t>(texts_.size());
  }

 private:
  std::optional<Doubles> doubles_ = {};
  std::vector<std::string> texts_ = {};
  std::vector<const char*> pointers_ = {};
};

// What the package hands over of a mesh: (dimension, coordinates, weights, simplices, neighbors,
// triangles, edges), each but the first two may be None; coordinates are flat.
class MeshArgument {
 public:
  explicit MeshArgument(const py::tuple& parts)
      : coordinates_(parts[1]), weights_(parts[2]), arrays_(parts) {
    mesh_.dimension = parts[0].cast<std::int64_t>();
    mesh_.point_count = mesh_.dimension > 0 ? coordinates_.size() / mesh_.dimension : 0;
    mesh_.coordinates = coordinates_.doubles();
    mesh_.exact_coordinates = coordinates_.texts();
    mesh_.weights = weights_.doubles();
    mesh_.exact_weights = weights_.texts();
    if (const auto rows = array(3)) {
      mesh_.simplex_count = rows->shape(0);
      mesh_.vertices_of_simplex = rows->shape(1);
      mesh_.index_bytes = rows->itemsize();
      mesh_.simplices = rows->data();
      if (const auto across = array(4)) mesh_.neighbors = across->data();
    }
    if (const auto faces = array(5)) {
      mesh_.triangle_count = faces->shape(0);
      mesh_.triangles = static_cast<const std::int64_t*>(faces->data());
    }
    if (const auto faces = array(6)) {
      mesh_.edge_count = faces->shape(0);
      mesh_.edges = static_cast<const std::int64_t*>(faces->data());
    }
  }
  const circumspect_mesh* get() const { return &mesh_; }

 private:
  std::optional<py::array> array(std::size_t place) const {
    if (arrays_[place].is_none()) return std::nullopt;
    return arrays_[place].cast<py::array>();
  }

  circumspect_mesh mesh_ = CIRCUMSPECT_MESH;
  NumberList coordinates_;
  NumberList weights_;
  py::tuple arrays_;  // which live as long as this
};

// (dimension, coordinates, segments, polygon_starts, line_starts, corners, hole_seeds, kind)
class DomainArgument {
 public:
  explicit DomainArgument(const py::tuple& parts)
      : coordinates_(parts[1]),
        segments_(parts[2].cast<Indices>()),
        polygons_(parts[3].cast<Indices>()),
        lines_(parts[4].cast<Indices>()),
        corners_(parts[5].cast<Indices>()),
        holes_(parts[6].cast<Doubles>()) {
    domain_.dimension = parts[0].cast<std::int64_t>();
    domain_.point_count = domain_.dimension > 0 ? coordinates_.size() / domain_.dimension : 0;
    domain_.coordinates = coordinates_.doubles();
    domain_.exact_coordinates = coordinates_.texts();
    domain_.segment_count = segments_.size() / 2;
    domain_.segments = segments_.data();
    domain_.polygon_count = polygons_.size() - 1;
    domain_.polygon_starts = polygons_.data();
    domain_.line_starts = lines_.data();
    domain_.corners = corners_.data();
    domain_.hole_count = domain_.dimension > 0 ? holes_.size() / domain_.dimension : 0;
    domain_.hole_seeds = holes_.data();
    domain_.kind = parts[7].cast<std::int32_t>();
  }
  const circumspect_domain* get() const { return &domain_; }

 private:
  circumspect_domain domain_ = CIRCUMSPECT_DOMAIN;
  NumberList coordinates_;
  Indices segments_, polygons_, lines_, corners_;
  Doubles holes_;
};

// (holds, unique, canonical, text, json, rules), facts −1 where they are not said.
py::tuple check(const std::string& claim, const py::tuple& mesh,
                const std::optional<py::tuple>& domain, std::int64_t threads,
                std::int64_t max_violations, bool by_definition, bool oriented,
                const std::optional<std::string>& within, const std::string& name, bool with_json) {
  const MeshArgument argument(mesh);
  std::optional<DomainArgument> about;
  if (domain) about.emplace(*domain);
  circumspect_options options = CIRCUMSPECT_OPTIONS;
  options.threads = threads;
  options.max_violations = max_violations;
  options.by_definition = by_definition ? 1 : 0;
  options.oriented = oriented ? 1 : 0;
  options.within = within ? within->c_str() : nullptr;
  options.mesh_name = name.c_str();
  options.without_json = with_json ? 0 : 1;
  circumspect_verdict* verdict = nullptr;
  circumspect_status status = CIRCUMSPECT_OK;
  {
    const py::gil_scoped_release others_go_on;
    status = circumspect_check(claim.c_str(), argument.get(), about ? about->get() : nullptr,
                               &options, &verdict);
  }
  require_ok(status);
  const std::unique_ptr<circumspect_verdict, decltype(&circumspect_verdict_free)> own(
      verdict, circumspect_verdict_free);
  py::dict rules;
  for (std::int64_t i = 0; i < circumspect_verdict_rule_count(verdict); ++i) {
    std::int64_t count = 0;
    const char* const rule = circumspect_verdict_rule(verdict, i, &count);
    rules[rule] = count;
  }
  return py::make_tuple(circumspect_verdict_holds(verdict) == 1,
                        circumspect_verdict_unique(verdict), circumspect_verdict_canonical(verdict),
                        circumspect_verdict_text(verdict), circumspect_verdict_json(verdict),
                        rules);
}

// Rows of `vertices` indices.
Indices rows_of(const circumspect_triangulation* built, std::int64_t vertices) {
  const std::int64_t* indices = nullptr;
  const std::int64_t count = circumspect_triangulation_simplices(built, vertices, &indices);
  return Indices({count, vertices}, indices);
}

using OwnTriangulation =
    std::unique_ptr<circumspect_triangulation, decltype(&circumspect_triangulation_free)>;

Indices delaunay(const py::tuple& points) {
  const MeshArgument argument(points);
  circumspect_triangulation* built = nullptr;
  circumspect_status status = CIRCUMSPECT_OK;
  {
    const py::gil_scoped_release others_go_on;
    status = circumspect_delaunay(argument.get(), &built);
  }
  require_ok(status);
  const OwnTriangulation own(built, circumspect_triangulation_free);
  return rows_of(built, std::max<std::int64_t>(circumspect_triangulation_dimension(built), 0) + 1);
}

// Simplices, and those that dangle: with three, two and one vertices.
py::tuple constrained_delaunay(const py::tuple& domain) {
  const DomainArgument argument(domain);
  circumspect_triangulation* built = nullptr;
  circumspect_status status = CIRCUMSPECT_OK;
  {
    const py::gil_scoped_release others_go_on;
    status = circumspect_constrained_delaunay(argument.get(), &built);
  }
  require_ok(status);
  const OwnTriangulation own(built, circumspect_triangulation_free);
  const std::int64_t vertices = circumspect_triangulation_dimension(built) + 1;
  return py::make_tuple(rows_of(built, vertices),
                        vertices == 4 ? rows_of(built, 3) : rows_of(nullptr, 3), rows_of(built, 2),
                        rows_of(built, 1));
}

int predicate(bool in_ball, std::int64_t dimension, const py::object& numbers) {
  const NumberList coordinates(numbers);
  if (coordinates.size() != dimension * (dimension + (in_ball ? 2 : 1))) {
    throw py::value_error("expected as many coordinates as the points have, found others");
  }
  int sign = 0;
  if (coordinates.doubles() != nullptr) {
    require_ok((in_ball ? circumspect_in_ball : circumspect_orientation)(
        dimension, coordinates.doubles(), &sign));
  } else {
    require_ok((in_ball ? circumspect_in_ball_exact : circumspect_orientation_exact)(
        dimension, coordinates.texts(), &sign));
  }
  return sign;
}

// The answer, and the text of the document.
py::tuple with_document(
    const std::function<circumspect_status(int*, circumspect_document**)>& call) {
  int answer = 0;
  circumspect_document* document = nullptr;
  circumspect_status status = CIRCUMSPECT_OK;
  {
    const py::gil_scoped_release others_go_on;
    status = call(&answer, &document);
  }
  require_ok(status);
  const std::unique_ptr<circumspect_document, decltype(&circumspect_document_free)> own(
      document, circumspect_document_free);
  return py::make_tuple(answer == 1, circumspect_document_text(document));
}

py::tuple compare(const py::tuple& a, const py::tuple& b) {
  const MeshArgument mesh_a(a);
  const MeshArgument mesh_b(b);
  return with_document([&](int* same, circumspect_document** document) {
    return circumspect_compare(mesh_a.get(), mesh_b.get(), same, document);
  });
}

py::tuple inspect(const py::tuple& points) {
  const MeshArgument argument(points);
  return with_document([&](int* unique, circumspect_document** document) {
    return circumspect_inspect(argument.get(), unique, document);
  });
}

py::tuple certify(const std::string& claim, const py::tuple& mesh) {
  const MeshArgument argument(mesh);
  return with_document([&](int* holds, circumspect_document** document) {
    return circumspect_certify(claim.c_str(), argument.get(), holds, document);
  });
}

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

// (points, segments, polygons as lists of lines, hole seeds, fills the hull?)
py::tuple generate_domain(const std::string& name, std::size_t max_points, std::uint64_t seed) {
  const generators::ComplexFamily* const family = properties::find_domain_family(name);
  if (family == nullptr) {
    throw std::invalid_argument("expected the name of a family of domains, found '" + name + "'");
  }
  const PiecewiseLinearInput input =
      generators::in_doubles(generators::drawn(*family, max_points, seed)).input;
  py::list polygons;
  for (const PolygonLines& polygon : input.polygons) polygons.append(py::cast(polygon.lines));
  return py::make_tuple(arrays_of({input.points}, family->dimension)[0], input.segments, polygons,
                        arrays_of({input.hole_seeds}, family->dimension)[0],
                        input.kind == DomainKind::kHull);
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
    for (const Point& point : set.points) {
      for (const Rational& x : point) {
        if (exact_value(x.get_d()) != x) return false;
      }
    }
    const py::tuple arrays = arrays_of(set, dimension);
    return still_fails(arrays[0], arrays[1]);
  };
  return arrays_of(
      generators::minimised(set_of(points, weights), fails,
                            {.tries = tries, .time = std::chrono::duration<double>(seconds)}),
      dimension);
}

}  // namespace
}  // namespace circumspect

PYBIND11_MODULE(_core, module) {
  using namespace circumspect;
  py::register_exception<InputError>(module, "InputError", PyExc_ValueError);
  py::register_exception<NoTriangulation>(module, "NoTriangulation", PyExc_LookupError);
  py::register_exception<Undecided>(module, "Undecided", PyExc_RuntimeError);
  module.attr("version") = circumspect_version();
  module.def("check", &check);
  module.def("delaunay", &delaunay);
  module.def("constrained_delaunay", &constrained_delaunay);
  module.def("predicate", &predicate);
  module.def("compare", &compare);
  module.def("certify", &certify);
  module.def("inspect", &inspect);
  module.def("families", &families);
  module.def("domain_families", &domain_families);
  module.def("generate", &generate);
  module.def("generate_exact", &generate_exact);
  module.def("generate_domain", &generate_domain);
  module.def("drawn_case", &drawn_case);
  module.def("minimized", &minimized);
}
