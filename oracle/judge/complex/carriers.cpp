#include "oracle/judge/complex/carriers.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>

#include "kernel/predicates/orientation.hpp"

namespace circumspect::check {
namespace {

using Axes = std::vector<std::size_t>;

// Two simplices by their vertices: those of both, and those of one alone.
struct Parted {
  Simplex common, only_a, only_b;
};

Parted parted(const Simplex& a, const Simplex& b) {
  Parted parts;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(parts.common));
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(parts.only_a));
  std::set_difference(b.begin(), b.end(), a.begin(), a.end(), std::back_inserter(parts.only_b));
  return parts;
}

// The axes of what both span together.
Axes axes_of_both(const OrientationSigns& orientation, const Simplex& a, const Parted& parts) {
  Axes all(orientation.points().ambient_dimension());
  std::iota(all.begin(), all.end(), std::size_t{0});
  if (a.size() == all.size() + 1) return all;
  Simplex together = a;
  if (a.size() == all.size()) {
    together.push_back(0);
    for (const Vertex v : parts.only_b) {
      together.back() = v;
      if (orientation(all, together) != 0) return all;
    }
    together.pop_back();
  }
  together.insert(together.end(), parts.only_b.begin(), parts.only_b.end());
  return axes_of(orientation.points(), together);
}

// The faces in the hyperplane through these vertices, if it separates the simplices and does not
// hold both. `plane` has room for one vertex more, which is the last.
std::optional<Carriers> faces_in(const OrientationSigns& orientation, const Axes& axes,
                                 Simplex& plane, const Parted& parts) {
  Carriers faces{parts.common, parts.common};
  const auto side_of = [&](Vertex v) {
    plane.back() = v;
    return orientation(axes, plane);
  };
  int side_of_a = 0;
  for (const Vertex v : parts.only_a) {
    const int side = side_of(v);
    if (side == 0) faces.of_a.push_back(v);
    if (side * side_of_a < 0) return std::nullopt;
    if (side != 0) side_of_a = side;
  }
  int side_of_b = 0;
  for (const Vertex v : parts.only_b) {
    const int side = side_of(v);
    if (side == 0) faces.of_b.push_back(v);
    if (side * side_of_b < 0 || side * side_of_a > 0) return std::nullopt;
    if (side != 0) side_of_b = side;
  }
  if (side_of_a == 0 && side_of_b == 0) return std::nullopt;
  std::sort(faces.of_a.begin(), faces.of_a.end());
  std::sort(faces.of_b.begin(), faces.of_b.end());
  return faces;
}

// A hyperplane that separates them has all common vertices.
std::optional<Carriers> separated(const OrientationSigns& orientation, const Axes& axes,
                                  const Parted& parts) {
  Simplex others = parts.only_a;
  others.insert(others.end(), parts.only_b.begin(), parts.only_b.end());
  Simplex chosen = first_subset(axes.size() - parts.common.size());
  do {
    Simplex plane = parts.common;
    for (const Vertex place : chosen) plane.push_back(others[static_cast<std::size_t>(place)]);
    plane.push_back(plane.front());
    if (auto faces = faces_in(orientation, axes, plane, parts)) return faces;
  } while (next_subset(chosen, others.size()));
  return std::nullopt;
}

}  // namespace

Carriers carriers(const OrientationSigns& orientation, Simplex a, Simplex b) {
  while (!a.empty() && !b.empty()) {
    const Parted parts = parted(a, b);
    if (parts.only_a.empty() || parts.only_b.empty()) return {parts.common, parts.common};
    const auto faces = separated(orientation, axes_of_both(orientation, a, parts), parts);
    if (!faces) return {a, b};
    a = faces->of_a;
    b = faces->of_b;
  }
  return {};
}

}  // namespace circumspect::check
