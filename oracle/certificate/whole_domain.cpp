// Evidence that speaks of the whole domain. Points and planes are in the integers of the file; what
// the checker decides is decided here in the same way, so that what is written is accepted.
#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "kernel/exact/point.hpp"
#include "kernel/predicates/intersection.hpp"
#include "oracle/certificate/domain_certificate.hpp"
#include "oracle/certificate/evidence.hpp"
#include "oracle/certificate/points_in_words.hpp"
#include "oracle/certificate/separators.hpp"

namespace circumspect::certificate {
namespace {

class WholeSearch {
 public:
  WholeSearch(const ExactMesh& mesh, const Domain& domain, const ListedSegments& listed,
              const Verdict& verdict, const ScaledPoints& points,
              const std::vector<Vertex>& vertices, const HullFillers& fillers)
      : mesh_(mesh),
        domain_(domain),
        listed_(listed),
        verdict_(verdict),
        points_(points),
        fillers_(fillers),
        sidedness_(points) {
    const PiecewiseLinearComplex& complex = domain.complex;
    const auto add = [&](std::string name, const Simplex& simplex, std::size_t polygon) {
      Part part{std::move(name), {}, polygon};
      for (const Vertex v : simplex)
        part.corners.push_back(at(vertices[static_cast<std::size_t>(v)]));
      corners_.push_back(part.corners);
      parts_.push_back(std::move(part));
    };
    for (Vertex v = 0; complex.points.names(v); ++v) add(fmt::format("vertex {}", v + 1), {v}, 0);
    for (std::size_t s = 0; s < complex.segments.size(); ++s) {
      add(fmt::format("segment {}", s + 1), complex.segments[s], 0);
    }
    for (std::size_t f = 0; f < complex.polygons.size(); ++f) {
      const std::vector<Simplex>& pieces = complex.polygons[f].triangles;
      for (std::size_t u = 0; u < pieces.size(); ++u) {
        add(fmt::format("{} {}", f + 1, u + 1), pieces[u], f);
      }
    }
  }

  // Is each simplex a simplex? Else other evidence says so. What dangles comes last.
  bool is_sound() {
    return std::all_of(mesh_.simplices.begin(), mesh_.simplices.end(), [&](const Simplex& simplex) {
      return simplex.size() <= points_.dimension + 1 &&
             std::all_of(simplex.begin(), simplex.end(),
                         [&](Vertex v) { return mesh_.points.names(v); }) &&
             (!is_full(simplex) || sidedness_.orientation(simplex) != 0);
    });
  }

  std::optional<WholeEvidence> evidence_for(Rule rule) {
    switch (rule) {
      case Rule::kConstrainedFacetNotLocal:
        return facet_not_local();
      case Rule::kVisibleVertexInBall:
        return visible_vertex();
      case Rule::kPolygonNotTiled:
        return polygon_not_tiled();
      case Rule::kUncovered: {
        auto found = uncovered();
        if (!found) found = gap();
        return found ? found : uncovered_inside();
      }
      case Rule::kOutside: {
        auto found = outside();
        return found ? found : gap();
      }
      case Rule::kDanglingNotDelaunay:
        return dangling_not_delaunay();
      case Rule::kHullNotConvex:
      case Rule::kHullNotClosed:
        return of_hull(rule);
      default:
        return std::nullopt;
    }
  }

 private:
  // A vertex, a segment or a piece of a polygon.
  struct Part {
    std::string name;
    std::vector<Point> corners;
    std::size_t polygon;
  };

  bool is_full(const Simplex& simplex) const { return simplex.size() == points_.dimension + 1; }
  bool something_dangles() const {
    return !mesh_.simplices.empty() && !is_full(mesh_.simplices.back());
  }
  Point at(Vertex v) const {
    Point point;
    for (std::size_t axis = 0; axis < points_.dimension; ++axis) {
      point.emplace_back(points_.coordinate(v, axis));
    }
    return point;
  }
  Point middle(const Simplex& simplex) const {
    return circumspect::barycentre(corners_of(simplex));
  }
  std::vector<Point> corners_of(const Simplex& simplex) const {
    std::vector<Point> corners;
    for (const Vertex v : simplex) corners.push_back(at(v));
    return corners;
  }
  bool is_enclosed() const { return domain_.complex.kind == DomainKind::kEnclosed; }

  std::optional<WholeEvidence> facet_not_local() const {
    if (something_dangles()) return std::nullopt;
    for (const Violation& violation : verdict_.violations()) {
      if (violation.rule != Rule::kConstrainedFacetNotLocal || !violation.witness.face) continue;
      const auto found = ball_evidence(mesh_, Rule::kFacetNotLocal, violation.witness);
      if (!found) continue;
      return WholeEvidence{violation.rule, std::string(identifier(violation.rule)),
                           words_of(*found) + text_of(middle(*violation.witness.face))};
    }
    return std::nullopt;
  }
  static std::string words_of(const Evidence& evidence) {
    std::string words;
    for (const Integer& token : evidence.because) words += token.get_str() + " ";
    return words;
  }

  std::optional<WholeEvidence> visible_vertex() const {
    constexpr std::array<std::array<int, 4>, 3> kWeights = {
        {{1, 1, 1, 1}, {1, 2, 3, 5}, {5, 3, 2, 1}}};
    if (something_dangles()) return std::nullopt;
    for (const Violation& violation : verdict_.violations()) {
      if (violation.rule != Rule::kVisibleVertexInBall) continue;
      const Vertex v = violation.witness.vertices.front();
      const auto simplex = number_of(mesh_, violation.witness.simplices.front());
      if (!simplex || !mesh_.points.names(v)) continue;
      for (const auto& weights : kWeights) {
        const Point inside = weighted(mesh_.simplices[*simplex - 1], weights);
        if (const auto planes = separators(inside, at(v), false)) {
          return WholeEvidence{
              violation.rule, std::string(identifier(violation.rule)),
              fmt::format("{} {} {}{}", *simplex, v + 1, text_of(inside), planes->words)};
        }
      }
    }
    return std::nullopt;
  }

  Point weighted(const Simplex& simplex, const auto& weights) const {
    Point sum(points_.dimension, 0);
    Rational total = 0;
    for (std::size_t i = 0; i < simplex.size(); ++i) {
      sum = sum + Rational(weights[i]) * at(simplex[i]);
      total += weights[i];
    }
    return 1 / total * sum;
  }

  // From inside a triangle that dangles a vertex in its circumdisk is seen, through pieces of their
  // polygon.
  std::optional<WholeEvidence> dangling_not_delaunay() const {
    constexpr std::array<std::array<int, 3>, 7> kWeights = {
        {{1, 1, 1}, {8, 8, 1}, {8, 1, 8}, {1, 8, 8}, {8, 4, 1}, {1, 8, 4}, {4, 1, 8}}};
    for (const Violation& violation : verdict_.violations()) {
      if (violation.rule != Rule::kDanglingNotDelaunay || !is_enclosed()) continue;
      const Vertex v = violation.witness.vertices.front();
      const auto number = number_of(mesh_, violation.witness.simplices.front());
      if (!number) continue;
      const Simplex& triangle = mesh_.simplices[*number - 1];
      for (std::size_t k = 0; k < domain_.complex.polygons.size(); ++k) {
        if (is_off(middle(triangle), k)) continue;
        std::vector<std::vector<Point>> pieces;
        std::vector<std::vector<Point>> others;
        for (const Part& part : parts_) {
          const bool is_piece = part.corners.size() == 3 && part.polygon == k;
          (is_piece ? pieces : others).push_back(part.corners);
        }
        for (const auto& weights : kWeights) {
          const Point inside = weighted(triangle, weights);
          const auto way = way_through(pieces, inside, at(v));
          if (!way) continue;
          const auto planes = certificate::separators(others, inside, at(v), false);
          if (!planes) continue;
          return WholeEvidence{violation.rule, std::string(identifier(violation.rule)),
                               fmt::format("{} {} {} {} {} {}{}", *number, v + 1,
                                           balance(corners_of(triangle), at(v)), k + 1,
                                           text_of(inside), *way, planes->words)};
        }
      }
    }
    return std::nullopt;
  }

  // What is wrong with the boundary of a mesh that is to fill a hull, as of points.
  std::optional<WholeEvidence> of_hull(Rule rule) const {
    if (is_enclosed() || something_dangles()) return std::nullopt;
    const auto found = certificate::evidence_for(mesh_, verdict_, points_, rule);
    if (!found) return std::nullopt;
    return WholeEvidence{rule, std::string(identifier(rule)), words_of(*found)};
  }

  std::optional<Separators> separators(const Point& a, const Point& b, bool with_end) const {
    return certificate::separators(corners_, a, b, with_end);
  }
  static std::string leg(const Point& end, const Separators& planes) {
    return fmt::format("{} {}{}", text_of(end), planes.count, planes.words);
  }

  std::string named(const Part& part, const Point& point) const {
    const std::string kind = part.corners.size() == 3 ? "piece " : "";
    return kind + part.name + " " + text_of(point);
  }

  bool is_in(const Simplex& face, const Point& point) const {
    return !intersection(corners_of(face), {point}).empty();
  }
  bool is_in_none(const Point& point) {
    const HomogeneousPoint q = homogeneous(point);
    return std::all_of(mesh_.simplices.begin(), mesh_.simplices.end(), [&](const Simplex& simplex) {
      if (!is_full(simplex)) return !is_in(simplex, point);
      return sidedness_.separating_place(simplex, sidedness_.orientation(simplex), q).has_value();
    });
  }

  std::optional<WholeEvidence> uncovered() {
    for (const Part& part : parts_) {
      for (const Point& point : samples(part.corners)) {
        if (!is_in_none(point)) continue;
        return WholeEvidence{Rule::kUncovered, std::string(identifier(Rule::kUncovered)),
                             named(part, point), homogeneous(point)};
      }
    }
    return std::nullopt;
  }

  // What walls hide is in a simplex of another mesh of the domain.
  std::optional<WholeEvidence> uncovered_inside() {
    const auto other = fillers_.mesh(domain_.complex);
    if (!other) return std::nullopt;
    auto certificate =
        domain_certificate_of(*other, domain_, listed_, Claim::kSteinerTriangulation, fillers_);
    if (!certificate || certificate->dangles) return std::nullopt;
    const ExactMesh& mesh = other->mesh;
    for (std::size_t s = 0; s < mesh.simplices.size(); ++s) {
      for (const Point& point : samples(coordinates(mesh.points, mesh.simplices[s]))) {
        const HomogeneousPoint here = scaled(points_, point);
        if (!is_in_none(ordinary(here))) continue;
        const Point there = ordinary(scaled(certificate->mesh.points, point));
        return WholeEvidence{Rule::kUncovered, "domain.uncovered-inside",
                             fmt::format("{} {}", s + 1, text_of(there)), here,
                             std::move(*certificate)};
      }
    }
    return std::nullopt;
  }

  std::optional<WholeEvidence> polygon_not_tiled() {
    std::set<std::size_t> named;
    for (const Violation& violation : verdict_.violations()) {
      if (violation.witness.polygon) named.insert(*violation.witness.polygon);
    }
    for (const Part& part : parts_) {
      if (part.corners.size() != 3 || !(named.empty() || named.contains(part.polygon))) continue;
      for (const Point& point : samples(part.corners)) {
        const HomogeneousPoint q = homogeneous(point);
        const bool all_leave =
            std::all_of(mesh_.simplices.begin(), mesh_.simplices.end(),
                        [&](const Simplex& simplex) { return leaves(simplex, q, part.polygon); });
        if (!all_leave) continue;
        return WholeEvidence{Rule::kPolygonNotTiled,
                             std::string(identifier(Rule::kPolygonNotTiled)),
                             part.name + " " + text_of(point), q};
      }
    }
    return std::nullopt;
  }
  // The simplex misses the point, or of the least face around it a vertex is off the polygon.
  bool leaves(const Simplex& simplex, const HomogeneousPoint& q, std::size_t polygon) {
    if (!is_full(simplex)) {
      // Its least face with the point: what is left when the others are taken away that are not
      // needed.
      Simplex face = simplex;
      const Point point = ordinary(q);
      if (!is_in(face, point)) return true;
      for (std::size_t i = 0; i < face.size() && face.size() > 1;) {
        Simplex fewer = face;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
        if (is_in(fewer, point)) {
          face = std::move(fewer);
        } else {
          ++i;
        }
      }
      return std::any_of(face.begin(), face.end(),
                         [&](Vertex v) { return is_off(at(v), polygon); });
    }
    const int own = sidedness_.orientation(simplex);
    bool leaves = false;
    for (std::size_t place = 0; place < simplex.size(); ++place) {
      const int sign = own * sidedness_.orientation_with(simplex, place, q);
      if (sign < 0) return true;
      if (sign > 0 && is_off(at(simplex[place]), polygon)) leaves = true;
    }
    return leaves;
  }
  bool is_off(const Point& point, std::size_t polygon) const {
    return std::none_of(parts_.begin(), parts_.end(), [&](const Part& part) {
      return part.corners.size() == 3 && part.polygon == polygon &&
             !intersection(part.corners, {point}).empty();
    });
  }

  // Those of the witnesses, and the first of all.
  std::vector<std::size_t> suspects(Rule rule) const {
    constexpr std::size_t kMost = 64;
    std::vector<std::size_t> found;
    for (const Violation& violation : verdict_.violations()) {
      if (violation.rule != rule) continue;
      for (const Simplex& simplex : violation.witness.simplices) {
        if (const auto number = number_of(mesh_, simplex)) found.push_back(*number - 1);
      }
    }
    for (std::size_t s = 0; s < std::min(kMost, mesh_.simplices.size()); ++s) found.push_back(s);
    return found;
  }

  std::optional<WholeEvidence> outside() const {
    for (const std::size_t s : suspects(Rule::kOutside)) {
      const Point start = middle(mesh_.simplices[s]);
      if (const auto words = way_out(mesh_.simplices[s], start)) {
        return WholeEvidence{Rule::kOutside, std::string(identifier(Rule::kOutside)),
                             fmt::format("{} {} {}", s + 1, text_of(start), *words)};
      }
    }
    return std::nullopt;
  }

  // To a hole point, or beyond all vertices, in one leg at most.
  std::optional<std::string> way_out(const Simplex& simplex, const Point& start) const {
    const std::vector<Point>& seeds = domain_.complex.hole_seeds;
    for (std::size_t h = 0; is_enclosed() && h < seeds.size(); ++h) {
      const Point end = ordinary(scaled(points_, seeds[h]));
      if (const auto planes = separators(start, end, true)) {
        return fmt::format("1 {} hole {}", leg(end, *planes), h + 1);
      }
    }
    for (const Point& direction : directions_from(corners_of(simplex), start)) {
      for (const int sign : {1, -1}) {
        const Point normal = Rational(sign) * direction;
        Rational offset = inner_product(normal, parts_.front().corners.front());
        for (const Part& part : parts_) {
          for (const Point& corner : part.corners) {
            offset = std::max(offset, inner_product(normal, corner));
          }
        }
        std::string plane;
        for (const Rational& x : normal) plane += " " + x.get_str();
        plane += " " + offset.get_str();
        const Rational lacks = offset - inner_product(normal, start);
        if (sgn(lacks) < 0) return "0 beyond" + plane;
        if (!is_enclosed()) continue;
        const Integer steps =
            Integer(lacks.get_num() / (lacks.get_den() * squared_length(normal).get_num())) + 1;
        const Point end = start + Rational(steps) * normal;
        if (const auto planes = separators(start, end, true)) {
          return fmt::format("1 {} beyond{}", leg(end, *planes), plane);
        }
      }
    }
    return std::nullopt;
  }
  // From inside a simplex through a facet that is no other's to a point in none.
  std::optional<WholeEvidence> gap() {
    constexpr std::size_t kMost = 500;
    std::size_t looked_at = 0;
    if (!is_enclosed()) return std::nullopt;
    std::map<Simplex, std::size_t> uses;
    const auto without = [](const Simplex& simplex, std::size_t place) {
      Simplex facet = simplex;
      facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(place));
      return sorted(facet);
    };
    for (const Simplex& simplex : mesh_.simplices) {
      for (std::size_t place = 0; place < simplex.size(); ++place) ++uses[without(simplex, place)];
    }
    for (std::size_t s = 0; s < mesh_.simplices.size() && is_full(mesh_.simplices[s]); ++s) {
      const Point start = middle(mesh_.simplices[s]);
      for (std::size_t place = 0; place < mesh_.simplices[s].size(); ++place) {
        const Simplex facet = without(mesh_.simplices[s], place);
        if (uses.at(facet) != 1) continue;
        if (++looked_at > kMost) return std::nullopt;
        const Point centre = middle(facet);
        if (!separators(start, centre, true)) continue;  // a wall
        Rational far = 1;
        for (int tries = 0; tries < 8; ++tries, far /= 4) {
          const Point end = centre + far * (centre - start);
          if (!is_in_none(end)) continue;
          if (const auto planes = separators(start, end, true)) {
            return WholeEvidence{Rule::kUncovered, "domain.uncovered-or-outside",
                                 fmt::format("{} {} {}", s + 1, text_of(start), leg(end, *planes)),
                                 homogeneous(end)};
          }
        }
      }
    }
    return std::nullopt;
  }

  const ExactMesh& mesh_;
  const Domain& domain_;
  const ListedSegments& listed_;
  const Verdict& verdict_;
  const ScaledPoints& points_;
  const HullFillers& fillers_;
  Sidedness sidedness_;
  std::vector<Part> parts_;
  std::vector<std::vector<Point>> corners_;  // theirs
};

}  // namespace

std::optional<WholeEvidence> whole_evidence(const ExactMesh& mesh, const Domain& domain,
                                            const ListedSegments& listed, const Verdict& verdict,
                                            const ScaledPoints& points,
                                            const std::vector<Vertex>& vertices,
                                            const HullFillers& fillers) {
  WholeSearch search(mesh, domain, listed, verdict, points, vertices, fillers);
  if (!search.is_sound()) return std::nullopt;
  for (const auto& [rule, tally] : verdict.tallies()) {
    if (auto found = search.evidence_for(rule)) return found;
  }
  return std::nullopt;
}

}  // namespace circumspect::certificate
