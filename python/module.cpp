// circumspect._core: the C interface, for the package around it; inputs.cpp has the families of
// inputs. Arrays come in as the package has made them: doubles and indices in C order, or exact
// numbers as texts.
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <circumspect/circumspect.h>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "python/long_calls.hpp"

namespace py = pybind11;

namespace circumspect {

void bind_inputs(py::module_& module);  // inputs.cpp

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

// The C interface names its own options; the package names them differently.
std::string in_words_of_python(std::string message) {
  for (const auto& [own, word] : {std::pair{"set merge_equal_points", "give duplicates=\"merge\""},
                                  std::pair{"set allow_empty", "give allow_empty=True"}}) {
    const std::size_t place = message.find(own);
    if (place != std::string::npos) message.replace(place, std::string_view(own).size(), word);
  }
  return message;
}

void require_ok(const Outcome& outcome) {
  const std::string message = in_words_of_python(outcome.message);
  switch (outcome.status) {
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

using OwnDocument = std::unique_ptr<circumspect_document, decltype(&circumspect_document_free)>;
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
      pointers_.push_back(nullptr);  // so that there is an array, even if it is empty
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

// A mesh as the package passes it: (dimension, coordinates, weights, simplices, neighbors,
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
  py::tuple arrays_;  // these live as long as this
};

// (dimension, coordinates, segments, polygon_starts, line_starts, corners, hole_seeds, kind,
// polygons_of_holes, polygon_hole_seeds, region_seeds, merge_coplanar, resolve)
class DomainArgument {
 public:
  explicit DomainArgument(const py::tuple& parts)
      : coordinates_(parts[1]),
        segments_(parts[2].cast<Indices>()),
        polygons_(parts[3].cast<Indices>()),
        lines_(parts[4].cast<Indices>()),
        corners_(parts[5].cast<Indices>()),
        holes_(parts[6]),
        polygons_of_holes_(parts[8].cast<Indices>()),
        polygon_holes_(parts[9]),
        regions_(parts[10]) {
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
    domain_.hole_seeds = holes_.doubles();
    domain_.exact_hole_seeds = holes_.texts();
    domain_.kind = parts[7].cast<std::int32_t>();
    domain_.polygon_hole_count = polygons_of_holes_.size();
    domain_.polygons_of_holes = polygons_of_holes_.data();
    domain_.polygon_hole_seeds = polygon_holes_.doubles();
    domain_.exact_polygon_hole_seeds = polygon_holes_.texts();
    domain_.region_count = domain_.dimension > 0 ? regions_.size() / domain_.dimension : 0;
    domain_.region_seeds = regions_.doubles();
    domain_.exact_region_seeds = regions_.texts();
    domain_.merge_coplanar = parts[11].cast<bool>() ? 1 : 0;
    domain_.resolve = parts[12].cast<bool>() ? 1 : 0;
  }
  const circumspect_domain* get() const { return &domain_; }

 private:
  circumspect_domain domain_ = CIRCUMSPECT_DOMAIN;
  NumberList coordinates_;
  Indices segments_, polygons_, lines_, corners_;
  NumberList holes_;
  Indices polygons_of_holes_;
  NumberList polygon_holes_;
  NumberList regions_;
};

std::string page_of(const circumspect_verdict* verdict) {
  circumspect_document* page = nullptr;
  const circumspect_status status = circumspect_verdict_page(verdict, &page);
  require_ok({status, circumspect_last_error()});
  const OwnDocument own(page, circumspect_document_free);
  return circumspect_document_text(page);
}

// (holds, unique, canonical, text, json, rules, notes, page), with −1 for facts that are not known;
// `page` is a function without arguments that returns HTML, or None. `brief`: neither JSON nor
// page.
py::tuple parts_of(std::shared_ptr<circumspect_verdict> own, bool brief) {
  const circumspect_verdict* const verdict = own.get();
  py::dict rules;
  for (std::int64_t i = 0; i < circumspect_verdict_rule_count(verdict); ++i) {
    std::int64_t count = 0;
    const char* const rule = circumspect_verdict_rule(verdict, i, &count);
    rules[rule] = count;
  }
  py::list notes;
  for (std::int64_t i = 0; i < circumspect_verdict_note_count(verdict); ++i) {
    notes.append(circumspect_verdict_note(verdict, i));
  }
  py::object page = py::none();
  if (!brief) page = py::cpp_function([own] { return page_of(own.get()); });
  return py::make_tuple(circumspect_verdict_claim(verdict), circumspect_verdict_holds(verdict) == 1,
                        circumspect_verdict_unique(verdict), circumspect_verdict_canonical(verdict),
                        circumspect_verdict_text(verdict), circumspect_verdict_json(verdict), rules,
                        notes, page);
}

// See parts_of. No claim: the default one. `brief`: for a mesh that is judged quickly.
py::tuple check(const std::optional<std::string>& claim, const py::tuple& mesh,
                const std::optional<py::tuple>& domain, std::int64_t threads,
                std::int64_t max_violations, bool by_definition, bool oriented, bool merge,
                bool allow_empty, const std::optional<std::string>& within,
                const std::string& demands, const std::string& name, double limit, bool brief,
                const std::vector<std::string>& requirements,
                const std::optional<std::string>& except_sharp,
                const std::optional<Doubles>& lattice, const std::optional<Indices>& offsets) {
  const MeshArgument argument(mesh);
  std::vector<const char*> required;
  for (const std::string& text : requirements) required.push_back(text.c_str());
  std::optional<DomainArgument> about;
  if (domain) about.emplace(*domain);
  circumspect_options options = CIRCUMSPECT_OPTIONS;
  options.threads = threads;
  options.max_violations = max_violations;
  options.by_definition = by_definition ? 1 : 0;
  options.oriented = oriented ? 1 : 0;
  options.merge_equal_points = merge ? 1 : 0;
  options.allow_empty = allow_empty ? 1 : 0;
  options.within = within ? within->c_str() : nullptr;
  options.demands = demands.c_str();
  options.mesh_name = name.c_str();
  options.without_json = brief ? 1 : 0;
  options.with_pictures = brief ? 0 : 1;
  options.require_count = static_cast<std::int64_t>(required.size());
  options.require = required.data();
  options.except_sharp = except_sharp ? except_sharp->c_str() : nullptr;
  options.lattice = lattice ? lattice->data() : nullptr;
  options.offsets = offsets ? offsets->data() : nullptr;
  std::shared_ptr<circumspect_verdict> own;
  const auto call = [&] {
    circumspect_verdict* made = nullptr;
    const circumspect_status status =
        circumspect_check(claim ? claim->c_str() : nullptr, argument.get(),
                          about ? about->get() : nullptr, &options, &made);
    own.reset(made, circumspect_verdict_free);
    return status;
  };
  require_ok(brief ? made_here(call) : made(call, limit));
  return parts_of(std::move(own), brief);
}

// What `check` returns, of cells: rows of sites, of vertices, of pairs of sites; starts and corners
// of the cells; the two corners of a box, or nothing.
py::tuple check_voronoi(std::int64_t dimension, const Doubles& sites, const Doubles& vertices,
                        const Indices& cell_starts, const Indices& corners, const Indices& ridges,
                        const std::optional<Doubles>& box, const std::string& within,
                        std::int64_t max_violations, bool by_definition, const std::string& name,
                        double limit) {
  circumspect_voronoi diagram = CIRCUMSPECT_VORONOI;
  diagram.dimension = dimension;
  diagram.site_count = sites.size() / dimension;
  diagram.sites = sites.data();
  diagram.vertex_count = vertices.size() / dimension;
  diagram.vertices = vertices.data();
  diagram.cell_starts = cell_starts.data();
  diagram.corners = corners.data();
  diagram.ridge_count = ridges.size() / 2;
  diagram.ridges = ridges.data();
  diagram.box = box ? box->data() : nullptr;
  circumspect_options options = CIRCUMSPECT_OPTIONS;
  options.max_violations = max_violations;
  options.by_definition = by_definition ? 1 : 0;
  options.within = within.c_str();
  options.mesh_name = name.c_str();
  options.with_pictures = 1;
  std::shared_ptr<circumspect_verdict> own;
  require_ok(made(
      [&] {
        circumspect_verdict* judged = nullptr;
        const circumspect_status status = circumspect_check_voronoi(&diagram, &options, &judged);
        own.reset(judged, circumspect_verdict_free);
        return status;
      },
      limit));
  return parts_of(std::move(own), false);
}

// Rows of `vertices` indices.
Indices rows_of(const circumspect_triangulation* built, std::int64_t vertices) {
  const std::int64_t* indices = nullptr;
  const std::int64_t count = circumspect_triangulation_simplices(built, vertices, &indices);
  return Indices({count, vertices}, indices);
}

using OwnTriangulation =
    std::unique_ptr<circumspect_triangulation, decltype(&circumspect_triangulation_free)>;

OwnTriangulation built_by(
    const std::function<circumspect_status(circumspect_triangulation**)>& call) {
  OwnTriangulation own(nullptr, circumspect_triangulation_free);
  require_ok(made([&] {
    circumspect_triangulation* built = nullptr;
    const circumspect_status status = call(&built);
    own.reset(built);
    return status;
  }));
  return own;
}

Indices delaunay(const py::tuple& points) {
  const MeshArgument argument(points);
  const OwnTriangulation own = built_by([&](circumspect_triangulation** built) {
    return circumspect_delaunay(argument.get(), built);
  });
  const circumspect_triangulation* const built = own.get();
  return rows_of(built, std::max<std::int64_t>(circumspect_triangulation_dimension(built), 0) + 1);
}

// Simplices, and those that dangle: with three, two and one vertices.
py::tuple constrained_delaunay(const py::tuple& domain) {
  const DomainArgument argument(domain);
  const OwnTriangulation own = built_by([&](circumspect_triangulation** built) {
    return circumspect_constrained_delaunay(argument.get(), built);
  });
  const circumspect_triangulation* const built = own.get();
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
  const circumspect_status status =
      coordinates.doubles() != nullptr
          ? (in_ball ? circumspect_in_ball : circumspect_orientation)(dimension,
                                                                      coordinates.doubles(), &sign)
          : (in_ball ? circumspect_in_ball_exact : circumspect_orientation_exact)(
                dimension, coordinates.texts(), &sign);
  require_ok({status, circumspect_last_error()});
  return sign;
}

// The answer, and the text of the document.
py::tuple with_document(
    const std::function<circumspect_status(int*, circumspect_document**)>& call) {
  int answer = 0;
  OwnDocument own(nullptr, circumspect_document_free);
  require_ok(made([&] {
    circumspect_document* document = nullptr;
    const circumspect_status status = call(&answer, &document);
    own.reset(document);
    return status;
  }));
  return py::make_tuple(answer == 1, circumspect_document_text(own.get()));
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

}  // namespace
}  // namespace circumspect

PYBIND11_MODULE(_core, module) {
  using namespace circumspect;
  py::register_exception<InputError>(module, "InputError", PyExc_ValueError);
  py::register_exception<NoTriangulation>(module, "NoTriangulation", PyExc_LookupError);
  py::register_exception<Undecided>(module, "Undecided", PyExc_RuntimeError);
  module.attr("version") = circumspect_version();
  module.def("check", &check, py::arg("claim"), py::arg("mesh"), py::arg("domain"),
             py::arg("threads"), py::arg("max_violations"), py::arg("by_definition"),
             py::arg("oriented"), py::arg("merge"), py::arg("allow_empty"), py::arg("within"),
             py::arg("demands"), py::arg("name"), py::arg("limit"), py::arg("brief"),
             py::arg("require") = std::vector<std::string>(), py::arg("except_sharp") = py::none(),
             py::arg("lattice") = py::none(), py::arg("offsets") = py::none());
  module.def("check_voronoi", &check_voronoi);
  module.def("delaunay", &delaunay);
  module.def("constrained_delaunay", &constrained_delaunay);
  module.def("predicate", &predicate);
  module.def("compare", &compare);
  module.def("certify", &certify);
  module.def("inspect", &inspect);
  py::module_::import("atexit").attr("register")(py::cpp_function(&stop_all_calls));
  circumspect::bind_inputs(module);
}
