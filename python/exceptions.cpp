#include "python/exceptions.hpp"

#include <new>
#include <string>
#include <string_view>

namespace circumspect::python {
namespace {

// They live as long as the process.
PyObject* input_error = nullptr;
PyObject* no_triangulation = nullptr;
PyObject* undecided = nullptr;

PyObject* added(PyObject* module, const char* name, PyObject* base) {
  const std::string in_module = std::string("circumspect._core.") + name;
  Object type = Object::owned(PyErr_NewException(in_module.c_str(), base, nullptr));
  require(PyObject_SetAttrString(module, name, type.get()) == 0);
  return type.release();
}

// What to do, in words of the package, by the option of the C interface that would settle a fault.
std::string_view advice_of(std::string_view option) {
  if (option == "merge_equal_points") {
    return "; to take equal points for one, give duplicates=\"merge\"";
  }
  if (option == "allow_empty") return "; to judge an empty mesh, give allow_empty=True";
  return "";
}

}  // namespace

void add_exceptions(PyObject* module) {
  input_error = added(module, "InputError", PyExc_ValueError);
  no_triangulation = added(module, "NoTriangulation", PyExc_LookupError);
  undecided = added(module, "Undecided", PyExc_RuntimeError);
}

void require_ok(const Outcome& outcome) {
  const std::string message = outcome.fault + std::string(advice_of(outcome.option));
  switch (outcome.status) {
    case CIRCUMSPECT_OK:
      return;
    case CIRCUMSPECT_INVALID_ARGUMENT:
      throw Failure{PyExc_ValueError, message};
    case CIRCUMSPECT_INPUT_FAULT:
      throw Failure{input_error, message};
    case CIRCUMSPECT_NONE:
      throw Failure{no_triangulation, message};
    case CIRCUMSPECT_UNDECIDED:
      throw Failure{undecided, message};
    case CIRCUMSPECT_OUT_OF_MEMORY:
      throw std::bad_alloc();
    case CIRCUMSPECT_INTERNAL_ERROR:
      break;
  }
  throw Failure{PyExc_RuntimeError, message};
}

}  // namespace circumspect::python
