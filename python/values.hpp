// Values of C++ made of Python's objects, and the other way. Only what Python promises to keep is
// called (PEP 384), so that one module serves Python 3.11 and all that come after it.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <Python.h>

namespace circumspect::python {

// Thrown where Python has been told of an error already: whoever is called by it returns NULL.
struct Raised {};

// Thrown to raise an exception of this type.
struct Failure {
  PyObject* type;
  std::string message;
};

// One reference to an object, or none.
class Object {
 public:
  Object() = default;
  // Takes over the reference that a call returned. Throws Raised if it returned NULL.
  static Object owned(PyObject* made) {
    if (made == nullptr) throw Raised();
    return Object(made);
  }
  static Object shared(PyObject* borrowed) {
    Py_XINCREF(borrowed);
    return Object(borrowed);
  }
  Object(const Object& other) : object_(other.object_) { Py_XINCREF(object_); }
  Object(Object&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
  Object& operator=(Object other) noexcept {
    std::swap(object_, other.object_);
    return *this;
  }
  ~Object() { Py_XDECREF(object_); }

  PyObject* get() const { return object_; }
  // The caller has the reference now.
  PyObject* release() { return std::exchange(object_, nullptr); }
  bool is_none() const { return object_ == nullptr || object_ == Py_None; }

 private:
  explicit Object(PyObject* object) : object_(object) {}

  PyObject* object_ = nullptr;
};

inline void require(bool is_well) {
  if (!is_well) throw Raised();
}

template <class Value, template <class...> class Template>
inline constexpr bool is_a = false;
template <class... Parts, template <class...> class Template>
inline constexpr bool is_a<Template<Parts...>, Template> = true;

template <class Value>
Value value_of(PyObject* object);

// The integers of Python are of any size: one that does not fit is a ValueError that says so.
template <class Value>
Value integer_of(PyObject* object) {
  using Widest = std::conditional_t<std::is_signed_v<Value>, long long, unsigned long long>;
  const Object index = Object::owned(PyNumber_Index(object));
  Widest value = 0;
  if constexpr (std::is_signed_v<Value>) {
    value = PyLong_AsLongLong(index.get());
  } else {
    value = PyLong_AsUnsignedLongLong(index.get());
  }
  const bool is_too_wide = value == static_cast<Widest>(-1) && PyErr_Occurred() != nullptr;
  if (!is_too_wide && std::in_range<Value>(value)) return static_cast<Value>(value);
  PyErr_Clear();
  const Object found = Object::owned(PyObject_Str(index.get()));
  Py_ssize_t size = 0;
  const char* const text = PyUnicode_AsUTF8AndSize(found.get(), &size);
  require(text != nullptr);
  throw Failure{PyExc_ValueError,
                "expected an integer from " + std::to_string(std::numeric_limits<Value>::min()) +
                    " to " + std::to_string(std::numeric_limits<Value>::max()) + ", found " +
                    std::string(text, static_cast<std::size_t>(size))};
}

template <class List>
List list_of(PyObject* object) {
  const Object items = Object::owned(PySequence_List(object));
  List values;
  for (Py_ssize_t i = 0; i < PyList_Size(items.get()); ++i) {
    values.push_back(value_of<typename List::value_type>(PyList_GetItem(items.get(), i)));
  }
  return values;
}

template <class Tuple, std::size_t... kPlaces>
Tuple tuple_of(PyObject* object, std::index_sequence<kPlaces...> /*places*/) {
  if (PyTuple_Check(object) == 0 ||
      PyTuple_Size(object) != static_cast<Py_ssize_t>(sizeof...(kPlaces))) {
    throw Failure{PyExc_TypeError,
                  "expected a tuple of " + std::to_string(sizeof...(kPlaces)) + " values"};
  }
  return Tuple{value_of<std::tuple_element_t<kPlaces, Tuple>>(
      PyTuple_GetItem(object, static_cast<Py_ssize_t>(kPlaces)))...};
}

// Throws Raised or Failure if the object is no such value. A class that is none of these is made of
// the object by its constructor.
template <class Value>
Value value_of(PyObject* object) {
  if constexpr (std::is_same_v<Value, Object>) {
    return Object::shared(object);
  } else if constexpr (std::is_same_v<Value, bool>) {
    const int is_true = PyObject_IsTrue(object);
    require(is_true >= 0);
    return is_true == 1;
  } else if constexpr (std::is_floating_point_v<Value>) {
    const double value = PyFloat_AsDouble(object);
    require(value != -1 || PyErr_Occurred() == nullptr);
    return value;
  } else if constexpr (std::is_integral_v<Value>) {
    return integer_of<Value>(object);
  } else if constexpr (std::is_same_v<Value, std::string>) {
    Py_ssize_t size = 0;
    const char* const text = PyUnicode_AsUTF8AndSize(object, &size);
    require(text != nullptr);
    return {text, static_cast<std::size_t>(size)};
  } else if constexpr (is_a<Value, std::optional>) {
    if (object == Py_None) return std::nullopt;
    return value_of<typename Value::value_type>(object);
  } else if constexpr (is_a<Value, std::vector>) {
    return list_of<Value>(object);
  } else if constexpr (is_a<Value, std::pair> || is_a<Value, std::tuple>) {
    return tuple_of<Value>(object, std::make_index_sequence<std::tuple_size_v<Value>>());
  } else {
    return Value(object);
  }
}

// An empty optional is None, and so is a null pointer for a text.
template <class Value>
Object object_of(const Value& value) {
  if constexpr (std::is_same_v<Value, Object>) {
    return value.get() == nullptr ? Object::shared(Py_None) : value;
  } else if constexpr (std::is_same_v<Value, bool>) {
    return Object::owned(PyBool_FromLong(value ? 1 : 0));
  } else if constexpr (std::is_floating_point_v<Value>) {
    return Object::owned(PyFloat_FromDouble(value));
  } else if constexpr (std::is_integral_v<Value> && std::is_signed_v<Value>) {
    return Object::owned(PyLong_FromLongLong(value));
  } else if constexpr (std::is_integral_v<Value>) {
    return Object::owned(PyLong_FromUnsignedLongLong(value));
  } else if constexpr (std::is_same_v<Value, const char*>) {
    if (value == nullptr) return Object::shared(Py_None);
    return Object::owned(PyUnicode_FromString(value));
  } else if constexpr (std::is_convertible_v<Value, std::string_view>) {
    const std::string_view text = value;
    return Object::owned(
        PyUnicode_FromStringAndSize(text.data(), static_cast<Py_ssize_t>(text.size())));
  } else if constexpr (is_a<Value, std::optional>) {
    return value ? object_of(*value) : Object::shared(Py_None);
  } else if constexpr (is_a<Value, std::pair> || is_a<Value, std::tuple>) {
    Object all = Object::owned(PyTuple_New(static_cast<Py_ssize_t>(std::tuple_size_v<Value>)));
    Py_ssize_t place = 0;
    const auto add = [&](const auto& part) {
      require(PyTuple_SetItem(all.get(), place++, object_of(part).release()) == 0);
    };
    std::apply([&](const auto&... parts) { (add(parts), ...); }, value);
    return all;
  } else {
    Object all = Object::owned(PyList_New(0));
    for (const auto& part : value) {
      require(PyList_Append(all.get(), object_of(part).get()) == 0);
    }
    return all;
  }
}

// What a Python function returns for these arguments.
template <class... Arguments>
Object called(const Object& function, const Arguments&... arguments) {
  const Object all = object_of(std::make_tuple(object_of(arguments)...));
  return Object::owned(PyObject_CallObject(function.get(), all.get()));
}

}  // namespace circumspect::python
