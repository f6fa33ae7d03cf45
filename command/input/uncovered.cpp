#include "command/input/uncovered.hpp"

#include <set>

#include "kernel/complex/simplex.hpp"
#include "oracle/domain/filling.hpp"

namespace circumspect::cli {
namespace {

class Covering {
 public:
  explicit Covering(const Regions& regions, const PointSet& points)
      : regions_(regions), points_(points), walls_of_(regions.size()) {
    for (std::size_t wall = 0; wall < regions.walls().size(); ++wall) {
      for (const std::size_t region : regions.beside(wall)) walls_of_[region].push_back(wall);
    }
  }

  // The regions that a face covers.
  std::set<std::size_t> covered_by(const PolygonLines& face) const {
    const std::set<std::size_t> own = walls_of(face);
    if (face.lines.size() == 1 && face.hole_seeds.empty()) {
      return reached_from(inside(face.lines.front()), own);
    }
    // With several lines it is known what is not covered: the outside and the holes.
    std::set<std::size_t> starts = {Regions::kUnbounded};
    for (const Point& seed : face.hole_seeds) {
      if (const auto region = regions_.region_at(seed)) starts.insert(*region);
    }
    const std::set<std::size_t> bare = reached_from(starts, own);
    std::set<std::size_t> covered;
    for (std::size_t region = 0; region < regions_.size(); ++region) {
      if (!bare.contains(region)) covered.insert(region);
    }
    return covered;
  }

 private:
  std::set<std::size_t> walls_of(const PolygonLines& face) const {
    std::set<std::size_t> own;
    for (const auto& line : face.lines) {
      for (std::size_t i = 0; line.size() > 1 && i < line.size(); ++i) {
        own.insert(regions_.walls().place_of(sorted({line[i], line[(i + 1) % line.size()]})));
      }
    }
    return own;
  }

  // What lies beside the edges of a closed line, on its inner side.
  std::set<std::size_t> inside(const std::vector<Vertex>& line) const {
    Rational twice_area = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Point& p = points_[line[i]];
      const Point& q = points_[line[(i + 1) % line.size()]];
      twice_area += cross_product(p, q, 0, 1);
    }
    std::set<std::size_t> regions;
    if (twice_area == 0) return regions;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Vertex from = line[i];
      const Vertex to = line[(i + 1) % line.size()];
      const auto [behind, in_front] =
          regions_.beside(regions_.walls().place_of(sorted({from, to})));
      // The front of a wall with its vertices ascending is on its left.
      regions.insert((twice_area > 0) == (from < to) ? in_front : behind);
    }
    return regions;
  }

  // The regions to which a way leads that crosses none of these walls.
  std::set<std::size_t> reached_from(std::set<std::size_t> reached,
                                     const std::set<std::size_t>& closed) const {
    std::vector<std::size_t> open(reached.begin(), reached.end());
    while (!open.empty()) {
      const std::size_t region = open.back();
      open.pop_back();
      for (const std::size_t wall : walls_of_[region]) {
        if (closed.contains(wall)) continue;
        for (const std::size_t next : regions_.beside(wall)) {
          if (reached.insert(next).second) open.push_back(next);
        }
      }
    }
    return reached;
  }

  const Regions& regions_;
  const PointSet& points_;
  std::vector<std::vector<std::size_t>> walls_of_;  // beside each region
};

}  // namespace

std::vector<Point> points_without_face(const std::vector<PolygonLines>& faces,
                                       const Regions& regions, const PointSet& points) {
  const Covering covering(regions, points);
  std::set<std::size_t> covered = {Regions::kUnbounded};
  for (const PolygonLines& face : faces) covered.merge(covering.covered_by(face));
  std::vector<Point> bare;
  if (covered.size() == regions.size()) return bare;
  const std::vector<Point> inner = points_of_regions(regions);
  for (std::size_t region = 0; region < regions.size(); ++region) {
    if (!covered.contains(region)) bare.push_back(inner[region]);
  }
  return bare;
}

}  // namespace circumspect::cli
