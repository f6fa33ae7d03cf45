#include "python/arrays.hpp"

#include <cstring>
#include <string_view>
#include <utility>

namespace circumspect::python {
namespace {

Object filled(const std::vector<std::size_t>& shape, const char* type, const void* numbers,
              std::size_t bytes) {
  const Object numpy = Object::owned(PyImport_ImportModule("numpy"));
  const Object empty = Object::owned(PyObject_GetAttrString(numpy.get(), "empty"));
  Object lengths = Object::owned(PyTuple_New(static_cast<Py_ssize_t>(shape.size())));
  for (std::size_t axis = 0; axis < shape.size(); ++axis) {
    require(PyTuple_SetItem(lengths.get(), static_cast<Py_ssize_t>(axis),
                            object_of(shape[axis]).release()) == 0);
  }
  Object array = called(empty, lengths, type);
  Py_buffer view;
  require(PyObject_GetBuffer(array.get(), &view, PyBUF_WRITABLE | PyBUF_C_CONTIGUOUS) == 0);
  if (bytes > 0) std::memcpy(view.buf, numbers, bytes);
  PyBuffer_Release(&view);
  return array;
}

}  // namespace

Array::Array(PyObject* object) {
  require(PyObject_GetBuffer(object, &view_, PyBUF_C_CONTIGUOUS | PyBUF_FORMAT) == 0);
  const std::string_view format = view_.format == nullptr ? "" : view_.format;
  holds_doubles_ = format == "d";
  const bool holds_integers = format == "i" || format == "l" || format == "q";
  if (!holds_doubles_ && !holds_integers) {
    const std::string found(format);
    PyBuffer_Release(&view_);
    throw Failure{PyExc_TypeError,
                  "expected an array of doubles or of signed integers, found the format " + found};
  }
}

Array::Array(Array&& other) noexcept
    : view_(std::exchange(other.view_, {})), holds_doubles_(other.holds_doubles_) {}

Array::~Array() { PyBuffer_Release(&view_); }

Object new_array(const std::vector<std::size_t>& shape, std::span<const double> numbers) {
  return filled(shape, "d", numbers.data(), numbers.size_bytes());
}

Object new_array(const std::vector<std::size_t>& shape, std::span<const std::int64_t> numbers) {
  return filled(shape, "q", numbers.data(), numbers.size_bytes());
}

}  // namespace circumspect::python
