#include "oracle/judge/within/reaches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "oracle/judge/within/distance.hpp"
#include "reference/kernel/exact/box_index.hpp"

namespace circumspect::check {
namespace {

// At least the square root. Doubles only choose which exact distances are asked for.
double upper_square_root(const Rational& squared) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return std::nextafter(std::sqrt(upper_double(squared)), kInfinity);
}

// A box that holds whatever is at most so far from the box. Sums and differences of two coordinates
// change by at most √2 times as much.
Box widened(Box box, double by) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < box.low.size(); ++i) {
    const double step = i < 3 ? by : 2 * by;
    box.low[i] = std::nextafter(box.low[i] - step, -kInfinity);
    box.high[i] = std::nextafter(box.high[i] + step, kInfinity);
  }
  return box;
}

// The simplices that all cells are made of, in boxes.
class Pieces {
 public:
  explicit Pieces(const Cells& cells) : points_(cells.complex().points) {
    for (const Cell cell : cells.all()) {
      for (const Simplex& simplex : cells.simplices(cell)) {
        cell_.push_back(cell);
        simplex_.push_back(simplex);
        boxes_.push_back(box(simplex));
      }
    }
    index_.emplace(boxes_);
  }

  std::size_t size() const { return cell_.size(); }
  Cell cell(std::size_t piece) const { return cell_[piece]; }
  std::vector<Point> corners(std::size_t piece) const {
    return coordinates(points_, simplex_[piece]);
  }
  // Of one cell, or with a corner in common?
  bool touch(std::size_t a, std::size_t b) const {
    if (cell_[a] == cell_[b]) return true;
    return std::any_of(simplex_[a].begin(), simplex_[a].end(),
                       [&](Vertex v) { return contains(simplex_[b], v); });
  }
  const Box& box(std::size_t piece) const { return boxes_[piece]; }
  std::vector<std::size_t> near(const Box& box, double distance) const {
    return index_->meeting(widened(box, distance));
  }

 private:
  Box box(const Simplex& simplex) const {
    Box box = box_around(points_[simplex.front()]);
    for (const Vertex v : simplex) box = box_around(box, box_around(points_[v]));
    return box;
  }

  const PointSet& points_;
  std::vector<Cell> cell_;
  std::vector<Simplex> simplex_;
  std::vector<Box> boxes_;
  std::optional<BoxIndex> index_;
};

}  // namespace

Reaches::Reaches(const ExactMesh& mesh, const std::vector<bool>& used, const Cells& cells,
                 const Rational& squared_limit)
    : of_(mesh.points.size()) {
  const PiecewiseLinearComplex& complex = cells.complex();
  near_[0].resize(complex.points.size());
  near_[1].resize(complex.segments.size());
  near_[2].resize(complex.polygons.size());
  const Pieces pieces(cells);
  const double limit = upper_square_root(squared_limit);
  for (Vertex v = 0; mesh.points.names(v); ++v) {
    if (!used[static_cast<std::size_t>(v)]) continue;
    const Point& point = mesh.points[v];
    std::vector<ToCell>& found = of_[static_cast<std::size_t>(v)];
    for (const std::size_t piece : pieces.near(box_around(point), limit)) {
      const Rational squared = squared_distance_to(pieces.corners(piece), point);
      if (squared > squared_limit) continue;
      // The pieces of a cell follow each other.
      if (!found.empty() && found.back().cell == pieces.cell(piece)) {
        found.back().squared = std::min(found.back().squared, squared);
      } else {
        found.push_back({pieces.cell(piece), squared});
      }
    }
    std::sort(found.begin(), found.end(), [](const ToCell& a, const ToCell& b) {
      if (a.cell.dimension != b.cell.dimension) return a.cell.dimension < b.cell.dimension;
      return a.squared != b.squared ? a.squared < b.squared : a.cell < b.cell;
    });
    for (const ToCell& to : found) {
      near_[static_cast<std::size_t>(to.cell.dimension)][to.cell.place].push_back({to.squared, v});
    }
  }
  for (auto& of_dimension : near_) {
    for (std::vector<ToVertex>& vertices : of_dimension) {
      std::stable_sort(vertices.begin(), vertices.end(),
                       [](const ToVertex& a, const ToVertex& b) { return a.squared < b.squared; });
    }
  }
}

Carrier Reaches::carrier(Vertex v, const Rational& squared_reach) const {
  Carrier carrier;
  for (const ToCell& to : of(v)) {
    if (to.squared > squared_reach) continue;
    if (!carrier.cell) {
      carrier.cell = to.cell;
    } else {
      if (to.cell.dimension == carrier.cell->dimension) carrier.second = to.cell;
      break;
    }
  }
  return carrier;
}

std::optional<ApartCells> least_apart(const Cells& cells, const Rational& squared_limit) {
  const Pieces pieces(cells);
  const double limit = upper_square_root(squared_limit);
  std::optional<ApartCells> least;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (const std::size_t j : pieces.near(pieces.box(i), limit)) {
      if (j <= i || pieces.touch(i, j) || cells.meet(pieces.cell(i), pieces.cell(j))) continue;
      const Rational squared = squared_distance_between(pieces.corners(i), pieces.corners(j));
      if (squared > squared_limit || (least && squared >= least->squared)) continue;
      least = {pieces.cell(i), pieces.cell(j), squared};
    }
  }
  return least;
}

}  // namespace circumspect::check
