#include "kernel/predicates/intersection.hpp"

#include <cassert>
#include <utility>
#include <variant>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>
#include <CGAL/mpq_class.h>
#include <boost/variant.hpp>

namespace circumspect {
namespace {

using Kernel = CGAL::Simple_cartesian<Rational>;

Point ours(const Kernel::Point_2& p) { return {p.x(), p.y()}; }
Point ours(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }

// CGAL's types for one dimension under common names.
struct Plane {
  using Vertex = Kernel::Point_2;
  using Segment = Kernel::Segment_2;
  using Triangle = Kernel::Triangle_2;
  static Vertex vertex(const Point& p) { return {p[0], p[1]}; }
};
struct Space {
  using Vertex = Kernel::Point_3;
  using Segment = Kernel::Segment_3;
  using Triangle = Kernel::Triangle_3;
  static Vertex vertex(const Point& p) { return {p[0], p[1], p[2]}; }
};

template <typename In>
using Cell = std::variant<typename In::Vertex, typename In::Segment, typename In::Triangle>;

template <typename In>
Cell<In> cell(const std::vector<Point>& corners) {
  switch (corners.size()) {
    case 1:
      return In::vertex(corners[0]);
    case 2:
      return typename In::Segment(In::vertex(corners[0]), In::vertex(corners[1]));
    default:
      assert(corners.size() == 3);
      return typename In::Triangle(In::vertex(corners[0]), In::vertex(corners[1]),
                                   In::vertex(corners[2]));
  }
}

// The vertices of what CGAL found.
template <typename In>
struct Corners {
  std::vector<Point> operator()(const typename In::Vertex& p) const { return {ours(p)}; }
  std::vector<Point> operator()(const typename In::Segment& s) const {
    return {ours(s.source()), ours(s.target())};
  }
  std::vector<Point> operator()(const typename In::Triangle& t) const {
    return {ours(t[0]), ours(t[1]), ours(t[2])};
  }
  std::vector<Point> operator()(const std::vector<typename In::Vertex>& polygon) const {
    std::vector<Point> corners;
    for (const auto& p : polygon) corners.push_back(ours(p));
    return corners;
  }
};

// CGAL 6 answers with a std::variant of these, CGAL 5 with a boost::variant.
template <typename In, typename... Kinds>
std::vector<Point> corners(const std::variant<Kinds...>& common) {
  return std::visit(Corners<In>(), common);
}
template <typename In, typename Common>
std::vector<Point> corners(const Common& common) {
  return boost::apply_visitor(Corners<In>(), common);
}

template <typename In>
std::vector<Point> common_points(const std::vector<Point>& a, const std::vector<Point>& b) {
  const auto meet = [](const auto& one, const auto& other) -> std::vector<Point> {
    const auto common = CGAL::intersection(one, other);
    if (!common) return {};
    return corners<In>(*common);
  };
  return std::visit(meet, cell<In>(a), cell<In>(b));
}

}  // namespace

std::vector<Point> intersection(const std::vector<Point>& a, const std::vector<Point>& b) {
  assert(!a.empty() && !b.empty());
  if (a.size() == 1 && b.size() == 1) return a == b ? a : std::vector<Point>();
  return a.front().size() == 2 ? common_points<Plane>(a, b) : common_points<Space>(a, b);
}

}  // namespace circumspect
