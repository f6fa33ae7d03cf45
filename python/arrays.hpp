// Arrays of NumPy, read where they are (PEP 3118), and made.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "python/values.hpp"

namespace circumspect::python {

// An array of doubles or of signed integers in C order. The object that it belongs to keeps its
// memory where it is as long as this exists.
class Array {
 public:
  // Throws Raised if the object is not an array in C order, Failure if it is one of other numbers.
  explicit Array(PyObject* object);
  Array(Array&& other) noexcept;
  Array& operator=(Array&&) = delete;
  ~Array();

  bool holds_doubles() const { return holds_doubles_; }
  std::size_t bytes_of_one() const { return static_cast<std::size_t>(view_.itemsize); }
  std::size_t size() const { return static_cast<std::size_t>(view_.len / view_.itemsize); }
  // Requires: an axis that there is.
  std::int64_t length(std::size_t axis) const { return view_.shape[axis]; }
  std::size_t axes() const { return static_cast<std::size_t>(view_.ndim); }
  const void* data() const { return view_.buf; }

 private:
  Py_buffer view_ = {};
  bool holds_doubles_ = false;
};

// Of numbers of one type.
template <class Number>
class ArrayOf : public Array {
 public:
  explicit ArrayOf(PyObject* object) : Array(object) {
    if (holds_doubles() != std::is_same_v<Number, double> || bytes_of_one() != sizeof(Number)) {
      throw Failure{PyExc_TypeError, std::is_same_v<Number, double>
                                         ? "expected an array of doubles, found other numbers"
                                         : "expected an array of int64, found other numbers"};
    }
  }
  const Number* data() const { return static_cast<const Number*>(Array::data()); }
  std::span<const Number> numbers() const { return {data(), size()}; }
};

using Doubles = ArrayOf<double>;
using Indices = ArrayOf<std::int64_t>;

// A new array of NumPy with a copy of these numbers, in C order. Requires: as many as the shape
// says.
Object new_array(const std::vector<std::size_t>& shape, std::span<const double> numbers);
Object new_array(const std::vector<std::size_t>& shape, std::span<const std::int64_t> numbers);

}  // namespace circumspect::python
