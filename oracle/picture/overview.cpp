#include "oracle/picture/overview.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "oracle/picture/picture.hpp"

namespace circumspect::picture {
namespace {

using report::Json;
using Spot = std::array<double, 3>;

constexpr std::size_t kShownWhole = 60;  // which the picture of a witness shows whole
constexpr std::size_t kMostSkin = 2500;
constexpr double kMarkWidth = 0.06;  // of the frame, whose half is 1

Spot spot_of(const Point& point) {
  Spot place = {0, 0, 0};
  for (std::size_t axis = 0; axis < std::min<std::size_t>(point.size(), 3); ++axis) {
    place[axis] = point[axis].get_d();
  }
  return place;
}

Spot middle(const std::vector<Spot>& places) {
  Spot sum = {0, 0, 0};
  for (const Spot& place : places) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      sum[axis] += place[axis] / static_cast<double>(places.size());
    }
  }
  return sum;
}

// Where on the mesh a witness is: its point, else the middle of the smallest cell that it names.
std::optional<Spot> spot_of(const Witness& witness, const Mesh& mesh, const Domain* domain) {
  if (witness.point) return spot_of(*witness.point);
  const auto middle_of = [&](const Simplex& cell) -> std::optional<Spot> {
    std::vector<Spot> corners;
    for (const Vertex v : cell) {
      if (mesh.names(v)) corners.push_back(spot_of(mesh.point(v)));
    }
    return corners.empty() ? std::nullopt : std::optional(middle(corners));
  };
  if (witness.face && !witness.face->empty()) return middle_of(*witness.face);
  if (!witness.simplices.empty()) return middle_of(witness.simplices.front());
  if (!witness.vertices.empty()) return middle_of({witness.vertices.front()});
  if (domain == nullptr) return std::nullopt;
  const PointSet& points = domain->complex.points;
  if (witness.domain_cell) return spot_of(barycentre(points, *witness.domain_cell));
  if (witness.polygon) {
    const Polygon& polygon = domain->complex.polygons[*witness.polygon];
    if (!polygon.triangles.empty()) {
      return spot_of(barycentre(points, polygon.triangles.front()));
    }
  }
  return std::nullopt;
}

// The triangles that are seen of a mesh from outside.
std::vector<Simplex> skin_of(const Mesh& mesh) {
  std::vector<Simplex> triangles;
  for (std::size_t i = 0; i < mesh.simplices.size(); ++i) {
    if (mesh.simplices[i].size() == 4) return boundary(mesh);
    if (mesh.simplices[i].size() != 3) continue;
    const Simplex triangle = mesh.simplices[i];
    if (std::all_of(triangle.begin(), triangle.end(), [&](Vertex v) { return mesh.names(v); })) {
      triangles.push_back(triangle);
    }
  }
  return triangles;
}

// The bounding box of places: what it maps to [−1, 1].
class Frame {
 public:
  void include(const Spot& place) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis] = std::min(low_[axis], place[axis]);
      high_[axis] = std::max(high_[axis], place[axis]);
    }
  }

  // Half the longest side; not a positive finite number if there is nothing to be drawn.
  double half() const {
    double longest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      longest = std::max(longest, high_[axis] / 2 - low_[axis] / 2);
    }
    return longest;
  }

  Spot operator()(const Spot& place) const {
    Spot at = {0, 0, 0};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double centre = low_[axis] / 2 + high_[axis] / 2;
      at[axis] = std::clamp((place[axis] - centre) / half(), -1.0, 1.0);
    }
    return at;
  }

 private:
  static constexpr double kNone = std::numeric_limits<double>::infinity();
  Spot low_ = {kNone, kNone, kNone};
  Spot high_ = {-kNone, -kNone, -kNone};
};

// Triangles whose corners are those of others that share a cell of a grid, so that there are few
// enough.
struct Skin {
  std::vector<Spot> corners = {};
  std::vector<std::array<std::size_t, 3>> triangles = {};
  bool is_coarser = false;
};

// `cells`: of the grid, along the longest side; none: each corner is drawn as itself.
Skin skin_on_grid(const std::vector<Simplex>& triangles, const std::map<Vertex, Spot>& at,
                  std::optional<int> cells) {
  Skin skin{.is_coarser = cells.has_value()};
  std::map<Vertex, std::size_t> corner_of;
  std::map<std::array<int, 3>, std::size_t> corner_in;
  for (const auto& [v, place] : at) {
    if (!cells) {
      corner_of[v] = skin.corners.size();
      skin.corners.push_back(place);
      continue;
    }
    std::array<int, 3> cell = {};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      cell[axis] = static_cast<int>((place[axis] + 1) / 2 * *cells);
    }
    const auto [found, is_new] = corner_in.try_emplace(cell, skin.corners.size());
    if (is_new) skin.corners.push_back(place);
    corner_of[v] = found->second;
  }
  std::set<std::array<std::size_t, 3>> seen;
  for (const Simplex& triangle : triangles) {
    const std::array<std::size_t, 3> corners = {
        corner_of.at(triangle[0]), corner_of.at(triangle[1]), corner_of.at(triangle[2])};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[0] == corners[2]) continue;
    std::array<std::size_t, 3> key = corners;
    std::sort(key.begin(), key.end());
    if (!cells || seen.insert(key).second) skin.triangles.push_back(corners);
  }
  return skin;
}

Skin drawable(const std::vector<Simplex>& triangles, const std::map<Vertex, Spot>& at) {
  if (triangles.size() <= kMostSkin) return skin_on_grid(triangles, at, std::nullopt);
  int cells = 64;
  Skin skin = skin_on_grid(triangles, at, cells);
  while (skin.triangles.size() > kMostSkin && cells > 2) {
    cells = cells * 3 / 4;
    skin = skin_on_grid(triangles, at, cells);
  }
  return skin;
}

// Places of violations, those that are near each other as one: the first of them.
struct Marks {
  std::vector<Spot> places = {};
  std::vector<Json> violations = {};

  void add(const Spot& place, std::size_t violation) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      double distance = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        distance = std::max(distance, std::abs(places[i][axis] - place[axis]));
      }
      if (distance > kMarkWidth) continue;
      violations[i].push_back(violation);
      return;
    }
    places.push_back(place);
    violations.push_back(Json::array({violation}));
  }
};

Json rounded(const Spot& place) {
  Json at = Json::array();
  for (const double x : place) at.push_back(std::round(x * 1e4) / 1e4);
  return at;
}

}  // namespace

Json overview(const Verdict& verdict, const Mesh& mesh, const Domain* domain, std::size_t shown) {
  if (mesh.simplices.size() <= kShownWhole || mesh.dimension() < 2 || mesh.dimension() > 3)
    return {};
  const std::vector<Simplex> triangles = skin_of(mesh);
  if (triangles.empty()) return {};
  Frame frame;
  std::map<Vertex, Spot> at;
  for (const Simplex& triangle : triangles) {
    for (const Vertex v : triangle) {
      const auto [found, is_new] = at.try_emplace(v);
      if (!is_new) continue;
      found->second = spot_of(mesh.point(v));
      frame.include(found->second);
    }
  }
  if (!(frame.half() > 0) || !std::isfinite(frame.half())) return {};
  for (auto& [v, place] : at) place = frame(place);

  Marks marks;
  for (std::size_t i = 0; i < std::min(shown, verdict.violations().size()); ++i) {
    const auto place = spot_of(verdict.violations()[i].witness, mesh, domain);
    if (place) marks.add(frame(*place), i);
  }
  const Skin skin = drawable(triangles, at);
  Json json = {
      {"mark", "whole"},           {"dimension", mesh.dimension()}, {"core", marks.places.size()},
      {"points", Json::array()},   {"marks", marks.violations},     {"skin", Json::array()},
      {"coarser", skin.is_coarser}};
  for (const Spot& place : marks.places) json["points"].push_back(rounded(place));
  for (const Spot& place : skin.corners) json["points"].push_back(rounded(place));
  for (const auto& triangle : skin.triangles) {
    Json corners = Json::array();
    for (const std::size_t corner : triangle) corners.push_back(marks.places.size() + corner);
    json["skin"].push_back(corners);
  }
  return json;
}

}  // namespace circumspect::picture
