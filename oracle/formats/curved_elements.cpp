#include "oracle/formats/curved_elements.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "kernel/exact/each_once.hpp"
#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"

namespace circumspect::formats {
namespace {

std::size_t edges_of(std::size_t corners) { return corners * (corners - 1) / 2; }

// Has it no more nodes than one on each edge? (A triangle may have another in its middle.)
bool is_of_second_order(std::size_t corners, std::size_t nodes) {
  return nodes <= corners + edges_of(corners) + (corners == 3 ? 1 : 0);
}

// A node of second order, and the edge whose middle is nearest.
struct Between {
  Vertex node = 0;
  std::pair<Vertex, Vertex> edge = {};
  bool is_off = false;
};

// The points of a file by their indices, in doubles: which node is farthest needs no more.
class Places {
 public:
  explicit Places(const ElementFile& file) : file_(file) {
    columns_ = file.points.points.columns();
    for (const Point& point : file.points.points) {
      for (const Rational& x : point) numbers_.push_back(x.get_d());
    }
  }

  // Twice the distance of a node from the middle of two others, squared; 0 if one is not a point.
  double twice_off_squared(Vertex node, Vertex a, Vertex b) const {
    double sum = 0;
    if (!names(node) || !names(a) || !names(b)) return sum;
    for (std::size_t i = 0; i < columns_; ++i) {
      const double off = 2 * at(node, i) - at(a, i) - at(b, i);
      sum += off * off;
    }
    return sum;
  }
  // The distance itself, squared and exact.
  Rational off_squared(const Between& between) const {
    const Point node = file_.points.points[place(between.node)];
    const Point a = file_.points.points[place(between.edge.first)];
    const Point b = file_.points.points[place(between.edge.second)];
    Rational sum = 0;
    for (std::size_t i = 0; i < columns_; ++i) {
      const Rational off = node[i] - (a[i] + b[i]) / 2;
      sum += off * off;
    }
    return sum;
  }

 private:
  std::size_t place(Vertex index) const {
    return static_cast<std::size_t>(index - file_.points.first_index);
  }
  bool names(Vertex index) const {
    const Vertex first = file_.points.first_index;
    return index >= first && place(index) < file_.points.points.size();
  }
  double at(Vertex index, std::size_t i) const { return numbers_[place(index) * columns_ + i]; }

  const ElementFile& file_;
  std::size_t columns_ = 0;
  std::vector<double> numbers_;
};

// The node of the elements, all of second order, that is farthest from the middle of every edge of
// its element.
Between farthest_between(const ElementFile& file, const Places& places) {
  Between farthest;
  double most = -1;
  for (std::size_t element = 0; element < file.curved.simplices.size(); ++element) {
    const Simplex nodes = file.curved.simplices[element];
    const std::size_t corners = file.corners_of_curved[element];
    const std::size_t on_edges = std::min(nodes.size(), corners + edges_of(corners));
    for (std::size_t i = corners; i < on_edges; ++i) {
      Between nearest{nodes[i]};
      double least = -1;
      for (std::size_t a = 0; a < corners; ++a) {
        for (std::size_t b = a + 1; b < corners; ++b) {
          const double off = places.twice_off_squared(nodes[i], nodes[a], nodes[b]);
          if (least >= 0 && off >= least) continue;
          least = off;
          nearest.edge = {nodes[a], nodes[b]};
        }
      }
      if (least <= most) continue;
      most = least;
      farthest = nearest;
      farthest.is_off = least > 0;
    }
  }
  return farthest;
}

}  // namespace

std::vector<Vertex> nodes_between_corners(const ElementFile& file) {
  std::vector<Vertex> nodes;
  if (file.curved.simplices.empty()) return nodes;
  const auto add = [&](const SimplexFile& list) {
    for (const Simplex& simplex : list.simplices) {
      nodes.insert(nodes.end(), simplex.begin(), simplex.end());
    }
  };
  add(file.curved);
  keep_each_once(nodes);
  std::vector<Vertex> vertices = std::exchange(nodes, {});
  for (const SimplexFile* const list : {&file.edges, &file.triangles, &file.tetrahedra}) add(*list);
  std::sort(nodes.begin(), nodes.end());
  std::vector<Vertex> between;
  std::set_difference(vertices.begin(), vertices.end(), nodes.begin(), nodes.end(),
                      std::back_inserter(between));
  return between;
}

std::optional<BetweenCorners> take_corners(SimplexFile& simplices, const PointFile& points,
                                           const std::string& name) {
  const std::size_t corners = points.dimension + 1;
  const bool is_of_mesh = points.dimension == 2 || points.dimension == 3;
  const std::size_t nodes = simplices.simplices.columns();
  if (!is_of_mesh || simplices.simplices.empty() || nodes != corners + edges_of(corners)) {
    return std::nullopt;
  }
  ElementFile file;
  file.points = points;
  SimplexFile& kept = corners == 3 ? file.triangles : file.tetrahedra;
  for (const Simplex& simplex : simplices.simplices) {
    kept.simplices.push_back(std::span(simplex).first(corners));
    file.corners_of_curved.push_back(corners);
  }
  file.curved.simplices = std::move(simplices.simplices);
  BetweenCorners between{nodes_between_corners(file), note_of_curved(file, name).value()};
  simplices.simplices = std::move(kept.simplices);
  simplices.vertices_per_simplex = corners;
  return between;
}

std::optional<std::string> note_of_curved(const ElementFile& file, const std::string& name) {
  const SimplexRows& curved = file.curved.simplices;
  if (curved.empty()) return std::nullopt;
  bool are_second = true;
  for (std::size_t i = 0; i < curved.size(); ++i) {
    are_second &= is_of_second_order(file.corners_of_curved[i], curved.size_of(i));
  }
  const bool is_one = curved.size() == 1;
  const std::string note = name + ": " + std::to_string(curved.size()) +
                           (is_one ? " element of " : " elements of ") +
                           (are_second ? "second order" : "higher order") +
                           (is_one ? " is judged by its corners" : " are judged by their corners");
  if (!are_second) return note;
  const Places places(file);
  const Between farthest = farthest_between(file, places);
  if (!farthest.is_off) return note + "; all other nodes are in the middle of edges";
  return note + "; node " + std::to_string(farthest.node) +
         " is farthest from the middle of its edge, ~ " +
         square_root_to_decimal(places.off_squared(farthest)) + " off";
}

}  // namespace circumspect::formats
