#include "oracle/domain/uncovered.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "kernel/complex/simplex.hpp"
#include "oracle/domain/filling.hpp"

namespace circumspect {
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

// A point in each of the regions that are not covered; the unbounded one needs none.
std::vector<Point> points_of_others(const std::set<std::size_t>& covered, const Regions& regions) {
  std::vector<Point> bare;
  if (covered.size() == regions.size()) return bare;
  const std::vector<Point> inner = points_of_regions(regions);
  for (std::size_t region = 0; region < regions.size(); ++region) {
    if (!covered.contains(region)) bare.push_back(inner[region]);
  }
  return bare;
}

// Changes whether something is in a set.
template <class Value>
void toggle(std::set<Value>& values, const Value& value) {
  if (!values.insert(value).second) values.erase(value);
}

using OfFace = std::pair<std::size_t, std::size_t>;  // a face and one of its rings

// For each wall, the rings that pass it an odd number of times.
std::vector<std::set<OfFace>> rings_at_walls(const std::vector<PolygonLines>& faces,
                                             const Regions& regions) {
  std::vector<std::set<OfFace>> found(regions.walls().size());
  for (std::size_t face = 0; face < faces.size(); ++face) {
    const auto& rings = faces[face].lines;
    for (std::size_t r = 0; r < rings.size(); ++r) {
      const auto& ring = rings[r];
      for (std::size_t i = 0; ring.size() > 1 && i < ring.size(); ++i) {
        const Simplex edge = sorted({ring[i], ring[(i + 1) % ring.size()]});
        toggle(found[regions.walls().place_of(edge)], OfFace(face, r));
      }
    }
  }
  return found;
}

// The rings that enclose each region. Going through a wall leads out of the rings that have it and
// into the others that do.
std::vector<std::set<OfFace>> rings_around_regions(const std::vector<PolygonLines>& faces,
                                                   const Regions& regions) {
  const auto rings_at = rings_at_walls(faces, regions);
  std::vector<std::vector<std::size_t>> walls_of(regions.size());
  for (std::size_t wall = 0; wall < regions.walls().size(); ++wall) {
    for (const std::size_t region : regions.beside(wall)) walls_of[region].push_back(wall);
  }
  std::vector<std::set<OfFace>> around(regions.size());
  std::vector<bool> is_reached(regions.size(), false);
  std::vector<std::size_t> open = {Regions::kUnbounded};
  is_reached[Regions::kUnbounded] = true;
  while (!open.empty()) {
    const std::size_t region = open.back();
    open.pop_back();
    for (const std::size_t wall : walls_of[region]) {
      for (const std::size_t next : regions.beside(wall)) {
        if (is_reached[next]) continue;
        is_reached[next] = true;
        around[next] = around[region];
        for (const OfFace& ring : rings_at[wall]) toggle(around[next], ring);
        open.push_back(next);
      }
    }
  }
  return around;
}

// Is there a face of which an odd number of rings are among these?
bool are_odd_of_one(const std::set<OfFace>& rings) {
  std::set<std::size_t> odd;
  for (const auto& [face, ring] : rings) toggle(odd, face);
  return !odd.empty();
}

}  // namespace

std::vector<Point> points_without_face(const std::vector<PolygonLines>& faces,
                                       const Regions& regions, const PointSet& points) {
  const Covering covering(regions, points);
  std::set<std::size_t> covered = {Regions::kUnbounded};
  for (const PolygonLines& face : faces) covered.merge(covering.covered_by(face));
  return points_of_others(covered, regions);
}

std::vector<Point> points_without_rings(const std::vector<PolygonLines>& faces,
                                        const Regions& regions) {
  const auto around = rings_around_regions(faces, regions);
  std::set<std::size_t> covered = {Regions::kUnbounded};
  for (std::size_t region = 0; region < regions.size(); ++region) {
    if (are_odd_of_one(around[region])) covered.insert(region);
  }
  return points_of_others(covered, regions);
}

std::vector<RingThatIsNoHole> rings_that_are_no_holes(const std::vector<PolygonLines>& faces,
                                                      const Regions& regions) {
  const auto around = rings_around_regions(faces, regions);
  std::map<OfFace, std::set<std::size_t>> inside;
  for (std::size_t region = 0; region < regions.size(); ++region) {
    for (const OfFace& ring : around[region]) inside[ring].insert(region);
  }
  const auto has_all = [&](const OfFace& ring, const std::set<std::size_t>& regions_of_other) {
    const auto& own = inside[ring];
    return std::includes(own.begin(), own.end(), regions_of_other.begin(), regions_of_other.end());
  };
  std::vector<RingThatIsNoHole> found;
  for (const auto& [ring, enclosed] : inside) {
    const auto [face, place] = ring;
    if (place == 0) continue;
    if (!has_all({face, 0}, enclosed)) {
      found.push_back({face, place, std::nullopt});
      continue;
    }
    for (const OfFace& other : around[*enclosed.begin()]) {
      const bool is_hole = other.first == face && other.second != 0 && other != ring;
      // Of two that enclose the same, the later one is in the earlier.
      const bool is_same = is_hole && inside[other] == enclosed;
      if (!is_hole || !has_all(other, enclosed) || (is_same && other > ring)) continue;
      found.push_back({face, place, other.second});
      break;
    }
  }
  return found;
}

}  // namespace circumspect
