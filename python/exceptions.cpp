#include "python/exceptions.hpp"

#include <new>
#include <string>
#include <string_view>
#include <utility>

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

// The C interface names its own options; the package names them differently.
std::string in_words_of_python(std::string message) {
  for (const auto& [own, word] : {std::pair{"set merge_equal_points", "give duplicates=\"merge\""},
                                  std::pair{"set allow_empty", "give allow_empty=True"}}) {
    const std::size_t place = message.find(own);
    if (place != std::string::npos) message.replace(place, std::string_view(own).size(), word);
  }
  return message;
}

}  // namespace

void add_exceptions(PyObject* module) {
  input_error = added(module, "InputError", PyExc_ValueError);
  no_triangulation = added(module, "NoTriangulation", PyExc_LookupError);
  undecided = added(module, "Undecided", PyExc_RuntimeError);
}

void require_ok(const Outcome& outcome) {
  const std::string message = in_words_of_python(outcome.message);
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
