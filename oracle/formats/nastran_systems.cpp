#include "oracle/formats/nastran_systems.hpp"

#include <utility>

namespace circumspect::formats {
namespace {

// Of length one; nothing if that is not rational, or the vector is zero.
std::optional<Point> unit(const Point& vector) {
  const Rational square = squared_length(vector);
  const Integer above = sqrt(square.get_num());
  const Integer below = sqrt(square.get_den());
  const Rational length(above, below);
  if (above == 0 || length * length != square) return std::nullopt;
  return Rational(1 / length) * vector;
}

// The axes of the system with this origin, a point on its third axis, and one in the plane of the
// first and the third.
std::vector<Point> axes_of(const Point& origin, const Point& on_third, const Point& in_plane) {
  const Point third = on_third - origin;
  const auto z = unit(third);
  const auto y = unit(cross_product(third, in_plane - origin));
  if (!y || !z) return {};
  return {cross_product(*y, *z), *y, *z};
}

}  // namespace

Status NastranSystems::add(const NastranEntries& entries, NumberReading reading) {
  const auto tag = entries.integer(0, "the tag of a system of coordinates");
  if (!tag) return tl::unexpected(tag.error());
  if (!*tag) return entries.fail_at(0, "the tag of a system of coordinates");
  System system{entries.entry().name, entries.entry().line};
  if (system.entry == "CORD2R") {
    const auto on = entries.integer(1, "the system of coordinates that this one is given in");
    if (!on) return tl::unexpected(on.error());
    Point numbers;
    for (std::size_t place = 2; place < 11; ++place) {
      auto number = entries.number(place, reading);
      if (!number) return tl::unexpected(number.error());
      numbers.push_back(number->value_or(0));
    }
    const auto point = [&](std::size_t i) {
      return Point{numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
    };
    system.origin = point(0);
    if (on->value_or(0) == 0) system.axes = axes_of(point(0), point(1), point(2));
  }
  if (system.entry.starts_with("CORD1")) {  // two in one entry
    const auto second = entries.integer(4, "the tag of a system of coordinates");
    if (!second) return tl::unexpected(second.error());
    if (*second) take(**second, system);
  }
  take(**tag, std::move(system));
  return {};
}

// Which of two is meant cannot be known, and need not be if no node is given in it.
void NastranSystems::take(Vertex tag, System system) {
  const auto [known, is_new] = systems_.emplace(tag, std::move(system));
  if (is_new) return;
  known->second.axes.clear();
  known->second.is_defined_twice = true;
}

std::optional<Point> NastranSystems::in_basic(const Point& point, Vertex system) const {
  const auto found = systems_.find(system);
  if (found == systems_.end() || found->second.axes.empty()) return std::nullopt;
  Point place = found->second.origin;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    place = place + point[axis] * found->second.axes[axis];
  }
  return place;
}

std::string NastranSystems::words(Vertex system) const {
  const std::string tag = "system " + std::to_string(system);
  const auto found = systems_.find(system);
  if (found == systems_.end()) return tag + ", which no CORD entry defines";
  const std::string& entry = found->second.entry;
  const std::string where = ", by " + entry + " on line " + std::to_string(found->second.line);
  if (found->second.is_defined_twice) return tag + where + " and again";
  if (entry.ends_with("C")) return tag + where + " a cylindrical one";
  if (entry.ends_with("S")) return tag + where + " a spherical one";
  if (entry != "CORD2R") return tag + where + " one that nodes define";
  return tag + where + " one whose axes have no rational directions, or that is given in another";
}

}  // namespace circumspect::formats
