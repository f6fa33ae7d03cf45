// Candidates are the sets of four vertices, in lexicographic order. Clauses about them say what a
// triangulation must do (proved in proofs/existence/Necessary.v); a solver says which are enough.
#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "kernel/complex/improper_intersection.hpp"
#include "kernel/exact/point.hpp"
#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/intersection.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"
#include "oracle/certificate/domain_certificate.hpp"
#include "oracle/certificate/domain_part.hpp"
#include "oracle/certificate/separators.hpp"

namespace circumspect::certificate {
namespace {
struct Plane {
  Point normal;
  Rational offset;
};

// One side of a plane: not negative there.
struct Halfspace {
  const Plane* plane;
  int sign;
  Rational operator()(const Point& p) const {
    return sign * (inner_product(plane->normal, p) - plane->offset);
  }
};

// What of a convex polygon (a segment, a point) is in a half-space.
std::vector<Point> clipped(const std::vector<Point>& corners, const Halfspace& half) {
  std::vector<Point> left;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point& p = corners[i];
    const Point& q = corners[(i + 1) % corners.size()];
    const Rational at_p = half(p), at_q = half(q);
    if (sgn(at_p) >= 0) left.push_back(p);
    if (sgn(at_p) * sgn(at_q) < 0) {
      const Rational t = at_p / (at_p - at_q);
      left.push_back((1 - t) * p + t * q);
    }
  }
  return left;
}

// A vertex, a segment or a piece of a polygon: part of a cell, with the names that the file gives.
struct CellPart {
  std::string name;
  std::vector<Point> corners;
  Simplex simplex;
};

class Search {
 public:
  // Of triangulations, or of those that are CDTs.
  Search(const PiecewiseLinearComplex& complex, const ScaledPoints& points, bool of_cdts)
      : complex_(complex), points_(points), of_cdts_(of_cdts) {
    const auto add = [&](std::string name, const Simplex& simplex) {
      parts_.push_back({std::move(name), coordinates(complex_.points, simplex), simplex});
      whole_parts_.emplace_back();
      for (const Vertex v : simplex) whole_parts_.back().push_back(whole(v));
    };
    for (Vertex v = 0; complex_.points.names(v); ++v) add(fmt::format("vertex {}", v + 1), {v});
    for (std::size_t s = 0; s < complex_.segments.size(); ++s) {
      add(fmt::format("segment {}", s + 1), complex_.segments[s]);
    }
    for (std::size_t f = 0; f < complex_.polygons.size(); ++f) {
      const std::vector<Simplex>& pieces = complex_.polygons[f].triangles;
      for (std::size_t u = 0; u < pieces.size(); ++u) {
        add(fmt::format("piece {} {}", f + 1, u + 1), pieces[u]);
      }
    }
    find_sides();
    for (Vertex a = 0; complex_.points.names(a); ++a) {
      for (Vertex b = a + 1; complex_.points.names(b); ++b) {
        for (Vertex c = b + 1; complex_.points.names(c); ++c) {
          for (Vertex d = c + 1; complex_.points.names(d); ++d) decide_fate({a, b, c, d});
        }
      }
    }
  }

  // Clauses that hold of every triangulation, but for those about two candidates.
  void add_clauses() {
    for (const CellPart& part : parts_) add_cover(part);
    for (const std::size_t k : free_) {
      for (std::size_t place = 0; place < 4; ++place) add_neighbours(k, place);
    }
  }

  // Of the chosen candidates some that overlap, as clauses. False: there are none.
  bool add_overlaps(const std::vector<bool>& chosen) {
    const std::size_t before = reasons.size();
    for (std::size_t i = 0; i < free_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const std::size_t s = free_[i], u = free_[j];
        if (!chosen[s] || !chosen[u]) continue;
        const auto point = improper_intersection(complex_.points, candidates_[s], candidates_[u]);
        if (!point) continue;
        reasons.push_back(fmt::format("not-both {} {} {}", s + 1, u + 1, text(*point)));
        clauses.push_back({-literal(s), -literal(u)});
      }
    }
    return reasons.size() > before;
  }

  int variables() const { return static_cast<int>(candidates_.size()); }

  std::vector<std::string> fates;
  std::vector<std::string> reasons;
  std::vector<Clause> clauses;  // for each reason

 private:
  static int literal(std::size_t candidate) { return static_cast<int>(candidate) + 1; }

  std::string text(const Point& point) const {
    const HomogeneousPoint q = scaled(points_, point);
    return fmt::format("{} {} {} {}", q.numerators[0].get_str(), q.numerators[1].get_str(),
                       q.numerators[2].get_str(), q.denominator.get_str());
  }

  // What is called so, with the point if it is not a vertex.
  std::string named(const CellPart& part, const Point& point) const {
    return part.simplex.size() == 1 ? part.name : part.name + " " + text(point);
  }

  std::array<Halfspace, 4> facets(const Simplex& tetrahedron) const {
    std::array<Halfspace, 4> halves;
    for (std::size_t place = 0; place < 4; ++place) {
      halves[place] = {&planes_[triangle_of(tetrahedron, place)],
                       raw_side(tetrahedron, place, tetrahedron[place])};
    }
    return halves;
  }

  // Is the vertex, which is a corner of a candidate, off the cell that the part is of?
  bool is_off(const CellPart& part, Vertex v) const {
    if (part.simplex.size() == 3) {
      return side_of_triangle(complex_.points.configuration(), part.simplex, v) != 0;
    }
    return std::find(part.simplex.begin(), part.simplex.end(), v) == part.simplex.end();
  }

  // Why a candidate is in no triangulation, or that it may be.
  std::string fate_of(const Simplex& candidate) const {
    if (side(candidate, 3, candidate[3]) == 0) return "flat";
    const std::array<Halfspace, 4> halves = facets(candidate);
    for (const CellPart& part : parts_) {
      if (is_beyond_a_facet(candidate, part)) continue;
      if (std::includes(candidate.begin(), candidate.end(), part.simplex.begin(),
                        part.simplex.end())) {
        continue;  // it is a face
      }
      if (part.simplex.size() == 1) return part.name;
      std::vector<Point> common = part.corners;
      for (const Halfspace& half : halves) {
        if (!common.empty()) common = clipped(common, half);
      }
      if (common.empty()) continue;
      const Point point = circumspect::barycentre(common);
      for (std::size_t place = 0; place < 4; ++place) {
        if (sgn(halves[place](point)) > 0 && is_off(part, candidate[place])) {
          return named(part, point);
        }
      }
    }
    if (of_cdts_) {
      if (const auto encroached = encroachment(candidate)) return *encroached;
    }
    return "free";
  }

  // A vertex in the open ball of the candidate that some point inside can see, with planes that
  // part the way there from all cells. All in integers.
  std::optional<std::string> encroachment(const Simplex& candidate) const {
    constexpr std::array<std::array<int, 4>, 3> kWeights = {
        {{1, 1, 1, 1}, {1, 2, 3, 5}, {5, 3, 2, 1}}};
    for (Vertex v = 0; complex_.points.names(v); ++v) {
      if (contains(candidate, v)) continue;
      if (in_ball(complex_.points.configuration(), kSpace, candidate, v) <= 0) continue;
      for (const auto& weights : kWeights) {
        Point sum = {0, 0, 0};
        int total = 0;
        for (std::size_t i = 0; i < 4; ++i) {
          sum = sum + Rational(weights[i]) * whole(candidate[i]);
          total += weights[i];
        }
        const Point start = Rational(1, total) * sum;
        if (const auto planes = separators(whole_parts_, start, whole(v), false)) {
          return fmt::format("sees {} {} {} {} {}", v + 1, sum[0].get_str(), sum[1].get_str(),
                             sum[2].get_str(), total) +
                 planes->words;
        }
      }
    }
    return std::nullopt;
  }

  Point whole(Vertex v) const {
    return {points_.coordinate(v, 0), points_.coordinate(v, 1), points_.coordinate(v, 2)};
  }

  // The planes of all triangles, and on which sides of them the vertices are.
  void find_sides() {
    const std::size_t n = complex_.points.size();
    planes_.resize(n * n * n);
    sides_.resize(n * n * n * n, 0);
    for (Vertex a = 0; complex_.points.names(a); ++a) {
      for (Vertex b = a + 1; complex_.points.names(b); ++b) {
        for (Vertex c = b + 1; complex_.points.names(c); ++c) find_sides_of({a, b, c});
      }
    }
  }
  void find_sides_of(const std::array<Vertex, 3>& triangle) {
    const Point& p = complex_.points[triangle[0]];
    Plane plane{cross_product(complex_.points[triangle[1]] - p, complex_.points[triangle[2]] - p),
                0};
    plane.offset = inner_product(plane.normal, p);
    const std::size_t number = number_of(triangle);
    for (Vertex v = 0; complex_.points.names(v); ++v) {
      sides_[number * complex_.points.size() + static_cast<std::size_t>(v)] =
          static_cast<signed char>(sgn(Halfspace{&plane, 1}(complex_.points[v])));
    }
    planes_[number] = std::move(plane);
  }
  std::size_t number_of(const std::array<Vertex, 3>& triangle) const {
    const std::size_t n = complex_.points.size();
    return (static_cast<std::size_t>(triangle[0]) * n + static_cast<std::size_t>(triangle[1])) * n +
           static_cast<std::size_t>(triangle[2]);
  }
  // The facet opposite vertex number `place` of a candidate.
  std::size_t triangle_of(const Simplex& candidate, std::size_t place) const {
    std::array<Vertex, 3> facet{};
    std::size_t next = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (i != place) facet[next++] = candidate[i];
    }
    return number_of(facet);
  }
  // On which side of its plane the vertex is.
  int raw_side(const Simplex& candidate, std::size_t place, Vertex v) const {
    return sides_[triangle_of(candidate, place) * complex_.points.size() +
                  static_cast<std::size_t>(v)];
  }
  // Positive on the side of that vertex, 0 in the plane of the facet; 0 if the candidate is flat.
  int side(const Simplex& candidate, std::size_t place, Vertex v) const {
    return raw_side(candidate, place, v) * raw_side(candidate, place, candidate[place]);
  }
  bool is_beyond_a_facet(const Simplex& candidate, const CellPart& part) const {
    for (std::size_t place = 0; place < 4; ++place) {
      if (std::all_of(part.simplex.begin(), part.simplex.end(),
                      [&](Vertex v) { return side(candidate, place, v) < 0; })) {
        return true;
      }
    }
    return false;
  }

  void decide_fate(const Simplex& candidate) {
    number_of_.emplace(candidate, candidates_.size());
    fates.push_back(fate_of(candidate));
    if (fates.back() == "free") {
      free_.push_back(candidates_.size());
      halves_.emplace(candidates_.size(), facets(candidate));
    }
    candidates_.push_back(candidate);
  }

  void add_cover(const CellPart& part) {
    const Point point = circumspect::barycentre(part.corners);
    Clause clause;
    for (const std::size_t k : free_) {
      const auto& halves = halves_.at(k);
      if (std::all_of(halves.begin(), halves.end(),
                      [&](const Halfspace& half) { return sgn(half(point)) >= 0; })) {
        clause.push_back(literal(k));
      }
    }
    reasons.push_back("covers " + named(part, point));
    clauses.push_back(std::move(clause));
  }

  void add_neighbours(std::size_t k, std::size_t place) {
    const Simplex& candidate = candidates_[k];
    Simplex facet = candidate;
    facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(place));
    const Point centre = circumspect::barycentre(complex_.points, facet);
    if (complex_.kind == DomainKind::kEnclosed && is_in_wall(facet, centre)) return;
    Clause clause = {-literal(k)};
    std::vector<std::size_t> numbers;
    for (Vertex v = 0; complex_.points.names(v); ++v) {
      if (side(candidate, place, v) >= 0) continue;
      Simplex other = facet;
      other.insert(std::upper_bound(other.begin(), other.end(), v), v);
      const std::size_t number = number_of_.at(other);
      numbers.push_back(number + 1);
      if (halves_.contains(number)) clause.push_back(literal(number));
    }
    if (complex_.kind == DomainKind::kHull && numbers.empty()) return;
    reasons.push_back(
        fmt::format("beside {} {} {} {}", k + 1, place, text(centre), fmt::join(numbers, " ")));
    clauses.push_back(std::move(clause));
  }

  bool is_in_wall(const Simplex& facet, const Point& centre) const {
    return std::any_of(parts_.begin(), parts_.end(), [&](const CellPart& part) {
      return part.simplex.size() == 3 &&
             std::none_of(facet.begin(), facet.end(), [&](Vertex v) { return is_off(part, v); }) &&
             !intersection(part.corners, {centre}).empty();
    });
  }

  const PiecewiseLinearComplex& complex_;
  const ScaledPoints& points_;
  bool of_cdts_;
  std::vector<CellPart> parts_;
  std::vector<std::vector<Point>> whole_parts_;  // their corners, in integers
  std::vector<Simplex> candidates_;
  std::map<Simplex, std::size_t> number_of_;
  std::vector<std::size_t> free_;   // the candidates that may be chosen
  std::vector<Plane> planes_;       // by triangles
  std::vector<signed char> sides_;  // by triangles and vertices
  std::map<std::size_t, std::array<Halfspace, 4>> halves_;
};

// Leaves out what the proof does not use.
void trim(Impossibility& made, std::vector<ProofStep> proof) {
  const std::size_t given = made.reasons.size();
  std::vector<bool> used(given + proof.size() + 1, false);
  for (std::size_t i = proof.size(); i-- > 0;) {
    if (i + 1 < proof.size() && !used[given + 1 + i]) continue;
    for (const std::size_t hint : proof[i].hints) used[hint] = true;
  }
  used[given + proof.size()] = true;
  std::vector<std::size_t> number(used.size(), 0);
  std::vector<std::string> reasons;
  std::size_t next = 0;
  for (std::size_t i = 1; i <= given; ++i) {
    if (!used[i]) continue;
    number[i] = ++next;
    reasons.push_back(std::move(made.reasons[i - 1]));
  }
  made.reasons = std::move(reasons);
  for (std::size_t i = 0; i < proof.size(); ++i) {
    if (!used[given + 1 + i]) continue;
    number[given + 1 + i] = ++next;
    for (std::size_t& hint : proof[i].hints) hint = number[hint];
    made.steps.push_back(std::move(proof[i]));
  }
}

}  // namespace

tl::expected<Impossibility, std::string> impossibility_of(const Domain& domain, Claim claim,
                                                          const ListedSegments& listed,
                                                          const HullFillers& fillers,
                                                          const Decide& decide) {
  const PiecewiseLinearComplex& complex = domain.complex;
  const auto filled = fillers.mesh(complex);
  if (!filled) return tl::unexpected(std::string("no mesh of the domain was found"));
  auto mesh = domain_certificate_of(*filled, domain, listed, Claim::kSteinerTriangulation, fillers);
  if (!mesh) return tl::unexpected(mesh.error());
  if (mesh->dangles) return tl::unexpected(std::string("something dangles in each of its meshes"));
  Impossibility made{.claim = claim,
                     .kind = complex.kind,
                     .points = in_scale_of(mesh->mesh.points, complex.points),
                     .segments = complex.segments,
                     .mesh = std::move(*mesh)};
  for (const Hole& hole : made.mesh.part.holes) made.holes.push_back(hole.seed);
  auto polygons = polygon_certificates(complex, made.points, listed, fillers);
  if (!polygons) return tl::unexpected(polygons.error());
  made.polygons = std::move(*polygons);
  Search search(complex, made.points, claim == Claim::kCdt);
  search.add_clauses();
  for (;;) {
    auto decision = decide(search.variables(), search.clauses);
    if (!decision) return tl::unexpected(std::string("the solver gave up"));
    if (!decision->model) {
      made.fates = std::move(search.fates);
      made.reasons = std::move(search.reasons);
      trim(made, std::move(decision->proof));
      return made;
    }
    if (!search.add_overlaps(*decision->model)) {
      return tl::unexpected(
          std::string("what is proved of every triangulation does not suffice: "
                      "tetrahedra can be chosen that do not overlap"));
    }
  }
}

}  // namespace circumspect::certificate
