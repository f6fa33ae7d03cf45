// circumspect._core: the C interface, for the package around it; inputs.cpp has the families of
// inputs. Arrays come in as the package has made them: doubles and indices in C order, or exact
// numbers as texts.
#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <circumspect/circumspect.h>

#include "python/arguments.hpp"
#include "python/arrays.hpp"
#include "python/exceptions.hpp"
#include "python/functions.hpp"
#include "python/inputs.hpp"
#include "python/long_calls.hpp"
#include "python/signs.hpp"
#include "python/values.hpp"

#ifdef CIRCUMSPECT_HAS_COMMAND
namespace circumspect::cli {
int command_line(int argc, char** argv);  // command/main.cpp
}
#endif

namespace circumspect::python {

namespace {

using OwnDocument = std::unique_ptr<circumspect_document, decltype(&circumspect_document_free)>;

std::string page_of(const circumspect_verdict* verdict) {
  circumspect_document* page = nullptr;
  const circumspect_status status = circumspect_verdict_page(verdict, &page);
  require_ok(outcome_of(status));
  const OwnDocument own(page, circumspect_document_free);
  return circumspect_document_text(page);
}

// A function without arguments that returns the page of a verdict, which it keeps.
Object page_function(std::shared_ptr<circumspect_verdict> own) {
  using Own = std::shared_ptr<circumspect_verdict>;
  constexpr const char* kName = "circumspect.verdict";
  static PyMethodDef method = {"page",
                               [](PyObject* capsule, PyObject* /*none*/) -> PyObject* {
                                 return answer_of([&] {
                                   const auto* const kept =
                                       static_cast<Own*>(PyCapsule_GetPointer(capsule, kName));
                                   require(kept != nullptr);
                                   return object_of(page_of(kept->get()));
                                 });
                               },
                               METH_NOARGS, nullptr};
  auto kept = std::make_unique<Own>(std::move(own));
  const Object capsule = Object::owned(PyCapsule_New(kept.get(), kName, [](PyObject* ended) {
    delete static_cast<Own*>(PyCapsule_GetPointer(ended, kName));
  }));
  static_cast<void>(kept.release());  // the capsule's
  return Object::owned(PyCFunction_NewEx(&method, capsule.get(), nullptr));
}

// (claim, holds, unique, canonical, text, json, rules, notes, page), with −1 for facts that are not
// known; `page` is a function without arguments that returns HTML, or None. `brief`: neither JSON
// nor page.
Object parts_of(const std::shared_ptr<circumspect_verdict>& own, bool brief) {
  const circumspect_verdict* const verdict = own.get();
  const Object rules = Object::owned(PyDict_New());
  for (std::int64_t i = 0; i < circumspect_verdict_rule_count(verdict); ++i) {
    std::int64_t count = 0;
    const char* const rule = circumspect_verdict_rule(verdict, i, &count);
    require(PyDict_SetItemString(rules.get(), rule, object_of(count).get()) == 0);
  }
  std::vector<std::string> notes;
  for (std::int64_t i = 0; i < circumspect_verdict_note_count(verdict); ++i) {
    notes.emplace_back(circumspect_verdict_note(verdict, i));
  }
  return object_of(
      std::make_tuple(circumspect_verdict_claim(verdict), circumspect_verdict_holds(verdict) == 1,
                      circumspect_verdict_unique(verdict), circumspect_verdict_canonical(verdict),
                      circumspect_verdict_text(verdict), circumspect_verdict_json(verdict), rules,
                      notes, brief ? Object() : page_function(own)));
}

// See parts_of. No claim: the default one. `brief`: for a mesh that is judged quickly.
Object check(const std::optional<std::string>& claim, const MeshArgument& mesh,
             const std::optional<Object>& domain, std::int64_t threads, std::int64_t max_violations,
             bool by_definition, bool oriented, bool merge, bool allow_empty,
             const std::optional<std::string>& within, const std::string& demands,
             const std::string& name, double limit, bool brief,
             const std::optional<std::vector<std::string>>& requirements,
             const std::optional<std::string>& except_sharp, const std::optional<Doubles>& lattice,
             const std::optional<Indices>& offsets) {
  std::vector<const char*> required;
  if (requirements) {
    for (const std::string& text : *requirements) required.push_back(text.c_str());
  }
  std::optional<DomainArgument> about;
  if (domain) about.emplace(domain->get());
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
        circumspect_check(claim ? claim->c_str() : nullptr, mesh.get(),
                          about ? about->get() : nullptr, &options, &made);
    own.reset(made, circumspect_verdict_free);
    return status;
  };
  require_ok(brief ? made_here(call) : made(call, limit));
  return parts_of(own, brief);
}

// What `check` returns, of cells: rows of sites, of vertices, of pairs of sites; starts and corners
// of the cells; the two corners of a box, or nothing.
Object check_voronoi(std::int64_t dimension, const Doubles& sites, const Doubles& vertices,
                     const Indices& cell_starts, const Indices& corners, const Indices& ridges,
                     const Indices& ridge_starts, const Indices& ridge_ends,
                     const std::optional<Doubles>& box, const std::string& within,
                     std::int64_t max_violations, bool by_definition, const std::string& name,
                     double limit, const std::string& demands) {
  circumspect_voronoi diagram = CIRCUMSPECT_VORONOI;
  diagram.dimension = dimension;
  diagram.site_count = static_cast<std::int64_t>(sites.size()) / dimension;
  diagram.sites = sites.data();
  diagram.vertex_count = static_cast<std::int64_t>(vertices.size()) / dimension;
  diagram.vertices = vertices.data();
  diagram.cell_starts = cell_starts.data();
  diagram.corners = corners.data();
  diagram.ridge_count = static_cast<std::int64_t>(ridges.size()) / 2;
  diagram.ridges = ridges.data();
  diagram.ridge_starts = ridge_starts.data();
  diagram.ridge_ends = ridge_ends.data();
  diagram.box = box ? box->data() : nullptr;
  circumspect_options options = CIRCUMSPECT_OPTIONS;
  options.max_violations = max_violations;
  options.by_definition = by_definition ? 1 : 0;
  options.within = within.c_str();
  options.demands = demands.c_str();
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
  return parts_of(own, false);
}

// Rows of `vertices` indices.
Object rows_of(const circumspect_triangulation* built, std::int64_t vertices) {
  const std::int64_t* indices = nullptr;
  const auto count =
      static_cast<std::size_t>(circumspect_triangulation_simplices(built, vertices, &indices));
  const auto columns = static_cast<std::size_t>(vertices);
  return new_array({count, columns}, std::span(indices, count * columns));
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

Object delaunay(const MeshArgument& points) {
  const OwnTriangulation own = built_by(
      [&](circumspect_triangulation** built) { return circumspect_delaunay(points.get(), built); });
  const circumspect_triangulation* const built = own.get();
  return rows_of(built, std::max<std::int64_t>(circumspect_triangulation_dimension(built), 0) + 1);
}

// Simplices, and those that dangle: with three, two and one vertices.
Object constrained_delaunay(const Object& domain) {
  const DomainArgument argument(domain.get());
  const OwnTriangulation own = built_by([&](circumspect_triangulation** built) {
    return circumspect_constrained_delaunay(argument.get(), built);
  });
  const circumspect_triangulation* const built = own.get();
  const std::int64_t vertices = circumspect_triangulation_dimension(built) + 1;
  return object_of(std::make_tuple(
      rows_of(built, vertices),
      vertices == 4 ? rows_of(built, 3) : new_array({0, 3}, std::span<const std::int64_t>()),
      rows_of(built, 2), rows_of(built, 1)));
}

// The answer, and the text of the document.
std::pair<bool, std::string> with_document(
    const std::function<circumspect_status(int*, circumspect_document**)>& call) {
  int answer = 0;
  OwnDocument own(nullptr, circumspect_document_free);
  require_ok(made([&] {
    circumspect_document* document = nullptr;
    const circumspect_status status = call(&answer, &document);
    own.reset(document);
    return status;
  }));
  return {answer == 1, circumspect_document_text(own.get())};
}

std::pair<bool, std::string> compare(const MeshArgument& a, const MeshArgument& b) {
  return with_document([&](int* same, circumspect_document** document) {
    return circumspect_compare(a.get(), b.get(), same, document);
  });
}

std::pair<bool, std::string> inspect(const MeshArgument& points) {
  return with_document([&](int* unique, circumspect_document** document) {
    return circumspect_inspect(points.get(), unique, document);
  });
}

std::pair<bool, std::string> certify(const std::string& claim, const MeshArgument& mesh) {
  return with_document([&](int* holds, circumspect_document** document) {
    return circumspect_certify(claim.c_str(), mesh.get(), holds, document);
  });
}

#ifdef CIRCUMSPECT_HAS_COMMAND
// The words of a command line, the program's name first.
int command(std::vector<std::string> words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return cli::command_line(static_cast<int>(words.size()), pointers.data());
}
#endif

std::optional<int> end_of_interpreter() {
  stop_all_calls();
  return std::nullopt;
}

Object new_module() {
  static std::array methods = {
      method<&check>("check"),
      method<&check_voronoi>("check_voronoi"),
      method<&delaunay>("delaunay"),
      method<&constrained_delaunay>("constrained_delaunay"),
      method<&predicate>("predicate"),
      method<&plain_predicate>("plain_predicate"),
      method<&compare>("compare"),
      method<&certify>("certify"),
      method<&inspect>("inspect"),
#ifdef CIRCUMSPECT_HAS_COMMAND
      method<&command>("command"),
#endif
      PyMethodDef{},
  };
  static PyMethodDef at_exit = method<&end_of_interpreter>("end_of_interpreter");
  static PyModuleDef definition = {PyModuleDef_HEAD_INIT,
                                   "_core",
                                   nullptr,
                                   -1,
                                   methods.data(),
                                   nullptr,
                                   nullptr,
                                   nullptr,
                                   nullptr};
  Object module = Object::owned(PyModule_Create(&definition));
  require(PyModule_AddFunctions(module.get(), methods_of_inputs()) == 0);
  add_exceptions(module.get());
  require(PyModule_AddStringConstant(module.get(), "version", circumspect_version()) == 0);
  const Object atexit = Object::owned(PyImport_ImportModule("atexit"));
  const Object add = Object::owned(PyObject_GetAttrString(atexit.get(), "register"));
  called(add, Object::owned(PyCFunction_NewEx(&at_exit, nullptr, nullptr)));
  return module;
}

}  // namespace
}  // namespace circumspect::python

PyMODINIT_FUNC PyInit__core() {
  return circumspect::python::answer_of(circumspect::python::new_module);
}
