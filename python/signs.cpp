#include "python/signs.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include <circumspect/circumspect.h>

#include "python/arguments.hpp"
#include "python/exceptions.hpp"

namespace circumspect::python {
namespace {

int sign_of(bool in_ball, std::int64_t dimension, const double* coordinates) {
  int sign = 0;
  const circumspect_status status =
      (in_ball ? circumspect_in_ball : circumspect_orientation)(dimension, coordinates, &sign);
  require_ok(outcome_of(status));
  return sign;
}

}  // namespace

int predicate(bool in_ball, std::int64_t dimension, const Object& numbers) {
  const NumberList coordinates(numbers.get());
  if (coordinates.size() != dimension * (dimension + (in_ball ? 2 : 1))) {
    throw Failure{PyExc_ValueError,
                  "expected as many coordinates as the points have, found others"};
  }
  if (coordinates.doubles() != nullptr) return sign_of(in_ball, dimension, coordinates.doubles());
  int sign = 0;
  const circumspect_status status =
      (in_ball ? circumspect_in_ball_exact : circumspect_orientation_exact)(
          dimension, coordinates.texts(), &sign);
  require_ok(outcome_of(status));
  return sign;
}

namespace {

// A finite float, or an int that is one as a double; nothing for anything else.
std::optional<double> plain_double(PyObject* number) {
  if (PyFloat_Check(number) != 0) {
    const double value = PyFloat_AsDouble(number);
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
  }
  if (PyLong_CheckExact(number) == 0) return std::nullopt;
  int overflow = 0;
  const long long value = PyLong_AsLongLongAndOverflow(number, &overflow);
  constexpr long long kLargestExact = 1LL << 53;
  if (overflow != 0 || value < -kLargestExact || value > kLargestExact) return std::nullopt;
  return static_cast<double>(value);
}

}  // namespace

std::optional<int> plain_predicate(bool in_ball, const Object& points) {
  const Py_ssize_t count = PyTuple_Size(points.get());
  const Py_ssize_t dimension = count - (in_ball ? 2 : 1);
  constexpr Py_ssize_t kMost = 3;
  if (dimension < 1 || dimension > kMost) return std::nullopt;
  std::array<double, kMost*(kMost + 2)> coordinates{};
  std::size_t place = 0;
  for (Py_ssize_t i = 0; i < count; ++i) {
    PyObject* const point = PyTuple_GetItem(points.get(), i);
    const bool is_tuple = PyTuple_CheckExact(point) != 0;
    if (!is_tuple && PyList_CheckExact(point) == 0) return std::nullopt;
    if ((is_tuple ? PyTuple_Size(point) : PyList_Size(point)) != dimension) return std::nullopt;
    for (Py_ssize_t axis = 0; axis < dimension; ++axis) {
      const std::optional<double> value =
          plain_double(is_tuple ? PyTuple_GetItem(point, axis) : PyList_GetItem(point, axis));
      if (!value) return std::nullopt;
      coordinates[place++] = *value;
    }
  }
  return sign_of(in_ball, dimension, coordinates.data());
}

}  // namespace circumspect::python
