// Where a surface is open that should be closed: holes, and cracks whose sides were rounded apart.
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "kernel/exact/point.hpp"
#include "kernel/piecewise_linear/disjoint_sets.hpp"
#include "oracle/judge/cause/rows.hpp"
#include "oracle/judge/cause/surface_edges.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::check {
namespace {

// More vertices of open edges are not compared with each other.
constexpr std::size_t kMostOpen = 20'000;
// How near to each other, in parts of the shortest open edge at one of them, vertices are that were
// one before they were rounded. That the edges then fit is checked.
constexpr double kNearInEdges = 1e-3;

// Of triangles that are open and should not be.
std::vector<OpenEdge> edges_at_fault(const Case& of) {
  const auto& complex = of.verdict().complex;
  if (!complex || complex->dimension != 2 || of.mesh().dimension() != 3) return {};
  std::vector<OpenEdge> edges = open_edges(of.mesh());
  // Triangles that were set apart leave their edges open, but are not among these.
  if (edges.size() != of.count(Rule::kNotClosed)) return {};
  return edges;
}

struct OpenVertex {
  Vertex vertex;
  std::array<double, 3> place;
  double shortest;  // of the open edges at it, squared
};

double squared(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  double sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
  return sum;
}

// In order of their first coordinate.
std::vector<OpenVertex> open_vertices(const Mesh& mesh, const std::vector<OpenEdge>& edges) {
  std::map<Vertex, OpenVertex> found;
  for (const auto& [from, to] : edges) {
    for (const Vertex v : {from, to}) {
      OpenVertex one{v, {}, 0};
      const Point point = mesh.point(v);
      for (std::size_t axis = 0; axis < 3; ++axis) one.place[axis] = point[axis].get_d();
      found.emplace(v, one);
    }
    OpenVertex &a = found.at(from), &b = found.at(to);
    const double length = squared(a.place, b.place);
    for (OpenVertex* one : {&a, &b}) {
      one->shortest = one->shortest == 0 ? length : std::min(one->shortest, length);
    }
  }
  std::vector<OpenVertex> sorted;
  for (const auto& [v, one] : found) sorted.push_back(one);
  std::sort(sorted.begin(), sorted.end(), [](const OpenVertex& a, const OpenVertex& b) {
    return std::tie(a.place, a.vertex) < std::tie(b.place, b.vertex);
  });
  return sorted;
}

// Vertices of open edges that are near each other, as pairs.
std::vector<std::pair<Vertex, Vertex>> near_pairs(const std::vector<OpenVertex>& vertices) {
  double longest = 0;
  for (const OpenVertex& one : vertices) longest = std::max(longest, one.shortest);
  std::vector<std::pair<Vertex, Vertex>> pairs;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    for (std::size_t j = i + 1; j < vertices.size(); ++j) {
      const OpenVertex &a = vertices[i], &b = vertices[j];
      const double off = b.place[0] - a.place[0];
      if (off * off > kNearInEdges * kNearInEdges * longest) break;
      const double most = kNearInEdges * kNearInEdges * std::min(a.shortest, b.shortest);
      if (squared(a.place, b.place) < most) pairs.emplace_back(a.vertex, b.vertex);
    }
  }
  return pairs;
}

// Open edges that are two sides of a crack each, and those that are not.
struct Cracks {
  std::size_t sides = 0;
  Rational widest = 0;  // squared
  std::vector<OpenEdge> others;
};

Cracks cracks_among(const Mesh& mesh, const std::vector<OpenEdge>& edges) {
  Cracks found{.others = edges};
  const std::vector<OpenVertex> vertices = open_vertices(mesh, edges);
  if (vertices.size() > kMostOpen) return found;
  DisjointSets joined(mesh.points());
  for (const auto& [a, b] : near_pairs(vertices)) {
    joined.unite(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
    found.widest = std::max(found.widest, squared_distance(mesh.point(a), mesh.point(b)));
  }
  const auto once_joined = [&](const OpenEdge& edge) {
    const std::size_t a = joined.find(static_cast<std::size_t>(edge.from));
    const std::size_t b = joined.find(static_cast<std::size_t>(edge.to));
    return std::pair(std::min(a, b), std::max(a, b));
  };
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> uses;
  for (const OpenEdge& edge : edges) ++uses[once_joined(edge)];
  std::erase_if(found.others, [&](const OpenEdge& edge) { return uses[once_joined(edge)] == 2; });
  found.sides = edges.size() - found.others.size();
  return found;
}

}  // namespace

std::vector<OpenEdge> edges_of_holes(const Case& of) {
  return cracks_among(of.mesh(), edges_at_fault(of)).others;
}

std::optional<Cause> cracks(Case& of) {
  const std::vector<OpenEdge> edges = edges_at_fault(of);
  const Cracks found = cracks_among(of.mesh(), edges);
  if (found.sides == 0) return std::nullopt;
  return of.cause(
      "cracks",
      fmt::format("{} of {} open edges are the sides of cracks, at most {} wide, as if their "
                  "vertices had been rounded: joined, {}",
                  found.sides, edges.size(), report::square_root_rounded_up(found.widest),
                  found.others.empty() ? "the surface is closed" : "the others remain"),
      found.sides);
}

std::optional<Cause> holes_of_surface(Case& of) {
  const std::vector<OpenEdge> edges = edges_of_holes(of);
  const auto loops = loops_of(edges);
  if (!loops || loops->empty()) return std::nullopt;
  std::vector<std::size_t> sizes;
  for (const auto& loop : *loops) sizes.push_back(loop.size());
  const auto [least, most] = std::minmax_element(sizes.begin(), sizes.end());
  if (*most == 3) return std::nullopt;  // simplices that are missing: another row
  const std::string each = *least == *most ? fmt::format("{} around each", *least)
                                           : fmt::format("{} to {} around each", *least, *most);
  return of.cause(
      "holes",
      fmt::format("the {} open edges go around {}{}", edges.size(),
                  report::counted(sizes.size(), "hole"), sizes.size() == 1 ? "" : ", " + each),
      edges.size());
}

}  // namespace circumspect::check
