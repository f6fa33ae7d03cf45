#include "oracle/formats/rows.hpp"

#include "reference/kernel/exact/number.hpp"

namespace circumspect::formats {
namespace {

template <class Value, class ToText>
std::string join(const std::vector<Value>& values, ToText to_text) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) text += " ";
    text += to_text(values[i]);
  }
  return text;
}

}  // namespace

std::string joined(const std::vector<Rational>& numbers) {
  return join(numbers, to_text_of_double_or_fraction);
}

std::string joined(const std::vector<Vertex>& indices) {
  return join(indices, [](Vertex v) { return std::to_string(v); });
}

}  // namespace circumspect::formats
