#include "oracle/judge/within/reaches.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "oracle/judge/fast/in_chunks.hpp"
#include "oracle/judge/within/distance.hpp"

namespace circumspect::check {
namespace {

constexpr std::size_t kChunk = 256;
constexpr std::size_t kStepsOfDistance = 10;  // see Work

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

  // Of a simplex of three corners at most.
  struct Corners {
    std::array<RoundedPoint, 3> points;
    std::size_t size;
    operator std::span<const RoundedPoint>() const { return std::span(points).first(size); }
  };
  static Corners rounded_corners(const Simplex& simplex, const std::vector<RoundedPoint>& points) {
    Corners corners{{}, simplex.size()};
    for (std::size_t i = 0; i < simplex.size(); ++i) {
      corners.points[i] = points[static_cast<std::size_t>(simplex[i])];
    }
    return corners;
  }

 private:
  std::vector<Cell> cell_;
  std::vector<Simplex> simplex_;
  std::vector<Box> boxes_;
  std::optional<BoxIndex> index_;
};

DomainPieces::DomainPieces(const Cells& cells, Work& work)
    : cells_(cells),
      work_(work),
      rounding_(cells.complex().points.points()),
      points_(rounding_.points(cells.complex().points.points())) {
  for (const int dimension : {0, 1, 2}) of_dimension_.emplace_back(cells, dimension, points_);
}
DomainPieces::~DomainPieces() = default;

struct DomainPieces::Around {
  Around(const At& of, const Limit& up_to)
      : point(of.exact), limit(up_to), at({of.rounded}), box(box_about(at, limit.rounded)) {}

  const Point& point;
  const Limit& limit;
  std::array<RoundedPoint, 1> at;
  Box box;
};

void DomainPieces::add_near(int dimension, const Around& around, std::vector<ToCell>& found) const {
  const PointSet& points = cells_.complex().points;
  const Pieces& pieces = of_dimension_[static_cast<std::size_t>(dimension)];
  const std::size_t before = found.size();
  if (work_.is_too_much()) return;
  const std::vector<std::size_t> meeting = pieces.meeting(around.box);
  work_.add(1 + meeting.size() / 4);
  for (const std::size_t piece : meeting) {
    const Simplex& simplex = pieces.simplex(piece);
    const auto corners = Pieces::rounded_corners(simplex, points_);
    if (certainly_apart(around.at, corners, around.limit.rounded)) continue;
    work_.add(kStepsOfDistance);
    Rational squared = squared_distance_to(coordinates(points, simplex), around.point);
    if (squared > around.limit.squared) continue;
    // The pieces of a cell follow each other.
    if (found.size() > before && found.back().cell == pieces.cell(piece)) {
      if (found.back().squared() <= squared) continue;
      found.pop_back();
    }
    found.push_back({pieces.cell(piece), std::make_shared<const Rational>(std::move(squared))});
  }
  std::sort(found.begin() + static_cast<std::ptrdiff_t>(before), found.end(),
            [](const ToCell& a, const ToCell& b) {
              const Rational &of_a = a.squared(), &of_b = b.squared();
              return of_a != of_b ? of_a < of_b : a.cell < b.cell;
            });
}

DomainPieces::Limit DomainPieces::limit(const Rational& squared) const {
  return {squared, rounding_.distance(squared)};
}

std::vector<ToCell> DomainPieces::vertices_near(const At& point, const Limit& limit) const {
  std::vector<ToCell> found;
  add_near(0, Around(point, limit), found);
  return found;
}

void DomainPieces::add_cells_near(const At& point, const Limit& limit,
                                  const Rational& squared_least, std::vector<ToCell>& found) const {
  if (!found.empty() && found.front().squared() <= squared_least) {
    // Whatever else is near has the vertex, or it would be near the vertex without meeting it.
    const ToCell vertex = found.front();
    const std::vector<Cell>& star = cells_.star(vertex.cell.place);
    found.reserve(found.size() + star.size());
    for (const Cell cell : star) found.push_back({cell, vertex.distance});
    return;
  }
  const Around around(point, limit);
  for (const int dimension : {1, 2}) add_near(dimension, around, found);
}

std::optional<ApartCells> DomainPieces::least_apart(const Rational& squared_limit,
                                                    unsigned threads) const {
  const PointSet& points = cells_.complex().points;
  const double limit = rounding_.distance(squared_limit);
  std::vector<std::optional<ApartCells>> least;
  const auto look_at = [&](const Pieces& from, const Pieces& to) {
    const std::size_t before = least.size();
    least.resize(before + fast::chunks_of(from.size(), kChunk));
    const auto in_chunk = [&](std::size_t chunk, std::size_t first, std::size_t last) {
      std::optional<ApartCells>& best = least[before + chunk];
      for (std::size_t i = first; i < last; ++i) {
        if (work_.is_too_much()) return;
        const Simplex& a = from.simplex(i);
        const auto of_a = Pieces::rounded_corners(a, points_);
        const std::vector<std::size_t> meeting = to.meeting(box_about(of_a, limit));
        work_.add(1 + meeting.size() / 4);
        for (const std::size_t j : meeting) {
          const Simplex& b = to.simplex(j);
          if (&from == &to && j <= i) continue;
          if (cells_.meet(from.cell(i), to.cell(j))) continue;
          if (certainly_apart(of_a, Pieces::rounded_corners(b, points_), limit)) continue;
          work_.add(3 * kStepsOfDistance);
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

Reaches::Reaches(const ExactMesh& mesh, const std::vector<RoundedPoint>& rounded,
                 const std::vector<bool>& used, const Cells& cells, const DomainPieces& pieces,
                 const Rational& squared_limit, unsigned threads)
    : of_(mesh.points.size()) {
  const PiecewiseLinearComplex& complex = cells.complex();
  near_[0].resize(complex.points.size());
  near_[1].resize(complex.segments.size());
  near_[2].resize(complex.polygons.size());
  const auto for_each_used = [&](const auto& visit) {
    const auto in_chunk = [&](std::size_t, std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v) {
        const DomainPieces::At at{mesh.points[static_cast<Vertex>(v)], rounded[v]};
        if (used[v]) visit(at, of_[v]);
      }
    };
    fast::in_chunks(of_.size(), kChunk, threads, in_chunk);
  };
  const DomainPieces::Limit limit = pieces.limit(squared_limit);
  for_each_used([&](const DomainPieces::At& point, std::vector<ToCell>& found) {
    found = pieces.vertices_near(point, limit);
  });
  std::vector<const Rational*> nearest(complex.points.size(), nullptr);
  for (const std::vector<ToCell>& found : of_) {
    for (const ToCell& to : found) {
      const Rational*& least = nearest[to.cell.place];
      if (least == nullptr || to.squared() < *least) least = &to.squared();
    }
  }
  for (const Rational* const squared : nearest) {
    if (squared != nullptr) squared_least_ = std::max(squared_least_, *squared);
  }
  for_each_used([&](const DomainPieces::At& point, std::vector<ToCell>& found) {
    pieces.add_cells_near(point, limit, squared_least_, found);
  });
  for (Vertex v = 0; mesh.points.names(v); ++v) {
    for (const ToCell& to : of(v)) {
      near_[static_cast<std::size_t>(to.cell.dimension)][to.cell.place].push_back(
          {&to.squared(), v});
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
    if (to.squared() > squared_reach) continue;
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
