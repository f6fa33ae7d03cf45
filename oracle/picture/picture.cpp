#include "oracle/picture/picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "kernel/exact/point.hpp"
#include "oracle/picture/caption.hpp"
#include "oracle/picture/gap.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::picture {
namespace {

using report::Json;

constexpr std::size_t kMostNear = 60;
constexpr std::size_t kSmallMesh = 500;  // the largest whose whole boundary is drawn
constexpr std::size_t kMostWalls = 400;
constexpr double kFar = 50;  // what lies further from the middle is not drawn

// Seven digits are more than a screen has, and keep pages small.
double shortened(double x) { return std::round(x * 1e7) / 1e7; }

// One picture as it grows.
class Composer {
 public:
  Composer(const Witness& witness, const Mesh& mesh, const Domain* domain)
      : witness_(witness), mesh_(mesh), domain_(domain) {}

  Json compose(const Surroundings& around, const std::vector<Simplex>& boundary,
               const Simplex& gap);

 private:
  using Place = std::size_t;  // among the points

  Place vertex(Vertex v);
  Json places(const Simplex& simplex);  // null for what names no point
  Place extra(const Point& point, std::string name);
  Place corner(Vertex of_domain, bool named);

  void add_witness();
  void add_cell();
  void add_around(const Surroundings& around, const std::vector<Simplex>& boundary);
  Json walls();
  void choose_frame();
  bool is_near(const Simplex& simplex);
  double in_frame(const Rational& x, std::size_t axis) const;
  std::array<double, 3> position(const Point& point) const;
  void add_ball();
  void add_thin();

  const Witness& witness_;
  const Mesh& mesh_;
  const Domain* domain_;
  std::map<Vertex, Place> place_of_;
  std::map<Vertex, Place> place_in_domain_;
  std::vector<Point> points_;
  std::vector<std::string> names_;
  std::size_t core_ = 0;
  Point centre_;
  Rational scale_;
  Json json_;
};

Composer::Place Composer::extra(const Point& point, std::string name) {
  points_.push_back(point);
  names_.push_back(std::move(name));
  return points_.size() - 1;
}

Composer::Place Composer::vertex(Vertex v) {
  const auto found = place_of_.find(v);
  if (found != place_of_.end()) return found->second;
  const Place place = extra(mesh_.point(v), "");
  place_of_.emplace(v, place);
  return place;
}

Json Composer::places(const Simplex& simplex) {
  Json array = Json::array();
  for (const Vertex v : simplex) array.push_back(mesh_.names(v) ? Json(vertex(v)) : Json(nullptr));
  return array;
}

Composer::Place Composer::corner(Vertex of_domain, bool named) {
  const auto found = place_in_domain_.find(of_domain);
  if (found != place_in_domain_.end()) return found->second;
  const std::string name =
      named ? fmt::format("domain {}", domain_->label(of_domain)) : std::string();
  const Place place = extra(domain_->complex.points[of_domain], name);
  place_in_domain_.emplace(of_domain, place);
  return place;
}

// What the witness names comes first, and has names: those that the report gives it.
void Composer::add_witness() {
  const report::NamedCells named = report::named_cells(witness_, mesh_);
  json_["simplices"] = Json::array();
  const auto name_all = [this](const Json& at, const Simplex& own) {
    for (std::size_t i = 0; i < own.size(); ++i) {
      if (at[i].is_null()) continue;
      std::string& name = names_[at[i].get<Place>()];
      if (name.empty()) name = std::to_string(own[i]);
    }
  };
  for (std::size_t i = 0; i < witness_.simplices.size(); ++i) {
    json_["simplices"].push_back(places(witness_.simplices[i]));
    name_all(json_["simplices"].back(), named.simplices[i]);
  }
  if (witness_.face) {
    json_["face"] = places(*witness_.face);
    name_all(json_["face"], *named.face);
  }
  const auto labelled = [this](Vertex v) { return Simplex{mesh_.label(v)}; };
  // A face that is one vertex is marked as a vertex is, or it would be lost among its simplices.
  const bool is_vertex = witness_.face && witness_.face->size() == 1 && witness_.vertices.empty();
  json_["vertices"] = places(is_vertex ? *witness_.face : witness_.vertices);
  for (std::size_t i = 0; i < witness_.vertices.size(); ++i) {
    name_all(Json::array({json_["vertices"][i]}), labelled(witness_.vertices[i]));
  }
  if (witness_.nearest) {
    json_["nearest"] = vertex(witness_.nearest->vertex);
    name_all(Json::array({json_["nearest"]}), labelled(witness_.nearest->vertex));
  }
  if (witness_.point) json_["point"] = extra(*witness_.point, "");
}

void Composer::add_cell() {
  if (domain_ == nullptr) return;
  const auto at = [this](const Simplex& corners) {
    Json array = Json::array();
    for (const Vertex v : corners) array.push_back(corner(v, false));
    return array;
  };
  if (witness_.domain_cell) {
    Json ends = Json::array();
    for (const Vertex v : *witness_.domain_cell) ends.push_back(corner(v, true));
    if (ends.size() == 1) {
      json_["cell"]["vertex"] = ends.front();
    } else if (ends.size() == 3) {
      json_["cell"]["polygon"] = {{"segments", Json::array()},
                                  {"triangles", Json::array({at(*witness_.domain_cell)})}};
    } else {
      json_["cell"]["segment"] = ends;
    }
  }
  if (!witness_.polygon) return;
  const Polygon& polygon = domain_->complex.polygons[*witness_.polygon];
  Json& cell = json_["cell"]["polygon"];
  cell = {{"segments", Json::array()}, {"triangles", Json::array()}};
  for (const Simplex& segment : polygon.segments) cell["segments"].push_back(at(segment));
  if (polygon.triangles.size() > kMostWalls) return;  // of larger ones the outline will do
  for (const Simplex& triangle : polygon.triangles) cell["triangles"].push_back(at(triangle));
}

// The middle of what the witness names, and half its size; of a single point, of what is around it.
void Composer::choose_frame() {
  const std::size_t dimension = mesh_.dimension();
  scale_ = 0;
  for (const std::size_t count : {core_, points_.size()}) {
    centre_.assign(dimension, Rational(0));
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      Rational low = points_.front()[axis];
      Rational high = low;
      for (std::size_t i = 1; i < count; ++i) {
        low = std::min(low, points_[i][axis]);
        high = std::max(high, points_[i][axis]);
      }
      centre_[axis] = (low + high) / 2;
      scale_ = std::max<Rational>(scale_, (high - low) / 2);
    }
    if (sign(scale_) > 0) return;
  }
  scale_ = 1;
}

double Composer::in_frame(const Rational& x, std::size_t axis) const {
  const Rational scaled = (x - centre_[axis]) / scale_;
  if (abs(scaled) > Rational(1000000)) return sign(scaled) * 1e6;
  return scaled.get_d();
}

std::array<double, 3> Composer::position(const Point& point) const {
  std::array<double, 3> at = {0, 0, 0};
  for (std::size_t axis = 0; axis < point.size(); ++axis) at[axis] = in_frame(point[axis], axis);
  return at;
}

// In doubles: whether something is drawn decides nothing.
bool Composer::is_near(const Simplex& simplex) {
  return std::all_of(simplex.begin(), simplex.end(), [this](Vertex v) {
    const auto at = position(points_[vertex(v)]);
    return std::all_of(at.begin(), at.end(), [](double x) { return std::abs(x) < kFar; });
  });
}

void Composer::add_around(const Surroundings& around, const std::vector<Simplex>& boundary) {
  json_["near"] = Json::array();
  std::size_t far = 0;
  for (const Simplex& simplex : around.near) {
    if (is_near(simplex)) {
      json_["near"].push_back(places(simplex));
    } else {
      ++far;
    }
  }
  json_["boundary"] = Json::array();
  for (const Simplex& facet : boundary) {
    if (is_near(facet)) json_["boundary"].push_back(places(facet));
  }
  json_["walls"] = walls();
  std::string left_out;
  if (around.left_out > 0) {
    left_out = fmt::format("{} more around it {} not drawn. ",
                           report::counted(around.left_out, "simplex", "simplices"),
                           around.left_out == 1 ? "is" : "are");
  }
  if (far > 0) {
    left_out +=
        fmt::format("{} {} too far to be drawn. ", report::counted(far, "simplex", "simplices"),
                    far == 1 ? "reaches" : "reach");
  }
  if (left_out.empty()) return;
  left_out.pop_back();
  json_["left_out"] = left_out;
}

Json Composer::walls() {
  Json found = {{"segments", Json::array()}, {"triangles", Json::array()}};
  if (domain_ == nullptr) return found;
  const PiecewiseLinearComplex& complex = domain_->complex;
  std::size_t count = 0;
  // One vertex within three times the size of the witness, and none too far.
  const auto is_beside = [&](const Simplex& wall) {
    bool near = false;
    for (const Vertex v : wall) {
      double furthest = 0;
      for (std::size_t axis = 0; axis < centre_.size(); ++axis) {
        furthest = std::max(furthest, std::abs(in_frame(complex.points[v][axis], axis)));
      }
      if (furthest > kFar) return false;
      near = near || furthest < 3;
    }
    return near;
  };
  const auto add = [&](Json& list, const Simplex& wall) {
    if (count >= kMostWalls || !is_beside(wall)) return;
    ++count;
    Json corners = Json::array();
    for (const Vertex v : wall) corners.push_back(corner(v, false));
    list.push_back(corners);
  };
  const std::size_t most_looked_at = 20000;
  for (std::size_t i = 0; i < std::min(complex.segments.size(), most_looked_at); ++i) {
    add(found["segments"], complex.segments[i]);
  }
  for (std::size_t p = 0; p < complex.polygons.size() && count < kMostWalls; ++p) {
    if (witness_.polygon == p || p > most_looked_at) continue;
    for (const Simplex& triangle : complex.polygons[p].triangles) add(found["triangles"], triangle);
  }
  return found;
}

// A vector as its direction, whatever its length, and its length in units of its largest
// coordinate.
struct Direction {
  std::array<double, 3> unit = {0, 0, 1};
  Rational largest = 0;
  double length = 0;
};

Direction direction(const Point& vector) {
  Direction found;
  for (const Rational& x : vector) found.largest = std::max<Rational>(found.largest, abs(x));
  if (sign(found.largest) == 0) return found;
  found.unit.fill(0);
  for (std::size_t i = 0; i < vector.size(); ++i) {
    found.unit[i] = Rational(vector[i] / found.largest).get_d();
    found.length += found.unit[i] * found.unit[i];
  }
  found.length = std::sqrt(found.length);
  for (double& x : found.unit) x /= found.length;
  return found;
}

void Composer::add_ball() {
  if (!witness_.ball || sign(witness_.ball->squared_radius) <= 0) return;
  const Point& centre = witness_.ball->centre;
  const Rational largest = Rational(to_integer(1'000'000'000'000)) * to_integer(1'000'000'000'000);
  const Rational squared =
      std::min<Rational>(witness_.ball->squared_radius / (scale_ * scale_), largest);
  const double radius = std::sqrt(squared.get_d());
  const Point from_centre = points_.front() - centre;
  const std::array<double, 3> normal = direction(from_centre).unit;
  // The distance from the first point to the sphere, without taking the difference of large
  // numbers.
  const Rational distance = squared_length(from_centre) / (scale_ * scale_);
  const double beyond = distance > largest ? 0
                                           : Rational(squared - distance).get_d() /
                                                 (radius + std::sqrt(distance.get_d()));
  const std::array<double, 3> first = position(points_.front());
  std::array<double, 3> surface = first;
  for (std::size_t axis = 0; axis < 3; ++axis) surface[axis] += beyond * normal[axis];
  json_["ball"] = {{"radius", radius}, {"normal", normal}, {"surface", surface}};
  if (radius > 1e5) return;
  json_["ball"]["centre"] = position(centre);
}

// Across the largest triangle (in the plane: the longest edge) of the witness's points.
void Composer::add_thin() {
  const std::size_t dimension = mesh_.dimension();
  const std::size_t candidates = std::min<std::size_t>(core_, 12);
  if (dimension < 2 || candidates <= dimension) return;
  Point normal;
  Rational most = 0;
  Simplex chosen = first_subset(dimension);
  do {
    const auto at = [&](std::size_t i) -> const Point& {
      return points_[static_cast<std::size_t>(chosen[i])];
    };
    const Point along = at(1) - at(0);
    const Point n =
        dimension == 2 ? Point{-along[1], along[0]} : cross_product(along, at(2) - at(0));
    const Rational size = squared_length(n);
    if (size > most) {
      most = size;
      normal = n;
    }
  } while (next_subset(chosen, candidates));
  if (sign(most) == 0) return;
  const auto [unit, largest, length] = direction(normal);
  Json heights = Json::array();
  for (const Point& point : points_) {
    const Rational height = inner_product(normal, point - centre_) / (largest * scale_);
    heights.push_back(abs(height) > 1000000 ? 0.0 : height.get_d() / length);
  }
  json_["thin"] = {{"normal", unit}, {"heights", heights}};
}

Json Composer::compose(const Surroundings& around, const std::vector<Simplex>& boundary,
                       const Simplex& gap) {
  const std::size_t dimension = mesh_.dimension();
  if (dimension > 3) {
    return {
        {"why_none", fmt::format("The points have {} coordinates, and a picture shows three. The "
                                 "table has all that the witness consists of.",
                                 dimension)}};
  }
  json_ = {{"dimension", dimension}};
  add_witness();
  if (!gap.empty()) json_["gap"] = places(gap);
  for (const Vertex v : gap) names_[vertex(v)] = std::to_string(mesh_.label(v));
  add_cell();
  core_ = points_.size();
  if (core_ == 0 || dimension == 0) {
    return {{"why_none", "The witness names no point that could be drawn."}};
  }
  for (const Simplex& simplex : around.near) {
    for (const Vertex v : simplex) vertex(v);
  }
  choose_frame();
  add_around(around, boundary);
  json_["points"] = Json::array();
  for (Place place = 0; place < points_.size(); ++place) {
    Json at = Json::array();
    for (const double x : position(points_[place])) at.push_back(shortened(x));
    json_["points"].push_back(at);
  }
  json_["names"] = names_;
  json_["core"] = core_;
  add_ball();
  add_thin();
  return std::move(json_);
}

// Of each witness the corners of the gap, if it is where a hull ends.
std::vector<Simplex> gaps_of(std::span<const Violation> violations, const Mesh& mesh) {
  std::vector<Simplex> gaps(violations.size());
  std::vector<Simplex> bare;
  for (std::size_t i = 0; i < violations.size(); ++i) {
    const Witness& witness = violations[i].witness;
    const bool has_gap = violations[i].rule == Rule::kHullUncovered && witness.face;
    if (!has_gap || mesh.dimension() < 2 || mesh.dimension() > 3) continue;
    if (bare.empty()) bare = boundary(mesh);
    gaps[i] = gap_at(mesh, witness.simplices.front(), *witness.face, bare);
    if (gaps[i].size() > kMostWalls) gaps[i].clear();
  }
  return gaps;
}

std::vector<Json> composed(std::span<const Witness> witnesses, std::span<const Simplex> gaps,
                           const Mesh& mesh, const Domain* domain) {
  std::vector<Json> found;
  if (witnesses.empty()) return found;
  const bool has_pictures = mesh.dimension() >= 1 && mesh.dimension() <= 3;
  const std::vector<Surroundings> around = has_pictures
                                               ? surroundings(witnesses, mesh, domain, kMostNear)
                                               : std::vector<Surroundings>(witnesses.size());
  const std::vector<Simplex> outer =
      has_pictures && mesh.simplices.size() <= kSmallMesh ? boundary(mesh) : std::vector<Simplex>();
  for (std::size_t i = 0; i < witnesses.size(); ++i) {
    found.push_back(Composer(witnesses[i], mesh, domain).compose(around[i], outer, gaps[i]));
  }
  return found;
}

}  // namespace

std::vector<Json> pictures(const Verdict& verdict, const Mesh& mesh, const Domain* domain,
                           std::size_t most) {
  const std::vector<Violation>& kept = verdict.violations();
  const std::span<const Violation> all(kept.data(), std::min(kept.size(), most));
  std::vector<Witness> witnesses;
  for (const Violation& violation : all) witnesses.push_back(violation.witness);
  std::vector<Json> found = composed(witnesses, gaps_of(all, mesh), mesh, domain);
  for (std::size_t i = 0; i < found.size(); ++i) {
    found[i]["caption"] = caption(all[i], mesh);
    found[i]["mark"] = name(entry(all[i].rule).mark);
  }
  return found;
}

std::vector<Json> pictures(std::span<const Witness> witnesses, const Mesh& mesh,
                           const Domain* domain) {
  return composed(witnesses, std::vector<Simplex>(witnesses.size()), mesh, domain);
}

}  // namespace circumspect::picture
