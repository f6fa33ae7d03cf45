#include "fuzz/harness/node_text.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace circumspect::harness {

std::string node_text(const PointArray& points) {
  const bool weighted = !points.weights.empty();
  std::string text = fmt::format("{} {} {} 0\n", points.size(), points.dimension, weighted ? 1 : 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    text += std::to_string(i);
    for (std::size_t axis = 0; axis < points.dimension; ++axis) {
      text += fmt::format(" {}", points.point(i)[axis]);
    }
    if (weighted) text += fmt::format(" {}", points.weights[i]);
    text += '\n';
  }
  return text;
}

bool are_doubles(const generators::PointsCase& set) {
  const auto is_double = [](const Rational& value) { return exact_value(value.get_d()) == value; };
  return std::all_of(set.weights.begin(), set.weights.end(), is_double) &&
         std::all_of(set.points.begin(), set.points.end(), [&](const Point& point) {
           return std::all_of(point.begin(), point.end(), is_double);
         });
}

}  // namespace circumspect::harness
