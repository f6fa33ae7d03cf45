#include "fuzz/campaign/by_hand_script.hpp"

#include <cstdint>

#include <fmt/format.h>

namespace circumspect::campaign {
namespace {

using report::Json;

// ["1/3", "2"] → "(F('1/3'), F('2'))"
std::string point_text(const Json& coordinates) {
  std::string text;
  for (const Json& x : coordinates) {
    text += fmt::format("{}F('{}')", text.empty() ? "" : ", ", x.get<std::string>());
  }
  return "(" + text + ")";
}

std::string list_text(const Json& vertices) { return vertices.dump(); }

bool are_known(const Json& vertices, const Json& coordinates) {
  for (const Json& v : vertices) {
    if (!coordinates.contains(std::to_string(v.get<std::int64_t>()))) return false;
  }
  return true;
}

// The lines that compute and print what decides; empty if nothing does that such lines could.
std::string decision(const Json& witness, const Json& coordinates) {
  const Json none = Json::array();
  const Json vertices = witness.value("vertices", none);
  const Json simplices = witness.value("simplices", none);
  if (witness.contains("ball") && !vertices.empty()) {
    return fmt::format(
        "centre = {}\n"
        "distance = lambda v: sum((x - y) ** 2 for x, y in zip(points[v], centre))\n"
        "print('squared distances from the centre of the ball: of the corners of', {}, "
        "[str(distance(v)) for v in {}])\n"
        "print('of vertex {}, which is nearer:', distance({}))\n",
        point_text(witness["ball"]["centre"]), list_text(simplices[0]), list_text(simplices[0]),
        vertices[0].dump(), vertices[0].dump());
  }
  if (witness.contains("point") && simplices.size() > 1) {
    return fmt::format(
        "points['p'] = {}\n"
        "for s in {}:  # p is inside if it has the same sign in the place of each corner as that "
        "corner has\n"
        "    print(s, orientation(*s), [str(orientation(*s[:i], 'p', *s[i + 1:])) for i in "
        "range(len(s))])\n",
        point_text(witness["point"]), list_text(simplices));
  }
  const Json face = witness.value("face", none);
  const std::size_t dimension = coordinates.begin()->size();
  if (face.size() == dimension && vertices.size() == 1 && simplices.size() == 1) {
    return fmt::format(
        "apex = [v for v in {0} if v not in {1}]\n"
        "print('the other corner and vertex {2} are on different sides of the facet:',\n"
        "      orientation(*{1}, *apex), orientation(*{1}, {2}))\n",
        list_text(simplices[0]), list_text(face), vertices[0].dump());
  }
  if (simplices.size() == 1 && simplices[0].size() == dimension + 1) {
    return fmt::format("print('the volume of the simplex, times {}!:', orientation(*{}))\n",
                       dimension, list_text(simplices[0]));
  }
  return "";
}

}  // namespace

std::string by_hand_script(const Json& verdict) {
  if (!verdict.is_object() || verdict.value("violations", Json::array()).empty()) return "";
  const Json& witness = verdict["violations"][0];
  const Json coordinates = witness.value("coordinates", Json::object());
  if (coordinates.empty()) return "";
  for (const Json& simplex : witness.value("simplices", Json::array())) {
    if (!are_known(simplex, coordinates)) return "";
  }
  if (!are_known(witness.value("vertices", Json::array()), coordinates)) return "";
  const std::string lines = decision(witness, coordinates);
  if (lines.empty()) return "";
  std::string points;
  for (const auto& [vertex, point] : coordinates.items()) {
    points +=
        fmt::format("{}{}: {}", points.empty() ? "" : ",\n          ", vertex, point_text(point));
  }
  return fmt::format(
      "#!/usr/bin/env python3\n"
      "# {}: {}.\n"
      "# By rational arithmetic alone, with the vertices that the first witness names.\n"
      "from fractions import Fraction as F\n"
      "points = {{{}}}\n"
      "def det(m):\n"
      "    return sum((-1) ** i * r[0] * det([s[1:] for s in m[:i] + m[i + 1:]]) for i, r in "
      "enumerate(m)) if m else F(1)\n"
      "def orientation(a, *others):\n"
      "    return det([[x - y for x, y in zip(points[v], points[a])] for v in others])\n"
      "{}",
      witness["rule"].get<std::string>(), witness["meaning"].get<std::string>(), points, lines);
}

}  // namespace circumspect::campaign
