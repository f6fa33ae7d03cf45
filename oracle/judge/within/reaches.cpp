#include "oracle/judge/within/reaches.hpp"

#include <algorithm>

#include "oracle/judge/fast/in_chunks.hpp"
#include "oracle/judge/within/distance.hpp"

namespace circumspect::check {
namespace {

constexpr std::size_t kChunk = 256;

}  // namespace

// The simplices that the cells of one dimension are made of, in boxes.
class DomainPieces::Pieces {
 public:
  Pieces(const Cells& cells, int dimension, const std::vector<RoundedPoint>& points) {
    const PiecewiseLinearComplex& complex = cells.complex();
    const std::size_t count = dimension == 0   ? complex.points.size()
                              : dimension == 1 ? complex.segments.size()
                                               : complex.polygons.size();
    for (std::size_t place = 0; place < count; ++place) {
      for (Simplex& simplex : cells.simplices({dimension, place})) {
        cell_.push_back({dimension, place});
        simplex_.push_back(std::move(simplex));
        boxes_.push_back(box_about(rounded_corners(simplex_.back(), points), 0));
      }
    }
    index_.emplace(boxes_);
  }

  std::size_t size() const { return cell_.size(); }
  Cell cell(std::size_t piece) const { return cell_[piece]; }
  const Simplex& simplex(std::size_t piece) const { return simplex_[piece]; }
  std::vector<std::size_t> meeting(const Box& box) const { return index_->meeting(box); }

  static std::vector<RoundedPoint> rounded_corners(const Simplex& simplex,
                                                   const std::vector<RoundedPoint>& points) {
    std::vector<RoundedPoint> corners;
    corners.reserve(simplex.size());
    for (const Vertex v : simplex) corners.push_back(points[static_cast<std::size_t>(v)]);
    return corners;
  }

 private:
  std::vector<Cell> cell_;
  std::vector<Simplex> simplex_;
  std::vector<Box> boxes_;
  std::optional<BoxIndex> index_;
};

DomainPieces::DomainPieces(const Cells& cells)
    : cells_(cells), points_(rounded(cells.complex().points.points())) {
  for (const int dimension : {0, 1, 2}) of_dimension_.emplace_back(cells, dimension, points_);
}
DomainPieces::~DomainPieces() = default;

std::vector<ToCell> DomainPieces::near(const Point& point, const Rational& squared_limit) const {
  const PointSet& points = cells_.complex().points;
  const double limit = upper_square_root(squared_limit);
  const std::array<RoundedPoint, 1> at = {rounded(point)};
  const Box box = box_about(at, limit);
  std::vector<ToCell> found;
  std::optional<Vertex> equal;  // the vertex of the domain that the point is
  for (const Pieces& pieces : of_dimension_) {
    for (const std::size_t piece : pieces.meeting(box)) {
      const Simplex& simplex = pieces.simplex(piece);
      if (simplex.size() == 1 && points[simplex[0]] == point) equal = simplex[0];
      Rational squared = 0;
      if (!equal || !contains(simplex, *equal)) {
        if (certainly_apart(at, Pieces::rounded_corners(simplex, points_), limit)) continue;
        squared = squared_distance_to(coordinates(points, simplex), point);
        if (squared > squared_limit) continue;
      }
      // The pieces of a cell follow each other.
      if (!found.empty() && found.back().cell == pieces.cell(piece)) {
        found.back().squared = std::min(found.back().squared, squared);
      } else {
        found.push_back({pieces.cell(piece), std::move(squared)});
      }
    }
  }
  std::sort(found.begin(), found.end(), [](const ToCell& a, const ToCell& b) {
    if (a.cell.dimension != b.cell.dimension) return a.cell.dimension < b.cell.dimension;
    return a.squared != b.squared ? a.squared < b.squared : a.cell < b.cell;
  });
  return found;
}

std::optional<ApartCells> DomainPieces::least_apart(const Rational& squared_limit,
                                                    unsigned threads) const {
  const PointSet& points = cells_.complex().points;
  const double limit = upper_square_root(squared_limit);
  std::vector<std::optional<ApartCells>> least;
  const auto look_at = [&](const Pieces& from, const Pieces& to) {
    const std::size_t before = least.size();
    least.resize(before + fast::chunks_of(from.size(), kChunk));
    const auto in_chunk = [&](std::size_t chunk, std::size_t first, std::size_t last) {
      std::optional<ApartCells>& best = least[before + chunk];
      for (std::size_t i = first; i < last; ++i) {
        const Simplex& a = from.simplex(i);
        const auto of_a = Pieces::rounded_corners(a, points_);
        for (const std::size_t j : to.meeting(box_about(of_a, limit))) {
          const Simplex& b = to.simplex(j);
          if (&from == &to && j <= i) continue;
          if (cells_.meet(from.cell(i), to.cell(j))) continue;
          if (certainly_apart(of_a, Pieces::rounded_corners(b, points_), limit)) continue;
          const Rational squared =
              squared_distance_between(coordinates(points, a), coordinates(points, b));
          if (squared > squared_limit || (best && squared >= best->squared)) continue;
          best = {from.cell(i), to.cell(j), squared};
        }
      }
    };
    fast::in_chunks(from.size(), kChunk, threads, in_chunk);
  };
  const Pieces &vertices = of_dimension_[0], &segments = of_dimension_[1];
  look_at(vertices, vertices);
  look_at(vertices, segments);
  look_at(vertices, of_dimension_[2]);
  look_at(segments, segments);
  std::optional<ApartCells> found;
  for (auto& best : least) {
    if (best && (!found || best->squared < found->squared)) found = std::move(best);
  }
  return found;
}

Reaches::Reaches(const ExactMesh& mesh, const std::vector<bool>& used, const Cells& cells,
                 const DomainPieces& pieces, const Rational& squared_limit, unsigned threads)
    : of_(mesh.points.size()) {
  const PiecewiseLinearComplex& complex = cells.complex();
  near_[0].resize(complex.points.size());
  near_[1].resize(complex.segments.size());
  near_[2].resize(complex.polygons.size());
  const auto in_chunk = [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      if (used[v]) of_[v] = pieces.near(mesh.points[static_cast<Vertex>(v)], squared_limit);
    }
  };
  fast::in_chunks(of_.size(), kChunk, threads, in_chunk);
  for (Vertex v = 0; mesh.points.names(v); ++v) {
    for (const ToCell& to : of(v)) {
      near_[static_cast<std::size_t>(to.cell.dimension)][to.cell.place].push_back({&to.squared, v});
    }
  }
  for (auto& of_dimension : near_) {
    for (std::vector<ToVertex>& vertices : of_dimension) {
      std::stable_sort(vertices.begin(), vertices.end(), [](const ToVertex& a, const ToVertex& b) {
        return a.squared() < b.squared();
      });
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

}  // namespace circumspect::check
