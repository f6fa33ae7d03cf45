// What the tests of readers have in common: a source that has the name "f", and what a reader complains of.
#pragma once

#include <string>

#include "oracle/formats/format_error.hpp"
#include "oracle/formats/source.hpp"
#include "reference/kernel/exact/number.hpp"

namespace circumspect::formats {

constexpr NumberReading kDouble = NumberReading::kDouble;

inline Source named(const std::string& text) { return {"f", text}; }

template <class T>
std::string error_of(const Result<T>& result) {
  return result ? "no error" : result.error().to_string();
}

}  // namespace circumspect::formats
