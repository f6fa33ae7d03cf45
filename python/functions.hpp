// Functions of C++ as functions of Python.
#pragma once

#include <array>
#include <cstddef>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include "python/values.hpp"

namespace circumspect::python {

// Makes the call, and returns its reference; or tells Python what was thrown, and returns NULL.
// What ends a thread passes.
template <class Call>
PyObject* answer_of(const Call& call) {
  try {
    return call().release();
  } catch (const Raised&) {
  } catch (const Failure& failure) {
    PyErr_SetString(failure.type, failure.message.c_str());
  } catch (const std::bad_alloc&) {
    PyErr_NoMemory();
  } catch (const std::out_of_range& error) {
    PyErr_SetString(PyExc_IndexError, error.what());
  } catch (const std::logic_error& error) {
    PyErr_SetString(PyExc_ValueError, error.what());
  } catch (const std::exception& error) {
    PyErr_SetString(PyExc_RuntimeError, error.what());
  }
  return nullptr;
}

template <auto kFunction>
struct Exposed;

// Takes its arguments by place; the last ones may be left out where they are optional.
template <class Result, class... Arguments, Result (*kFunction)(Arguments...)>
struct Exposed<kFunction> {
  static PyObject* call(PyObject* /*module*/, PyObject* const* arguments, Py_ssize_t count) {
    return answer_of([&] {
      return with(arguments, static_cast<std::size_t>(count),
                  std::index_sequence_for<Arguments...>());
    });
  }

 private:
  template <std::size_t... kPlaces>
  static Object with(PyObject* const* given, std::size_t count,
                     std::index_sequence<kPlaces...> /*places*/) {
    constexpr std::size_t kWanted = sizeof...(Arguments);
    constexpr std::array<bool, kWanted + 1> kMayLack = {
        is_a<std::remove_cvref_t<Arguments>, std::optional>..., true};
    if (count > kWanted || !kMayLack[count]) {
      throw Failure{PyExc_TypeError, "expected " + std::to_string(kWanted) + " arguments, found " +
                                         std::to_string(count)};
    }
    const std::tuple<std::remove_cvref_t<Arguments>...> all{
        value_of<std::remove_cvref_t<Arguments>>(kPlaces < count ? given[kPlaces] : Py_None)...};
    return object_of(kFunction(std::get<kPlaces>(all)...));
  }
};

template <auto kFunction>
PyMethodDef method(const char* name) {
  PyObject* (*const call)(PyObject*, PyObject* const*, Py_ssize_t) = &Exposed<kFunction>::call;
  return {name, reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(call)), METH_FASTCALL,
          nullptr};
}

}  // namespace circumspect::python
